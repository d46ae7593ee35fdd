//! rust-hdl in this process: the description itself, clocked by hand.

use super::{Engine, EngineError, Run, SignalMismatch, Wave};
use crate::wave::CLOCK_PS;
use rust_hdl_core::vcd_probe::{write_vcd_change, write_vcd_dump, write_vcd_header, VCDProbe};
use shadegate_gen::vectors::{pack_outputs, Trace, FLAGS, PIXEL};
use shadegate_gen::write::temporary_beside;
use shadegate_hdl::shade::device::CoreSimulator;
use shadegate_hdl::shade::model::CoreOutputs;
use std::fs::File;
use std::io::BufWriter;
use std::time::Instant;
use tempfile::NamedTempFile;

const ENGINE: Engine = Engine::RustHdl;

/// The fields of a clock's outputs, by name, in the order of the vector file.
fn fields(o: &CoreOutputs) -> impl Iterator<Item = (&'static str, u64)> {
    let (flags, mut pixel) = pack_outputs(o);
    let named = FLAGS.into_iter().enumerate();
    let flags = named.map(move |(bit, name)| (name, flags >> bit & 1));
    flags.chain(PIXEL.into_iter().map(move |(name, bits)| {
        let value = pixel & ((1 << bits) - 1);
        pixel >>= bits;
        (name, value)
    }))
}

/// The first output that differs.
pub(super) fn difference(
    cycle: usize,
    want: &CoreOutputs,
    got: &CoreOutputs,
) -> Option<SignalMismatch> {
    let mut pairs = fields(want).zip(fields(got));
    let ((signal, expected), (_, got)) = pairs.find(|(w, g)| w.1 != g.1)?;
    Some(SignalMismatch {
        cycle: cycle as u64,
        signal: signal.to_string(),
        expected,
        got,
        x: u32::from(want.x),
        y: u32::from(want.y),
    })
}

/// A waveform under construction: written beside its place, moved there when it is whole.
struct Waveform {
    probe: VCDProbe<BufWriter<File>>,
    file: NamedTempFile,
}

impl Waveform {
    fn begin(wave: &Wave, simulator: &CoreSimulator) -> std::io::Result<Self> {
        let file = temporary_beside(&wave.file)?;
        let header = write_vcd_header(BufWriter::new(file.reopen()?), simulator.design());
        Ok(Self {
            probe: write_vcd_dump(header, simulator.design()),
            file,
        })
    }

    fn change(mut self, cycle: usize, simulator: &CoreSimulator) -> std::io::Result<Self> {
        self.probe.timestamp(cycle as u64 * CLOCK_PS)?;
        Ok(Self {
            probe: write_vcd_change(self.probe, simulator.design()),
            ..self
        })
    }

    fn end(self, wave: &Wave) -> std::io::Result<()> {
        drop(self.probe);
        self.file.persist(&wave.file)?;
        Ok(())
    }
}

/// Clocks the description through the trace.
pub fn run(trace: &Trace, wave: Option<&Wave>) -> Result<Run, EngineError> {
    let failed = |what: String| EngineError::Failed {
        engine: ENGINE,
        what,
    };
    let wave_failed = |w: &Wave, e: std::io::Error| {
        failed(format!("{}: cannot be written: {e}", w.file.display()))
    };
    let mut simulator = CoreSimulator::new(trace.core).map_err(failed)?;
    let mut run = Run {
        cycles: trace.clocks.len() as u64,
        ..Run::default()
    };
    let mut waveform: Option<Waveform> = None;
    let begin = Instant::now();
    let mut before = simulator.outputs();
    for (cycle, clock) in trace.clocks.iter().enumerate() {
        if before.valid && clock.inputs.ready {
            run.pixels.push((before.x, before.y, before.rgb));
        }
        simulator.clock(&clock.inputs);
        let after = simulator.outputs();
        if after != clock.outputs {
            run.mismatches += 1;
            if run.first.is_none() {
                run.first = difference(cycle, &clock.outputs, &after);
            }
        }
        before = after;
        if let Some(w) = wave.filter(|w| (w.from..w.to).contains(&(cycle as u64))) {
            let next = match waveform.take() {
                None => Waveform::begin(w, &simulator),
                Some(v) => v.change(cycle, &simulator),
            };
            waveform = Some(next.map_err(|e| wave_failed(w, e))?);
        }
    }
    run.simulate_ns = begin.elapsed().as_nanos() as u64;
    run.loop_ns = Some(run.simulate_ns);
    if let Some(w) = wave {
        match waveform {
            Some(v) => v.end(w).map_err(|e| wave_failed(w, e))?,
            None => {
                let what = format!(
                    "has no clock to show from {} on: the run has {} clocks",
                    w.from, run.cycles
                );
                return Err(EngineError::Unsupported {
                    engine: ENGINE,
                    what,
                });
            }
        }
    }
    Ok(run)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_output_is_named_when_it_alone_differs() {
        let want = CoreOutputs::default();
        let flip = |change: fn(&mut CoreOutputs)| {
            let mut got = want;
            change(&mut got);
            difference(7, &want, &got).map(|d| (d.signal, d.expected, d.got))
        };
        assert_eq!(flip(|_| {}), None);
        assert_eq!(
            flip(|o| o.load_ready = true),
            Some(("load_ready".into(), 0, 1))
        );
        assert_eq!(flip(|o| o.valid = true), Some(("valid".into(), 0, 1)));
        assert_eq!(flip(|o| o.busy = true), Some(("busy".into(), 0, 1)));
        assert_eq!(flip(|o| o.done = true), Some(("done".into(), 0, 1)));
        assert_eq!(flip(|o| o.x = 2047), Some(("x".into(), 0, 2047)));
        assert_eq!(flip(|o| o.y = 2047), Some(("y".into(), 0, 2047)));
        assert_eq!(flip(|o| o.rgb[0] = 255), Some(("red".into(), 0, 255)));
        assert_eq!(flip(|o| o.rgb[1] = 255), Some(("green".into(), 0, 255)));
        assert_eq!(flip(|o| o.rgb[2] = 255), Some(("blue".into(), 0, 255)));
        assert_eq!(flip(|o| o.depth = 65535), Some(("depth".into(), 0, 65535)));
    }
}
