//! Running the generated test benches, and reading what they print.

use super::{Engine, EngineError, Run, SignalMismatch};
use shadegate_gen::package::PackageFile;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Writes the package's files below `directory`.
pub fn unpack(
    engine: Engine,
    package: &[PackageFile],
    directory: &Path,
) -> Result<(), EngineError> {
    for f in package {
        let path = directory.join(&f.path);
        shadegate_gen::write::write_file(&path, f.text.as_bytes()).map_err(|e| {
            EngineError::Failed {
                engine,
                what: e.to_string(),
            }
        })?;
    }
    Ok(())
}

/// Runs a compiled test bench on the package's vectors: its verdict, its pixels, and the time of the whole process.
pub fn replay(
    engine: Engine,
    binary: &Path,
    scratch: &Path,
    arguments: &[String],
) -> Result<Run, EngineError> {
    let begin = Instant::now();
    let mut simulation = Command::new(std::path::absolute(binary).unwrap_or(binary.to_path_buf()));
    simulation
        .current_dir(scratch)
        .args(["sim/vectors.txt", "pixels.txt"])
        .args(arguments);
    let text = output(engine, &mut simulation, true)?;
    let simulate_ns = begin.elapsed().as_nanos() as u64;
    let verdict = read_verdict(engine, &text)?;
    Ok(Run {
        pixels: read_pixels(engine, &scratch.join("pixels.txt"))?,
        simulate_ns,
        ..verdict
    })
}

/// Paths of the package's Verilog modules.
pub fn rtl_paths(package: &[PackageFile]) -> impl Iterator<Item = &str> {
    let paths = package.iter().map(|f| f.path.as_str());
    paths.filter(|p| p.starts_with("rtl/") && p.ends_with(".v"))
}

/// Runs a program to its end, see [`crate::process::output`].
pub fn output(
    engine: Engine,
    command: &mut Command,
    accept_failure: bool,
) -> Result<String, EngineError> {
    let failed = |what| EngineError::Failed { engine, what };
    crate::process::output(command, accept_failure).map_err(failed)
}

fn field<'a>(line: &'a str, key: &str) -> Option<&'a str> {
    line.split_whitespace()
        .find_map(|w| w.strip_prefix(key)?.strip_prefix('='))
}

/// What a test bench printed: `MISMATCH …`, then `PASS …` or `FAIL …`.
pub fn read_verdict(engine: Engine, text: &str) -> Result<Run, EngineError> {
    let failed = |what: String| EngineError::Failed { engine, what };
    let verdict = text
        .lines()
        .find(|l| l.starts_with("PASS ") || l.starts_with("FAIL "));
    let verdict = verdict
        .ok_or_else(|| failed(format!("the test bench gave no verdict: {}", text.trim())))?;
    let number = |line: &str, key: &str| field(line, key).and_then(|v| v.parse::<u64>().ok());
    let cycles = number(verdict, "clocks").ok_or_else(|| failed(verdict.to_string()))?;
    let first = text
        .lines()
        .find(|l| l.starts_with("MISMATCH "))
        .map(|l| SignalMismatch {
            cycle: number(l, "clock").unwrap_or_default(),
            signal: field(l, "signal").unwrap_or("?").to_string(),
            expected: field(l, "expected")
                .and_then(|v| u64::from_str_radix(v, 16).ok())
                .unwrap_or_default(),
            // Four-valued: an unknown bit has no number.
            got: field(l, "got")
                .and_then(|v| u64::from_str_radix(v, 16).ok())
                .unwrap_or(u64::MAX),
            x: number(l, "x").unwrap_or_default() as u32,
            y: number(l, "y").unwrap_or_default() as u32,
        });
    let mismatches = if verdict.starts_with("PASS") {
        0
    } else {
        number(verdict, "mismatches").unwrap_or(1)
    };
    Ok(Run {
        mismatches,
        first,
        cycles,
        loop_ns: number(verdict, "loop_ns"),
        ..Run::default()
    })
}

/// Reads `x y red green blue` lines.
pub fn read_pixels(engine: Engine, path: &Path) -> Result<Vec<(u16, u16, [u8; 3])>, EngineError> {
    let error = |what: String| EngineError::Failed {
        engine,
        what: format!("{}: {what}", path.display()),
    };
    let text = std::fs::read_to_string(path).map_err(|e| error(e.to_string()))?;
    let mut pixels = vec![];
    for (i, line) in text.lines().enumerate() {
        let numbers: Vec<u16> = line
            .split_whitespace()
            .map_while(|w| w.parse().ok())
            .collect();
        let [x, y, r, g, b] = numbers[..] else {
            return Err(error(format!(
                "line {}: five numbers expected, not `{line}`",
                i + 1
            )));
        };
        pixels.push((x, y, [r as u8, g as u8, b as u8]));
    }
    Ok(pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_are_read() {
        let text = "MISMATCH clock=17 signal=red expected=00ff got=00fe x=3 y=4\nFAIL clocks=100 mismatches=9\n";
        let run = read_verdict(Engine::Icarus, text).unwrap();
        assert_eq!((run.cycles, run.mismatches), (100, 9));
        let want = SignalMismatch {
            cycle: 17,
            signal: "red".into(),
            expected: 255,
            got: 254,
            x: 3,
            y: 4,
        };
        assert_eq!(run.first, Some(want));
        let run = read_verdict(Engine::Icarus, "PASS clocks=5 pixels=1\n").unwrap();
        assert_eq!((run.cycles, run.mismatches, run.first), (5, 0, None));
        assert_eq!(run.loop_ns, None);
        let timed = "FAIL clocks=5 mismatches=1 loop_ns=1234\n";
        let run = read_verdict(Engine::Verilator, timed).unwrap();
        assert_eq!(run.loop_ns, Some(1234));
        assert!(read_verdict(Engine::Icarus, "nothing").is_err());
        assert!(read_verdict(Engine::Icarus, "FAIL cannot open vectors.txt").is_err());
    }
}
