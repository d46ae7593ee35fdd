//! The z-buffer: at every pixel the nearest of the triangles that cover it, of equals the first.
//!
//! What it stores decides what it can tell apart (Loisel 1996, section on the z-buffer; the law is our own):
//!
//! - 1/z, as near/z with F fraction bits, is affine on the screen, one addition per pixel. Two depths are told apart
//!   when they differ by Δz ≈ z²·2^−F / near: coarse far away.
//! - z, as z/far with F fraction bits, needs a division per pixel and is equally fine everywhere: Δz = far·2^−F.
//! - The renderer's reversed depth, fitted to the frame, here as a real number: the reference.

use super::{each_span, pixel, Visible};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::shade::barycentric::{steps, weights};

/// What a cell holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stored {
    /// Reversed depth as it is.
    Real,
    /// near/z in a word.
    Inverse(Word),
    /// z/far in a word.
    Z(Word),
}

/// A word of F fraction bits and the depths it is made for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Word {
    /// F, 1 to 32.
    pub bits: u32,
    /// The nearest depth, > 0, in units of w.
    pub near: f64,
    /// The farthest.
    pub far: f64,
}

impl Word {
    /// A word for the depths of a frame. Without perspective every w is 1, and a depth buffer on w says nothing.
    #[must_use]
    pub fn of(p: &Prepared, bits: u32) -> Self {
        let all = || p.triangles.iter().flat_map(|t| t.inv_w);
        Self {
            bits,
            near: 1.0 / all().fold(f64::MIN_POSITIVE, f64::max),
            far: 1.0 / all().fold(f64::INFINITY, f64::min),
        }
    }

    /// near/z, rounded to nearest; the nearest depth itself saturates.
    #[must_use]
    pub fn inverse(&self, inv_z: f64) -> u64 {
        let one = (1u64 << self.bits) as f64;
        ((self.near * inv_z * one + 0.5) as u64).min((1 << self.bits) - 1)
    }

    /// z/far, rounded to nearest; the farthest depth itself saturates.
    #[must_use]
    pub fn z(&self, inv_z: f64) -> u64 {
        let one = (1u64 << self.bits) as f64;
        ((one / (inv_z * self.far) + 0.5) as u64).min((1 << self.bits) - 1)
    }

    /// How far apart two depths around `z` must be for near/z to tell them apart.
    #[must_use]
    pub fn resolution_of_inverse(&self, z: f64) -> f64 {
        z * z / (self.near * (1u64 << self.bits) as f64)
    }

    /// How far apart two depths must be for z/far to tell them apart.
    #[must_use]
    pub fn resolution_of_z(&self) -> f64 {
        self.far / (1u64 << self.bits) as f64
    }
}

/// Draws all triangles in order.
#[must_use]
pub fn draw(p: &Prepared, stored: Stored) -> Visible {
    let inv_w = |t: &ScreenTriangle| t.inv_w;
    match stored {
        Stored::Real => fill(p, f64::NEG_INFINITY, |t| t.depth, |d| d),
        Stored::Inverse(word) => fill(p, -1, inv_w, |v| word.inverse(v) as i64),
        Stored::Z(word) => fill(p, i64::MIN, inv_w, |v| -(word.z(v) as i64)),
    }
}

/// `values` at the vertices are interpolated; of their keys the greatest is nearest.
fn fill<K: Copy + PartialOrd>(
    p: &Prepared,
    cleared: K,
    values: impl Fn(&ScreenTriangle) -> [f64; 3],
    key: impl Fn(f64) -> K,
) -> Visible {
    let mut visible = Visible::new(p);
    let mut buffer = vec![cleared; visible.ids.len()];
    for (i, t) in p.triangles.iter().enumerate() {
        let v = values(t);
        let dot = |w: [f64; 3]| w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
        let step = dot(steps(&t.position));
        each_span(p, t, |span| {
            let first = dot(weights(&t.position, span.start, span.y));
            let at = pixel(p, span.start, span.y);
            let count = (span.end - span.start) as usize;
            let (cells, ids) = (
                &mut buffer[at..at + count],
                &mut visible.ids[at..at + count],
            );
            for (k, (cell, id)) in cells.iter_mut().zip(ids).enumerate() {
                let nearness = key(first + k as f64 * step);
                if nearness > *cell {
                    *cell = nearness;
                    *id = i as u32;
                    visible.written += 1;
                }
            }
        });
    }
    visible
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    /// Depths that are a fraction of the resolution apart are confused as often as rounding says, and never from one
    /// resolution on.
    #[test]
    fn order_errors_follow_the_law() {
        let mut rng = StdRng::seed_from_u64(7);
        for bits in [16, 18, 24] {
            let word = Word {
                bits,
                near: 1.0,
                far: 1000.0,
            };
            for z in [1.5, 10.0, 90.0] {
                for apart in [0.25, 0.5, 0.75, 1.02, 3.0] {
                    for inverse in [true, false] {
                        let resolution = if inverse {
                            word.resolution_of_inverse(z)
                        } else {
                            word.resolution_of_z()
                        };
                        let trials = 4000;
                        let mut confused = 0;
                        for _ in 0..trials {
                            // A word's width around z, so that every phase of the grid occurs.
                            let z = z + rng.random_range(-2.0..2.0) * resolution;
                            let (near, far) = (1.0 / z, 1.0 / (z + apart * resolution));
                            confused += u32::from(if inverse {
                                word.inverse(near) <= word.inverse(far)
                            } else {
                                word.z(near) >= word.z(far)
                            });
                        }
                        let rate = f64::from(confused) / f64::from(trials);
                        let want = (1.0 - apart).max(0.0);
                        assert!(
                            (rate - want).abs() < 0.03 && (apart < 1.0 || confused == 0),
                            "F={bits} z={z} apart={apart} inverse={inverse}: {rate}"
                        );
                    }
                }
            }
        }
        // The figures of the law for near = 1: 1.5e-5 at z = 1 and 0.15 at 100 for 16 bits, 6e-8 and 6e-4 for 24.
        let at = |bits, z| {
            let word = Word {
                bits,
                near: 1.0,
                far: 1e5,
            };
            word.resolution_of_inverse(z)
        };
        for (bits, z, want) in [
            (16, 1.0, 1.5e-5),
            (16, 100.0, 0.15),
            (18, 10.0, 3.8e-4),
            (24, 100.0, 6e-4),
        ] {
            assert!((at(bits, z) / want - 1.0).abs() < 0.03);
        }
    }
}
