//! Vectors: what goes into a core and what must come out, clock by clock, recorded from the integer model.
//!
//! File format (`vectors.txt`): comment lines begin with `#`; every other line is one clock, three hexadecimal words:
//!
//! | word | bits, high to low |
//! |---|---|
//! | inputs before the edge | ready, clear, start, write, select\[7:0\], data\[B-1:0\] |
//! | flags after the edge | done, busy, valid, load_ready |
//! | pixel after the edge | depth\[15:0\], blue\[7:0\], green\[7:0\], red\[7:0\], y\[10:0\], x\[10:0\] |
//!
//! A core that takes several register words per clock has a word more for each further lane, at the end of the line:
//! write, select\[7:0\], data\[B-1:0\].
//!
//! Any simulator that drives the first word and compares the other two replays the run; nothing else is needed.

use crate::spent::Spent;
use crate::stimulus::{Host, Step, Stimulus};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::lanes::Lane;
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs};
use std::fmt::Write;

/// One clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Clock {
    /// Inputs before the edge.
    pub inputs: CoreInputs,
    /// Outputs after it.
    pub outputs: CoreOutputs,
}

/// A pixel that the core handed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// Clock (from 0) whose edge showed it.
    pub clock: usize,
    /// Column.
    pub x: u16,
    /// Row.
    pub y: u16,
    /// Colour.
    pub rgb: [u8; 3],
    /// Depth word.
    pub depth: u16,
    /// Index of its triangle in the list the stimulus was built from.
    pub triangle: usize,
}

/// A recorded run.
#[derive(Clone, Debug)]
pub struct Trace {
    /// The core.
    pub core: Core,
    /// Every clock.
    pub clocks: Vec<Clock>,
    /// Every pixel that was taken, in order.
    pub pixels: Vec<Pixel>,
    /// Clocks from the first register write of a triangle to `done`, both included.
    pub cycles: u64,
    /// What these clocks were spent on.
    pub spent: Spent,
    /// Register writes.
    pub writes: u64,
}

/// Names and widths of the fields of the flags word, low bit first.
pub const FLAGS: [&str; 4] = ["load_ready", "valid", "busy", "done"];
/// Names and widths of the fields of the pixel word, low bits first.
pub const PIXEL: [(&str, u32); 6] = [
    ("x", 11),
    ("y", 11),
    ("red", 8),
    ("green", 8),
    ("blue", 8),
    ("depth", 16),
];

/// The inputs as the first word of a line.
#[must_use]
pub fn pack_inputs(i: &CoreInputs, bus_bits: usize) -> u64 {
    let flags = [i.write, i.start, i.clear, i.ready];
    let data = i.data & ((1 << bus_bits) - 1);
    let select = u64::from(i.select) << bus_bits;
    flags.iter().enumerate().fold(data | select, |w, (k, f)| {
        w | u64::from(*f) << (bus_bits + 8 + k)
    })
}

/// A further lane as a word of a line.
#[must_use]
pub fn pack_lane(lane: &Lane, bus_bits: usize) -> u64 {
    let data = lane.data & ((1 << bus_bits) - 1);
    u64::from(lane.write) << (bus_bits + 8) | u64::from(lane.select) << bus_bits | data
}

/// The outputs as the second and third word of a line.
#[must_use]
pub fn pack_outputs(o: &CoreOutputs) -> (u64, u64) {
    let flags = [o.load_ready, o.valid, o.busy, o.done];
    let flags = flags
        .iter()
        .enumerate()
        .fold(0, |w, (k, f)| w | u64::from(*f) << k);
    let [r, g, b] = o.rgb.map(u64::from);
    let pixel = u64::from(o.x)
        | u64::from(o.y) << 11
        | r << 22
        | g << 30
        | b << 38
        | u64::from(o.depth) << 46;
    (flags, pixel)
}

impl Trace {
    /// Runs the integer model against the host until the frame is done. `ready(clock)` is the consumer's back pressure.
    #[must_use]
    pub fn record(core: Core, stimulus: &Stimulus, mut ready: impl FnMut(u64) -> bool) -> Self {
        let mut model = core.model();
        let mut host = Host::with_lanes(stimulus, core.load_words);
        let mut outputs = model.outputs();
        let mut trace = Self {
            core,
            clocks: vec![],
            pixels: vec![],
            cycles: 0,
            spent: Spent::default(),
            writes: 0,
        };
        let mut spent = Spent::default();
        let mut first = None;
        let mut clock = 0;
        loop {
            let sent = host.sent();
            let Step::Drive(inputs) = host.step(&outputs, ready(clock)) else {
                break;
            };
            if outputs.valid && inputs.ready {
                let triangle = stimulus.primitives[model.ordinal() as usize - 1].triangle;
                let CoreOutputs {
                    x, y, rgb, depth, ..
                } = outputs;
                trace.pixels.push(Pixel {
                    clock: clock as usize - 1,
                    x,
                    y,
                    rgb,
                    depth,
                    triangle,
                });
            }
            let frame_write = clock < stimulus.frame.len() as u64;
            if first.is_none() && !frame_write && (inputs.write || inputs.start) {
                first = Some(clock);
            }
            trace.writes += inputs.writes();
            if first.is_some() {
                spent.count(model.pace(&inputs), outputs.load_ready && !sent);
            }
            model.clock(&inputs);
            outputs = model.outputs();
            trace.clocks.push(Clock { inputs, outputs });
            if outputs.done {
                trace.cycles = clock + 1 - first.unwrap_or(clock);
                trace.spent = spent;
            }
            clock += 1;
        }
        trace
    }

    /// The vector file.
    #[must_use]
    pub fn to_text(&self) -> String {
        let bits = self.core.bus_bits();
        let mut out = format!(
            "# Vectors for the {} core: one clock per line.\n# inputs {{ready, clear, start, write, select[7:0], data[{}:0]}}, \
             flags {{done, busy, valid, load_ready}}, pixel {{depth, blue, green, red, y, x}}{}\n",
            self.core.name(),
            bits - 1,
            (1..self.core.load_words)
                .map(|k| format!(", lane {k} {{write, select, data}}"))
                .collect::<String>()
        );
        for c in &self.clocks {
            let (flags, pixel) = pack_outputs(&c.outputs);
            let _ = write!(
                out,
                "{:x} {flags:x} {pixel:x}",
                pack_inputs(&c.inputs, bits)
            );
            for lane in &c.inputs.more[..self.core.load_words - 1] {
                let _ = write!(out, " {:x}", pack_lane(lane, bits));
            }
            out.push('\n');
        }
        out
    }
}
