//! The perspective division against f64: random and extreme u·w, v·w and w within what the host sends.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::texture::division::division_model;

/// u from a quotient of words that are right to their last bit.
fn check(r: &mut StdRng, u: f64, w: f64) -> f64 {
    let code = |x: f64, bits: i32| (x * 2f64.powi(bits)).floor() as i64;
    let v = r.random_range(-1000.0..1000.0);
    let [got, _] = division_model(code(u * w, 28), code(v * w, 28), code(w, 39));
    // What the words themselves say.
    let want = code(u * w, 28) as f64 / 2f64.powi(28) / (code(w, 39) as f64 / 2f64.powi(39));
    let off = got as f64 / 4096.0 - want;
    // The nearest of the residues modulo 1024.
    let off = off - (off / 1024.0).round() * 1024.0;
    // Cut twice, downwards; the reciprocal is off by less than 2^-21 and doubled.
    let bound = 2.0 / 4096.0 + want.abs() * 2f64.powi(-20);
    assert!(
        off <= want.abs() * 2f64.powi(-20) && off >= -bound,
        "{u} {w}: {off:e} {bound:e}"
    );
    off.abs() / bound
}

#[test]
fn quotients_are_within_their_bound() {
    let mut r = StdRng::seed_from_u64(51);
    let mut worst = 0.0f64;
    for _ in 0..1_000_000 {
        let w = r.random_range(2.0f64.powi(-15)..1.0) * 2f64.powi(-r.random_range(0..15));
        let w = w.max(2f64.powi(-15));
        let reach = 2f64.powi(r.random_range(-12..=10)) - 0.001;
        let u = r.random_range(-reach.abs()..=reach.abs());
        worst = worst.max(check(&mut r, u, w));
    }
    // Powers of two and their neighbours, where the normalisation changes.
    for s in 0..=15 {
        for step in -2i32..=2 {
            let w =
                (2f64.powi(-s) + f64::from(step) * 2f64.powi(-39)).clamp(2f64.powi(-15), 0.999_99);
            for u in [-1023.5, -512.0, -1.0, 0.0, 0.25, 1.0, 511.5, 1023.75] {
                worst = worst.max(check(&mut r, u, w));
            }
        }
    }
    assert!(worst > 0.5, "{worst}");
}
