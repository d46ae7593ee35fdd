//! Running the external simulators.

use std::path::Path;
use std::process::Command;

/// Runs a program in a directory; what it said.
///
/// # Errors
/// What it said, when it fails.
pub fn attempt(directory: &Path, program: &str, arguments: &[&str]) -> Result<String, String> {
    let out = Command::new(program)
        .current_dir(directory)
        .args(arguments)
        .output()
        .unwrap_or_else(|e| panic!("{program} is needed by this test ({e}): apt-get install iverilog verilator make g++"));
    let said =
        String::from_utf8_lossy(&out.stdout).to_string() + &String::from_utf8_lossy(&out.stderr);
    if out.status.success() {
        Ok(said)
    } else {
        Err(said)
    }
}

/// Runs a program in a directory. It must succeed; what it said is returned.
pub fn run(directory: &Path, program: &str, arguments: &[&str]) -> String {
    attempt(directory, program, arguments)
        .unwrap_or_else(|said| panic!("{program} failed:\n{}", head(&said)))
}

/// Runs a program that must succeed and say nothing.
pub fn silent(directory: &Path, program: &str, arguments: &[&str]) {
    let said = run(directory, program, arguments);
    assert!(
        said.trim().is_empty(),
        "{program} remarks:\n{}",
        head(&said)
    );
}

fn head(text: &str) -> String {
    text.lines().take(60).collect::<Vec<_>>().join("\n")
}
