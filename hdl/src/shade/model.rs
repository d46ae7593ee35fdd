//! Integer model of a whole core, clock by clock: what the description must do, in plain integers.

use super::lanes::{Lane, MAX_LANES};
use super::pace::Pace;
use super::phong::model::{DelayModel, Fragment, PhongModel};
use super::phong::power::{PLACE_FRACTION_BITS, PLACE_INTEGER_BITS};
use super::phong::root_model::DuffModel;
use super::phong::unit_cosines::{self, SCALE_WORD};
use super::phong::{FENCE_WORD, LIGHT_FRACTION_BITS, LIGHT_INTEGER_BITS, STAGES};
use super::saturate::saturate_model;
use super::span_core::SpanKind;
use super::span_model::SpanModel;
use super::{COLOUR_INTEGER_BITS, DEPTH_BIAS, DEPTH_FRACTION_BITS, DEPTH_INTEGER_BITS};
use crate::depth::z_buffer::{ZBufferInputs, ZBufferModel};
use crate::format::mask;
use crate::interpolate::linear_2::{Controls, Linear2Model};
use crate::interpolate::quadratic_2::Quadratic2Model;
use crate::line::model::LineModel;
use crate::line::Filter;
use crate::raster::shell::{ShellInputs, ShellModel};

/// Which interpolant a core has per colour channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// Planes: the Gouraud core.
    Linear,
    /// Quadrics: the quadratic core.
    Quadratic,
    /// Quadrics of two cosines, the reflection model per pixel: the quadratic-dots core.
    QuadraticDots,
    /// Planes of two dot products and the quadric of the squared length, a root per pixel: the Duff core.
    Duff,
    /// Lines instead of triangles: the line cores.
    Line(Filter),
    /// Spans that the host sets up one by one.
    Span(SpanKind),
}

/// What a core sees in one clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CoreInputs {
    /// Register write strobe.
    pub write: bool,
    /// Channel mask and word number.
    pub select: u8,
    /// Register bus.
    pub data: u64,
    /// The register words are complete.
    pub start: bool,
    /// Clears the depth memory.
    pub clear: bool,
    /// The pixel is taken.
    pub ready: bool,
    /// The further lanes of a core that takes several words per clock; idle in the others.
    pub more: [Lane; MAX_LANES - 1],
}

impl CoreInputs {
    /// The word for a target of the registers, 0 the shell, 1 to 4 the bits of the mask: that of the lowest lane.
    #[must_use]
    #[inline]
    pub fn word_for(&self, target: usize) -> Option<(usize, u64)> {
        let first = Lane {
            write: self.write,
            select: self.select,
            data: self.data,
        };
        let mut lanes = std::iter::once(&first).chain(&self.more);
        let lane = lanes.find(|l| l.writes_to(target))?;
        Some((usize::from(lane.select & 15), lane.data))
    }

    /// Register writes in this clock.
    #[must_use]
    pub fn writes(&self) -> u64 {
        u64::from(self.write) + self.more.iter().map(|l| u64::from(l.write)).sum::<u64>()
    }
}

/// What a core drives, after the clock edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CoreOutputs {
    /// Register words may be written.
    pub load_ready: bool,
    /// A visible pixel is offered.
    pub valid: bool,
    /// Its column.
    pub x: u16,
    /// Its row.
    pub y: u16,
    /// Its colour: red, green, blue.
    pub rgb: [u8; 3],
    /// Its depth.
    pub depth: u16,
    /// Anything is waiting, being drawn or being cleared.
    pub busy: bool,
    /// Pulses when `busy` falls.
    pub done: bool,
}

#[derive(Clone, Copy, Debug)]
enum Channel {
    Linear(Linear2Model),
    Quadratic(Quadratic2Model),
}

impl Channel {
    fn value(&self) -> i64 {
        match self {
            Self::Linear(m) => m.value(),
            Self::Quadratic(m) => m.value(),
        }
    }

