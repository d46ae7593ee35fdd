//! What textured cores are sent: the texels before the first triangle, place and size of the picture where it changes,
//! and the words of colours and addresses.
//!
//! Colours are scaled by 256/255, so that the core's product with a texel in 256ths is right; half a unit of what the core
//! cuts them to is added. Before bilinear interpolation half a texel is taken off u and v, since texel centres lie at
//! i + 1/2, and half of what the core cuts from an address is added; the nearest texel takes u and v as they are.

use super::build::{fixed_colours, Triangle, Writer};
use super::picture::{Picture, Pictures};
use crate::setup::{fixed_knot, plane_words, quadric_words, Frame, KNOT_FRACTION_BITS};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::texture::{
    select, Mapping, Texturing, ADDRESS_FRACTION_BITS, BANK_BITS, COLOUR_FRACTION_BITS, LEAST_W,
    PERSPECTIVE_BITS, PRODUCT_FRACTION_BITS, W_FRACTION_BITS,
};
use std::sync::Arc;

/// How a picture lies on a triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Covering {
    /// The picture.
    pub picture: Arc<Picture>,
    /// The nearest texel instead of a bilinear mean.
    pub nearest: bool,
    /// u and v in texels and w = 1/z, at the vertices; for quadratic addresses at the mid-edges 01, 02, 12 too.
    pub address: Vec<[f64; 3]>,
}

/// Greatest knot of a colour that is multiplied: 4/3 of it, times 256/255, stay below 2048.
const BRIGHTEST: f64 = 1528.0;

fn fixed(value: f64, bits: usize) -> i128 {
    (value * 2f64.powi(bits as i32)).round() as i128
}

/// Words of u, v and w.
struct AddressWords {
    uv: [Vec<u64>; 2],
    w: Option<[u64; 4]>,
}

/// Takes whole pictures off, so that `reach` is as small as it can be; `None` where an address stays beyond it.
fn centred(values: &[f64], side: usize, reach: f64) -> Option<Vec<f64>> {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let side = side as f64;
    let whole = ((least + most) / 2.0 / side).round() * side;
    let moved: Vec<f64> = values.iter().map(|v| v - whole).collect();
    moved.iter().all(|v| v.abs() < reach).then_some(moved)
}

fn perspective(f: &Frame, uv: &[Vec<f64>; 2], w: [f64; 3]) -> Result<AddressWords, String> {
    let most = w.iter().copied().fold(0.0, f64::max);
    // Just below one, so that no rounding reaches it.
    let scaled = w.map(|w| w / most * (1.0 - 2f64.powi(-16)));
    if !scaled.iter().all(|w| *w >= LEAST_W * 1.01) {
        return Err(format!(
            "its depths are in a ratio of more than 32000: 1/z is {}, {} and {} at its vertices",
            w[0], w[1], w[2]
        ));
    }
    let words = |codes: [i128; 3]| {
        // Knots in units of a code: nothing is lost before the one rounding of a word.
        plane_words(f, codes, KNOT_FRACTION_BITS, PERSPECTIVE_BITS as u32, 0)
    };
    let product = |u: &[f64]| {
        let code = |i: usize| fixed(u[i] * scaled[i], PRODUCT_FRACTION_BITS);
        words([0, 1, 2].map(code)).to_vec()
    };
    Ok(AddressWords {
        uv: [product(&uv[0]), product(&uv[1])],
        w: Some(words(scaled.map(|w| fixed(w, W_FRACTION_BITS)))),
    })
}

