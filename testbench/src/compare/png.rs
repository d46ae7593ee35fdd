//! Frames from PNG files and into them.

use super::{CompareError, Rgb8Image, Rgb8Ref};
use image::codecs::png::{PngDecoder, PngEncoder};
use image::{DynamicImage, ExtendedColorType, ImageEncoder};
use std::fs::File;
use std::io::{BufReader, BufWriter, Cursor, Read, Write};
use std::path::Path;

const SIGNATURE: [u8; 8] = *b"\x89PNG\r\n\x1a\n";

/// Reads any PNG as 8-bit RGB: grey is spread over the three channels, 16 bits are rounded to 8,
/// and an alpha channel is dropped without blending.
pub fn load_png(path: &Path) -> Result<Rgb8Image, CompareError> {
    let unreadable = |source| CompareError::Read {
        path: path.to_owned(),
        source,
    };
    let mut reader = BufReader::new(File::open(path).map_err(unreadable)?);
    let mut start = Vec::new();
    let wanted = SIGNATURE.len() as u64;
    (&mut reader)
        .take(wanted)
        .read_to_end(&mut start)
        .map_err(unreadable)?;
    if start != SIGNATURE {
        return Err(CompareError::NotPng {
            path: path.to_owned(),
        });
    }
    // The rest is read whole, so that a fault of the disk is not taken for one of the image.
    reader.read_to_end(&mut start).map_err(unreadable)?;
    let damaged = |e: image::ImageError| CompareError::BadPng {
        path: path.to_owned(),
        why: one_line(&e.to_string()),
    };
    let mut limits = image::Limits::default();
    limits.max_image_width = Some(1 << 20);
    limits.max_image_height = Some(1 << 20);
    let decoder = PngDecoder::with_limits(Cursor::new(start), limits).map_err(damaged)?;
    let image = DynamicImage::from_decoder(decoder)
        .map_err(damaged)?
        .into_rgb8();
    let (width, height) = image.dimensions();
    let pixels = image.pixels().map(|p| p.0).collect();
    Rgb8Image::new(width, height, pixels)
}

/// Writes a frame as an 8-bit RGB PNG, whole or not at all: into a new file beside `path`, which
/// then takes its name.
pub fn save_png(path: &Path, frame: Rgb8Ref) -> Result<(), CompareError> {
    let unwritable = |e: String| CompareError::Write {
        path: path.to_owned(),
        why: one_line(&e),
    };
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".shadegate-").suffix(".png");
    // A temporary file is its owner's alone; this one is to be a file like any other.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder
        .tempfile_in(directory)
        .map_err(|e| unwritable(reason(&e)))?;
    let mut writer = BufWriter::new(file);
    PngEncoder::new(&mut writer)
        .write_image(
            frame.pixels().as_flattened(),
            frame.width(),
            frame.height(),
            ExtendedColorType::Rgb8,
        )
        .map_err(|e| unwritable(e.to_string()))?;
    writer.flush().map_err(|e| unwritable(reason(&e)))?;
    let file = writer
        .into_inner()
        .map_err(|e| unwritable(reason(e.error())))?;
    file.persist(path)
        .map(|_| ())
        .map_err(|e| unwritable(reason(&e.error)))
}

/// The system's reason, without the temporary file's name, which would be another every time.
fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "its directory does not exist".to_owned(),
        kind => kind.to_string(),
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
