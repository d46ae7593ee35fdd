//! How far anything moves on the screen between two times, at most.
//!
//! A point p of an object is at N·p + n in view space, with N and n changing from time to time. Its movement is affine in
//! p, so that no point of a box moves farther than the farthest of its corners, δ. On the screen, nowhere nearer than
//! w_min and nowhere farther from the axis than τ·w, that is at most f·(1 + τ)·δ/w_min pixels (f·δ without perspective).
//! Movements between many times are added up, so that what goes round in circles has gone far.

use crate::animation::Player;
use crate::geometry::camera::View;
use crate::geometry::cull::corners;
use glam::DVec3;

/// The places of an object's corners in view space at one time.
struct Places {
    corners: [DVec3; 8],
}

/// At most so many pixels of a frame of this size does any point of the scene move between the first and the last of
/// these times; infinite where something comes as near as the near plane.
pub(super) fn at_most(player: &mut Player, times: &[f64], (width, height): (u32, u32)) -> f64 {
    let mut before: Option<Vec<Option<Places>>> = None;
    let mut farthest: Vec<f64> = Vec::new();
    let boxes: Vec<_> = player
        .at(times.first().copied().unwrap_or(0.0))
        .objects
        .iter()
        .map(|o| corners(&o.mesh.positions))
        .collect();
    for time in times {
        let scene = player.at(*time);
        let view = View::new(&scene.camera, width, height);
        let near = scene.camera.near;
        let places: Vec<Option<Places>> = scene
            .objects
            .iter()
            .zip(&boxes)
            .map(|(o, corners)| {
                let to_view = view.to_view() * o.transform;
                corners.map(|c| Places {
                    corners: c.map(|p| to_view.transform_point3(p)),
                })
            })
            .collect();
        if let Some(before) = &before {
            farthest.resize(places.len(), 0.0);
            for (sum, pair) in farthest.iter_mut().zip(before.iter().zip(&places)) {
                if let (Some(a), Some(b)) = pair {
                    *sum += step(&view, near, a, b);
                }
            }
        }
        before = Some(places);
    }
    farthest.into_iter().fold(0.0, f64::max)
}

fn step(view: &View, near: f64, a: &Places, b: &Places) -> f64 {
    let pairs = a.corners.iter().zip(&b.corners);
    let moved = pairs.map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
    if moved == 0.0 {
        return 0.0;
    }
    if !view.is_perspective() {
        return view.focal() * moved;
    }
    let both = || a.corners.iter().chain(&b.corners);
    let nearest = both().map(|p| -p.z).fold(f64::INFINITY, f64::min);
    if nearest <= near {
        return f64::INFINITY;
    }
    let aside = both().map(|p| p.truncate().length()).fold(0.0, f64::max);
    view.focal() * (1.0 + aside / nearest) * moved / nearest
}
