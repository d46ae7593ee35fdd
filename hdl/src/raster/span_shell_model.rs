//! Integer model of the span shell, clock by clock.

use super::span_shell::{COLUMNS, PLACE, ROW, STYLE};
use crate::format::mask;
use crate::shade::pace::Pace;

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

/// Words of the span after the current one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct SpanWords {
    pixels: u64,
    row: u64,
    column: u64,
    base: u64,
    material: u64,
    shift: u64,
}

/// The current pixel of a span.
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

/// Integer model of [`super::span_shell::SpanShell`] with frame addresses of `address_bits`.
#[derive(Clone, Debug)]
pub struct SpanShellModel {
    address_bits: usize,
    words: SpanWords,
    columns: u64,
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
            words: SpanWords::default(),
            columns: 0,
            pending: false,
            running: false,
            pixel: SpanPlace::default(),
            ordinal: 0,
        }
    }

    /// Whether words may be written while the memory is being cleared, or is not.
    #[must_use]
    pub fn open(&self, hold: bool) -> bool {
        !self.pending || (!self.running && !hold)
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
        let open = self.open(i.hold);
        if take {
            let w = self.words;
            self.pixel = SpanPlace {
                left: w.pixels,
                y: w.row,
                x: w.column,
                address: (w.base + w.column) & mask(self.address_bits),
                material: w.material,
                shift: w.shift,
            };
            self.running = w.pixels != 0;
            self.ordinal += 1;
            self.pending = false;
        } else if run {
            let p = &mut self.pixel;
            self.running = p.left != 1;
            p.left = p.left.wrapping_sub(1) & mask(11);
            p.x = (p.x + 1) & mask(11);
            p.address = (p.address + 1) & mask(self.address_bits);
        }
        self.pending |= i.start && open;
        let w = &mut self.words;
        match i.write.filter(|_| open) {
            Some((PLACE, data)) => {
                w.column = data >> 10 & mask(11);
                w.pixels = data >> 21 & mask(11);
                w.row = (w.row + (data & 1)) & mask(10);
                w.base = (w.base + (data & 1) * self.columns) & mask(self.address_bits);
            }
            Some((ROW, data)) => {
                w.base = data & mask(self.address_bits);
                w.row = data >> 21 & mask(10);
            }
            Some((COLUMNS, data)) => self.columns = data & mask(11),
            Some((STYLE, data)) => {
                w.material = data & 3;
                w.shift = data >> 2 & 7;
            }
            _ => {}
        }
    }
}
