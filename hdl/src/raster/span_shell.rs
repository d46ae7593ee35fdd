//! The span shell: register words of one span in, fragments and interpolant controls out.
//!
//! Some methods need constants on every span that no two-variate polynomial gives (the amplitude and phase of a great
//! circle, the multiplier of a slerp). Their host walks the edges itself and writes one span at a time:
//!
//! ```text
//!  register words --take--> pixel registers --> fragment (x, y, address, material)
//!  (next span)              (current span)
//! ```
//!
//! The words of the next span may be written while the current one is drawn; when they are complete in time, spans
//! follow each other without a bubble. A span of no pixels is taken and dropped. Complete words that find the pixel
//! registers empty leave in the next clock whatever the consumer does, so in that clock words are accepted again: a host
//! whose words take longer than its pixels writes in every clock.
//!
//! | word | content |
//! |---|---|
//! | 0 | pixels\[31:21\], first column\[20:10\], next row\[0\]: the span lies in the row after that of the words |
//! | 1 | row\[30:21\], address of its column 0\[20:0\] |
//! | 6 | columns of the frame\[10:0\]; write it while the core is idle |
//! | 7 | shift\[4:2\], material\[1:0\] |
//!
//! From row to row of a triangle one word says where a span lies: the row and its address step by themselves.
//!
//! Nothing here can overflow in a frame of at most 2040 columns and 1024 rows: columns and counts have 11 bits, rows 10,
//! and an address stays below columns · rows.

