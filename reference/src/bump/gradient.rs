//! The gradient of a height map between its samples (Hast 2004 §3.4, paper IX). Bicubic filters give the surface
//! F = Σ hᵢ(u)·hⱼ(v)·Gⱼᵢ over 4 × 4 samples, and gradients without heights, F_u = Σ hᵢ'(u)·hⱼ(v)·Gⱼᵢ (3.266–3.268). With
//! the samples a…d, e…h, i…l, m…p by rows and f the sample itself, F_u(0, 0) of the B-spline is
//! [(c − a) + 4(g − e) + (k − i)]/12; the table of the thesis has 3 for 4, and its weights do not sum. That of
//! Catmull–Rom is (g − e)/2. Interpolating these differences linearly comes close to it at a fraction of the cost.

use super::kernel::Kernel;
use crate::texture::{Texels, Wrap};
use glam::DVec2;

/// How gradients are found between the samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Gradient {
    /// Those of the nearest sample: bumps with facets.
    Nearest,
    /// Interpolated bilinearly between four samples.
    #[default]
    Linear,
    /// Those of the surface through all samples.
    CatmullRom,
    /// Those of the smooth surface near the samples, which is flatter.
    BSpline,
}

/// Heights, 0 to 1, by rows from the bottom: the mean of red, green and blue.
#[derive(Clone, Debug, PartialEq)]
pub struct Heights {
    width: usize,
    height: usize,
    samples: Vec<f32>,
}

