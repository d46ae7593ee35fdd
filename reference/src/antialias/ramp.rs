//! Coverage along a row as linear ramps (Blake, Disselkoen and Kuijk 1992, section 3.6): each side of a triangle is, in a
//! row, a ramp from 0 to 1 as wide as the side runs across, at least one pixel, times the height of the side in the row.
//! What lies right of the left sides less what lies right of the right sides is the coverage.
//!
//! With m the run of a side in pixels, the true coverage by the side is a box of width 1 convolved with one of width m:
//! linear in the middle and rounded where it enters and leaves. The ramp errs most at its own ends, by 1/(8m) for m ≥ 1
//! (32 LSB at m = 1, 8 at m = 4) and by m/8 below; sides of height h err by h·min(m, 1/m)/8, and a triangle by no more
//! than its sides together.
//!
//! A side counts the same for both triangles that share it, with opposite signs. So coverages around a vertex add up to
//! 1 exactly, and nothing behind shines through, whatever the ramps err.

use crate::raster::Point;

/// A side of a triangle in a row.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Side {
    /// Part of the row's height that it spans: positive for a left side, negative for a right one.
    height: f64,
    /// Column coordinate of its middle, pixels.
    middle: f64,
    /// How far it runs across, pixels.
    run: f64,
}

impl Side {
    /// The side from `a` to `b` in row `row`; `sign` is that of a side that goes down. Always worked out from the upper
    /// to the lower end, so that it is the same for both triangles.
    fn new(a: Point, b: Point, row: i32, sign: f64) -> Self {
        let (top, bottom, sign) = if a.y <= b.y {
            (a, b, sign)
        } else {
            (b, a, -sign)
        };
        let ((ax, ay), (bx, by)) = (top.pixels(), bottom.pixels());
        let (first, last) = (f64::from(row), f64::from(row) + 1.0);
        let (from, to) = (ay.max(first), by.min(last));
        if to <= from {
            return Self::default();
        }
        let [x0, x1] = [from, to].map(|y| ax + (bx - ax) * ((y - ay) / (by - ay)));
        Self {
            height: sign * (to - from),
            middle: (x0 + x1) / 2.0,
            run: (x1 - x0).abs(),
        }
    }

    fn width(&self) -> f64 {
        self.run.max(1.0)
    }

    /// What lies right of the side of a pixel with its centre at `x`.
    fn at(&self, x: f64) -> f64 {
        self.height * (0.5 + (x - self.middle) / self.width()).clamp(0.0, 1.0)
    }
}

/// The coverage of a triangle along one row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowCoverage {
    sides: [Side; 3],
}

impl RowCoverage {
    /// The coverage in a row; nothing for a triangle that does not touch it or has no area.
    #[must_use]
    pub fn new(t: [Point; 3], row: i32) -> Self {
        // Clockwise on the screen, left sides go up.
        let sign = -(crate::raster::area2(t).signum() as f64);
        Self {
            sides: [0, 1, 2].map(|i| Side::new(t[i], t[(i + 1) % 3], row, sign)),
        }
    }

    /// The share of a pixel that is covered, by column coordinate of its centre; at least 0.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        self.signed(x).max(0.0)
    }

    /// The same without its limit: where ramps of a narrow end cross, slightly below 0.
    fn signed(&self, x: f64) -> f64 {
        self.sides.iter().map(|s| s.at(x)).sum()
    }

    /// Bound of the difference from the exact area.
    #[must_use]
    pub fn error_bound(&self) -> f64 {
        let side = |s: &Side| match s.run {
            0.0 => 0.0,
            m => s.height.abs() * m.min(1.0 / m) / 8.0,
        };
        self.sides.iter().map(side).sum()
    }

    /// Column coordinates between which the coverage is linear, ascending.
    #[must_use]
    pub fn breaks(&self) -> Vec<f64> {
        let mut all = Vec::with_capacity(9);
        for s in self.sides.iter().filter(|s| s.height != 0.0) {
            all.extend([s.middle - s.width() / 2.0, s.middle + s.width() / 2.0]);
        }
        all.sort_by(f64::total_cmp);
        // Where the sum passes 0, the limit bends it once more.
        for k in 1..all.len() {
            let (p, q) = (self.signed(all[k - 1]), self.signed(all[k]));
            if p * q < 0.0 {
                all.push(all[k - 1] + (all[k] - all[k - 1]) * (p / (p - q)));
            }
        }
        all.sort_by(f64::total_cmp);
        all
    }
}

