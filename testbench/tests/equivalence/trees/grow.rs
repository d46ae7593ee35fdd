//! Trees grown from a list of random choices, so that proptest's strategy for lists is the strategy for trees.

use super::tree::{inputs, Node, Tree};
use super::value::{Comparison, Format, Operator, Reduction, WIDTHS};
use proptest::prelude::*;

/// Deepest tree.
const DEPTH: usize = 4;

/// Widths of words that count bits: rust-hdl's shifts grow as large as their count.
const COUNTS: &[usize] = &[1, 2, 3, 7, 8, 9];

struct Choices<'a> {
    list: &'a [u32],
    at: usize,
    inputs: &'a [(String, Format)],
}

impl Choices<'_> {
    /// A number below `n`; zero when the choices are used up, which ends the tree.
    fn below(&mut self, n: usize) -> usize {
        let choice = self.list.get(self.at).copied().unwrap_or(0);
        self.at += 1;
        choice as usize % n
    }

    fn of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    /// A width; long words are rarer, since every simulator spends most of its time on them.
    fn width(&mut self) -> usize {
        let short = WIDTHS.iter().filter(|w| **w <= 33).count();
        let long = WIDTHS.iter().filter(|w| **w > 64).count();
        match self.below(10) {
            0 => WIDTHS[WIDTHS.len() - 1 - self.below(long)],
            1 | 2 => WIDTHS[short + self.below(WIDTHS.len() - short - long)],
            _ => WIDTHS[self.below(short)],
        }
    }

    fn input(&mut self, format: Format) -> Tree {
        let fitting: Vec<usize> = (0..self.inputs.len())
            .filter(|i| self.inputs[*i].1 == format)
            .collect();
        let i = self.of(&fitting);
        Tree::new(format, Node::Input(i), vec![])
    }

    /// A number that fits, often one at the end of its range.
    fn number(&mut self, format: Format) -> Tree {
        let random = (self.below(1 << 31) as i128) << 33
            | (self.below(1 << 31) as i128) << 2
            | self.below(4) as i128;
        let (least, most): (i128, i128) = match format {
            Format::Bit => (0, 1),
            Format::Word(n) => (0, (1 << n.min(64)) - 1),
            // A longer literal would need a suffix that rust-hdl does not take for signed words.
            Format::Int(n) => (
                -(1 << (n - 1).min(31)) + i128::from(n > 31),
                (1 << (n - 1).min(31)) - 1,
            ),
        };
        let n = match self.below(6) {
            0 => least,
            1 => most,
            2 => (least + 1).min(most),
            3 => (most - 1).max(least),
            4 => (random % 20).clamp(least, most),
            _ => least + random % (most - least + 1),
        };
        Tree::new(format, Node::Number(n), vec![])
    }

    /// A number without a type, for a position or a count.
    fn constant(&mut self, most: usize) -> Tree {
        let n = match self.below(4) {
            0 => 0,
            1 => most,
            _ => self.below(most + 1),
        };
        Tree::new(Format::Word(64), Node::Number(n as i128), vec![])
    }

    fn leaf(&mut self, format: Format, known: bool) -> Tree {
        match self.below(4) {
            3 if !known => self.number(format),
            _ => self.input(format),
        }
    }

    /// A constant position, or a word; computed positions are written as casts.
    fn position(&mut self, most: usize, depth: usize) -> Tree {
        if self.below(2) == 0 {
            return self.constant(most);
        }
        let width = self.of(COUNTS);
        if self.below(2) == 0 {
            return self.input(Format::Word(width));
        }
        let from = self.width();
        let inner = self.tree(Format::Word(from), depth - 1, true);
        Tree::new(Format::Word(width), Node::Cast, vec![inner])
    }

    fn word_or_int(&mut self, width: usize) -> Format {
        if self.below(2) == 0 {
            Format::Word(width)
        } else {
            Format::Int(width)
        }
    }

    fn pair(&mut self, format: Format, depth: usize, known: bool) -> Vec<Tree> {
        // One of the two may be a number or an untyped cast.
        let (a, b) = match self.below(3) {
            0 => (
                self.tree(format, depth, true),
                self.tree(format, depth, false),
            ),
            1 => (
                self.tree(format, depth, false),
                self.tree(format, depth, true),
            ),
            _ => (
                self.tree(format, depth, true),
                self.tree(format, depth, true),
            ),
        };
        debug_assert!(!known || a.known() || b.known());
        vec![a, b]
    }

    /// A tree of this format; `known` when its own text must show the format.
    fn tree(&mut self, format: Format, depth: usize, known: bool) -> Tree {
        if depth == 0 || self.below(6) == 0 {
            return self.leaf(format, known);
        }
        let d = depth - 1;
        let of = |node, parts| Tree::new(format, node, parts);
        match format {
            Format::Bit => self.bit(d),
            Format::Word(w) => self.word(w, d),
            Format::Int(w) => match self.below(if w == 32 { 9 } else { 8 }) {
                0..=2 => {
                    let op = self.of(&[Operator::Add, Operator::Subtract]);
                    let parts = self.pair(format, d, known);
                    of(Node::Binary(op), parts)
                }
                3 => of(Node::Negate, vec![self.tree(format, d, true)]),
                4 => of(Node::ToSigned, vec![self.tree(Format::Word(w), d, true)]),
                5 => {
                    let from = self.width();
                    let parts = vec![
                        self.tree(Format::Int(from), d, true),
                        self.position(from, depth),
                    ];
                    of(Node::Slice, parts)
                }
                6 | 7 if !known => {
                    let from = self.width();
                    of(Node::Resize, vec![self.tree(Format::Int(from), d, true)])
                }
                8 => {
                    let factor = Format::Int(16);
                    of(
                        Node::Product,
                        vec![self.tree(factor, d, true), self.tree(factor, d, true)],
                    )
                }
                _ => self.leaf(format, known),
            },
        }
    }

    fn bit(&mut self, d: usize) -> Tree {
        let of = |node, parts| Tree::new(Format::Bit, node, parts);
        let operators = [
            Operator::And,
            Operator::Or,
            Operator::Xor,
            Operator::Both,
            Operator::Either,
        ];
        let width = self.width();
        match self.below(9) {
            0 => of(Node::Not, vec![self.tree(Format::Bit, d, true)]),
            1 | 2 => {
                let op = self.of(&operators);
                let parts = self.pair(Format::Bit, d, true);
                of(Node::Binary(op), parts)
            }
            3..=5 => {
                let c = self.of(&[
                    Comparison::Equal,
                    Comparison::NotEqual,
                    Comparison::Less,
                    Comparison::LessEqual,
                    Comparison::Greater,
                    Comparison::GreaterEqual,
                ]);
                let format = match self.below(7) {
                    0 => Format::Bit,
                    _ => self.word_or_int(width),
                };
                let parts = self.pair(format, d, true);
                of(Node::Compare(c), parts)
            }
            6 => {
                let how = self.of(&[Reduction::All, Reduction::Any, Reduction::Parity]);
                of(
                    Node::Reduce(how),
                    vec![self.tree(Format::Word(width), d, true)],
                )
            }
            _ => {
                let format = self.word_or_int(width);
                let parts = vec![self.tree(format, d, true), self.position(width - 1, d + 1)];
                of(Node::Bit, parts)
            }
        }
    }

    fn word(&mut self, w: usize, d: usize) -> Tree {
        let format = Format::Word(w);
        let of = |node, parts| Tree::new(format, node, parts);
        let operators = [
            Operator::Add,
            Operator::Subtract,
            Operator::And,
            Operator::Or,
            Operator::Xor,
        ];
        let more = usize::from(w == 32 || w == 64);
        match self.below(15 + 2 * more) {
            0..=3 => {
                let op = self.of(&operators);
                let parts = self.pair(format, d, true);
                of(Node::Binary(op), parts)
            }
            4 => of(Node::Not, vec![self.tree(format, d, true)]),
            5 => of(
                Node::PlusBit,
                vec![self.tree(format, d, true), self.tree(Format::Bit, d, true)],
            ),
            6 | 7 => {
                let left = self.below(2) == 0;
                let word = self.tree(format, d, true);
                let by = if self.below(2) == 0 {
                    self.constant(w + 2)
                } else {
                    let width = self.of(COUNTS);
                    self.tree(Format::Word(width), d, true)
                };
                of(Node::Shift(left), vec![word, by])
            }
            8 | 9 => {
                let from = self.width();
                let parts = vec![
                    self.tree(Format::Word(from), d, true),
                    self.position(from, d + 1),
                ];
                of(Node::Slice, parts)
            }
            10 => {
                let word = self.tree(format, d, true);
                let parts = vec![
                    word,
                    self.position(w - 1, d + 1),
                    self.tree(Format::Bit, d, false),
                ];
                of(Node::Replace, parts)
            }
            11 | 12 => {
                let from = self.width();
                of(Node::Cast, vec![self.tree(Format::Word(from), d, true)])
            }
            13 => of(Node::ToUnsigned, vec![self.tree(Format::Int(w), d, true)]),
            14 => match self.number(format).node {
                Node::Number(n) => of(Node::Sized(n as u64), vec![]),
                _ => self.input(format),
            },
            _ if w == 32 => {
                let factor = Format::Word(16);
                of(
                    Node::Product,
                    vec![self.tree(factor, d, true), self.tree(factor, d, true)],
                )
            }
            _ => {
                let width = self.of(COUNTS);
                let parts = vec![self.number(format), self.tree(Format::Word(width), d, true)];
                of(Node::Shift(true), parts)
            }
        }
    }
}

/// The tree that a list of choices makes.
fn grow(list: &[u32], inputs: &[(String, Format)]) -> Tree {
    let mut choices = Choices {
        list,
        at: 0,
        inputs,
    };
    let width = choices.width();
    let format = match choices.below(5) {
        0 => Format::Bit,
        1 | 2 => Format::Int(width),
        _ => Format::Word(width),
    };
    choices.tree(format, DEPTH, false)
}

/// Trees of every format.
pub fn trees() -> impl Strategy<Value = Tree> {
    let inputs = inputs();
    proptest::collection::vec(any::<u32>(), 4..120).prop_map(move |list| grow(&list, &inputs))
}
