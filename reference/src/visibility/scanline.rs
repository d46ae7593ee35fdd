//! Scan-line visibility: row by row, the spans of all triangles are cut at each other's ends; between two ends the same
//! spans lie over one another, and one of them is seen until another one rises above it. No depth buffer, nothing is
//! cleared, and every pixel is written exactly once (Loisel 1996, section on visible surfaces).

use super::{each_span, pixel, DepthPlane, Visible};
use crate::geometry::Prepared;

/// A triangle in a row.
#[derive(Clone, Copy, Debug)]
struct Active {
    triangle: u32,
    start: i32,
    end: i32,
}

/// Draws all triangles.
#[must_use]
pub fn draw(p: &Prepared) -> Visible {
    let planes: Vec<DepthPlane> = p.triangles.iter().map(DepthPlane::new).collect();
    let mut rows: Vec<Vec<Active>> = vec![Vec::new(); p.height as usize];
    for (i, t) in p.triangles.iter().enumerate() {
        each_span(p, t, |s| {
            rows[s.y as usize].push(Active {
                triangle: i as u32,
                start: s.start,
                end: s.end,
            });
        });
    }
    let mut visible = Visible::new(p);
    let mut active: Vec<Active> = Vec::new();
    for (y, spans) in rows.iter_mut().enumerate() {
        spans.sort_by_key(|s| s.start);
        let mut ends: Vec<i32> = spans.iter().flat_map(|s| [s.start, s.end]).collect();
        ends.sort_unstable();
        ends.dedup();
        let mut waiting = spans.iter().peekable();
        active.clear();
        for pair in ends.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            active.retain(|s| s.end > from);
            while let Some(s) = waiting.next_if(|s| s.start == from) {
                active.push(*s);
            }
            if !active.is_empty() {
                segment(p, &planes, &active, y as i32, from, to, &mut visible);
            }
        }
    }
    visible
}

/// Draws columns `from..to`, over all of which the `active` spans reach.
fn segment(
    p: &Prepared,
    planes: &[DepthPlane],
    active: &[Active],
    y: i32,
    from: i32,
    to: i32,
    visible: &mut Visible,
) {
    let depth = |triangle: u32, x: i32| {
        planes[triangle as usize].at(f64::from(x) + 0.5, f64::from(y) + 0.5)
    };
    let slope = |triangle: u32| planes[triangle as usize].slope[0];
    let mut x = from;
    while x < to {
        // The nearest here; of equals the first of the list.
        let mut top = active[0].triangle;
        for s in &active[1..] {
            let (a, b) = (depth(s.triangle, x), depth(top, x));
            if a > b || (a == b && s.triangle < top) {
                top = s.triangle;
            }
        }
        // Where another one rises above it first; from the pixel after this at the earliest.
        let mut until = to;
        for s in active.iter().filter(|s| s.triangle != top) {
            let gain = slope(s.triangle) - slope(top);
            if gain > 0.0 {
                let columns = (depth(top, x) - depth(s.triangle, x)) / gain;
                // A difference that overflows or is not a number saturates to a column that does not limit.
                let crossing = x.saturating_add((columns.ceil() as i32).max(1));
                until = until.min(crossing);
            }
        }
        for column in x..until {
            visible.write(pixel(p, column, y), top as usize);
        }
        x = until;
    }
}
