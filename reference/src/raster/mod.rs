//! Screen-space triangles as pixels: which centres a triangle covers, and the exact integer walk that visits them.

pub mod constant_depth;
pub mod coverage;
pub mod touch;
pub mod walk;

pub use constant_depth::{constant_depth, ConstantDepth};
pub use coverage::covers;
pub use touch::covers_any;
pub use walk::{EdgeDda, Span, Walk};

/// Fraction bits of a snapped screen coordinate.
pub const SUBPIXEL_BITS: u32 = 8;
/// Sub-pixel steps per pixel.
pub const SUBPIXELS: i32 = 1 << SUBPIXEL_BITS;
/// Largest magnitude of a snapped coordinate that the integer set-up takes, in sub-pixels (about one million pixels).
/// Products of two differences then stay below 2^60.
pub const COORDINATE_LIMIT: i32 = 1 << 28;

/// A snapped screen position in units of 1/256 pixel; x to the right, y down, pixel (0, 0) has its centre at (128, 128).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Point {
    /// Horizontal position in 1/256 pixel.
    pub x: i32,
    /// Vertical position in 1/256 pixel.
    pub y: i32,
}

impl Point {
    /// Snaps a position in pixels to the sub-pixel grid (round to nearest, halves away from zero).
    /// `None` for values that are not finite or beyond [`COORDINATE_LIMIT`].
    #[must_use]
    pub fn snap(x: f64, y: f64) -> Option<Self> {
        let one = |v: f64| {
            let s = v * f64::from(SUBPIXELS);
            // Rounds without a call of the mathematics library; what is too large saturates and is refused below.
            let whole = s as i32;
            let rest = s - f64::from(whole);
            let rounded = whole
                .saturating_add(i32::from(rest >= 0.5))
                .saturating_sub(i32::from(rest <= -0.5));
            (s.abs() < f64::from(COORDINATE_LIMIT) + 0.5).then_some(rounded)
        };
        Some(Self {
            x: one(x)?,
            y: one(y)?,
        })
    }

    /// Position in pixels.
    #[must_use]
    pub fn pixels(self) -> (f64, f64) {
        let s = f64::from(SUBPIXELS);
        (f64::from(self.x) / s, f64::from(self.y) / s)
    }
}

/// The pixels that exist: columns `0..width`, rows `0..height`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// Twice the signed area of a triangle in sub-pixels squared; positive when the vertices turn clockwise on the screen
/// (y points down).
#[must_use]
pub fn area2(p: [Point; 3]) -> i64 {
    let d = |a: Point, b: Point| {
        (
            i64::from(b.x) - i64::from(a.x),
            i64::from(b.y) - i64::from(a.y),
        )
    };
    let (ux, uy) = d(p[0], p[1]);
    let (vx, vy) = d(p[0], p[2]);
    ux * vy - uy * vx
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_rounds_to_nearest_halves_away_from_zero() {
        let limit = f64::from(COORDINATE_LIMIT);
        let mut sub_pixels = vec![
            0.5f64.next_down(),
            limit,
            limit + 0.4,
            limit + 0.5,
            1e30,
            f64::NAN,
            f64::INFINITY,
        ];
        sub_pixels.extend((-4000..4000).map(|i| f64::from(i) / 8.0));
        for s in sub_pixels
            .iter()
            .flat_map(|s| [*s, -s, s.next_up(), s.next_down()])
        {
            let want = (s.round().abs() <= limit).then(|| s.round() as i32);
            let got = Point::snap(s / 256.0, 0.0).map(|p| p.x);
            assert_eq!(got, want, "{s}");
        }
    }
}
