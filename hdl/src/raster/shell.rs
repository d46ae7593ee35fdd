//! The raster shell: register words in, fragments and interpolant controls out.
//!
//! A triangle is walked from its *major* edge (the one that spans all rows) towards its minor edges. `mirrored`
//! triangles have the major edge on the right: all columns are complemented (x' = !x = −1 − x), and only the screen
//! column is complemented back, so one walk serves both orientations.
//!
//! ```text
//!  register words --load--> line registers --take--> pixel registers --> fragment (x, y, address)
//!  (next triangle)          (next span)              (current span)
//! ```
//!
//! The line registers always hold the *next* span, so spans follow each other without a bubble, and so do triangles
//! when their words are complete in time. A row without a pixel costs at most one clock.
//!
//! Register map (word number, bits high to low):
//!
//! | word | content |
//! |---|---|
//! | 0 | mirrored\[22\], upper_rows\[21:11\], rows\[10:0\] |
//! | 1 | address of (column 0, first row)\[31:11\], first row\[10:0\] |
//! | 2, 3, 4 | major edge: column\[31:20\] error\[19:0\]; whole\[31:20\] up\[19:0\]; down\[19:0\] |
//! | 5, 6, 7 | upper minor edge, likewise |
//! | 8, 9, 10 | lower minor edge, likewise; used after upper_rows rows |
//! | 11 | frame width\[11:0\], not double-buffered: write it while the core is idle |
//!
//! A triangle without an upper part puts its lower edge in words 5 to 7. Pixels outside columns 0..width are walked
//! but not emitted, and a span ends at the frame's border.

