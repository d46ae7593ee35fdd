//! The walk along a line: register words in, columns and their pixels out.
//!
//! A line is walked with its major coordinate rising, whatever end it was given first; the words say how the walk lies
//! on the screen (`steep`: the major axis is y; `falling`: the minor coordinate falls). One integer error term E decides:
//! from column to column, if E > 0 then E += step and the minor coordinate moves, else E += stay. With E = 2·dY − dX,
//! stay = 2·dY, step = 2·(dY − dX) at the first column this is Bresenham's line (1965; Abbas 2003, section 3.1, whose
//! hardware description tests E ≥ 0 and so moves lines of one pixel); other words make it the floor of the line, as the
//! box filter needs.
//!
//! Every column has as many pixels (*lanes*) as the line is thick, one per clock; or with `whole` it takes one clock.
//! The words of the next line are written while this one is walked.
//!
//! Register map (word number, bits high to low):
//!
//! | word | content |
//! |---|---|
//! | 0 | last lane\[14:13\], falling\[12\], steep\[11\], last column\[10:0\] |
//! | 1 | minor coordinate\[23:12\], major coordinate\[11:0\] of the first column, signed |
//! | 2 | address of that pixel, modulo 2^A |
//! | 3, 4, 5 | E behind the first column, stay, step, signed |
//! | 11 | frame height\[23:12\], frame width\[11:0\]; not double-buffered: write it while the core is idle |
//!
//! # Range
//! |E| ≤ 2·dX for lines of dX columns, before anything is cut off (Q13.0 holds dX ≤ 4095). Coordinates are Q11.0; the
//! host cuts a line at the frame's borders, so they stay within three pixels of 0..=2040.

