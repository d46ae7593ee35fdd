//! The cone-filtered line in two overlapped stages, one pixel per clock (Abbas 2003, section 3.3 and its VHDL model).
//!
//! A column takes three distances, D, D_L = cos φ − D and D_H = cos φ + D, and near the diagonal a fourth, 2·cos φ − |D|.
//! Abbas forms them with one shared adder and subtractor in four clocks per column, of which two overlap with the three
//! clocks in which the second stage writes pixels. Here E has an adder of its own (it belongs to the walk), so the shared
//! one does exactly one operation per pixel: while the second stage looks up and draws a lane, this stage forms the
//! distance of the next one, or D of the next column. Neither stage ever waits for the other.
//!
//! One adder serves both signs: a − b = ¬(¬a + b). The distance leaves as its bin in
//! the table of weights: words are in bins of 1/256 pixel, Q9.22.

use super::cone_words::{ConeWords, ConeWordsModel};
use crate::format::{unsigned_cast_integer, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: one clock from `load` to the distance of lane 0; one distance per clock.
#[derive(LogicBlock)]
pub struct ConeStages {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`.
    pub write: Signal<In, Bit>,
    /// Register word, 6 to 9; others are ignored.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// A new line begins.
    pub load: Signal<In, Bit>,
    /// The next lane or column follows.
    pub run: Signal<In, Bit>,
    /// What follows is the next column.
    pub turn: Signal<In, Bit>,
    /// The minor coordinate moves with it.
    pub rises: Signal<In, Bit>,
    /// Lane of the current pixel.
    pub lane: Signal<In, U<2>>,
    /// Bin of the current pixel's distance from the line, without its sign.
    pub index: Signal<Out, U<9>>,
    /// The line runs on the side of Y - 1.
    pub below: Signal<Out, Bit>,
    /// Register words.
    words: Quiet<ConeWords<9, 22>>,
    /// D: distance of the column's lane 0.
    column: Register<Q<9, 22>>,
    /// Distance of the current pixel.
    pixel: Register<Q<9, 22>>,
    /// D is negative.
    negative: Wire<Bit>,
    /// The shared adder subtracts.
    subtracts: Wire<Bit>,
    /// What is added to, or subtracted from.
    base: Wire<Q<9, 22>>,
    /// What is added or subtracted.
    other: Wire<Q<9, 22>>,
    /// The base, complemented for a subtraction.
    operand: Wire<Q<9, 22>>,
    /// The shared adder.
    sum: Wire<Q<9, 22>>,
    /// The next distance.
    result: Wire<Q<9, 22>>,
    /// On the line.
    zero: Constant<Q<9, 22>>,
}

impl Default for ConeStages {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            load: Default::default(),
            run: Default::default(),
            turn: Default::default(),
            rises: Default::default(),
            lane: Default::default(),
            index: Default::default(),
            below: Default::default(),
            words: Default::default(),
            column: Default::default(),
            pixel: Default::default(),
            negative: Default::default(),
            subtracts: Default::default(),
            base: Default::default(),
            other: Default::default(),
            operand: Default::default(),
            sum: Default::default(),
            result: Default::default(),
            zero: Constant::new(Q::from_code(0)),
        }
    }
}

impl Logic for ConeStages {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name cone_stages");
        comment!(
            "title Distances of a cone-filtered line, one pixel per clock with one shared adder."
        );
        comment!(
            "equation D += stay or D -= step per column; lanes |D|, cos - D, cos + D, 2 cos - |D|"
        );
        comment!("source Abbas 2003, section 3.3: two overlapped stages; equation 3.12 corrected (D -= step, D0 = 0).");
        comment!("latency One clock from load to index; one distance per clock.");
        dff_setup!(self, clock, column, pixel);
        self.words.clock.next = self.clock.val();
        self.words.write.next = self.write.val();
        self.words.word.next = self.word.val();
        self.words.data.next = self.data.val();
        self.words.load.next = self.load.val();

        // One operation per clock: the next column's D, or the next lane's distance.
        self.negative.next = self.column.q.val().get_bit(31);
        self.base.next = self.words.cosine.val();
        self.other.next = self.column.q.val();
        self.subtracts.next = true;
        if self.turn.val() {
            self.base.next = self.column.q.val();
            self.other.next = self.words.stay.val();
            if self.rises.val() {
                self.other.next = self.words.step.val();
            }
            self.subtracts.next = self.rises.val();
        } else if self.lane.val() == 1u64.into() {
            self.subtracts.next = false;
        } else if self.lane.val() == 2u64.into() {
            self.base.next = self.words.cosine_2.val();
            self.subtracts.next = !self.negative.val();
        }
        self.operand.next = self.base.val();
        if self.subtracts.val() {
            self.operand.next = !self.base.val();
        }
        self.sum.next = self.operand.val() + self.other.val();
        self.result.next = self.sum.val();
        if self.subtracts.val() {
            self.result.next = !self.sum.val();
        }

        if self.load.val() {
            self.column.d.next = self.words.first.val();
            self.pixel.d.next = self.words.first.val();
        } else if self.run.val() {
            self.pixel.d.next = self.result.val();
            if self.turn.val() {
                self.column.d.next = self.result.val();
            }
        }

        self.below.next = self.negative.val();
        if self.pixel.q.val().get_bit(31) {
            self.index.next =
                unsigned_cast_integer::<9, 9, 22>(self.zero.val() - self.pixel.q.val());
        } else {
            self.index.next = unsigned_cast_integer::<9, 9, 22>(self.pixel.q.val());
        }
    }
}

crate::clocked!(ConeStages;
    inputs write, word, data, load, run, turn, rises, lane;
    outputs index, below);

/// Integer model of [`ConeStages`].
#[derive(Clone, Copy, Debug, Default)]
pub struct ConeStagesModel {
    words: ConeWordsModel,
    column: i64,
    pixel: i64,
}

impl ConeStagesModel {
    /// Bin of the current pixel's distance.
    #[must_use]
    pub fn index(&self) -> usize {
        let shift = super::cone_words::FRACTION_BITS - super::TABLE_BITS as usize;
        (self.pixel.abs() >> shift) as usize & ((2 << super::TABLE_BITS) - 1)
    }

    /// The line runs on the side of Y − 1.
    #[must_use]
    pub fn below(&self) -> bool {
        self.column < 0
    }

    /// One clock edge, with the walk's controls before it and the lane it stands on.
    pub fn clock(
        &mut self,
        write: Option<(usize, u64)>,
        c: super::walk_model::WalkControls,
        lane: u64,
    ) {
        if c.load {
            self.column = self.words.first();
            self.pixel = self.column;
        } else if c.run {
            if c.turn {
                self.column = self.words.next(self.column, c.rises);
                self.pixel = self.column;
            } else {
                // Behind lane 3 the adder has nothing to do; it repeats lane 1.
                let next = if lane == 3 { 1 } else { lane + 1 };
                self.pixel = self.words.distance(self.column, next);
            }
        }
        self.words.clock(write, c.load);
    }
}
