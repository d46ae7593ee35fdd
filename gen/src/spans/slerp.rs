//! Words of the slerp cores, from the span stage of the methods `slerp` and `slerp-chebyshev`.

use super::words::{residue, Terms};
use shadegate_hdl::lit::chebyshev::TWICE_FRACTION_BITS;
use shadegate_hdl::lit::swing::{
    EXPONENT_STEP, KAPPA_FRACTION_BITS, MANTISSA_BITS, WORD_FRACTION_BITS,
};
use shadegate_reference::shade::slerp::{Chebyshevs, Differences, Start};
use shadegate_reference::shade::sweep::Sweep;

const FRACTION: u32 = WORD_FRACTION_BITS as u32;

/// κ as the word that the core takes, and the value of that word.
fn kappa(exact: f64) -> (u64, f64) {
    let scale = |e: usize| 2f64.powi((KAPPA_FRACTION_BITS + EXPONENT_STEP * e) as i32);
    let largest = (1u64 << MANTISSA_BITS) - 1;
    let fits = |e: &usize| (exact * scale(*e)).round() <= largest as f64;
    // κ = 4 itself is one unit too much.
    let e = (0..4).rev().find(fits).unwrap_or(0);
    let mantissa = ((exact * scale(e)).round() as u64).min(largest);
    ((e as u64) << 25 | mantissa, mantissa as f64 / scale(e))
}

/// Value, change and κ of a sweep over `pixels` pixels. The change is that with which the rounded κ meets the last
/// pixel, so that its rounding bends the span and does not tilt it.
fn differences(s: &Sweep, pixels: u32) -> [u64; 3] {
    let exact = Differences::start(s);
    let (word, rounded) = kappa(exact.kappa);
    let steps = f64::from(pixels.max(2) - 1);
    let step = 2.0 * (rounded.sqrt() / 2.0).min(1.0).asin();
    let turned = steps * step;
    let change = if pixels < 2 {
        0.0
    } else if turned > 1e-6 && turned.sin() > 1e-3 {
        let across = (s.to - exact.value * turned.cos()) / turned.sin();
        exact.value * (1.0 - step.cos()) + across * step.sin()
    } else if rounded == 0.0 {
        (s.to - exact.value) / steps
    } else {
        exact.change
    };
    [
        residue(exact.value, FRACTION),
        residue(change, FRACTION),
        word,
    ]
}

/// The words of both terms; a term that is missing is dark.
pub fn terms(sweeps: [Option<&Sweep>; 2], pixels: u32) -> Terms {
    let [diffuse, highlight] = sweeps.map(|s| s.map_or([0; 3], |s| differences(s, pixels)));
    Terms {
        first: 0,
        pixels,
        diffuse,
        highlight,
    }
}

/// The same for Chebyshev's recurrence.
pub fn chebyshev_terms(sweeps: [Option<&Sweep>; 2], pixels: u32) -> Terms {
    let words = |s: &Sweep| {
        let c = Chebyshevs::start(s);
        let twice = residue(c.twice, TWICE_FRACTION_BITS as u32) & 0x1ff_ffff;
        [
            residue(c.current, FRACTION),
            residue(c.previous, FRACTION),
            twice,
        ]
    };
    let [diffuse, highlight] = sweeps.map(|s| s.map_or([0; 3], words));
    Terms {
        first: 0,
        pixels,
        diffuse,
        highlight,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kappa_keeps_sixteen_bits_or_the_last_of_the_smallest() {
        for i in 0..4000 {
            let exact = 4.0 * 0.985f64.powi(i);
            let (word, rounded) = kappa(exact);
            assert!(word < 1 << 27 && word & 1 << 24 == 0, "{exact} {word:x}");
            let error = (rounded - exact).abs();
            let allowed = (exact * 2f64.powi(-16)).max(2f64.powi(-47));
            assert!(error <= allowed, "{exact}: {error}");
        }
        assert_eq!(kappa(0.0), (3 << 25, 0.0));
    }
}
