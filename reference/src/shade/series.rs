//! Polynomials of two variables up to the second order, for Taylor expansions on a triangle.

use super::form::Form;
use std::ops::Mul;

/// c + x·u + y·v + xx·u² + xy·uv + yy·v², where u and v are the departures of λ₁ and λ₂ from the point of expansion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Series {
    /// The constant.
    pub c: f64,
    /// Coefficients of u and v.
    pub first: [f64; 2],
    /// Coefficients of u², uv and v².
    pub second: [f64; 3],
}

impl Series {
    /// A constant.
    #[must_use]
    pub fn constant(c: f64) -> Self {
        Self {
            c,
            ..Self::default()
        }
    }

    /// A linear or quadratic function about the point with weights `at`: exact.
    #[must_use]
    pub fn of(form: &Form, at: [f64; 3]) -> Self {
        let [i0, i1, i2] = form.corner;
        // Edges 01, 02, 12; λ₀ = at₀ − u − v.
        let [k, l, m] = form.bow;
        Self {
            c: form.at(at),
            first: [
                i1 - i0 + k * (at[0] - at[1]) - l * at[2] + m * at[2],
                i2 - i0 + l * (at[0] - at[2]) - k * at[1] + m * at[1],
            ],
            second: [-k, m - k - l, -l],
        }
    }

    /// The same polynomial as a function of weights.
    #[must_use]
    pub fn form(&self, at: [f64; 3]) -> Form {
        let value = |w: [f64; 3]| {
            let (u, v) = (w[1] - at[1], w[2] - at[2]);
            let [uu, uv, vv] = self.second;
            self.c + self.first[0] * u + self.first[1] * v + uu * u * u + uv * u * v + vv * v * v
        };
        let [k, both, l] = self.second.map(|s| -s);
        Form {
            corner: [
                value([1.0, 0.0, 0.0]),
                value([0.0, 1.0, 0.0]),
                value([0.0, 0.0, 1.0]),
            ],
            bow: [k, l, k + l - both],
        }
    }

    /// The series of 1/√f: (1 − e/2 + 3e²/8)/√c with f = c(1 + e). `None` where the constant is not positive.
    #[must_use]
    pub fn inverse_root(self) -> Option<Self> {
        let usable = self.c > super::CANCELLED;
        let e = self.scaled(1.0 / self.c);
        let [x, y] = e.first;
        let square = [x * x, 2.0 * x * y, y * y];
        let unscaled = Self {
            c: 1.0,
            first: e.first.map(|v| -0.5 * v),
            second: [0, 1, 2].map(|i| -0.5 * e.second[i] + 0.375 * square[i]),
        };
        usable.then(|| unscaled.scaled(1.0 / self.c.sqrt()))
    }

    fn scaled(self, k: f64) -> Self {
        Self {
            c: self.c * k,
            first: self.first.map(|v| v * k),
            second: self.second.map(|v| v * k),
        }
    }
}

impl Mul for Series {
    type Output = Self;

    /// The product, without what is of higher order.
    fn mul(self, o: Self) -> Self {
        let ([a, b], [x, y]) = (self.first, o.first);
        let cross = [a * x, a * y + b * x, b * y];
        Self {
            c: self.c * o.c,
            first: [0, 1].map(|i| self.c * o.first[i] + o.c * self.first[i]),
            second: [0, 1, 2].map(|i| self.c * o.second[i] + o.c * self.second[i] + cross[i]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const AT: [f64; 3] = [0.5, 0.3, 0.2];

    fn forms() -> impl Strategy<Value = Form> {
        (
            prop::array::uniform3(-1.0..1.0f64),
            prop::array::uniform3(-1.0..1.0f64),
        )
            .prop_map(|(corner, bow)| Form { corner, bow })
    }

    fn weights(u: f64, v: f64) -> [f64; 3] {
        [AT[0] - u - v, AT[1] + u, AT[2] + v]
    }

    proptest! {
        #[test]
        fn forms_go_there_and_back(f in forms()) {
            let back = Series::of(&f, AT).form(AT);
            for i in 0..3 {
                prop_assert!((back.corner[i] - f.corner[i]).abs() < 1e-14);
                prop_assert!((back.bow[i] - f.bow[i]).abs() < 1e-14);
            }
        }

        /// What is left out is of the third order: it falls to an eighth when the departure halves.
        #[test]
        fn products_and_roots_are_right_to_the_second_order(
            f in forms(), g in forms(), u in -1.0..1.0f64, v in -1.0..1.0f64,
        ) {
            let g = Form { corner: g.corner.map(|c| 2.0 + c), ..g };
            let series = (Series::of(&f, AT) * Series::of(&g, AT).inverse_root().unwrap()).form(AT);
            let left = |h: f64| {
                let w = weights(u * h, v * h);
                f.at(w) / g.at(w).sqrt() - series.at(w)
            };
            prop_assert!(left(1e-3).abs() < 2e-8, "{}", left(1e-3));
            prop_assert!((left(2e-3) - 8.0 * left(1e-3)).abs() < 2e-10);
        }
    }

    #[test]
    fn there_is_no_root_of_what_is_not_positive() {
        assert_eq!(Series::constant(0.0).inverse_root(), None);
        assert_eq!(Series::constant(-1.0).inverse_root(), None);
        assert_eq!(Series::constant(f64::NAN).inverse_root(), None);
    }
}
