//! Register words of a span: rounding to nearest, residues where registers hold them.

/// The words of both terms of one span: diffuse, highlight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Terms {
    /// Its first pixel, counted from the begin of the row's span.
    pub first: u32,
    /// Its pixels.
    pub pixels: u32,
    /// Words of the diffuse term.
    pub diffuse: [u64; 3],
    /// Words of the highlight.
    pub highlight: [u64; 3],
}

/// The code of `value` with this many fraction bits, as 32 bits of a register that holds residues.
pub fn residue(value: f64, fraction_bits: u32) -> u64 {
    (value * 2f64.powi(fraction_bits as i32)).round() as i64 as u64 & 0xffff_ffff
}

/// The code of a signed word of `bits` bits in all.
///
/// # Errors
/// Values that do not fit, with their name.
pub fn signed(what: &str, value: f64, fraction_bits: u32, bits: u32) -> Result<u64, String> {
    let code = (value * 2f64.powi(fraction_bits as i32)).round();
    let limit = 2f64.powi(bits as i32 - 1);
    if (-limit..limit).contains(&code) {
        Ok(code as i64 as u64 & ((1 << bits) - 1))
    } else {
        Err(format!(
            "{what} {value} does not fit {bits} bits with {fraction_bits} of fraction"
        ))
    }
}
