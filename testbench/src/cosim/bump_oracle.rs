//! What a pixel of a bump core should be: vectors, place, gradient, factors and cosines in f64 from the knots of its triangle.
//!
//! The normal is left in the surface where the reflection would turn it below, as the core leaves it.

use shadegate_gen::stimulus::{Relief, Triangle};
use shadegate_hdl::bump::Bend;
use shadegate_reference::shade;

/// The gradient at a place, bilinear between four samples.
fn gradient(r: &Relief, [u, v]: [f64; 2]) -> [f64; 2] {
    let (x, y) = ((u - 0.5).floor(), (v - 0.5).floor());
    let (f, g) = (u - 0.5 - x, v - 0.5 - y);
    let at = |i: i64, j: i64| r.map.at(x as i64 + i, y as i64 + j);
    std::array::from_fn(|k| {
        let row = |j: i64| at(0, j)[k] * (1.0 - f) + at(1, j)[k] * f;
        row(0) * (1.0 - g) + row(1) * g
    })
}

/// N·L and N·H of a pixel of a triangle.
#[must_use]
pub fn cosines(t: &Triangle, bend: Bend, x: i32, y: i32) -> [f64; 2] {
    let slope = t.relief.as_ref().map_or([0.0; 2], |r| {
        let knots: [[f64; 3]; 3] = std::array::from_fn(|i| [r.address[i][0], r.address[i][1], 0.0]);
        let [u, v, _] = shade::gouraud::value(&t.position, &knots, x, y);
        gradient(r, [u, v])
    });
    let square = slope[0] * slope[0] + slope[1] * slope[1];
    let (across, along) = match bend {
        Bend::Newton => {
            let k = 1.0 - square.min(2.0) / 2.0;
            (k, k)
        }
        Bend::Reflection => {
            let factor = 4.0 / (square.min(4.0) + 4.0);
            (factor, 2.0 * factor - 1.0)
        }
    };
    [0, 6].map(|first| {
        let knots: [[f64; 3]; 6] = std::array::from_fn(|i| t.knots[first + i]);
        let v = shade::quadratic::value(&t.position, &knots, x, y);
        along * v[2] - across * (slope[0] * v[0] + slope[1] * v[1])
    })
}
