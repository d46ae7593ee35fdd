//! What the bump cores are sent: the gradients of a map where it changes, quadrics of light and half-way vector, planes of
//! the place in the map.
//!
//! Half of what the core cuts is added to vectors and places, and one unit to the gradients, which the two cuts between the
//! samples take away again on average. Half a sample is taken off the place, since samples lie at i + 1/2.

use super::build::{Triangle, Writer};
use super::material::MATERIAL;
use crate::setup::{fixed_knot, plane_words, quadric_words, Frame};
use shadegate_hdl::bump::{
    address_fraction_bits, select, ADDRESS_INTEGER_BITS, BUMPY_WORD, GRADIENT_FRACTION_BITS,
    GRADIENT_LIMIT, MAP_PLACE_WORD, MAP_SIZE, MAP_WORD, PLACE_FRACTION_BITS, VECTOR_FRACTION_BITS,
    VECTOR_INTEGER_BITS,
};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::phong::FENCE_WORD;
use std::sync::Arc;

/// Knots are scaled by this before they are rounded to 2^-20, so that they are rounded to 2^-30.
const FINER: u32 = 10;
/// Longest part of a vector at a knot: its quadric then stays below 2.
const LONGEST: f64 = 1.1;
/// Farthest place in the map, samples; it repeats.
const FARTHEST: f64 = 100_000.0;

/// The gradients of a height map at its samples, [`MAP_SIZE`] squared, row by row: F_u and F_v, world units per world unit.
#[derive(Clone, Debug, PartialEq)]
pub struct GradientMap(Vec<[f64; 2]>);

impl GradientMap {
    /// A map of a gradient per column and row.
    #[must_use]
    pub fn new(slope: impl Fn(usize, usize) -> [f64; 2]) -> Self {
        let one = |i: usize| slope(i % MAP_SIZE, i / MAP_SIZE);
        Self((0..MAP_SIZE * MAP_SIZE).map(one).collect())
    }

    /// F_u and F_v of the sample in a column and row; the map repeats.
    #[must_use]
    pub fn at(&self, column: i64, row: i64) -> [f64; 2] {
        let fold = |x: i64| x.rem_euclid(MAP_SIZE as i64) as usize;
        self.0[fold(row) * MAP_SIZE + fold(column)]
    }

    /// The largest part of a gradient.
    #[must_use]
    pub fn steepest(&self) -> f64 {
        let parts = self.0.iter().flatten();
        parts.fold(0.0, |most: f64, s| most.max(s.abs()))
    }

    /// The words of the samples.
    fn words(&self) -> Result<Vec<u64>, String> {
        let unit = (1u64 << GRADIENT_FRACTION_BITS) as f64;
        let limit = GRADIENT_LIMIT - 1.0 / unit;
        // Not a number is beyond it too.
        let beyond = self
            .0
            .iter()
            .flatten()
            .find(|s| s.abs().max(0.0) > limit || s.is_nan());
        if let Some(slope) = beyond {
            return Err(format!("a bump of slope {slope} is steeper than {limit}"));
        }
        let bits = GRADIENT_FRACTION_BITS + 2;
        let code = |s: f64| ((s * unit).round() as i64 + 1) as u64 & ((1 << bits) - 1);
        Ok(self
            .0
            .iter()
            .map(|[u, v]| code(*u) << bits | code(*v))
            .collect())
    }
}

/// How a map lies on a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Relief {
    /// The map.
    pub map: Arc<GradientMap>,
    /// u and v at the vertices, in samples.
    pub address: [[f64; 2]; 3],
}

/// Six knots of a part of a vector.
fn part(t: &Triangle, first: usize, which: usize) -> Result<[i128; 6], String> {
    if t.knots.len() != 12 {
        return Err(format!("{} knots where the core takes 12", t.knots.len()));
    }
    let mut out = [0; 6];
    for (to, knot) in out.iter_mut().zip(&t.knots[first..]) {
        let value = knot[which];
        *to = fixed_knot(value * f64::from(1u32 << FINER))
            .filter(|_| (-LONGEST..=LONGEST).contains(&value))
            .ok_or_else(|| {
                format!("part {value} of a vector is outside -{LONGEST} to {LONGEST}")
            })?;
    }
    Ok(out)
}

impl Writer<'_> {
    /// The map of a triangle, if it is not the one before, and whether there is one.
    fn map(&mut self, relief: Option<&Relief>, writes: &mut Vec<(u8, u64)>) -> Result<(), String> {
        let word = |number: usize| MATERIAL | number as u8;
        let mut words = vec![];
        let bumpy = u64::from(relief.is_some());
        if self.needed(word(BUMPY_WORD), bumpy) {
            words.push((word(BUMPY_WORD), bumpy));
        }
        // The whole map is one word to those who count: where it lies tells it from others.
        if let Some(r) = relief {
            if self.needed(word(MAP_WORD), Arc::as_ptr(&r.map) as u64) {
                words.push((word(MAP_PLACE_WORD), 0));
                let samples = r.map.words()?.into_iter();
                words.extend(samples.map(|w| (word(MAP_WORD), w)));
            }
        }
        if !words.is_empty() {
            writes.push((FENCE_WORD as u8, 0));
            writes.extend(words);
        }
        Ok(())
    }

    /// Words of a triangle of a bump core, without depth.
    pub(super) fn bump(
        &mut self,
        core: &Core,
        t: &Triangle,
        frame: &Frame,
        writes: &mut Vec<(u8, u64)>,
    ) -> Result<(), String> {
        let m = t.material.as_ref().ok_or("no material")?;
        self.material(core.order, m, writes)?;
        self.map(t.relief.as_ref(), writes)?;
        let below = core.fraction_bits();
        let fraction = (VECTOR_FRACTION_BITS + below) as u32;
        let width = (1 + VECTOR_INTEGER_BITS) as u32 + fraction;
        for (first, targets) in [(0, select::LIGHT), (6, select::HALF)] {
            if first != 0 && !m.shines() {
                continue;
            }
            for (which, target) in targets.into_iter().enumerate() {
                let knots = part(t, first, which)?;
                let half = 1i128 << (below - 1);
                let words = quadric_words(frame, knots, fraction - FINER, width, half);
                self.words(target, words, writes);
            }
        }
        let Some(r) = &t.relief else {
            return Ok(());
        };
        let fraction = address_fraction_bits(core.wide);
        let width = (1 + ADDRESS_INTEGER_BITS + fraction) as u32;
        let half = 1i128 << (fraction - PLACE_FRACTION_BITS - 1);
        for (which, target) in [select::U, select::V].into_iter().enumerate() {
            let mut knots = [0; 3];
            for (to, at) in knots.iter_mut().zip(&r.address) {
                *to = fixed_knot(at[which] - 0.5)
                    .filter(|_| at[which].abs() < FARTHEST)
                    .ok_or_else(|| format!("its place in the map is beyond {FARTHEST} samples"))?;
            }
            let words = plane_words(frame, knots, fraction as u32, width, half);
            self.words(target, words, writes);
        }
        Ok(())
    }
}
