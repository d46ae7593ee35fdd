//! From operations in any order to instructions clock by clock: a list scheduler and a register allocator.
//!
//! An instruction is issued in every clock. Its result can be read by the one after the next. A product is taken by one
//! instruction, at a fixed distance behind the one that starts it, and the multiplier takes as many clocks as y has
//! limbs. A quotient stays until the divider is started again. So the schedule knows every clock in advance; nothing
//! in the hardware waits or looks for hazards.

use super::instruction::{Division, Instruction, XFrom, YFrom};

/// Clocks from an instruction to the first one that can read its result.
pub const RESULT: usize = 2;
/// Clocks from a multiplication of one limb to the instruction that takes the product, less one.
pub const PRODUCT: usize = 4;
/// Registers; register 0 holds zero.
pub const REGISTERS: usize = 64;

/// Steps of a division.
#[must_use]
pub const fn steps(division: Division) -> usize {
    match division {
        Division::Whole => 14,
        Division::Fraction => 44,
        Division::Reciprocal => 64,
    }
}

/// An operation; a handle on its result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Value(pub(super) usize);

/// x of an operation.
#[derive(Clone, Copy, Debug)]
pub enum X {
    /// 0.
    Zero,
    /// A result.
    Of(Value),
    /// The product of a multiplication.
    Product(Value),
    /// The quotient of a division.
    Quotient(Value),
    /// What it leaves.
    Remainder(Value),
}

/// An operation before it has registers and a clock.
#[derive(Clone, Debug)]
struct Operation {
    instruction: Instruction,
    x: X,
    /// The result that y is.
    y: Option<Value>,
    /// Operations that must come so many clocks before.
    after: Vec<(usize, usize)>,
}

/// A program being written.
#[derive(Clone, Debug, Default)]
pub struct Builder {
    operations: Vec<Operation>,
}

impl Builder {
    /// Appends an operation: `instruction` says all but registers; `after` lists others to come before it.
    pub fn push(
        &mut self,
        instruction: Instruction,
        x: X,
        y: Option<Value>,
        after: &[Value],
    ) -> Value {
        let mut wait: Vec<(usize, usize)> = after.iter().map(|v| (v.0, RESULT)).collect();
        match x {
            X::Of(v) => wait.push((v.0, RESULT)),
            X::Quotient(v) | X::Remainder(v) => {
                let division = self.operations[v.0].instruction.divide;
                wait.push((v.0, 1 + steps(division.unwrap_or_default())));
            }
            X::Zero | X::Product(_) => {}
        }
        wait.extend(y.map(|v| (v.0, RESULT)));
        self.operations.push(Operation {
            instruction,
            x,
            y,
            after: wait,
        });
        Value(self.operations.len() - 1)
    }

    fn limbs(&self, i: usize) -> usize {
        let multiply = self.operations[i].instruction.multiply;
        multiply.map_or(1, |(limbs, _, _)| usize::from(limbs))
    }

    /// For every multiplication the operation that takes its product.
    fn takers(&self) -> Vec<Option<usize>> {
        let mut takers = vec![None; self.operations.len()];
        for (i, o) in self.operations.iter().enumerate() {
            if let X::Product(v) = o.x {
                assert!(takers[v.0].is_none(), "a product is taken once");
                takers[v.0] = Some(i);
            }
        }
        takers
    }

    /// Clocks from the issue of each operation to the end, at least.
    fn heights(&self, takers: &[Option<usize>]) -> Vec<usize> {
        let mut heights = vec![0; self.operations.len()];
        for i in (0..self.operations.len()).rev() {
            if let Some(taker) = takers[i] {
                heights[i] = heights[i].max(heights[taker] + PRODUCT + self.limbs(i));
            }
            for (before, wait) in &self.operations[i].after {
                let height = heights[i] + wait;
                heights[*before] = heights[*before].max(height);
            }
        }
        heights
    }

