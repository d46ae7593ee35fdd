//! How far two frames are apart and how long something took, as text and as JSON.

use serde_json::{json, Value};
use shadegate_testbench::compare::Comparison;

/// The error keys that all commands share. Equal frames have no PSNR: null.
pub fn error_json(c: &Comparison) -> Value {
    json!({
        "max_lsb": c.max_lsb,
        "rms_lsb": c.rms_lsb,
        "psnr_db": Some(c.psnr_db).filter(|p| p.is_finite()),
        "flip_mean": c.flip_mean,
    })
}

/// The same on lines.
pub fn error_text(c: &Comparison) -> String {
    let psnr = if c.psnr_db.is_finite() {
        format!("{:.2} dB", c.psnr_db)
    } else {
        "infinite".to_owned()
    };
    format!(
        "  max   {} LSB\n  RMS   {:.4} LSB\n  PSNR  {psnr}\n  FLIP  {:.6}\n",
        c.max_lsb, c.rms_lsb, c.flip_mean
    )
}

/// Nanoseconds in a unit that reads well.
pub fn duration(ns: u64) -> String {
    let t = ns as f64;
    match ns {
        0..1_000 => format!("{ns} ns"),
        1_000..1_000_000 => format!("{:.1} µs", t / 1e3),
        1_000_000..1_000_000_000 => format!("{:.2} ms", t / 1e6),
        _ => format!("{:.2} s", t / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations() {
        assert_eq!(duration(999), "999 ns");
        assert_eq!(duration(1_500), "1.5 µs");
        assert_eq!(duration(12_340_000), "12.34 ms");
        assert_eq!(duration(2_500_000_000), "2.50 s");
    }
}
