//! `shadegate compare`: how far two images are apart.

use crate::args::Global;
use crate::measures::{error_json, error_text};
use crate::outcome::{Exit, Failure, Outcome, Report};
use crate::output;
use clap::Args;
use serde_json::json;
use shadegate_testbench::compare::{
    compare, difference_image, load_png, save_png, Comparison, Rgb8Image, Rgb8Ref,
};
use std::fmt::Write;
use std::path::PathBuf;

/// Arguments of `compare`.
#[derive(Debug, Args)]
#[command(
    after_help = "Exit codes: 0 the images are equal; 1 they differ; 2 they cannot be compared."
)]
pub struct CompareArgs {
    /// The reference
    a: PathBuf,
    /// The image to judge
    b: PathBuf,
    /// Picture of the differences: black where equal, one LSB already visible
    #[arg(short, long, value_name = "DIFF.png")]
    output: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &CompareArgs, global: Global) -> Outcome {
    if let Some(file) = &args.output {
        output::file(file, "png")?;
        output::not_over(file, &args.a)?;
        output::not_over(file, &args.b)?;
    }
    let load = |path: &PathBuf| load_png(path).map_err(Failure::input);
    let (a, b) = (load(&args.a)?, load(&args.b)?);
    let c = compare(a.view(), b.view()).map_err(Failure::input)?;
    if let Some(file) = &args.output {
        save_difference(file, &a, &b)?;
    }
    let output = args.output.as_ref().map(|f| f.to_string_lossy());
    let mut json = error_json(&c);
    json["a"] = args.a.to_string_lossy().into();
    json["b"] = args.b.to_string_lossy().into();
    json["pixels"] = c.pixels.into();
    json["differing"] = c.differing.into();
    json["first_mismatch"] = json!(c.first_mismatch);
    json["histogram"] = json!(c.histogram);
    json["output"] = json!(output);
    let mut text = if global.quiet {
        String::new()
    } else {
        text(&c, global.verbose)
    };
    if let Some(file) = output.filter(|_| !global.quiet) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "wrote {file}");
    }
    let exit = if c.equal() {
        Exit::Done
    } else {
        Exit::CheckFailed
    };
    Ok(Report { text, json, exit })
}

fn save_difference(file: &std::path::Path, a: &Rgb8Image, b: &Rgb8Image) -> Result<(), Failure> {
    let pixels = difference_image(a.view(), b.view()).map_err(Failure::input)?;
    let (width, height) = (a.view().width(), a.view().height());
    Rgb8Ref::new(width, height, &pixels)
        .and_then(|d| save_png(file, d))
        .map_err(Failure::input)
}

fn text(c: &Comparison, verbose: bool) -> String {
    let mut out = match c.differing {
        0 => format!("{} pixels, all equal\n", c.pixels),
        n => format!("{} pixels, {n} differ\n", c.pixels),
    };
    out += &error_text(c);
    if let Some(m) = c.first_mismatch {
        let colour = |[r, g, b]: [u8; 3]| format!("{r} {g} {b}");
        let _ = writeln!(
            out,
            "first difference at column {}, row {}: {} and {}",
            m.x,
            m.y,
            colour(m.a),
            colour(m.b)
        );
    }
    if verbose {
        out += "channels by difference in LSB\n";
        for (d, count) in c.histogram.iter().enumerate().filter(|(_, n)| **n > 0) {
            let _ = writeln!(out, "  {d:>3}  {count}");
        }
    }
    out
}
