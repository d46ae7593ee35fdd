//! Integer model of the compact unit, clock by clock.

use super::clamp::clamp_model;
use super::CHANNEL_WORDS;
use crate::format::{mask, wrap};

/// What the unit sees in one clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CompactInputs {
    /// Word write.
    pub write: bool,
    /// Channel mask and word number.
    pub select: u8,
    /// Register bus.
    pub data: u32,
    /// The words are complete.
    pub start: bool,
    /// The pixel is taken.
    pub ready: bool,
}

/// What the unit drives after the clock edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CompactOutputs {
    /// Words may be written.
    pub load_ready: bool,
    /// A pixel is offered.
    pub valid: bool,
    /// Its column.
    pub x: u64,
    /// Its row.
    pub y: u64,
    /// Its colour.
    pub rgb: [u8; 3],
    /// A triangle is waiting or being drawn.
    pub busy: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Edge {
    column: i64,
    error: i64,
}

impl Edge {
    /// Adds a word of columns and an error step.
    fn add(&mut self, word: u32) {
        self.column = wrap(self.column + i64::from(word >> 20), 12);
        self.error = wrap(self.error + i64::from(word & 0xf_ffff), 20);
    }

    fn carries(self) -> bool {
        self.error >= 0
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct Channel {
    words: [i64; 16],
    value: i64,
    d_line: i64,
    d_pixel: i64,
    bend: i64,
    total: i64,
    first: i64,
}

/// What the line registers are doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    Stands,
    Loads(usize),
    Steps,
    Finishes,
}

/// The unit with words of `1 + integer + fraction` bits and values of `value_fraction` fraction bits.
#[derive(Clone, Debug)]
pub struct CompactModel {
    integer: usize,
    fraction: usize,
    value_fraction: usize,
    edges: [u32; 16],
    channels: [Channel; 3],
    /// One past the last row of the upper and of the lower minor edge.
    rows: [u64; 2],
    lower: bool,
    mirrored: bool,
    row: u64,
    frame_width: u64,
    pending: bool,
    bank: usize,
    phase: Phase,
    active: bool,
    turn: u64,
    end_row: u64,
    has_lower: bool,
    on_lower: bool,
    switching: bool,
    carried: bool,
    line_row: u64,
    line_mirrored: bool,
    major: Edge,
    minor: Edge,
    running: bool,
    column: i64,
    end: i64,
    pixel_row: u64,
    pixel_mirrored: bool,
}

impl CompactModel {
    /// The unit at power-up.
    #[must_use]
    pub fn new(integer: usize, fraction: usize, value_fraction: usize) -> Self {
        Self {
            integer,
            fraction,
            value_fraction,
            edges: [0; 16],
            channels: [Channel::default(); 3],
            rows: [0; 2],
            lower: false,
            mirrored: false,
            row: 0,
            frame_width: 0,
            pending: false,
            bank: 0,
            phase: Phase::Stands,
            active: false,
            turn: 0,
            end_row: 0,
            has_lower: false,
            on_lower: false,
            switching: false,
            carried: false,
            line_row: 0,
            line_mirrored: false,
            major: Edge::default(),
            minor: Edge::default(),
            running: false,
            column: 0,
            end: 0,
            pixel_row: 0,
            pixel_mirrored: false,
        }
    }

    fn screen(&self) -> u64 {
        let c = if self.pixel_mirrored {
            !self.column
        } else {
            self.column
        };
        c as u64 & mask(12)
    }

    fn fragment(&self) -> bool {
        self.running && self.screen() < self.frame_width
    }

    /// The outputs, which depend on state alone.
    #[must_use]
    pub fn outputs(&self) -> CompactOutputs {
        CompactOutputs {
            load_ready: !self.pending,
            valid: self.fragment(),
            x: self.screen() & mask(11),
            y: self.pixel_row,
            rgb: self
                .channels
                .map(|c| clamp_model(c.total >> self.value_fraction, self.integer)),
            busy: self.pending || self.active || self.phase != Phase::Stands || self.running,
        }
    }

    /// Adds in every channel: to the value, to the difference along the line, along the pixel step.
    fn add(&mut self, pixel_step: bool, value: bool, line: Option<usize>, pixel: Option<usize>) {
        let (width, value_width) = (
            1 + self.integer + self.fraction,
            1 + self.integer + self.value_fraction,
        );
        let drop = self.fraction - self.value_fraction;
        let half = 8 * self.bank;
        for c in &mut self.channels {
            let old = *c;
            if value {
                let step = if pixel_step { old.d_pixel } else { old.d_line };
                c.value = wrap(old.value.wrapping_add(step >> drop), value_width);
            }
            if let Some(w) = line {
                c.d_line = wrap(old.d_line.wrapping_add(old.words[half + w]), width);
            }
            if let Some(w) = pixel {
                c.d_pixel = wrap(old.d_pixel.wrapping_add(old.words[half + w]), width);
            }
        }
    }

