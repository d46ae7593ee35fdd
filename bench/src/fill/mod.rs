//! Fill rate: triangles of one shape in five sizes, by us, retrofire and, where it is installed, Mesa.

mod mesa;
mod ours;
mod retrofire;
mod shape;

use crate::report::Report;
use crate::turns::{cell, time, Job, Times, Took, PART, WHOLE};
use mesa::Mesa;
use retrofire::Retrofire;
use shadegate_reference::{Method, Prepared};
use shadegate_testbench::bench::clock::Effort;
use shape::Triangle;
use std::cell::RefCell;

const ABOUT: &str = "Right triangles with two sides of `size` pixels, in layers from back to front, one thread. \
    Nanoseconds per triangle, in parentheses megapixels per second. Ours and *Mesa, z* clear the frame and test depth; \
    retrofire does neither; *retrofire, f32* also leaves colours as they are instead of making bytes of them. *Drawing* is ours without what it works out for all triangles first, which includes the light \
    at their corners, where the others are given colours; *frame* is ours with it. Ratios are the peer's time over ours, \
    medians over rounds: above 1 ours is faster.";

/// What is drawn.
struct Fill {
    name: &'static str,
    method: Method,
    /// As retrofire draws it.
    retrofire: fn(&mut Retrofire),
    /// The same without the conversion to bytes, where there is one.
    unconverted: Option<fn(&mut Retrofire)>,
    /// Whether Mesa is to interpolate colours.
    smooth: bool,
}

const FILLS: [Fill; 2] = [
    Fill {
        name: "gouraud",
        method: Method::Gouraud,
        retrofire: Retrofire::gouraud,
        unconverted: Some(Retrofire::gouraud_unconverted),
        smooth: true,
    },
    Fill {
        name: "flat",
        method: Method::Flat,
        retrofire: Retrofire::flat,
        unconverted: None,
        smooth: false,
    },
];

/// The places of the jobs in [`Times`].
const OURS: usize = 0;
const RETROFIRE: usize = 1;
const UNCONVERTED: usize = 2;
const MESA_Z: usize = 3;
const MESA: usize = 4;

/// Measures every size.
pub fn compare(effort: Effort, report: &mut Report) -> Result<(), String> {
    let (mesa, said) = match Mesa::open() {
        Ok(m) => {
            let said = format!("Mesa is {}.", m.name);
            (Some(RefCell::new(m)), said)
        }
        Err(why) => (None, format!("{why}.")),
    };
    eprintln!("{said}");
    report.section("Fill", &format!("{ABOUT} {said}"));
    let mut rows = Vec::new();
    for fill in &FILLS {
        for (size, layers) in shape::SIZES {
            let triangles = shape::triangles(size, layers);
            let mut row = vec![fill.name.to_owned(), size.to_string()];
            row.extend(one(fill, &triangles, mesa.as_ref(), effort)?);
            rows.push(row);
        }
    }
    let headings = [
        "fill",
        "size",
        "ours, drawing",
        "ours, frame",
        "retrofire",
        "retrofire, f32",
        "Mesa, z",
        "Mesa, no z",
        "retrofire / drawing",
        "retrofire / frame",
        "retrofire, f32 / frame",
        "Mesa, z / frame",
    ];
    report.table(&headings, 1, &rows);
    Ok(())
}

/// Cells of a row: times, then ratios.
fn one(
    fill: &Fill,
    triangles: &[Triangle],
    mesa: Option<&RefCell<Mesa>>,
    effort: Effort,
) -> Result<Vec<String>, String> {
    let p = ours::prepare(triangles)?;
    let mut peer = Retrofire::new(triangles);
    if let Some(m) = mesa {
        m.borrow_mut().take(triangles);
    }
    let pixels = same_pixels(fill, &p, &mut peer, mesa)?;
    let peer = RefCell::new(peer);
    let mut jobs: Vec<Job<'_>> = vec![
        Box::new(|| {
            let s = ours::draw(&p, fill.method).1;
            Took {
                part: s.raster_ns as f64,
                whole: (s.setup_ns + s.raster_ns) as f64,
            }
        }),
        Box::new(|| time(|| (fill.retrofire)(&mut peer.borrow_mut()))),
        Box::new(|| match fill.unconverted {
            Some(draw) => time(|| draw(&mut peer.borrow_mut())),
            None => Took::NOTHING,
        }),
    ];
    if let Some(m) = mesa {
        for depth_test in [true, false] {
            jobs.push(Box::new(move || {
                time(|| m.borrow_mut().draw(depth_test, fill.smooth))
            }));
        }
    }
    let times = Times::measure(jobs, effort);
    let each = |(job, which)| {
        cell(times.ns(job, which), |ns| {
            let rate = pixels as f64 / ns * 1e3;
            format!("{:.0} ({rate:.0})", ns / triangles.len() as f64)
        })
    };
    let mut row: Vec<String> = [
        (OURS, PART),
        (OURS, WHOLE),
        (RETROFIRE, WHOLE),
        (UNCONVERTED, WHOLE),
        (MESA_Z, WHOLE),
        (MESA, WHOLE),
    ]
    .map(each)
    .into();
    for (peer, which) in [
        (RETROFIRE, PART),
        (RETROFIRE, WHOLE),
        (UNCONVERTED, WHOLE),
        (MESA_Z, WHOLE),
    ] {
        row.push(cell(times.ratio((peer, WHOLE), (OURS, which)), |r| {
            format!("{r:.2}")
        }));
    }
    Ok(row)
}

/// Pixels that the triangles cover, each counted once per triangle; refused when the renderers do not cover the same
/// places, since then they would not do the same work. A pixel in ten thousand is granted to peers that walk in f32.
fn same_pixels(
    fill: &Fill,
    p: &Prepared,
    peer: &mut Retrofire,
    mesa: Option<&RefCell<Mesa>>,
) -> Result<u64, String> {
    let (frame, stats) = ours::draw(p, fill.method);
    if stats.pixels_written != stats.pixels_tested {
        return Err("a layer hides another one".to_owned());
    }
    let ours = frame.pixels.iter().filter(|c| **c != [0; 3]).count() as u64;
    (fill.retrofire)(peer);
    let mut counts = vec![("retrofire", peer.covered())];
    if let Some(m) = mesa {
        m.borrow_mut().draw(true, fill.smooth);
        counts.push(("Mesa", m.borrow().covered()));
    }
    for (name, theirs) in counts {
        if theirs.abs_diff(ours) > ours / 10_000 {
            return Err(format!("we cover {ours} pixels and {name} {theirs}"));
        }
    }
    Ok(stats.pixels_tested)
}