use crate::format::{bit_cast_u, signed_cast_bits, unsigned_cast_integer, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Double-buffered register words; the frame's size comes after them, at [`FRAME_SIZE`].
pub const WORDS: usize = 6;
/// Register word of the frame's width and height.
pub const FRAME_SIZE: usize = 11;

/// `A` is the width of a frame address.
#[derive(LogicBlock)]
pub struct LineWalk<const A: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Register word.
    pub word: Signal<In, U<4>>,
    /// Register bus; its low 24 bits are enough.
    pub data: Signal<In, U<24>>,
    /// The register words are complete; ignored while `load_ready` is low.
    pub start: Signal<In, Bit>,
    /// Keeps a new line from being loaded (the memory is being cleared).
    pub hold: Signal<In, Bit>,
    /// The pixel is taken.
    pub go: Signal<In, Bit>,
    /// A column is taken at once, not lane by lane.
    pub whole: Signal<In, Bit>,
    /// The register words may be written.
    pub load_ready: Signal<Out, Bit>,
    /// A new line moves to the walk registers.
    pub load: Signal<Out, Bit>,
    /// The next lane or column follows.
    pub run: Signal<Out, Bit>,
    /// What follows is the next column.
    pub turn: Signal<Out, Bit>,
    /// The minor coordinate moves with the next column.
    pub rises: Signal<Out, Bit>,
    /// The walk stands on a pixel.
    pub active: Signal<Out, Bit>,
    /// Lane of the pixel, from 0.
    pub lane: Signal<Out, U<2>>,
    /// Last lane of the line.
    pub last_lane: Signal<Out, U<2>>,
    /// Major coordinate of the column.
    pub major: Signal<Out, Q<11, 0>>,
    /// Minor coordinate of its lane 0.
    pub minor: Signal<Out, Q<11, 0>>,
    /// Frame address of that pixel.
    pub address: Signal<Out, U<A>>,
    /// The major axis is the screen's y axis.
    pub steep: Signal<Out, Bit>,
    /// The minor coordinate falls along the walk.
    pub falling: Signal<Out, Bit>,
    /// Columns of the frame.
    pub frame_width: Signal<Out, Q<11, 0>>,
    /// Rows of the frame.
    pub frame_height: Signal<Out, Q<11, 0>>,
    /// A line is waiting or being walked.
    pub busy: Signal<Out, Bit>,
    /// The register words hold a complete line.
    pending: Register<Bit>,
    /// Columns of the frame.
    width: Register<Q<11, 0>>,
    /// Rows of the frame.
    height: Register<Q<11, 0>>,
    /// Next line, columns after the first.
    word_columns: Register<U<11>>,
    /// Next line, the major axis is y.
    word_steep: Register<Bit>,
    /// Next line, the minor coordinate falls.
    word_falling: Register<Bit>,
    /// Next line, last lane.
    word_lanes: Register<U<2>>,
    /// Next line, major coordinate of the first column.
    word_major: Register<Q<11, 0>>,
    /// Next line, minor coordinate of the first column.
    word_minor: Register<Q<11, 0>>,
    /// Next line, address of that pixel.
    word_address: Register<U<A>>,
    /// Next line, error term behind the first column.
    word_error: Register<Q<13, 0>>,
    /// Next line, error step where the minor coordinate stays.
    word_stay: Register<Q<13, 0>>,
    /// Next line, error step where it moves.
    word_step: Register<Q<13, 0>>,
    /// The walk stands on a pixel.
    walking: Register<Bit>,
    /// Columns that follow this one.
    columns_left: Register<U<11>>,
    /// The major axis is y.
    is_steep: Register<Bit>,
    /// The minor coordinate falls.
    is_falling: Register<Bit>,
    /// Last lane.
    lanes: Register<U<2>>,
    /// Lane of the pixel.
    at_lane: Register<U<2>>,
    /// Major coordinate of the column.
    along: Register<Q<11, 0>>,
    /// Minor coordinate of its lane 0.
    across: Register<Q<11, 0>>,
    /// Address of that pixel.
    place: Register<U<A>>,
    /// Error term: positive where the next column moves the minor coordinate.
    error: Register<Q<13, 0>>,
    /// Error step where it stays.
    error_stay: Register<Q<13, 0>>,
    /// Error step where it moves.
    error_step: Register<Q<13, 0>>,
    /// The write is accepted.
    accept: Wire<Bit>,
    /// Low bits of the register bus.
    low_bits: Wire<U<12>>,
    /// The next bits of the register bus.
    high_bits: Wire<U<12>>,
    /// Low bits of the register bus, signed.
    low: Wire<Q<11, 0>>,
    /// The next bits of the register bus, signed.
    high: Wire<Q<11, 0>>,
    /// Bits of an error term on the register bus.
    error_bits: Wire<U<14>>,
    /// An error term on the register bus.
    error_word: Wire<Q<13, 0>>,
    /// The minor coordinate moves with the next column.
    moves: Wire<Bit>,
    /// The pixel is the last of its column.
    column_done: Wire<Bit>,
    /// The column is the last of its line.
    line_done: Wire<Bit>,
    /// The pixel leaves.
    leaves: Wire<Bit>,
    /// A line moves to the walk registers.
    loading: Wire<Bit>,
    /// Frame width as an address step.
    row_step: Wire<U<A>>,
    /// Address step of the major axis.
    major_step: Wire<U<A>>,
    /// Address step of the minor axis.
    minor_step: Wire<U<A>>,
    /// Address of lane 0 of the next column, if the minor coordinate stays.
    straight: Wire<U<A>>,
    /// No column.
    zero: Constant<Q<13, 0>>,
    /// One pixel.
    one: Constant<Q<11, 0>>,
    /// One column.
    one_column: Constant<U<11>>,
    /// One lane.
    one_lane: Constant<U<2>>,
    /// One word of the frame.
    one_word: Constant<U<A>>,
}

