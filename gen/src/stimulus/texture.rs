//! What textured cores are sent: the texels before the first triangle, place and size of the picture where it changes,
//! and the words of colours and addresses.
//!
//! Colours are scaled by 256/255, so that the core's product with a texel in 256ths is right; half a unit of what the core
//! cuts them to is added. Before bilinear interpolation half a texel is taken off u and v, since texel centres lie at
//! i + 1/2, and half of what the core cuts from an address is added; the nearest texel takes u and v as they are.

use super::build::{fixed_colours, Triangle, Writer};
use crate::setup::{fixed_knot, plane_words, quadric_words, Frame, KNOT_FRACTION_BITS};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::texture::{
    select, Mapping, Texturing, ADDRESS_FRACTION_BITS, BANK_BITS, COLOUR_FRACTION_BITS, LEAST_W,
    MAX_SIDE, PERSPECTIVE_BITS, PRODUCT_FRACTION_BITS, W_FRACTION_BITS,
};
use std::sync::Arc;

/// A picture as the texture memory holds it: rows from the bottom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns, a power of two up to [`MAX_SIDE`].
    pub width: usize,
    /// Rows, likewise.
    pub height: usize,
    /// Red, green, blue, row by row.
    pub texels: Vec<[u8; 3]>,
}

impl Picture {
    /// One white texel: what triangles without a texture are covered with.
    #[must_use]
    pub fn white() -> Self {
        Self {
            width: 1,
            height: 1,
            texels: vec![[255; 3]],
        }
    }

    /// Words that it takes in each of the four banks.
    #[must_use]
    pub fn bank_words(&self) -> usize {
        self.width.div_ceil(2) * self.height.div_ceil(2)
    }

    /// The texel at a column and row, repeated.
    #[must_use]
    pub fn at(&self, x: usize, y: usize) -> [u8; 3] {
        self.texels[(y % self.height) * self.width + x % self.width]
    }

    fn check(&self) -> Result<(), String> {
        let side = |n: usize| n.is_power_of_two() && n <= MAX_SIDE as usize;
        if side(self.width) && side(self.height) && self.texels.len() == self.width * self.height {
            return Ok(());
        }
        Err(format!(
            "a picture of {}x{} texels where the core takes sides of a power of two up to {MAX_SIDE}",
            self.width, self.height
        ))
    }

    /// Its size word: pairs of columns and of rows less one, and the logarithm of the first.
    fn size_word(&self) -> u64 {
        let [columns, rows] = [self.width, self.height].map(|n| n.div_ceil(2) as u64);
        (columns - 1) | (rows - 1) << 9 | u64::from(columns.trailing_zeros()) << 18
    }
}

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

/// Pictures of a list of triangles and where they begin in the banks.
#[derive(Clone, Debug, Default)]
pub(super) struct Pictures(Vec<(Arc<Picture>, usize)>);

impl Pictures {
    /// The different pictures, in order of appearance.
    pub(super) fn new(triangles: &[Triangle]) -> Self {
        let white = Arc::new(Picture::white());
        let mut all = Self::default();
        let mut next = 0;
        for t in triangles {
            let picture = t.covering.as_ref().map_or(&white, |c| &c.picture);
            if all.place(picture).is_none() {
                all.0.push((picture.clone(), next));
                next += picture.bank_words();
            }
        }
        all
    }

    /// Texels that they take.
    fn texels(&self) -> usize {
        4 * self.0.iter().map(|(p, _)| p.bank_words()).sum::<usize>()
    }

    fn place(&self, picture: &Arc<Picture>) -> Option<usize> {
        let same = |(p, _): &&(Arc<Picture>, usize)| Arc::ptr_eq(p, picture) || p == picture;
        self.0.iter().find(same).map(|(_, base)| *base)
    }

    /// Every texel, in order.
    pub(super) fn writes(&self, t: Texturing) -> Result<Vec<(u8, u64)>, String> {
        let (needed, there) = (self.texels(), t.texels());
        if needed > there {
            return Err(format!(
                "the pictures take {needed} texels and the texture memory has {there}"
            ));
        }
        let mut out = vec![(select::WRITE_PLACE, 0)];
        for (p, _) in &self.0 {
            p.check()?;
            let columns = p.width.div_ceil(2);
            for pair in 0..p.bank_words() {
                for bank in 0..4 {
                    let x = 2 * (pair % columns) + bank % 2;
                    let y = 2 * (pair / columns) + bank / 2;
                    let [r, g, b] = p.at(x, y).map(u64::from);
                    out.push((select::TEXEL, r << 16 | g << 8 | b));
                }
            }
        }
        Ok(out)
    }
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
            self.words(mask, words, writes);
        }
        if let Some(w) = address.w {
            self.words(select::W, &w, writes);
        }
        Ok(())
    }

    fn words(&mut self, mask: u8, words: &[u64], writes: &mut Vec<(u8, u64)>) {
        for (word, data) in (0u8..).zip(words) {
            if self.needed(mask | word, *data) {
                writes.push((mask | word, *data));
            }
        }
    }
}
