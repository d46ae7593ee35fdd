//! The edge walk: every span of a triangle by additions on integers, exact at pixel centres.
//!
//! Along an edge from (xa, ya) to (xb, yb), in sub-pixels, the first covered column of row r is
//! X(r) = ceil(n(r) / (256·dy)), n(r) = (xa − 128)·dy + (256·r + 128 − ya)·dx.
//! From row to row n grows by 256·dx, so X grows by a = floor(dx / dy), and by one more when an error term carries
//! (Bresenham's argument for a digital differential analyser; the papers step a truncated real slope instead and
//! sample up to a pixel beside the centre: Abbas 2003, algorithms of section 2.2).
//!
//! The walk starts on the *major* edge, the one that spans all rows, and runs towards the two *minor* edges. When the
//! major edge is the right one, everything is done in the mirrored column x' = −1 − x (the bitwise complement of x),
//! so one set-up serves both orientations and nothing is reloaded at the middle vertex.

use super::{Point, Viewport, COORDINATE_LIMIT, SUBPIXELS};

/// One edge as an exact digital differential analyser over rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EdgeDda {
    /// Column (walk space) at the first row of the edge's section.
    pub column: i32,
    /// Whole columns per row, rounded down.
    pub whole: i32,
    /// Error term, biased so that its sign decides: the next row step carries when it is not negative.
    pub error: i32,
    /// Added to the error term when it does not carry; in `0..dy`.
    pub up: i32,
    /// Added to the error term when it carries: `up - dy`, negative.
    pub down: i32,
}

impl EdgeDda {
    /// Whether the step to the next row moves one column more than [`EdgeDda::whole`].
    #[must_use]
    pub fn carries(&self) -> bool {
        self.error >= 0
    }

    /// Moves to the next row.
    pub fn step(&mut self) {
        let carry = self.carries();
        self.column = self
            .column
            .wrapping_add(self.whole)
            .wrapping_add(i32::from(carry));
        self.error += if carry { self.down } else { self.up };
    }

    /// Moves `rows` rows at once. With dy = up − down and r = error + dy − up in 0..dy, the carries of k steps are
    /// floor((r + k·up) / dy).
    fn advance(&mut self, rows: u32) {
        let dy = i64::from(self.up) - i64::from(self.down);
        if dy == 0 {
            return;
        }
        let k = i64::from(rows);
        let sum = i64::from(self.error) + dy - i64::from(self.up) + k * i64::from(self.up);
        let columns = k * i64::from(self.whole) + sum.div_euclid(dy);
        self.column = self.column.wrapping_add(columns as i32);
        self.error = (sum.rem_euclid(dy) - dy + i64::from(self.up)) as i32;
    }

    /// The edge from `a` (upper) to `b` (lower) at pixel row `row`; `rows` is how many rows will be visited.
    fn new(a: Point, b: Point, row: i32, rows: u32, mirrored: bool) -> Self {
        let (ax, ay) = (i64::from(a.x), i64::from(a.y));
        let (dx, dy) = (i64::from(b.x) - ax, i64::from(b.y) - ay);
        let s = i64::from(SUBPIXELS);
        let den = s * dy;
        let n = (ax - s / 2) * dy + (s * i64::from(row) + s / 2 - ay) * dx;
        let (n, dx) = if mirrored {
            (-n, -dx)
        } else {
            (n + den - 1, dx)
        };
        let column = n.div_euclid(den) as i32;
        // With a single row nothing is ever stepped, and the slope of a nearly level edge need not fit.
        let (whole, up) = if rows > 1 {
            (dx.div_euclid(dy) as i32, dx.rem_euclid(dy))
        } else {
            (0, 0)
        };
        let error = (n.rem_euclid(den) / s + up - dy) as i32;
        Self {
            column,
            whole,
            error,
            up: up as i32,
            down: (up - dy) as i32,
        }
    }
}

/// One row of a triangle: columns `start..end` on the screen, already limited to the viewport, never empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// Pixel row.
    pub y: i32,
    /// First covered column.
    pub start: i32,
    /// One past the last covered column.
    pub end: i32,
}

