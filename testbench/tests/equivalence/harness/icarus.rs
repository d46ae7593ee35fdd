//! The units in Icarus Verilog, under a test bench that only reads and writes words.

use super::bench::{Answers, Bench};
use super::process::{self, run, silent};
use std::fmt::Write;
use std::path::Path;

/// The test bench.
fn test_bench(b: &Bench) -> String {
    let stimuli = b.stimuli();
    let clocked = b.units.iter().any(|u| u.clock);
    let mut out = "module bench;\n  reg clock = 1'b0;\n  integer from;\n  integer to;\n  integer i;\n  integer read;\n".to_string();
    let mut connections = vec![];
    if clocked {
        connections.push(".clock(clock)".to_string());
    }
    for (i, s) in stimuli.iter().enumerate() {
        let _ = writeln!(out, "  reg [{}:0] x{i};", Bench::input_bits(s) - 1);
        if !s.inputs.is_empty() {
            connections.push(format!(".x{i}(x{i})"));
        }
    }
    let outputs = b.outputs();
    for (name, width) in &outputs {
        let _ = writeln!(out, "  wire [{}:0] {name};", width - 1);
        connections.push(format!(".{name}({name})"));
    }
    let _ = writeln!(
        out,
        "  everything all (\n    {}\n  );",
        connections.join(",\n    ")
    );
    let names = |letter: &str, count: usize| {
        (0..count)
            .map(|i| format!("{letter}{i}"))
            .collect::<Vec<_>>()
    };
    let holes = |count: usize| vec!["%h"; count].join(" ");
    out += "  task show;\n    begin\n";
    for (name, _) in &outputs {
        let _ = writeln!(out, "      $fwrite(to, \"%h \", {name});");
    }
    out += "      $fdisplay(to);\n    end\n  endtask\n";
    let edge = if b.clocked {
        "clock = 1'b1;\n      #1 show;\n      clock = 1'b0;\n"
    } else {
        ""
    };
    let _ = write!(
        out,
        "  initial begin\n    from = $fopen(\"stimuli.txt\", \"r\");\n    to = $fopen(\"icarus.txt\", \"w\");\n    \
         for (i = 0; i < {}; i = i + 1) begin\n      read = $fscanf(from, \"{}\", {});\n      #1 show;\n      {edge}    end\n    \
         $fclose(to);\n    $finish;\n  end\nendmodule\n",
        b.vectors(),
        holes(stimuli.len()),
        names("x", stimuli.len()).join(", ")
    );
    out
}

/// Runs the units, whatever Icarus may remark.
///
/// # Errors
/// What Icarus says of files that do not compile.
pub fn attempt(b: &Bench, directory: &Path) -> Result<Answers, String> {
    let names = b.write_verilog(directory);
    b.write_stimuli(&directory.join("stimuli.txt"));
    std::fs::write(directory.join("bench.v"), test_bench(b)).expect("writable");
    let mut build = vec!["-g2001", "-s", "bench", "-o", "simulation", "bench.v"];
    build.extend(names.iter().map(String::as_str));
    process::attempt(directory, "iverilog", &build)?;
    run(directory, "vvp", &["-n", "simulation"]);
    Ok(b.read_answers(&directory.join("icarus.txt")))
}

/// Runs the units; their files must compile without a remark.
pub fn answers(b: &Bench, directory: &Path) -> Answers {
    let names = b.write_verilog(directory);
    let mut lint = vec!["-g2001", "-Wall", "-s", "everything", "-o", "lint"];
    lint.extend(names.iter().map(String::as_str));
    silent(directory, "iverilog", &lint);
    attempt(b, directory).unwrap_or_else(|said| panic!("iverilog failed:\n{said}"))
}
