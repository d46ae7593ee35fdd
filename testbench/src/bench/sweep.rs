//! The sweep: every method at every exponent, on every sphere, at every size.
//!
//! The *empty rasteriser* is the method `flat`, pixel by pixel, without its set-up: it walks the same spans, makes the same
//! depth test and writes one constant. What a method's drawing, also pixel by pixel, takes beyond it in the same round is
//! what its colours cost.

use super::clock::{in_turns, median, Effort};
use super::front::front;
use super::row::Row;
use super::scenes::Tessellation;
use super::select::Selection;
use super::{BenchError, OnStep};
use crate::compare::{compare, Comparison, Rgb8Ref};
use shadegate_reference::render::Vectors;
use shadegate_reference::{render, with_threads};
use shadegate_reference::{Frame, Method, Prepared, RenderOptions, RenderStats, Skips};
use std::time::Duration;

/// What is swept over, besides methods and scenes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Exponents of the highlight.
    pub exponents: Vec<u32>,
    /// Widths and heights of frames.
    pub sizes: Vec<(u32, u32)>,
    /// How long to measure.
    pub effort: Effort,
}

impl Grid {
    /// Everything.
    #[must_use]
    pub fn full() -> Self {
        Self {
            exponents: vec![5, 20, 50, 100],
            sizes: vec![(320, 240), (640, 480), (1280, 960)],
            effort: Effort::FULL,
        }
    }

    /// A first look: two exponents, one small size, few rounds.
    #[must_use]
    pub fn quick() -> Self {
        Self {
            exponents: vec![20, 100],
            sizes: vec![(160, 120)],
            effort: Effort::QUICK,
        }
    }
}

/// Options of every timed frame: one thread, every skip that the frame allows.
#[must_use]
pub fn one_thread() -> RenderOptions {
    RenderOptions {
        threads: Some(1),
        ..RenderOptions::default()
    }
}

/// The same, pixel by pixel.
#[must_use]
pub fn pixel_by_pixel() -> RenderOptions {
    RenderOptions {
        vectors: Vectors::None,
        ..one_thread()
    }
}

/// Measures. Each step is one scene at one exponent and size.
///
/// # Errors
/// When the scene cannot be prepared or frames cannot be compared.
pub fn sweep(
    selection: &Selection,
    grid: &Grid,
    on_step: &mut OnStep<'_>,
) -> Result<Vec<Row>, BenchError> {
    let total = selection.scenes.len() * grid.exponents.len() * grid.sizes.len();
    let (mut rows, mut done) = (Vec::new(), 0);
    for &scene in &selection.scenes {
        for &exponent in &grid.exponents {
            let made = scene.scene(exponent)?;
            for &(width, height) in &grid.sizes {
                let what = format!("{}, n = {exponent}, {width}x{height}", scene.name);
                on_step(done, total, &what);
                let prepare = || Prepared::new(&made, Some((width, height)), &Skips::all());
                let p = with_threads(one_thread().threads, prepare)?;
                rows.extend(task(scene, exponent, &p, &selection.methods, grid.effort)?);
                done += 1;
            }
        }
    }
    Ok(rows)
}

/// One scene at one exponent and size: a row for each method.
fn task(
    scene: Tessellation,
    exponent: u32,
    p: &Prepared,
    methods: &[Method],
    effort: Effort,
) -> Result<Vec<Row>, BenchError> {
    // The empty rasteriser runs in any case, as the first job; where it is listed too, it need not run twice.
    let mut jobs = vec![(Method::Flat, pixel_by_pixel())];
    for options in [one_thread(), pixel_by_pixel()] {
        for m in methods {
            if (*m, options.vectors) != (jobs[0].0, jobs[0].1.vectors) {
                jobs.push((*m, options));
            }
        }
    }
    let find = |method: Method, options: RenderOptions| {
        let same = |j: &(Method, RenderOptions)| (j.0, j.1.vectors) == (method, options.vectors);
        jobs.iter().position(same)
    };
    // Once each, to warm up, to see how long it takes and to have the frames.
    let first: Vec<(Frame, RenderStats)> = jobs.iter().map(|(m, o)| render(p, *m, o)).collect();
    let once: u64 = first.iter().map(|f| f.1.setup_ns + f.1.raster_ns).sum();
    let rounds = effort.rounds(Duration::from_nanos(once));
    let times = in_turns(jobs.len(), rounds, |job| {
        let s = render(p, jobs[job].0, &jobs[job].1).1;
        (s.setup_ns as f64, s.raster_ns as f64)
    });
    let empty = &times[0];
    let frame_time = |job: usize| median(times[job].iter().map(|t| t.0 + t.1));
    let truth = match find(Method::Exact, one_thread()) {
        Some(i) => first[i].0.clone(),
        None => render(p, Method::Exact, &RenderOptions::default()).0,
    };
    let mut rows = Vec::with_capacity(methods.len());
    for method in methods {
        let as_used = find(*method, one_thread());
        let (Some(job), Some(plain)) = (as_used, find(*method, pixel_by_pixel())) else {
            continue;
        };
        let (frame, stats) = &first[job];
        let colour = median(times[plain].iter().zip(empty).map(|(t, e)| t.1 - e.1));
        let setup = median(times[plain].iter().map(|t| t.0));
        let mut row = Row {
            scene: scene.name,
            method: method.name(),
            exponent,
            triangles: p.counts.in_,
            drawn: p.counts.drawn,
            width: p.width,
            height: p.height,
            pixels: stats.pixels_tested,
            ns_per_frame: frame_time(job),
            ns_per_frame_scalar: frame_time(plain),
            ns_setup: setup,
            ns_per_pixel: colour / stats.pixels_tested.max(1) as f64,
            ns_per_triangle: setup / p.counts.drawn.max(1) as f64,
            rounds,
            max_lsb: 0,
            rms_lsb: 0.0,
            psnr_db: None,
            flip_mean: 0.0,
            front_rms: false,
            front_max: false,
        };
        row.set_error(&apart(&truth, frame)?);
        rows.push(row);
    }
    mark_front(&mut rows);
    Ok(rows)
}

