//! Integer models of the reflection model's stages and of the fragments that go along with them.

use super::power_table::WORDS;
use super::{TABLE_PLACE_WORD, TABLE_WORD};
use crate::format::{mask, wrap};

/// max(0, N·L), at most 1, in units of 2^−16.
fn limit_light(light: i64) -> i64 {
    light.clamp(0, 1 << 16)
}

/// Place in the table in units of 2^−19; `None` beyond it.
fn limit_place(place: i64) -> Option<u64> {
    let place = place.max(0) as u64;
    (place < 1 << 19).then_some(place)
}

/// The power (17 fraction bits) that the table gives for a place in units of 2^−19.
#[must_use]
pub fn power(table: &[u32], place: i64) -> i64 {
    let Some(place) = limit_place(place) else {
        return 0;
    };
    let word = table[(place >> 10) as usize];
    finish(u64::from(word), place & mask(10))
}

fn finish(word: u64, fraction: u64) -> i64 {
    let (start, fall) = (word >> 14, word & mask(14));
    ((start.wrapping_sub((fall * fraction) >> 10) & mask(18)) >> 1) as i64
}

/// The colour words of one channel, in codes of their formats.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tint {
    /// Q11.12, with half an LSB.
    pub ambient: i64,
    /// Q11.6.
    pub diffuse: i64,
    /// Q11.6.
    pub specular: i64,
}

impl Tint {
    /// Takes a word: 0 ambient, 1 diffuse, 2 specular.
    pub(crate) fn write(&mut self, word: usize, data: u64) {
        let low = |bits: usize| wrap((data & mask(bits)) as i64, bits);
        match word {
            0 => self.ambient = low(24),
            1 => self.diffuse = low(18),
            _ => self.specular = low(18),
        }
    }

    /// Colour without the highlight, and the highlight, Q11.12.
    pub(crate) fn products(&self, light: i64, power: i64) -> (i64, i64) {
        let reflected = wrap((self.diffuse * light) >> 10, 24);
        let gloss = wrap((self.specular * power) >> 11, 24);
        (wrap(self.ambient + reflected, 24), gloss)
    }
}

/// A pixel in the first three stages.
#[derive(Clone, Copy, Debug, Default)]
struct Lobe {
    light: i64,
    place: Option<u64>,
    /// What the table has there, from stage 2 on.
    word: u64,
}

/// State of [`super::colour::PhongColour`].
#[derive(Clone, Debug)]
pub struct PhongModel {
    table: Vec<u32>,
    interval: u64,
    tint: [Tint; 3],
    lobes: [Lobe; 3],
    /// Stage 4: light and power.
    lit: (i64, i64),
    /// Stage 5: colour without highlight, highlight.
    parts: [(i64, i64); 3],
    /// Stage 6.
    colour: [i64; 3],
}

impl Default for PhongModel {
    fn default() -> Self {
        // Registers are zero at power-up, and the table's output too.
        let lobe = Lobe {
            place: Some(0),
            ..Lobe::default()
        };
        Self {
            table: vec![0; WORDS],
            interval: 0,
            tint: Default::default(),
            lobes: [lobe; 3],
            lit: (0, 0),
            parts: Default::default(),
            colour: [0; 3],
        }
    }
}

impl PhongModel {
    /// Integer parts of red, green and blue of the pixel that entered six moves ago.
    #[must_use]
    pub fn levels(&self) -> [i64; 3] {
        self.colour.map(|c| c >> 12)
    }

    /// One clock: a material word and its data, whether the stages move, N·L and place in the lobe.
    pub fn clock(&mut self, write: Option<(usize, u64)>, go: bool, light: i64, place: i64) {
        if go {
            let (light_4, power_4) = self.lit;
            self.colour = self.parts.map(|(matt, gloss)| wrap(matt + gloss, 24));
            self.parts = self.tint.map(|t| t.products(light_4, power_4));
            let [first, second, third] = self.lobes;
            let power = third.place.map_or(0, |p| finish(third.word, p & mask(10)));
            self.lit = (third.light, power);
            self.lobes = [
                Lobe {
                    light: limit_light(light),
                    place: limit_place(place),
                    word: 0,
                },
                Lobe {
                    word: u64::from(self.table[(first.place.unwrap_or(0) >> 10) as usize]),
                    ..first
                },
                second,
            ];
        }
        if let Some((word, data)) = write {
            self.write(word, data);
        }
    }

    fn write(&mut self, word: usize, data: u64) {
        match word {
            0..=8 => self.tint[word / 3].write(word % 3, data),
            TABLE_PLACE_WORD => self.interval = data & mask(9),
            TABLE_WORD => {
                self.table[self.interval as usize] = data as u32;
                self.interval = (self.interval + 1) & mask(9);
            }
            _ => {}
        }
    }
}

/// A fragment on its way to the depth test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fragment {
    /// There is one.
    pub valid: bool,
    /// Ordinal of its triangle.
    pub ordinal: u64,
    /// Column.
    pub x: u64,
    /// Row.
    pub y: u64,
    /// Frame address.
    pub address: u64,
    /// Depth word.
    pub depth: u16,
}

/// Fragments in as many stages as there are between the interpolants and the pixel stream.
#[derive(Clone, Debug)]
pub struct DelayModel(Vec<Fragment>);

impl DelayModel {
    /// A delay of so many stages. The depth registers hold 0 less the bias at power-up.
    #[must_use]
    pub fn new(stages: usize) -> Self {
        let empty = Fragment {
            depth: 1 << 15,
            ..Fragment::default()
        };
        Self(vec![empty; stages])
    }

    /// The fragment that leaves.
    #[must_use]
    pub fn last(&self) -> Option<Fragment> {
        self.0.last().copied()
    }

    /// A fragment is in one of the stages.
    #[must_use]
    pub fn busy(&self) -> bool {
        self.0.iter().any(|f| f.valid)
    }

    /// One move.
    pub fn shift(&mut self, next: Fragment) {
        self.0.rotate_right(1);
        if let Some(first) = self.0.first_mut() {
            *first = next;
        }
    }
}
