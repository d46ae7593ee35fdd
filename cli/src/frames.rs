//! Frames of animated scenes: which one is meant, and what its file is called.

use crate::outcome::Failure;
use std::path::{Path, PathBuf};

/// The frame that was typed, of `count`.
///
/// # Errors
/// What is not the number of a frame.
pub fn number(text: &str, count: u32) -> Result<u32, Failure> {
    let digits = text.bytes().all(|b| b.is_ascii_digit());
    let k = text.parse().ok().filter(|k| digits && *k < count);
    k.ok_or_else(|| {
        let expected = match count {
            1 => "the scene has only frame 0".to_owned(),
            n => format!("expected a number from 0 to {}", n - 1),
        };
        Failure::input(format!("frame '{text}' cannot be drawn; {expected}"))
    })
}

/// The file of a frame: its number before the ending, with four digits or more, so that names sort as frames do.
#[must_use]
pub fn file(base: &Path, number: u32) -> PathBuf {
    let stem = base.file_stem().unwrap_or_default().to_string_lossy();
    let ending = base.extension().unwrap_or_default().to_string_lossy();
    base.with_file_name(format!("{stem}-{number:04}.{ending}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers() {
        assert_eq!(number("0", 1).unwrap(), 0);
        assert_eq!(number("47", 48).unwrap(), 47);
        for (text, count, expected) in [
            ("1", 1, "the scene has only frame 0"),
            ("48", 48, "expected a number from 0 to 47"),
            ("-1", 48, "expected a number from 0 to 47"),
            ("+1", 48, "expected a number from 0 to 47"),
            ("", 48, "expected a number from 0 to 47"),
            ("x", 48, "expected a number from 0 to 47"),
        ] {
            assert_eq!(
                number(text, count).unwrap_err().message,
                format!("frame '{text}' cannot be drawn; {expected}")
            );
        }
    }

    #[test]
    fn files() {
        let at = |k| file(Path::new("out/spin.x.png"), k);
        assert_eq!(at(7), Path::new("out/spin.x-0007.png"));
        assert_eq!(at(12345), Path::new("out/spin.x-12345.png"));
    }
}