impl Heights {
    /// Takes the heights from a picture.
    #[must_use]
    pub fn new(picture: &Texels) -> Self {
        let (width, height) = (picture.width(), picture.height());
        let sample = |i: usize| {
            let [r, g, b] = picture.at(i % width, i / width);
            ((r + g + b) / 3.0) as f32
        };
        Self {
            width,
            height,
            samples: (0..width * height).map(sample).collect(),
        }
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> DVec2 {
        DVec2::new(self.width as f64, self.height as f64)
    }

    fn at(&self, x: usize, y: usize) -> f64 {
        f64::from(self.samples[y * self.width + x])
    }

    /// Half the difference of the neighbours on both sides.
    fn central(&self, wrap: Wrap, x: usize, y: usize) -> DVec2 {
        let column = |offset| self.at(wrap.neighbour(x, offset, self.width), y);
        let row = |offset| self.at(x, wrap.neighbour(y, offset, self.height));
        DVec2::new(column(1) - column(-1), row(1) - row(-1)) / 2.0
    }

    fn linear(&self, wrap: Wrap, at: DVec2) -> DVec2 {
        let ([x0, x1], f) = wrap.pair(at.x, self.width);
        let ([y0, y1], g) = wrap.pair(at.y, self.height);
        let row = |y| self.central(wrap, x0, y).lerp(self.central(wrap, x1, y), f);
        row(y0).lerp(row(y1), g)
    }

    fn bicubic(&self, kernel: Kernel, wrap: Wrap, at: DVec2) -> DVec2 {
        let ([x, _], f) = wrap.pair(at.x, self.width);
        let ([y, _], g) = wrap.pair(at.y, self.height);
        let (wu, su) = (kernel.weights(f), kernel.slopes(f));
        let (wv, sv) = (kernel.weights(g), kernel.slopes(g));
        let mut sum = DVec2::ZERO;
        for j in 0..4 {
            let row = wrap.neighbour(y, j as isize - 1, self.height);
            for i in 0..4 {
                let h = self.at(wrap.neighbour(x, i as isize - 1, self.width), row);
                sum += DVec2::new(su[i] * wv[j], wu[i] * sv[j]) * h;
            }
        }
        sum
    }

    /// The gradient at a place given in samples; heights per sample.
    #[must_use]
    pub fn gradient(&self, way: Gradient, wrap: Wrap, at: DVec2) -> DVec2 {
        match way {
            Gradient::Nearest => self.central(
                wrap,
                wrap.texel(at.x, self.width),
                wrap.texel(at.y, self.height),
            ),
            Gradient::Linear => self.linear(wrap, at),
            Gradient::CatmullRom => self.bicubic(Kernel::CATMULL_ROM, wrap, at),
            Gradient::BSpline => self.bicubic(Kernel::B_SPLINE, wrap, at),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const ALL: [Gradient; 4] = [
        Gradient::Nearest,
        Gradient::Linear,
        Gradient::CatmullRom,
        Gradient::BSpline,
    ];

    fn heights(w: usize, h: usize, f: impl Fn(usize, usize) -> f64) -> Heights {
        Heights::new(&Texels::from_fn(w, h, |x, y| [f(x, y) as f32; 3]))
    }

    /// The published weights at the corners of a cell, one sample at a time. The samples are those of a cell around
    /// sample (1, 1), which is called f; u grows with the column and v with the row.
    #[test]
    fn the_weights_of_the_thesis() {
        let weight = |way, name: char, u: f64, v: f64| {
            let k = name as usize - 'a' as usize;
            // Far from its repetitions.
            let h = heights(12, 12, |x, y| f64::from(u8::from((x, y) == (k % 4, k / 4))));
            h.gradient(way, Wrap::Repeat, DVec2::new(1.5 + u, 1.5 + v))
                .x
        };
        let spline = [
            ('a', -1.0),
            ('b', 0.0),
            ('c', 1.0),
            ('e', -4.0),
            ('f', 0.0),
            ('g', 4.0),
            ('i', -1.0),
            ('k', 1.0),
            ('m', 0.0),
        ];
        for (name, twelfths) in spline {
            let got = weight(Gradient::BSpline, name, 0.0, 0.0);
            assert!((got - twelfths / 12.0).abs() < 1e-12, "{name} {got}");
        }
        for (u, v, plus, minus) in [
            (0.0, 0.0, 'g', 'e'),
            (1.0, 0.0, 'h', 'f'),
            (0.0, 1.0, 'k', 'i'),
            (1.0, 1.0, 'l', 'j'),
        ] {
            for name in 'a'..='p' {
                let want =
                    0.5 * (f64::from(u8::from(name == plus)) - f64::from(u8::from(name == minus)));
                let got = weight(Gradient::CatmullRom, name, u, v);
                assert!((got - want).abs() < 1e-12, "{name} at ({u}, {v}): {got}");
            }
        }
    }

    /// A ramp of slope 1 in u and −2 in v has just these, in every filter; with the 3 of the thesis it would be 0.83.
    #[test]
    fn a_ramp_keeps_its_slope() {
        let h = heights(16, 16, |x, y| (x as f64 - 2.0 * y as f64) / 64.0);
        for way in ALL {
            for (x, y) in [(5.5, 5.5), (6.2, 9.9), (8.0, 7.01)] {
                let g = h.gradient(way, Wrap::Clamp, DVec2::new(x, y)) * 64.0;
                assert!(g.distance(DVec2::new(1.0, -2.0)) < 1e-5, "{way:?} {g}");
            }
        }
    }

    /// Against the derivative of the wave that was sampled, sin·cos with 16 samples per period, along a crest of the
    /// cosine. Central differences scale the slope by sin w/w, w = 2π/16 (2.5 % too flat), which Catmull–Rom keeps and
    /// linear interpolation adds w²/8 to; the spline also blurs across, by (2 + cos w)/3.
    #[test]
    fn errors_on_a_wave() {
        let n = 64;
        let w = TAU / 16.0;
        let h = heights(n, n, |x, y| {
            0.5 + 0.5 * (w * (x as f64 + 0.5)).sin() * (w * (y as f64 - 7.0)).cos()
        });
        for (way, bound) in [
            (Gradient::Nearest, 0.20),
            (Gradient::Linear, 0.045),
            (Gradient::CatmullRom, 0.026),
            (Gradient::BSpline, 0.051),
        ] {
            let mut worst = 0.0f64;
            for k in 0..=640 {
                let x = f64::from(k) / 10.0;
                let g = h.gradient(way, Wrap::Repeat, DVec2::new(x, 7.5));
                assert!(g.y.abs() < 1e-7);
                worst = worst.max((g.x / (0.5 * w) - (w * x).cos()).abs());
            }
            println!("{way:?}: {worst:.4} of the steepest slope");
            assert!(worst <= bound && worst > 0.9 * bound, "{way:?} {worst}");
        }
    }
}
