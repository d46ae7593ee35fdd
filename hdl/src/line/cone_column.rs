//! The cone-filtered line a column at a time: three weighted pixels, and near the diagonal a fourth, in every clock.
//!
//! Where [`super::cone_stages`] shares one adder and one table between the pixels of a column, this unit has an adder and a
//! table for each lane: D and its neighbours' distances cos φ − D, cos φ + D, 2·cos φ − |D| are formed side by side from the
//! same words. A frame memory in four banks, pixel (x, y) in bank (x + y) mod 4, takes such a column in one clock, for the
//! four pixels of a column always lie in different banks.
//!
//! The weights are those of the core, bit for bit, if the tables have as many fraction bits. Equation 3.12 of Abbas (2003)
//! corrected as in [`super::cone_words`].

use super::cone_words::{ConeWords, ConeWordsModel};
use super::walk::LineWalk;
use super::walk_model::{WalkInputs, WalkModel, WalkPosition};
use super::weight_rom::{WeightModel, WeightRom};
use crate::format::{bit_cast_u, unsigned_cast_integer, wrap, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `A` is the width of a frame address; the tables have `I` address bits, `I` − 1 of them fraction bits of a pixel, and a
/// distance has `N` = 31 − `I` bits below a bin.
#[derive(LogicBlock)]
pub struct ConeColumns<const A: usize, const I: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Register word.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// The register words are complete; ignored while `load_ready` is low.
    pub start: Signal<In, Bit>,
    /// The column is taken.
    pub ready: Signal<In, Bit>,
    /// Register words may be written.
    pub load_ready: Signal<Out, Bit>,
    /// A column is offered; held until `ready`.
    pub valid: Signal<Out, Bit>,
    /// Major coordinate of the column.
    pub major: Signal<Out, Q<11, 0>>,
    /// Minor coordinate of its middle pixel.
    pub minor: Signal<Out, Q<11, 0>>,
    /// Frame address of that pixel.
    pub address: Signal<Out, U<A>>,
    /// The major axis is the screen's y axis.
    pub steep: Signal<Out, Bit>,
    /// The minor coordinate falls along the walk.
    pub falling: Signal<Out, Bit>,
    /// The fourth pixel lies on the side of Y - 1.
    pub below: Signal<Out, Bit>,
    /// Weight of the middle pixel, of 255.
    pub middle: Signal<Out, U<8>>,
    /// Weight of the pixel at Y + 1.
    pub plus: Signal<Out, U<8>>,
    /// Weight of the pixel at Y - 1.
    pub minus: Signal<Out, U<8>>,
    /// Weight of the fourth pixel, at Y + 2 or Y - 2.
    pub fourth: Signal<Out, U<8>>,
    /// A line is waiting or being walked, or a column is offered.
    pub busy: Signal<Out, Bit>,
    /// Register file and walk.
    walk: Quiet<LineWalk<A>>,
    /// Register words of the distances.
    words: Quiet<ConeWords<I, N>>,
    /// D: distance of the walk's middle pixel from the line.
    distance: Register<Q<I, N>>,
    /// A column is offered.
    out_valid: Register<Bit>,
    /// Major coordinate of the column.
    out_major: Register<Q<11, 0>>,
    /// Minor coordinate of its middle pixel.
    out_minor: Register<Q<11, 0>>,
    /// Frame address of that pixel.
    out_address: Register<U<A>>,
    /// The major axis is y.
    out_steep: Register<Bit>,
    /// The minor coordinate falls.
    out_falling: Register<Bit>,
    /// The fourth pixel lies on the side of Y - 1.
    out_below: Register<Bit>,
    /// Last lane of the line.
    out_lanes: Register<U<2>>,
    /// The stages move.
    moves: Wire<Bit>,
    /// D is negative.
    negative: Wire<Bit>,
    /// Weights of the middle pixel.
    middle_rom: Quiet<WeightRom<I>>,
    /// Weights of the pixel at Y + 1.
    plus_rom: Quiet<WeightRom<I>>,
    /// Weights of the pixel at Y - 1.
    minus_rom: Quiet<WeightRom<I>>,
    /// Weights of the fourth pixel.
    fourth_rom: Quiet<WeightRom<I>>,
    /// On the line.
    zero: Constant<Q<I, N>>,
}

