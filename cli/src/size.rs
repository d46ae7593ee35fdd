//! Frame sizes as typed: `320x240`.

use crate::outcome::Failure;
use shadegate_reference::scene::IMAGE_LIMIT;

/// Parses `WxH`.
///
/// # Errors
/// Anything else, and sizes that no renderer draws.
pub fn parse(text: &str) -> Result<(u32, u32), Failure> {
    let side = |s: &str| {
        s.parse()
            .ok()
            .filter(|n| s.bytes().all(|b| b.is_ascii_digit()) && (1..=IMAGE_LIMIT).contains(n))
    };
    text.split_once(['x', 'X'])
        .and_then(|(w, h)| Some((side(w)?, side(h)?)))
        .ok_or_else(|| {
            Failure::input(format!(
                "size '{text}' cannot be drawn; expected WxH from 1x1 to {IMAGE_LIMIT}x{IMAGE_LIMIT}"
            ))
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(parse("320x240").unwrap(), (320, 240));
        assert_eq!(parse("1X16384").unwrap(), (1, 16384));
        for bad in [
            "",
            "x",
            "0x5",
            "5x0",
            "5",
            "5x",
            "-1x5",
            "+1x5",
            "1x2x3",
            "16385x1",
            "1.5x2",
            "99999999999x1",
        ] {
            assert_eq!(
                parse(bad).unwrap_err().message,
                format!("size '{bad}' cannot be drawn; expected WxH from 1x1 to 16384x16384")
            );
        }
    }
}
