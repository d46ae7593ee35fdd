//! Bresenham's line (1965; Abbas 2003, section 3.1; the same with doubled denominators as the error-free integer line of
//! 3D graphics texts): in every column the one pixel nearest to the line, at most half a pixel beside it.

use super::{Path, Pixel};

/// The pixels of a line, major coordinate rising.
pub fn pixels(path: &Path) -> impl Iterator<Item = Pixel> + '_ {
    path.columns().map(|c| path.place(c.x, c.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn line(a: (i32, i32), b: (i32, i32)) -> Vec<(i32, i32)> {
        let p = |(x, y)| Pixel { x, y };
        let path = Path::new(p(a), p(b)).unwrap();
        pixels(&path).map(|p| (p.x, p.y)).collect()
    }

    #[test]
    fn the_line_of_the_paper() {
        let want = [
            (0, 0),
            (1, 1),
            (2, 1),
            (3, 2),
            (4, 3),
            (5, 4),
            (6, 4),
            (7, 5),
        ];
        assert_eq!(line((0, 0), (7, 5)), want);
        assert_eq!(line((7, 5), (0, 0)), want);
    }

    #[test]
    fn points_levels_and_diagonals() {
        assert_eq!(line((3, -4), (3, -4)), [(3, -4)]);
        assert_eq!(line((2, 5), (0, 5)), [(0, 5), (1, 5), (2, 5)]);
        assert_eq!(line((1, 2), (1, 0)), [(1, 0), (1, 1), (1, 2)]);
        assert_eq!(line((0, 2), (2, 0)), [(0, 2), (1, 1), (2, 0)]);
    }

    /// The rule: ties stay on the row of the left end, whether the line rises or falls.
    #[test]
    fn ties_stay() {
        assert_eq!(line((0, 0), (2, 1)), [(0, 0), (1, 0), (2, 1)]);
        assert_eq!(line((0, 0), (2, -1)), [(0, 0), (1, 0), (2, -1)]);
        assert_eq!(line((0, 0), (1, 2)), [(0, 0), (0, 1), (1, 2)]);
        assert_eq!(line((0, 0), (-1, 2)), [(0, 0), (0, 1), (-1, 2)]);
    }

    /// Against the real line, in f64 and without an error term.
    #[test]
    fn never_more_than_half_a_pixel_beside_the_line() {
        let mut worst = 0.0f64;
        for dx in 1..64 {
            for dy in -dx..=dx {
                for (x, y) in line((0, 0), (dx, dy)) {
                    let real = f64::from(x) * f64::from(dy) / f64::from(dx);
                    worst = worst.max((f64::from(y) - real).abs());
                }
            }
        }
        assert!(worst <= 0.5 + 1e-12, "{worst}");
        assert!(worst > 0.499, "ties occur");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]
        #[test]
        fn all_octants_are_images_of_one(dx in 0..200i32, dy in 0..200i32) {
            let base = line((0, 0), (dx, dy));
            let mirror = |f: fn((i32, i32)) -> (i32, i32)| base.iter().copied().map(f).collect::<Vec<_>>();
            if dx > dy {
                prop_assert_eq!(line((0, 0), (dx, -dy)), mirror(|(x, y)| (x, -y)));
                prop_assert_eq!(line((0, 0), (dy, dx)), mirror(|(x, y)| (y, x)));
                prop_assert_eq!(line((0, 0), (-dy, dx)), mirror(|(x, y)| (-y, x)));
            }
            // With the ends swapped only ties may lie differently.
            let turned: Vec<_> = line((0, 0), (-dx, -dy)).into_iter().rev().map(|(x, y)| (-x, -y)).collect();
            let differ = base.iter().zip(&turned).filter(|(p, q)| p != q).count();
            let (long, short) = (dx.max(dy), dx.min(dy));
            let ties = (0..=long).filter(|k| long > 0 && (2 * k * short) % (2 * long) == long).count();
            prop_assert_eq!(differ, ties);
        }
    }
}
