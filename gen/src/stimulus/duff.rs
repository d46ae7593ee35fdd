//! What the Duff core is sent: planes of N·L and N·H, the quadric of |N|², all for the blended normal as it is.

use super::build::{Triangle, Writer};
use crate::setup::{fixed_knot, plane_words, quadric_words, Frame};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::phong::inverse_root::LEAST;
use shadegate_hdl::shade::phong::unit_cosines::{FRACTION_BITS, INTEGER_BITS};

/// Knots are scaled by this before they are rounded to 2^-20, so that they are rounded to 2^-30.
const FINER: u32 = 10;
/// Masks of the words: N·L, N·H, |N|².
const MASKS: [u8; 3] = [0x10, 0x14, 0x20];
/// Least |N|².
const LEAST_SQUARE: f64 = LEAST as f64 / (1u64 << FRACTION_BITS) as f64;

/// The least value of a convex quadric through six knots, on the triangle.
fn least(k: [f64; 6]) -> f64 {
    // On an edge: ends a and b, middle m.
    let edge = |a: f64, b: f64, m: f64| {
        let bend = 2.0 * (a + b - 2.0 * m);
        let slope = b - a - bend;
        let t = if bend > 0.0 {
            (-slope / (2.0 * bend)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (a + slope * t + bend * t * t).min(a).min(b)
    };
    let border = edge(k[0], k[1], k[3])
        .min(edge(k[0], k[2], k[4]))
        .min(edge(k[1], k[2], k[5]));
    // Inside: k0 + d u + e v + a u² + b v² + c u v at its stationary point.
    let a = 2.0 * (k[0] + k[1] - 2.0 * k[3]);
    let b = 2.0 * (k[0] + k[2] - 2.0 * k[4]);
    let c = 4.0 * (k[0] + k[5] - k[3] - k[4]);
    let (d, e) = (k[1] - k[0] - a, k[2] - k[0] - b);
    let determinant = 4.0 * a * b - c * c;
    if determinant <= 1e-12 {
        return border;
    }
    let u = (c * e - 2.0 * b * d) / determinant;
    let v = (c * d - 2.0 * a * e) / determinant;
    if u > 0.0 && v > 0.0 && u + v < 1.0 {
        border.min(k[0] + (d * u + e * v) / 2.0)
    } else {
        border
    }
}

fn fixed(t: &Triangle, name: &str, which: usize) -> Result<[i128; 6], String> {
    let mut out = [0; 6];
    for (to, knot) in out.iter_mut().zip(&t.knots) {
        let value = knot[which];
        *to = fixed_knot(value * f64::from(1u32 << FINER))
            .filter(|_| (-1.0 - 1e-9..=1.0 + 1e-9).contains(&value))
            .ok_or_else(|| format!("{name} {value} at a knot is outside -1 to 1"))?;
    }
    Ok(out)
}

impl Writer<'_> {
    /// Words of a triangle of the Duff core.
    pub(super) fn duff(
        &mut self,
        core: &Core,
        t: &Triangle,
        frame: &Frame,
        writes: &mut Vec<(u8, u64)>,
    ) -> Result<(), String> {
        if t.knots.len() != 6 {
            return Err(format!("{} knots where the core takes 6", t.knots.len()));
        }
        let m = t.material.as_ref().ok_or("no material")?;
        self.material(core.order, m, writes)?;
        let least = least(std::array::from_fn(|i| t.knots[i][2]));
        if least < LEAST_SQUARE {
            return Err(format!(
                "the squared length of the normal falls to {least:.4}; the core takes {LEAST_SQUARE:.4} at least"
            ));
        }
        let fraction = (FRACTION_BITS + core.fraction_bits()) as u32;
        let width = 1 + INTEGER_BITS as u32 + fraction;
        for (which, name) in [(0, "N·L"), (1, "N·H")] {
            if which == 1 && !m.shines() {
                continue;
            }
            let [a, b, c, ..] = fixed(t, name, which)?;
            let words = plane_words(frame, [a, b, c], fraction - FINER, width, 0);
            self.words(MASKS[which], words, writes);
        }
        let square = fixed(t, "N·N", 2)?;
        let words = quadric_words(frame, square, fraction - FINER, width, 0);
        self.words(MASKS[2], words, writes);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::least;

    /// Squared lengths of blends of random vectors, against a fine grid.
    #[test]
    fn the_least_square_is_found() {
        let mut state = 7u64;
        let mut draw = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 40) as f64 / (1u64 << 23) as f64 - 1.0
        };
        for _ in 0..300 {
            let n: [[f64; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| draw()));
            let at = |w: [f64; 3]| {
                (0..3)
                    .map(|i| (0..3).map(|k| w[k] * n[k][i]).sum::<f64>().powi(2))
                    .sum::<f64>()
            };
            let k = [
                at([1.0, 0.0, 0.0]),
                at([0.0, 1.0, 0.0]),
                at([0.0, 0.0, 1.0]),
                at([0.5, 0.5, 0.0]),
                at([0.5, 0.0, 0.5]),
                at([0.0, 0.5, 0.5]),
            ];
            let mut grid = f64::MAX;
            for i in 0..=200 {
                for j in 0..=200 - i {
                    let (u, v) = (f64::from(i) / 200.0, f64::from(j) / 200.0);
                    grid = grid.min(at([1.0 - u - v, u, v]));
                }
            }
            let got = least(k);
            assert!(got <= grid + 1e-12 && got >= grid - 2e-3, "{got} {grid}");
        }
    }
}
