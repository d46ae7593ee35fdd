//! The filters for magnification: the nearest texel, and bilinear interpolation between four (Zed3D 1996,
//! "Bilinear"; its figure of the areas is lost, the weights here are the products of the distances):
//! t = nw + f·(ne − nw), b = sw + f·(se − sw), t + g·(b − t). A convex sum of four texels, which lie in no plane in
//! general (the text calls it one).

use super::{Texels, Wrap};
use glam::DVec2;

/// The texel that covers a place, given in texels.
#[must_use]
pub fn nearest(t: &Texels, wrap: Wrap, at: DVec2) -> [f64; 3] {
    t.at(wrap.texel(at.x, t.width()), wrap.texel(at.y, t.height()))
}

/// Interpolated between the four texels whose centres enclose a place, given in texels.
#[must_use]
pub fn bilinear(t: &Texels, wrap: Wrap, at: DVec2) -> [f64; 3] {
    let ([x0, x1], f) = wrap.pair(at.x, t.width());
    let ([y0, y1], g) = wrap.pair(at.y, t.height());
    let (a, b, c, d) = (t.at(x0, y0), t.at(x1, y0), t.at(x0, y1), t.at(x1, y1));
    [0, 1, 2].map(|k| {
        let first = a[k] + f * (b[k] - a[k]);
        let second = c[k] + f * (d[k] - c[k]);
        first + g * (second - first)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A picture of texels that differ everywhere.
    fn picture() -> Texels {
        Texels::from_fn(7, 5, |x, y| {
            let v = ((x * 37 + y * 101) % 97) as f32 / 97.0;
            [v, 1.0 - v, v * v]
        })
    }

    /// The definition: every texel weighs with the product of its distances, the picture repeated.
    fn tent(t: &Texels, at: DVec2) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for y in 0..t.height() {
            for x in 0..t.width() {
                for copy in 0..9 {
                    let shift = DVec2::new((copy % 3) as f64 - 1.0, (copy / 3) as f64 - 1.0)
                        * DVec2::new(t.width() as f64, t.height() as f64);
                    let d = (DVec2::new(x as f64 + 0.5, y as f64 + 0.5) + shift - at).abs();
                    let weight = (1.0 - d.x).max(0.0) * (1.0 - d.y).max(0.0);
                    for (s, v) in sum.iter_mut().zip(t.at(x, y)) {
                        *s += weight * v;
                    }
                }
            }
        }
        sum
    }

    proptest! {
        #[test]
        fn bilinear_is_a_tent(x in 0.0..7.0f64, y in 0.0..5.0f64) {
            let (t, at) = (picture(), DVec2::new(x, y));
            let (got, want) = (bilinear(&t, Wrap::Repeat, at), tent(&t, at));
            for c in 0..3 {
                prop_assert!((got[c] - want[c]).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn at_the_centres_both_give_the_texel() {
        let t = picture();
        for wrap in [Wrap::Repeat, Wrap::Clamp] {
            for y in 0..5 {
                for x in 0..7 {
                    let at = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                    assert_eq!(nearest(&t, wrap, at), t.at(x, y));
                    assert_eq!(bilinear(&t, wrap, at), t.at(x, y));
                }
            }
        }
    }
}
