//! cosⁿθ ≈ q(θ) in three quadratic pieces (Blake, Disselkoen and Kuijk 1992, eq. 4):
//!
//!   q = 1 − θ²/(ab) for |θ| ≤ a,  (|θ| − b)²/(b(b − a)) for a < |θ| < b,  0 beyond; its slope does not jump.
//!
//! The printed a(n) = (n + 5.6)/(n(0.09n + 5.2)), b(n) = (n + 65)/(5n + 31.7) are good to 5.3 LSB of full scale from
//! n = 3 to 80; then b tends to 0.2 in the place of falling with 1/√n: 9 LSB at n = 100, 37 at 256. Refitted,
//! a = 0.7531/√(n − 1.5 + 2/n), b = 2.9926/√(n + 0.94): at most 3.7 LSB from n = 4 on; below 4 the least maximal error is
//! searched for when the material is set up (n = 1, the diffuse reflection: 6.1 LSB where the printed pair has 13.3).

use super::{distance, least, Curve};
use std::sync::OnceLock;

/// Exponents from this one on have a refit in closed form.
const CLOSED_FORM: f64 = 4.0;

/// The three pieces for one exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pieces {
    /// Where the middle piece ends, rad.
    pub a: f64,
    /// Where everything ends, rad; greater than `a`.
    pub b: f64,
}

impl Pieces {
    /// As printed; exponents below 1, for which it was not made, count as 1.
    #[must_use]
    pub fn printed(n: f64) -> Self {
        let n = n.max(1.0);
        Self {
            a: (n + 5.6) / (n * (0.09 * n + 5.2)),
            b: (n + 65.0) / (5.0 * n + 31.7),
        }
    }

    /// The refit in closed form, n ≥ 1; within 3.7 LSB of full scale from n = 4 on.
    #[must_use]
    pub fn closed_form(n: f64) -> Self {
        Self {
            a: 0.7531 / (n - 1.5 + 2.0 / n).sqrt(),
            b: 2.9926 / (n + 0.94).sqrt(),
        }
    }

    /// Refitted.
    #[must_use]
    pub fn refit(n: f64) -> Self {
        if n >= CLOSED_FORM {
            Self::closed_form(n)
        } else if n == 1.0 {
            *DIFFUSE.get_or_init(|| Self::minimax(1.0))
        } else {
            Self::minimax(n)
        }
    }

    /// The pair of least maximal error, by two searches one inside the other; about ten thousand times the work of the
    /// closed forms.
    #[must_use]
    pub fn minimax(n: f64) -> Self {
        let guess = Self::printed(n.min(3.0));
        let error = |a: f64, b: f64| {
            let q = Self { a, b };
            distance(n, 192, &q)
        };
        let scale = (3.0 / n.max(3.0)).sqrt();
        let best_a = |b: f64| least(0.2 * b, 0.95 * b, 24, |a| error(a, b));
        let b = least(0.6 * guess.b * scale, 1.4 * guess.b * scale, 24, |b| {
            error(best_a(b), b)
        });
        Self { a: best_a(b), b }
    }
}

impl Curve for Pieces {
    fn at(&self, angle: f64) -> f64 {
        let x = angle.abs();
        if x >= self.b {
            0.0
        } else if x > self.a {
            (x - self.b).powi(2) / (self.b * (self.b - self.a))
        } else {
            1.0 - x * x / (self.a * self.b)
        }
    }
}

/// The refit for n = 1, which every scene needs.
static DIFFUSE: OnceLock<Pieces> = OnceLock::new();

#[cfg(test)]
mod tests {
    use super::*;

    fn error(n: f64, q: Pieces) -> f64 {
        255.0 * distance(n, 4096, &q)
    }

    #[test]
    fn equation_4_as_measured() {
        let row = [
            (1.0, 13.3),
            (2.0, 10.5),
            (3.0, 6.7),
            (5.0, 3.6),
            (8.0, 5.3),
            (10.0, 5.2),
            (20.0, 3.7),
            (32.0, 4.7),
            (50.0, 4.6),
            (64.0, 4.0),
            (80.0, 5.2),
            (100.0, 9.1),
            (125.0, 14.2),
            (150.0, 19.0),
            (200.0, 28.0),
            (256.0, 37.5),
        ];
        for (n, want) in row {
            let e = error(n, Pieces::printed(n));
            assert!((e - want).abs() < 0.4, "{n}: {e} against {want}");
        }
    }

    #[test]
    fn the_refit_is_better_and_close_to_the_best() {
        for n in [
            4.0, 5.0, 8.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 2000.0, 10_000.0,
        ] {
            let e = error(n, Pieces::refit(n));
            let best = error(n, Pieces::minimax(n));
            println!(
                "n={n}: printed {:.2}, refit {e:.2}, minimax {best:.2} LSB",
                error(n, Pieces::printed(n))
            );
            assert!(e <= 3.72, "{n}: {e}");
            assert!(best <= e + 0.02 && e <= 1.12 * best, "{n}: {e} {best}");
        }
        for (n, want) in [(1.0, 6.1), (2.0, 4.5), (3.0, 4.0)] {
            let e = error(n, Pieces::refit(n));
            println!("n={n}: refit {e:.2} LSB {:?}", Pieces::refit(n));
            assert!(e <= want + 0.05, "{n}: {e}");
        }
        let one = Pieces::refit(1.0);
        assert!(
            (one.a - 1.3545).abs() < 5e-3 && (one.b - 1.6861).abs() < 5e-3,
            "{one:?}"
        );
    }

    #[test]
    fn pieces_join_without_a_kink_for_every_exponent() {
        for n in [0.0, 0.3, 1.0, 2.0, 7.0, 90.0, 10_000.0] {
            for q in [Pieces::printed(n), Pieces::refit(n)] {
                assert!(
                    q.a > 0.0 && q.b > q.a && q.b < std::f64::consts::PI,
                    "{n}: {q:?}"
                );
                let slope = |x: f64, h: f64| (q.at(x + h) - q.at(x)) / h;
                let h = 1e-7 * q.a;
                for x in [q.a, q.b] {
                    assert!((slope(x, h) - slope(x, -h)).abs() * q.a < 1e-5, "{n}");
                }
                assert_eq!((q.at(0.0), q.at(-q.b)), (1.0, 0.0));
            }
        }
    }
}
