//! Integer model of the raster shell, clock by clock.

use super::edge_walk::EdgeModel;
use super::shell::{FRAME_WIDTH, WORDS};
use crate::format::{mask, wrap};
use crate::interpolate::linear_2::Controls;
use crate::shade::pace::Pace;

/// What the shell sees in one clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ShellInputs {
    /// Register write: word and data.
    pub write: Option<(usize, u64)>,
    /// The register words are complete.
    pub start: bool,
    /// No triangle may be loaded.
    pub hold: bool,
    /// The stages behind the pixel registers move.
    pub go: bool,
}

/// What the shell drives in one clock, before the edge; all depend on its state, some also on `go` and `hold`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ShellOutputs {
    /// The register words may be written.
    pub load_ready: bool,
    /// Controls of the interpolants.
    pub controls: Controls,
    /// The pixel registers stand on a pixel of the frame.
    pub fragment: bool,
    /// Its column.
    pub x: u64,
    /// Its row.
    pub y: u64,
    /// Its frame address.
    pub address: u64,
    /// A triangle is waiting or being walked.
    pub busy: bool,
    /// Ordinal of the pixel's triangle since power-up, from 1; known to the model only.
    pub ordinal: u64,
}

/// State of the shell with frame addresses of `address_bits`.
#[derive(Clone, Debug)]
pub struct ShellModel {
    address_bits: usize,
    words: [u64; WORDS],
    frame_width: i64,
    pending: bool,
    line: Option<Line>,
    stale_line: Line,
    pixel: Pixel,
    running: bool,
    loads: u64,
}

#[derive(Clone, Copy, Debug, Default)]
struct Line {
    ordinal: u64,
    rows_left: u64,
    upper_left: u64,
    row: u64,
    base: u64,
    mirrored: bool,
    major: EdgeModel,
    minor: EdgeModel,
    lower: EdgeModel,
}

#[derive(Clone, Copy, Debug, Default)]
struct Pixel {
    ordinal: u64,
    column: i64,
    end: i64,
    row: u64,
    base: u64,
    mirrored: bool,
}

/// What the state and `go`, `hold` decide for one clock.
struct Decisions {
    taking: bool,
    advance: bool,
    loading: bool,
    stepping: bool,
    span_done: bool,
}

impl ShellModel {
    /// A shell at power-up.
    #[must_use]
    pub fn new(address_bits: usize) -> Self {
        Self {
            address_bits,
            words: [0; WORDS],
            frame_width: 0,
            pending: false,
            line: None,
            stale_line: Line::default(),
            pixel: Pixel::default(),
            running: false,
            loads: 0,
        }
    }

    /// First and one-past-last walk column of the frame.
    fn limits(&self, mirrored: bool) -> (i64, i64) {
        if mirrored {
            (wrap(-self.frame_width, 12), 0)
        } else {
            (0, self.frame_width)
        }
    }

    fn decide(&self, i: &ShellInputs) -> Decisions {
        let next = wrap(self.pixel.column + 1, 12);
        let span_done = next == self.pixel.end || next == self.limits(self.pixel.mirrored).1;
        let pixel_free = !self.running || (i.go && span_done);
        let (taking, advance, last_row) = match &self.line {
            None => (false, false, false),
            Some(l) => {
                let (near, far) = self.limits(l.mirrored);
                let (from, to) = (l.major.column, l.minor.column);
                let has_pixels = from < to && from < far && near < to;
                let taking = has_pixels && pixel_free;
                (taking, taking || !has_pixels, l.rows_left == 1)
            }
        };
        let loading = self.pending && !i.hold && (self.line.is_none() || (advance && last_row));
        Decisions {
            taking,
            advance,
            loading,
            stepping: advance && !last_row,
            span_done,
        }
    }

    /// The outputs for these inputs, before the clock edge.
    #[must_use]
    pub fn outputs(&self, i: &ShellInputs) -> ShellOutputs {
        let d = self.decide(i);
        let p = &self.pixel;
        let screen = if p.mirrored { !p.column } else { p.column };
        let line = self.line.as_ref().unwrap_or(&self.stale_line);
        ShellOutputs {
            load_ready: !self.pending,
            controls: Controls {
                load: d.loading,
                step: d.stepping,
                carry: line.major.carry(),
                take: d.taking,
                run: self.running && i.go,
            },
            fragment: self.running && p.column >= self.limits(p.mirrored).0,
            x: screen as u64 & mask(11),
            y: p.row,
            address: (p.base.wrapping_add(screen as u64)) & mask(self.address_bits),
            busy: self.pending || self.line.is_some() || self.running,
            ordinal: p.ordinal,
        }
    }

    /// What a clock with these inputs is spent on.
    #[must_use]
    pub fn pace(&self, i: &ShellInputs) -> Pace {
        let d = self.decide(i);
        let empty_row = d.advance && !d.taking;
        Pace::of_pixel(self.running, i.go).unwrap_or(match &self.line {
            Some(_) if empty_row => Pace::EmptyRow,
            Some(_) => Pace::Moving,
            None => Pace::of_empty(i.hold, self.pending),
        })
    }

    fn load_line(&self) -> Line {
        let w = &self.words;
        let edge = |i: usize| EdgeModel::from_words(w[i], w[i + 1], w[i + 2]);
        Line {
            ordinal: self.loads + 1,
            rows_left: w[0] & mask(11),
            upper_left: w[0] >> 11 & mask(11),
            mirrored: w[0] >> 22 & 1 == 1,
            row: w[1] & mask(11),
            base: w[1] >> 11 & mask(self.address_bits),
            major: edge(2),
            minor: edge(5),
            lower: edge(8),
        }
    }

    fn step_line(&self, l: &Line) -> Line {
        let mut next = *l;
        let switch = l.upper_left == 1;
        next.rows_left = l.rows_left.wrapping_sub(1) & mask(11);
        next.upper_left = l.upper_left.wrapping_sub(1) & mask(11);
        next.row = (l.row + 1) & mask(11);
        next.base = (l.base.wrapping_add(self.frame_width as u64)) & mask(self.address_bits);
        next.major.clock(None, true);
        next.minor.clock(switch.then_some(l.lower), true);
        next
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &ShellInputs) {
        let d = self.decide(i);
        // Pixel registers.
        if d.taking {
            let l = self
                .line
                .as_ref()
                .expect("a span is only taken from a line");
            self.pixel = Pixel {
                ordinal: l.ordinal,
                column: l.major.column,
                end: l.minor.column,
                row: l.row,
                base: l.base,
                mirrored: l.mirrored,
            };
            self.running = true;
        } else if self.running && i.go {
            self.running = !d.span_done;
            self.pixel.column = wrap(self.pixel.column + 1, 12);
        }
        // Line registers.
        if d.loading {
            let l = self.load_line();
            self.loads += 1;
            self.stale_line = l;
            self.line = (l.rows_left != 0).then_some(l);
        } else if d.stepping {
            let next = self.step_line(self.line.as_ref().expect("only a line steps"));
            self.stale_line = next;
            self.line = Some(next);
        } else if d.advance {
            self.line = None;
        }
        // Register words.
        let accept = !self.pending;
        if d.loading {
            self.pending = false;
        } else if i.start && accept {
            self.pending = true;
        }
        if let Some((word, data)) = i.write.filter(|_| accept) {
            if word < WORDS {
                self.words[word] = data & mask(32);
            } else if word == FRAME_WIDTH {
                self.frame_width = wrap(data as i64, 12);
            }
        }
    }
}
