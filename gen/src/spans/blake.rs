//! Words of the Blake core, from the span stage of the methods `blake` and `blake-refit`: each span is cut where a piece
//! of either term ends.
//!
//! What the printed appendix has wrong is put right as in the software method: pieces begin at pixels and are half-open,
//! the extreme of a piece is a real number, and the bend is that per pixel.

use super::words::{residue, Terms};
use shadegate_reference::shade::curve::Pieces;
use shadegate_reference::shade::sweep::{Phase, Sweep};

/// Fraction bits of a factor's words.
const FRACTION: u32 = 30;

/// scale·q(ψ) along a span.
struct Term {
    pieces: Pieces,
    scale: f64,
    phase: Phase,
}

impl Term {
    fn new(s: &Sweep, n: f64, pieces: Pieces) -> Self {
        let phase = s.phase();
        Self {
            pieces,
            scale: phase.amplitude.powf(n),
            phase,
        }
    }

    /// ψ at pixel `k`.
    fn at(&self, k: u32) -> f64 {
        self.phase.phase + f64::from(k) * self.phase.step
    }

    /// Extreme, value there and half the bend of the piece at ψ, and where the piece ends.
    fn piece(&self, x: f64) -> [f64; 4] {
        let Pieces { a, b } = self.pieces;
        let side = 1.0 / (b * (b - a));
        if x < -b {
            [0.0, 0.0, 0.0, -b]
        } else if x < -a {
            [-b, 0.0, side, -a]
        } else if x < a {
            [0.0, 1.0, -1.0 / (a * b), a]
        } else if x < b {
            [b, 0.0, side, b]
        } else {
            [0.0, 0.0, 0.0, f64::INFINITY]
        }
    }

    /// The first pixel after `k` that another piece has.
    fn end(&self, k: u32) -> u32 {
        let [.., end] = self.piece(self.at(k));
        // The conversion saturates: a piece without end, or a phase at rest.
        let more = ((end - self.at(k)) / self.phase.step).ceil() as u32;
        k.saturating_add(more.max(1))
    }

    /// Value, change and bend from pixel `k` on.
    fn words(&self, k: u32) -> [u64; 3] {
        let x = self.at(k);
        let [extreme, top, half, _] = self.piece(x);
        let (half, o, step) = (half * self.scale, x - extreme, self.phase.step);
        [
            top * self.scale + half * o * o,
            half * step * (2.0 * o + step),
            2.0 * half * step * step,
        ]
        .map(|v| residue(v, FRACTION))
    }
}

/// The parts of a span, each with the words of both terms; a term that is missing is dark.
pub fn terms(
    pieces: impl Fn(f64) -> Pieces,
    sweeps: [Option<&Sweep>; 2],
    n: f64,
    pixels: u32,
) -> Vec<Terms> {
    let both =
        [(sweeps[0], 1.0), (sweeps[1], n)].map(|(s, n)| s.map(|s| Term::new(s, n, pieces(n))));
    let mut out = vec![];
    let mut first = 0;
    while first < pixels {
        let ends = both.iter().flatten().map(|t| t.end(first));
        let end = ends.min().unwrap_or(pixels).min(pixels);
        let [diffuse, highlight] = [0, 1].map(|i| {
            let term: &Option<Term> = &both[i];
            term.as_ref().map_or([0; 3], |t| t.words(first))
        });
        out.push(Terms {
            first,
            pixels: end - first,
            diffuse,
            highlight,
        });
        first = end;
    }
    out
}
