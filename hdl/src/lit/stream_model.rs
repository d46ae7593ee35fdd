//! Integer model of the lit stream, clock by clock.

use super::channel::LitChannelModel;
use super::{COLOUR_STAGES, FACTOR_STAGES};
use crate::depth::z_buffer::{ZBufferInputs, ZBufferModel};
use crate::shade::model::CoreOutputs;
use crate::shade::saturate::saturate_model;
use crate::shade::DEPTH_BIAS;

/// A fragment on its way, as the model sees it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Fragment {
    /// There is one.
    pub held: bool,
    /// Ordinal of its span; known to the model only.
    pub ordinal: u64,
    /// Column.
    pub x: u64,
    /// Row.
    pub y: u64,
    /// Frame address.
    pub address: u64,
    /// Depth less 32768, as it is walked.
    pub depth: i64,
}

/// What [`super::stream::LitStream`] sees in one clock.
#[derive(Clone, Copy, Debug, Default)]
pub struct LitStreamInputs {
    /// Clears the depth memory.
    pub clear: bool,
    /// The offered pixel is taken.
    pub ready: bool,
    /// A span is waiting or being drawn.
    pub walking: bool,
    /// What arrives.
    pub fragment: Fragment,
    /// Its material.
    pub material: u64,
    /// Diffuse factor and highlight of the fragment three stages before.
    pub factors: [u64; 2],
    /// A colour that is written.
    pub colour: Option<u64>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Pixel {
    fragment: Fragment,
    rgb: [u8; 3],
    depth: u16,
}

/// Integer model of [`super::stream::LitStream`].
#[derive(Clone, Debug)]
pub struct LitStreamModel {
    stages: [Fragment; COLOUR_STAGES],
    materials: [u64; FACTOR_STAGES - 1],
    channels: [LitChannelModel; 3],
    z_buffer: ZBufferModel,
    drawn: Pixel,
    tested: Pixel,
    out: Pixel,
    out_valid: bool,
    was_busy: bool,
}

impl LitStreamModel {
    /// A stream over a depth memory of `pixels` words.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self {
            stages: Default::default(),
            materials: Default::default(),
            channels: Default::default(),
            z_buffer: ZBufferModel::new(pixels),
            drawn: Pixel::default(),
            tested: Pixel::default(),
            out: Pixel::default(),
            out_valid: false,
            was_busy: false,
        }
    }

    /// Whether the stages move.
    #[must_use]
    pub fn go(&self, ready: bool) -> bool {
        !self.out_valid || ready
    }

    /// Whether a clear is not complete.
    #[must_use]
    pub fn clearing(&self) -> bool {
        self.z_buffer.clearing()
    }

    fn busy(&self, walking: bool) -> bool {
        walking
            || self.stages.iter().any(|s| s.held)
            || self.z_buffer.waiting()
            || self.z_buffer.clearing()
            || self.z_buffer.cleared()
            || self.out_valid
    }

    /// The outputs of the current state, but for `load_ready`.
    #[must_use]
    pub fn outputs(&self, walking: bool) -> CoreOutputs {
        let busy = self.busy(walking);
        CoreOutputs {
            load_ready: false,
            valid: self.out_valid,
            x: self.out.fragment.x as u16,
            y: self.out.fragment.y as u16,
            rgb: self.out.rgb,
            depth: self.out.depth,
            busy,
            done: self.was_busy && !busy,
        }
    }

    /// Ordinal of the span that the offered pixel belongs to.
    #[must_use]
    pub fn ordinal(&self) -> u64 {
        self.out.fragment.ordinal
    }

    /// One clock.
    pub fn clock(&mut self, i: &LitStreamInputs) {
        let busy = self.busy(i.walking);
        let go = self.go(i.ready);
        let last = self.stages[COLOUR_STAGES - 1];
        let materials = self.materials;
        if go {
            self.out_valid = self.z_buffer.pass();
            self.out = Pixel {
                depth: self.z_buffer.depth,
                ..self.tested
            };
            self.tested = self.drawn;
            self.drawn = Pixel {
                fragment: last,
                rgb: [0, 1, 2].map(|c| saturate_model(self.channels[c].value())),
                depth: 0,
            };
            self.stages.rotate_right(1);
            self.stages[0] = i.fragment;
            self.materials = [i.material, materials[0]];
        }
        self.z_buffer.clock(&ZBufferInputs {
            go,
            clear: i.clear && !busy,
            fragment: last.held,
            address: last.address,
            depth: depth_word(last.depth),
        });
        let write = |channel: u64| {
            let data = i.colour?;
            let (material, cell) = (data >> 30 & 3, data >> 26 & 15);
            (cell / 3 == channel).then_some(((cell % 3) as usize, material, data & 0x3_ffff))
        };
        for (channel, model) in (0..).zip(&mut self.channels) {
            model.clock(go, materials[1], i.factors, write(channel));
        }
        self.was_busy = busy;
    }
}

/// The depth word of a walked depth less its bias.
fn depth_word(walked: i64) -> u16 {
    (walked + DEPTH_BIAS) as u16
}
