//! Integer models of highlight, spot and the stages around them.

use super::{CONE_WORD, CURVE_WORD, SKIP_WORD};
use crate::format::{mask, wrap};
use crate::interpolate::linear_2::Controls;
use crate::shade::phong::model::Tint;

/// Largest value: 1 less one unit.
const FULL: u64 = (1 << 17) - 1;

/// Seventeen fraction bits of a place that begins the units; `None` at and beyond 1.
fn inner(place: i64) -> Option<u64> {
    let place = place.max(0) as u64;
    (place < 1 << 19).then_some(place >> 2)
}

fn product(a: u64, b: u64) -> u64 {
    (a * b) >> 17
}

/// What the highlight unit begins with: 1 − t; `None` where the pixel is skipped.
fn rest(place: i64) -> Option<u64> {
    inner(place).map(|place| FULL - place)
}

/// (1 − t)^d from 1 − t.
fn power(degree: u8, rest: u64) -> u64 {
    let square = product(rest, rest);
    match degree {
        2 => square,
        4 => product(square, square),
        _ => product(square, rest),
    }
}

/// The highlight at a place in the lobe (units of 2^−19), in units of 2^−17; `None` where it is skipped.
#[must_use]
pub fn highlight(degree: u8, place: i64) -> Option<u64> {
    rest(place).map(|rest| power(degree, rest))
}

/// What the spot unit begins with: v or 1 − v; `None` outside the cone.
fn base(hard: bool, place: i64) -> Option<u64> {
    if hard {
        inner(place)
    } else {
        rest(place)
    }
}

/// The light from that.
fn fall_off(hard: bool, base: u64) -> u64 {
    let square = product(base, base);
    if hard {
        FULL - square
    } else {
        square
    }
}

/// The light of a spot at a place in the cone (units of 2^−19), in units of 2^−17; `None` outside.
#[must_use]
pub fn spot(hard: bool, place: i64) -> Option<u64> {
    base(hard, place).map(|base| fall_off(hard, base))
}

/// What a triangle does without: highlight, diffuse reflection. Model of [`super::skip::Skip`].
#[derive(Clone, Copy, Debug, Default)]
pub struct SkipModel {
    word: u64,
    line: u64,
    span: u64,
}

impl SkipModel {
    /// No highlight, no diffuse reflection on the triangle of the current pixel.
    #[must_use]
    pub fn outputs(&self) -> (bool, bool) {
        (self.span & 1 == 1, self.span & 2 == 2)
    }

    /// One clock.
    pub fn clock(&mut self, write: Option<u64>, c: Controls) {
        if c.take {
            self.span = self.line;
        }
        if c.load {
            self.line = self.word;
        }
        if let Some(data) = write {
            self.word = data & 3;
        }
    }
}

/// What a pixel comes with.
#[derive(Clone, Copy, Debug, Default)]
pub struct LightInputs {
    /// N·L, in units of 2^−16.
    pub light: i64,
    /// Place in the lobe, in units of 2^−19.
    pub place: i64,
    /// Place in the cone, likewise.
    pub cone: i64,
    /// The triangle has no highlight.
    pub no_highlight: bool,
    /// The triangle has no diffuse reflection.
    pub no_diffuse: bool,
}

/// A pixel in the first two stages.
#[derive(Clone, Copy, Debug, Default)]
struct Early {
    light: u64,
    /// What the units begin with; `None` where they are skipped.
    rest: Option<u64>,
    base: Option<u64>,
}

/// Model of [`super::kappa_colour::KappaColour`] and [`super::spot_colour::SpotColour`].
#[derive(Clone, Debug)]
pub struct LightModel {
    has_spot: bool,
    degree: u8,
    hard: bool,
    tint: [Tint; 3],
    early: [Early; 2],
    /// Stage 3: light, highlight, spot.
    late: (u64, u64, u64),
    /// Stage 4: light and highlight.
    lit: (i64, i64),
    /// Stage 5: colour without highlight, highlight.
    parts: [(i64, i64); 3],
    /// Stage 6.
    colour: [i64; 3],
}

impl LightModel {
    /// Stages at power-up, with or without a spot.
    #[must_use]
    pub fn new(has_spot: bool) -> Self {
        Self {
            has_spot,
            degree: 0,
            hard: false,
            tint: Default::default(),
            early: Default::default(),
            late: (0, 0, 0),
            lit: (0, 0),
            parts: Default::default(),
            colour: [0; 3],
        }
    }

    /// Integer parts of red, green and blue of the pixel that entered six moves ago.
    #[must_use]
    pub fn levels(&self) -> [i64; 3] {
        self.colour.map(|c| c >> 12)
    }

    /// One clock: a material word and its data, whether the stages move, what a pixel comes with.
    pub fn clock(&mut self, write: Option<(usize, u64)>, go: bool, i: &LightInputs) {
        if go {
            let (light, gloss) = self.lit;
            self.colour = self.parts.map(|(matt, gloss)| wrap(matt + gloss, 24));
            self.parts = self.tint.map(|t| t.products(light, gloss));
            let (light, gloss, spot) = self.late;
            self.lit = if self.has_spot {
                (product(light, spot) as i64, product(gloss, spot) as i64)
            } else {
                (light as i64, gloss as i64)
            };
            let [first, second] = self.early;
            let power = |rest| power(self.degree, rest);
            let fall_off = |base| fall_off(self.hard, base);
            self.late = (
                second.light,
                second.rest.map_or(0, power),
                second.base.map_or(0, fall_off),
            );
            let dark = i.no_highlight && i.no_diffuse;
            let limited = i.light.clamp(0, 1 << 16) as u64;
            let arrived = Early {
                light: if i.no_diffuse { 0 } else { limited },
                rest: rest(i.place).filter(|_| !i.no_highlight),
                base: base(self.hard, i.cone).filter(|_| !dark),
            };
            self.early = [arrived, first];
        }
        if let Some((word, data)) = write {
            self.write(word, data);
        }
    }

    fn write(&mut self, word: usize, data: u64) {
        match word {
            0..=8 => self.tint[word / 3].write(word % 3, data),
            CURVE_WORD => {
                self.degree = (data & mask(3)) as u8;
                self.hard = data >> 3 & 1 == 1;
            }
            _ => {}
        }
    }
}

/// Where a word of the depth's mask goes.
#[must_use]
pub fn cone_word(word: usize) -> Option<usize> {
    (CONE_WORD..SKIP_WORD)
        .contains(&word)
        .then(|| word - CONE_WORD)
}
