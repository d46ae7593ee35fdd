//! A line as a walk along its major axis: 0 ≤ dY ≤ dX after swapping and mirroring, and one integer error term that all
//! kinds of lines share (Bresenham 1965; Abbas 2003, listing of section 3.1; the error term with doubled denominator,
//! so that no half appears, also in 3D graphics texts under no name).
//!
//! E starts at −dX. In every column: if E ≤ 0 then E += 2·dY, else E += 2·(dY − dX) and Y += 1; then the column is
//! drawn. The first column always takes the first branch. The hardware description printed with the method tests E < 0,
//! which is another tie rule and moves a line of one pixel (dX = 0) off its place; E ≤ 0 is right for both.

/// Greatest magnitude of a coordinate of an end point, pixels.
pub const LIMIT: i32 = 1 << 22;

/// A pixel of the (unbounded) grid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Pixel {
    /// Column, to the right.
    pub x: i32,
    /// Row, downwards.
    pub y: i32,
}

/// A line in the first octant of its own coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Path {
    /// Where the walk starts: the left end, or the upper one of a steep line.
    origin: Pixel,
    /// Steps along the major axis, dX ≥ 0. There are dX + 1 columns.
    pub major: i32,
    /// Steps along the minor axis, 0 ≤ dY ≤ dX.
    pub minor: i32,
    /// The major axis is the screen's y axis.
    pub steep: bool,
    /// The minor coordinate of the screen falls along the walk.
    pub falling: bool,
}

/// One column of a walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Steps along the major axis, 0..=dX.
    pub x: i32,
    /// Steps along the minor axis of the pixel nearest to the line; ties stay.
    pub y: i32,
    /// The error term after its update, 2·dY·(x + 1) − 2·dX·y − dX; within ±2·dX.
    pub error: i64,
    /// Whether `y` is one more than in the column before.
    pub stepped: bool,
}

impl Path {
    /// The line from `a` to `b`, both included; the same for `b` to `a`. `None` when a coordinate is beyond [`LIMIT`].
    #[must_use]
    pub fn new(a: Pixel, b: Pixel) -> Option<Self> {
        let fits = |p: Pixel| (-LIMIT..=LIMIT).contains(&p.x) && (-LIMIT..=LIMIT).contains(&p.y);
        if !fits(a) || !fits(b) {
            return None;
        }
        let steep = (b.y - a.y).abs() > (b.x - a.x).abs();
        let along = |p: Pixel| if steep { p.y } else { p.x };
        let across = |p: Pixel| if steep { p.x } else { p.y };
        let (a, b) = if along(a) <= along(b) { (a, b) } else { (b, a) };
        let rise = across(b) - across(a);
        Some(Self {
            origin: a,
            major: along(b) - along(a),
            minor: rise.abs(),
            steep,
            falling: rise < 0,
        })
    }

    /// Whether [`Path::new`] walks from its second argument to its first.
    #[must_use]
    pub fn starts_at(&self, a: Pixel) -> bool {
        self.origin == a
    }

    /// The pixel of the screen at major step `x` and minor step `y`.
    #[must_use]
    pub fn place(&self, x: i32, y: i32) -> Pixel {
        let y = if self.falling { -y } else { y };
        let (dx, dy) = if self.steep { (y, x) } else { (x, y) };
        Pixel {
            x: self.origin.x + dx,
            y: self.origin.y + dy,
        }
    }

    /// Cosine of the angle between line and major axis, dX / √(dX² + dY²), 0.707 to 1; 1 for a line of one pixel.
    #[must_use]
    pub fn cosine(&self) -> f64 {
        if self.major == 0 {
            return 1.0;
        }
        f64::from(self.major) / f64::from(self.major).hypot(f64::from(self.minor))
    }

    /// The columns, major coordinate rising.
    pub fn columns(&self) -> impl Iterator<Item = Column> {
        let (dx, dy) = (i64::from(self.major), i64::from(self.minor));
        let (mut error, mut y) = (-dx, 0);
        (0..=self.major).map(move |x| {
            let stepped = error > 0;
            if stepped {
                error += 2 * (dy - dx);
                y += 1;
            } else {
                error += 2 * dy;
            }
            Column {
                x,
                y,
                error,
                stepped,
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn pixel(limit: i32) -> impl Strategy<Value = Pixel> {
        (-limit..=limit, -limit..=limit).prop_map(|(x, y)| Pixel { x, y })
    }

    #[test]
    fn what_is_too_far_is_refused() {
        let far = Pixel {
            x: LIMIT,
            y: -LIMIT,
        };
        assert!(Path::new(
            far,
            Pixel {
                x: -LIMIT,
                y: LIMIT
            }
        )
        .is_some());
        assert_eq!(Path::new(far, Pixel { x: 0, y: i32::MIN }), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn both_directions_are_one_path_in_the_first_octant(a in pixel(200), b in pixel(200)) {
            let p = Path::new(a, b).unwrap();
            prop_assert_eq!(Path::new(b, a).unwrap(), p);
            prop_assert!(0 <= p.minor && p.minor <= p.major);
            let ends = [p.place(0, 0), p.place(p.major, p.minor)];
            prop_assert!(ends == [a, b] || ends == [b, a]);
        }

        #[test]
        fn the_error_term_is_its_closed_form_and_stays_small(a in pixel(300), b in pixel(300)) {
            let p = Path::new(a, b).unwrap();
            let (dx, dy) = (i64::from(p.major), i64::from(p.minor));
            for c in p.columns() {
                prop_assert_eq!(c.error, 2 * dy * i64::from(c.x + 1) - 2 * dx * i64::from(c.y) - dx);
                prop_assert!(c.error.abs() <= 2 * dx);
            }
            let last = p.columns().last().unwrap();
            prop_assert_eq!((last.x, last.y), (p.major, p.minor));
        }
    }
}
