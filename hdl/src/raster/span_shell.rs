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
//! follow each other without a bubble. A span of no pixels is taken and dropped.
//!
//! | word | content |
//! |---|---|
//! | 0 | pixels\[31:21\], first column\[20:10\], row\[9:0\] |
//! | 1 | shift\[25:23\], material\[22:21\], address of the first pixel\[20:0\] |
//!
//! Nothing here can overflow in a frame of at most 2040 columns and 1024 rows: columns, rows and counts have 11 bits,
//! a row 10 as it is written, and an address stays below columns · rows.

use crate::format::{bit_cast_u, mask, U};
use crate::shade::pace::Pace;
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Register words of the shell.
pub const WORDS: usize = 2;

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
    /// Next span, address of the first pixel.
    word_address: Register<U<A>>,
    /// Next span, material.
    word_material: Register<U<2>>,
    /// Next span, stretch of the highlight table.
    word_shift: Register<U<3>>,
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
    /// The write is accepted.
    accept: Wire<Bit>,
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
        comment!("equation x = first column + k, address = first address + k, k = 0 to pixels - 1");
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
            word_address,
            word_material,
            word_shift,
            running,
            left,
            row,
            column,
            place,
            span_material,
            span_shift
        );
        self.accept.next = self.write.val() && !self.pending.q.val();
        if self.accept.val() {
            if self.word.val() == 0u64.into() {
                self.word_row.d.next = self.data.val().get_bits::<10>(0);
                self.word_column.d.next = self.data.val().get_bits::<11>(10);
                self.word_pixels.d.next = self.data.val().get_bits::<11>(21);
            }
            if self.word.val() == 1u64.into() {
                self.word_address.d.next = self.data.val().get_bits::<A>(0);
                self.word_material.d.next = self.data.val().get_bits::<2>(21);
                self.word_shift.d.next = self.data.val().get_bits::<3>(23);
            }
        }

        self.span_done.next = self.left.q.val() == 1u64.into();
        self.pixel_free.next = !self.running.q.val() || (self.go.val() && self.span_done.val());
        self.taking.next = self.pending.q.val() && !self.hold.val() && self.pixel_free.val();
        self.running_now.next = self.running.q.val() && self.go.val();

        if self.taking.val() {
            self.pending.d.next = false;
        } else if self.start.val() && !self.pending.q.val() {
            self.pending.d.next = true;
        }

        if self.taking.val() {
            self.running.d.next = self.word_pixels.q.val().any();
            self.left.d.next = self.word_pixels.q.val();
            self.row.d.next = self.word_row.q.val();
            self.column.d.next = self.word_column.q.val();
            self.place.d.next = self.word_address.q.val();
            self.span_material.d.next = self.word_material.q.val();
            self.span_shift.d.next = self.word_shift.q.val();
        } else if self.running_now.val() {
            self.running.d.next = !self.span_done.val();
            self.left.d.next = self.left.q.val() - 1u64.into();
            self.column.d.next = self.column.q.val() + 1u64.into();
            self.place.d.next = self.place.q.val() + 1u64.into();
        }

        self.load_ready.next = !self.pending.q.val();
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

/// What the shell sees in one clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SpanShellInputs {
    /// Register write: word and data.
    pub write: Option<(usize, u64)>,
    /// The register words are complete.
    pub start: bool,
    /// No span may be taken.
    pub hold: bool,
    /// The stages behind the pixel registers move.
    pub go: bool,
}

/// A span in the shell: its words, or the place of the current pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SpanPlace {
    /// Pixels from this one on.
    pub left: u64,
    /// Row.
    pub y: u64,
    /// Column.
    pub x: u64,
    /// Frame address.
    pub address: u64,
    /// Material.
    pub material: u64,
    /// Stretch of the highlight table.
    pub shift: u64,
}

/// Integer model of [`SpanShell`] with frame addresses of `address_bits`.
#[derive(Clone, Debug)]
pub struct SpanShellModel {
    address_bits: usize,
    words: SpanPlace,
    /// The register words hold a complete span.
    pub pending: bool,
    /// The pixel registers stand on a pixel.
    pub running: bool,
    /// The current pixel.
    pub pixel: SpanPlace,
    /// Ordinal of its span since power-up, from 1.
    pub ordinal: u64,
}

impl SpanShellModel {
    /// A shell at power-up.
    #[must_use]
    pub fn new(address_bits: usize) -> Self {
        Self {
            address_bits,
            words: SpanPlace::default(),
            pending: false,
            running: false,
            pixel: SpanPlace::default(),
            ordinal: 0,
        }
    }

    /// Whether a span is taken, and whether the pixel registers move on, in a clock with these inputs.
    #[must_use]
    pub fn controls(&self, i: &SpanShellInputs) -> (bool, bool) {
        let free = !self.running || (i.go && self.pixel.left == 1);
        (self.pending && !i.hold && free, self.running && i.go)
    }

    /// What a clock with these inputs is spent on.
    #[must_use]
    pub fn pace(&self, i: &SpanShellInputs) -> Pace {
        let pixel = Pace::of_pixel(self.running, i.go);
        pixel.unwrap_or(Pace::of_empty(i.hold, self.pending))
    }

    /// A span is waiting or being drawn.
    #[must_use]
    pub fn busy(&self) -> bool {
        self.pending || self.running
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &SpanShellInputs) {
        let (take, run) = self.controls(i);
        let accept = !self.pending;
        if take {
            self.pixel = self.words;
            self.running = self.words.left != 0;
            self.ordinal += 1;
            self.pending = false;
        } else {
            if run {
                let p = &mut self.pixel;
                self.running = p.left != 1;
                p.left = p.left.wrapping_sub(1) & mask(11);
                p.x = (p.x + 1) & mask(11);
                p.address = (p.address + 1) & mask(self.address_bits);
            }
            self.pending |= i.start;
        }
        match i.write.filter(|_| accept) {
            Some((0, data)) => {
                self.words.y = data & mask(10);
                self.words.x = data >> 10 & mask(11);
                self.words.left = data >> 21 & mask(11);
            }
            Some((1, data)) => {
                self.words.address = data & mask(self.address_bits);
                self.words.material = data >> 21 & 3;
                self.words.shift = data >> 23 & 7;
            }
            _ => {}
        }
    }
}
