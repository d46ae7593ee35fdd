//! The numbers: differing pixels, largest and root-mean-square error, PSNR, FLIP, histogram.

use super::{same_size, CompareError, Rgb8Ref};
use nv_flip::{flip, FlipImageRgb8};
use serde::{Serialize, Serializer};

/// Pixels to a degree of the viewer's field for FLIP: the measure's own default of 67, which is a
/// 3840-pixel screen of 0.7 m width seen from 0.7 m.
pub const FLIP_PIXELS_PER_DEGREE: f32 = nv_flip::DEFAULT_PIXELS_PER_DEGREE;

/// The first pixel, in reading order, that is not the same in both frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct PixelMismatch {
    /// Column, from the left.
    pub x: u32,
    /// Row, from the top.
    pub y: u32,
    /// Colour in the first frame.
    pub a: [u8; 3],
    /// Colour in the second frame.
    pub b: [u8; 3],
}

/// How far two frames are apart. One LSB is one step of an 8-bit channel.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// Pixels compared.
    pub pixels: u64,
    /// Pixels of which at least one channel differs.
    pub differing: u64,
    /// Largest difference of a channel.
    pub max_lsb: u8,
    /// Root of the mean square difference over all channels of all pixels.
    pub rms_lsb: f64,
    /// Peak signal-to-noise ratio, 20 log10(255 / rms); infinite for equal frames, which JSON
    /// writes as null.
    #[serde(serialize_with = "null_if_infinite")]
    pub psnr_db: f64,
    /// Mean of the FLIP error map (0: no visible difference, 1: the largest), at
    /// [`FLIP_PIXELS_PER_DEGREE`].
    pub flip_mean: f64,
    /// The first pixel that differs.
    pub first_mismatch: Option<PixelMismatch>,
    /// How many channels differ by 0, 1, ... `max_lsb`; they add up to three times `pixels`.
    pub histogram: Vec<u64>,
}

impl Comparison {
    /// Whether the frames are the same, byte for byte.
    pub fn equal(&self) -> bool {
        self.differing == 0
    }
}

fn null_if_infinite<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    Some(value).filter(|v| v.is_finite()).serialize(serializer)
}

/// Compares frame `b` with the reference `a`.
pub fn compare(a: Rgb8Ref, b: Rgb8Ref) -> Result<Comparison, CompareError> {
    same_size(a, b)?;
    let mut counts = [0u64; 256];
    let mut differing = 0;
    let mut first = None;
    for (index, (pa, pb)) in a.pixels().iter().zip(b.pixels()).enumerate() {
        for (ca, cb) in pa.iter().zip(pb) {
            counts[usize::from(ca.abs_diff(*cb))] += 1;
        }
        if pa != pb {
            differing += 1;
            first = first.or(Some(index));
        }
    }
    let max_lsb = (0..=u8::MAX)
        .rev()
        .find(|&d| counts[usize::from(d)] > 0)
        .unwrap_or(0);
    // Exact: at most 3 * 2^30 channels of at most 255^2 each.
    let squares: u64 = (0u64..).zip(&counts).map(|(d, count)| d * d * count).sum();
    let pixels = a.pixels().len() as u64;
    let rms_lsb = (squares as f64 / (3 * pixels) as f64).sqrt();
    Ok(Comparison {
        pixels,
        differing,
        max_lsb,
        rms_lsb,
        psnr_db: 20.0 * (255.0 / rms_lsb).log10(),
        flip_mean: if differing == 0 { 0.0 } else { flip_mean(a, b) },
        first_mismatch: first.map(|index| mismatch(a, b, index)),
        histogram: counts[..=usize::from(max_lsb)].to_vec(),
    })
}

fn mismatch(a: Rgb8Ref, b: Rgb8Ref, index: usize) -> PixelMismatch {
    // In range: `Rgb8Ref` holds at most 2^30 pixels.
    let (row, column) = (index as u32 / a.width(), index as u32 % a.width());
    PixelMismatch {
        x: column,
        y: row,
        a: a.pixels()[index],
        b: b.pixels()[index],
    }
}

/// The mean is taken here in f64, since the library's own adds in f32.
fn flip_mean(a: Rgb8Ref, b: Rgb8Ref) -> f64 {
    let image =
        |f: Rgb8Ref| FlipImageRgb8::with_data(f.width(), f.height(), f.pixels().as_flattened());
    let map = flip(image(a), image(b), FLIP_PIXELS_PER_DEGREE).to_vec();
    map.iter().map(|&e| f64::from(e)).sum::<f64>() / map.len() as f64
}
