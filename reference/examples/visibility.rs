//! How the ways to decide what is seen compare, and two old claims measured again: `visibility SCENE...`.
//!
//! The claims (Loisel 1996): culling removes about half of the faces, vertices and edges of a closed object, and painter's
//! order is faster than a z-buffer below about 5000 polygons.

use shadegate_reference::mesh::{sphere, teapot};
use shadegate_reference::visibility::zbuffer::{Stored, Word};
use shadegate_reference::visibility::{bsp, painter, scanline, zbuffer};
use shadegate_reference::{scene, Prepared, Scene, SceneError, Skips};
use std::path::Path;
use std::time::Instant;

/// Median time of some runs, ns.
fn time<T>(mut f: impl FnMut() -> T) -> f64 {
    let mut all: Vec<f64> = (0..9)
        .map(|_| {
            let start = Instant::now();
            std::hint::black_box(f());
            start.elapsed().as_nanos() as f64
        })
        .collect();
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

fn main() -> Result<(), SceneError> {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let scenes = files
        .iter()
        .map(|f| scene::load(Path::new(f)))
        .collect::<Result<Vec<_>, _>>()?;
    for scene in &scenes {
        overdraw(scene)?;
    }
    if let Some(scene) = scenes.first() {
        preparation(scene)?;
        claims(scene)?;
    }
    Ok(())
}

/// Pixels written for each pixel seen.
fn overdraw(scene: &Scene) -> Result<(), SceneError> {
    let p = Prepared::new(scene, None, &Skips::all())?;
    let z = zbuffer::draw(&p, Stored::Real);
    let (painted, counts) = painter::draw(&p);
    print!(
        "{}: {} triangles, {} pixels seen; overdraw: z-buffer {:.3}, painter {:.3}",
        p.scene_name,
        p.triangles.len(),
        z.seen(),
        z.overdraw(),
        painted.overdraw()
    );
    // A tree over a convex object takes time with the square of its triangles.
    if p.triangles.len() < 10_000 {
        let tree = bsp::Tree::new(&p);
        print!(
            ", BSP {:.3} back to front and {:.3} front to back ({} splits)",
            tree.back_to_front(&p).overdraw(),
            tree.front_to_back(&p).overdraw(),
            tree.splits
        );
    }
    println!(", scan-line {:.3}", scanline::draw(&p).overdraw());
    println!("  painter's order: {counts:?}");
    Ok(())
}

/// The first scene with its object replaced.
fn with(scene: &Scene, mesh: shadegate_reference::mesh::Mesh) -> Scene {
    let mut scene = scene.clone();
    scene.objects.truncate(1);
    scene.objects[0].mesh = mesh;
    (scene.image.width, scene.image.height) = (640, 480);
    scene
}

/// What culling in object space saves.
fn preparation(scene: &Scene) -> Result<(), SceneError> {
    println!("preparation, ns per triangle, median of 9:");
    for (name, mesh) in [
        ("sphere", sphere::sphere(224, 224, 1.0)),
        ("teapot", teapot::teapot(40)),
    ] {
        let scene = with(scene, mesh);
        let n = scene.objects[0].mesh.triangles.len() as f64;
        let of = |without: &str| {
            let skips = Skips::without(without).unwrap_or_default();
            time(|| Prepared::new(&scene, None, &skips)) / n
        };
        let (all, late, none) = (of(""), of("vertex"), of("vertex,back-face"));
        println!(
            "  {name} of {n}: {all:.1}; all vertices transformed {late:.1} (x{:.2}); back faces kept {none:.1} (x{:.2})",
            late / all,
            none / all
        );
    }
    Ok(())
}

fn claims(scene: &Scene) -> Result<(), SceneError> {
    println!("removed by back-face culling, of closed objects at 640x480:");
    for (name, mesh) in [
        ("sphere", sphere::sphere(48, 32, 1.0)),
        (
            "torus",
            shadegate_reference::mesh::torus::torus(1.0, 0.4, 48, 24),
        ),
        ("box", shadegate_reference::mesh::solids::cube(1)),
        ("teapot", teapot::teapot(10)),
    ] {
        let scene = with(scene, mesh);
        let mesh = &scene.objects[0].mesh;
        let p = Prepared::new(&scene, None, &Skips::all())?;
        let count = |reason: &str| p.skipped.get(reason).copied().unwrap_or(0) as f64;
        println!(
            "  {name}: faces {:.1} %, vertices {:.1} %",
            100.0 * count("back-face") / mesh.triangles.len() as f64,
            100.0 * count("vertex") / mesh.positions.len() as f64
        );
    }
    println!("painter's order (sort by farthest vertex, fill) over z-buffer, time, 640x480, median of 9:");
    for (slices, stacks) in [
        (8, 6),
        (23, 16),
        (48, 48),
        (96, 96),
        (160, 160),
        (224, 224),
        (320, 320),
    ] {
        let scene = with(scene, sphere::sphere(slices, stacks, 1.0));
        for skips in ["", "back-face"] {
            let skips = Skips::without(skips).unwrap_or_default();
            let p = Prepared::new(&scene, None, &skips)?;
            let word = Word::of(&p, 16);
            let real = time(|| zbuffer::draw(&p, Stored::Real));
            let inverse = time(|| zbuffer::draw(&p, Stored::Inverse(word)));
            let sorted = time(|| painter::draw_by_farthest(&p));
            println!(
                "  {:6} triangles drawn: {:.2} of z as a real number, {:.2} of 1/z in 16 bits",
                p.triangles.len(),
                sorted / real,
                sorted / inverse
            );
        }
    }
    Ok(())
}
