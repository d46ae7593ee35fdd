//! What cores were measured to take of a device, and what follows from the frame alone.
//!
//! The figures are those of the README's table, made by `scripts/resources`; a configuration that is not here was not
//! measured, and nothing is guessed for it.

use super::line;
use serde::Serialize;
use shadegate_constraints::Device;
use shadegate_hdl::bump::Bend;
use shadegate_hdl::light::Glint;
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_hdl::texture::Mapping;

/// Synthesiser and what it counted.
pub const TOOL: &str = "Yosys 0.23, synth_xilinx, cells before placement";

/// Cells of one core on one family.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Measured {
    /// Family, as devices name it.
    pub family: &'static str,
    /// Look-up tables of any size, and inverters.
    pub lut: u32,
    /// Flip-flops.
    pub ff: u32,
    /// Block RAMs.
    pub bram: u32,
    /// Multipliers.
    pub dsp: u32,
}

/// Frame of the measured cores.
const FRAME: (u32, u32) = (320, 240);

const fn row(family: &'static str, lut: u32, ff: u32, bram: u32) -> Measured {
    let dsp = 0;
    Measured {
        family,
        lut,
        ff,
        bram,
        dsp,
    }
}

const QUADRATIC: [Measured; 3] = [
    row("spartan-3", 2727, 3509, 86),
    row("spartan-6", 2401, 3509, 86),
    row("spartan-7", 2408, 3509, 43),
];
const GOURAUD: [Measured; 3] = [
    row("spartan-3", 1806, 2021, 86),
    row("spartan-6", 1485, 2021, 86),
    row("spartan-7", 1481, 2021, 43),
];
const fn with_multipliers(dsp: u32, row: Measured) -> Measured {
    Measured { dsp, ..row }
}

const DUFF: [Measured; 3] = [
    with_multipliers(22, row("spartan-3", 3234, 5341, 88)),
    with_multipliers(22, row("spartan-6", 2689, 4948, 88)),
    with_multipliers(21, row("spartan-7", 2682, 4948, 45)),
];
const SLERP: [Measured; 3] = [
    with_multipliers(15, row("spartan-3", 2499, 2420, 88)),
    with_multipliers(15, row("spartan-6", 1646, 1670, 88)),
    with_multipliers(11, row("spartan-7", 1588, 1670, 44)),
];
const BLAKE: [Measured; 3] = [
    with_multipliers(6, row("spartan-3", 2039, 2380, 86)),
    with_multipliers(6, row("spartan-6", 1346, 1664, 86)),
    with_multipliers(6, row("spartan-7", 1352, 1664, 43)),
];
const QUADRATIC_DOTS: [Measured; 3] = [
    with_multipliers(7, row("spartan-3", 2710, 3977, 87)),
    with_multipliers(7, row("spartan-6", 2402, 3823, 87)),
    with_multipliers(7, row("spartan-7", 2380, 3823, 44)),
];

/// The estimate in a manifest.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Resources {
    /// Bits of the depth memory, or of the frame memory of a line core.
    pub depth_memory_bits: u64,
    /// Multipliers that the description has, whatever they are made of.
    pub multipliers: u32,
    /// Synthesiser of `measured`.
    pub tool: &'static str,
    /// By family; only the device's, if one is named. Null where this configuration was not measured.
    pub measured: Option<Vec<Measured>>,
}

/// What a core takes, as far as it was measured.
#[must_use]
pub fn resources(core: &Core, size: (u32, u32), device: Option<&Device>) -> Resources {
    let all = match core.order {
        Order::Linear => GOURAUD.to_vec(),
        Order::Quadratic => QUADRATIC.to_vec(),
        Order::QuadraticDots => QUADRATIC_DOTS.to_vec(),
        Order::QuadraticEngine => vec![],
        Order::Line(filter) => line::measured(filter).to_vec(),
        Order::Duff => DUFF.to_vec(),
        Order::Glint(_) => vec![],
        Order::Span(SpanKind::Slerp) => SLERP.to_vec(),
        Order::Span(SpanKind::Blake) => BLAKE.to_vec(),
        Order::Span(_) => vec![],
        Order::Textured(_) => vec![],
        Order::Bump(_) => vec![],
    };
    let rows: Vec<Measured> = all
        .into_iter()
        .filter(|m| {
            core.load_words == Core::usual_load_words(core.order)
                && size == FRAME
                && device.is_none_or(|d| d.family == m.family)
        })
        .collect();
    Resources {
        multipliers: match core.order {
            Order::Linear | Order::Quadratic => 0,
            Order::QuadraticDots => 7,
            Order::QuadraticEngine => 1,
            Order::Line(Filter::Bresenham) => 0,
            Order::Line(Filter::Box | Filter::Cone) => 3,
            Order::Duff => 12,
            // Three per channel for the mean, one for the product; two for the reciprocal, two after it.
            Order::Textured(t) if t.mapping == Mapping::Perspective => 16,
            Order::Textured(_) => 12,
            // Six of the gradient, two or three of its factors, eight of the cosines, seven of the reflection model.
            Order::Bump(Bend::Newton) => 23,
            Order::Bump(Bend::Reflection) => 24,
            // Six of the channels, two of the highlight; one of the spot and two of what it scales.
            Order::Glint(Glint::Kappa) => 8,
            Order::Glint(Glint::Spot) => 11,
            // Two per channel; a recurrence for either curve and the power in between.
            Order::Span(SpanKind::Slerp | SpanKind::Chebyshev) => 9,
            Order::Span(_) => 6,
        },
        depth_memory_bits: core.memory_bits(),
        tool: TOOL,
        measured: Some(rows).filter(|r| !r.is_empty()),
    }
}
