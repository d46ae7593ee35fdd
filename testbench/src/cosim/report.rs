//! The report of a co-simulation: stable JSON keys, documented in `docs/`.

use super::frames::FragmentError;
use super::{CosimOptions, Prelude};
use crate::compare::Comparison;
use crate::engine::Run;
use serde::Serialize;
use shadegate_gen::spent::Spent;
use shadegate_gen::stimulus::Stimulus;
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::longest_run;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::{DEPTH_FRACTION_BITS, DEPTH_INTEGER_BITS};
use std::collections::BTreeMap;

/// Error of one frame against another.
#[derive(Clone, Debug, Serialize)]
pub struct ErrorReport {
    /// Largest difference of a channel, LSB.
    pub max_lsb: u8,
    /// Root mean square over all channels, LSB.
    pub rms_lsb: f64,
    /// Peak signal-to-noise ratio, dB; null for equal frames.
    pub psnr_db: Option<f64>,
    /// Mean FLIP.
    pub flip_mean: f64,
}

impl From<&Comparison> for ErrorReport {
    fn from(c: &Comparison) -> Self {
        let psnr_db = c.psnr_db.is_finite().then_some(c.psnr_db);
        Self {
            max_lsb: c.max_lsb,
            rms_lsb: c.rms_lsb,
            psnr_db,
            flip_mean: f64::from(c.flip_mean as f32),
        }
    }
}

/// Where expected and simulated first differ, and how to see it again.
#[derive(Clone, Debug, Serialize)]
pub struct FirstMismatch {
    /// Clock, from 0.
    pub cycle: u64,
    /// Output.
    pub signal: String,
    /// Value of the integer model.
    pub expected: u64,
    /// Value of the engine.
    pub got: u64,
    /// Pixel that the model shows in this clock.
    pub pixel: (u32, u32),
    /// Its triangle or line.
    pub triangle: Option<String>,
    /// A command that shows the clocks around it.
    pub reproduce: String,
}

/// A format in use.
#[derive(Clone, Debug, Serialize)]
pub struct FormatReport {
    /// Integer bits, without the sign.
    pub int: usize,
    /// Fraction bits.
    pub frac: usize,
}

/// What the host sent and what it left out.
#[derive(Clone, Debug, Default, Serialize)]
pub struct HostReport {
    /// Triangles, or pieces of lines, sent.
    pub triangles: u64,
    /// Register writes sent.
    pub writes: u64,
    /// Left out, by reason.
    pub skipped: BTreeMap<&'static str, u64>,
}

impl HostReport {
    /// Counts of a stimulus and its run.
    pub(super) fn new(s: &Stimulus, t: &Trace) -> Self {
        let uncovered = match t.core.order {
            Order::Line(_) => "unseen-lines",
            _ => "uncovered-triangles",
        };
        // A span core has a primitive for every span.
        let mut sent: Vec<usize> = s.primitives.iter().map(|p| p.triangle).collect();
        sent.dedup();
        let mut skipped = BTreeMap::from([
            ("unchanged-words", s.skipped_unchanged),
            ("broadcast-words", s.skipped_broadcast),
            (uncovered, s.skipped_uncovered),
        ]);
        if let Order::Glint(_) = t.core.order {
            skipped.insert("dark-words", s.skipped_dark);
        }
        Self {
            triangles: sent.len() as u64,
            writes: t.writes,
            skipped,
        }
    }
}

/// What the clocks were spent on; the three parts add up to `cycles`.
#[derive(Clone, Debug, Serialize)]
pub struct ClockReport {
    /// A pixel moves on from the pixel registers, whether the depth test lets it pass or not.
    pub drawing: u64,
    /// The pixel registers are empty because words are written or on their way.
    pub loading: u64,
    /// The rest.
    pub waiting: u64,
    /// The rest by what it waits for.
    pub waiting_for: BTreeMap<&'static str, u64>,
}

impl From<&Spent> for ClockReport {
    fn from(s: &Spent) -> Self {
        Self {
            drawing: s.drawing,
            loading: s.loading,
            waiting: s.waiting(),
            waiting_for: BTreeMap::from([
                ("back-pressure", s.back_pressure),
                ("empty-rows", s.empty_rows),
                ("clear", s.clear),
                ("drain", s.drain),
            ]),
        }
    }
}

/// Where the time went.
#[derive(Clone, Debug, Serialize)]
pub struct TimeReport {
    /// Scene to register words.
    pub setup: u64,
    /// Verilog and vectors.
    pub emit: u64,
    /// Building the simulator; zero if there is none to build, or if it was kept from an earlier run.
    pub build: u64,
    /// The simulation: of external engines the whole process, which reads vectors and writes pixels.
    pub simulate: u64,
    /// The simulation loop alone, vectors and pixels in memory; null where the engine cannot tell.
    pub simulate_loop: Option<u64>,
    /// Reference frames and comparison.
    pub compare: u64,
}