fn address_words(
    core: &Core,
    t: Texturing,
    f: &Frame,
    c: &Covering,
) -> Result<AddressWords, String> {
    let knots = match t.mapping {
        Mapping::Quadratic => 6,
        _ => 3,
    };
    if c.address.len() != knots {
        return Err(format!(
            "{} addresses where the core takes {knots}",
            c.address.len()
        ));
    }
    let cut = 2f64.powi(-(ADDRESS_FRACTION_BITS as i32));
    let shift = match (c.nearest, t.mapping) {
        (true, _) => 0.0,
        (false, Mapping::Perspective) => cut - 0.5,
        (false, _) => cut / 2.0 - 0.5,
    };
    let reach = match t.mapping {
        Mapping::Perspective => 1023.0,
        Mapping::Quadratic => 2047.0,
        Mapping::Affine => 100_000.0,
    };
    let mut uv = [vec![], vec![]];
    for (i, side) in [c.picture.width, c.picture.height].into_iter().enumerate() {
        let values: Vec<f64> = c.address.iter().map(|a| a[i] + shift).collect();
        uv[i] = centred(&values, side, reach)
            .ok_or_else(|| format!("the texture spans more than {} texels on it", 2.0 * reach))?;
    }
    let (int, frac) = t.mapping.format(core.wide);
    let width = (1 + int + frac) as u32;
    // Within `reach`, so they are finite and fit.
    let codes = |u: &[f64]| -> Option<Vec<i128>> { u.iter().map(|u| fixed_knot(*u)).collect() };
    match t.mapping {
        Mapping::Perspective => perspective(f, &uv, [0, 1, 2].map(|i| c.address[i][2])),
        Mapping::Affine | Mapping::Quadratic => {
            let mut words = [vec![], vec![]];
            for (to, u) in words.iter_mut().zip(&uv) {
                let k = codes(u).ok_or("an address does not fit")?;
                *to = match k[..] {
                    [a, b, c] => plane_words(f, [a, b, c], frac as u32, width, 0).to_vec(),
                    [a, b, c, d, e, g] => {
                        quadric_words(f, [a, b, c, d, e, g], frac as u32, width, 0).to_vec()
                    }
                    _ => return Err("an address has 3 or 6 knots".to_owned()),
                };
            }
            Ok(AddressWords { uv: words, w: None })
        }
    }
}

impl Writer<'_> {
    /// Place and size of a picture, if they are not those before.
    fn covering(&mut self, c: &Covering, pictures: &Pictures, writes: &mut Vec<(u8, u64)>) {
        let base = pictures.place(&c.picture).unwrap_or(0) as u64;
        let place = base | u64::from(c.nearest) << BANK_BITS;
        let mut words = vec![];
        for (select, data) in [
            (select::PLACE, place),
            (select::SIZE, c.picture.size_word()),
        ] {
            if self.needed(select, data) {
                words.push((select, data));
            }
        }
        if self.out.primitives.is_empty() {
            // No pixel is on its way yet.
            self.out.frame.extend(words);
        } else if !words.is_empty() {
            writes.push((shadegate_hdl::shade::phong::FENCE_WORD as u8, 0));
            writes.extend(words);
        }
    }

    /// Words of a triangle of a textured core, without depth.
    pub(super) fn textured(
        &mut self,
        (core, texturing): (&Core, Texturing),
        t: &Triangle,
        frame: &Frame,
        pictures: &Pictures,
        writes: &mut Vec<(u8, u64)>,
    ) -> Result<(), String> {
        let white;
        let covering = match &t.covering {
            Some(c) => c,
            None => {
                let address = vec![
                    [0.0, 0.0, 1.0];
                    if texturing.mapping == Mapping::Quadratic {
                        6
                    } else {
                        3
                    }
                ];
                white = Covering {
                    picture: Picture::white().into(),
                    nearest: true,
                    address,
                };
                &white
            }
        };
        self.covering(covering, pictures, writes);
        let fraction = core.fraction_bits();
        let half = 1i128 << (fraction - COLOUR_FRACTION_BITS - 1);
        let (fraction, width) = (fraction as u32, 12 + fraction as u32);
        let mut colours = [[0; 10]; 3];
        for (channel, words) in colours.iter_mut().enumerate() {
            let scaled = |k: f64| k * 256.0 / 255.0;
            if t.knots.len() == 3 {
                let k = fixed_colours::<3>(t, channel, BRIGHTEST, scaled)?;
                words[..4].copy_from_slice(&plane_words(frame, k, fraction, width, half));
            } else {
                let k = fixed_colours::<6>(t, channel, BRIGHTEST, scaled)?;
                *words = quadric_words(frame, k, fraction, width, half);
            }
        }
        self.colours(&colours, writes);
        let address = address_words(core, texturing, frame, covering)?;
        for (mask, words) in [select::U, select::V].into_iter().zip(&address.uv) {
            self.words(mask, words.iter().copied(), writes);
        }
        if let Some(w) = address.w {
            self.words(select::W, w, writes);
        }
        Ok(())
    }
}
