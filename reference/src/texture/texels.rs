//! A picture as texels: read from a PNG file or computed, and looked up one by one.

use std::path::Path;

/// Greatest width and height of a texture or height map, in texels.
pub const SIDE_LIMIT: u32 = 4096;

/// Rows of texels, from the bottom, so that v grows with the row.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    width: usize,
    height: usize,
    rgb: Vec<[f32; 3]>,
}

/// Why a picture cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}; {accepted}")]
pub struct TexelsError {
    /// What is wrong.
    pub what: String,
    /// What would be accepted.
    pub accepted: String,
}

impl TexelsError {
    fn new(what: impl Into<String>) -> Self {
        Self {
            what: what.into(),
            accepted: format!("expected a PNG file of 1x1 to {SIDE_LIMIT}x{SIDE_LIMIT} texels"),
        }
    }
}

impl Texels {
    /// Computes every texel: column, row from the bottom. A side of zero is taken as one.
    #[must_use]
    pub fn from_fn(
        width: usize,
        height: usize,
        mut texel: impl FnMut(usize, usize) -> [f32; 3],
    ) -> Self {
        let (width, height) = (width.max(1), height.max(1));
        let rgb = (0..width * height)
            .map(|i| texel(i % width, i / width))
            .collect();
        Self { width, height, rgb }
    }

    /// Reads a PNG of 8 or 16 bits, grey or RGB; transparency is not used. Values are taken as they are (full scale is
    /// 1), as the rest of the program takes bytes.
    ///
    /// # Errors
    /// When the file cannot be read, is not a PNG or is too large.
    pub fn load_png(path: &Path) -> Result<Self, TexelsError> {
        let bytes =
            std::fs::read(path).map_err(|e| TexelsError::new(format!("cannot be read ({e})")))?;
        Self::from_png(&bytes)
    }

    fn from_png(bytes: &[u8]) -> Result<Self, TexelsError> {
        let unreadable = |e: image::ImageError| TexelsError::new(format!("not readable ({e})"));
        let reader = || {
            image::ImageReader::with_format(std::io::Cursor::new(bytes), image::ImageFormat::Png)
        };
        // The size is looked at before memory is taken for the texels.
        let (width, height) = reader().into_dimensions().map_err(unreadable)?;
        if width > SIDE_LIMIT || height > SIDE_LIMIT {
            return Err(TexelsError::new(format!("{width}x{height} texels")));
        }
        let picture = reader().decode().map_err(unreadable)?.into_rgb32f();
        Ok(Self::from_fn(width as usize, height as usize, |x, y| {
            picture.get_pixel(x as u32, height - 1 - y as u32).0
        }))
    }

    /// Columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// RGB of a texel, fractions of full scale. Indices beyond the last column or row count as the last.
    #[must_use]
    pub fn at(&self, x: usize, y: usize) -> [f64; 3] {
        let (x, y) = (x.min(self.width - 1), y.min(self.height - 1));
        self.rgb[y * self.width + x].map(f64::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn png(width: u32, height: u32) -> Vec<u8> {
        let mut out = std::io::Cursor::new(Vec::new());
        image::RgbImage::from_fn(width, height, |x, y| image::Rgb([x as u8, y as u8, 255]))
            .write_to(&mut out, image::ImageFormat::Png)
            .unwrap();
        out.into_inner()
    }

    #[test]
    fn rows_count_from_the_bottom() {
        let t = Texels::from_png(&png(5, 3)).unwrap();
        assert_eq!((t.width(), t.height()), (5, 3));
        for (x, y) in [(0, 0), (4, 2), (3, 1)] {
            let want = [x as f64 / 255.0, (2 - y) as f64 / 255.0, 1.0];
            for (got, want) in t.at(x, y).into_iter().zip(want) {
                assert!((got - want).abs() < 3e-8);
            }
        }
    }

    #[test]
    fn what_cannot_be_used_is_refused() {
        let good = png(4, 4);
        assert_eq!(
            Texels::from_png(&png(SIDE_LIMIT + 1, 1))
                .unwrap_err()
                .to_string(),
            "4097x1 texels; expected a PNG file of 1x1 to 4096x4096 texels"
        );
        assert!(Texels::from_png(&png(SIDE_LIMIT, 1)).is_ok());
        for cut in 0..good.len() - 12 {
            let e = Texels::from_png(&good[..cut]).unwrap_err().to_string();
            assert!(e.starts_with("not readable ("), "{e}");
        }
        let mut seed = 1u32;
        for _ in 0..3000 {
            let mut bad = good.clone();
            for _ in 0..3 {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let at = (seed >> 8) as usize % bad.len();
                bad[at] = (seed >> 3) as u8;
            }
            // Read or refused, but never a panic.
            let _ = Texels::from_png(&bad);
        }
    }
}
