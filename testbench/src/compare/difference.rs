//! A picture of where two frames differ.

use super::{same_size, CompareError, Rgb8Ref};

/// The absolute difference of each channel, made visible.
///
/// Equal channels are black. A difference of d LSB shows as 63 + 16 d, so that one LSB (79) can
/// be seen on a screen, and 12 LSB or more are full brightness.
pub fn difference_image(a: Rgb8Ref, b: Rgb8Ref) -> Result<Vec<[u8; 3]>, CompareError> {
    same_size(a, b)?;
    let pairs = a.pixels().iter().zip(b.pixels());
    Ok(pairs
        .map(|(pa, pb)| std::array::from_fn(|c| shown(pa[c].abs_diff(pb[c]))))
        .collect())
}

fn shown(difference: u8) -> u8 {
    match difference {
        0 => 0,
        d => d.saturating_mul(16).saturating_add(63),
    }
}