impl<const A: usize, const I: usize, const N: usize> Default for ConeColumns<A, I, N> {
    fn default() -> Self {
        assert!(
            I + N == 31,
            "a distance has a sign, I bits of a bin and N below"
        );
        Self {
            clock: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            start: Default::default(),
            ready: Default::default(),
            load_ready: Default::default(),
            valid: Default::default(),
            major: Default::default(),
            minor: Default::default(),
            address: Default::default(),
            steep: Default::default(),
            falling: Default::default(),
            below: Default::default(),
            middle: Default::default(),
            plus: Default::default(),
            minus: Default::default(),
            fourth: Default::default(),
            busy: Default::default(),
            walk: Default::default(),
            words: Default::default(),
            distance: Default::default(),
            out_valid: Default::default(),
            out_major: Default::default(),
            out_minor: Default::default(),
            out_address: Default::default(),
            out_steep: Default::default(),
            out_falling: Default::default(),
            out_below: Default::default(),
            out_lanes: Default::default(),
            moves: Default::default(),
            negative: Default::default(),
            middle_rom: Default::default(),
            plus_rom: Default::default(),
            minus_rom: Default::default(),
            fourth_rom: Default::default(),
            zero: Constant::new(Q::from_code(0)),
        }
    }
}

impl<const A: usize, const I: usize, const N: usize> Logic for ConeColumns<A, I, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name cone_columns");
        comment!("title Cone-filtered line, one column of three weighted pixels per clock, four near the diagonal.");
        comment!("equation weights V(|D|), V(cos - D), V(cos + D), V(2 cos - |D|);  D += stay or D -= step per column");
        comment!("source Gupta, Sproull and Sutherland 1981; Abbas 2003, section 3.3, corrected.");
        comment!("latency Three clocks from start to the first column; then one column per clock.");
        dff_setup!(
            self,
            clock,
            distance,
            out_valid,
            out_major,
            out_minor,
            out_address,
            out_steep,
            out_falling,
            out_below,
            out_lanes
        );
        self.moves.next = !self.out_valid.q.val() || self.ready.val();
        self.walk.clock.next = self.clock.val();
        self.walk.write.next = self.write.val();
        self.walk.word.next = self.word.val();
        self.walk.data.next = bit_cast_u::<24, 32>(self.data.val());
        self.walk.start.next = self.start.val();
        self.walk.hold.next = false;
        self.walk.go.next = self.moves.val();
        self.walk.whole.next = true;
        self.words.clock.next = self.clock.val();
        self.words.write.next = self.write.val() && self.walk.load_ready.val();
        self.words.word.next = self.word.val();
        self.words.data.next = self.data.val();
        self.words.load.next = self.walk.load.val();

        // D of the next column.
        if self.walk.load.val() {
            self.distance.d.next = self.words.first.val();
        } else if self.walk.run.val() {
            if self.walk.rises.val() {
                self.distance.d.next = self.distance.q.val() - self.words.step.val();
            } else {
                self.distance.d.next = self.distance.q.val() + self.words.stay.val();
            }
        }

        // Distances of all lanes side by side.
        self.negative.next = self.distance.q.val().get_bit(31);
        if self.negative.val() {
            self.middle_rom.index.next =
                unsigned_cast_integer::<I, I, N>(self.zero.val() - self.distance.q.val());
            self.fourth_rom.index.next =
                unsigned_cast_integer::<I, I, N>(self.words.cosine_2.val() + self.distance.q.val());
        } else {
            self.middle_rom.index.next = unsigned_cast_integer::<I, I, N>(self.distance.q.val());
            self.fourth_rom.index.next =
                unsigned_cast_integer::<I, I, N>(self.words.cosine_2.val() - self.distance.q.val());
        }
        self.plus_rom.index.next =
            unsigned_cast_integer::<I, I, N>(self.words.cosine.val() - self.distance.q.val());
        self.minus_rom.index.next =
            unsigned_cast_integer::<I, I, N>(self.words.cosine.val() + self.distance.q.val());
        self.middle_rom.clock.next = self.clock.val();
        self.middle_rom.read.next = self.moves.val();
        self.plus_rom.clock.next = self.clock.val();
        self.plus_rom.read.next = self.moves.val();
        self.minus_rom.clock.next = self.clock.val();
        self.minus_rom.read.next = self.moves.val();
        self.fourth_rom.clock.next = self.clock.val();
        self.fourth_rom.read.next = self.moves.val();

        if self.moves.val() {
            self.out_valid.d.next = self.walk.active.val();
            self.out_major.d.next = self.walk.major.val();
            self.out_minor.d.next = self.walk.minor.val();
            self.out_address.d.next = self.walk.address.val();
            self.out_steep.d.next = self.walk.steep.val();
            self.out_falling.d.next = self.walk.falling.val();
            self.out_below.d.next = self.negative.val();
            self.out_lanes.d.next = self.walk.last_lane.val();
        }

        self.load_ready.next = self.walk.load_ready.val();
        self.valid.next = self.out_valid.q.val();
        self.major.next = self.out_major.q.val();
        self.minor.next = self.out_minor.q.val();
        self.address.next = self.out_address.q.val();
        self.steep.next = self.out_steep.q.val();
        self.falling.next = self.out_falling.q.val();
        self.below.next = self.out_below.q.val();
        // A line of one pixel has no neighbours, and only lines near the diagonal have a fourth pixel.
        self.middle.next = self.middle_rom.weight.val();
        self.plus.next = 0u64.into();
        self.minus.next = 0u64.into();
        self.fourth.next = 0u64.into();
        if self.out_lanes.q.val().any() {
            self.plus.next = self.plus_rom.weight.val();
            self.minus.next = self.minus_rom.weight.val();
        }
        if self.out_lanes.q.val() == 3u64.into() {
            self.fourth.next = self.fourth_rom.weight.val();
        }
        self.busy.next = self.walk.busy.val() || self.out_valid.q.val();
    }
}