/// The integer set-up of a triangle: where its rows begin and end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Walk {
    /// Columns are complemented: the major edge is on the right and spans run leftwards.
    pub mirrored: bool,
    /// First row.
    pub first_row: i32,
    /// Rows in all; at least one.
    pub rows: u32,
    /// Rows bounded by the upper minor edge; the remaining ones by the lower minor edge.
    pub upper_rows: u32,
    /// The edge that spans all rows; a span starts at its column (inclusive, walk space).
    pub major: EdgeDda,
    /// Upper and lower minor edges; a span ends before their column (exclusive, walk space).
    pub minor: [EdgeDda; 2],
}

/// First row whose centre is at or below `y` (sub-pixels).
fn first_row_at(y: i32) -> i32 {
    (i64::from(y) - i64::from(SUBPIXELS / 2) + i64::from(SUBPIXELS - 1))
        .div_euclid(i64::from(SUBPIXELS)) as i32
}

impl Walk {
    /// Sets up the walk over the rows of `viewport`; `None` when the area is zero or no row centre is crossed.
    ///
    /// # Panics
    /// When a coordinate exceeds [`COORDINATE_LIMIT`]; [`Point::snap`] never makes such a point.
    #[must_use]
    pub fn new(p: [Point; 3], viewport: Viewport) -> Option<Self> {
        assert!(
            p.iter()
                .all(|v| v.x.abs() <= COORDINATE_LIMIT && v.y.abs() <= COORDINATE_LIMIT),
            "coordinates are limited by Point::snap"
        );
        let mut v = p;
        v.sort_by_key(|q| (q.y, q.x));
        let [top, middle, bottom] = v;
        let area = super::area2([top, middle, bottom]);
        if area == 0 {
            return None;
        }
        // Clockwise top-middle-bottom on a y-down screen: the middle vertex lies right of the major edge.
        let mirrored = area < 0;
        let height = i32::try_from(viewport.height).unwrap_or(i32::MAX);
        let first_row = first_row_at(top.y).max(0);
        let end_row = first_row_at(bottom.y).min(height);
        if end_row <= first_row {
            return None;
        }
        let split = first_row_at(middle.y).clamp(first_row, end_row);
        let rows = (end_row - first_row) as u32;
        let upper_rows = (split - first_row) as u32;
        let lower_rows = rows - upper_rows;
        let edge = |a, b, row, rows| {
            if rows > 0 {
                EdgeDda::new(a, b, row, rows, mirrored)
            } else {
                EdgeDda::default()
            }
        };
        Some(Self {
            mirrored,
            first_row,
            rows,
            upper_rows,
            major: edge(top, bottom, first_row, rows),
            minor: [
                edge(top, middle, first_row, upper_rows),
                edge(middle, bottom, split, lower_rows),
            ],
        })
    }

