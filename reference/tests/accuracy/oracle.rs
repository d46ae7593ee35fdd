//! The truth, from the definition: blend, normalise, dot products, power; in f64.

use crate::setting::{Place, Setting};
use crate::vector::{add, blend, dot, sub, unit, Vector};

/// What L and H are between the vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Truth {
    /// Blended as N is, and normalised (Abbas 2003, eq. 5.2).
    Blended,
    /// Found anew at the position of the pixel.
    Positions,
}

/// Perspective-correct weights of the centre of a pixel.
fn weights(s: &Setting, x: i32, y: i32) -> [f64; 3] {
    let corner = s.position.map(|p| {
        let (px, py) = p.pixels();
        [px - f64::from(x) - 0.5, py - f64::from(y) - 0.5]
    });
    let area = |i: usize, j: usize| corner[i][0] * corner[j][1] - corner[i][1] * corner[j][0];
    let w = [
        area(1, 2) * s.inv_w[0],
        area(2, 0) * s.inv_w[1],
        area(0, 1) * s.inv_w[2],
    ];
    let sum = w[0] + w[1] + w[2];
    w.map(|v| v / sum)
}

/// The colour at the centre of a pixel, LSB.
pub fn value(s: &Setting, truth: Truth, x: i32, y: i32) -> f64 {
    let w = weights(s, x, y);
    let n = unit(blend(w, s.normal));
    let (l, h): (Vector, Vector) = match (truth, s.place) {
        (_, Place::Far { light, half }) => (light, half),
        (Truth::Blended, Place::Near { .. }) => {
            let at = [0, 1, 2].map(|i| s.incidence(i));
            (
                unit(blend(w, at.map(|a| a.0))),
                unit(blend(w, at.map(|a| a.1))),
            )
        }
        (Truth::Positions, Place::Near { light, eye }) => {
            let x = blend(w, s.world);
            let l = unit(sub(light, x));
            (l, unit(add(l, unit(sub(eye, x)))))
        }
    };
    let highlight = dot(n, h);
    let highlight = if highlight > 0.0 {
        highlight.powf(s.shininess)
    } else {
        0.0
    };
    255.0 * (s.ambient + s.diffuse * dot(n, l).max(0.0) + s.specular * highlight)
}
