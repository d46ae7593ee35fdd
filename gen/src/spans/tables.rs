//! Palette and tables: what is written before the first span of a frame.

use super::curves::Curves;
use super::surface::Surface;
use shadegate_hdl::lit::channel::{COLOUR_FRACTION_BITS, LARGEST};
use shadegate_hdl::lit::chord::{chord, shift_of, CHORDS};
use shadegate_hdl::lit::{loader, MATERIALS};
use shadegate_hdl::shade::span_core::SpanKind;

/// A material as the core knows it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Material {
    scene_index: usize,
    lit: bool,
    /// Ambient, diffuse, highlight.
    colours: [[f64; 3]; 3],
    exponent: f64,
}

/// The materials of a frame, at most [`MATERIALS`].
#[derive(Clone, Debug, Default)]
pub struct Palette {
    materials: Vec<Material>,
}

impl Palette {
    /// Adds the material of a surface; its place in the palette.
    ///
    /// # Errors
    /// One material too many, or one that the core's words do not hold.
    pub fn add(&mut self, kind: SpanKind, s: &Surface) -> Result<(), String> {
        let term = s.corners.terms.first();
        let shines = term.is_some_and(|t| t.shines());
        let new = Material {
            scene_index: s.triangle.material,
            lit: term.is_some(),
            colours: [
                s.corners.ambient.to_array(),
                term.map_or([0.0; 3], |t| t.diffuse[0].to_array()),
                term.map_or([0.0; 3], |t| t.specular[0].to_array()),
            ],
            exponent: if shines { s.corners.shininess } else { 1.0 },
        };
        let limit = LARGEST - 0.5;
        if let Some(c) = new
            .colours
            .iter()
            .flatten()
            .find(|c| !(0.0..=limit).contains(*c))
        {
            return Err(format!("colour {c} is outside 0 to {limit}"));
        }
        check_exponent(kind, new.exponent)?;
        let full = self.materials.len() == MATERIALS;
        let known = |m: &&mut Material| m.scene_index == new.scene_index;
        match self.materials.iter_mut().find(known) {
            Some(m) if new.lit && !m.lit => *m = new,
            Some(_) => {}
            None if full => {
                return Err(format!(
                    "its material is one more than the {MATERIALS} that this core takes in a frame"
                ));
            }
            None => self.materials.push(new),
        }
        Ok(())
    }

    /// Place of a surface's material, and the stretch of its highlight table.
    pub fn place(&self, s: &Surface) -> (u64, u64) {
        let at = self
            .materials
            .iter()
            .position(|m| m.scene_index == s.triangle.material);
        let at = at.unwrap_or(0);
        let shift = self.materials.get(at).map_or(0, |m| shift_of(m.exponent));
        (at as u64, u64::from(shift))
    }

    fn shines(&self) -> bool {
        self.materials.iter().any(|m| m.colours[2] != [0.0; 3])
    }

    /// The writes: colours, then the tables that the core has.
    pub fn writes(&self, kind: SpanKind) -> Vec<(u8, u64)> {
        let mut out = vec![];
        for (place, m) in (0u64..).zip(&self.materials) {
            for channel in 0..3 {
                for part in 0..3 {
                    // Half an LSB for the rounding of the output.
                    let half = if part == 0 { 0.5 } else { 0.0 };
                    let scale = f64::from(1u32 << COLOUR_FRACTION_BITS);
                    let code = ((m.colours[part][channel] + half) * scale).round() as u64;
                    let cell = (3 * channel + part) as u64;
                    out.push((loader::COLOUR as u8, place << 30 | cell << 26 | code));
                }
            }
        }
        match kind {
            SpanKind::Slerp | SpanKind::Chebyshev => {
                self.highlights(&mut out, CHORDS, |m, i| chord(m.exponent, i));
            }
            SpanKind::Spherical(bits) | SpanKind::SphericalPower(bits) => {
                let cosine = Curves::diffuse(bits);
                out.push((loader::POINTER as u8, 0));
                out.extend((0..1 << bits).map(|i| (loader::COSINE as u8, cosine.word(i))));
                self.highlights(&mut out, 1 << bits, |m, i| {
                    Curves::highlight(kind, m.exponent).word(i as u32)
                });
            }
            SpanKind::Blake | SpanKind::BlakeRefit | SpanKind::BlakeTrapezium => {}
        }
        out
    }

    /// The highlight table: words of the materials side by side.
    fn highlights(
        &self,
        out: &mut Vec<(u8, u64)>,
        count: usize,
        word: impl Fn(&Material, usize) -> u64,
    ) {
        if !self.shines() {
            return;
        }
        out.push((loader::POINTER as u8, 0));
        for i in 0..count {
            for place in 0..MATERIALS {
                let data = self.materials.get(place).map_or(0, |m| word(m, i));
                out.push((loader::HIGHLIGHT as u8, data));
            }
        }
    }
}

/// Exponents that the tables and phases of a core are made for.
fn check_exponent(kind: SpanKind, n: f64) -> Result<(), String> {
    let (least, most) = match kind {
        SpanKind::Slerp | SpanKind::Chebyshev => (1.0, 1024.0),
        SpanKind::Spherical(_) | SpanKind::SphericalPower(_) => (0.0, 1024.0),
        SpanKind::Blake | SpanKind::BlakeRefit | SpanKind::BlakeTrapezium => (1.0, 10_000.0),
    };
    if (least..=most).contains(&n) {
        Ok(())
    } else {
        Err(format!(
            "shininess {n} is outside the {least} to {most} that this core takes"
        ))
    }
}
