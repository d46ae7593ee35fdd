//! `shadegate synth`: what a core takes of a device family, and how fast it runs where it can be routed.

use crate::args::Global;
use crate::cosim::failure;
use crate::names::{core, cores, devices, hardware_method, routers, Offer};
use crate::outcome::{Failure, Outcome, Report};
use crate::progress::Progress;
use crate::table::Table;
use crate::{output, size};
use clap::Args;
use serde_json::{json, Value};
use shadegate_constraints::{device, Device};
use shadegate_gen::package::{rtl, PackageFile};
use shadegate_gen::write::write_file;
use shadegate_reference::{scene, Method};
use shadegate_testbench::cosim::{core_for, CosimError};
use shadegate_testbench::synthesis::{
    route, synthesise, Capacity, Design, Family, Options, Router, Row, Synthesis, SynthesisError,
};
use std::path::{Path, PathBuf};

/// Frame of a core that is synthesised without a scene.
const FRAME: (u32, u32) = (320, 240);

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
    #[arg(value_parser = Offer(cores))]
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
    /// Folder for Verilog, netlists and reports [default: none are kept]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// A design, and what is known of it besides.
struct Subject {
    design: Design,
    title: String,
    about: Value,
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

/// What is to be synthesised.
fn subject(a: &SynthArgs, size: Option<(u32, u32)>) -> Result<Subject, Failure> {
    if let (Some(folder), Some(top)) = (&a.verilog, &a.top) {
        return verilog(folder, top);
    }
    let (method, scene_size) = match (&a.scene, &a.core) {
        (Some(file), _) => {
            hardware_method(a.method.as_deref(), None, Method::Quadratic)?;
            let scene = scene::load(file).map_err(Failure::input)?;
            let method = hardware_method(a.method.as_deref(), None, scene.render.method)?;
            (method, (scene.image.width, scene.image.height))
        }
        (None, Some(name)) if name.ends_with(".toml") => {
            return Err(Failure::input(format!(
                "'{name}' is not a core; for a scene: shadegate synth --scene {name}"
            )));
        }
        (None, Some(name)) => (core(name)?, FRAME),
        // clap demands one of them.
        (None, None) => return Err(Failure::input("expected a core or --scene FILE")),
    };
    let (width, height) = size.unwrap_or(scene_size);
    let core = core_for(method, width, height).map_err(failure)?;
    let rtl = rtl(&core).map_err(|e| failure(CosimError::Package(e)))?;
    let file = |f: &shadegate_gen::verilog::VerilogFile| PackageFile {
        path: format!("rtl/{}", f.file_name()),
        text: f.text.clone(),
    };
    let top = format!("{}_core", core.name());
    Ok(Subject {
        title: format!("{} core, {width}x{height}", core.name()),
        about: json!({
            "design": top,
            "core": core.name(),
            "frame": [width, height],
            "configuration": rtl.configuration,
        }),
        design: Design {
            top,
            files: rtl.files.iter().map(file).collect(),
        },
    })
}

/// A folder of Verilog files. Their names go into scripts, so they must be plain.
fn verilog(folder: &Path, top: &str) -> Result<Subject, Failure> {
    let plain = |name: &str| {
        name.bytes()
            .all(|b| b.is_ascii_alphanumeric() || b"_-.".contains(&b))
    };
    if !top.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') || top.is_empty() {
        return Err(Failure::input(format!(
            "top module '{top}' is not a name; expected letters, digits and underscores"
        )));
    }
    let cannot =
        |path: &Path, e: std::io::Error| Failure::input(format!("'{}': {e}", path.display()));
    let mut files = vec![];
    for file in std::fs::read_dir(folder).map_err(|e| cannot(folder, e))? {
        let path = file.map_err(|e| cannot(folder, e))?.path();
        let Some(name) = path.file_name().and_then(|n| n.to_str()) else {
            continue;
        };
        if !name.ends_with(".v") {
            continue;
        }
        if !plain(name) {
            return Err(Failure::input(format!(
                "'{}': expected a file name of letters, digits, '.', '-' and '_'",
                path.display()
            )));
        }
        files.push(PackageFile {
            path: format!("rtl/{name}"),
            text: std::fs::read_to_string(&path).map_err(|e| cannot(&path, e))?,
        });
    }
    if files.is_empty() {
        return Err(Failure::input(format!(
            "'{}' holds no Verilog; expected files that end in .v",
            folder.display()
        )));
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(Subject {
        title: top.to_string(),
        about: json!({ "design": top, "core": null, "frame": null, "configuration": null }),
        design: Design {
            top: top.to_string(),
            files,
        },
    })
}

fn text(title: &str, rows: &[Row], folder: Option<&Path>) -> String {
    let mut table = Table::new(&[
        "target",
        "family",
        "LUT",
        "FF",
        "carry",
        "block RAM",
        "DSP",
        "slices",
        "fits",
        "depth",
        "cells, ns",
        "Fmax, MHz",
    ]);
    let dash = || "-".to_owned();
    for r in rows {
        let n = &r.resources;
        let kinds = n.bram_cells.iter().map(|(kind, n)| format!("{n} {kind}"));
        let kinds: Vec<String> = kinds.collect();
        table.row([
            r.target.clone().unwrap_or_else(dash),
            r.family.to_owned(),
            n.lut.to_string(),
            n.ff.to_string(),
            match &n.carry_cell {
                Some(cell) => format!("{} {cell}", n.carry),
                None => "0".to_owned(),
            },
            if kinds.is_empty() {
                "0".to_owned()
            } else {
                kinds.join(", ")
            },
            n.dsp.to_string(),
            r.slices.map_or_else(dash, |s| s.to_string()),
            r.fits
                .map_or_else(dash, |f| if f { "yes" } else { "no" }.to_owned()),
            r.depth.map_or_else(dash, |d| d.to_string()),
            r.arrival_ps
                .map_or_else(dash, |ps| format!("{:.2}", ps as f64 / 1e3)),
            r.fmax_mhz.map_or_else(dash, |f| format!("{f:.1}")),
        ]);
    }
    let mut out = format!("{title}: cells before placement\n{}", table.text());
    out += "slices  if every one is filled: the most that LUT, FF or carry need\n\
            depth   cells on the longest path between registers\n\
            cells   delay of these cells without wires: no clock is that fast\n";
    for r in rows {
        if let (Some(part), Some(fmax)) = (&r.target, r.fmax_mhz) {
            out += &format!(
                "routed on {part} by {}: {fmax:.1} MHz; not a Spartan figure\n",
                r.tool
            );
        }
    }
    if let Some(folder) = folder {
        out += &format!("wrote {}\n", folder.display());
    }
    out
}
