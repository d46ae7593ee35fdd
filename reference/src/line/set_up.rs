//! What a line core must be told before it can draw: the words of a line as real numbers, for whoever quantises them.
//!
//! | word | meaning | unit | range |
//! |---|---|---|---|
//! | `columns` | dX, columns but one | pixels | 0..=2²³ |
//! | `error_start` | −dX | half pixels · dX | −`columns` |
//! | `error_stay`, `error_step` | 2·dY, 2·(dY − dX) | likewise | 0..=2·dX, −2·dX..=0 |
//! | `fraction_step` | dY/dX, box filter | pixels | 0..=1 |
//! | `cosine` | dX·d, distance of neighbours in a column | pixels | 0.7071..=1 |
//! | `distance_start` | −dY·d | pixels | −0.7071..=0 |
//! | `distance_stay`, `distance_step` | dY·d, (dX − dY)·d | pixels | 0..=0.7071, 0..=1 |
//! | `distance_scale` | d/2 | 1/pixels | 0..=0.5 |
//! | `error_offset` | dX − 2·dY: D = (E + `error_offset`)·`distance_scale` | as the error | −dX..=dX |
//!
//! d = 1/√(dX² + dY²); a line of one pixel has all its steps zero and needs no division. D lies in ±½, the distances of
//! the neighbours in 0.2..=1.5.

use super::Path;

/// The words of one line. The error term is integer, the rest waits for a word length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetUp {
    /// Columns but one.
    pub columns: i64,
    /// Error term before the first column.
    pub error_start: i64,
    /// Added where the walk stays on its row (E ≤ 0).
    pub error_stay: i64,
    /// Added where it steps.
    pub error_step: i64,
    /// Added to the error term before it is scaled to D.
    pub error_offset: i64,
    /// Change of the box filter's fraction per column, pixels.
    pub fraction_step: f64,
    /// Distance from the line of one pixel in a column relative to the next, pixels.
    pub cosine: f64,
    /// D before the first column, pixels.
    pub distance_start: f64,
    /// Added to D where the walk stays, pixels.
    pub distance_stay: f64,
    /// Subtracted from D where it steps, pixels.
    pub distance_step: f64,
    /// D of one unit of the error term, pixels.
    pub distance_scale: f64,
    /// The line is steep enough for a fourth pixel: dY > dX/2.
    pub fourth: bool,
    /// The major axis is the screen's y axis.
    pub steep: bool,
    /// The minor coordinate falls along the walk.
    pub falling: bool,
}

impl SetUp {
    /// The words of a line.
    #[must_use]
    pub fn new(path: &Path) -> Self {
        let (dx, dy) = (i64::from(path.major), i64::from(path.minor));
        let point = dx == 0;
        let d = if point {
            0.0
        } else {
            (dx as f64).hypot(dy as f64).recip()
        };
        Self {
            columns: dx,
            error_start: -dx,
            error_stay: 2 * dy,
            error_step: 2 * (dy - dx),
            error_offset: dx - 2 * dy,
            fraction_step: if point { 0.0 } else { dy as f64 / dx as f64 },
            cosine: path.cosine(),
            distance_start: -(dy as f64) * d,
            distance_stay: dy as f64 * d,
            distance_step: (dx - dy) as f64 * d,
            distance_scale: 0.5 * d,
            fourth: 2 * dy > dx,
            steep: path.steep,
            falling: path.falling,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::path::LIMIT;
    use super::super::{cone, Pixel};
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]
        #[test]
        fn words_are_in_their_ranges_and_make_the_walk(
            a in (-60..60i32, -60..60i32), b in (-60..60i32, -60..60i32), far: bool,
        ) {
            let scale = if far { LIMIT / 60 } else { 1 };
            let p = |(x, y): (i32, i32)| Pixel { x: x * scale, y: y * scale };
            let path = Path::new(p(a), p(b)).unwrap();
            let s = SetUp::new(&path);
            let root = 0.5f64.sqrt() + 1e-12;
            prop_assert!((0..=1 << 23).contains(&s.columns));
            prop_assert!((0..=2 * s.columns).contains(&s.error_stay) && (-2 * s.columns..=0).contains(&s.error_step));
            prop_assert!(s.error_offset.abs() <= s.columns);
            prop_assert!((0.0..=1.0).contains(&s.fraction_step) && (root - 1e-9..=1.0).contains(&s.cosine));
            prop_assert!((-root..=0.0).contains(&s.distance_start) && (0.0..=root).contains(&s.distance_stay));
            prop_assert!((0.0..=1.0).contains(&s.distance_step) && (0.0..=0.5).contains(&s.distance_scale));
            if far { return Ok(()); }
            let (mut e, mut d) = (s.error_start, s.distance_start);
            for c in path.columns() {
                let step = e > 0;
                e += if step { s.error_step } else { s.error_stay };
                d += if step { -s.distance_step } else { s.distance_stay };
                prop_assert_eq!(e, c.error);
                let want = cone::distance(&path, c);
                prop_assert!((d - want).abs() < 1e-12);
                prop_assert!(((e + s.error_offset) as f64 * s.distance_scale - want).abs() < 1e-12);
            }
        }
    }
}