    /// The clock of every operation. `spread` weighs how early an operation was written against how far it is from the
    /// end: large values keep few registers in use.
    fn clocks(&self, spread: usize) -> Vec<usize> {
        let n = self.operations.len();
        let takers = self.takers();
        let heights = self.heights(&takers);
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by_key(|i| (i * spread) as i64 - 8 * heights[*i] as i64);
        let mut clocks: Vec<Option<usize>> = vec![None; n];
        let mut taken = std::collections::BTreeSet::new();
        // When the multiplier is free; what the divider waits for.
        let (mut multiplier, mut division): (usize, Option<usize>) = (0, None);
        let mut left = n;
        let mut t = 0;
        while left > 0 {
            let ready = |i: usize, at: usize, clocks: &[Option<usize>]| {
                let after = self.operations[i].after.iter();
                after
                    .into_iter()
                    .all(|(before, wait)| clocks[*before].is_some_and(|c| c + wait <= at))
            };
            let users = |d: usize| {
                self.operations.iter().enumerate().filter(
                    move |(_, o)| matches!(o.x, X::Quotient(v) | X::Remainder(v) if v.0 == d),
                )
            };
            if !taken.contains(&t) {
                let found = order.iter().copied().find(|&i| {
                    let o = &self.operations[i];
                    if clocks[i].is_some() || matches!(o.x, X::Product(_)) || !ready(i, t, &clocks)
                    {
                        return false;
                    }
                    if let Some(taker) = takers[i] {
                        let at = t + PRODUCT + self.limbs(i);
                        return t >= multiplier
                            && !taken.contains(&at)
                            && ready(taker, at, &clocks);
                    }
                    if o.instruction.divide.is_some() {
                        return division
                            .is_none_or(|d| users(d).all(|(user, _)| clocks[user].is_some()));
                    }
                    true
                });
                if let Some(i) = found {
                    clocks[i] = Some(t);
                    taken.insert(t);
                    left -= 1;
                    if let Some(taker) = takers[i] {
                        let at = t + PRODUCT + self.limbs(i);
                        clocks[taker] = Some(at);
                        taken.insert(at);
                        multiplier = t + self.limbs(i);
                        left -= 1;
                    }
                    if self.operations[i].instruction.divide.is_some() {
                        division = Some(i);
                    }
                }
            }
            t += 1;
            assert!(t < 1 << 14, "the operations wait for each other");
        }
        clocks.into_iter().flatten().collect()
    }

    /// Registers of all results; `None` when there are too few.
    fn registers(&self, clocks: &[usize]) -> Option<Vec<u8>> {
        let mut last = vec![0; self.operations.len()];
        for (i, o) in self.operations.iter().enumerate() {
            let x = match o.x {
                X::Of(v) => Some(v),
                _ => None,
            };
            for v in x.into_iter().chain(o.y) {
                last[v.0] = last[v.0].max(clocks[i]);
            }
        }
        let mut order: Vec<usize> = (0..clocks.len()).collect();
        order.sort_by_key(|i| clocks[*i]);
        let mut until = [0; REGISTERS];
        let mut registers = vec![0; clocks.len()];
        for i in order {
            if self.operations[i].instruction.to.is_none() {
                continue;
            }
            let free = (1..REGISTERS).find(|r| until[*r] <= clocks[i])?;
            until[free] = last[i].max(clocks[i] + 1);
            registers[i] = free as u8;
        }
        Some(registers)
    }

    /// The instructions, one per clock: the shortest of several schedules that fit the registers.
    ///
    /// # Panics
    /// When no schedule fits, which the program's own test excludes.
    #[must_use]
    pub fn schedule(&self) -> Vec<Instruction> {
        let fits = |spread: usize| {
            let clocks = self.clocks(spread);
            Some((self.registers(&clocks)?, clocks))
        };
        let best = (0..=16)
            .filter_map(fits)
            .min_by_key(|(_, clocks)| clocks.iter().max().copied());
        let (registers, clocks) = best.expect("a schedule fits the registers");
        let end = clocks.iter().max().copied().unwrap_or(0);
        let mut out = vec![Instruction::default(); end + 1];
        for (i, o) in self.operations.iter().enumerate() {
            let slot = &mut out[clocks[i]];
            *slot = o.instruction;
            match o.x {
                X::Zero => slot.x_from = XFrom::Register,
                X::Of(v) => slot.x = registers[v.0],
                X::Product(_) => slot.x_from = XFrom::Product,
                X::Quotient(_) => slot.x_from = XFrom::Quotient,
                X::Remainder(_) => slot.x_from = XFrom::Remainder,
            }
            if let Some(v) = o.y {
                slot.y = registers[v.0];
                slot.y_from = YFrom::Register;
            }
            slot.to = slot.to.map(|_| registers[i]);
        }
        out[end].end = true;
        out
    }
}
