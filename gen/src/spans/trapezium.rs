//! Ends of spans by way of trapezia with level sides, as Blake, Disselkoen and Kuijk 1992 have them (section 3 and
//! appendix; the printed sign of λ put right as in the software method): a triangle is two, above and below its middle
//! vertex, each with one side collapsed. In a trapezium both cosines at the ends of a row come from one angle per edge, so
//! the host turns no normal from row to row. The core is that of `blake`; what differs are the knots at the ends.
//!
//! Of the turn between the ends the algebra gives the cosine alone, which has two digits left of a turn of 1e-7 rad;
//! there the phase along the span, and with it Blake's curve, is off by 2 LSB, in the method as in the core.

use super::surface::Surface;
use shadegate_reference::raster::{area2, Span, SUBPIXELS};
use shadegate_reference::shade::circular::Sweeps;
use shadegate_reference::shade::corners::Corners;
use shadegate_reference::shade::cut::Cut;
use shadegate_reference::shade::ends::trapezium::Trapezium;
use shadegate_reference::shade::sweep::Sweep;
use shadegate_reference::shade::turn::Arc;

/// The trapezium of a triangle in which a row lies.
struct Part {
    /// Corners from top to bottom.
    order: [usize; 3],
    /// The middle corner lies left of the long edge.
    left: bool,
    /// How far down the long edge the middle corner lies, of 1.
    share: f64,
    /// Below the middle corner.
    lower: bool,
    /// The row, from the top of the trapezium (0) to its bottom (1).
    t: f64,
}

impl Part {
    fn new(s: &Surface, span: Span) -> Self {
        let p = &s.triangle.position;
        let mut order = [0, 1, 2];
        order.sort_by_key(|i| (p[*i].y, p[*i].x));
        let [top, middle, bottom] = order.map(|i| f64::from(p[i].y) / f64::from(SUBPIXELS));
        let row = f64::from(span.y) + 0.5;
        let lower = row >= middle && bottom > middle;
        let (from, to) = if lower {
            (middle, bottom)
        } else {
            (top, middle)
        };
        let share = |at: f64, from: f64, to: f64| match to > from {
            true => ((at - from) / (to - from)).clamp(0.0, 1.0),
            false => 0.0,
        };
        Self {
            order,
            left: area2(order.map(|i| p[i])) < 0,
            share: share(middle, top, bottom),
            lower,
            t: share(row, from, to),
        }
    }

    /// Both cosines with a vector at rest, and that of the turn between the ends.
    fn sweep(&self, c: &Corners, v: [f64; 3], cut: &Cut) -> Sweep {
        let [top, middle, bottom] = self.order.map(|i| c.normal[i]);
        let across = Arc::new(top, bottom).at(self.share);
        let (short, long) = match self.lower {
            false => ([top, middle], [top, across]),
            true => ([middle, bottom], [across, bottom]),
        };
        let (left, right) = match self.left {
            true => (short, long),
            false => (long, short),
        };
        let [from, to, turn] = Trapezium::new(left, right, v.into()).at(self.t);
        let cos = turn.clamp(-1.0, 1.0);
        Sweep {
            from,
            to,
            cos,
            sin: (1.0 - cos * cos).sqrt(),
            first: cut.first,
            step: cut.step,
        }
    }
}

/// The sweeps of a span: of the light, if any, and of the highlight where there is one. Light and viewer are far.
pub fn sweeps(s: &Surface, span: Span) -> Option<Sweeps> {
    let (part, cut) = (Part::new(s, span), Cut::new(&s.triangle.position, span));
    let sweep = |v: [f64; 3]| part.sweep(&s.corners, v, &cut);
    s.corners.terms.first().map(|term| {
        let highlight = term.shines().then(|| sweep(term.half[0].to_array()));
        (sweep(term.light[0].to_array()), highlight)
    })
}
