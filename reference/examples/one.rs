//! scratch
use shadegate_reference::raster::Point;
use shadegate_reference::shade::Surroundings;
use shadegate_reference::{render, scene, Prepared, RenderOptions, ScreenTriangle};
use std::path::Path;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let scene = scene::load(Path::new(&a[1])).unwrap();
    let m = a[2].parse().unwrap();
    let s: i32 = a[3].parse().unwrap();
    let one = RenderOptions {
        threads: Some(1),
        ..RenderOptions::default()
    };
    let q = |x: i32, y: i32| Point {
        x: x * s + 128,
        y: y * s + 128,
    };
    let t = ScreenTriangle {
        position: [q(16, 33), q(240, 190), q(130, 21)],
        inv_w: [1.0; 3],
        depth: [0.1, 0.5, 0.9],
        world: [glam::DVec3::ZERO; 3],
        normal: [glam::DVec3::Z, glam::DVec3::Y, glam::DVec3::X],
        material: 0,
        object: 0,
        face: 0,
    };
    let count = 4_000_000 / (s * s) as usize + 1;
    let all: Vec<_> = (0..count)
        .map(|i| ScreenTriangle {
            depth: t.depth.map(|d| d * 0.01 + 0.9 * i as f64 / count as f64),
            ..t
        })
        .collect();
    let p = Prepared::from_triangles((s as u32, s as u32), [0; 3], all, Surroundings::new(&scene));
    let mut px = 0;
    for _ in 0..50 {
        px += render(&p, m, &one).1.pixels_written;
    }
    println!("{px}");
}
