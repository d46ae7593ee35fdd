//! Finding and running other programs.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The path of a program on PATH.
#[must_use]
pub fn find_tool(name: &str) -> Option<PathBuf> {
    let paths = std::env::var_os("PATH")?;
    std::env::split_paths(&paths)
        .map(|p| p.join(name))
        .find(|p| executable(p))
}

fn executable(path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        path.metadata()
            .is_ok_and(|m| m.is_file() && m.permissions().mode() & 0o111 != 0)
    }
    #[cfg(not(unix))]
    path.is_file()
}

/// Runs a program to its end; its standard output, or what went wrong with the last lines it said. A failure may be
/// accepted if the program at least says something: then it came as far as a verdict.
pub fn output(command: &mut Command, accept_failure: bool) -> Result<String, String> {
    let program = command.get_program().to_string_lossy().to_string();
    let out = command
        .output()
        .map_err(|e| format!("cannot run {program}: {e}"))?;
    let text = String::from_utf8_lossy(&out.stdout).to_string();
    if out.status.success() || accept_failure && !text.trim().is_empty() {
        return Ok(text);
    }
    let said = String::from_utf8_lossy(&out.stderr).to_string() + &text;
    let lines: Vec<&str> = said.lines().filter(|l| !l.trim().is_empty()).collect();
    let tail = lines[lines.len().saturating_sub(5)..].join(" | ");
    Err(format!("{program} failed ({}): {tail}", out.status))
}

/// What a program says on both of its streams, whatever its exit code.
pub fn said(command: &mut Command) -> Result<String, String> {
    let program = command.get_program().to_string_lossy().to_string();
    let out = command
        .output()
        .map_err(|e| format!("cannot run {program}: {e}"))?;
    Ok(String::from_utf8_lossy(&out.stdout).to_string() + &String::from_utf8_lossy(&out.stderr))
}
