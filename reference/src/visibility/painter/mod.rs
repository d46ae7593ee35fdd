//! Painter's order: what is farther is painted first (Newell, Newell and Sancha 1972, as told by Loisel 1996).
//!
//! Two triangles need an order only where they overlap on the screen. There both depths are planes over the screen, so
//! the difference takes its extremes at the corners of the overlap, and its signs decide exactly: one is nearer all over,
//! or both tie and any order will do, or they *interpenetrate* and one is cut along the line where they are equally deep.
//! What must be painted before what is a graph; as long as it has an order, that is a painter's order. Where triangles
//! overlap in a *cycle*, one of them is cut by the plane of its neighbour in the cycle and the graph is made anew.

mod part;

use super::piece::Piece;
use super::{DepthPlane, Visible};
use crate::geometry::Prepared;
use part::{relation, Cut, Part, Relation};
use std::collections::BinaryHeap;

/// Side of the cells that are searched for overlaps, pixels.
const CELL: f64 = 16.0;
/// Times that triangles may be cut before what is left is painted as it comes.
const ROUNDS: usize = 256;

/// What happened on the way to an order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PainterCounts {
    /// Pairs whose boxes on the screen overlap.
    pub pairs: u64,
    /// Pairs of which one reaches through the other.
    pub interpenetrating: u64,
    /// Cycles found.
    pub cycles: u64,
    /// Cuts made.
    pub cuts: u64,
    /// Parts in a cycle that no cut could resolve; zero unless rounding made the cycle.
    pub unresolved: u64,
}

/// Pairs of parts whose boxes on the screen overlap, each once.
fn pairs(p: &Prepared, parts: &[Part]) -> Vec<(usize, usize)> {
    let columns = (f64::from(p.width) / CELL).ceil() as usize;
    let rows = (f64::from(p.height) / CELL).ceil() as usize;
    // Nothing beyond the frame matters: what lies there is searched with its border.
    let cell = |v: f64, count: usize| ((v / CELL).max(0.0) as usize).min(count - 1);
    let reach = |part: &Part, axis: usize, count| {
        cell(part.low[axis], count)..=cell(part.high[axis], count)
    };
    let mut cells = vec![Vec::new(); columns * rows];
    for (i, part) in parts.iter().enumerate() {
        for y in reach(part, 1, rows) {
            for x in reach(part, 0, columns) {
                cells[y * columns + x].push(i);
            }
        }
    }
    let mut pairs = Vec::new();
    for (k, cell_parts) in cells.iter().enumerate() {
        for (n, &i) in cell_parts.iter().enumerate() {
            for &j in &cell_parts[n + 1..] {
                let (a, b) = (&parts[i], &parts[j]);
                let meet = |axis: usize| a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis];
                // Only in the first cell that both reach.
                let first = cell(a.low[1].max(b.low[1]), rows) * columns
                    + cell(a.low[0].max(b.low[0]), columns);
                let same = a.piece.triangle == b.piece.triangle;
                if k == first && !same && meet(0) && meet(1) {
                    pairs.push((i, j));
                }
            }
        }
    }
    pairs
}

/// A painter's order of all triangles, cut where they must be, and what it took.
fn order(p: &Prepared) -> (Vec<Part>, PainterCounts) {
    let mut counts = PainterCounts::default();
    let mut parts: Vec<Part> = p
        .triangles
        .iter()
        .enumerate()
        .map(|(i, t)| {
            let corners = t.position.map(|q| {
                let (x, y) = q.pixels();
                [x, y]
            });
            Part::new(Piece::whole(i), DepthPlane::new(t), corners.to_vec())
        })
        .collect();
    for round in 0..=ROUNDS {
        let last = round == ROUNDS;
        let mut nearer: Vec<Vec<usize>> = vec![Vec::new(); parts.len()];
        let mut cuts: Vec<Option<Cut>> = vec![None; parts.len()];
        let found = pairs(p, &parts);
        counts.pairs = found.len() as u64;
        for (i, j) in found {
            match relation(&parts[i], &parts[j]) {
                Relation::Free => {}
                Relation::FirstNearer => nearer[j].push(i),
                Relation::SecondNearer => nearer[i].push(j),
                Relation::Interpenetrate => {
                    // One cut for a part in a round; what it leaves is looked at again.
                    if cuts[i].is_none() && cuts[j].is_none() {
                        counts.interpenetrating += 1;
                        cuts[i] = Some(Cut::equally_deep(&parts[i], &parts[j]));
                    }
                }
            }
        }
        if !last && cuts.iter().any(Option::is_some) {
            counts.cuts += apply(p, &mut parts, &cuts);
            continue;
        }
        let (mut sorted, cycle) = sort(&parts, &nearer);
        let in_order = sorted.len() == parts.len();
        if !in_order && !last {
            counts.cycles += 1;
            let mut cuts = vec![None; parts.len()];
            if let Some((part, cut)) = breaking(p, &parts, &cycle) {
                cuts[part] = Some(cut);
                counts.cuts += apply(p, &mut parts, &cuts);
                continue;
            }
        }
        if !in_order {
            let mut there = vec![false; parts.len()];
            sorted.iter().for_each(|i| there[*i] = true);
            let mut rest: Vec<usize> = (0..parts.len()).filter(|i| !there[*i]).collect();
            rest.sort_by(|a, b| parts[*a].farthest().total_cmp(&parts[*b].farthest()));
            counts.unresolved = rest.len() as u64;
            sorted.extend(rest);
        }
        let ordered = sorted.iter().map(|i| parts[*i].clone()).collect();
        return (ordered, counts);
    }
    (parts, counts)
}

