//! Draws scenes with every method and prints times and errors against `exact`: `measure [-o DIR] SCENE...`.

use shadegate_reference::{render, scene, Frame, Method, Prepared, RenderOptions, Skips};
use std::path::Path;

fn main() {
    let mut args: Vec<String> = std::env::args().skip(1).collect();
    let out = (args.first().map(String::as_str) == Some("-o")).then(|| {
        args.remove(0);
        args.remove(0)
    });
    println!(
        "{:14} {:9} {:>8} {:>8} {:>8} {:>8} {:>9} {:>9}",
        "scene", "method", "drawn", "pixels", "max", "rms", "setup us", "raster us"
    );
    for file in &args {
        let scene = match scene::load(Path::new(file)) {
            Ok(s) => s,
            Err(e) => {
                println!("{e}");
                continue;
            }
        };
        let p = match Prepared::new(&scene, None, &Skips::all()) {
            Ok(p) => p,
            Err(e) => {
                println!("{e}");
                continue;
            }
        };
        let options = RenderOptions::default();
        let (truth, _) = render(&p, Method::Exact, &options);
        for m in Method::ALL.iter().copied() {
            let mut runs: Vec<_> = (0..5).map(|_| render(&p, m, &options)).collect();
            runs.sort_by_key(|r| r.1.setup_ns + r.1.raster_ns);
            let (frame, stats) = &runs[2];
            let (max, rms) = difference(&truth, frame);
            println!(
                "{:14} {:9} {:8} {:8} {:8.0} {:8.3} {:9} {:9}",
                p.scene_name,
                m,
                p.triangles.len(),
                stats.pixels_tested,
                max,
                rms,
                stats.setup_ns / 1000,
                stats.raster_ns / 1000
            );
            if let Some(dir) = &out {
                if let Err(e) =
                    frame.save_png(&Path::new(dir).join(format!("{}-{m}.png", p.scene_name)))
                {
                    println!("{e}");
                }
            }
        }
        println!("{:14} {:?} {:?}", "", p.counts, p.skipped);
    }
}

fn difference(a: &Frame, b: &Frame) -> (f64, f64) {
    let (mut max, mut sum, mut n) = (0.0f64, 0.0, 0.0);
    for (p, q) in a.pixels.iter().flatten().zip(b.pixels.iter().flatten()) {
        let d = (f64::from(*p) - f64::from(*q)).abs();
        max = max.max(d);
        sum += d * d;
        n += 1.0;
    }
    (max, (sum / n).sqrt())
}