use crate::format::{bit_cast_u, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Word of pixels and first column, and of the step to the next row.
pub const PLACE: usize = 0;
/// Word of a row and its address.
pub const ROW: usize = 1;
/// Word of the frame's columns.
pub const COLUMNS: usize = 6;
/// Word of material and stretch.
pub const STYLE: usize = 7;

/// `A` is the width of a frame address.
#[derive(LogicBlock, Default)]
pub struct SpanShell<const A: usize> {
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
    /// Keeps a new span from being taken (the depth memory is being cleared).
    pub hold: Signal<In, Bit>,
    /// The stages behind the pixel registers move.
    pub go: Signal<In, Bit>,
    /// The register words may be written.
    pub load_ready: Signal<Out, Bit>,
    /// A new span moves to the pixel registers.
    pub take: Signal<Out, Bit>,
    /// The pixel registers move on.
    pub run: Signal<Out, Bit>,
    /// The pixel registers stand on a pixel.
    pub fragment: Signal<Out, Bit>,
    /// Its column.
    pub x: Signal<Out, U<11>>,
    /// Its row.
    pub y: Signal<Out, U<11>>,
    /// Its frame address.
    pub address: Signal<Out, U<A>>,
    /// Its material.
    pub material: Signal<Out, U<2>>,
    /// Binary places that its material's highlight table is stretched by.
    pub shift: Signal<Out, U<3>>,
    /// A span is waiting or being drawn.
    pub busy: Signal<Out, Bit>,
    /// The register words hold a complete span.
    pending: Register<Bit>,
    /// Next span, row.
    word_row: Register<U<10>>,
    /// Next span, first column.
    word_column: Register<U<11>>,
    /// Next span, pixels.
    word_pixels: Register<U<11>>,
    /// Next span, address of its row.
    word_base: Register<U<A>>,
    /// Next span, material.
    word_material: Register<U<2>>,
    /// Next span, stretch of the highlight table.
    word_shift: Register<U<3>>,
    /// Columns of the frame.
    columns: Register<U<11>>,
    /// The pixel registers stand on a pixel.
    running: Register<Bit>,
    /// Pixels from this one on.
    left: Register<U<11>>,
    /// Row of the pixel.
    row: Register<U<10>>,
    /// Column of the pixel.
    column: Register<U<11>>,
    /// Frame address of the pixel.
    place: Register<U<A>>,
    /// Material of the span.
    span_material: Register<U<2>>,
    /// Stretch of the highlight table for the span.
    span_shift: Register<U<3>>,
    /// The register words are free, or leave whatever the consumer does.
    open: Wire<Bit>,
    /// The write is accepted.
    accept: Wire<Bit>,
    /// First column of the next span, as an address.
    word_offset: Wire<U<A>>,
    /// Columns of the frame, as an address.
    row_step: Wire<U<A>>,
    /// This is the last pixel of the span.
    span_done: Wire<Bit>,
    /// The pixel registers can take a span.
    pixel_free: Wire<Bit>,
    /// A span moves to the pixel registers.
    taking: Wire<Bit>,
    /// The pixel registers move on.
    running_now: Wire<Bit>,
}

impl<const A: usize> Logic for SpanShell<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name span_shell");
        comment!("title Register words of one span ahead, and the walk along a span.");
        comment!("equation x = first column + k, address = columns row + x, k = 0 to pixels - 1");
        comment!(
            "source Abbas 2003, section 2.1, one-variate systems; double-buffered and with back pressure."
        );
        comment!(
            "latency Two clocks from start to the first fragment; then one fragment per clock."
        );
        dff_setup!(
            self,
            clock,
            pending,
            word_row,
            word_column,
            word_pixels,
            word_base,
            word_material,
            word_shift,
            columns,
            running,
            left,
            row,
            column,
            place,
            span_material,
            span_shift
        );
        self.open.next = !self.pending.q.val() || (!self.running.q.val() && !self.hold.val());
        self.accept.next = self.write.val() && self.open.val();
        self.row_step.next = bit_cast_u::<A, 11>(self.columns.q.val());
        if self.accept.val() {
            if self.word.val() == 0u64.into() {
                self.word_column.d.next = self.data.val().get_bits::<11>(10);
                self.word_pixels.d.next = self.data.val().get_bits::<11>(21);
                if self.data.val().get_bit(0) {
                    self.word_row.d.next = self.word_row.q.val() + 1u64.into();
                    self.word_base.d.next = self.word_base.q.val() + self.row_step.val();
                }
            }
            if self.word.val() == 1u64.into() {
                self.word_base.d.next = self.data.val().get_bits::<A>(0);
                self.word_row.d.next = self.data.val().get_bits::<10>(21);
            }
            if self.word.val() == 6u64.into() {
                self.columns.d.next = self.data.val().get_bits::<11>(0);
            }
            if self.word.val() == 7u64.into() {
                self.word_material.d.next = self.data.val().get_bits::<2>(0);
                self.word_shift.d.next = self.data.val().get_bits::<3>(2);
            }
        }

        self.span_done.next = self.left.q.val() == 1u64.into();
        self.pixel_free.next = !self.running.q.val() || (self.go.val() && self.span_done.val());
        self.taking.next = self.pending.q.val() && !self.hold.val() && self.pixel_free.val();
        self.running_now.next = self.running.q.val() && self.go.val();
        self.word_offset.next = bit_cast_u::<A, 11>(self.word_column.q.val());

        if self.start.val() && self.open.val() {
            self.pending.d.next = true;
        } else if self.taking.val() {
            self.pending.d.next = false;
        }

        if self.taking.val() {
            self.running.d.next = self.word_pixels.q.val().any();
            self.left.d.next = self.word_pixels.q.val();
            self.row.d.next = self.word_row.q.val();
            self.column.d.next = self.word_column.q.val();
            self.place.d.next = self.word_base.q.val() + self.word_offset.val();
            self.span_material.d.next = self.word_material.q.val();
            self.span_shift.d.next = self.word_shift.q.val();
        } else if self.running_now.val() {
            self.running.d.next = !self.span_done.val();
            self.left.d.next = self.left.q.val() - 1u64.into();
            self.column.d.next = self.column.q.val() + 1u64.into();
            self.place.d.next = self.place.q.val() + 1u64.into();
        }

        self.load_ready.next = self.open.val();
        self.take.next = self.taking.val();
        self.run.next = self.running_now.val();
        self.fragment.next = self.running.q.val();
        self.x.next = self.column.q.val();
        self.y.next = bit_cast_u::<11, 10>(self.row.q.val());
        self.address.next = self.place.q.val();
        self.material.next = self.span_material.q.val();
        self.shift.next = self.span_shift.q.val();
        self.busy.next = self.pending.q.val() || self.running.q.val();
    }
}

crate::clocked!(SpanShell<A>, const A: usize;
    inputs write, word, data, start, hold, go;
    outputs load_ready, take, run, fragment, x, y, address, material, shift, busy);
