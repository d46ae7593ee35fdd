//! Three-dimensional vectors for the oracle, and random ones.

use rand::rngs::StdRng;
use rand::Rng;

pub type Vector = [f64; 3];

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn scale(a: Vector, k: f64) -> Vector {
    a.map(|v| v * k)
}

pub fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: Vector, b: Vector) -> Vector {
    add(a, scale(b, -1.0))
}

pub fn unit(a: Vector) -> Vector {
    scale(a, 1.0 / dot(a, a).sqrt())
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The angle between two vectors of any length, well-conditioned everywhere.
pub fn angle(a: Vector, b: Vector) -> f64 {
    let c = cross(a, b);
    dot(c, c).sqrt().atan2(dot(a, b))
}

/// Σ wᵢvᵢ.
pub fn blend(w: [f64; 3], v: [Vector; 3]) -> Vector {
    add(add(scale(v[0], w[0]), scale(v[1], w[1])), scale(v[2], w[2]))
}

/// Evenly distributed on the sphere.
pub fn any(rng: &mut StdRng) -> Vector {
    loop {
        let v = [0; 3].map(|_| rng.random_range(-1.0..1.0));
        let l = dot(v, v);
        if l > 1e-4 && l <= 1.0 {
            return unit(v);
        }
    }
}

/// A unit vector whose angle to `axis` lies in a range, rad.
pub fn around(rng: &mut StdRng, axis: Vector, angles: std::ops::Range<f64>) -> Vector {
    let a = rng.random_range(angles);
    let across = loop {
        let v = any(rng);
        let t = sub(v, scale(axis, dot(v, axis)));
        if dot(t, t) > 1e-6 {
            break unit(t);
        }
    };
    add(scale(axis, a.cos()), scale(across, a.sin()))
}

/// Evenly distributed barycentric weights.
pub fn weights(rng: &mut StdRng) -> [f64; 3] {
    let (a, b): (f64, f64) = (rng.random(), rng.random());
    let (a, b) = if a + b > 1.0 {
        (1.0 - a, 1.0 - b)
    } else {
        (a, b)
    };
    [1.0 - a - b, a, b]
}

/// Turns `v` about a unit axis (Rodrigues).
pub fn rotate(v: Vector, axis: Vector, by: f64) -> Vector {
    let along = scale(axis, dot(axis, v) * (1.0 - by.cos()));
    add(
        add(scale(v, by.cos()), scale(cross(axis, v), by.sin())),
        along,
    )
}
