//! Integer model of the line cores' pixel stream, clock by clock.

use super::blend::blend_model;
use crate::depth::frame_memory::ColourMemoryModel;
use crate::format::mask;

/// A pixel on its way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LinePixel {
    /// Which line, counted from 1 since power-up; known to the model only.
    pub ordinal: u64,
    /// Column.
    pub x: u64,
    /// Row.
    pub y: u64,
    /// Frame address.
    pub address: u64,
    /// Colour: the line's, then the mixed one.
    pub rgb: [u8; 3],
    /// Weight.
    pub weight: u8,
}

/// What the stream sees in one clock.
#[derive(Clone, Copy, Debug, Default)]
pub struct StreamInputs {
    /// Clears the frame memory.
    pub clear: bool,
    /// The offered pixel is taken.
    pub ready: bool,
    /// A line is waiting or being walked.
    pub walking: bool,
    /// A fragment arrives.
    pub fragment: bool,
    /// Its place and colour, whether it arrives or not.
    pub pixel: LinePixel,
    /// Weight of the fragment that arrived last.
    pub weight: u8,
    /// Colour of an empty frame.
    pub background: u32,
}

/// Integer model of [`super::stream::LineStream`].
#[derive(Clone, Debug)]
pub struct StreamModel {
    address_bits: usize,
    memory: ColourMemoryModel,
    fetched: LinePixel,
    fetched_valid: bool,
    mixed: LinePixel,
    mixed_valid: bool,
    /// A pixel is offered.
    pub valid: bool,
    /// It.
    pub out: LinePixel,
    sweep: Option<u64>,
    /// Busy, one clock ago.
    pub was_busy: bool,
}

fn bytes(word: u32) -> [u8; 3] {
    [16, 8, 0].map(|s| (word >> s) as u8)
}

fn word(rgb: [u8; 3]) -> u32 {
    rgb.iter().fold(0, |w, c| w << 8 | u32::from(*c))
}

impl StreamModel {
    /// An empty stream over a cleared memory of `pixels` words.
    #[must_use]
    pub fn new(address_bits: usize, pixels: usize) -> Self {
        Self {
            address_bits,
            memory: ColourMemoryModel::new(pixels),
            fetched: LinePixel::default(),
            fetched_valid: false,
            mixed: LinePixel::default(),
            mixed_valid: false,
            valid: false,
            out: LinePixel::default(),
            sweep: None,
            was_busy: false,
        }
    }

    /// The stages move.
    #[must_use]
    pub fn moving(&self, ready: bool) -> bool {
        !self.valid || ready
    }

    /// The stages move and this fragment is taken.
    #[must_use]
    pub fn go(&self, ready: bool, fragment: bool, address: u64) -> bool {
        let conflict = fragment
            && (self.fetched_valid && self.fetched.address == address
                || self.mixed_valid && self.mixed.address == address);
        self.moving(ready) && !conflict
    }

    /// The frame memory is being cleared.
    #[must_use]
    pub fn clearing(&self) -> bool {
        self.sweep.is_some()
    }

    /// Anything is waiting, being drawn or being cleared.
    #[must_use]
    pub fn busy(&self, walking: bool) -> bool {
        walking || self.fetched_valid || self.mixed_valid || self.clearing() || self.valid
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &StreamInputs) {
        let busy = self.busy(i.walking);
        let moves = self.moving(i.ready);
        let go = self.go(i.ready, i.fragment, i.pixel.address);
        let old = bytes(self.memory.read_data ^ i.background);
        let write = match self.sweep {
            Some(address) => Some((address, 0)),
            None => (self.mixed_valid && moves)
                .then(|| (self.mixed.address, word(self.mixed.rgb) ^ i.background)),
        };
        self.memory.clock(moves.then_some(i.pixel.address), write);
        if moves {
            self.valid = self.mixed_valid;
            self.out = self.mixed;
            self.mixed_valid = self.fetched_valid && i.weight != 0;
            let new = self.fetched.rgb;
            self.mixed = LinePixel {
                rgb: std::array::from_fn(|c| blend_model(old[c], new[c], i.weight)),
                weight: i.weight,
                ..self.fetched
            };
            self.fetched_valid = i.fragment && go;
            self.fetched = i.pixel;
        }
        self.sweep = match self.sweep {
            Some(a) if a as usize + 1 == self.memory.len() => None,
            Some(a) => Some((a + 1) & mask(self.address_bits)),
            None => (i.clear && !busy).then_some(0),
        };
        self.was_busy = busy;
    }
}
