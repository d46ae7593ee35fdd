//! What cores that shade per pixel are sent: the words of a material, behind a fence, and those of two cosines.

use super::build::{Triangle, Writer};
use super::glint::{Cone, Lobe};
use crate::setup::{fixed_knot, lobe_scale, power_words, quadric_words, Frame};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::phong::power::{MAX_EXPONENT, PLACE_FRACTION_BITS, PLACE_INTEGER_BITS};
use shadegate_hdl::shade::phong::unit_cosines::{self, SCALE_WORD};
use shadegate_hdl::shade::phong::{
    AMBIENT_FRACTION_BITS, FENCE_WORD, LIGHT_FRACTION_BITS, LIGHT_INTEGER_BITS, TABLE_PLACE_WORD,
    TABLE_WORD, TINT_FRACTION_BITS,
};

/// Mask of the material words.
pub(super) const MATERIAL: u8 = 0x40;
/// Mask of the words of N·L.
pub(super) const LIGHT: u8 = 0x10;
/// Mask of the words of the place in the lobe.
pub(super) const LOBE: u8 = 0x20;
/// Largest sum of a channel's three colours, LSB.
const BRIGHTEST: f64 = 2047.0;

/// Largest exponent that a core draws.
#[must_use]
pub fn greatest_exponent(order: Order) -> f64 {
    match order {
        Order::Duff => unit_cosines::MAX_EXPONENT,
        Order::Bump(_) => shadegate_hdl::bump::MAX_EXPONENT,
        _ => MAX_EXPONENT,
    }
}

/// How a surface reflects one light, LSB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Colour without the light.
    pub ambient: [f64; 3],
    /// Colour of the diffuse reflection.
    pub diffuse: [f64; 3],
    /// Colour of the highlight.
    pub specular: [f64; 3],
    /// The exponent n of the highlight.
    pub shininess: f64,
    /// The function that makes the highlight.
    pub lobe: Lobe,
    /// The cone, where the light is a spot.
    pub cone: Option<Cone>,
}

impl Material {
    /// Whether there is a highlight.
    pub(super) fn shines(&self) -> bool {
        self.specular.iter().any(|s| *s != 0.0)
    }

    /// The scale of the lobe, 0 where there is none.
    pub(super) fn scale(&self, greatest: f64) -> Result<u32, String> {
        if !self.shines() {
            return Ok(0);
        }
        lobe_scale(self.shininess)
            .filter(|_| self.shininess <= greatest)
            .ok_or_else(|| format!("shininess {} is outside 1 to {greatest}", self.shininess))
    }

    /// The nine colour words.
    pub(super) fn colours(&self) -> Result<[u64; 9], String> {
        let mut words = [0; 9];
        for channel in 0..3 {
            let parts = [
                self.ambient[channel],
                self.diffuse[channel],
                self.specular[channel],
            ];
            let sum: f64 = parts.iter().sum();
            let fits = parts.iter().all(|p| *p >= 0.0) && sum <= BRIGHTEST;
            if !fits {
                return Err(format!(
                    "ambient, diffuse and specular colour {}, {} and {} do not add up to 0 to {BRIGHTEST}",
                    parts[0], parts[1], parts[2]
                ));
            }
            let code = |value: f64, bits: usize| (value * (1u64 << bits) as f64).round() as u64;
            let half = 1 << (AMBIENT_FRACTION_BITS - 1);
            words[3 * channel] = code(parts[0], AMBIENT_FRACTION_BITS) + half;
            words[3 * channel + 1] = code(parts[1], TINT_FRACTION_BITS);
            words[3 * channel + 2] = code(parts[2], TINT_FRACTION_BITS);
        }
        Ok(words)
    }
}

/// Six knots of one of a triangle's quantities, each mapped.
pub(super) fn six(
    t: &Triangle,
    name: &str,
    which: usize,
    map: impl Fn(f64) -> f64,
) -> Result<[i128; 6], String> {
    if t.knots.len() != 6 {
        return Err(format!("{} knots where the core takes 6", t.knots.len()));
    }
    let mut out = [0; 6];
    for (to, knot) in out.iter_mut().zip(&t.knots) {
        let cosine = knot[which];
        *to = fixed_knot(map(cosine))
            .filter(|_| (-2.0..=2.0).contains(&cosine))
            .ok_or_else(|| format!("{name} {cosine} at a knot is outside -2 to 2"))?;
    }
    Ok(out)
}

impl Writer<'_> {
    /// The material of a triangle, if it is not the one before: a fence, then what differs.
    pub(super) fn material(
        &mut self,
        order: Order,
        m: &Material,
        writes: &mut Vec<(u8, u64)>,
    ) -> Result<(), String> {
        let mut words = vec![];
        self.words(MATERIAL, m.colours()?, &mut words);
        let scale = m.scale(greatest_exponent(order))?;
        let scale_word = MATERIAL | SCALE_WORD as u8;
        let scaled = matches!(order, Order::Duff | Order::Bump(_));
        if scaled && m.shines() && self.needed(scale_word, u64::from(scale)) {
            words.push((scale_word, u64::from(scale)));
        }
        // The whole table is one word to those who count.
        if m.shines() && self.needed(MATERIAL | TABLE_WORD as u8, m.shininess.to_bits()) {
            words.push((MATERIAL | TABLE_PLACE_WORD as u8, 0));
            let table = power_words(m.shininess, scale).into_iter();
            words.extend(table.map(|w| (MATERIAL | TABLE_WORD as u8, w)));
        }
        if !words.is_empty() {
            writes.push((FENCE_WORD as u8, 0));
            writes.extend(words);
        }
        Ok(())
    }

    /// Words of a triangle of the quadratic-dots core.
    pub(super) fn dots(
        &mut self,
        core: &Core,
        t: &Triangle,
        frame: &Frame,
        writes: &mut Vec<(u8, u64)>,
    ) -> Result<(), String> {
        let m = t.material.as_ref().ok_or("no material")?;
        self.material(core.order, m, writes)?;
        let below = core.fraction_bits();
        let half = 1i128 << (below - 1);
        let words = |knots, int: usize, frac: usize| {
            let fraction = (frac + below) as u32;
            quadric_words(frame, knots, fraction, 1 + int as u32 + fraction, half)
        };
        let light = six(t, "N·L", 0, |c| c)?;
        self.words(
            LIGHT,
            words(light, LIGHT_INTEGER_BITS, LIGHT_FRACTION_BITS),
            writes,
        );
        if m.shines() {
            let scale = f64::from(1u32 << m.scale(MAX_EXPONENT)?);
            let lobe = six(t, "N·H", 1, |c| (1.0 - c) * scale)?;
            self.words(
                LOBE,
                words(lobe, PLACE_INTEGER_BITS, PLACE_FRACTION_BITS),
                writes,
            );
        }
        Ok(())
    }
}