/// The report; field names are the JSON keys.
#[derive(Clone, Debug, Serialize)]
pub struct CosimReport {
    /// Scene.
    pub scene: String,
    /// Method.
    pub method: String,
    /// Core.
    pub core: String,
    /// Engine.
    pub engine: String,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Clocks from the first register write of a triangle to `done`.
    pub cycles: u64,
    /// What they were spent on.
    pub clocks: ClockReport,
    /// Register words per clock.
    pub load_words: usize,
    /// Pixels handed over by the core.
    pub pixels: u64,
    /// Pixels per clock.
    pub pixels_per_cycle: f64,
    /// Clocks simulated per second of `time_ns.simulate`.
    pub cycles_per_second: f64,
    /// Clocks simulated per second of `time_ns.simulate_loop`.
    pub loop_cycles_per_second: Option<f64>,
    /// Clocks with a difference in any output, plus pixels of the frame that differ.
    pub mismatches: u64,
    /// The first of them.
    pub first_mismatch: Option<FirstMismatch>,
    /// Simulated frame against `exact`.
    pub error: ErrorReport,
    /// Simulated frame against the same method in f64.
    pub method_f64: ErrorReport,
    /// Every pixel handed over against the same method in f64 at its own triangle: the arithmetic error alone.
    pub arithmetic: BTreeMap<&'static str, f64>,
    /// Proved bound of the arithmetic error before the final rounding, LSB.
    pub error_bound_lsb: f64,
    /// Formats.
    pub formats: BTreeMap<&'static str, FormatReport>,
    /// What depth words are linear in; null for lines.
    pub depth: Option<&'static str>,
    /// What the host sent.
    pub host: HostReport,
    /// Where the time went, ns.
    pub time_ns: TimeReport,
    /// The simulator's build came from the cache.
    pub build_cached: bool,
    /// Configuration of the emitted core.
    pub configuration: String,
}

/// Everything a report is made of.
pub(super) struct Inputs<'a> {
    pub prelude: &'a Prelude,
    pub options: &'a CosimOptions,
    pub scene_name: &'a str,
    pub run: &'a Run,
    pub against_expected: &'a Comparison,
    pub against_method: &'a Comparison,
    pub against_exact: &'a Comparison,
    pub fragments: FragmentError,
    pub compare_ns: u64,
}

/// Clocks per second; zero for a time of zero.
fn rate(cycles: u64, ns: u64) -> f64 {
    if ns == 0 {
        0.0
    } else {
        cycles as f64 / (ns as f64 / 1e9)
    }
}

/// Clocks shown on either side of a mismatch.
const WINDOW: u64 = 20;

fn first_mismatch(i: &Inputs) -> Option<FirstMismatch> {
    let first = i.run.first.as_ref()?;
    let near = i
        .prelude
        .trace
        .pixels
        .iter()
        .find(|p| p.clock as u64 >= first.cycle);
    let label = |index: usize| {
        let triangle = i.prelude.triangles.get(index).map(|t| t.label.clone());
        triangle.or_else(|| i.prelude.lines.get(index).map(|l| l.label.clone()))
    };
    let triangle = near.and_then(|p| label(p.triangle));
    let (from, to) = (first.cycle.saturating_sub(WINDOW), first.cycle + WINDOW);
    Some(FirstMismatch {
        cycle: first.cycle,
        signal: first.signal.clone(),
        expected: first.expected,
        got: first.got,
        pixel: (first.x, first.y),
        triangle,
        reproduce: format!(
            "{} --wave mismatch.vcd --from {from} --to {to}",
            i.options.command
        ),
    })
}

fn arithmetic(order: Order, error: &FragmentError) -> BTreeMap<&'static str, f64> {
    let mut all = BTreeMap::from([
        ("max_lsb", f64::from(error.max_lsb)),
        ("rms_lsb", error.rms_lsb),
    ]);
    if let Order::Textured(_) = order {
        all.insert("border_pixels", error.border_pixels as f64);
    }
    all
}

impl CosimReport {
    pub(super) fn new(i: Inputs) -> Self {
        let p = i.prelude;
        let core = &p.trace.core;
        let (width, height) = (p.prepared.width, p.prepared.height);
        let pixels = i.run.pixels.len() as u64;
        let format = |int, frac| FormatReport { int, frac };
        let own = core.formats().into_iter();
        let own = own.map(|(name, int, frac)| (name, format(int, frac)));
        Self {
            scene: i.scene_name.to_string(),
            method: match core.order {
                Order::Line(_) => core.name().to_string(),
                _ => i.options.method.to_string(),
            },
            core: core.name().to_string(),
            engine: i.options.engine.to_string(),
            width,
            height,
            cycles: p.trace.cycles,
            clocks: (&p.trace.spent).into(),
            load_words: core.load_words,
            pixels,
            pixels_per_cycle: if p.trace.cycles == 0 {
                0.0
            } else {
                pixels as f64 / p.trace.cycles as f64
            },
            cycles_per_second: rate(i.run.cycles, i.run.simulate_ns),
            loop_cycles_per_second: i.run.loop_ns.map(|ns| rate(i.run.cycles, ns)),
            mismatches: i.run.mismatches + i.against_expected.differing,
            first_mismatch: first_mismatch(&i),
            error: i.against_exact.into(),
            method_f64: i.against_method.into(),
            arithmetic: arithmetic(core.order, &i.fragments),
            error_bound_lsb: core.error_bound(longest_run(width, height).unwrap_or(u32::MAX)),
            formats: match core.order {
                Order::Line(_) => p
                    .package
                    .manifest
                    .formats
                    .iter()
                    .map(|(name, f)| (*name, format(f.int, f.frac)))
                    .collect(),
                _ => own
                    .chain([("depth", format(DEPTH_INTEGER_BITS, DEPTH_FRACTION_BITS))])
                    .collect(),
            },
            depth: match core.order {
                Order::Line(_) => None,
                _ => Some(i.options.stimulus.depth.name()),
            },
            host: p.host.clone(),
            time_ns: TimeReport {
                setup: p.setup_ns,
                emit: p.emit_ns,
                build: i.run.build_ns,
                simulate: i.run.simulate_ns,
                simulate_loop: i.run.loop_ns,
                compare: i.compare_ns,
            },
            build_cached: i.run.build_cached,
            configuration: p.package.manifest.configuration.clone(),
        }
    }

    /// Whether every check holds: no mismatch, and an arithmetic error of at most one LSB.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.mismatches == 0 && self.arithmetic["max_lsb"] <= 1.0
    }
}
