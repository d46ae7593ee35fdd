//! A frame of bytes and how it is kept as PNG.

use std::path::Path;

/// An image of 8-bit RGB.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// RGB, row by row from the top.
    pub pixels: Vec<[u8; 3]>,
}

/// Why a frame could not be kept or read.
#[derive(Debug, thiserror::Error)]
#[error("{file}: {why}")]
pub struct FrameError {
    /// The image file.
    pub file: String,
    /// The reason, one line.
    pub why: String,
}

impl FrameError {
    fn new(path: &Path, why: impl std::fmt::Display) -> Self {
        Self {
            file: path.display().to_string(),
            why: why
                .to_string()
                .split_whitespace()
                .collect::<Vec<_>>()
                .join(" "),
        }
    }
}

impl Frame {
    /// A frame of one colour.
    #[must_use]
    pub fn new(width: u32, height: u32, colour: [u8; 3]) -> Self {
        Self {
            width,
            height,
            pixels: vec![colour; width as usize * height as usize],
        }
    }

    /// Writes a PNG to a temporary file beside `path` and renames it, so that no reader ever sees half a picture.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn save_png(&self, path: &Path) -> Result<(), FrameError> {
        let name = path
            .file_name()
            .ok_or_else(|| FrameError::new(path, "not a file name"))?;
        let beside = path.with_file_name(format!(
            ".{}.{}.part",
            name.to_string_lossy(),
            std::process::id()
        ));
        let written = image::save_buffer_with_format(
            &beside,
            self.pixels.as_flattened(),
            self.width,
            self.height,
            image::ExtendedColorType::Rgb8,
            image::ImageFormat::Png,
        )
        .map_err(|e| FrameError::new(path, e))
        .and_then(|()| std::fs::rename(&beside, path).map_err(|e| FrameError::new(path, e)));
        if written.is_err() {
            // Nothing more can be done about a temporary that will not go.
            let _ = std::fs::remove_file(&beside);
        }
        written
    }

    /// Reads a PNG.
    ///
    /// # Errors
    /// When the file cannot be read or is not a PNG.
    pub fn load_png(path: &Path) -> Result<Self, FrameError> {
        let bytes = std::fs::read(path).map_err(|e| FrameError::new(path, e))?;
        let rgb = image::load_from_memory_with_format(&bytes, image::ImageFormat::Png)
            .map_err(|e| FrameError::new(path, e))?
            .into_rgb8();
        Ok(Self {
            width: rgb.width(),
            height: rgb.height(),
            pixels: rgb.pixels().map(|p| p.0).collect(),
        })
    }
}
