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
use crate::bump::core_model::BumpModel;
use crate::bump::{self, Bend};
use crate::depth::z_buffer::{ZBufferInputs, ZBufferModel};
use crate::format::mask;
use crate::interpolate::linear_2::{Controls, Linear2Model};
use crate::interpolate::quadratic_2::Quadratic2Model;
use crate::light::model::{cone_word, LightInputs, LightModel, SkipModel};
use crate::light::{Glint, SKIP_WORD};
use crate::line::model::LineModel;
use crate::line::Filter;
use crate::raster::shell::{ShellInputs, ShellModel};
use crate::set_up::core_model::EngineCoreModel;
use crate::texture::model::{colour_in, TextureModel};
use crate::texture::{select, Mapping, Texturing, PERSPECTIVE_BITS};

/// Which interpolant a core has per colour channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// Planes: the Gouraud core.
    Linear,
    /// Quadrics: the quadratic core.
    Quadratic,
    /// Quadrics that the core sets up itself from corners and knots.
    QuadraticEngine,
    /// Quadrics of two cosines, the reflection model per pixel: the quadratic-dots core.
    QuadraticDots,
    /// Planes of two dot products and the quadric of the squared length, a root per pixel: the Duff core.
    Duff,
    /// Quadrics of two or three cosines, highlight and spot per pixel without tables.
    Glint(Glint),
    /// Normals bent by a map, quadrics of light and half-way vector: the bump cores.
    Bump(Bend),
    /// Lines instead of triangles: the line cores.
    Line(Filter),
    /// Spans that the host sets up one by one.
    Span(SpanKind),
    /// Quadrics times a texture: the textured cores.
    Textured(Texturing),
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

/// The stages from cosines to a colour.
#[derive(Clone, Debug)]
enum Stages {
    /// With a power table.
    Table(PhongModel),
    /// Without, and what a triangle does without.
    Glint(LightModel, SkipModel),
}

impl Stages {
    fn levels(&self) -> [i64; 3] {
        match self {
            Self::Table(m) => m.levels(),
            Self::Glint(m, _) => m.levels(),
        }
    }

    /// One clock with N·L, place in the lobe and place in the cone.
    fn clock(&mut self, write: Option<(usize, u64)>, go: bool, [light, place, cone]: [i64; 3]) {
        match self {
            Self::Table(m) => m.clock(write, go, light, place),
            Self::Glint(m, skips) => {
                let (no_highlight, no_diffuse) = skips.outputs();
                let i = LightInputs {
                    light,
                    place,
                    cone,
                    no_highlight,
                    no_diffuse,
                };
                m.clock(write, go, &i);
            }
        }
    }
}

/// What cores have that shade per pixel: stages between the interpolants and the pixel stream, and a fence.
#[derive(Clone, Debug)]
struct Reflection {
    /// What makes the cosines, where they are not interpolated.
    front: Option<DuffModel>,
    colour: Stages,
    delay: DelayModel,
    draining: bool,
}

impl Reflection {
    fn of(order: Order) -> Option<Self> {
        let stages = match order {
            Order::Linear
            | Order::Quadratic
            | Order::QuadraticEngine
            | Order::Line(_)
            | Order::Span(_)
            | Order::Bump(_)
            | Order::Textured(_) => return None,
            Order::QuadraticDots => STAGES,
            Order::Glint(_) => crate::light::STAGES,
            Order::Duff => unit_cosines::STAGES + STAGES,
        };
        Some(Self {
            front: (order == Order::Duff).then(DuffModel::default),
            colour: match order {
                Order::Glint(glint) => {
                    Stages::Glint(LightModel::new(glint == Glint::Spot), SkipModel::default())
                }
                _ => Stages::Table(PhongModel::default()),
            },
            delay: DelayModel::new(stages),
            draining: false,
        })
    }
}

/// Width of the register bus of a core whose interpolants have `fraction_bits`.
#[must_use]
pub fn bus_bits(order: Order, fraction_bits: usize) -> usize {
    let address = match order {
        Order::Textured(t) if t.mapping == Mapping::Perspective => PERSPECTIVE_BITS,
        Order::Textured(t) => {
            let (int, frac) = t.mapping.format(textured_wide(fraction_bits));
            1 + int + frac
        }
        // Samples of the map.
        Order::Bump(_) => 36,
        _ => 0,
    };
    interpolant_bits(order, fraction_bits)
        .into_iter()
        .fold(address.max(32), usize::max)
}

