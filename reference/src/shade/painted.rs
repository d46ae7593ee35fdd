//! The plan of [`Auto`] pixel by pixel, for textures to be laid on it: colours that one value, a linear or a quadratic
//! interpolant gives with the promised error are drawn so, all others from the definition.

use super::auto::Auto;
use super::differences::{Differences, Interpolant};
use super::exact;
use super::paint::Paint;
use super::shader::{Run, Shader};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::Span;

/// A triangle as its paint asks for it.
pub enum Painted {
    /// One colour, LSB.
    Constant([f64; 3]),
    /// Linear or quadratic.
    Interpolant(Box<Interpolant>),
    /// From the definition.
    Exact(usize),
}

/// The current pixel.
pub enum PaintedRun<'a> {
    /// Of an interpolant; or a constant, which does not step.
    Differences(Differences),
    /// Of the definition.
    Exact {
        /// The scene.
        prepared: &'a Prepared,
        /// The triangle.
        triangle: &'a ScreenTriangle,
        /// Column and row.
        at: [i32; 2],
    },
}

impl Shader for Auto<'_> {
    /// The error is promised against the truth, textures included.
    const EXACT: bool = true;
    type Triangle = Painted;
    type Run<'b>
        = PaintedRun<'b>
    where
        Self: 'b;

    fn triangle(&self, p: &Prepared, index: usize) -> Painted {
        let position = p.triangles[index].position;
        match self.paint(index) {
            Paint::Constant(c) => Painted::Constant(c),
            Paint::Linear(k) => Painted::Interpolant(Box::new(Interpolant::linear(position, &k))),
            Paint::Quadratic(k) => {
                Painted::Interpolant(Box::new(Interpolant::quadratic(position, &k)))
            }
            Paint::Dots(_) | Paint::Phong(_) | Paint::Exact => Painted::Exact(index),
        }
    }

    fn start<'b>(&'b self, p: &'b Prepared, painted: &'b Painted, span: Span) -> PaintedRun<'b> {
        match painted {
            Painted::Constant(c) => PaintedRun::Differences(Differences {
                r: *c,
                ..Differences::default()
            }),
            Painted::Interpolant(i) => PaintedRun::Differences(i.start(span.start, span.y)),
            Painted::Exact(index) => PaintedRun::Exact {
                prepared: p,
                triangle: &p.triangles[*index],
                at: [span.start, span.y],
            },
        }
    }
}

impl Run for PaintedRun<'_> {
    fn colour(&self) -> [f64; 3] {
        match self {
            Self::Differences(d) => d.r,
            Self::Exact {
                prepared,
                triangle,
                at: [x, y],
            } => exact::value(prepared, triangle, *x, *y),
        }
    }

    fn step(&mut self) {
        match self {
            Self::Differences(d) => d.step(),
            Self::Exact { at, .. } => at[0] += 1,
        }
    }
}
