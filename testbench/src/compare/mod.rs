//! Compares two frames pixel by pixel: how many differ, by how much, and where first.
//!
//! Frames are 8-bit RGB, row by row from the top left. The first of the two is the reference: it
//! matters to FLIP and to nothing else.

mod difference;
mod error;
mod metrics;
mod png;
#[cfg(test)]
mod tests;

pub use difference::difference_image;
pub use error::CompareError;
pub use metrics::{compare, Comparison, PixelMismatch, FLIP_PIXELS_PER_DEGREE};
pub use png::{load_png, save_png};

/// More pixels than this are refused, so that three bytes each still count in 32 bits.
pub const MAX_PIXELS: u64 = 1 << 30;

/// A frame lent by its owner.
#[derive(Clone, Copy, Debug)]
pub struct Rgb8Ref<'a> {
    width: u32,
    height: u32,
    pixels: &'a [[u8; 3]],
}

impl<'a> Rgb8Ref<'a> {
    /// A frame of `width` times `height` pixels, or an error if there are more or fewer, none at
    /// all, or beyond [`MAX_PIXELS`].
    pub fn new(width: u32, height: u32, pixels: &'a [[u8; 3]]) -> Result<Self, CompareError> {
        let wanted = u64::from(width) * u64::from(height);
        if wanted == 0 || wanted > MAX_PIXELS {
            return Err(CompareError::BadSize { width, height });
        }
        if wanted != pixels.len() as u64 {
            return Err(CompareError::WrongLength {
                width,
                height,
                pixels: pixels.len(),
            });
        }
        Ok(Rgb8Ref {
            width,
            height,
            pixels,
        })
    }

    /// Pixels in a row.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All pixels, row by row from the top.
    pub fn pixels(&self) -> &'a [[u8; 3]] {
        self.pixels
    }
}

/// A frame of one's own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rgb8Image {
    width: u32,
    height: u32,
    pixels: Vec<[u8; 3]>,
}

impl Rgb8Image {
    /// A frame of `width` times `height` pixels, with the refusals of [`Rgb8Ref::new`].
    pub fn new(width: u32, height: u32, pixels: Vec<[u8; 3]>) -> Result<Self, CompareError> {
        Rgb8Ref::new(width, height, &pixels)?;
        Ok(Rgb8Image {
            width,
            height,
            pixels,
        })
    }

    /// Lends it.
    pub fn view(&self) -> Rgb8Ref<'_> {
        Rgb8Ref {
            width: self.width,
            height: self.height,
            pixels: &self.pixels,
        }
    }

    /// Its pixels, row by row from the top.
    pub fn into_pixels(self) -> Vec<[u8; 3]> {
        self.pixels
    }
}

/// Refuses frames of two sizes.
fn same_size(a: Rgb8Ref, b: Rgb8Ref) -> Result<(), CompareError> {
    if (a.width, a.height) == (b.width, b.height) {
        return Ok(());
    }
    Err(CompareError::SizesDiffer {
        a: (a.width, a.height),
        b: (b.width, b.height),
    })
}
