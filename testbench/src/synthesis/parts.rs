//! The parts that are routed, and which of them a design needs.

use super::{Design, Resources, Router, SynthesisError};

/// A part that can be routed.
pub(super) struct Part {
    /// Name, with package.
    pub name: &'static str,
    /// Options of nextpnr.
    pub options: &'static [&'static str],
    /// Look-up tables of four inputs.
    luts: u64,
    block_rams: u64,
}

/// ECP5, smallest first; speed grade 6, the slowest.
const ECP5: [Part; 3] = [
    Part {
        name: "LFE5U-25F-6BG381",
        options: &["--25k", "--package", "CABGA381", "--speed", "6"],
        luts: 24_288,
        block_rams: 56,
    },
    Part {
        name: "LFE5U-45F-6BG381",
        options: &["--45k", "--package", "CABGA381", "--speed", "6"],
        luts: 43_848,
        block_rams: 108,
    },
    Part {
        name: "LFE5U-85F-6BG381",
        options: &["--85k", "--package", "CABGA381", "--speed", "6"],
        luts: 83_640,
        block_rams: 208,
    },
];
/// iCE40: smaller ones have too few pins for a core.
const ICE40: [Part; 1] = [Part {
    name: "iCE40HX8K-CT256",
    options: &["--hx8k", "--package", "ct256"],
    luts: 7_680,
    block_rams: 32,
}];

/// The smallest part that holds a design.
pub(super) fn smallest(
    router: Router,
    design: &Design,
    r: &Resources,
) -> Result<&'static Part, SynthesisError> {
    // A carry cell of ECP5 is made of two look-up tables; one of iCE40 sits beside its own.
    let luts = match router {
        Router::Ecp5 => r.lut + 2 * r.carry,
        Router::Ice40 => r.lut.max(r.ff),
    };
    let holds = |p: &&Part| r.bram <= p.block_rams && luts <= p.luts;
    let parts: &[Part] = match router {
        Router::Ecp5 => &ECP5,
        Router::Ice40 => &ICE40,
    };
    parts.iter().find(holds).ok_or_else(|| {
        let largest = &parts[parts.len() - 1];
        SynthesisError::TooLarge(format!(
            "{} needs {luts} look-up tables and {} block RAMs; the largest part that can be routed, {}, has {} \
             and {}; draw a smaller frame with --size",
            design.top, r.bram, largest.name, largest.luts, largest.block_rams
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_part_that_holds_it() {
        let design = Design {
            top: "core".into(),
            files: vec![],
        };
        let r = |lut, ff, carry, bram| Resources {
            lut,
            ff,
            carry,
            bram,
            ..Resources::default()
        };
        let ecp5 = |r: Resources| smallest(Router::Ecp5, &design, &r).map(|p| p.name);
        assert_eq!(ecp5(r(900, 1900, 300, 1)).unwrap(), "LFE5U-25F-6BG381");
        assert_eq!(ecp5(r(900, 1900, 300, 75)).unwrap(), "LFE5U-45F-6BG381");
        assert_eq!(ecp5(r(20_000, 0, 12_000, 1)).unwrap(), "LFE5U-85F-6BG381");
        let e = smallest(Router::Ice40, &design, &r(1500, 1900, 600, 300));
        assert_eq!(
            e.err().unwrap().to_string(),
            "core needs 1900 look-up tables and 300 block RAMs; the largest part that can be routed, iCE40HX8K-CT256, \
             has 7680 and 32; draw a smaller frame with --size"
        );
    }
}
