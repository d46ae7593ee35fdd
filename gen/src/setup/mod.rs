//! From a screen triangle to register words: exact set-up, quantised once.
//!
//! Vertices are integers (1/256 pixel) and knots are rounded to 2^−20 LSB first; from there on every word is an exact
//! rational number, rounded to nearest once, in 128-bit integers. So words are right to half an ulp for every triangle,
//! however thin, and neighbours along a thin triangle cannot be spoilt by cancellation. Words of thin triangles may
//! exceed the register: the residue is stored, and because registers only ever add, the value at a covered pixel (which
//! does fit) comes out right. See `shadegate_hdl::shade::quadratic`.

mod line;
mod plane;
mod power;
mod quadric;
mod rational;
mod shell;

pub use line::{cue_words, line_words, MAX_COLUMNS, MAX_PIECE};
pub use plane::plane_words;
pub use power::{lobe_scale, power_words};
pub use quadric::quadric_words;
pub use rational::{fixed_knot, KNOT_FRACTION_BITS};
pub use shell::{shell_words, MAX_COLUMN, MIN_COLUMN};

use shadegate_reference::raster::{area2, Point, Walk, SUBPIXELS};

/// Barycentric weights of vertices 1 and 2 as integers over [`Frame::area`], at the first span start and along the steps.
///
/// Weight 1 at a point P is cross(P − V0, V2 − V0) / area2, weight 2 is cross(V1 − V0, P − V0) / area2.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Twice the signed area, sub-pixels squared.
    pub area: i128,
    /// Weights 1 and 2, times the area, at the centre of the first span's first pixel.
    pub start: [i128; 2],
    /// Their change along the pixel step p.
    pub pixel: [i128; 2],
    /// Their change along the line step s.
    pub line: [i128; 2],
}

impl Frame {
    /// The frame of a triangle along its walk.
    #[must_use]
    pub fn new(position: [Point; 3], walk: &Walk) -> Self {
        let [v0, v1, v2] = position.map(|p| (i128::from(p.x), i128::from(p.y)));
        let weights = |dx: i128, dy: i128| {
            [
                dx * (v2.1 - v0.1) - dy * (v2.0 - v0.0),
                (v1.0 - v0.0) * dy - (v1.1 - v0.1) * dx,
            ]
        };
        let one = i128::from(SUBPIXELS);
        let column = if walk.mirrored {
            !walk.major.column
        } else {
            walk.major.column
        };
        let direction = if walk.mirrored { -one } else { one };
        let x = i128::from(column) * one + one / 2 - v0.0;
        let y = i128::from(walk.first_row) * one + one / 2 - v0.1;
        Self {
            area: i128::from(area2(position)),
            start: weights(x, y),
            pixel: weights(direction, 0),
            line: weights(i128::from(walk.major.whole) * direction, one),
        }
    }
}
