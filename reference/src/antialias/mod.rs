//! Anti-aliasing of the edges of polygons: a pixel on an edge shows what lies on either side, each by the area it covers.
//!
//! | file | what |
//! |---|---|
//! | `area` | exact area of a triangle in a pixel: the oracle |
//! | `mask` | coverage masks of 4×4, 4×8 and 8×8 samples, exactly |
//! | `mask_table` | half-plane masks by angle and offset, as a read-only memory holds them |
//! | `a_buffer` | masks composited front to back |
//! | `ramp` | linear coverage ramps of the parts of a row |
//! | `cubic` | ramp × quadratic colour along a row by third differences |
//! | `paint` | colour and depth of a triangle anywhere in it |
//! | `touched` | the pixels that a triangle touches |
//! | `fragments` | what covers a pixel, front to back |
//!
//! Both ways assume that faces do not pierce each other within a pixel, and neither filters what is inside a triangle.

pub mod a_buffer;
pub mod area;
pub mod cubic;
mod fragments;
pub mod mask;
pub mod mask_table;
mod paint;
pub mod ramp;
mod touched;

use crate::geometry::Prepared;
use crate::line::wireframe;
use crate::method::{Method, UnknownName};
use crate::parallel;
use crate::render::{render, Frame, RenderOptions, RenderStats};
use crate::skips::{self, Skips};
use fragments::Tally;
use mask::Grid;
use paint::Painter;
use std::fmt;
use std::str::FromStr;
use std::time::Instant;

/// How edges of polygons are anti-aliased.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Antialias {
    /// Not: a pixel belongs to the triangle that owns its centre.
    #[default]
    None,
    /// Coverage masks of 8 × 8 samples, composited front to back.
    ABuffer,
    /// A coverage ramp times the colour along a row, by third differences.
    Cubic,
}

impl Antialias {
    /// All, in the order of the catalogue.
    pub const ALL: [Self; 3] = [Self::None, Self::ABuffer, Self::Cubic];

    /// The catalogue name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::ABuffer => "a-buffer",
            Self::Cubic => "cubic",
        }
    }
}

impl fmt::Display for Antialias {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Antialias {
    type Err = UnknownName;

    fn from_str(s: &str) -> Result<Self, UnknownName> {
        Self::ALL
            .into_iter()
            .find(|a| a.name() == s)
            .ok_or_else(|| UnknownName::new("anti-aliasing", s, &Self::ALL.map(Self::name)))
    }
}

/// A method that cannot be anti-aliased.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "method '{method}' has no anti-aliased form '{antialias}'; expected a method of exact, flat, gouraud, quadratic, or \
     anti-aliasing none"
)]
pub struct Unsupported {
    /// The method.
    pub method: Method,
    /// What was asked of it.
    pub antialias: Antialias,
}

/// Whether a method has an anti-aliased form.
///
/// # Errors
/// Methods other than exact, flat, gouraud and quadratic.
pub fn supported(method: Method, antialias: Antialias) -> Result<(), Unsupported> {
    let drawn = [
        Method::Exact,
        Method::Flat,
        Method::Gouraud,
        Method::Quadratic,
    ];
    if antialias == Antialias::None || drawn.contains(&method) {
        Ok(())
    } else {
        Err(Unsupported { method, antialias })
    }
}

/// The skips to prepare a scene with: triangles that cover no pixel centre still cover parts of pixels.
#[must_use]
pub fn skips_for(antialias: Antialias, skips: Skips) -> Skips {
    match antialias {
        Antialias::None => skips,
        _ => skips.but(skips::UNCOVERED),
    }
}

/// [`render`] with anti-aliasing, of a scene prepared with [`skips_for`].
///
/// # Errors
/// Methods other than exact, flat, gouraud and quadratic.
pub fn draw(
    p: &Prepared,
    method: Method,
    antialias: Antialias,
    o: &RenderOptions,
) -> Result<(Frame, RenderStats), Unsupported> {
    if antialias == Antialias::None {
        return Ok(render(p, method, o));
    }
    parallel::with(o.threads, || {
        let start = Instant::now();
        let painter = Painter::new(p, method).ok_or(Unsupported { method, antialias })?;
        let setup_ns = nanoseconds(start);
        let start = Instant::now();
        let (mut frame, tally) = match antialias {
            Antialias::Cubic => cubic::draw(p, &painter, o.skips),
            _ => a_buffer::draw(
                p,
                &painter,
                &a_buffer::Masks::Direct(Grid::EIGHT_BY_EIGHT),
                o.skips,
            ),
        };
        if !p.wires.is_empty() {
            wireframe::draw(&p.wires, &mut frame);
        }
        Ok((frame, stats(p, tally, setup_ns, nanoseconds(start))))
    })
}

/// [`draw`] by an A-buffer with masks of any kind.
///
/// # Errors
/// Methods other than exact, flat, gouraud and quadratic.
pub fn draw_with_masks(
    p: &Prepared,
    method: Method,
    masks: &a_buffer::Masks<'_>,
    skips: Skips,
) -> Result<Frame, Unsupported> {
    let antialias = Antialias::ABuffer;
    let painter = Painter::new(p, method).ok_or(Unsupported { method, antialias })?;
    Ok(a_buffer::draw(p, &painter, masks, skips).0)
}

fn stats(p: &Prepared, tally: Tally, setup_ns: u64, raster_ns: u64) -> RenderStats {
    let mut skipped = p.skipped.clone();
    for (name, count) in [(skips::HIDDEN, tally.hidden), (skips::MASKED, tally.masked)] {
        if count > 0 {
            skipped.insert(name, count);
        }
    }
    RenderStats {
        pixels_tested: tally.touched,
        pixels_shaded: tally.shaded,
        pixels_written: tally.composited,
        skipped,
        setup_ns,
        raster_ns,
        threads: parallel::threads(),
    }
}

fn nanoseconds(since: Instant) -> u64 {
    u64::try_from(since.elapsed().as_nanos()).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_there_and_back() {
        for a in Antialias::ALL {
            assert_eq!(a.to_string().parse(), Ok(a));
        }
        let e = "abuffer".parse::<Antialias>().unwrap_err().to_string();
        assert_eq!(
            e,
            "unknown anti-aliasing 'abuffer'; the nearest is 'a-buffer' of none, a-buffer, cubic"
        );
    }
}
