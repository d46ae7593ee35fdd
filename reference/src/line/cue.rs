//! Depth cueing (Abbas 2003, eq. 3.14): what is farther is dimmer,
//! I(Z) = I₀·(C_max − (C_max − C_min)·Z/Z_max), and along a line of N + 1 columns I changes by (I(Z₂) − I(Z₁))/N from
//! column to column: one accumulator beside the line generator. N = 0 and Z_max = 0 divide by zero as printed; here
//! the line then keeps its first value.
//!
//! Depth is not linear on a screen in perspective, I along the line is: where the depths of the ends are in the ratio r,
//! the factor is off by up to (√r − 1)/(√r + 1) of its change between the ends, as any value is that is interpolated
//! without regard to perspective.

/// Factors of the colour at the nearest and the farthest depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cue {
    /// C_max, at the nearest depth.
    pub near: f64,
    /// C_min, at the farthest depth.
    pub far: f64,
}

impl Default for Cue {
    fn default() -> Self {
        Self {
            near: 1.0,
            far: 1.0,
        }
    }
}

impl Cue {
    /// The factor at depth `z` of a range; `near` where the range is empty.
    #[must_use]
    pub fn factor(&self, z: f64, [nearest, farthest]: [f64; 2]) -> f64 {
        if farthest > nearest {
            let share = ((z - nearest) / (farthest - nearest)).clamp(0.0, 1.0);
            self.near - (self.near - self.far) * share
        } else {
            self.near
        }
    }
}

/// A value that changes evenly from column to column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    /// The value in the current column.
    pub value: f64,
    /// Change to the next one.
    pub step: f64,
}

impl Ramp {
    /// From `first` to `last` in `steps` steps.
    #[must_use]
    pub fn new(first: f64, last: f64, steps: i32) -> Self {
        Self {
            value: first,
            step: if steps > 0 {
                (last - first) / f64::from(steps)
            } else {
                0.0
            },
        }
    }

    /// The value in column `x`: the accumulator's without its rounding.
    #[must_use]
    pub fn at(&self, x: i32) -> f64 {
        self.value + self.step * f64::from(x)
    }

    /// Moves to the next column.
    pub fn advance(&mut self) {
        self.value += self.step;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_and_no_range() {
        let c = Cue {
            near: 1.0,
            far: 0.2,
        };
        assert_eq!(c.factor(3.0, [3.0, 7.0]), 1.0);
        assert!((c.factor(7.0, [3.0, 7.0]) - 0.2).abs() < 1e-15);
        assert!((c.factor(5.0, [3.0, 7.0]) - 0.6).abs() < 1e-15);
        assert_eq!(c.factor(5.0, [5.0, 5.0]), 1.0);
        assert_eq!(c.factor(5.0, [f64::INFINITY, f64::NEG_INFINITY]), 1.0);
    }

    #[test]
    fn the_accumulator_arrives() {
        let mut r = Ramp::new(200.0, 17.0, 1023);
        let whole = r;
        for x in 0..1023 {
            assert!((r.value - whole.at(x)).abs() < 1e-10);
            r.advance();
        }
        assert!((r.value - 17.0).abs() < 1e-10);
        assert_eq!(Ramp::new(5.0, 9.0, 0).at(0), 5.0);
    }

    /// The bound for perspective, against depth by its definition.
    #[test]
    fn linear_on_the_screen_is_off_by_at_most_the_bound() {
        for r in [1.1, 2.0, 4.0, 10.0f64] {
            let (z0, z1) = (1.0, r);
            let mut worst = 0.0f64;
            for k in 0..=1000 {
                let s = f64::from(k) / 1000.0;
                let true_depth = 1.0 / ((1.0 - s) / z0 + s / z1);
                let linear = z0 + s * (z1 - z0);
                worst = worst.max((linear - true_depth).abs() / (z1 - z0));
            }
            let bound = (r.sqrt() - 1.0) / (r.sqrt() + 1.0);
            assert!(
                worst <= bound + 1e-12 && worst > bound * 0.999,
                "{r}: {worst} {bound}"
            );
        }
    }
}