    fn clock(&mut self, width: usize, write: Option<(usize, u64)>, c: Controls) {
        match self {
            Self::Linear(m) => m.clock(width, write, c),
            Self::Quadratic(m) => m.clock(width, write, c),
        }
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct Pixel {
    ordinal: u64,
    x: u64,
    y: u64,
    rgb: [u8; 3],
    depth: u16,
}

/// What cores have that shade per pixel: stages between the interpolants and the pixel stream, and a fence.
#[derive(Clone, Debug)]
struct Reflection {
    /// What makes the cosines, where they are not interpolated.
    front: Option<DuffModel>,
    colour: PhongModel,
    delay: DelayModel,
    draining: bool,
}

impl Reflection {
    fn of(order: Order) -> Option<Self> {
        let stages = match order {
            Order::Linear | Order::Quadratic | Order::Line(_) | Order::Span(_) => return None,
            Order::QuadraticDots => STAGES,
            Order::Duff => unit_cosines::STAGES + STAGES,
        };
        Some(Self {
            front: (order == Order::Duff).then(DuffModel::default),
            colour: PhongModel::default(),
            delay: DelayModel::new(stages),
            draining: false,
        })
    }
}

/// Width of the register bus of a core whose interpolants have `fraction_bits`.
#[must_use]
pub fn bus_bits(order: Order, fraction_bits: usize) -> usize {
    interpolant_bits(order, fraction_bits)
        .into_iter()
        .fold(32, usize::max)
}

/// Widths of a core's three interpolants beside depth.
fn interpolant_bits(order: Order, fraction_bits: usize) -> [usize; 3] {
    match order {
        Order::Linear | Order::Quadratic | Order::Line(_) | Order::Span(_) => {
            [1 + COLOUR_INTEGER_BITS + fraction_bits; 3]
        }
        Order::QuadraticDots => [
            1 + LIGHT_INTEGER_BITS + LIGHT_FRACTION_BITS + fraction_bits,
            1 + PLACE_INTEGER_BITS + PLACE_FRACTION_BITS + fraction_bits,
            // Its words belong to the material.
            1,
        ],
        Order::Duff => {
            let units = 1 + unit_cosines::INTEGER_BITS + unit_cosines::FRACTION_BITS;
            [units + fraction_bits; 3]
        }
    }
}

/// State of a core.
#[derive(Clone, Debug)]
pub struct CoreModel {
    /// The whole of a line core; the fields below then stand still.
    line: Option<Box<LineModel>>,
    /// The whole of a span core; the fields below then stand still.
    span: Option<Box<SpanModel>>,
    fraction_bits: usize,
    bus_bits: usize,
    shell: ShellModel,
    /// Widths of the interpolants.
    widths: [usize; 3],
    colour: [Channel; 3],
    reflection: Option<Reflection>,
    depth: Linear2Model,
    z_buffer: ZBufferModel,
    drawn: Pixel,
    out: Pixel,
    out_valid: bool,
    was_busy: bool,
}

impl CoreModel {
    /// A core at power-up; colours have `fraction_bits`, frame addresses `address_bits`, the depth memory `pixels` words.
    #[must_use]
    pub fn new(order: Order, fraction_bits: usize, address_bits: usize, pixels: usize) -> Self {
        let line = match order {
            Order::Line(filter) => Some(LineModel::new(filter, address_bits, pixels).into()),
            _ => None,
        };
        let span = match order {
            Order::Span(kind) => Some(SpanModel::new(kind, address_bits, pixels).into()),
            _ => None,
        };
        let linear = Channel::Linear(Linear2Model::default());
        let channel = match order {
            Order::Linear | Order::Line(_) | Order::Span(_) => linear,
            Order::Quadratic | Order::QuadraticDots | Order::Duff => {
                Channel::Quadratic(Quadratic2Model::default())
            }
        };
        Self {
            line,
            span,
            fraction_bits,
            bus_bits: bus_bits(order, fraction_bits),
            shell: ShellModel::new(address_bits),
            widths: interpolant_bits(order, fraction_bits),
            colour: match order {
                Order::Duff => [linear, linear, channel],
                _ => [channel; 3],
            },
            reflection: Reflection::of(order),
            depth: Linear2Model::default(),
            z_buffer: ZBufferModel::new(address_bits, pixels),
            drawn: Pixel::default(),
            out: Pixel::default(),
            out_valid: false,
            was_busy: false,
        }
    }

    fn shell_inputs(&self, i: &CoreInputs) -> ShellInputs {
        let write = i.word_for(0).filter(|_| !self.draining());
        ShellInputs {
            write: write.map(|(word, data)| (word, data & mask(self.bus_bits.min(32)))),
            start: i.start && !self.draining(),
            hold: self.z_buffer.clearing(),
            go: !self.out_valid || i.ready,
        }
    }

    fn draining(&self) -> bool {
        self.reflection.as_ref().is_some_and(|r| r.draining)
    }

    /// A triangle is waiting or being walked, or a pixel has no colour yet.
    fn walking(&self, shell_busy: bool) -> bool {
        shell_busy || self.reflection.as_ref().is_some_and(|r| r.delay.busy())
    }

    fn busy(&self, shell_busy: bool) -> bool {
        self.walking(shell_busy)
            || self.z_buffer.waiting
            || self.z_buffer.clearing()
            || self.out_valid
    }

    /// The outputs of the current state.
    #[must_use]
    pub fn outputs(&self) -> CoreOutputs {
        if let Some(line) = &self.line {
            return line.outputs();
        }
        if let Some(span) = &self.span {
            return span.outputs();
        }
        let shell = self.shell.outputs(&ShellInputs::default());
        let busy = self.busy(shell.busy);
        CoreOutputs {
            load_ready: shell.load_ready && !self.draining(),
            valid: self.out_valid,
            x: self.out.x as u16,
            y: self.out.y as u16,
            rgb: self.out.rgb,
            depth: self.out.depth,
            busy,
            done: self.was_busy && !busy,
        }
    }

    /// Ordinal (from 1, counting starts since power-up) of the triangle that the offered pixel belongs to.
    #[must_use]
    pub fn ordinal(&self) -> u64 {
        match (&self.line, &self.span) {
            (Some(line), _) => line.ordinal(),
            (_, Some(span)) => span.ordinal(),
            _ => self.out.ordinal,
        }
    }

    /// What a clock with these inputs is spent on.
    #[must_use]
    pub fn pace(&self, i: &CoreInputs) -> Pace {
        match (&self.line, &self.span) {
            (Some(line), _) => line.pace(i),
            (_, Some(span)) => span.pace(i),
            _ => self.shell.pace(&self.shell_inputs(i)),
        }
    }

    /// The accumulators of the pixel registers: red, green, blue, depth codes.
    #[must_use]
    pub fn accumulators(&self) -> [i64; 4] {
        let [r, g, b] = self.colour.map(|c| c.value());
        [r, g, b, self.depth.value()]
    }

    /// One clock edge; the outputs after it are those of [`CoreModel::outputs`].
    pub fn clock(&mut self, i: &CoreInputs) {
        if let Some(line) = &mut self.line {
            return line.clock(i);
        }
        if let Some(span) = &mut self.span {
            return span.clock(i);
        }
        let si = self.shell_inputs(i);
        let so = self.shell.outputs(&si);
        let busy = self.busy(so.busy);
        let go = si.go;
        let depth_bits = 1 + DEPTH_INTEGER_BITS + DEPTH_FRACTION_BITS;
        let accept = so.load_ready && !self.draining();
        let write = |channel: usize| i.word_for(1 + channel).filter(|_| accept);
        let walked = Fragment {
            valid: so.fragment,
            ordinal: so.ordinal,
            x: so.x,
            y: so.y,
            address: so.address,
            depth: ((self.depth.value() >> DEPTH_FRACTION_BITS) + DEPTH_BIAS) as u16,
        };
        let values = self.colour.map(|c| c.value() >> self.fraction_bits);
        let walking = self.walking(so.busy);
        let (arrived, levels) = match &mut self.reflection {
            None => (walked, values),
            Some(r) => {
                let late = (r.delay.last().unwrap_or(walked), r.colour.levels());
                let material = write(2);
                match &mut r.front {
                    None => r.colour.clock(material, go, values[0], values[1]),
                    Some(front) => {
                        let [light, place] = front.arguments;
                        r.colour.clock(material, go, light, place);
                        let scale = material.filter(|(word, _)| *word == SCALE_WORD);
                        front.clock(scale.map(|(_, data)| data), go, values);
                    }
                }
                if go {
                    r.delay.shift(walked);
                }
                let fence = accept && i.word_for(0).is_some_and(|(word, _)| word == FENCE_WORD);
                r.draining = fence || (r.draining && walking);
                late
            }
        };
        // The stages of the pixel stream, last one first.
        if go {
            self.out_valid = self.z_buffer.pass();
            self.out = Pixel {
                depth: self.z_buffer.depth,
                ..self.drawn
            };
            self.drawn = Pixel {
                ordinal: arrived.ordinal,
                x: arrived.x,
                y: arrived.y,
                rgb: levels.map(saturate_model),
                depth: 0,
            };
        }
        self.z_buffer.clock(&ZBufferInputs {
            go,
            clear: i.clear && !busy,
            fragment: arrived.valid,
            address: arrived.address,
            depth: arrived.depth,
        });
        // Interpolants.
        let two_planes = self.reflection.as_ref().is_some_and(|r| r.front.is_some());
        for (channel, (model, width)) in self.colour.iter_mut().zip(self.widths).enumerate() {
            let own = match (two_planes, channel) {
                (false, _) => write(channel),
                // Words 0 to 3 of the first mask bit, then words 4 to 7.
                (true, 0 | 1) => write(0)
                    .filter(|(word, _)| word >> 2 & 1 == channel)
                    .map(|(word, data)| (word & 3, data)),
                (true, _) => write(1),
            };
            model.clock(width, own, so.controls);
        }
        self.depth.clock(depth_bits, write(3), so.controls);
        self.shell.clock(&si);
        self.was_busy = busy;
    }
}
