//! Keeps the compiler's version and flags, which figures are worth nothing without.

use std::process::Command;

fn main() {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let said = Command::new(rustc).arg("--version").output();
    let version = said.ok().and_then(|o| String::from_utf8(o.stdout).ok());
    let version = version.unwrap_or_else(|| "an unknown compiler".to_owned());
    // Cargo separates flags by the unit separator.
    let flags = std::env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    let flags = match flags.replace('\u{1f}', " ") {
        f if f.is_empty() => "no further flags".to_owned(),
        f => f,
    };
    println!("cargo:rustc-env=PEERS_COMPILER={}, {flags}", version.trim());
    println!("cargo:rerun-if-changed=build.rs");
}
