//! Integer model of the line cores, clock by clock.

use super::box_weight::{self, BoxModel};
use super::cone_stages::ConeStagesModel;
use super::cone_words;
use super::cue::CueModel;
use super::place::place_model;
use super::stream_model::{LinePixel, StreamInputs, StreamModel};
use super::walk_model::{WalkInputs, WalkModel};
use super::weight_rom::WeightModel;
use super::{Filter, TABLE_BITS};
use crate::format::mask;
use crate::shade::model::{CoreInputs, CoreOutputs};
use crate::shade::pace::Pace;

/// Register word of the background.
pub const BACKGROUND: usize = 12;

/// Where weights come from.
#[derive(Clone, Debug)]
enum Weights {
    One,
    Box(BoxModel),
    Cone(ConeStagesModel, WeightModel),
}

/// What follows the walk.
#[derive(Clone, Debug)]
enum Stages {
    /// An output register; with whether a clear is being answered, and busy one clock ago.
    Plain {
        valid: bool,
        out: LinePixel,
        clearing: bool,
        was_busy: bool,
    },
    /// Blending; with the weight of the fragment taken last.
    Blend(Box<StreamModel>, u8),
}

/// State of a line core.
#[derive(Clone, Debug)]
pub struct LineModel {
    address_bits: usize,
    walk: WalkModel,
    colour: [CueModel; 3],
    weights: Weights,
    stages: Stages,
    background: u32,
}

impl LineModel {
    /// A core at power-up with `pixels` words of frame memory.
    #[must_use]
    pub fn new(filter: Filter, address_bits: usize, pixels: usize) -> Self {
        let blend = || Stages::Blend(Box::new(StreamModel::new(address_bits, pixels)), 0);
        let (weights, stages) = match filter {
            Filter::Bresenham => {
                let stages = Stages::Plain {
                    valid: false,
                    out: LinePixel::default(),
                    clearing: false,
                    was_busy: false,
                };
                (Weights::One, stages)
            }
            Filter::Box => (Weights::Box(BoxModel::default()), blend()),
            Filter::Cone => {
                let rom = WeightModel::new(TABLE_BITS);
                (Weights::Cone(ConeStagesModel::default(), rom), blend())
            }
        };
        Self {
            address_bits,
            walk: WalkModel::new(address_bits),
            colour: [CueModel::default(); 3],
            weights,
            stages,
            background: 0,
        }
    }

    fn walking(&self) -> bool {
        self.walk.pending || self.walk.active
    }

    /// The outputs of the current state.
    #[must_use]
    pub fn outputs(&self) -> CoreOutputs {
        let walking = self.walking();
        let (valid, out, weight, busy, was_busy) = match &self.stages {
            Stages::Plain {
                valid,
                out,
                clearing,
                was_busy,
            } => (*valid, out, 255, walking || *valid || *clearing, *was_busy),
            Stages::Blend(s, _) => {
                let busy = s.busy(walking);
                (s.valid, &s.out, s.out.weight, busy, s.was_busy)
            }
        };
        CoreOutputs {
            load_ready: !self.walk.pending,
            valid,
            x: out.x as u16,
            y: out.y as u16,
            rgb: out.rgb,
            depth: u16::from(weight),
            busy,
            done: was_busy && !busy,
        }
    }

    /// Ordinal (from 1, counting starts since power-up) of the line that the offered pixel belongs to.
    #[must_use]
    pub fn ordinal(&self) -> u64 {
        match &self.stages {
            Stages::Plain { out, .. } => out.ordinal,
            Stages::Blend(s, _) => s.out.ordinal,
        }
    }

    fn hold(&self) -> bool {
        match &self.stages {
            Stages::Plain { clearing, .. } => *clearing,
            Stages::Blend(s, _) => s.clearing(),
        }
    }

