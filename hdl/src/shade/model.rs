//! Integer model of a whole core, clock by clock: what the description must do, in plain integers.

use super::saturate::saturate_model;
use super::span_core::SpanKind;
use super::span_model::SpanModel;
use super::{COLOUR_INTEGER_BITS, DEPTH_BIAS, DEPTH_FRACTION_BITS, DEPTH_INTEGER_BITS};
use crate::depth::z_buffer::{ZBufferInputs, ZBufferModel};
use crate::format::mask;
use crate::interpolate::linear_2::{Controls, Linear2Model};
use crate::interpolate::quadratic_2::Quadratic2Model;
use crate::raster::shell::{ShellInputs, ShellModel};

/// Which interpolant a core has per colour channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// Planes: the Gouraud core.
    Linear,
    /// Quadrics: the quadratic core.
    Quadratic,
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

/// State of a core.
#[derive(Clone, Debug)]
pub struct CoreModel {
    /// The whole of a span core; the fields below then stand still.
    span: Option<Box<SpanModel>>,
    fraction_bits: usize,
    bus_bits: usize,
    shell: ShellModel,
    colour: [Channel; 3],
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
        let span = match order {
            Order::Span(kind) => Some(SpanModel::new(kind, address_bits, pixels).into()),
            _ => None,
        };
        let channel = match order {
            Order::Span(_) | Order::Linear => Channel::Linear(Linear2Model::default()),
            Order::Quadratic => Channel::Quadratic(Quadratic2Model::default()),
        };
        Self {
            span,
            fraction_bits,
            bus_bits: (1 + COLOUR_INTEGER_BITS + fraction_bits).max(32),
            shell: ShellModel::new(address_bits),
            colour: [channel; 3],
            depth: Linear2Model::default(),
            z_buffer: ZBufferModel::new(address_bits, pixels),
            drawn: Pixel::default(),
            out: Pixel::default(),
            out_valid: false,
            was_busy: false,
        }
    }

    fn shell_inputs(&self, i: &CoreInputs) -> ShellInputs {
        let word = usize::from(i.select & 15);
        let data = i.data & mask(self.bus_bits);
        ShellInputs {
            write: (i.write && i.select >> 4 == 0).then_some((word, data & mask(32))),
            start: i.start,
            hold: self.z_buffer.clearing(),
            go: !self.out_valid || i.ready,
        }
    }

    fn busy(&self, shell_busy: bool) -> bool {
        shell_busy || self.z_buffer.waiting || self.z_buffer.clearing() || self.out_valid
    }

    /// The outputs of the current state.
    #[must_use]
    pub fn outputs(&self) -> CoreOutputs {
        if let Some(span) = &self.span {
            return span.outputs();
        }
        let shell = self.shell.outputs(&ShellInputs::default());
        let busy = self.busy(shell.busy);
        CoreOutputs {
            load_ready: shell.load_ready,
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
        match &self.span {
            Some(span) => span.ordinal(),
            None => self.out.ordinal,
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
        if let Some(span) = &mut self.span {
            return span.clock(i);
        }
        let si = self.shell_inputs(i);
        let so = self.shell.outputs(&si);
        let busy = self.busy(so.busy);
        let go = si.go;
        let colour_bits = 1 + COLOUR_INTEGER_BITS + self.fraction_bits;
        let depth_bits = 1 + DEPTH_INTEGER_BITS + DEPTH_FRACTION_BITS;
        // The stages behind the pixel registers, last one first.
        let fragment_depth = ((self.depth.value() >> DEPTH_FRACTION_BITS) + DEPTH_BIAS) as u16;
        if go {
            self.out_valid = self.z_buffer.pass();
            self.out = Pixel {
                depth: self.z_buffer.depth,
                ..self.drawn
            };
            let rgb = self
                .colour
                .map(|c| saturate_model(c.value() >> self.fraction_bits));
            self.drawn = Pixel {
                ordinal: so.ordinal,
                x: so.x,
                y: so.y,
                rgb,
                depth: 0,
            };
        }
        self.z_buffer.clock(&ZBufferInputs {
            go,
            clear: i.clear && !busy,
            fragment: so.fragment,
            address: so.address,
            depth: fragment_depth,
        });
        // Interpolants.
        let accept = i.write && so.load_ready;
        let word = usize::from(i.select & 15);
        let write = |channel: usize| {
            (accept && i.select >> (4 + channel) & 1 == 1).then_some((word, i.data))
        };
        for (channel, model) in self.colour.iter_mut().enumerate() {
            model.clock(colour_bits, write(channel), so.controls);
        }
        self.depth.clock(depth_bits, write(3), so.controls);
        self.shell.clock(&si);
        self.was_busy = busy;
    }
}
