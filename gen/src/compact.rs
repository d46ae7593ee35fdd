//! The compact unit's Verilog, and its words from those of the quadratic core.

use crate::netlist::{collect, elaborate, undocumented};
use crate::package::{PackageError, GENERATOR};
use crate::stimulus::Primitive;
use crate::verilog::check::check;
use crate::verilog::{emit, VerilogFile};
use shadegate_hdl::compact::channel_words;
use shadegate_hdl::compact::unit::CompactUnit;
use shadegate_hdl::simulate::{Clocked, Simulator};

/// The six words of the walk beside its edges, and three times six: what a triangle needs, in the order of writing.
///
/// The triangle's words are those of the quadratic core, all of them (nothing left out or sent together). `dropped` is the
/// number of fraction bits that a difference has and the value has not: half a step of the value is added to both first
/// differences, so that what the value drops is rounded.
#[must_use]
pub fn words(triangle: &Primitive, dropped: u32) -> Vec<(u8, u32)> {
    let word = |select: u8| {
        let of = triangle.writes.iter().find(|(s, _)| *s == select);
        of.map_or(0, |(_, data)| *data)
    };
    // A step of an edge as one word: columns, and the error's step; with carry one column more.
    let edge = |first: u8| {
        let (start, steps, down) = (word(first), word(first + 1), word(first + 2));
        let carrying = (steps + (1 << 20)) & 0xfff0_0000 | down & 0xf_ffff;
        [start, steps, carrying].map(|w| w as u32)
    };
    let [major, upper, lower] = [2, 5, 8].map(edge);
    let (rows, upper_rows, mirrored) = (word(0) & 0x7ff, word(0) >> 11 & 0x7ff, word(0) >> 22 & 1);
    // A triangle of one part has it in the upper edge.
    let upper_rows = match upper_rows {
        0 => rows,
        part => part.min(rows),
    };
    let first_row = word(1) & 0x7ff;
    let row = |n: u64| (first_row + n) & 0x7ff;
    let has_lower = u64::from(rows > upper_rows);
    let shape = has_lower << 23 | mirrored << 22 | row(rows) << 11 | row(upper_rows);
    let mut out = vec![
        (7, major[0]),
        (0, major[1]),
        (1, major[2]),
        (15, upper[0]),
        (2, upper[1]),
        (3, upper[2]),
        (6, lower[0]),
        (4, lower[1]),
        (5, lower[2]),
        (8, shape as u32),
        (9, first_row as u32),
    ];
    for mask in [16, 32, 64] {
        let quadric = std::array::from_fn(|i| word(mask | i as u8));
        for (i, data) in channel_words(quadric).into_iter().enumerate() {
            let half = if matches!(i, 1 | 2) {
                (1 << dropped) >> 1
            } else {
                0
            };
            out.push((mask | i as u8, (data as u32).wrapping_add(half)));
        }
    }
    out
}

/// The Verilog of a description, checked as that of a core is.
///
/// # Errors
/// See [`PackageError`].
pub fn rtl<B: Clocked>(design: B) -> Result<Vec<VerilogFile>, PackageError> {
    let simulator = Simulator::new(design).map_err(PackageError::Description)?;
    let top = collect(simulator.design.as_ref())?;
    if let Some(missing) = undocumented(&top) {
        return Err(missing.into());
    }
    elaborate(&top)?;
    let files = emit(&top, GENERATOR)?;
    for f in &files {
        check(&f.file_name(), &f.text)?;
    }
    Ok(files)
}

/// The Verilog of the compact unit with words of `D` bits.
///
/// # Errors
/// See [`PackageError`].
pub fn unit<const D: usize, const M: usize, const N: usize, const V: usize>(
) -> Result<Vec<VerilogFile>, PackageError> {
    rtl(CompactUnit::<D, M, N, V>::default())
}
