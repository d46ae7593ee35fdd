//! Words of the spherical core, from the span stage of the methods `spherical-cos2-rom` and `spherical-cosn`.

use super::curves::Curves;
use super::words::{signed, Terms};
use shadegate_hdl::lit::angle::{FRACTION_BITS, TURNS_BITS};
use shadegate_hdl::lit::UNIT;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::shade::sweep::Sweep;

/// Phase, step and amplitude of Aᵐ·f(ξ).
fn words(s: &Sweep, m: f64, curve: &Curves) -> Result<[u64; 3], String> {
    let p = s.phase();
    let bits = curve.bits + (1 + TURNS_BITS + FRACTION_BITS) as u32;
    let word = |what, angle: f64| signed(what, angle * curve.density(), FRACTION_BITS as u32, bits);
    let full = f64::from(1u32 << curve.bits) / f64::from((1u32 << curve.bits) - 1);
    let amplitude = p.amplitude.powf(m) * full * UNIT as f64;
    Ok([
        word("phase", p.phase)?,
        word("step of the phase", p.step)?,
        amplitude.round() as u64,
    ])
}

/// The words of both terms; a term that is missing is dark.
pub fn terms(
    kind: SpanKind,
    bits: usize,
    sweeps: [Option<&Sweep>; 2],
    n: f64,
    pixels: u32,
) -> Result<Terms, String> {
    let of =
        |s: Option<&Sweep>, m: f64, curve: Curves| s.map_or(Ok([0; 3]), |s| words(s, m, &curve));
    Ok(Terms {
        first: 0,
        pixels,
        diffuse: of(sweeps[0], 1.0, Curves::diffuse(bits))?,
        highlight: of(sweeps[1], n, Curves::highlight(kind, n))?,
    })
}
