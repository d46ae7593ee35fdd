//! The netlist as native code in this process: elaborated and compiled when it is needed, without files or programs.

use super::rust_hdl::difference;
use super::{Engine, EngineError, Run, Wave};
use crate::wave::{WaveError, Waveform};
use shadegate_gen::compile::CompiledCore;
use shadegate_gen::vectors::Trace;
use std::time::Instant;

const ENGINE: Engine = Engine::Compiled;

fn failed(what: impl ToString) -> EngineError {
    EngineError::Failed {
        engine: ENGINE,
        what: what.to_string(),
    }
}

fn unsupported(what: String) -> EngineError {
    EngineError::Unsupported {
        engine: ENGINE,
        what,
    }
}

fn wave_failed(w: &Wave, e: WaveError) -> EngineError {
    match e {
        WaveError::NoSignal(_) => unsupported(format!("cannot write '{}': {e}", w.file.display())),
        WaveError::File(e) => failed(format!("{}: cannot be written: {e}", w.file.display())),
        WaveError::Netlist(e) => failed(e),
    }
}

/// Compiles the core and clocks it through the trace.
pub fn run(trace: &Trace, wave: Option<&Wave>) -> Result<Run, EngineError> {
    let begin = Instant::now();
    let mut core = CompiledCore::new(trace.core).map_err(failed)?;
    let mut run = Run {
        cycles: trace.clocks.len() as u64,
        build_ns: begin.elapsed().as_nanos() as u64,
        ..Run::default()
    };
    run.pixels.reserve(trace.pixels.len());
    let mut waveform: Option<Waveform> = None;
    let window = wave.map_or(0..0, |w| w.from..w.to);
    let begin = Instant::now();
    let mut before = core.outputs();
    for (cycle, clock) in trace.clocks.iter().enumerate() {
        if before.valid && clock.inputs.ready {
            run.pixels.push((before.x, before.y, before.rgb));
        }
        core.clock(&clock.inputs);
        let after = core.outputs();
        if after != clock.outputs {
            run.mismatches += 1;
            if run.first.is_none() {
                run.first = difference(cycle, &clock.outputs, &after);
            }
        }
        before = after;
        if let Some(w) = wave.filter(|_| window.contains(&(cycle as u64))) {
            let simulator = core.simulator();
            let shown = match &mut waveform {
                Some(v) => v,
                none => none.insert(Waveform::begin(w, simulator).map_err(|e| wave_failed(w, e))?),
            };
            let shown = shown.clock(cycle as u64, simulator);
            shown.map_err(|e| wave_failed(w, e))?;
        }
    }
    run.simulate_ns = begin.elapsed().as_nanos() as u64;
    run.loop_ns = Some(run.simulate_ns);
    if let Some(w) = wave {
        let Some(v) = waveform else {
            let (from, cycles) = (w.from, run.cycles);
            return Err(unsupported(format!(
                "has no clock to show from {from} on: the run has {cycles} clocks"
            )));
        };
        v.end(w).map_err(|e| wave_failed(w, e))?;
    }
    Ok(run)
}
