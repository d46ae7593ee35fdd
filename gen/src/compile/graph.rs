//! Values as a graph: every distinct computation is one node, whoever in the hierarchy asks for it.
//!
//! Signs and names are gone: an operator says whether it is signed, a port is the value that drives it. Nodes are
//! numbered behind their operands. Equal nodes are one node, constants are folded when a node is made ([`super::fold`]).

use super::fold;
use crate::netlist::{MemoryId, Operator, Reduction, SignalId};
use std::collections::HashMap;

/// A node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct ValueId(pub(super) u32);

impl ValueId {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

/// How a value is computed. Widths are those of the nodes; codes are zero-extended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Op {
    Constant(u128),
    /// An input, a register or clocked read data: what the state holds.
    Load(SignalId),
    /// A word of a memory; zero beyond its last.
    Word(MemoryId, ValueId),
    Not(ValueId),
    Negate(ValueId),
    Binary(Operator, ValueId, ValueId),
    /// Both operands extended to the node's width, by their sign if `true`.
    Product(bool, ValueId, ValueId),
    Equal(ValueId, ValueId),
    /// Less, as signed numbers if `true`.
    Less(bool, ValueId, ValueId),
    Reduce(Reduction, ValueId),
    /// Zero for amounts of the width or more.
    ShiftLeft(ValueId, ValueId),
    ShiftRight(ValueId, ValueId),
    /// The node's width of bits from a constant position.
    Slice(ValueId, u32),
    ZeroExtend(ValueId),
    SignExtend(ValueId),
    /// Word, position, bit; unchanged when the position is beyond the top.
    ReplaceBit(ValueId, ValueId, ValueId),
    /// Word, constant position, the bits that replace its own there.
    Insert(ValueId, u32, ValueId),
    /// The second where the first is set, otherwise the third.
    Choose(ValueId, ValueId, ValueId),
}

/// What a value reads of the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Cell {
    Signal(SignalId),
    Memory(MemoryId),
}

impl Op {
    /// Operands in order.
    pub(super) fn operands(&self) -> impl Iterator<Item = ValueId> {
        let (a, b, c) = match *self {
            Self::Constant(_) | Self::Load(_) => (None, None, None),
            Self::Word(_, a)
            | Self::Not(a)
            | Self::Negate(a)
            | Self::Reduce(_, a)
            | Self::Slice(a, _)
            | Self::ZeroExtend(a)
            | Self::SignExtend(a) => (Some(a), None, None),
            Self::Binary(_, a, b)
            | Self::Product(_, a, b)
            | Self::Equal(a, b)
            | Self::Less(_, a, b)
            | Self::ShiftLeft(a, b)
            | Self::ShiftRight(a, b)
            | Self::Insert(a, _, b) => (Some(a), Some(b), None),
            Self::ReplaceBit(a, b, c) | Self::Choose(a, b, c) => (Some(a), Some(b), Some(c)),
        };
        [a, b, c].into_iter().flatten()
    }

    /// The part of the state that the node itself reads.
    pub(super) fn cell(&self) -> Option<Cell> {
        match *self {
            Self::Load(s) => Some(Cell::Signal(s)),
            Self::Word(m, _) => Some(Cell::Memory(m)),
            _ => None,
        }
    }
}

/// The nodes.
#[derive(Debug, Default)]
pub(super) struct Graph {
    nodes: Vec<(Op, u32)>,
    known: HashMap<(Op, u32), ValueId>,
}

impl Graph {
    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    pub(super) fn op(&self, v: ValueId) -> Op {
        self.nodes[v.index()].0
    }

    /// Bits of a value.
    pub(super) fn width(&self, v: ValueId) -> u32 {
        self.nodes[v.index()].1
    }

    /// The code of a constant.
    pub(super) fn code(&self, v: ValueId) -> Option<u128> {
        match self.op(v) {
            Op::Constant(code) => Some(code),
            _ => None,
        }
    }

    pub(super) fn constant(&mut self, code: u128, width: u32) -> ValueId {
        self.node(Op::Constant(code), width)
    }

    /// The simplest node with the value of this operation.
    pub(super) fn add(&mut self, op: Op, width: u32) -> ValueId {
        fold::simplest(self, op, width)
    }

    /// This node itself, made if it is new.
    pub(super) fn node(&mut self, op: Op, width: u32) -> ValueId {
        let next = ValueId(self.nodes.len() as u32);
        let nodes = &mut self.nodes;
        *self.known.entry((op, width)).or_insert_with(|| {
            nodes.push((op, width));
            next
        })
    }

    pub(super) fn not(&mut self, a: ValueId) -> ValueId {
        let width = self.width(a);
        self.add(Op::Not(a), width)
    }

    /// The low bits, or the code with zeros above it.
    pub(super) fn resize(&mut self, a: ValueId, signed: bool, width: u32) -> ValueId {
        match self.width(a).cmp(&width) {
            std::cmp::Ordering::Equal => a,
            std::cmp::Ordering::Greater => self.add(Op::Slice(a, 0), width),
            std::cmp::Ordering::Less if signed => self.add(Op::SignExtend(a), width),
            std::cmp::Ordering::Less => self.add(Op::ZeroExtend(a), width),
        }
    }
}