    /// The spans in walk space, rows downwards: (row, first column, one past the last column); possibly empty
    /// (`end <= start`) and not limited to the viewport's columns.
    pub fn walk_spans(&self) -> impl Iterator<Item = (i32, i32, i32)> + '_ {
        let mut major = self.major;
        let mut minor = self.minor[usize::from(self.upper_rows == 0)];
        (0..self.rows).map(move |k| {
            let span = (self.first_row + k as i32, major.column, minor.column);
            major.step();
            if k + 1 == self.upper_rows {
                minor = self.minor[1];
            } else {
                minor.step();
            }
            span
        })
    }

    /// The walk from row `row` on; the same state as after stepping there row by row.
    fn at_row(&self, row: i32) -> Self {
        let skipped = (row - self.first_row).max(0) as u32;
        if skipped == 0 {
            return *self;
        }
        let mut to = *self;
        to.first_row = row;
        to.rows = self.rows.saturating_sub(skipped);
        to.major.advance(skipped);
        if skipped < self.upper_rows {
            to.minor[0].advance(skipped);
        } else {
            to.minor[1].advance(skipped - self.upper_rows);
        }
        to.upper_rows = self.upper_rows.saturating_sub(skipped);
        to
    }

    /// The spans of rows `from..to`, as [`Walk::spans`] gives them, without visiting the rows before.
    pub fn spans_within(&self, width: u32, from: i32, to: i32) -> impl Iterator<Item = Span> {
        let width = i32::try_from(width).unwrap_or(i32::MAX);
        let mut walk = self.at_row(from);
        let rows = (to - walk.first_row).clamp(0, walk.rows as i32);
        let mut left = walk.upper_rows;
        let mut minor = walk.minor[usize::from(left == 0)];
        (0..rows).filter_map(move |k| {
            let (first, last) = (walk.major.column, minor.column);
            walk.major.step();
            left = left.wrapping_sub(1);
            if left == 0 {
                minor = walk.minor[1];
            } else {
                minor.step();
            }
            let (start, end) = if walk.mirrored {
                (-last, -first)
            } else {
                (first, last)
            };
            let (start, end) = (start.max(0), end.min(width));
            (start < end).then_some(Span {
                y: walk.first_row + k,
                start,
                end,
            })
        })
    }

    /// The non-empty spans on the screen, rows downwards, limited to columns `0..width`.
    pub fn spans(&self, width: u32) -> impl Iterator<Item = Span> + '_ {
        let width = i32::try_from(width).unwrap_or(i32::MAX);
        self.walk_spans().filter_map(move |(y, from, to)| {
            let (start, end) = if self.mirrored {
                (-to, -from)
            } else {
                (from, to)
            };
            let (start, end) = (start.max(0), end.min(width));
            (start < end).then_some(Span { y, start, end })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::covers;
    use super::*;
    use proptest::prelude::*;

    fn check_against_the_oracle(p: [Point; 3], w: u32, h: u32) {
        let mut got = vec![0u32; (w * h) as usize];
        if let Some(walk) = Walk::new(
            p,
            Viewport {
                width: w,
                height: h,
            },
        ) {
            for s in walk.spans(w) {
                for x in s.start..s.end {
                    got[(s.y as u32 * w) as usize + x as usize] += 1;
                }
            }
        }
        for y in 0..h {
            for x in 0..w {
                let want = u32::from(covers(p, x as i32, y as i32));
                assert_eq!(got[(y * w + x) as usize], want, "pixel {x} {y} of {p:?}");
            }
        }
    }

    fn check_parts(p: [Point; 3], from: i32, to: i32) -> Result<(), TestCaseError> {
        let viewport = Viewport {
            width: 400,
            height: 300,
        };
        if let Some(walk) = Walk::new(p, viewport) {
            let some: Vec<Span> = walk.spans_within(400, from, to).collect();
            let rows = from..to;
            let all: Vec<Span> = walk.spans(400).filter(|s| rows.contains(&s.y)).collect();
            prop_assert_eq!(some, all);
        }
        Ok(())
    }

    fn point(limit: i32) -> impl Strategy<Value = Point> {
        (-limit..limit, -limit..limit).prop_map(|(x, y)| Point { x, y })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn the_walk_covers_what_the_rule_says(a in point(6000), b in point(6000), c in point(6000)) {
            check_against_the_oracle([a, b, c], 20, 16);
        }

        #[test]
        fn a_part_of_the_rows_is_a_part_of_the_spans(
            a in point(90_000), b in point(90_000), c in point(90_000), from in 0..300, rows in 0..40,
        ) {
            check_parts([a, b, c], from, from + rows)?;
        }

        #[test]
        fn coarse_grids_hit_every_tie(a in point(8), b in point(8), c in point(8)) {
            let s = |p: Point| Point { x: p.x * 128, y: p.y * 128 };
            check_against_the_oracle([s(a), s(b), s(c)], 5, 5);
        }

        #[test]
        fn huge_triangles(a in point(COORDINATE_LIMIT), b in point(COORDINATE_LIMIT), c in point(COORDINATE_LIMIT)) {
            check_against_the_oracle([a, b, c], 9, 7);
        }
    }
}
