//! Helpers of the generator's tests.

use std::process::Command;

/// Fails with the command that installs the tool, if it is missing: tests never skip silently.
pub fn need(tool: &str) {
    let found = Command::new(tool).arg("--version").output().is_ok()
        || Command::new(tool).arg("-V").output().is_ok();
    assert!(found, "`{tool}` is needed by this test: apt-get install iverilog verilator yosys (scripts/test does it)");
}
