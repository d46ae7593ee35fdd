//! Integer model of the walk along a line, clock by clock.

use super::walk::{FRAME_SIZE, WORDS};
use crate::format::{mask, wrap};

/// What the walk sees in one clock.
#[derive(Clone, Copy, Debug, Default)]
pub struct WalkInputs {
    /// Register write: word and data.
    pub write: Option<(usize, u64)>,
    /// The register words are complete.
    pub start: bool,
    /// No line may be loaded.
    pub hold: bool,
    /// The pixel is taken.
    pub go: bool,
    /// A column is taken at once.
    pub whole: bool,
}

/// What the units beside the walk obey in one clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WalkControls {
    /// A new line moves to the registers.
    pub load: bool,
    /// The next lane or column follows.
    pub run: bool,
    /// What follows is the next column.
    pub turn: bool,
    /// The minor coordinate moves with it.
    pub rises: bool,
}

/// Where the walk stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WalkPosition {
    /// Columns that follow.
    pub columns_left: u64,
    /// The major axis is y.
    pub steep: bool,
    /// The minor coordinate falls.
    pub falling: bool,
    /// Last lane.
    pub last_lane: u64,
    /// Lane.
    pub lane: u64,
    /// Major coordinate.
    pub major: i64,
    /// Minor coordinate of lane 0.
    pub minor: i64,
    /// Frame address of lane 0.
    pub address: u64,
    /// Error term, stay, step.
    pub error: [i64; 3],
}

/// Integer model of [`super::walk::LineWalk`].
#[derive(Clone, Debug)]
pub struct WalkModel {
    address_bits: usize,
    words: [u64; WORDS],
    /// Columns and rows of the frame.
    pub frame: [i64; 2],
    /// The register words hold a complete line.
    pub pending: bool,
    /// The walk stands on a pixel.
    pub active: bool,
    /// Where.
    pub at: WalkPosition,
    /// Lines loaded since power-up; known to the model only.
    pub ordinal: u64,
}

impl WalkModel {
    /// A walk at power-up.
    #[must_use]
    pub fn new(address_bits: usize) -> Self {
        Self {
            address_bits,
            words: [0; WORDS],
            frame: [0; 2],
            pending: false,
            active: false,
            at: WalkPosition::default(),
            ordinal: 0,
        }
    }

    /// What happens in this clock.
    #[must_use]
    pub fn controls(&self, i: &WalkInputs) -> WalkControls {
        let run = self.active && i.go;
        let turn = i.whole || self.at.lane == self.at.last_lane;
        let done = run && turn && self.at.columns_left == 0;
        WalkControls {
            load: self.pending && !i.hold && (!self.active || done),
            run,
            turn,
            rises: self.at.error[0] > 0,
        }
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &WalkInputs) {
        let c = self.controls(i);
        let accept = !self.pending;
        if c.load {
            self.pending = false;
            self.active = true;
            self.ordinal += 1;
            self.at = self.first();
        } else if c.run {
            if !c.turn {
                self.at.lane = (self.at.lane + 1) & 3;
            } else if self.at.columns_left == 0 {
                self.active = false;
            } else {
                self.next_column(c.rises);
            }
        }
        if !c.load && i.start && accept {
            self.pending = true;
        }
        if let Some((word, data)) = i.write.filter(|_| accept) {
            if word < WORDS {
                self.words[word] = data & mask(32);
            } else if word == FRAME_SIZE {
                self.frame = [wrap(data as i64, 12), wrap((data >> 12) as i64, 12)];
            }
        }
    }

    fn first(&self) -> WalkPosition {
        let w = &self.words;
        WalkPosition {
            columns_left: w[0] & mask(11),
            steep: w[0] >> 11 & 1 == 1,
            falling: w[0] >> 12 & 1 == 1,
            last_lane: w[0] >> 13 & 3,
            lane: 0,
            major: wrap(w[1] as i64, 12),
            minor: wrap((w[1] >> 12) as i64, 12),
            address: w[2] & mask(self.address_bits),
            error: [w[3], w[4], w[5]].map(|v| wrap(v as i64, 14)),
        }
    }

    fn next_column(&mut self, rises: bool) {
        let row = self.frame[0] as u64;
        let p = &mut self.at;
        let [major, minor] = if p.steep { [row, 1] } else { [1, row] };
        let [error, stay, step] = p.error;
        p.columns_left -= 1;
        p.lane = 0;
        p.major = wrap(p.major + 1, 12);
        p.address = p.address.wrapping_add(major);
        if rises {
            p.minor = wrap(p.minor + if p.falling { -1 } else { 1 }, 12);
            p.address = if p.falling {
                p.address.wrapping_sub(minor)
            } else {
                p.address.wrapping_add(minor)
            };
        }
        p.address &= mask(self.address_bits);
        p.error[0] = wrap(error + if rises { step } else { stay }, 14);
    }
}
