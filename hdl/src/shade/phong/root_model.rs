//! Integer model of the stages in front of the reflection model in the Duff core, and of one over a root alone.

use super::inverse_root::LEAST;
use super::root_table::root_word;
use crate::format::{mask, wrap};

/// m and e of a square in units of 2^−28, limited: square = m·4^−e.
fn normalise(square: u64) -> (u64, u32) {
    match square {
        s if s >> 26 != 0 => (s >> 4, 0),
        s if s >> 24 & 3 != 0 => (s >> 2 & mask(24), 1),
        s => (s & mask(24), 2),
    }
}

fn limit(square: i64) -> u64 {
    match square {
        s if s < LEAST as i64 => LEAST,
        s if s >= 1 << 28 => (1 << 28) - 1,
        s => s as u64,
    }
}

fn miss(m: u64, seed_square: u64) -> i64 {
    wrap((-((m * seed_square) as i64 >> 19)) & mask(21) as i64, 21)
}

fn newton(seed: u64, miss: i64) -> i64 {
    wrap((seed << 6) as i64 + ((seed as i64 * miss) >> 23), 25)
}

/// y and e with 1/√square = y·2^e·2^−22, square in units of 2^−28.
#[must_use]
pub fn inverse_root(square: i64) -> (i64, u32) {
    let (m, e) = normalise(limit(square));
    let seed = root_word((m >> 14) as usize);
    (newton(seed, miss(m, (seed * seed) >> 9)), e)
}

/// N·L in units of 2^−16 and place in the lobe in units of 2^−19, from two cosines in units of 2^−28.
#[must_use]
pub(crate) fn place([light, half]: [i64; 2], scale: u64) -> [i64; 2] {
    let off = wrap((1 << 28) - half, 32);
    let place = match off {
        o if o < 0 => 0,
        o => (((o as u64) << scale) & mask(39)) >> 9,
    };
    [wrap(light >> 12, 19), wrap((place & mask(30)) as i64, 30)]
}

/// What the stages give for N·L, N·H and |N|² in units of 2^−28 and a scale of the lobe: N·L in units of 2^−16 and the
/// place in the lobe in units of 2^−19.
#[must_use]
pub fn arguments([light, half, square]: [i64; 3], scale: u64) -> [i64; 2] {
    let (root, e) = inverse_root(square);
    let cosine = |dot: i64| wrap(wrap((dot * root) >> 22, 32) << e, 32);
    place([cosine(light), cosine(half)], scale)
}

#[derive(Clone, Copy, Debug, Default)]
struct Scaled {
    m: u64,
    e: u32,
    seed: u64,
    seed_square: u64,
    miss: i64,
}

/// State of the stages.
#[derive(Clone, Debug, Default)]
pub struct DuffModel {
    scale: u64,
    square: u64,
    /// Stages 2 to 5.
    stages: [Scaled; 4],
    root: (i64, u32),
    /// N·L and N·H, stages 1 to 6.
    dots: [[i64; 2]; 6],
    products: ([i64; 2], u32),
    cosines: [i64; 2],
    /// N·L and place in the lobe, as the reflection model takes them.
    pub arguments: [i64; 2],
}

impl DuffModel {
    /// One clock: scale of the lobe if it is written, whether the stages move, N·L, N·H and |N|².
    pub fn clock(&mut self, scale: Option<u64>, go: bool, values: [i64; 3]) {
        if go {
            self.advance(values);
        }
        if let Some(data) = scale {
            self.scale = data & 7;
        }
    }

    fn advance(&mut self, [light, half, square]: [i64; 3]) {
        self.arguments = place(self.cosines, self.scale);
        let (products, e) = self.products;
        self.cosines = products.map(|p| wrap(p << e, 32));
        let (root, e) = self.root;
        self.products = (self.dots[5].map(|d| wrap((d * root) >> 22, 32)), e);
        self.dots.rotate_right(1);
        self.dots[0] = [light, half];
        let [second, third, fourth, fifth] = self.stages;
        self.root = (newton(fifth.seed, fifth.miss), fifth.e);
        let (m, e) = normalise(self.square);
        let seed = root_word((second.m >> 14) as usize);
        self.stages = [
            Scaled {
                m,
                e,
                ..Scaled::default()
            },
            Scaled { seed, ..second },
            Scaled {
                seed_square: (third.seed * third.seed) >> 9,
                ..third
            },
            Scaled {
                miss: miss(fourth.m, fourth.seed_square),
                ..fourth
            },
        ];
        self.square = limit(square);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::phong::inverse_root::ERROR;

    /// Every m of 24 bits.
    #[test]
    fn the_root_is_faithful_for_every_mantissa() {
        let mut worst = 0.0f64;
        for m in 1i64 << 22..1 << 24 {
            // The bits that are cut from m go either way; take the far end of what they stand for.
            let (y, e) = inverse_root((m << 4) | 15);
            assert_eq!(e, 0);
            let want = 1.0 / ((m as f64 + 0.97) / f64::from(1 << 24)).sqrt();
            worst = worst.max((y as f64 / f64::from(1 << 22) - want).abs());
        }
        assert!(worst <= ERROR && worst > 0.7 * ERROR, "{worst:e}");
        // Less than a unit of 17 fraction bits.
        assert!(ERROR < 1.0 / f64::from(1 << 17));
    }

    #[test]
    fn every_power_of_four_and_the_limits() {
        for (square, e) in [
            (1i64 << 28, 0),
            ((1 << 28) - 1, 0),
            (1 << 26, 0),
            ((1 << 26) - 1, 1),
            (1 << 24, 1),
            ((1 << 24) - 1, 2),
            (1 << 22, 2),
        ] {
            let (y, got) = inverse_root(square);
            assert_eq!(got, e, "{square}");
            let root = y as f64 / f64::from(1 << 22) * f64::from(1 << e);
            let want = (f64::from(1 << 28) / square as f64).sqrt();
            assert!(
                (root - want).abs() <= ERROR * f64::from(1 << e),
                "{square}: {root} {want}"
            );
        }
        assert_eq!(inverse_root(5), inverse_root(1 << 22));
        assert_eq!(inverse_root(-5), inverse_root(1 << 22));
        assert_eq!(inverse_root(1 << 29), inverse_root((1 << 28) - 1));
    }
}
