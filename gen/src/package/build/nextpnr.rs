//! What nextpnr must be told of a device.

use crate::package::Target;
use shadegate_constraints::Format;

/// Options of `nextpnr-ice40` or `nextpnr-ecp5`; none for devices that have no nextpnr.
pub fn options(t: Target) -> Vec<String> {
    let device = t.device.name.as_str();
    let (package, speed) = match t.board {
        Some(b) => (b.package.as_str(), b.speed),
        None => (t.device.package.as_str(), t.device.speed),
    };
    let words = match t.device.constraints {
        Format::Ucf | Format::Xdc => return vec![],
        // ice40up5k, sg48.
        Format::Pcf => vec![
            format!("--{}", device.trim_start_matches("ice40")),
            "--package".to_owned(),
            package.to_owned(),
            "--pcf-allow-unconstrained".to_owned(),
        ],
        // lfe5u-25f, bg381.
        Format::Lpf => vec![
            format!(
                "--{}k",
                device.trim_start_matches("lfe5u-").trim_end_matches('f')
            ),
            "--package".to_owned(),
            package.replace("bg", "CABGA"),
            "--speed".to_owned(),
            speed.to_string(),
            "--lpf-allow-unconstrained".to_owned(),
        ],
    };
    words
}