use super::edge_walk::EdgeWalk;
use crate::format::{signed_cast_bits, unsigned_cast_integer, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

pub use super::model::{ShellInputs, ShellModel, ShellOutputs};

/// Double-buffered register words; word [`FRAME_WIDTH`] follows them.
pub const WORDS: usize = 11;
/// Register word of the frame width.
pub const FRAME_WIDTH: usize = 11;

/// `A` is the width of a frame address.
#[derive(LogicBlock)]
pub struct Shell<const A: usize> {
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
    /// Keeps a new triangle from being loaded (the depth memory is being cleared).
    pub hold: Signal<In, Bit>,
    /// The stages behind the pixel registers move.
    pub go: Signal<In, Bit>,
    /// The register words may be written.
    pub load_ready: Signal<Out, Bit>,
    /// A new triangle moves to the line registers.
    pub load: Signal<Out, Bit>,
    /// The line registers move to the next row.
    pub step: Signal<Out, Bit>,
    /// That step carries.
    pub carry: Signal<Out, Bit>,
    /// A new span moves to the pixel registers.
    pub take: Signal<Out, Bit>,
    /// The pixel registers move on.
    pub run: Signal<Out, Bit>,
    /// The pixel registers stand on a pixel of the frame.
    pub fragment: Signal<Out, Bit>,
    /// Its column.
    pub x: Signal<Out, U<11>>,
    /// Its row.
    pub y: Signal<Out, U<11>>,
    /// Its frame address, row · width + column.
    pub address: Signal<Out, U<A>>,
    /// A triangle is waiting or being walked.
    pub busy: Signal<Out, Bit>,
    /// The register words hold a complete triangle.
    pending: Register<Bit>,
    /// Columns of the frame.
    frame_width: Register<Q<11, 0>>,
    /// Next triangle, rows.
    word_rows: Register<U<11>>,
    /// Next triangle, rows of the upper minor edge.
    word_upper_rows: Register<U<11>>,
    /// Next triangle, columns are complemented.
    word_mirrored: Register<Bit>,
    /// Next triangle, first row.
    word_row: Register<U<11>>,
    /// Next triangle, address of column 0 of the first row.
    word_base: Register<U<A>>,
    /// Next triangle, major edge, column at the first row.
    word_major_column: Register<Q<11, 0>>,
    /// Next triangle, major edge, biased error term at the first row.
    word_major_error: Register<Q<19, 0>>,
    /// Next triangle, major edge, whole columns per row.
    word_major_whole: Register<Q<11, 0>>,
    /// Next triangle, major edge, error step without carry.
    word_major_up: Register<Q<19, 0>>,
    /// Next triangle, major edge, error step with carry.
    word_major_down: Register<Q<19, 0>>,
    /// Next triangle, upper minor edge, column at the first row.
    word_upper_column: Register<Q<11, 0>>,
    /// Next triangle, upper minor edge, biased error term at the first row.
    word_upper_error: Register<Q<19, 0>>,
    /// Next triangle, upper minor edge, whole columns per row.
    word_upper_whole: Register<Q<11, 0>>,
    /// Next triangle, upper minor edge, error step without carry.
    word_upper_up: Register<Q<19, 0>>,
    /// Next triangle, upper minor edge, error step with carry.
    word_upper_down: Register<Q<19, 0>>,
    /// Next triangle, lower minor edge, column at the first row.
    word_lower_column: Register<Q<11, 0>>,
    /// Next triangle, lower minor edge, biased error term at the first row.
    word_lower_error: Register<Q<19, 0>>,
    /// Next triangle, lower minor edge, whole columns per row.
    word_lower_whole: Register<Q<11, 0>>,
    /// Next triangle, lower minor edge, error step without carry.
    word_lower_up: Register<Q<19, 0>>,
    /// Next triangle, lower minor edge, error step with carry.
    word_lower_down: Register<Q<19, 0>>,
    /// Current triangle, lower minor edge, column at the first row.
    lower_column: Register<Q<11, 0>>,
    /// Current triangle, lower minor edge, biased error term at the first row.
    lower_error: Register<Q<19, 0>>,
    /// Current triangle, lower minor edge, whole columns per row.
    lower_whole: Register<Q<11, 0>>,
    /// Current triangle, lower minor edge, error step without carry.
    lower_up: Register<Q<19, 0>>,
    /// Current triangle, lower minor edge, error step with carry.
    lower_down: Register<Q<19, 0>>,
    /// The line registers hold a span.
    line_active: Register<Bit>,
    /// Rows from this one on.
    rows_left: Register<U<11>>,
    /// Rows from this one on that end at the upper minor edge.
    upper_left: Register<U<11>>,
    /// Row of the next span.
    line_row: Register<U<11>>,
    /// Address of column 0 of that row.
    line_base: Register<U<A>>,
    /// Columns of the next span are complemented.
    line_mirrored: Register<Bit>,
    /// The pixel registers stand on a pixel.
    running: Register<Bit>,
    /// Walk column of the pixel.
    column: Register<Q<11, 0>>,
    /// One past the last walk column of the span.
    span_end: Register<Q<11, 0>>,
    /// Row of the pixel.
    pixel_row: Register<U<11>>,
    /// Address of column 0 of that row.
    pixel_base: Register<U<A>>,
    /// Columns of the span are complemented.
    pixel_mirrored: Register<Bit>,
    /// The write is accepted.
    accept: Wire<Bit>,
    /// Upper part of the register bus.
    high_bits: Wire<U<12>>,
    /// Lower part of the register bus.
    low_bits: Wire<U<20>>,
    /// Upper part of the register bus as a column.
    high: Wire<Q<11, 0>>,
    /// Lower part of the register bus as an error term.
    low: Wire<Q<19, 0>>,
    /// Low part of the register bus as a column.
    width_word: Wire<Q<11, 0>>,
    /// Low part of the register bus.
    width_bits: Wire<U<12>>,
    /// Minus the frame width.
    negative_width: Wire<Q<11, 0>>,
    /// First walk column of the frame for the next span.
    line_near: Wire<Q<11, 0>>,
    /// One past the last walk column of the frame for the next span.
    line_far: Wire<Q<11, 0>>,
    /// First walk column of the frame for this span.
    pixel_near: Wire<Q<11, 0>>,
    /// One past the last walk column of the frame for this span.
    pixel_far: Wire<Q<11, 0>>,
    /// The next span meets the frame.
    has_pixels: Wire<Bit>,
    /// Walk column of the next pixel.
    next_column: Wire<Q<11, 0>>,
    /// This is the last pixel of the span.
    span_done: Wire<Bit>,
    /// The pixel registers can take a span.
    pixel_free: Wire<Bit>,
    /// A span moves to the pixel registers.
    taking: Wire<Bit>,
    /// The line registers move on.
    advance: Wire<Bit>,
    /// The next span is the last of its triangle.
    last_row: Wire<Bit>,
    /// A triangle moves to the line registers.
    loading: Wire<Bit>,
    /// The line registers move to the next row.
    stepping: Wire<Bit>,
    /// The lower minor edge takes over.
    switching: Wire<Bit>,
    /// The minor edge takes new words.
    reload: Wire<Bit>,
    /// Minor edge to take, column at the first row.
    reload_column: Wire<Q<11, 0>>,
    /// Minor edge to take, biased error term at the first row.
    reload_error: Wire<Q<19, 0>>,
    /// Minor edge to take, whole columns per row.
    reload_whole: Wire<Q<11, 0>>,
    /// Minor edge to take, error step without carry.
    reload_up: Wire<Q<19, 0>>,
    /// Minor edge to take, error step with carry.
    reload_down: Wire<Q<19, 0>>,
    /// The pixel registers move on.
    running_now: Wire<Bit>,
    /// Column on the screen.
    screen_column: Wire<Q<11, 0>>,
    /// Column on the screen, as an address.
    screen_address: Wire<U<A>>,
    /// Frame width, as an address step.
    width_address: Wire<U<A>>,
    /// The edge that spans all rows.
    major: Quiet<EdgeWalk>,
    /// The edge that ends the spans.
    minor: Quiet<EdgeWalk>,
    /// Column 0.
    zero: Constant<Q<11, 0>>,
    /// One column.
    one: Constant<Q<11, 0>>,
    /// One row.
    one_row: Constant<U<11>>,
}

impl<const A: usize> Default for Shell<A> {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            word: Default::default(),
            data: Default::default(),
            start: Default::default(),
            hold: Default::default(),
            go: Default::default(),
            load_ready: Default::default(),
            load: Default::default(),
            step: Default::default(),
            carry: Default::default(),
            take: Default::default(),
            run: Default::default(),
            fragment: Default::default(),
            x: Default::default(),
            y: Default::default(),
            address: Default::default(),
            busy: Default::default(),
            pending: Default::default(),
            frame_width: Default::default(),
            word_rows: Default::default(),
            word_upper_rows: Default::default(),
            word_mirrored: Default::default(),
            word_row: Default::default(),
            word_base: Default::default(),
            word_major_column: Default::default(),
            word_major_error: Default::default(),
            word_major_whole: Default::default(),
            word_major_up: Default::default(),
            word_major_down: Default::default(),
            word_upper_column: Default::default(),
            word_upper_error: Default::default(),
            word_upper_whole: Default::default(),
            word_upper_up: Default::default(),
            word_upper_down: Default::default(),
            word_lower_column: Default::default(),
            word_lower_error: Default::default(),
            word_lower_whole: Default::default(),
            word_lower_up: Default::default(),
            word_lower_down: Default::default(),
            lower_column: Default::default(),
            lower_error: Default::default(),
            lower_whole: Default::default(),
            lower_up: Default::default(),
            lower_down: Default::default(),
            line_active: Default::default(),
            rows_left: Default::default(),
            upper_left: Default::default(),
            line_row: Default::default(),
            line_base: Default::default(),
            line_mirrored: Default::default(),
            running: Default::default(),
            column: Default::default(),
            span_end: Default::default(),
            pixel_row: Default::default(),
            pixel_base: Default::default(),
            pixel_mirrored: Default::default(),
            accept: Default::default(),
            high_bits: Default::default(),
            low_bits: Default::default(),
            high: Default::default(),
            low: Default::default(),
            width_word: Default::default(),
            width_bits: Default::default(),
            negative_width: Default::default(),
            line_near: Default::default(),
            line_far: Default::default(),
            pixel_near: Default::default(),
            pixel_far: Default::default(),
            has_pixels: Default::default(),
            next_column: Default::default(),
            span_done: Default::default(),
            pixel_free: Default::default(),
            taking: Default::default(),
            advance: Default::default(),
            last_row: Default::default(),
            loading: Default::default(),
            stepping: Default::default(),
            switching: Default::default(),
            reload: Default::default(),
            reload_column: Default::default(),
            reload_error: Default::default(),
            reload_whole: Default::default(),
            reload_up: Default::default(),
            reload_down: Default::default(),
            running_now: Default::default(),
            screen_column: Default::default(),
            screen_address: Default::default(),
            width_address: Default::default(),
            major: Default::default(),
            minor: Default::default(),
            zero: Constant::new(Q::from_code(0)),
            one: Constant::new(Q::from_code(1)),
            one_row: Constant::new(U::new(1)),
        }
    }
}

