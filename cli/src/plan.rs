//! `shadegate plan`: what a scene needs of a core, unit by unit, and why.

use crate::args::Global;
use crate::outcome::{Failure, Outcome, Report};
use crate::progress::Progress;
use crate::render::parse_error;
use crate::size;
use crate::table::Table;
use clap::Args;
use serde_json::{json, Value};
use shadegate_reference::animation::Player;
use shadegate_reference::needs::{Needs, Range, Unit};
use shadegate_reference::{scene, Prepared, Skips};
use std::path::PathBuf;

/// Arguments of `plan`.
#[derive(Debug, Args)]
#[command(
    after_help = "All frames of an animated scene are looked at. Which way of shading is enough is proved, not sampled; all \
                  other figures are exact. What is not drawn asks for nothing."
)]
pub struct PlanArgs {
    /// Scene file
    scene: PathBuf,
    /// What shading may be off, in 255ths of full scale, beside the rounding to a byte
    #[arg(long, value_name = "LSB", default_value = "1")]
    max_error: String,
    /// Frame size [default: the scene's]
    #[arg(long, value_name = "WxH")]
    size: Option<String>,
}

/// Runs the command.
pub fn run(a: &PlanArgs, global: Global) -> Outcome {
    let error = parse_error(&a.max_error)?;
    let size = a.size.as_deref().map(size::parse).transpose()?;
    let progress = Progress::new("reading the scene", global);
    let scene = scene::load(&a.scene).map_err(Failure::input)?;
    let count = scene.animation.as_ref().map_or(1, |a| a.frames);
    let name = scene.name.clone();
    let mut player = Player::new(scene);
    let mut all: Option<Needs> = None;
    for k in 0..count {
        progress.at(k as usize, count as usize, "frames");
        let frame = player.at(f64::from(k));
        let prepared = Prepared::new(frame, size, &Skips::all()).map_err(Failure::input)?;
        let needs = Needs::of(&prepared, error);
        all = Some(match all {
            Some(all) => all.join(&needs),
            None => needs,
        });
    }
    drop(progress);
    let needs = all.ok_or_else(|| Failure::input("the scene has no frames"))?;
    let units = needs.units(error);
    let text = match global.quiet {
        true => String::new(),
        false => text(&name, count, &needs, &units),
    };
    let json = json!({
        "scene": name,
        "frames": count,
        "width": needs.width,
        "height": needs.height,
        "max_error": error,
        "shading": needs.shading(),
        "needs": needs_json(&needs),
        "units": units.iter().map(|u| json!({
            "unit": u.name, "needed": u.needed, "because": u.because,
        })).collect::<Vec<_>>(),
    });
    Ok(Report::done(text, json))
}

fn between(r: Range, digits: usize) -> String {
    match r.is_none() {
        true => "-".to_owned(),
        false => format!("{:.digits$} to {:.digits$}", r.least, r.most),
    }
}

fn text(name: &str, frames: u32, n: &Needs, units: &[Unit]) -> String {
    let of = if frames == 1 {
        String::new()
    } else {
        format!(", {frames} frames")
    };
    let mut out = format!("{name}, {}x{}{of}\n\n", n.width, n.height);
    let mut table = Table::new(&["unit", "needed", "because"]);
    for u in units {
        let needed = if u.needed { "yes" } else { "no" };
        table.row([u.name.to_owned(), needed.to_owned(), u.because.clone()]);
    }
    out += &table.text();
    out.push('\n');
    let mut table = Table::new(&["what", "how far"]);
    let mut row = |what: &str, figure: String| table.row([what.to_owned(), figure]);
    row(
        "triangles",
        format!("{}, of which {} cover no pixel", n.triangles, n.empty),
    );
    row("pixels", n.pixels.to_string());
    row(
        "longest span, rows",
        format!("{}, {}", n.longest_span, n.most_rows),
    );
    row("most additions", n.longest_run.to_string());
    row("columns", between(n.columns, 2));
    row("rows", between(n.rows, 2));
    row("depth", between(n.depth, 4));
    row("depth from pixel to pixel", format!("{:.6}", n.depth_slope));
    row("colours, LSB", between(n.colour, 1));
    row(
        "colour from pixel to pixel",
        format!("{:.3}", n.colour_slope),
    );
    row(
        "normals along an edge",
        format!("{:.2} degrees", n.curvature),
    );
    out + &table.text()
}

fn needs_json(n: &Needs) -> Value {
    let range = |r: Range| match r.is_none() {
        true => Value::Null,
        false => json!([r.least, r.most]),
    };
    json!({
        "triangles": n.triangles,
        "empty": n.empty,
        "pixels": n.pixels,
        "deepest": n.deepest,
        "longest_span": n.longest_span,
        "most_rows": n.most_rows,
        "longest_run": n.longest_run,
        "columns": range(n.columns),
        "rows": range(n.rows),
        "depth": range(n.depth),
        "depth_slope": n.depth_slope,
        "colour": range(n.colour),
        "colour_slope": n.colour_slope,
        "curvature_degrees": n.curvature,
        "perspective": n.perspective,
        "exponents": n.exponents,
        "materials": n.materials,
        "textures": n.textures,
        "bumps": n.bumps,
        "lights": {
            "directional": n.lights.directional,
            "point": n.lights.point,
            "spot": n.lights.spot,
        },
        "lines": n.lines,
        "orders": {
            "constant": n.orders.constant,
            "linear": n.orders.linear,
            "quadratic": n.orders.quadratic,
            "products": n.orders.products,
            "per_pixel": n.orders.per_pixel,
        },
    })
}
