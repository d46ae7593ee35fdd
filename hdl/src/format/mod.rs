//! Number formats as signal types: [`Q`] is a signed fixed-point word, [`U`] an unsigned word, both on one machine word.
//!
//! They implement rust-hdl's `Synth`, so a signal's type *is* its format, and simulation runs on native integers
//! instead of bit vectors. `#[hdl_gen]` translates calls by name, so every conversion used inside a description starts
//! with a name it knows (`bit_cast`, `signed_cast`, `unsigned_cast`); what the conversion means follows from the two
//! types, and the Verilog back end reads those types from the descriptors.
//!
//! Sums and differences are taken modulo 2^width, as an adder does. That is deliberate: an accumulator may leave its
//! range on the way as long as the value that is *used* fits, since residues add exactly (see `shade::quadratic`).

mod cast;
mod product;
mod q;
mod u;

pub use cast::{bit_cast_u, signed_cast_align, signed_cast_bits, unsigned_cast_integer};
pub use product::{bit_cast_product, signed_cast_product, SignedProduct, UnsignedProduct};
pub use q::{quantise, Q};
pub use u::U;

use rust_hdl_core::prelude::{Bits, VCDValue, VerilogLiteral};

/// The low `width` bits set.
pub(crate) const fn mask(width: usize) -> u64 {
    if width >= 64 {
        !0
    } else {
        (1 << width) - 1
    }
}

/// `value` reduced to `width` bits and sign-extended: the residue that a register of that width holds.
#[must_use]
#[inline(always)]
pub const fn wrap(value: i64, width: usize) -> i64 {
    (value << (64 - width)) >> (64 - width)
}

/// rust-hdl's literal of a runtime width; its own types carry the width as a constant, hence the table.
fn literal(bits: u64, width: usize) -> VerilogLiteral {
    macro_rules! table {
        ($($w:literal)*) => {
            match width {
                $($w => Bits::<$w>::from(bits & mask($w)).into(),)*
                _ => unreachable!("formats have 1 to 64 bits"),
            }
        };
    }
    table!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32
           33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63 64)
}

/// The word as a waveform value, most significant bit first.
fn waveform(bits: u64, width: usize) -> VCDValue {
    let bit = |i: usize| {
        if bits >> i & 1 == 1 {
            vcd::Value::V1
        } else {
            vcd::Value::V0
        }
    };
    if width == 1 {
        VCDValue::Single(bit(0))
    } else {
        VCDValue::Vector((0..width).rev().map(bit).collect())
    }
}
