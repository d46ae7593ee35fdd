//! The triangles as retrofire-core draws them, by `tri_fill` and its span iterators: no depth test, colours in f32. The
//! colour of a pixel is taken from the span's iterator as it is, without the division for perspective that `fragments`
//! would add, because ours divides for none either.

use super::shape::{Triangle, SIDE};
use retrofire_core::geom::{vertex, Vertex};
use retrofire_core::math::{pt3, rgb, Color3, Color3f};
use retrofire_core::render::raster::{tri_fill, ScreenPt};
use retrofire_core::util::{Buf2, Dims};
use std::iter::zip;

/// A frame, and the triangles in retrofire's types.
pub struct Retrofire {
    /// What was drawn last.
    pub frame: Buf2<Color3>,
    unconverted: Buf2<Color3f>,
    coloured: Vec<[Vertex<ScreenPt, Color3f>; 3]>,
    plain: Vec<[Vertex<ScreenPt, ()>; 3]>,
}

impl Retrofire {
    /// Takes the triangles over.
    pub fn new(triangles: &[Triangle]) -> Self {
        Self {
            frame: Buf2::new(Dims(SIDE, SIDE)),
            unconverted: Buf2::new(Dims(SIDE, SIDE)),
            coloured: convert(triangles, |c| rgb(c[0], c[1], c[2])),
            plain: convert(triangles, |_| ()),
        }
    }

    /// Linear interpolation of colours.
    pub fn gouraud(&mut self) {
        for t in &self.coloured {
            tri_fill(*t, |span| {
                let pixels = &mut self.frame[span.y][span.xs];
                for (pixel, (_, colour)) in zip(pixels, span.vs) {
                    *pixel = colour.to_color3();
                }
            });
        }
    }

    /// The same, colours left in f32 as they are interpolated: what retrofire reaches without the conversion to bytes.
    pub fn gouraud_unconverted(&mut self) {
        for t in &self.coloured {
            tri_fill(*t, |span| {
                let pixels = &mut self.unconverted[span.y][span.xs];
                for (pixel, (_, colour)) in zip(pixels, span.vs) {
                    *pixel = colour;
                }
            });
        }
    }

    /// One colour per triangle.
    pub fn flat(&mut self) {
        let colour = rgb(200, 100, 50);
        for t in &self.plain {
            tri_fill(*t, |span| self.frame[span.y][span.xs].fill(colour));
        }
    }

    /// Pixels that are not black, where every colour drawn is not.
    pub fn covered(&self) -> u64 {
        let black = rgb(0, 0, 0);
        self.frame.data().iter().filter(|c| **c != black).count() as u64
    }
}

fn convert<A>(
    triangles: &[Triangle],
    attribute: impl Fn([f32; 3]) -> A,
) -> Vec<[Vertex<ScreenPt, A>; 3]> {
    let corner = |t: &Triangle, i: usize| {
        let c = t[i];
        vertex(pt3(c.x, c.y, 1.0), attribute(c.colour))
    };
    let all = triangles.iter();
    all.map(|t| [0, 1, 2].map(|i| corner(t, i))).collect()
}
