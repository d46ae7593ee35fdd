//! One triangle edge as an exact digital differential analyser: the column of the first covered pixel centre, row by row.
//!
//! column += whole + carry; error += carry ? down : up; carry = (error >= 0). With up = dx mod dy and down = up − dy the
//! error term never leaves [−dy, dy), so its sign bit is the carry and one adder serves both cases (Bresenham's
//! argument; the papers add a truncated real slope instead, which drifts off the pixel centres).

use crate::format::{wrap, Q};
use crate::raster::{COLUMN_BITS, ERROR_BITS};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Latency: one clock from `load`; one row per clock while `step`.
#[derive(LogicBlock)]
pub struct EdgeWalk {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Takes the inputs below; wins over `step`.
    pub load: Signal<In, Bit>,
    /// Moves to the next row.
    pub step: Signal<In, Bit>,
    /// Column at the first row.
    pub first_column: Signal<In, Q<11, 0>>,
    /// Error term at the first row, biased: the step carries when it is not negative.
    pub first_error: Signal<In, Q<19, 0>>,
    /// Whole columns per row.
    pub whole: Signal<In, Q<11, 0>>,
    /// Error step without carry.
    pub up: Signal<In, Q<19, 0>>,
    /// Error step with carry.
    pub down: Signal<In, Q<19, 0>>,
    /// Column at the current row.
    pub column: Signal<Out, Q<11, 0>>,
    /// The next step moves one column more.
    pub carry: Signal<Out, Bit>,
    /// Column of the edge at the current row.
    position: Register<Q<11, 0>>,
    /// Biased error term, the next step carries when it is not negative.
    error: Register<Q<19, 0>>,
    /// Whole columns per row.
    slope: Register<Q<11, 0>>,
    /// Error step without carry, dx mod dy.
    error_up: Register<Q<19, 0>>,
    /// Error step with carry, dx mod dy - dy.
    error_down: Register<Q<19, 0>>,
    /// The next step carries.
    carries: Wire<Bit>,
    /// Columns of a carrying step.
    slope_carry: Wire<Q<11, 0>>,
    /// One column.
    one: Constant<Q<11, 0>>,
}

impl Default for EdgeWalk {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            load: Default::default(),
            step: Default::default(),
            first_column: Default::default(),
            first_error: Default::default(),
            whole: Default::default(),
            up: Default::default(),
            down: Default::default(),
            column: Default::default(),
            carry: Default::default(),
            position: Default::default(),
            error: Default::default(),
            slope: Default::default(),
            error_up: Default::default(),
            error_down: Default::default(),
            carries: Default::default(),
            slope_carry: Default::default(),
            one: Constant::new(Q::from_code(1)),
        }
    }
}

impl Logic for EdgeWalk {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name edge_walk");
        comment!("title One triangle edge, walked row by row, exact at pixel centres.");
        comment!("equation column(r) = ceil(((xa - 1/2) dy + (r + 1/2 - ya) dx) / dy), by whole steps and an error term");
        comment!("source Exact digital differential analyser; replaces the truncated slope of Abbas 2003, section 2.2.");
        comment!("latency One clock from load to column; one row per clock.");
        dff_setup!(self, clock, position, error, slope, error_up, error_down);
        self.carries.next = !self.error.q.val().get_bit(19);
        self.slope_carry.next = self.slope.q.val() + self.one.val();
        if self.load.val() {
            self.position.d.next = self.first_column.val();
            self.error.d.next = self.first_error.val();
            self.slope.d.next = self.whole.val();
            self.error_up.d.next = self.up.val();
            self.error_down.d.next = self.down.val();
        } else if self.step.val() {
            if self.carries.val() {
                self.position.d.next = self.position.q.val() + self.slope_carry.val();
                self.error.d.next = self.error.q.val() + self.error_down.q.val();
            } else {
                self.position.d.next = self.position.q.val() + self.slope.q.val();
                self.error.d.next = self.error.q.val() + self.error_up.q.val();
            }
        }
        self.column.next = self.position.q.val();
        self.carry.next = self.carries.val();
    }
}

crate::clocked!(EdgeWalk;
    inputs load, step, first_column, first_error, whole, up, down;
    outputs column, carry);

/// Integer model of [`EdgeWalk`], and the words of one edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EdgeModel {
    /// Column at the current row.
    pub column: i64,
    /// Biased error term.
    pub error: i64,
    /// Whole columns per row.
    pub whole: i64,
    /// Error step without carry.
    pub up: i64,
    /// Error step with carry.
    pub down: i64,
}

impl EdgeModel {
    /// Whether the next step carries.
    #[must_use]
    pub fn carry(&self) -> bool {
        self.error >= 0
    }

    /// One clock.
    pub fn clock(&mut self, load: Option<Self>, step: bool) {
        if let Some(words) = load {
            *self = words;
        } else if step {
            let carry = self.carry();
            self.column = wrap(self.column + self.whole + i64::from(carry), COLUMN_BITS);
            self.error = wrap(
                self.error + if carry { self.down } else { self.up },
                ERROR_BITS,
            );
        }
    }

    /// The edge's fields from its three register words (see [`super::shell`]).
    #[must_use]
    pub fn from_words(a: u64, b: u64, c: u64) -> Self {
        let high = |w: u64| wrap((w >> 20 & 0xfff) as i64, COLUMN_BITS);
        let low = |w: u64| wrap((w & 0xf_ffff) as i64, ERROR_BITS);
        Self {
            column: high(a),
            error: low(a),
            whole: high(b),
            up: low(b),
            down: low(c),
        }
    }
}
