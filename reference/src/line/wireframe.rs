//! Wireframe with hidden lines removed: edges over a finished frame, far ones first.
//!
//! Which parts of an edge are hidden is worked out exactly ([`super::hidden`]), for each edge against the faces of the
//! cells of the screen that it crosses; the weights of the pixels beside the line need no depth. Column k of N + 1
//! stands for the k-th of N + 1 equal parts of the edge and is drawn when the middle of its part is visible: so the
//! ends, where many faces meet, decide nothing.
//!
//! Lines join pixel centres, as a line core draws them: the ends of an edge move to the centres of the pixels they are
//! in, by at most half a pixel each way. Edges that share a vertex meet in one pixel.

use super::blend::blend;
use super::coverage::Table;
use super::cue::Ramp;
use super::hidden::{hidden, Occluder, Sight};
use super::{box_filter, bresenham, cone, LineFilter, Path, Pixel};
use crate::geometry::{WireEdge, Wires};
use crate::parallel;
use crate::raster::SUBPIXEL_BITS;
use crate::render::Frame;
use crate::shade::to_byte;

/// Side of the cells that faces are sorted into, pixels.
const CELL_BITS: u32 = 5;
/// Address bits and full level of the table of weights: an error of less than one LSB.
const TABLE: (u32, u16) = (8, 255);

/// The table of weights that cone-filtered wires are drawn with.
#[must_use]
pub fn table() -> Table {
    Table::new(TABLE.0, TABLE.1)
}

/// Draws the wires over a frame.
pub fn draw(wires: &Wires, frame: &mut Frame) {
    let table = table();
    for s in strokes(wires, frame.width, frame.height) {
        s.pixels(wires.filter, &table, |x, p, level| {
            let inside =
                (0..frame.width as i32).contains(&p.x) && (0..frame.height as i32).contains(&p.y);
            if inside {
                let pixel = &mut frame.pixels[p.y as usize * frame.width as usize + p.x as usize];
                *pixel = blend(*pixel, s.colour_at(x), level, table.full());
            }
        });
    }
}

/// An edge as it is drawn: a walk, the colour along it, and which of its columns are seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// The walk.
    pub path: Path,
    /// Colour before depth cueing, LSB.
    pub colour: [f64; 3],
    /// Factor of the colour along the walk.
    pub ramp: Ramp,
    /// For every column of the walk, whether it is drawn.
    pub visible: Vec<bool>,
    /// Index of the edge.
    pub edge: usize,
}

impl Stroke {
    /// The colour of a column.
    #[must_use]
    pub fn colour_at(&self, x: i32) -> [u8; 3] {
        self.colour.map(|c| to_byte(c * self.ramp.at(x)))
    }

    /// Calls `put(column, pixel, level)` for every pixel of the visible columns whose level is not 0; pixels may lie
    /// outside the frame.
    pub fn pixels(&self, filter: LineFilter, table: &Table, mut put: impl FnMut(i32, Pixel, u16)) {
        let path = &self.path;
        let mut put = |p: Pixel, level: u16| {
            let x = if path.steep {
                p.y - path.place(0, 0).y
            } else {
                p.x - path.place(0, 0).x
            };
            if level != 0 && self.visible.get(x as usize) == Some(&true) {
                put(x, p, level);
            }
        };
        match filter {
            LineFilter::Bresenham => bresenham::pixels(path).for_each(|p| put(p, table.full())),
            LineFilter::Box => box_filter::pixels(path)
                .for_each(|(p, w)| put(p, (w * f64::from(table.full())).round() as u16)),
            LineFilter::Cone => cone::pixels(path, cone::Fourth::NearDiagonal)
                .for_each(|(p, d)| put(p, table.level(d))),
        }
    }
}

/// What is drawn for the wires in a frame, far ones first; of equals, in their order.
#[must_use]
pub fn strokes(wires: &Wires, width: u32, height: u32) -> Vec<Stroke> {
    let hidden = hidden_parts(wires, width, height);
    let nearest = |e: &WireEdge| e.sight.nearness[0].max(e.sight.nearness[1]);
    let mut order: Vec<usize> = (0..wires.edges.len()).collect();
    order.sort_by(|a, b| nearest(&wires.edges[*a]).total_cmp(&nearest(&wires.edges[*b])));
    order
        .into_iter()
        .filter_map(|i| stroke(wires, i, &hidden[i]))
        .collect()
}

/// For every edge the intervals of t in which it is hidden, in no order and possibly overlapping. Only what is hidden
/// within the frame is certain to be found.
#[must_use]
pub fn hidden_parts(wires: &Wires, width: u32, height: u32) -> Vec<Vec<[f64; 2]>> {
    let cells = Cells::new(&wires.faces, width, height);
    let find = |i: usize| {
        let e = &wires.edges[i];
        let faces = cells.along(&e.sight);
        faces
            .iter()
            .filter_map(|f| hidden(&e.sight, &wires.faces[*f as usize]))
            .collect()
    };
    parallel::map(wires.edges.len(), find)
}

