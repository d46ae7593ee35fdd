//! Register words of the raster shell from the integer edge walk.

use super::rational::residue;
use shadegate_reference::raster::{EdgeDda, Point, Walk, SUBPIXELS};

/// Leftmost column a vertex may have: the walk column is signed, 12 bits.
pub const MIN_COLUMN: i32 = -2047;
/// Rightmost column a vertex may have.
pub const MAX_COLUMN: i32 = 2046;
/// Largest height of an edge in sub-pixels: the error term has 20 bits.
const MAX_EDGE: i64 = 1 << 19;

fn edge_words(e: &EdgeDda) -> [u64; 3] {
    let pack =
        |high: i32, low: i32| residue(i128::from(high), 12) << 20 | residue(i128::from(low), 20);
    [
        pack(e.column, e.error),
        pack(e.whole, e.up),
        residue(i128::from(e.down), 20),
    ]
}

/// The eleven words of the shell; `width` is the frame's. `Err` says which limit of the core the triangle exceeds.
///
/// # Errors
/// A vertex outside columns −2047..=2046 or an edge higher than 2048 rows.
pub fn shell_words(position: [Point; 3], walk: &Walk, width: u32) -> Result<[u64; 11], String> {
    for p in position {
        let (low, high) = (MIN_COLUMN * SUBPIXELS, MAX_COLUMN * SUBPIXELS);
        if p.x < low || p.x > high {
            return Err(format!(
                "column {:.2} is outside the core's walk columns {MIN_COLUMN} to {MAX_COLUMN}",
                p.pixels().0
            ));
        }
    }
    let top = position.iter().map(|p| i64::from(p.y)).min().unwrap_or(0);
    let bottom = position.iter().map(|p| i64::from(p.y)).max().unwrap_or(0);
    if bottom - top > MAX_EDGE {
        return Err(format!(
            "{} rows high; the core's edges have at most 2048",
            (bottom - top) / i64::from(SUBPIXELS)
        ));
    }
    let row = walk.first_row as u64;
    let rows = u64::from(walk.rows);
    let upper = u64::from(walk.upper_rows);
    let mut words = [0; 11];
    words[0] = u64::from(walk.mirrored) << 22 | upper << 11 | rows;
    words[1] = (row * u64::from(width)) << 11 | row;
    // Without an upper part the lower edge is the one to begin with.
    let first = usize::from(upper == 0);
    words[2..5].copy_from_slice(&edge_words(&walk.major));
    words[5..8].copy_from_slice(&edge_words(&walk.minor[first]));
    words[8..11].copy_from_slice(&edge_words(&walk.minor[1]));
    Ok(words)
}