crate::clocked!(ConeColumns<A, I, N>, const A: usize, const I: usize, const N: usize;
    inputs write, word, data, start, ready;
    outputs load_ready, valid, major, minor, address, steep, falling, below, middle, plus, minus, fourth, busy);

/// A column as [`ConeColumns`] offers it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Column {
    /// Where; of its error term nothing is said.
    pub at: WalkPosition,
    /// The fourth pixel lies on the side of Y − 1.
    pub below: bool,
    /// Weights of the middle pixel, of those at Y + 1 and Y − 1, of the fourth.
    pub weights: [u8; 4],
}

/// Integer model of [`ConeColumns`].
#[derive(Clone, Debug)]
pub struct ConeColumnsModel {
    walk: WalkModel,
    words: ConeWordsModel,
    distance: i64,
    fraction_bits: u32,
    roms: [WeightModel; 4],
    /// A column is offered.
    pub valid: bool,
    at: WalkPosition,
    below: bool,
}

impl ConeColumnsModel {
    /// The unit at power-up, with tables of so many fraction bits.
    #[must_use]
    pub fn new(address_bits: usize, fraction_bits: u32) -> Self {
        Self {
            walk: WalkModel::new(address_bits),
            words: ConeWordsModel::default(),
            distance: 0,
            fraction_bits,
            roms: std::array::from_fn(|_| WeightModel::new(fraction_bits)),
            valid: false,
            at: WalkPosition::default(),
            below: false,
        }
    }

    /// Register words may be written.
    #[must_use]
    pub fn load_ready(&self) -> bool {
        !self.walk.pending
    }

    /// Anything is waiting, walked or offered.
    #[must_use]
    pub fn busy(&self) -> bool {
        self.walk.pending || self.walk.active || self.valid
    }

    /// The column on offer.
    #[must_use]
    pub fn column(&self) -> Column {
        let lanes = match self.at.last_lane {
            0 => 1,
            3 => 4,
            _ => 3,
        };
        Column {
            at: self.at,
            below: self.below,
            weights: std::array::from_fn(|i| if i < lanes { self.roms[i].weight } else { 0 }),
        }
    }

    /// One clock edge: a register write, start, and whether the column is taken.
    pub fn clock(&mut self, write: Option<(usize, u64)>, start: bool, ready: bool) {
        let moves = !self.valid || ready;
        let i = WalkInputs {
            write,
            start,
            hold: false,
            go: moves,
            whole: true,
        };
        let c = self.walk.controls(&i);
        let accepted = write.filter(|_| self.load_ready());
        if moves {
            self.valid = self.walk.active;
            self.at = self.walk.at;
            self.below = self.distance < 0;
            for (lane, rom) in (0..).zip(&mut self.roms) {
                let d = self.words.distance(self.distance, lane);
                // Only D itself can be negative.
                let d = if lane == 0 { wrap(d.abs(), 32) } else { d };
                let bits = self.fraction_bits;
                let index = d >> (super::cone_words::FRACTION_BITS as u32 - bits);
                rom.clock(Some(index as usize & ((2 << bits) - 1)));
            }
        }
        if c.load {
            self.distance = self.words.first();
        } else if c.run {
            self.distance = self.words.next(self.distance, c.rises);
        }
        self.words.clock(accepted, c.load);
        self.walk.clock(&i);
    }
}