fn stroke(wires: &Wires, edge: usize, hidden: &[[f64; 2]]) -> Option<Stroke> {
    let e = &wires.edges[edge];
    let [from, to] = e.sight.ends.map(|p| Pixel {
        x: p.x >> SUBPIXEL_BITS,
        y: p.y >> SUBPIXEL_BITS,
    });
    // Snapped positions are well within the limit of paths.
    let path = Path::new(from, to)?;
    let forward = path.starts_at(from);
    let factor = e.depth.map(|z| wires.cue.factor(z, wires.depth_range));
    let [first, last] = if forward {
        factor
    } else {
        [factor[1], factor[0]]
    };
    let columns = f64::from(path.major) + 1.0;
    let visible = |x: i32| {
        let t = (f64::from(x) + 0.5) / columns;
        let t = if forward { t } else { 1.0 - t };
        !hidden.iter().any(|[a, b]| (*a..=*b).contains(&t))
    };
    Some(Stroke {
        path,
        colour: e.colour,
        ramp: Ramp::new(first, last, path.major),
        visible: (0..=path.major).map(visible).collect(),
        edge,
    })
}

/// Faces by the cells of the screen that their bounding boxes touch. What lies beside the screen counts to the cells at
/// its border; clamping keeps order, so nothing is lost.
struct Cells {
    columns: i32,
    rows: i32,
    faces: Vec<Vec<u32>>,
}

impl Cells {
    fn new(all: &[Occluder], width: u32, height: u32) -> Self {
        let count = |pixels: u32| (pixels.div_ceil(1 << CELL_BITS)).max(1) as i32;
        let (columns, rows) = (count(width), count(height));
        let mut cells = Self {
            columns,
            rows,
            faces: vec![Vec::new(); columns as usize * rows as usize],
        };
        for (i, f) in (0u32..).zip(all) {
            let [x0, x1] = range(f.position.map(|p| p.x), columns);
            let [y0, y1] = range(f.position.map(|p| p.y), rows);
            for y in y0..=y1 {
                for x in x0..=x1 {
                    cells.faces[(y * columns + x) as usize].push(i);
                }
            }
        }
        cells
    }

    /// Faces in the cells that an edge crosses, each once.
    fn along(&self, e: &Sight) -> Vec<u32> {
        let mut found = Vec::new();
        let [a, b] = e.ends;
        let [y0, y1] = range(e.ends.map(|p| p.y), self.rows);
        for y in y0..=y1 {
            // The part of the edge in this row of cells, one sub-pixel added on either side for its rounding.
            let border = |row: i32| f64::from(row) * f64::from(1 << (CELL_BITS + SUBPIXEL_BITS));
            let lowest = if y == 0 { f64::NEG_INFINITY } else { border(y) };
            let highest = if y == self.rows - 1 {
                f64::INFINITY
            } else {
                border(y + 1)
            };
            let x_at = |limit: f64| {
                let (p, q) = if a.y <= b.y { (a, b) } else { (b, a) };
                let height = f64::from(q.y - p.y);
                let share = if height > 0.0 {
                    (limit - f64::from(p.y)) / height
                } else {
                    0.0
                };
                f64::from(p.x) + f64::from(q.x - p.x) * share.clamp(0.0, 1.0)
            };
            let level = a.y == b.y;
            let ends = if level {
                [f64::from(a.x), f64::from(b.x)]
            } else {
                [x_at(lowest), x_at(highest)]
            };
            let [lo, hi] = [ends[0].min(ends[1]) - 1.0, ends[0].max(ends[1]) + 1.0];
            let [x0, x1] = range([lo as i32, hi as i32], self.columns);
            for x in x0..=x1 {
                found.extend_from_slice(&self.faces[(y * self.columns + x) as usize]);
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// First and last cell of some sub-pixel coordinates.
fn range<const N: usize>(v: [i32; N], cells: i32) -> [i32; 2] {
    let cell = |v: i32| (v >> (CELL_BITS + SUBPIXEL_BITS)).clamp(0, cells - 1);
    let lo = v.iter().copied().min().unwrap_or_default();
    let hi = v.iter().copied().max().unwrap_or_default();
    [cell(lo), cell(hi)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Point;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = Point> {
        (-60_000..120_000i32, -60_000..90_000i32).prop_map(|(x, y)| Point { x, y })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        /// The cells lose no face that hides something, compared with trying all.
        #[test]
        fn cells_find_what_trying_all_finds(
            faces in prop::collection::vec((prop::array::uniform3(point()), 0.0..1.0f64), 1..40),
            ends in prop::array::uniform2(point()),
        ) {
            let faces: Vec<Occluder> = faces
                .into_iter()
                .map(|(position, n)| Occluder { position, nearness: [n; 3] })
                .collect();
            let sight = Sight { ends, nearness: [0.3, 0.4] };
            let found = Cells::new(&faces, 300, 200).along(&sight);
            for (i, f) in (0u32..).zip(&faces) {
                if hidden(&sight, f).is_some() {
                    prop_assert!(found.contains(&i), "{f:?}");
                }
            }
        }
    }
}
