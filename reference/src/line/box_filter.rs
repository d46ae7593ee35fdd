//! The box-filtered line (Abbas 2003, section 3.2): the line's intensity is shared between the two pixels of a column
//! above and below it, 1 − f and f with f the fraction of the line's minor coordinate.
//!
//! Eq. 3.8 prints Round where floor is meant (its listing has floor), and the increment of the listing lacks the factor
//! of the intensity. The weights here come from an integer remainder, so they neither drift nor depend on intensity.
//! They ignore the slope: the sum of a column is 1, where a line one pixel wide covers 1/cos φ. Near the diagonal such
//! lines are 30 % too dim, and a pixel errs by up to 64/255.

use super::{Path, Pixel};

/// Pixels with weights in 0..=1, two per column (one where the line meets a pixel centre), major coordinate rising.
pub fn pixels(path: &Path) -> impl Iterator<Item = (Pixel, f64)> + '_ {
    let (dx, dy) = (i64::from(path.major.max(1)), i64::from(path.minor));
    (0..=path.major).flat_map(move |x| {
        let n = i64::from(x) * dy;
        let (y, f) = ((n / dx) as i32, (n % dx) as f64 / dx as f64);
        [(y, 1.0 - f), (y + 1, f)]
            .into_iter()
            .filter(|(_, w)| *w > 0.0)
            .map(move |(y, w)| (path.place(x, y), w))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(a: (i32, i32), b: (i32, i32)) -> Path {
        let p = |(x, y)| Pixel { x, y };
        Path::new(p(a), p(b)).unwrap()
    }

    #[test]
    fn columns_sum_to_one_and_balance_on_the_line() {
        for dx in 1..40 {
            for dy in -dx..=dx {
                let mut sum = vec![(0.0, 0.0); dx as usize + 1];
                for (p, w) in pixels(&path((0, 0), (dx, dy))) {
                    let s = &mut sum[p.x as usize];
                    *s = (s.0 + w, s.1 + w * f64::from(p.y));
                }
                for (x, (s, m)) in sum.into_iter().enumerate() {
                    let real = x as f64 * f64::from(dy) / f64::from(dx);
                    assert!((s - 1.0).abs() < 1e-12 && (m - real).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn a_point_is_one_full_pixel() {
        let all: Vec<_> = pixels(&path((5, 6), (5, 6))).collect();
        assert_eq!(all, [(Pixel { x: 5, y: 6 }, 1.0)]);
    }

    /// Area of a strip of width 1 around y = m·x in the unit pixel with centre (0, c), by summing thin columns.
    fn area(m: f64, c: f64) -> f64 {
        let half = 0.5 * m.hypot(1.0);
        let n = 2000;
        (0..n)
            .map(|i| {
                let y = m * ((f64::from(i) + 0.5) / f64::from(n) - 0.5);
                ((y + half).min(c + 0.5) - (y - half).max(c - 0.5)).max(0.0) / f64::from(n)
            })
            .sum()
    }

    /// Worst error of a weight in LSB by slope, as in the study.
    #[test]
    fn the_error_of_ignoring_the_slope() {
        for (m, want) in [
            (0.0, 0.0),
            (0.25, 12.0),
            (0.5, 24.0),
            (0.75, 42.0),
            (1.0, 64.0),
        ] {
            let mut worst = 0.0f64;
            for k in 0..200 {
                let f = f64::from(k) / 200.0;
                // The line passes the column's middle at f above the lower pixel.
                for (c, w) in [(-f, 1.0 - f), (1.0 - f, f)] {
                    worst = worst.max((w - area(m, c)).abs());
                }
            }
            let lsb = worst * 255.0;
            println!("slope {m}: {lsb:.1} LSB ({want})");
            assert!((lsb - want).abs() < 1.0, "slope {m}: {lsb}");
        }
    }
}
