//! What a core with a set-up engine takes: corners, depths and knots, rounded once.

use super::Triangle;
use crate::setup::shell_words;
use shadegate_hdl::format::quantise;
use shadegate_hdl::set_up::{DEPTH_KNOT_FRACTION_BITS, KNOT_FRACTION_BITS, RAW_BITS};
use shadegate_reference::raster::{Viewport, Walk};

/// Register of the frame's rows; that of its columns is the shell's.
pub const FRAME_ROWS: u8 = 12;

/// The writes of a triangle, all of them: the engine has two sets of registers, so that the one before is not there.
///
/// # Errors
/// What the core's coordinates and formats do not hold.
pub(super) fn raw_words(
    t: &Triangle,
    walk: &Walk,
    viewport: Viewport,
) -> Result<Vec<(u8, u64)>, String> {
    // The limits are those of the words that the engine makes.
    shell_words(t.position, walk, viewport.width)?;
    let bus = |code: i64| code as u64 & ((1 << RAW_BITS) - 1);
    let mut writes = vec![];
    for (i, p) in (0u8..).zip(t.position) {
        writes.extend([(i, bus(i64::from(p.x))), (4 | i, bus(i64::from(p.y)))]);
    }
    if t.knots.len() != 6 {
        let n = t.knots.len();
        return Err(format!("{n} colour knots where the core takes 6"));
    }
    // Mid-edges 01, 02, 12 are numbered by the vertex opposite.
    for (word, knot) in [0u8, 1, 2, 6, 5, 4].into_iter().zip(&t.knots) {
        for (channel, value) in (0u8..).zip(knot) {
            let code = quantise(*value, 13, KNOT_FRACTION_BITS)
                .filter(|_| (0.0..=1530.0).contains(value))
                .ok_or_else(|| format!("colour knot {value} is outside 0 to 1530"))?;
            writes.push((16 << channel | word, bus(code)));
        }
    }
    for (i, d) in (0u8..).zip(t.depth) {
        let code = quantise(d, 17, DEPTH_KNOT_FRACTION_BITS)
            .filter(|_| (0.0..=65535.0).contains(&d))
            .ok_or_else(|| format!("depth {d} is outside 0 to 65535"))?;
        writes.push((0x80 | i, bus(code)));
    }
    Ok(writes)
}
