//! The output directory: frames, Verilog, reports.

use super::frames::Frames;
use super::{CosimError, CosimReport, Prelude};
use crate::compare::{difference_image, save_png, Rgb8Ref};
use shadegate_gen::write::{create_directory, write_file};
use std::path::Path;

/// Rows of the HTML report.
fn rows(r: &CosimReport) -> Vec<(&'static str, String)> {
    let error = |e: &super::ErrorReport| {
        let psnr = e
            .psnr_db
            .map_or("equal".to_string(), |p| format!("{p:.2} dB"));
        format!(
            "max {} LSB, RMS {:.3} LSB, PSNR {psnr}, FLIP {:.4}",
            e.max_lsb, e.rms_lsb, e.flip_mean
        )
    };
    let mismatch = r.first_mismatch.as_ref().map_or("none".to_string(), |m| {
        format!(
            "clock {}, {}: expected {}, got {}, at pixel {:?}",
            m.cycle, m.signal, m.expected, m.got, m.pixel
        )
    });
    vec![
        ("Scene", r.scene.clone()),
        (
            "Method, core, engine",
            format!("{}, {}, {}", r.method, r.core, r.engine),
        ),
        ("Frame", format!("{}×{}", r.width, r.height)),
        ("Mismatches", r.mismatches.to_string()),
        ("First mismatch", mismatch),
        (
            "Pixels per clock",
            format!(
                "{:.4} ({} pixels in {} clocks)",
                r.pixels_per_cycle, r.pixels, r.cycles
            ),
        ),
        (
            "Clocks simulated per second",
            match r.loop_cycles_per_second {
                Some(inside) => format!(
                    "{:.0}, in the simulation loop alone {inside:.0}",
                    r.cycles_per_second
                ),
                None => format!("{:.0}", r.cycles_per_second),
            },
        ),
        ("Error against exact", error(&r.error)),
        ("Error against the method in f64", error(&r.method_f64)),
        (
            "Arithmetic error",
            format!(
                "max {} LSB, RMS {:.4} LSB",
                r.arithmetic["max_lsb"], r.arithmetic["rms_lsb"]
            ),
        ),
        (
            "Proved bound before rounding",
            format!("{:.4} LSB", r.error_bound_lsb),
        ),
        ("Configuration", r.configuration.clone()),
    ]
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

fn html(r: &CosimReport) -> String {
    let table: String = rows(r)
        .iter()
        .map(|(k, v)| format!("<tr><th>{k}</th><td>{}</td></tr>\n", escape(v)))
        .collect();
    let pictures: String = [("expected", "Integer model"), ("simulated", "Engine"), ("method", "Method in f64"), ("exact", "Exact"), ("difference", "Simulated against exact")]
        .iter()
        .map(|(file, title)| format!("<figure><img src=\"{file}.png\" alt=\"{title}\"><figcaption>{title}</figcaption></figure>\n"))
        .collect();
    format!(
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>{0} · {1}</title>\n<style>\n\
         body{{font:16px system-ui;margin:2em;max-width:70em}} th{{text-align:left;padding-right:2em;font-weight:600}}\n\
         figure{{display:inline-block;margin:1em 1em 0 0}} img{{image-rendering:pixelated;max-width:100%}}\n</style>\n\
         <h1>{0} · {1} · {2}</h1>\n<table>\n{table}</table>\n{pictures}</html>\n",
        escape(&r.scene),
        escape(&r.method),
        escape(&r.engine)
    )
}

/// Writes everything below `directory`; the reports last, so that a report means that the rest is there.
pub fn write(
    directory: &Path,
    p: &Prelude,
    frames: &Frames,
    report: &CosimReport,
) -> Result<(), CosimError> {
    create_directory(directory)?;
    for f in &p.package.files {
        write_file(&directory.join("core").join(&f.path), f.text.as_bytes())?;
    }
    let view = |pixels| Rgb8Ref::new(p.prepared.width, p.prepared.height, pixels);
    let difference = difference_image(view(&frames.exact)?, view(&frames.simulated)?)?;
    for (name, pixels) in [
        ("expected", &frames.expected),
        ("simulated", &frames.simulated),
        ("method", &frames.method),
        ("exact", &frames.exact),
        ("difference", &difference),
    ] {
        save_png(&directory.join(format!("{name}.png")), view(pixels)?)?;
    }
    let json = serde_json::to_string_pretty(report).unwrap_or_default() + "\n";
    write_file(&directory.join("report.html"), html(report).as_bytes())?;
    write_file(&directory.join("report.json"), json.as_bytes())?;
    Ok(())
}