/// Cuts parts; says how many cuts were made.
fn apply(p: &Prepared, parts: &mut Vec<Part>, cuts: &[Option<Cut>]) -> u64 {
    let mut made = 0;
    for (i, cut) in cuts.iter().enumerate() {
        if let Some([inner, outer]) = cut.and_then(|cut| parts[i].cut(p, &cut)) {
            parts[i] = inner;
            parts.push(outer);
            made += 1;
        }
    }
    made
}

/// A cut that takes a cycle apart: along the plane of a neighbour, or, where each lies wholly on one side of the next,
/// along an edge of it. Finitely many such lines divide the screen into finitely many parts, so that this comes to an end.
fn breaking(p: &Prepared, parts: &[Part], cycle: &[usize]) -> Option<(usize, Cut)> {
    let neighbours = || cycle.windows(2).flat_map(|w| [(w[0], w[1]), (w[1], w[0])]);
    let planes = neighbours().map(|(a, b)| (a, Cut::equally_deep(&parts[a], &parts[b])));
    let edges = neighbours().flat_map(|(a, b)| Cut::edges(&parts[b]).map(move |cut| (a, cut)));
    planes
        .chain(edges)
        .find(|(a, cut)| parts[*a].cut(p, cut).is_some())
}

/// Paints what nothing unpainted lies behind, of several the last triangle first, so that of equal depths the first is
/// seen. Also, when not all could be painted, a cycle: parts each of which must be painted before the next, the first
/// repeated at the end.
fn sort(parts: &[Part], nearer: &[Vec<usize>]) -> (Vec<usize>, Vec<usize>) {
    let mut behind = vec![0usize; parts.len()];
    nearer.iter().flatten().for_each(|j| behind[*j] += 1);
    let key = |i: usize| (parts[i].piece.triangle, i);
    let mut ready: BinaryHeap<(usize, usize)> = (0..parts.len())
        .filter(|i| behind[*i] == 0)
        .map(key)
        .collect();
    let mut sorted = Vec::with_capacity(parts.len());
    while let Some((_, i)) = ready.pop() {
        sorted.push(i);
        for &j in &nearer[i] {
            behind[j] -= 1;
            if behind[j] == 0 {
                ready.push(key(j));
            }
        }
    }
    let mut cycle = Vec::new();
    if let Some(start) = (0..parts.len()).find(|i| behind[*i] > 0) {
        // Everything left has something left behind it: going back must return.
        let mut seen = vec![usize::MAX; parts.len()];
        let mut at = start;
        while seen[at] == usize::MAX {
            seen[at] = cycle.len();
            cycle.push(at);
            let before = (0..parts.len()).find(|i| behind[*i] > 0 && nearer[*i].contains(&at));
            let Some(before) = before else { break };
            at = before;
        }
        cycle.drain(..seen[at].min(cycle.len()));
        cycle.push(at);
        cycle.reverse();
    }
    (sorted, cycle)
}

/// Draws all triangles in painter's order.
#[must_use]
pub fn draw(p: &Prepared) -> (Visible, PainterCounts) {
    let (parts, counts) = order(p);
    let mut visible = Visible::new(p);
    for part in &parts {
        let triangle = part.piece.triangle;
        part.piece.each_pixel(p, |at| visible.write(at, triangle));
    }
    (visible, counts)
}

/// The cheap form: sorted by the farthest vertex, without any test; wrong wherever ranges of depth overlap unluckily.
#[must_use]
pub fn draw_by_farthest(p: &Prepared) -> Visible {
    let far = |i: &usize| {
        let d = p.triangles[*i].depth;
        d[0].min(d[1]).min(d[2])
    };
    let mut order: Vec<(f64, usize)> = (0..p.triangles.len()).map(|i| (far(&i), i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    let mut visible = Visible::new(p);
    for (_, i) in order {
        super::each_span(p, &p.triangles[i], |span| {
            let at = super::pixel(p, span.start, span.y);
            let count = (span.end - span.start) as usize;
            visible.ids[at..at + count].fill(i as u32);
            visible.written += count as u64;
        });
    }
    visible
}