impl<const A: usize> Default for LineWalk<A> {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            start: Default::default(),
            hold: Default::default(),
            go: Default::default(),
            whole: Default::default(),
            load_ready: Default::default(),
            load: Default::default(),
            run: Default::default(),
            turn: Default::default(),
            rises: Default::default(),
            active: Default::default(),
            lane: Default::default(),
            last_lane: Default::default(),
            major: Default::default(),
            minor: Default::default(),
            address: Default::default(),
            steep: Default::default(),
            falling: Default::default(),
            frame_width: Default::default(),
            frame_height: Default::default(),
            busy: Default::default(),
            pending: Default::default(),
            width: Default::default(),
            height: Default::default(),
            word_columns: Default::default(),
            word_steep: Default::default(),
            word_falling: Default::default(),
            word_lanes: Default::default(),
            word_major: Default::default(),
            word_minor: Default::default(),
            word_address: Default::default(),
            word_error: Default::default(),
            word_stay: Default::default(),
            word_step: Default::default(),
            walking: Default::default(),
            columns_left: Default::default(),
            is_steep: Default::default(),
            is_falling: Default::default(),
            lanes: Default::default(),
            at_lane: Default::default(),
            along: Default::default(),
            across: Default::default(),
            place: Default::default(),
            error: Default::default(),
            error_stay: Default::default(),
            error_step: Default::default(),
            accept: Default::default(),
            low_bits: Default::default(),
            high_bits: Default::default(),
            low: Default::default(),
            high: Default::default(),
            error_bits: Default::default(),
            error_word: Default::default(),
            moves: Default::default(),
            column_done: Default::default(),
            line_done: Default::default(),
            leaves: Default::default(),
            loading: Default::default(),
            row_step: Default::default(),
            major_step: Default::default(),
            minor_step: Default::default(),
            straight: Default::default(),
            zero: Constant::new(Q::from_code(0)),
            one: Constant::new(Q::from_code(1)),
            one_column: Constant::new(U::new(1)),
            one_lane: Constant::new(U::new(1)),
            one_word: Constant::new(U::new(1)),
        }
    }
}