/// Whether a textured core whose colours have `fraction_bits` is the wide one.
fn textured_wide(fraction_bits: usize) -> bool {
    fraction_bits > 20
}

/// Whether a bump core whose vectors have `fraction_bits` below their units is the wide one.
fn bump_wide(fraction_bits: usize) -> bool {
    fraction_bits > 19
}

/// Widths of a core's three interpolants beside depth.
fn interpolant_bits(order: Order, fraction_bits: usize) -> [usize; 3] {
    match order {
        Order::Linear
        | Order::Quadratic
        | Order::QuadraticEngine
        | Order::Line(_)
        | Order::Span(_)
        | Order::Textured(_) => [1 + COLOUR_INTEGER_BITS + fraction_bits; 3],
        Order::Bump(_) => {
            let part = bump::VECTOR_INTEGER_BITS + bump::VECTOR_FRACTION_BITS;
            [1 + part + fraction_bits, 1, 1]
        }
        Order::QuadraticDots => [
            1 + LIGHT_INTEGER_BITS + LIGHT_FRACTION_BITS + fraction_bits,
            1 + PLACE_INTEGER_BITS + PLACE_FRACTION_BITS + fraction_bits,
            // Its words belong to the material.
            1,
        ],
        Order::Glint(glint) => {
            let place = 1 + PLACE_INTEGER_BITS + PLACE_FRACTION_BITS + fraction_bits;
            let light = 1 + LIGHT_INTEGER_BITS + LIGHT_FRACTION_BITS + fraction_bits;
            // The third is that of the spot; without one nothing reads it.
            let cone = if glint == Glint::Spot { place } else { 1 };
            [light, place, cone]
        }
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
    /// The whole of a core with a set-up engine; the fields below then stand still.
    engine: Option<Box<EngineCoreModel>>,
    order: Order,
    fraction_bits: usize,
    bus_bits: usize,
    shell: ShellModel,
    /// Widths of the interpolants.
    widths: [usize; 3],
    colour: [Channel; 3],
    reflection: Option<Reflection>,
    texture: Option<Box<TextureModel>>,
    bump: Option<Box<BumpModel>>,
    depth: Linear2Model,
    z_buffer: ZBufferModel,
    drawn: Pixel,
    tested: Pixel,
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
        let engine = (order == Order::QuadraticEngine).then(|| {
            let bus = bus_bits(order, fraction_bits);
            EngineCoreModel::new(fraction_bits, bus, address_bits, pixels).into()
        });
        let linear = Channel::Linear(Linear2Model::default());
        let channel = match order {
            Order::Linear
            | Order::QuadraticEngine
            | Order::Line(_)
            | Order::Bump(_)
            | Order::Span(_) => linear,
            Order::Quadratic
            | Order::QuadraticDots
            | Order::Duff
            | Order::Textured(_)
            | Order::Glint(_) => Channel::Quadratic(Quadratic2Model::default()),
        };
        Self {
            line,
            span,
            engine,
            order,
            fraction_bits,
            bus_bits: bus_bits(order, fraction_bits),
            shell: ShellModel::new(address_bits),
            widths: interpolant_bits(order, fraction_bits),
            colour: match order {
                Order::Duff => [linear, linear, channel],
                _ => [channel; 3],
            },
            reflection: Reflection::of(order),
            texture: match order {
                Order::Textured(t) => {
                    Some(TextureModel::new(t, textured_wide(fraction_bits)).into())
                }
                _ => None,
            },
            bump: match order {
                Order::Bump(bend) => {
                    let wide = bump_wide(fraction_bits);
                    Some(BumpModel::new(bend, fraction_bits, wide).into())
                }
                _ => None,
            },
            depth: Linear2Model::default(),
            z_buffer: ZBufferModel::new(pixels),
            drawn: Pixel::default(),
            tested: Pixel::default(),
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
            || self.texture.as_ref().is_some_and(|t| t.draining)
            || self.bump.as_ref().is_some_and(|b| b.draining)
    }

    /// A triangle is waiting or being walked, or a pixel has no colour yet.
    fn walking(&self, shell_busy: bool) -> bool {
        shell_busy
            || self.reflection.as_ref().is_some_and(|r| r.delay.busy())
            || self.texture.as_ref().is_some_and(|t| t.delay.busy())
            || self.bump.as_ref().is_some_and(|b| b.delay.busy())
    }

    fn busy(&self, shell_busy: bool) -> bool {
        self.walking(shell_busy)
            || self.z_buffer.waiting()
            || self.z_buffer.clearing()
            || self.z_buffer.cleared()
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
        if let Some(engine) = &self.engine {
            return engine.outputs();
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
        match (&self.line, &self.span, &self.engine) {
            (Some(line), _, _) => line.ordinal(),
            (_, Some(span), _) => span.ordinal(),
            (_, _, Some(engine)) => engine.ordinal(),
            _ => self.out.ordinal,
        }
    }

    /// What a clock with these inputs is spent on.
    #[must_use]
    pub fn pace(&self, i: &CoreInputs) -> Pace {
        match (&self.line, &self.span, &self.engine) {
            (Some(line), _, _) => line.pace(i),
            (_, Some(span), _) => span.pace(i),
            (_, _, Some(engine)) => engine.pace(i),
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
        if let Some(engine) = &mut self.engine {
            return engine.clock(i);
        }
        let si = self.shell_inputs(i);
        let so = self.shell.outputs(&si);
        let busy = self.busy(so.busy);
        let go = si.go;
        let depth_bits = 1 + DEPTH_INTEGER_BITS + DEPTH_FRACTION_BITS;
        let accept = so.load_ready && !self.draining();
        let numbered = self.bump.is_some();
        let textured = numbered || self.texture.is_some();
        let write = |channel: usize| {
            if !textured {
                return i.word_for(1 + channel).filter(|_| accept);
            }
            let chosen = match channel {
                // Bit 7 chooses between the colours and the rest, of which depth is the one without a mask.
                3 => i.select >> 4 == select::DEPTH >> 4,
                // Their words belong to the stages behind the shell.
                _ if numbered => false,
                _ => i.select >> 7 == 0 && i.select >> (4 + channel) & 1 == 1,
            };
            (accept && i.write && chosen).then_some((usize::from(i.select & 15), i.data))
        };
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
            None => match (&mut self.texture, &mut self.bump) {
                (None, None) => (walked, values),
                (None, Some(b)) => {
                    let late = (b.delay.last().unwrap_or(walked), b.levels());
                    let own = (accept && i.write).then_some((i.select, i.data));
                    b.clock(own, go, so.controls, walked);
                    let fence = own.is_some() && usize::from(i.select) == FENCE_WORD;
                    b.draining = fence || (b.draining && walking);
                    late
                }
                (Some(t), _) => {
                    let late = (t.delay.last().unwrap_or(walked), t.levels());
                    let colours = self
                        .colour
                        .map(|c| colour_in(c.value(), self.fraction_bits));
                    let own = (accept && i.write).then_some((i.select, i.data));
                    t.clock(own, go, so.controls, colours, walked);
                    let fence = own.is_some() && usize::from(i.select) == FENCE_WORD;
                    t.draining = fence || (t.draining && walking);
                    late
                }
            },
            Some(r) => {
                let late = (r.delay.last().unwrap_or(walked), r.colour.levels());
                let material = write(2);
                match &mut r.front {
                    None => r.colour.clock(material, go, values),
                    Some(front) => {
                        let [light, place] = front.arguments;
                        r.colour.clock(material, go, [light, place, 0]);
                        let scale = material.filter(|(word, _)| *word == SCALE_WORD);
                        front.clock(scale.map(|(_, data)| data), go, values);
                    }
                }
                if let Stages::Glint(_, skips) = &mut r.colour {
                    let own = write(3).filter(|(word, _)| *word == SKIP_WORD);
                    skips.clock(own.map(|(_, data)| data), so.controls);
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
                ..self.tested
            };
            self.tested = self.drawn;
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
        let glint = self.order == Order::Glint(Glint::Spot);
        for (channel, (model, width)) in self.colour.iter_mut().zip(self.widths).enumerate() {
            let own = match (two_planes, channel) {
                // The words of the cone follow those of the depth.
                (false, 2) if glint => {
                    write(3).and_then(|(word, data)| Some((cone_word(word)?, data)))
                }
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