#[cfg(test)]
mod tests {
    use super::super::area::coverage;
    use super::*;
    use proptest::prelude::*;

    /// A half plane right of an edge that runs `m` pixels across per row, against the exact area, by offset of the edge.
    #[test]
    fn the_error_of_a_ramp() {
        for (m, lsb) in [
            (1.0, 32.0),
            (2.0, 16.0),
            (4.0, 8.0),
            (0.5, 16.0),
            (0.25, 8.0),
        ] {
            let mut worst = 0.0f64;
            for k in 0..256 {
                let at = |x: f64, y: f64| Point::snap(x + f64::from(k) / 256.0, y).unwrap();
                let t = [
                    at(100.0, -100.0),
                    at(100.0 + 300.0 * m, 200.0),
                    at(3000.0, -100.0),
                ];
                let row = RowCoverage::new(t, 7);
                for x in 90..700 {
                    worst = worst.max((row.at(f64::from(x) + 0.5) - coverage(t, x, 7)).abs());
                }
            }
            println!("run {m}: {:.2} LSB ({lsb})", worst * 255.0);
            let want = f64::min(m, 1.0 / m) / 8.0;
            assert!(worst <= want + 1e-9 && worst > want * 0.97, "{m}: {worst}");
            assert!((want * 255.0 - lsb).abs() < 0.2);
        }
    }

    fn any_triangle() -> impl Strategy<Value = [Point; 3]> {
        prop::array::uniform3((-500..3000i32, -500..2500i32))
            .prop_map(|v| v.map(|(x, y)| Point { x, y }))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1500))]
        #[test]
        fn coverage_keeps_its_bound_and_is_linear_between_breaks(t in any_triangle()) {
            for y in -2..10 {
                let row = RowCoverage::new(t, y);
                let bound = row.error_bound();
                for x in -3..13 {
                    let c = row.at(f64::from(x) + 0.5);
                    let area = coverage(t, x, y);
                    prop_assert!((c - area).abs() <= bound + 1e-9, "{x} {y}: {c} {area} {bound}");
                    prop_assert!((0.0..=1.0 + bound + 1e-12).contains(&c));
                }
                for pair in row.breaks().windows(2) {
                    let at = |s: f64| row.at(pair[0] + (pair[1] - pair[0]) * s);
                    prop_assert!((at(0.5) - (at(0.25) + at(0.75)) / 2.0).abs() < 1e-9);
                }
            }
        }

        /// A fan around a vertex: coverages add up to 1, or a little more where narrow ends cross.
        #[test]
        fn fans_leave_no_pinholes(cx in 600..1400i32, cy in 600..1400i32, n in 3..9usize, turn in 0.0..1.0f64) {
            let centre = Point { x: cx, y: cy };
            let rim: Vec<Point> = (0..n).map(|k| {
                let a = (k as f64 + turn) / n as f64 * std::f64::consts::TAU;
                Point { x: cx + (2000.0 * a.cos()) as i32, y: cy + (2000.0 * a.sin()) as i32 }
            }).collect();
            for y in cy / 256 - 1..=cy / 256 + 1 {
                for x in cx / 256 - 1..=cx / 256 + 1 {
                    let sum: f64 = (0..n)
                        .map(|k| RowCoverage::new([centre, rim[k], rim[(k + 1) % n]], y).at(f64::from(x) + 0.5))
                        .sum();
                    prop_assert!(sum >= 1.0 - 1e-9, "{x} {y}: {sum}");
                    prop_assert!(sum <= 1.13, "{x} {y}: {sum}");
                }
            }
        }
    }
}