    /// The pixel that the walk stands on.
    fn pixel(&self) -> (LinePixel, bool) {
        let below = match &self.weights {
            Weights::Cone(stages, _) => stages.below(),
            _ => false,
        };
        let at = &self.walk.at;
        let place = place_model(at, at.lane, below, self.walk.frame, self.address_bits);
        let pixel = LinePixel {
            ordinal: self.walk.ordinal,
            x: place.x,
            y: place.y,
            address: place.address,
            rgb: self.colour.map(|c| c.level()),
            weight: 0,
        };
        (pixel, self.walk.active && place.inside)
    }

    /// Whether the stages behind the walk move, and whether the walk does.
    fn moves(&self, ready: bool) -> (bool, bool) {
        match &self.stages {
            Stages::Plain { valid, .. } => (!valid || ready, !valid || ready),
            Stages::Blend(s, _) => {
                let (pixel, fragment) = self.pixel();
                (s.moving(ready), s.go(ready, fragment, pixel.address))
            }
        }
    }

    /// What a clock with these inputs is spent on.
    #[must_use]
    pub fn pace(&self, i: &CoreInputs) -> Pace {
        let (_, go) = self.moves(i.ready);
        let pixel = Pace::of_pixel(self.walk.active, go);
        pixel.unwrap_or(Pace::of_empty(self.hold(), self.walk.pending))
    }

    /// One clock edge; the outputs after it are those of [`LineModel::outputs`].
    pub fn clock(&mut self, i: &CoreInputs) {
        let (pixel, fragment) = self.pixel();
        let walking = self.walking();
        let (moving, go) = self.moves(i.ready);
        let accept = i.write && !self.walk.pending;
        let word = usize::from(i.select & 15);
        let data = i.data & mask(32);
        let line_write = (accept && i.select >> 4 == 0).then_some((word, data));
        let wi = WalkInputs {
            write: line_write,
            start: i.start,
            hold: self.hold(),
            go,
            whole: false,
        };
        let c = self.walk.controls(&wi);
        let weight = match &self.weights {
            Weights::Cone(_, rom) => rom.weight,
            _ => 0,
        };
        // Behind the walk.
        match &mut self.stages {
            Stages::Plain {
                valid,
                out,
                clearing,
                was_busy,
            } => {
                let busy = walking || *valid || *clearing;
                if moving {
                    *valid = fragment;
                    *out = pixel;
                }
                *clearing = i.clear && !busy;
                *was_busy = busy;
            }
            Stages::Blend(s, held) => {
                let weight = match &self.weights {
                    Weights::Box(_) => *held,
                    _ => weight,
                };
                s.clock(&StreamInputs {
                    clear: i.clear,
                    ready: i.ready,
                    walking,
                    fragment,
                    pixel,
                    weight,
                    background: self.background,
                });
                if let (Weights::Box(b), true) = (&self.weights, moving) {
                    *held = b.weight(self.walk.at.lane != 0);
                }
            }
        }
        // Weights and colours.
        let advance = c.run && c.turn;
        match &mut self.weights {
            Weights::One => {}
            Weights::Box(b) => b.clock(line_write, c.load, advance, c.rises),
            Weights::Cone(stages, rom) => {
                rom.clock(moving.then_some(stages.index()));
                stages.clock(line_write, c, self.walk.at.lane);
            }
        }
        for (channel, cue) in self.colour.iter_mut().enumerate() {
            let write = (accept && i.select >> (4 + channel) & 1 == 1).then_some((word, data));
            cue.clock(write, c.load, advance);
        }
        if let Some((BACKGROUND, data)) = line_write {
            self.background = (data & mask(24)) as u32;
        }
        self.walk.clock(&wi);
    }
}

/// Register words of the walk and the weights, by filter: those of a line, without the frame's.
#[must_use]
pub fn line_words(filter: Filter) -> usize {
    match filter {
        Filter::Bresenham => super::walk::WORDS,
        Filter::Box => box_weight::FIRST_WORD + box_weight::WORDS,
        Filter::Cone => cone_words::FIRST_WORD + cone_words::WORDS,
    }
}
