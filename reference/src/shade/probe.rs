//! For tests: how far a vector M that a method puts in the place of the unit normal is from it.

use glam::DVec3;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// What was found.
#[derive(Clone, Copy, Debug)]
pub struct Deviation {
    /// The least length.
    pub shortest: f64,
    /// The greatest length.
    pub longest: f64,
    /// The greatest angle to the normal, rad.
    pub angle: f64,
}

/// How vertex normals lie to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// All pairs equally far apart.
    Even,
    /// Two of them equal.
    Thin,
    /// As it comes.
    Any,
}

/// Unit vectors of which the two farthest apart are `spread` rad apart.
pub fn normals(rng: &mut StdRng, spread: f64, shape: Shape) -> [DVec3; 3] {
    let place: [(f64, f64); 3] = [0.0, 1.0, 2.0].map(|k| {
        let turn = k * std::f64::consts::TAU / 3.0;
        match shape {
            Shape::Even => (1.0, turn),
            Shape::Thin if k < 1.0 => (1.0, 0.0),
            Shape::Thin => (1.0, std::f64::consts::PI),
            Shape::Any => (
                rng.random_range(0.0..1.0),
                rng.random_range(0.0..std::f64::consts::TAU),
            ),
        }
    });
    let at = |reach: f64| {
        place.map(|(r, a)| {
            let (s, c) = (r * reach).sin_cos();
            DVec3::new(s * a.cos(), s * a.sin(), c)
        })
    };
    let widest = |v: [DVec3; 3]| {
        let far = |i: usize, j: usize| v[i].cross(v[j]).length().atan2(v[i].dot(v[j]));
        far(0, 1).max(far(0, 2)).max(far(1, 2))
    };
    let (mut lo, mut hi) = (0.0, std::f64::consts::PI);
    for _ in 0..50 {
        let mid = f64::midpoint(lo, hi);
        if widest(at(mid)) < spread {
            lo = mid;
        } else {
            hi = mid;
        }
    }
    at(lo)
}

/// The worst over random triangles of a spread and places in them; `replace` gives M for normals and weights.
pub fn deviation(spread: f64, replace: impl Fn(&[DVec3; 3], [f64; 3]) -> DVec3) -> Deviation {
    let mut rng = StdRng::seed_from_u64(spread.to_bits());
    let mut worst = Deviation {
        shortest: f64::INFINITY,
        longest: 0.0,
        angle: 0.0,
    };
    for k in 0..400 {
        let shape = match k % 8 {
            0 => Shape::Even,
            1 => Shape::Thin,
            _ => Shape::Any,
        };
        let n = normals(&mut rng, spread, shape);
        for place in 0..60 {
            let (a, b): (f64, f64) = (rng.random(), rng.random());
            let (a, b) = if a + b > 1.0 {
                (1.0 - a, 1.0 - b)
            } else {
                (a, b)
            };
            let w = match place {
                0..3 => [0, 1, 2].map(|i| f64::from(u8::from(i == place))),
                3..9 => [1.0 - a, a, 0.0],
                _ => [1.0 - a - b, a, b],
            };
            let truth = (n[0] * w[0] + n[1] * w[1] + n[2] * w[2]).normalize();
            let m = replace(&n, w);
            worst.shortest = worst.shortest.min(m.length());
            worst.longest = worst.longest.max(m.length());
            let angle = m.cross(truth).length().atan2(m.dot(truth));
            worst.angle = worst.angle.max(angle);
        }
    }
    worst
}

/// Spreads for such tests, degrees.
pub const SPREADS: [f64; 8] = [1.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0];
