//! The triangles of a frame in drawing order, as pieces of the parts that found them: known before they are made, so that
//! they can be made at the same time.

use super::prepare::Cast;
use super::selected::{Piece, Selected};
use super::{ScreenTriangle, UNSHARED};

/// Where each begins that is so long, and of all of them the end.
pub(super) fn starts(lengths: impl Iterator<Item = usize>) -> Vec<usize> {
    let sums = lengths.scan(0, |sum, n| {
        *sum += n;
        Some(*sum)
    });
    std::iter::once(0).chain(sums).collect()
}

/// From so many pieces on the run of a piece is looked for.
const HINT: usize = 16;

/// What is drawn, in order.
pub(super) struct List<'a> {
    cast: &'a Cast<'a>,
    /// The pieces of each part: first the fronts of all, by rank, then the backs, so that of equal depths the front wins.
    runs: Vec<Run<'a>>,
    /// Where each run begins, and of all of them the end.
    starts: Vec<usize>,
    /// The runs that pieces 0, [`HINT`], 2·[`HINT`], … are in.
    hints: Vec<u32>,
    pub(super) len: usize,
    /// Least and greatest nearness.
    range: [f64; 2],
}

struct Run<'a> {
    subject: usize,
    part: &'a Selected,
    pieces: &'a [Piece],
}

impl<'a> List<'a> {
    pub(super) fn new(cast: &'a Cast<'a>, parts: &'a [(usize, Selected)], ranks: &[usize]) -> Self {
        let run = |(subject, part): &'a (usize, Selected), pieces| Run {
            subject: *subject,
            part,
            pieces,
        };
        let mut by_rank: Vec<_> = parts.iter().collect();
        by_rank.sort_by_key(|p| ranks[p.0]);
        let fronts = by_rank.into_iter().map(|p| run(p, &p.1.front[..]));
        let backs = parts.iter().map(|p| run(p, &p.1.back[..]));
        let runs: Vec<_> = fronts
            .chain(backs)
            .filter(|r| !r.pieces.is_empty())
            .collect();
        let starts = starts(runs.iter().map(|r| r.pieces.len()));
        let mut hints = Vec::new();
        for (k, end) in starts[1..].iter().enumerate() {
            let run = hints.len()..end.div_ceil(HINT);
            hints.extend(run.map(|_| k as u32));
        }
        let least = |a: f64, b: &(usize, Selected)| a.min(b.1.range[0]);
        let most = |a: f64, b: &(usize, Selected)| a.max(b.1.range[1]);
        Self {
            cast,
            len: starts.last().copied().unwrap_or(0),
            starts,
            hints,
            runs,
            range: [
                parts.iter().fold(f64::INFINITY, least),
                parts.iter().fold(f64::NEG_INFINITY, most),
            ],
        }
    }

    /// Piece `i`, and the run that it is in.
    #[inline]
    fn piece(&self, i: usize) -> (&Run<'a>, Piece) {
        let mut k = self.hints[i / HINT] as usize;
        while self.starts[k + 1] <= i {
            k += 1;
        }
        let run = &self.runs[k];
        (run, run.pieces[i - self.starts[k]])
    }

    /// Maps nearness from the range to 0..=1; a frame of one depth is all nearest. The range does not depend on what is
    /// skipped, so neither does the frame; triangles that are drawn only because a skip is off may lie outside it.
    #[inline]
    fn fit(&self, depth: f64) -> f64 {
        let [lo, hi] = self.range;
        if hi > lo {
            (depth - lo) / (hi - lo)
        } else {
            1.0
        }
    }

    /// The finished triangle `i`.
    #[inline]
    pub(super) fn triangle(&self, i: usize) -> ScreenTriangle {
        let (run, piece) = self.piece(i);
        let subject = &self.cast.subjects[run.subject];
        run.part.triangle(subject, piece, |d| self.fit(d))
    }

    /// The vertex numbers of triangle `i`.
    #[inline]
    pub(super) fn numbers(&self, i: usize) -> [u32; 3] {
        let (run, piece) = self.piece(i);
        let before = self.cast.vertices[run.subject] as u32;
        let numbers = run.part.numbers(piece);
        numbers.map(|n| n.map_or(UNSHARED, |n| before + n))
    }
}
