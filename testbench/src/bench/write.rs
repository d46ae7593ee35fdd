//! The files of results: rows as CSV and JSON, tables as Markdown, a picture for each scene and size.

use super::machine::Machine;
use super::papers::Claim;
use super::plot;
use super::row::{csv, Row};
use super::skips::SkipRow;
use super::within;
use super::BenchError;
use serde_json::{json, Value};
use std::fmt::Write;

/// A file by its name in the folder of results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Name.
    pub name: String,
    /// Contents.
    pub text: String,
}

/// What the JSON says: the machine and the rows.
#[must_use]
pub fn json(machine: &Machine, rows: &[Row]) -> Value {
    json!({
        "machine": machine,
        "threads": 1,
        "empty_rasteriser": "flat, pixel by pixel, drawing without set-up",
        "rows": rows,
    })
}

/// All files of a sweep.
///
/// # Errors
/// When a picture cannot be drawn.
pub fn files(machine: &Machine, rows: &[Row]) -> Result<Vec<File>, BenchError> {
    let file = |name: &str, text: String| File {
        name: name.to_owned(),
        text,
    };
    let mut out = vec![
        file("bench.csv", csv(rows)),
        file("bench.json", format!("{:#}\n", json(machine, rows))),
        file("bench.md", markdown(machine, rows)),
    ];
    for group in groups(rows, |a, b| {
        (a.scene, a.width, a.height) == (b.scene, b.width, b.height)
    }) {
        let r = group[0];
        let name = format!("{}-{}x{}.svg", r.scene, r.width, r.height);
        out.push(file(&name, plot::svg(&group)?));
    }
    Ok(out)
}

/// Rows that belong together, in the order of their first ones; no group is empty.
#[must_use]
pub fn groups(rows: &[Row], same: impl Fn(&Row, &Row) -> bool) -> Vec<Vec<&Row>> {
    let mut out: Vec<Vec<&Row>> = Vec::new();
    for r in rows {
        match out.iter_mut().find(|g| same(g[0], r)) {
            Some(group) => group.push(r),
            None => out.push(vec![r]),
        }
    }
    out
}

/// The tables: for each task the methods from fast to slow.
fn markdown(machine: &Machine, rows: &[Row]) -> String {
    let mut out = head("Run time against error", "bench", machine);
    out += "## The fastest method within an error\n\nThe error is the largest difference of a channel from `exact`.\n\n";
    out += &within::table(rows);
    out.push('\n');
    for mut group in groups(rows, Row::same_task) {
        let first = group[0];
        // Writing to a string cannot fail.
        let _ = write!(
            out,
            "## {}, n = {}, {}x{}\n\n{} triangles, {} drawn; {} pixels; medians of {} rounds.\n\n\
             | method | ms per frame | pixel by pixel, ms | set-up, ns per triangle | colour, ns per pixel | max LSB | RMS LSB | PSNR dB | \
             FLIP | front |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---|\n",
            first.scene,
            first.exponent,
            first.width,
            first.height,
            first.triangles,
            first.drawn,
            first.pixels,
            first.rounds,
        );
        group.sort_by(|a, b| a.ns_per_frame.total_cmp(&b.ns_per_frame));
        for r in group {
            let _ = writeln!(
                out,
                "| {} | {:.3} | {:.3} | {:.1} | {:.2} | {} | {:.4} | {} | {:.6} | {} |",
                r.method,
                r.ns_per_frame / 1e6,
                r.ns_per_frame_scalar / 1e6,
                r.ns_per_triangle,
                r.ns_per_pixel,
                r.max_lsb,
                r.rms_lsb,
                r.psnr_db.map_or("∞".to_owned(), |p| format!("{p:.2}")),
                r.flip_mean,
                front_name(r),
            );
        }
        out.push('\n');
    }
    out
}

/// The head of a file of tables.
fn head(title: &str, command: &str, machine: &Machine) -> String {
    format!(
        "# {title}\n\nWritten by `shadegate {command}`; docs/bench.md says how to read it. {machine}, one thread.\n\n"
    )
}

/// The file of what skips save.
#[must_use]
pub fn skip_files(machine: &Machine, rows: &[SkipRow]) -> Vec<File> {
    let mut text = head("What skips save", "bench --skips", machine);
    text += "| scene | method | skip | count | without, ms | with, ms | alone, times | among all, times | max LSB |\n\
             |---|---|---|---:|---:|---:|---:|---:|---:|\n";
    for r in rows {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {:.3} | {:.3} | {:.3} | {:.3} | {} |",
            r.scene,
            r.method,
            r.skip,
            r.count,
            r.ns_without / 1e6,
            r.ns_with / 1e6,
            r.speedup_alone,
            r.speedup_among_all,
            r.max_lsb,
        );
    }
    let json = json!({ "machine": machine, "threads": 1, "skips": rows });
    both("skips", text, &json)
}

/// The file of the papers' claims.
#[must_use]
pub fn claim_files(machine: &Machine, claims: &[Claim]) -> Vec<File> {
    let mut text = head("The papers' comparisons", "bench --papers", machine);
    text +=
        "| source | what | unit | paper | ours | reproduced | |\n|---|---|---|---:|---:|---|---|\n";
    for c in claims {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} |",
            c.source,
            c.what,
            c.unit,
            c.figure(c.paper),
            c.figure(c.ours),
            c.verdict(),
            c.note,
        );
    }
    let json = json!({ "machine": machine, "threads": 1, "claims": claims });
    both("papers", text, &json)
}

fn both(name: &str, markdown: String, json: &Value) -> Vec<File> {
    [("md", markdown), ("json", format!("{json:#}\n"))]
        .map(|(ending, text)| File {
            name: format!("{name}.{ending}"),
            text,
        })
        .into()
}

/// On which front a row is, in a word.
#[must_use]
pub fn front_name(r: &Row) -> &'static str {
    match (r.front_rms, r.front_max) {
        (true, true) => "both",
        (true, false) => "RMS",
        (false, true) => "max",
        (false, false) => "",
    }
}

#[cfg(test)]
mod tests {
    use super::super::row::sample;
    use super::*;

    #[test]
    fn a_file_of_each_kind_and_a_picture_for_each_scene_and_size() {
        let mut rows = vec![
            sample("flat", 2e6, 90, 12.0),
            sample("gouraud", 1e6, 20, 3.0),
        ];
        let mut other = sample("flat", 3e6, 80, 11.0);
        other.exponent = 50;
        rows.push(other.clone());
        other.width = 640;
        rows.push(other);
        let files = files(&Machine::here(), &rows).unwrap();
        let names: Vec<&str> = files.iter().map(|f| f.name.as_str()).collect();
        assert_eq!(
            names,
            [
                "bench.csv",
                "bench.json",
                "bench.md",
                "sphere-690-320x240.svg",
                "sphere-690-640x240.svg"
            ]
        );
        let json: Value = serde_json::from_str(&files[1].text).unwrap();
        assert_eq!(json["rows"].as_array().unwrap().len(), 4);
        assert_eq!(json["rows"][1]["method"], "gouraud");
        assert!(json["rows"][0]["psnr_db"].is_number());
        let md = &files[2].text;
        assert_eq!(md.matches("\n## ").count(), 4);
        let (answer, tables) = md.split_once("\n## sphere-690, n = 20").unwrap();
        assert!(answer.contains("| gouraud 1.000 ms |"), "{answer}");
        // From fast to slow.
        assert!(
            tables.find("| gouraud |").unwrap() < tables.find("| flat |").unwrap(),
            "{md}"
        );
    }
}