impl<const A: usize> Logic for LineWalk<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name line_walk");
        comment!("title Register file and walk of a line core: columns along the major axis, lanes across.");
        comment!("equation E > 0: E += step, minor += 1; else E += stay; then the next column (all octants by steep and falling)");
        comment!("source Bresenham 1965; Abbas 2003, section 3.1, with the tie rule of the algorithm, not of its listing.");
        comment!("latency Two clocks from start to the first pixel; then one pixel, or one column, per clock.");
        dff_setup!(
            self,
            clock,
            pending,
            width,
            height,
            word_columns,
            word_steep,
            word_falling,
            word_lanes,
            word_major,
            word_minor,
            word_address,
            word_error,
            word_stay,
            word_step,
            walking,
            columns_left,
            is_steep,
            is_falling,
            lanes,
            at_lane,
            along,
            across,
            place,
            error,
            error_stay,
            error_step
        );

        // Register file.
        self.accept.next = self.write.val() && !self.pending.q.val();
        self.low_bits.next = self.data.val().get_bits::<12>(0);
        self.high_bits.next = self.data.val().get_bits::<12>(12);
        self.low.next = signed_cast_bits::<11, 0, 12>(self.low_bits.val());
        self.high.next = signed_cast_bits::<11, 0, 12>(self.high_bits.val());
        self.error_bits.next = self.data.val().get_bits::<14>(0);
        self.error_word.next = signed_cast_bits::<13, 0, 14>(self.error_bits.val());
        if self.accept.val() {
            if self.word.val() == 0u64.into() {
                self.word_columns.d.next = self.data.val().get_bits::<11>(0);
                self.word_steep.d.next = self.data.val().get_bit(11);
                self.word_falling.d.next = self.data.val().get_bit(12);
                self.word_lanes.d.next = self.data.val().get_bits::<2>(13);
            }
            if self.word.val() == 1u64.into() {
                self.word_major.d.next = self.low.val();
                self.word_minor.d.next = self.high.val();
            }
            if self.word.val() == 2u64.into() {
                self.word_address.d.next = bit_cast_u::<A, 24>(self.data.val());
            }
            if self.word.val() == 3u64.into() {
                self.word_error.d.next = self.error_word.val();
            }
            if self.word.val() == 4u64.into() {
                self.word_stay.d.next = self.error_word.val();
            }
            if self.word.val() == 5u64.into() {
                self.word_step.d.next = self.error_word.val();
            }
            if self.word.val() == 11u64.into() {
                self.width.d.next = self.low.val();
                self.height.d.next = self.high.val();
            }
        }

        // What the walk does in this clock.
        self.moves.next = self.zero.val() < self.error.q.val();
        self.leaves.next = self.walking.q.val() && self.go.val();
        self.column_done.next = self.whole.val() || (self.at_lane.q.val() == self.lanes.q.val());
        self.line_done.next = self.column_done.val() && !self.columns_left.q.val().any();
        self.loading.next = self.pending.q.val()
            && !self.hold.val()
            && (!self.walking.q.val() || (self.leaves.val() && self.line_done.val()));
        if self.loading.val() {
            self.pending.d.next = false;
        } else if self.start.val() && !self.pending.q.val() {
            self.pending.d.next = true;
        }

        // Address steps.
        self.row_step.next = unsigned_cast_integer::<A, 11, 0>(self.width.q.val());
        self.major_step.next = self.one_word.val();
        self.minor_step.next = self.row_step.val();
        if self.is_steep.q.val() {
            self.major_step.next = self.row_step.val();
            self.minor_step.next = self.one_word.val();
        }
        self.straight.next = self.place.q.val() + self.major_step.val();

        if self.loading.val() {
            self.walking.d.next = true;
            self.columns_left.d.next = self.word_columns.q.val();
            self.is_steep.d.next = self.word_steep.q.val();
            self.is_falling.d.next = self.word_falling.q.val();
            self.lanes.d.next = self.word_lanes.q.val();
            self.at_lane.d.next = 0u64.into();
            self.along.d.next = self.word_major.q.val();
            self.across.d.next = self.word_minor.q.val();
            self.place.d.next = self.word_address.q.val();
            self.error.d.next = self.word_error.q.val();
            self.error_stay.d.next = self.word_stay.q.val();
            self.error_step.d.next = self.word_step.q.val();
        } else if self.leaves.val() {
            if self.line_done.val() {
                self.walking.d.next = false;
            } else if self.column_done.val() {
                self.columns_left.d.next = self.columns_left.q.val() - self.one_column.val();
                self.at_lane.d.next = 0u64.into();
                self.along.d.next = self.along.q.val() + self.one.val();
                if self.moves.val() {
                    self.error.d.next = self.error.q.val() + self.error_step.q.val();
                    if self.is_falling.q.val() {
                        self.across.d.next = self.across.q.val() - self.one.val();
                        self.place.d.next = self.straight.val() - self.minor_step.val();
                    } else {
                        self.across.d.next = self.across.q.val() + self.one.val();
                        self.place.d.next = self.straight.val() + self.minor_step.val();
                    }
                } else {
                    self.error.d.next = self.error.q.val() + self.error_stay.q.val();
                    self.place.d.next = self.straight.val();
                }
            } else {
                self.at_lane.d.next = self.at_lane.q.val() + self.one_lane.val();
            }
        }

        self.load_ready.next = !self.pending.q.val();
        self.load.next = self.loading.val();
        self.run.next = self.leaves.val();
        self.turn.next = self.column_done.val();
        self.rises.next = self.moves.val();
        self.active.next = self.walking.q.val();
        self.lane.next = self.at_lane.q.val();
        self.last_lane.next = self.lanes.q.val();
        self.major.next = self.along.q.val();
        self.minor.next = self.across.q.val();
        self.address.next = self.place.q.val();
        self.steep.next = self.is_steep.q.val();
        self.falling.next = self.is_falling.q.val();
        self.frame_width.next = self.width.q.val();
        self.frame_height.next = self.height.q.val();
        self.busy.next = self.pending.q.val() || self.walking.q.val();
    }
}

crate::clocked!(LineWalk<A>, const A: usize;
    inputs write, word, data, start, hold, go, whole;
    outputs load_ready, load, run, turn, rises, active, lane, last_lane, major, minor, address, steep, falling,
        frame_width, frame_height, busy);