/// How far a frame is from another.
pub(super) fn apart(truth: &Frame, frame: &Frame) -> Result<Comparison, BenchError> {
    let a = Rgb8Ref::new(truth.width, truth.height, &truth.pixels)?;
    let b = Rgb8Ref::new(frame.width, frame.height, &frame.pixels)?;
    Ok(compare(a, b)?)
}

/// Marks the rows of one task that no other row of it beats.
fn mark_front(rows: &mut [Row]) {
    let by = |error: fn(&Row) -> f64| {
        let points: Vec<(f64, f64)> = rows.iter().map(|r| (r.ns_per_frame, error(r))).collect();
        front(&points)
    };
    let (rms, max) = (by(|r| r.rms_lsb), by(|r| r.max_lsb.into()));
    for (r, (rms, max)) in rows.iter_mut().zip(rms.into_iter().zip(max)) {
        (r.front_rms, r.front_max) = (rms, max);
    }
}

#[cfg(test)]
mod tests {
    use super::super::row::sample;
    use super::*;

    #[test]
    fn the_front_is_marked_for_each_error_of_its_own() {
        // name, time, max, rms
        let mut rows = [
            sample("a", 1.0, 9, 2.0),
            sample("b", 2.0, 3, 3.0),
            sample("c", 3.0, 3, 1.0),
            sample("d", 4.0, 0, 0.0),
        ];
        mark_front(&mut rows);
        assert_eq!(
            rows.each_ref().map(|r| r.front_rms),
            [true, false, true, true]
        );
        assert_eq!(
            rows.each_ref().map(|r| r.front_max),
            [true, true, false, true]
        );
    }

    #[test]
    fn a_small_sweep_has_a_row_for_every_method_and_the_truth_has_no_error() {
        let selection = Selection {
            scenes: vec![Tessellation::ALL[0]],
            ..Selection::default()
        };
        let grid = Grid {
            exponents: vec![20],
            sizes: vec![(64, 48)],
            effort: Effort::QUICK,
        };
        let mut steps = Vec::new();
        let rows = sweep(&selection, &grid, &mut |done, total, what| {
            steps.push((done, total, what.to_owned()));
        })
        .unwrap();
        assert_eq!(steps, [(0, 1, "sphere-168, n = 20, 64x48".to_owned())]);
        let names: Vec<&str> = rows.iter().map(|r| r.method).collect();
        let all: Vec<&str> = Method::ALL.iter().map(|m| m.name()).collect();
        assert_eq!(names, all);
        for r in &rows {
            assert_eq!((r.triangles, r.width, r.exponent), (168, 64, 20));
            assert!(r.drawn > 0 && r.drawn < 168 && r.pixels > 1000, "{r:?}");
            assert!(r.ns_per_frame > 0.0 && r.ns_setup <= r.ns_per_frame_scalar && r.rounds >= 3);
            if r.method == Method::Exact.name() {
                assert!(r.max_lsb == 0 && r.psnr_db.is_none(), "{r:?}");
            }
            if r.method == Method::Flat.name() {
                assert!(r.max_lsb > 20 && r.flip_mean > 0.0, "{r:?}");
            }
        }
        assert!(rows.iter().any(|r| r.method != "exact" && r.front_rms));
        // Whoever has no error and is fastest is on both fronts: `exact`, or a method that is as good.
        assert!(rows
            .iter()
            .any(|r| r.max_lsb == 0 && r.front_rms && r.front_max));
    }
}
