//! Mip-maps (Williams 1983; Zed3D 1996, "Mipmapping"): each level has half the columns and rows of the one before, and a
//! place between two levels is interpolated bilinearly in both and linearly between them (trilinear): level 3.15 is
//! 85 % of level 3 and 15 % of level 4. A picture and its levels take 4/3 of its memory.

use super::{point, pyramid, Footprint, Texels, Wrap};
use glam::DVec2;

/// A picture and its levels.
#[derive(Clone, Debug, PartialEq)]
pub struct MipMap {
    levels: Vec<Texels>,
}

impl MipMap {
    /// Makes the levels, down to a single texel.
    #[must_use]
    pub fn new(picture: Texels) -> Self {
        let count = pyramid::levels(picture.width().max(picture.height()));
        Self {
            levels: pyramid::chain(picture, count, |t| {
                pyramid::halve_height(&pyramid::halve_width(t))
            }),
        }
    }

    /// The levels, the picture first.
    #[must_use]
    pub fn levels(&self) -> &[Texels] {
        &self.levels
    }

    /// Bilinear in one level at a place given in texels of the picture.
    fn one(&self, level: usize, wrap: Wrap, at: DVec2) -> [f64; 3] {
        let (base, t) = (&self.levels[0], &self.levels[level]);
        let ratio = DVec2::new(
            t.width() as f64 / base.width() as f64,
            t.height() as f64 / base.height() as f64,
        );
        point::bilinear(t, wrap, at * ratio)
    }

    /// Trilinear at a place given in texels of the picture.
    #[must_use]
    pub fn sample(&self, wrap: Wrap, at: DVec2, footprint: &Footprint) -> [f64; 3] {
        let last = self.levels.len() - 1;
        let level = footprint.level().min(last as f64);
        let lower = (level as usize).min(last);
        let share = level - lower as f64;
        let fine = self.one(lower, wrap, at);
        if share > 0.0 {
            let coarse = self.one((lower + 1).min(last), wrap, at);
            [0, 1, 2].map(|c| fine[c] + share * (coarse[c] - fine[c]))
        } else {
            fine
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::pattern;

    fn isotropic(scale: f64) -> Footprint {
        Footprint {
            right: DVec2::X * scale,
            down: DVec2::Y * scale,
        }
    }

    #[test]
    fn levels_are_averages_of_squares() {
        let picture = Texels::from_fn(32, 32, |x, y| [((x * 5 + y * 3) % 17) as f32 / 17.0; 3]);
        let m = MipMap::new(picture.clone());
        assert_eq!(m.levels().len(), 6);
        for (l, level) in m.levels().iter().enumerate() {
            let side = 1 << l;
            for (x, y) in [(0, 0), (level.width() - 1, level.height() / 2)] {
                let mut sum = 0.0;
                for i in 0..side * side {
                    sum += picture.at(x * side + i % side, y * side + i / side)[0];
                }
                let mean = sum / (side * side) as f64;
                assert!((level.at(x, y)[0] - mean).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn level_three_and_a_bit() {
        let m = MipMap::new(pattern::colour("tiles").unwrap());
        let at = DVec2::new(11.3, 47.9);
        let got = m.sample(Wrap::Repeat, at, &isotropic(3.15f64.exp2()));
        let (three, four) = (m.one(3, Wrap::Repeat, at), m.one(4, Wrap::Repeat, at));
        for c in 0..3 {
            assert!((got[c] - (0.85 * three[c] + 0.15 * four[c])).abs() < 1e-9);
        }
        // Beyond the last level there is only the mean.
        let far = m.sample(Wrap::Repeat, at, &isotropic(1e9));
        assert_eq!(far, m.levels()[6].at(0, 0));
    }

    #[test]
    fn a_checker_seen_from_afar_is_grey() {
        let m = MipMap::new(pattern::colour("checker").unwrap());
        for scale in [16.0, 17.0, 40.0, 64.0, 1000.0] {
            for place in 0..50 {
                let at = DVec2::new(f64::from(place) * 1.37, f64::from(place) * 2.11);
                let v = m.sample(Wrap::Repeat, at, &isotropic(scale))[0];
                assert!((v - 0.6).abs() < 1e-6, "{scale} {v}");
            }
        }
    }
}
