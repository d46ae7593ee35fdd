//! Two threads against one, on the sphere of 100 000 triangles.

use crate::report::Report;
use crate::turns::{cell, Job, Times, Took, PART, WHOLE};
use shadegate_reference::{render, with_threads, Method, Prepared, RenderOptions, Skips};
use shadegate_testbench::bench::clock::Effort;
use shadegate_testbench::bench::scenes::Tessellation;
use std::time::Instant;

const SIZE: (u32, u32) = (1280, 960);
const ABOUT: &str = "The sphere of 100 000 triangles at 1280x960, milliseconds. *Drawing* is `render`: set-up of the \
    method and of all triangles, then the frame. *Whole* adds what comes before: transform, culling, clipping, snapping. \
    Ratios are one thread over two, medians over rounds.";

/// Measures every method that the catalogue holds, `exact` apart.
pub fn compare(effort: Effort, report: &mut Report) -> Result<(), String> {
    let Some(sphere) = Tessellation::ALL.last() else {
        return Err("there is no sphere".to_owned());
    };
    let scene = sphere.scene(20).map_err(|e| e.to_string())?;
    let mut rows = Vec::new();
    for method in Method::ALL.iter().copied().filter(|m| *m != Method::Exact) {
        let frame = |threads: usize| {
            let begin = Instant::now();
            // The size is one that scenes may have.
            let Ok(p) = Prepared::new(&scene, Some(SIZE), &Skips::all()) else {
                return Took::NOTHING;
            };
            let before = begin.elapsed().as_nanos() as f64;
            let options = RenderOptions {
                threads: Some(threads),
                ..RenderOptions::default()
            };
            let s = render(&p, method, &options).1;
            let part = (s.setup_ns + s.raster_ns) as f64;
            Took {
                part,
                whole: before + part,
            }
        };
        let job = |threads: usize| -> Job<'_> {
            Box::new(move || with_threads(Some(threads), || frame(threads)))
        };
        let times = Times::measure(vec![job(1), job(2)], effort);
        let ms = |job, which| cell(times.ns(job, which), |ns| format!("{:.2}", ns / 1e6));
        let ratio = |which| cell(times.ratio((0, which), (1, which)), |r| format!("{r:.2}"));
        rows.push(vec![
            method.name().to_owned(),
            ms(0, PART),
            ms(1, PART),
            ratio(PART),
            ms(0, WHOLE),
            ms(1, WHOLE),
            ratio(WHOLE),
        ]);
    }
    report.section("Two threads against one", ABOUT);
    let headings = [
        "method",
        "drawing, one",
        "drawing, two",
        "ratio",
        "whole, one",
        "whole, two",
        "ratio",
    ];
    report.table(&headings, 1, &rows);
    Ok(())
}
