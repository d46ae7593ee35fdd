//! Curves in the place of cosⁿ that cost less than a power: each is a function of the angle, 1 at zero, even, and 0 from
//! some angle on.

pub mod blake;
pub mod cos2;
pub mod rom;

pub use blake::Pieces;
pub use cos2::Cos2;
pub use rom::Rom;

use std::f64::consts::FRAC_PI_2;

/// A function of an angle.
pub trait Curve {
    /// Its value at an angle, rad; 0..=1.
    fn at(&self, x: f64) -> f64;
}

/// cosⁿ of an angle within ±π/2; 0 beyond.
#[must_use]
pub fn power(angle: f64, n: f64) -> f64 {
    let cos = angle.cos();
    if angle.abs() < FRAC_PI_2 && cos > 0.0 {
        cos.powf(n)
    } else {
        0.0
    }
}

/// Largest difference between a curve and cosⁿ over 0..=π, both taken at `samples` angles that crowd where cosⁿ falls.
///
/// Both bend over angles of about 1/√n, so with h the distance of two samples there the true maximum is larger by no
/// more than about n·h²/8, 1e-6 for 1024 samples. Steps of a ROM are another matter: see [`Rom`].
#[must_use]
pub fn distance(n: f64, samples: u32, curve: &impl Curve) -> f64 {
    // Half of the samples up to where cosⁿ is 1e-4, half from there to where everything has ended.
    let fall = if n > 0.0 {
        (1e-4f64).powf(1.0 / n).acos()
    } else {
        FRAC_PI_2
    };
    let half = samples.max(2) / 2;
    let near = (0..=half).map(|i| fall * f64::from(i) / f64::from(half));
    let far =
        (0..=half).map(|i| fall + (std::f64::consts::PI - fall) * f64::from(i) / f64::from(half));
    near.chain(far)
        .map(|x| (curve.at(x) - power(x, n)).abs())
        .fold(0.0, f64::max)
}

/// The `x` in `from..=to` with the least `f`, for an `f` that falls and then rises: golden section search.
#[must_use]
pub fn least(mut from: f64, mut to: f64, rounds: u32, mut f: impl FnMut(f64) -> f64) -> f64 {
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (to - ratio * (to - from), from + ratio * (to - from));
    let (mut fa, mut fb) = (f(a), f(b));
    for _ in 0..rounds {
        if fa < fb {
            (to, b, fb) = (b, a, fa);
            a = to - ratio * (to - from);
            fa = f(a);
        } else {
            (from, a, fa) = (a, b, fb);
            b = from + ratio * (to - from);
            fb = f(b);
        }
    }
    (from + to) / 2.0
}
