//! Times of the fast renderer on one thread: fill rates of one right-angled triangle shape, and whole frames of scenes:
//! `fill [SCENE...]`. Every figure is the median of many runs.

use shadegate_reference::raster::Point;
use shadegate_reference::render::Vectors;
use shadegate_reference::shade::Surroundings;
use shadegate_reference::{render, scene, Method, Prepared, RenderOptions, ScreenTriangle, Skips};
use std::path::Path;
use std::time::Instant;

fn median(mut run: impl FnMut(), least: usize) -> f64 {
    let mut times: Vec<f64> = (0..least)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let one = RenderOptions {
        threads: Some(1),
        ..RenderOptions::default()
    };
    for file in &files {
        let scene = match scene::load(Path::new(file)) {
            Ok(s) => s,
            Err(e) => {
                println!("{e}");
                continue;
            }
        };
        let prepare = median(|| drop(Prepared::new(&scene, None, &Skips::all())), 51);
        let Ok(p) = Prepared::new(&scene, None, &Skips::all()) else {
            continue;
        };
        println!("{file}: prepare {:.1} us", prepare * 1e6);
        for m in Method::ALL.iter().copied() {
            let mut line = format!("  {m:12}");
            for vectors in [Vectors::Widest, Vectors::Baseline, Vectors::None] {
                let o = RenderOptions { vectors, ..one };
                let count = if m == Method::Exact { 3 } else { 51 };
                let t = median(|| drop(render(&p, m, &o)), count);
                line += &format!(" {vectors:?} {:9.1} us", t * 1e6);
            }
            println!("{line}");
        }
    }
    let Some(Ok(scene)) = files.first().map(|f| scene::load(Path::new(f))) else {
        return;
    };
    for s in [4, 16, 64, 256, 1024] {
        let q = |x: i32, y: i32| Point {
            x: x * s + 128,
            y: y * s + 128,
        };
        let t = ScreenTriangle {
            position: [q(16, 33), q(240, 190), q(130, 21)],
            inv_w: [1.0; 3],
            depth: [0.1, 0.5, 0.9],
            world: [glam::DVec3::ZERO; 3],
            uv: [glam::DVec2::ZERO; 3],
            normal: [glam::DVec3::Z, glam::DVec3::Y, glam::DVec3::X],
            material: 0,
            object: 0,
            face: 0,
        };
        let count = 4_000_000 / (s * s) as usize + 1;
        // Nearer and nearer, so that every pixel is written.
        let all = (0..count)
            .map(|i| ScreenTriangle {
                depth: t.depth.map(|d| d * 0.01 + 0.9 * i as f64 / count as f64),
                ..t
            })
            .collect();
        let p =
            Prepared::from_triangles((s as u32, s as u32), [0; 3], all, Surroundings::new(&scene));
        for m in [Method::Flat, Method::Gouraud, Method::Quadratic] {
            let mut pixels = 0;
            let time = median(
                || {
                    let (_, stats) = render(&p, m, &one);
                    pixels = stats.pixels_written;
                },
                21,
            );
            println!(
                "{s:5} {m:10} {:8.1} ns/triangle {:8.1} Mpix/s",
                time * 1e9 / count as f64,
                pixels as f64 / time / 1e6
            );
        }
    }
}