    fn load_phase(&mut self, phase: usize, pixel_free: bool) {
        match phase {
            1 => {
                for c in &mut self.channels {
                    (c.value, c.d_line, c.d_pixel) = (0, 0, 0);
                }
                (self.major, self.minor) = (Edge::default(), Edge::default());
                self.line_row = 0;
            }
            2 => {
                self.add(false, false, Some(0), None);
                self.line_row = self.row;
                self.major.add(self.edges[7]);
            }
            3 => {
                self.add(false, true, None, None);
                for c in &mut self.channels {
                    c.d_line = 0;
                }
                self.minor.add(self.edges[15]);
            }
            4 => self.add(false, false, Some(1), None),
            5 => self.add(false, false, None, Some(2)),
            _ if !pixel_free => return,
            _ => {
                let half = 8 * self.bank;
                for c in &mut self.channels {
                    c.bend = c.words[half + 3];
                }
                self.active = true;
                self.line_mirrored = self.mirrored;
                self.pending = false;
                self.phase = Phase::Stands;
                return;
            }
        }
        self.phase = Phase::Loads(phase + 1);
    }

    /// The line registers' clock; whether a span is taken.
    fn line(&mut self, pixel_free: bool, half: usize) -> bool {
        match self.phase {
            Phase::Loads(n) => self.load_phase(n, pixel_free),
            Phase::Steps => {
                self.add(false, false, self.carried.then_some(5), Some(5));
                let step = if self.on_lower { 4 } else { 2 };
                if self.switching {
                    self.minor = Edge::default();
                } else {
                    let word = step + usize::from(self.minor.carries());
                    self.minor.add(self.edges[half + word]);
                }
                let more = self.carried || self.switching;
                self.phase = if more { Phase::Finishes } else { Phase::Stands };
            }
            Phase::Finishes => {
                if self.carried {
                    self.add(true, true, None, Some(3));
                }
                if self.switching {
                    self.minor.add(self.edges[half + 6]);
                    self.on_lower = true;
                }
                self.phase = Phase::Stands;
            }
            Phase::Stands if self.active => {
                let has_pixels = self.major.column < self.minor.column;
                if !pixel_free && has_pixels {
                    return false;
                }
                if has_pixels {
                    self.running = true;
                    (self.column, self.end) = (self.major.column, self.minor.column);
                    (self.pixel_row, self.pixel_mirrored) = (self.line_row, self.line_mirrored);
                    for c in &mut self.channels {
                        (c.total, c.first) = (c.value, c.d_pixel);
                    }
                }
                let next_row = (self.line_row + 1) & mask(11);
                self.switching = next_row == self.turn;
                if self.switching && (self.on_lower || !self.has_lower) {
                    self.switching = false;
                    self.active = false;
                    return has_pixels;
                }
                if self.switching {
                    self.turn = self.end_row;
                }
                self.line_row = next_row;
                self.carried = self.major.carries();
                self.add(false, true, Some(4), None);
                self.major.add(self.edges[half + usize::from(self.carried)]);
                self.phase = Phase::Steps;
                return has_pixels;
            }
            Phase::Stands if self.pending => {
                self.bank ^= 1;
                (self.turn, self.end_row) = (self.rows[0], self.rows[1]);
                self.has_lower = self.lower;
                self.on_lower = false;
                self.phase = Phase::Loads(1);
            }
            Phase::Stands => {}
        }
        false
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &CompactInputs) {
        let go = !self.fragment() || i.ready;
        let write = i.write && !self.pending;
        let start = i.start && !self.pending;
        let next = wrap(self.column + 1, 12);
        let done = next == self.end;
        let pixel_free = !self.running || (go && done);
        let (half, waiting) = (8 * self.bank, 8 * (1 - self.bank));
        let moves = self.running && go;
        // The pixel registers add what they hold before the line registers may replace it.
        let drop = self.fraction - self.value_fraction;
        let width = 1 + self.integer + self.fraction;
        let value_width = 1 + self.integer + self.value_fraction;
        if moves {
            for c in &mut self.channels {
                c.total = wrap(c.total.wrapping_add(c.first >> drop), value_width);
                c.first = wrap(c.first.wrapping_add(c.bend), width);
            }
            self.column = next;
            self.running = !done;
        }
        if !write {
            self.line(pixel_free, half);
        }
        if start {
            self.pending = true;
        }
        if write {
            self.write(i, waiting);
        }
    }

    fn write(&mut self, i: &CompactInputs, waiting: usize) {
        let word = usize::from(i.select & 15);
        let inside = waiting + word % 8;
        let width = 1 + self.integer + self.fraction;
        for (k, c) in self.channels.iter_mut().enumerate() {
            if i.select >> (4 + k) & 1 == 1 {
                c.words[inside] = wrap(i64::from(i.data), width);
            }
        }
        let data = u64::from(i.data);
        if i.select >> 4 != 0 {
            return;
        }
        match word {
            7 | 15 => self.edges[word] = i.data,
            0..=6 => self.edges[inside] = i.data,
            8 => {
                self.rows = [data & mask(11), data >> 11 & mask(11)];
                self.mirrored = data >> 22 & 1 == 1;
                self.lower = data >> 23 & 1 == 1;
            }
            9 => self.row = data & mask(11),
            11 => self.frame_width = data & mask(12),
            _ => {}
        }
    }
}

/// Words of a channel from the ten of [`crate::interpolate::quadratic_2`]: the other four are sums of these.
#[must_use]
pub fn channel_words(quadratic: [u64; 10]) -> [u64; CHANNEL_WORDS] {
    [0, 2, 1, 4, 7, 5].map(|i| quadratic[i])
}