// "Not left of the border" is a comparator and an inverter.
#[allow(clippy::nonminimal_bool)]
impl<const A: usize> Logic for Shell<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name raster_shell");
        comment!("title Register file, exact edge walk and pixel counter of a triangle core.");
        comment!("equation span of row r = columns major(r) .. minor(r) - 1; screen column = mirrored ? ~column : column");
        comment!("source Register file as in Abbas 2003, appendix (select, data, strobe), double-buffered; edge walk exact.");
        comment!("latency Two clocks from start to the first fragment; then one pixel per clock, without bubbles.");
        dff_setup!(
            self,
            clock,
            pending,
            frame_width,
            word_rows,
            word_upper_rows,
            word_mirrored,
            word_row,
            word_base,
            word_major_column,
            word_major_error,
            word_major_whole,
            word_major_up,
            word_major_down,
            word_upper_column,
            word_upper_error,
            word_upper_whole,
            word_upper_up,
            word_upper_down,
            word_lower_column,
            word_lower_error,
            word_lower_whole,
            word_lower_up,
            word_lower_down,
            lower_column,
            lower_error,
            lower_whole,
            lower_up,
            lower_down,
            line_active,
            rows_left,
            upper_left,
            line_row,
            line_base,
            line_mirrored,
            running,
            column,
            span_end,
            pixel_row,
            pixel_base,
            pixel_mirrored
        );

        self.accept.next = self.write.val() && !self.pending.q.val();
        self.high_bits.next = self.data.val().get_bits::<12>(20);
        self.low_bits.next = self.data.val().get_bits::<20>(0);
        self.high.next = signed_cast_bits::<11, 0, 12>(self.high_bits.val());
        self.low.next = signed_cast_bits::<19, 0, 20>(self.low_bits.val());
        self.width_bits.next = self.data.val().get_bits::<12>(0);
        self.width_word.next = signed_cast_bits::<11, 0, 12>(self.width_bits.val());
        if self.accept.val() {
            if self.word.val() == 0u64.into() {
                self.word_rows.d.next = self.data.val().get_bits::<11>(0);
                self.word_upper_rows.d.next = self.data.val().get_bits::<11>(11);
                self.word_mirrored.d.next = self.data.val().get_bit(22);
            }
            if self.word.val() == 1u64.into() {
                self.word_row.d.next = self.data.val().get_bits::<11>(0);
                self.word_base.d.next = self.data.val().get_bits::<A>(11);
            }
            if self.word.val() == 2u64.into() {
                self.word_major_column.d.next = self.high.val();
                self.word_major_error.d.next = self.low.val();
            }
            if self.word.val() == 3u64.into() {
                self.word_major_whole.d.next = self.high.val();
                self.word_major_up.d.next = self.low.val();
            }
            if self.word.val() == 4u64.into() {
                self.word_major_down.d.next = self.low.val();
            }
            if self.word.val() == 5u64.into() {
                self.word_upper_column.d.next = self.high.val();
                self.word_upper_error.d.next = self.low.val();
            }
            if self.word.val() == 6u64.into() {
                self.word_upper_whole.d.next = self.high.val();
                self.word_upper_up.d.next = self.low.val();
            }
            if self.word.val() == 7u64.into() {
                self.word_upper_down.d.next = self.low.val();
            }
            if self.word.val() == 8u64.into() {
                self.word_lower_column.d.next = self.high.val();
                self.word_lower_error.d.next = self.low.val();
            }
            if self.word.val() == 9u64.into() {
                self.word_lower_whole.d.next = self.high.val();
                self.word_lower_up.d.next = self.low.val();
            }
            if self.word.val() == 10u64.into() {
                self.word_lower_down.d.next = self.low.val();
            }
            if self.word.val() == 11u64.into() {
                self.frame_width.d.next = self.width_word.val();
            }
        }

        // Where the frame begins and ends in walk columns.
        self.negative_width.next = self.zero.val() - self.frame_width.q.val();
        self.line_near.next = self.zero.val();
        self.line_far.next = self.frame_width.q.val();
        if self.line_mirrored.q.val() {
            self.line_near.next = self.negative_width.val();
            self.line_far.next = self.zero.val();
        }
        self.pixel_near.next = self.zero.val();
        self.pixel_far.next = self.frame_width.q.val();
        if self.pixel_mirrored.q.val() {
            self.pixel_near.next = self.negative_width.val();
            self.pixel_far.next = self.zero.val();
        }

        // The three levels: words, next span, current span.
        self.has_pixels.next = (self.major.column.val() < self.minor.column.val())
            && (self.major.column.val() < self.line_far.val())
            && (self.line_near.val() < self.minor.column.val());
        self.next_column.next = self.column.q.val() + self.one.val();
        self.span_done.next = (self.next_column.val() == self.span_end.q.val())
            || (self.next_column.val() == self.pixel_far.val());
        self.pixel_free.next = !self.running.q.val() || (self.go.val() && self.span_done.val());
        self.taking.next =
            self.line_active.q.val() && self.has_pixels.val() && self.pixel_free.val();
        self.advance.next =
            self.taking.val() || (self.line_active.q.val() && !self.has_pixels.val());
        self.last_row.next = self.rows_left.q.val() == self.one_row.val();
        self.loading.next = self.pending.q.val()
            && !self.hold.val()
            && (!self.line_active.q.val() || (self.advance.val() && self.last_row.val()));
        self.stepping.next = self.advance.val() && !self.last_row.val();
        self.switching.next =
            self.stepping.val() && (self.upper_left.q.val() == self.one_row.val());
        self.running_now.next = self.running.q.val() && self.go.val();

        if self.loading.val() {
            self.pending.d.next = false;
        } else if self.start.val() && !self.pending.q.val() {
            self.pending.d.next = true;
        }

        self.width_address.next = unsigned_cast_integer::<A, 11, 0>(self.frame_width.q.val());
        if self.loading.val() {
            self.line_active.d.next = self.word_rows.q.val().any();
            self.rows_left.d.next = self.word_rows.q.val();
            self.upper_left.d.next = self.word_upper_rows.q.val();
            self.line_row.d.next = self.word_row.q.val();
            self.line_base.d.next = self.word_base.q.val();
            self.line_mirrored.d.next = self.word_mirrored.q.val();
            self.lower_column.d.next = self.word_lower_column.q.val();
            self.lower_error.d.next = self.word_lower_error.q.val();
            self.lower_whole.d.next = self.word_lower_whole.q.val();
            self.lower_up.d.next = self.word_lower_up.q.val();
            self.lower_down.d.next = self.word_lower_down.q.val();
        } else if self.stepping.val() {
            self.rows_left.d.next = self.rows_left.q.val() - self.one_row.val();
            self.upper_left.d.next = self.upper_left.q.val() - self.one_row.val();
            self.line_row.d.next = self.line_row.q.val() + self.one_row.val();
            self.line_base.d.next = self.line_base.q.val() + self.width_address.val();
        } else if self.advance.val() {
            self.line_active.d.next = false;
        }

        self.major.clock.next = self.clock.val();
        self.major.load.next = self.loading.val();
        self.major.step.next = self.stepping.val();
        self.major.first_column.next = self.word_major_column.q.val();
        self.major.first_error.next = self.word_major_error.q.val();
        self.major.whole.next = self.word_major_whole.q.val();
        self.major.up.next = self.word_major_up.q.val();
        self.major.down.next = self.word_major_down.q.val();

        self.reload.next = self.loading.val() || self.switching.val();
        self.reload_column.next = self.word_upper_column.q.val();
        self.reload_error.next = self.word_upper_error.q.val();
        self.reload_whole.next = self.word_upper_whole.q.val();
        self.reload_up.next = self.word_upper_up.q.val();
        self.reload_down.next = self.word_upper_down.q.val();
        if self.switching.val() {
            self.reload_column.next = self.lower_column.q.val();
            self.reload_error.next = self.lower_error.q.val();
            self.reload_whole.next = self.lower_whole.q.val();
            self.reload_up.next = self.lower_up.q.val();
            self.reload_down.next = self.lower_down.q.val();
        }
        self.minor.clock.next = self.clock.val();
        self.minor.load.next = self.reload.val();
        self.minor.step.next = self.stepping.val();
        self.minor.first_column.next = self.reload_column.val();
        self.minor.first_error.next = self.reload_error.val();
        self.minor.whole.next = self.reload_whole.val();
        self.minor.up.next = self.reload_up.val();
        self.minor.down.next = self.reload_down.val();

        if self.taking.val() {
            self.running.d.next = true;
            self.column.d.next = self.major.column.val();
            self.span_end.d.next = self.minor.column.val();
            self.pixel_row.d.next = self.line_row.q.val();
            self.pixel_base.d.next = self.line_base.q.val();
            self.pixel_mirrored.d.next = self.line_mirrored.q.val();
        } else if self.running_now.val() {
            self.running.d.next = !self.span_done.val();
            self.column.d.next = self.next_column.val();
        }

        self.screen_column.next = self.column.q.val();
        if self.pixel_mirrored.q.val() {
            self.screen_column.next = !self.column.q.val();
        }
        self.screen_address.next = unsigned_cast_integer::<A, 11, 0>(self.screen_column.val());
        self.fragment.next = self.running.q.val() && !(self.column.q.val() < self.pixel_near.val());
        self.x.next = unsigned_cast_integer::<11, 11, 0>(self.screen_column.val());
        self.y.next = self.pixel_row.q.val();
        self.address.next = self.pixel_base.q.val() + self.screen_address.val();

        self.load_ready.next = !self.pending.q.val();
        self.load.next = self.loading.val();
        self.step.next = self.stepping.val();
        self.carry.next = self.major.carry.val();
        self.take.next = self.taking.val();
        self.run.next = self.running_now.val();
        self.busy.next = self.pending.q.val() || self.line_active.q.val() || self.running.q.val();
    }
}

crate::clocked!(Shell<A>, const A: usize;
    inputs write, word, data, start, hold, go;
    outputs load_ready, load, step, carry, take, run, fragment, x, y, address, busy);
