//! Integer model of everything that bump cores have between the shell and the pixel stream.
//!
//! Stages that depend on nothing but what enters them are worked out when a pixel enters them; what depends on words of the
//! material or on the memory is kept stage by stage.

use super::model::{blend, dot, newton, reflection, Bump, MapModel};
use super::{address_fraction_bits, select, Bend, ADDRESS_INTEGER_BITS};
use super::{BUMPY_WORD, MAP_PLACE_WORD, MAP_WORD, PLACE_FRACTION_BITS};
use super::{VECTOR_FRACTION_BITS, VECTOR_INTEGER_BITS};
use crate::format::mask;
use crate::interpolate::linear_2::{Controls, Linear2Model};
use crate::interpolate::quadratic_2::Quadratic2Model;
use crate::shade::phong::model::{DelayModel, Fragment, PhongModel};
use crate::shade::phong::root_model::place;
use crate::shade::phong::unit_cosines::SCALE_WORD;
use crate::shade::phong::STAGES;
use std::collections::VecDeque;

/// Light and half-way vector in 2^−16.
type Vectors = [[i64; 3]; 2];

/// State of the stages and interpolants.
#[derive(Clone, Debug)]
pub struct BumpModel {
    bend: Bend,
    wide: bool,
    /// Fraction bits of the vectors below 2^−16.
    below: usize,
    vectors: [[Quadratic2Model; 3]; 2],
    address: [Linear2Model; 2],
    map: MapModel,
    sample: u64,
    bumpy: bool,
    scale: u64,
    /// Where the map is read next.
    place: [u64; 2],
    /// Gradients behind the memory, and vectors, oldest first.
    slopes: VecDeque<[i64; 2]>,
    waiting: VecDeque<Vectors>,
    /// N·L and N·H on their way, oldest first.
    cosines: VecDeque<[i64; 2]>,
    arguments: [i64; 2],
    colour: PhongModel,
    /// Where the pixels are.
    pub delay: DelayModel,
    /// Nothing is accepted until the pixels on their way have been coloured.
    pub draining: bool,
}

impl BumpModel {
    /// The stages of a core at power-up.
    #[must_use]
    pub fn new(bend: Bend, fraction_bits: usize, wide: bool) -> Self {
        let (normal, fetch) = match bend {
            Bend::Newton => (super::newton::STAGES, super::fetch::STAGES),
            Bend::Reflection => (super::reflection::STAGES, super::fetch::STAGES),
        };
        Self {
            bend,
            wide,
            below: fraction_bits,
            vectors: Default::default(),
            address: Default::default(),
            map: MapModel::default(),
            sample: 0,
            bumpy: false,
            scale: 0,
            place: [0; 2],
            slopes: vec![[0; 2]; fetch - 1].into(),
            waiting: vec![[[0; 3]; 2]; fetch].into(),
            cosines: vec![[0; 2]; normal + super::dot::STAGES].into(),
            arguments: [0; 2],
            colour: PhongModel::default(),
            delay: DelayModel::new(bend.stages() + STAGES),
            draining: false,
        }
    }

    /// Integer parts of the colour.
    #[must_use]
    pub fn levels(&self) -> [i64; 3] {
        self.colour.levels()
    }

    /// One clock: an accepted write (select, data), whether the stages move, what the interpolants do, the pixel that
    /// enters.
    pub fn clock(
        &mut self,
        write: Option<(u8, u64)>,
        go: bool,
        controls: Controls,
        fragment: Fragment,
    ) {
        let word = |target: u8| {
            write
                .filter(|(s, _)| s & 0xf0 == target)
                .map(|(s, data)| (usize::from(s & 15), data))
        };
        let material = word(select::MATERIAL);
        let [light, lobe] = self.arguments;
        if go {
            self.advance();
            self.delay.shift(fragment);
        }
        self.colour.clock(material, go, light, lobe);
        if let Some((word, data)) = material {
            self.write(word, data);
        }
        let width = 1 + VECTOR_INTEGER_BITS + VECTOR_FRACTION_BITS + self.below;
        let targets = [select::LIGHT, select::HALF];
        for (vector, targets) in self.vectors.iter_mut().zip(targets) {
            for (part, target) in vector.iter_mut().zip(targets) {
                part.clock(width, word(target), controls);
            }
        }
        let width = 1 + ADDRESS_INTEGER_BITS + address_fraction_bits(self.wide);
        for (part, target) in self.address.iter_mut().zip([select::U, select::V]) {
            part.clock(width, word(target), controls);
        }
    }

    /// The stages, last ones first.
    fn advance(&mut self) {
        let cosines = self.cosines.pop_front().unwrap_or_default();
        self.arguments = arguments(cosines, self.scale);
        let vectors = self.waiting.pop_front().unwrap_or_default();
        let read = self.slopes.pop_front().unwrap_or_default();
        let slope = if self.bumpy { read } else { [0; 2] };
        let bend = self.bend;
        self.cosines
            .push_back(vectors.map(|light| cosine(bend, slope, light)));
        let [u, v] = self.place;
        self.slopes.push_back(blend(self.map.samples(u, v), u, v));
        let below = self.below;
        self.waiting
            .push_back(self.vectors.map(|v| v.map(|p| p.value() >> below)));
        let cut = address_fraction_bits(self.wide) - PLACE_FRACTION_BITS;
        self.place = self
            .address
            .map(|a| (a.value() >> cut) as u64 & mask(6 + PLACE_FRACTION_BITS));
    }

    fn write(&mut self, word: usize, data: u64) {
        match word {
            SCALE_WORD => self.scale = data & 7,
            MAP_PLACE_WORD => self.sample = data & mask(12),
            MAP_WORD => {
                self.map.write(self.sample, data);
                self.sample = (self.sample + 1) & mask(12);
            }
            BUMPY_WORD => self.bumpy = data & 1 == 1,
            _ => {}
        }
    }
}

/// Cosine in 2^−16 of a bump's normal with a vector in 2^−16, for a gradient in 2^−16.
#[must_use]
pub fn cosine(bend: Bend, slope: [i64; 2], light: [i64; 3]) -> i64 {
    let [u, v] = slope;
    let (across, along) = match bend {
        Bend::Newton => (newton(u, v), newton(u, v)),
        Bend::Reflection => reflection(u, v),
    };
    dot(&Bump {
        slope,
        across,
        along,
        light,
    })
}

/// N·L in 2^−16 and the place in the lobe in 2^−19 from N·L and N·H in 2^−16.
#[must_use]
pub fn arguments(cosines: [i64; 2], scale: u64) -> [i64; 2] {
    place(cosines.map(|c| c << 12), scale)
}
