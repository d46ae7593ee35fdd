//! How far what is interpolated ranges, and how fast it changes.

use super::{ascending, Needs};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{area2, SUBPIXELS};
use crate::shade::gouraud;
use std::collections::BTreeSet;

/// Pairs of corners with an edge between them.
const EDGES: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// The larger change per pixel, in x and in y, of what is linear between three values; 0 on a triangle without area.
fn slope(t: &ScreenTriangle, v: [f64; 3]) -> f64 {
    let area = area2(t.position) as f64;
    if area == 0.0 {
        return 0.0;
    }
    let of = |i: usize| (f64::from(t.position[i].x), f64::from(t.position[i].y));
    let ((ax, ay), (bx, by), (cx, cy)) = (of(0), of(1), of(2));
    let (b, c) = (v[1] - v[0], v[2] - v[0]);
    let x = (b * (cy - ay) - c * (by - ay)) / area;
    let y = (c * (bx - ax) - b * (cx - ax)) / area;
    x.abs().max(y.abs()) * f64::from(SUBPIXELS)
}

impl Needs {
    /// Positions, depths, colours, normals and weights; slopes only of triangles that cover pixels.
    pub(super) fn measure(&mut self, p: &Prepared, covering: &[bool]) {
        for (t, covers) in p.triangles.iter().zip(covering) {
            let knots = gouraud::knots(p, t);
            for (i, knot) in knots.iter().enumerate() {
                let at = |v: i32| f64::from(v) / f64::from(SUBPIXELS);
                self.columns = self.columns.with(at(t.position[i].x));
                self.rows = self.rows.with(at(t.position[i].y));
                self.depth = self.depth.with(t.depth[i]);
                self.colour = knot.iter().fold(self.colour, |range, v| range.with(*v));
            }
            if *covers {
                self.depth_slope = self.depth_slope.max(slope(t, t.depth));
                let channels = [0, 1, 2].map(|c| knots.map(|k| k[c]));
                let steepest = channels.map(|channel| slope(t, channel));
                self.colour_slope = steepest.into_iter().fold(self.colour_slope, f64::max);
            }
            for (a, b) in EDGES {
                let (a, b) = (t.normal[a], t.normal[b]);
                // Well-conditioned for small and for large angles.
                let angle = a.cross(b).length().atan2(a.dot(b)).to_degrees();
                self.curvature = self.curvature.max(angle);
            }
            let [least, most] = t
                .inv_w
                .iter()
                .fold([f64::INFINITY, 0.0f64], |[l, m], w| [l.min(*w), m.max(*w)]);
            self.perspective = self.perspective.max(most / least);
        }
    }

    /// Materials that are drawn.
    pub(super) fn survey(&mut self, p: &Prepared) {
        let used: BTreeSet<usize> = p.triangles.iter().map(|t| t.material).collect();
        self.materials = used.len();
        for m in used.into_iter().map(|i| p.surroundings.material(i)) {
            self.textures += usize::from(m.texture.is_some());
            self.bumps += usize::from(m.bump.is_some());
            if m.specular.max_element() > 0.0 {
                self.exponents.push(m.shininess);
            }
        }
        ascending(&mut self.exponents);
    }
}
