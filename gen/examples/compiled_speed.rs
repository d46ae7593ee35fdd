//! How fast the compiled simulation starts and runs, beside rust-hdl's, while the quadratic core draws a scene.
//!
//! `cargo run --release -p shadegate-gen --example compiled_speed [SCENE]`; every output of every clock is compared
//! with the integer model. Median of five, engines in turn.

use shadegate_gen::compile::{CompiledCore, Simulator};
use shadegate_gen::netlist::{collect, elaborate};
use shadegate_gen::scene::triangles;
use shadegate_gen::stimulus::{build, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;
use shadegate_reference::{scene, Prepared, Skips};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;

const RUNS: usize = 5;

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn trace_of(path: &Path) -> Result<Trace, Box<dyn Error>> {
    let scene = scene::load(path)?;
    let (width, height) = (scene.image.width, scene.image.height);
    let core = Core::for_frame(Order::Quadratic, width, height).ok_or("the frame is too large")?;
    let prepared = Prepared::new(&scene, None, &Skips::all())?;
    let triangles = triangles(&prepared, core.order);
    let options = StimulusOptions::default();
    let stimulus = build(&core, &triangles, Viewport { width, height }, &options)?;
    Ok(Trace::record(core, &stimulus, |_| true))
}

fn main() -> Result<(), Box<dyn Error>> {
    let scenes = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let path = std::env::args_os().nth(1).map(PathBuf::from);
    let trace = trace_of(&path.unwrap_or_else(|| scenes.join("teapot.toml")))?;
    let connected = CoreSimulator::new(trace.core)?;
    let netlist = collect(connected.design())?;
    let (mut start, mut flat, mut compiled, mut described) = (vec![], vec![], vec![], vec![]);
    for _ in 0..RUNS {
        let begin = Instant::now();
        elaborate(&netlist)?;
        flat.push(begin.elapsed().as_secs_f64() * 1e3);
        let begin = Instant::now();
        let simulator = Simulator::new(&netlist)?;
        start.push(begin.elapsed().as_secs_f64() * 1e3);

        let mut core = CompiledCore::from_simulator(simulator)?;
        let begin = Instant::now();
        let mut wrong = 0;
        for c in &trace.clocks {
            core.clock(&c.inputs);
            wrong += usize::from(core.outputs() != c.outputs);
        }
        compiled.push(trace.clocks.len() as f64 / begin.elapsed().as_secs_f64());
        let mut core = CoreSimulator::new(trace.core)?;
        let begin = Instant::now();
        for c in &trace.clocks {
            core.clock(&c.inputs);
            wrong += usize::from(core.outputs() != c.outputs);
        }
        described.push(trace.clocks.len() as f64 / begin.elapsed().as_secs_f64());
        if wrong != 0 {
            return Err(format!("{wrong} clocks differ from the integer model").into());
        }
    }
    let (compiled, described) = (median(compiled), median(described));
    println!("{} clocks, median of {RUNS}:", trace.clocks.len());
    println!(
        "  compiled {compiled:.0} clocks/s, rust-hdl {described:.0} clocks/s, ratio {:.1}",
        compiled / described
    );
    println!(
        "  start {:.1} ms, of which elaboration {:.1} ms",
        median(start),
        median(flat)
    );
    Ok(())
}
