//! The triangles as Shadegate draws them: with the depth test, on one thread.

use super::shape::{Triangle, SIDE};
use shadegate_reference::raster::Point;
use shadegate_reference::shade::Surroundings;
use shadegate_reference::{render, Frame, Method, Prepared, RenderStats, ScreenTriangle, Skips};
use shadegate_testbench::bench::scenes::Tessellation;
use shadegate_testbench::bench::sweep::one_thread;

/// The triangles on the screen. Colours come from light on normals here, so the corners get normals and a light that
/// give them colours apart; what they are has no influence on the time.
pub fn prepare(triangles: &[Triangle]) -> Result<Prepared, String> {
    let scene = Tessellation::of_690()
        .scene(20)
        .map_err(|e| e.to_string())?;
    let whole = Prepared::new(&scene, None, &Skips::all()).map_err(|e| e.to_string())?;
    let Some(like) = whole.triangles.first() else {
        return Err("the scene has no triangle".to_owned());
    };
    let all = triangles.iter().map(|t| screen(t, like)).collect();
    let surroundings = Surroundings::new(&scene);
    Ok(Prepared::from_triangles(
        (SIDE, SIDE),
        [0; 3],
        all,
        surroundings,
    ))
}

fn screen(t: &Triangle, like: &ScreenTriangle) -> ScreenTriangle {
    let mut out = *like;
    for (i, c) in t.iter().enumerate() {
        // In range: the shape stays in the frame.
        out.position[i] = Point::snap(c.x.into(), c.y.into()).unwrap_or_default();
        out.depth[i] = c.depth.into();
        out.inv_w[i] = 1.0;
    }
    out
}

/// A frame, and what it took.
pub fn draw(p: &Prepared, method: Method) -> (Frame, RenderStats) {
    render(p, method, &one_thread())
}
