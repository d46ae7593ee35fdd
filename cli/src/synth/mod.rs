//! `shadegate synth`: what a core takes of a device family, and how fast it runs where it can be routed.

mod subject;
mod text;

use crate::args::Global;
use crate::names::{all_cores, cores, devices, routers, Offer};
use crate::outcome::{Failure, Outcome, Report};
use crate::progress::Progress;
use crate::{output, size};
use clap::Args;
use serde_json::{json, Value};
use shadegate_constraints::{device, Device};
use shadegate_gen::write::write_file;
use shadegate_testbench::synthesis::{
    route, synthesise, Capacity, Family, Options, Router, Row, Synthesis, SynthesisError,
};
use std::path::PathBuf;
use subject::subject;
use text::text;

/// Arguments of `synth`.
#[derive(Debug, Args)]
#[command(group(clap::ArgGroup::new("what").required(true).args(["core", "scene", "verilog"])))]
#[command(
    after_help = "Cells are counted after mapping by Yosys and before placement. No tool here places and routes for \
                  Xilinx devices, so none of them gets a clock frequency; --route gives that of a Lattice part.\n\n\
                  Exit codes: 0 done; 2 bad input; 3 Yosys or nextpnr is missing or failed."
)]
pub struct SynthArgs {
    /// Core
    #[arg(value_parser = Offer(all_cores))]
    core: Option<String>,
    /// Scene that the core is to draw: its frame size, its method
    #[arg(long, value_name = "FILE")]
    scene: Option<PathBuf>,
    /// Folder of Verilog files instead of a core
    #[arg(long, value_name = "DIR", requires = "top")]
    verilog: Option<PathBuf>,
    /// Its top module
    #[arg(long, value_name = "MODULE", requires = "verilog")]
    top: Option<String>,
    /// Device; may be given several times [default: the families of Spartan-3, -6 and -7]
    #[arg(long, value_parser = Offer(devices), value_name = "DEVICE")]
    target: Vec<String>,
    /// Shading method, one that has a core [default: the scene's]
    #[arg(long, value_parser = Offer(cores), requires = "scene")]
    method: Option<String>,
    /// Frame size [default: the scene's, or 320x240]
    #[arg(long, value_name = "WxH", conflicts_with = "verilog")]
    size: Option<String>,
    /// Place and route too, on the smallest part of this family that holds the core
    #[arg(long, value_parser = Offer(routers), default_value = "none", value_name = "FAMILY")]
    route: String,
    /// Run the tools even if their results are known, and do not keep them
    #[arg(long)]
    no_cache: bool,
    /// No multiplexers wider than a look-up table: longer paths, far fewer look-up tables on Spartan-3
    #[arg(long)]
    no_wide_mux: bool,
    /// Folder for Verilog, netlists and reports [default: none are kept]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Runs the command.
pub fn run(a: &SynthArgs, global: Global) -> Outcome {
    let router = match a.route.as_str() {
        "none" => None,
        name => Some(name.parse::<Router>().map_err(Failure::input)?),
    };
    let targets = targets(&a.target, router)?;
    // Nobody waits for Yosys to be told that nextpnr is missing.
    router.map(Router::tool).transpose().map_err(fault)?;
    let size = a.size.as_deref().map(size::parse).transpose()?;
    a.output.as_deref().map(output::folder).transpose()?;
    let progress = Progress::new("writing Verilog", global);
    let subject = subject(a, size)?;
    if let Some(folder) = &a.output {
        for f in &subject.design.files {
            write_file(&folder.join(&f.path), f.text.as_bytes()).map_err(Failure::input)?;
        }
    }
    let options = Options {
        cache: !a.no_cache,
        output: a.output.as_deref(),
        wide_muxes: !a.no_wide_mux,
    };
    let mut rows = vec![];
    let mut done: Vec<Synthesis> = vec![];
    for (family, device) in targets {
        if !done.iter().any(|s| s.family == family) {
            progress.say(format!("Yosys maps {} to {family}", subject.title));
            done.push(synthesise(&subject.design, family, &options).map_err(fault)?);
        }
        if let Some(s) = done.iter().find(|s| s.family == family) {
            rows.push(Row::mapped(s, device.map(capacity)));
        }
    }
    if let Some(router) = router {
        progress.say(format!("nextpnr routes {} on {router}", subject.title));
        let (s, r) = route(&subject.design, router, &options).map_err(fault)?;
        rows.push(Row::routed(&s, &r));
    }
    let mut json = subject.about;
    if let Some(object) = json.as_object_mut() {
        let rows = serde_json::to_value(&rows).unwrap_or(Value::Null);
        object.insert("rows".into(), rows);
        let folder = a.output.as_ref().map(|o| o.to_string_lossy());
        object.insert("output".into(), json!(folder));
    }
    if let Some(folder) = &a.output {
        let text = format!("{json:#}\n");
        write_file(&folder.join("synth.json"), text.as_bytes()).map_err(Failure::input)?;
    }
    drop(progress);
    let text = if global.quiet {
        String::new()
    } else {
        text(&subject.title, &rows, a.output.as_deref())
    };
    Ok(Report::done(text, json))
}

fn fault(e: SynthesisError) -> Failure {
    match e {
        SynthesisError::TooLarge(_) => Failure::input(e),
        _ => Failure::tool(e),
    }
}

/// Families to map to, and the devices that stand for them.
fn targets(
    names: &[String],
    router: Option<Router>,
) -> Result<Vec<(Family, Option<&'static Device>)>, Failure> {
    if names.is_empty() {
        // A row that is routed says all that a mapped one would.
        let usual = Family::USUAL.into_iter();
        let usual = usual.filter(|f| router.map(Router::family) != Some(*f));
        return Ok(usual.map(|f| (f, None)).collect());
    }
    let one = |name: &String| {
        let device = device(name).map_err(Failure::input)?;
        let family = device.yosys_family.parse().map_err(Failure::input)?;
        Ok((family, Some(device)))
    };
    names.iter().map(one).collect()
}

fn capacity(d: &Device) -> (&str, Capacity) {
    let capacity = Capacity {
        lut: d.luts.into(),
        ff: d.flip_flops.into(),
        bram_kbit: d.block_ram_total_kbit().into(),
        dsp: d.multipliers.into(),
    };
    (&d.name, capacity)
}
