//! What cores without tables are sent: three cosines as places, and what a triangle does without.
//!
//! A quadric lies within the hull of its Bernstein coefficients, kᵢ at the vertices and 2kᵢⱼ − (kᵢ + kⱼ)/2 at the edges. So
//! a triangle whose place in the lobe has no coefficient below 1 has no highlight, and one whose N·L has none above 0
//! has no diffuse reflection; the core is told so, and the words of the cosines that it then ignores are left out.

use super::build::{Triangle, Writer};
use super::material::{six, Material, LIGHT, LOBE, MATERIAL};
use crate::setup::{quadric_words, Frame};
use shadegate_hdl::light::{Glint, CONE_WORD, CURVE_WORD, DEGREES, MAX_SCALE, SKIP_WORD};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::phong::power::{PLACE_FRACTION_BITS, PLACE_INTEGER_BITS};
use shadegate_hdl::shade::phong::{FENCE_WORD, LIGHT_FRACTION_BITS, LIGHT_INTEGER_BITS};

/// Mask of the words of the depth, of the place in the cone and of the skips.
const DEPTH: u8 = 0x80;

/// The function that makes a highlight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lobe {
    /// cosⁿ.
    Power,
    /// κ(cos − γ)^d.
    Kappa {
        /// The degree d.
        degree: u8,
        /// The cosine γ where it ends.
        gamma: f64,
    },
}

/// How a spot falls off beside its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// 1 − v² instead of (1 − v)².
    pub hard: bool,
    /// 1 − g, g being the cosine where it ends.
    pub width: f64,
}

impl Material {
    /// Degree and scale 1/(1 − γ) of the highlight.
    fn kappa(&self) -> Result<(u8, f64), String> {
        let Lobe::Kappa { degree, gamma } = self.lobe else {
            return Err("a highlight that is no shifted low power".to_owned());
        };
        if !DEGREES.contains(&degree) {
            return Err(format!("degree {degree} of a highlight is outside 2 to 4"));
        }
        let scale = 1.0 / (1.0 - gamma);
        if !(gamma >= 0.0 && scale <= MAX_SCALE) {
            return Err(format!(
                "a highlight that ends at the cosine {gamma} is outside 0 to 127/128"
            ));
        }
        Ok((degree, scale))
    }
}

impl Cone {
    /// 1/(1 − g).
    fn scale(&self) -> Result<f64, String> {
        let scale = 1.0 / self.width;
        if self.width > 0.0 && scale <= MAX_SCALE {
            Ok(scale)
        } else {
            Err(format!(
                "a cone with 1 - g = {} is narrower than 1/128",
                self.width
            ))
        }
    }
}

/// The Bernstein coefficients of six knots.
fn hull(t: &Triangle, map: impl Fn(&[f64; 3]) -> f64) -> [f64; 6] {
    let k: [f64; 6] = std::array::from_fn(|i| t.knots.get(i).map_or(f64::NAN, &map));
    let edge = |i: usize, j: usize, m: usize| 2.0 * k[m] - (k[i] + k[j]) / 2.0;
    [
        k[0],
        k[1],
        k[2],
        edge(0, 1, 3),
        edge(0, 2, 4),
        edge(1, 2, 5),
    ]
}

impl Writer<'_> {
    /// The material of a triangle, if it is not the one before: a fence, then what differs.
    fn curves(
        &mut self,
        glint: Glint,
        m: &Material,
        writes: &mut Vec<(u8, u64)>,
    ) -> Result<(), String> {
        let degree = if m.shines() { m.kappa()?.0 } else { 2 };
        let hard = glint == Glint::Spot && m.cone.is_some_and(|c| c.hard);
        let curve = u64::from(degree) | u64::from(hard) << 3;
        let words = (0u8..).zip(m.colours()?);
        let mut sent = vec![];
        for (word, data) in words.chain([(CURVE_WORD as u8, curve)]) {
            if self.needed(MATERIAL | word, data) {
                sent.push((MATERIAL | word, data));
            }
        }
        if !sent.is_empty() {
            writes.push((FENCE_WORD as u8, 0));
            writes.extend(sent);
        }
        Ok(())
    }

    /// Words of a triangle of a core without tables.
    pub(super) fn glint(
        &mut self,
        core: &Core,
        glint: Glint,
        t: &Triangle,
        frame: &Frame,
        writes: &mut Vec<(u8, u64)>,
    ) -> Result<(), String> {
        let m = t.material.as_ref().ok_or("no material")?;
        self.curves(glint, m, writes)?;
        let below = core.fraction_bits();
        let words = |knots, int: usize, frac: usize, offset: i128| {
            let fraction = (frac + below) as u32;
            quadric_words(frame, knots, fraction, 1 + int as u32 + fraction, offset)
        };
        // Half of 2^-17: see the units.
        let half = 2i128 << below;
        let place = |knots, hard: bool| {
            let offset = if hard { half } else { -half };
            words(knots, PLACE_INTEGER_BITS, PLACE_FRACTION_BITS, offset)
        };
        let lobe = if m.shines() { m.kappa()?.1 } else { 0.0 };
        let cone = match (glint, m.cone) {
            (Glint::Kappa, _) => None,
            (Glint::Spot, Some(cone)) => Some((cone.scale()?, cone.hard)),
            (Glint::Spot, None) => return Err("no cone".to_owned()),
        };

        let out = cone
            .is_some_and(|(scale, _)| hull(t, |k| (1.0 - k[2]) * scale).iter().all(|v| *v >= 1.0));
        let dull = out || !m.shines() || hull(t, |k| (1.0 - k[1]) * lobe).iter().all(|v| *v >= 1.0);
        let matt = out || hull(t, |k| k[0]).iter().all(|v| *v <= 0.0);
        let skips = [dull, matt].map(|skip| skip && self.leaves_out());
        let [dull, matt] = skips;

        let light = six(t, "N·L", 0, |c| c)?;
        let light = words(
            light,
            LIGHT_INTEGER_BITS,
            LIGHT_FRACTION_BITS,
            1i128 << (below - 1),
        );
        self.unless(matt, |w, writes| w.words(LIGHT, light, writes), writes);
        let at = six(t, "N·H", 1, |c| (1.0 - c) * lobe)?;
        let at = place(at, false);
        self.unless(dull, |w, writes| w.words(LOBE, at, writes), writes);
        if let Some((scale, hard)) = cone {
            let at = six(t, "the cosine from the axis", 2, |c| (1.0 - c) * scale)?;
            let at = place(at, hard);
            let first = DEPTH | CONE_WORD as u8;
            let send = |w: &mut Self, writes: &mut Vec<_>| {
                for (word, data) in (first..).zip(at) {
                    if w.needed(word, data) {
                        writes.push((word, data));
                    }
                }
            };
            self.unless(dull && matt, send, writes);
        }
        let word = DEPTH | SKIP_WORD as u8;
        let skips = u64::from(dull) | u64::from(matt) << 1;
        if self.needed(word, skips) {
            writes.push((word, skips));
        }
        Ok(())
    }

    /// Sends the ten words of a quadric, or counts them as left out.
    fn unless(
        &mut self,
        skip: bool,
        send: impl FnOnce(&mut Self, &mut Vec<(u8, u64)>),
        writes: &mut Vec<(u8, u64)>,
    ) {
        if skip {
            self.dark(10);
        } else {
            send(self, writes);
        }
    }
}
