//! The units compiled by Verilator, under a main program that only reads and writes words.

use super::bench::{Answers, Bench};
use super::process::{run, silent};
use std::fmt::Write;
use std::path::Path;

/// Bytes of a port are its words in memory, lowest first, whatever type Verilator gave it.
const HELPERS: &str = r#"#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include "Veverything.h"
#include "verilated.h"

double sc_time_stamp() { return 0; }

static void put(void* port, size_t bytes, const std::string& hex) {
  unsigned char* to = static_cast<unsigned char*>(port);
  std::memset(to, 0, bytes);
  for (size_t i = 0; i < hex.size(); ++i) {
    char c = hex[hex.size() - 1 - i];
    unsigned digit = c <= '9' ? c - '0' : c - 'a' + 10;
    to[i / 2] |= digit << (i % 2 * 4);
  }
}

static void get(std::FILE* file, const void* port, size_t digits) {
  const unsigned char* from = static_cast<const unsigned char*>(port);
  for (size_t i = digits; i-- > 0;) std::fputc("0123456789abcdef"[from[i / 2] >> (i % 2 * 4) & 15], file);
  std::fputc(' ', file);
}

"#;

fn main_program(b: &Bench) -> String {
    let clocked = b.units.iter().any(|u| u.clock);
    let mut out = HELPERS.to_string();
    out += "static void show(std::FILE* file, Veverything& t) {\n";
    for (name, width) in b.outputs() {
        let digits = width.div_ceil(4);
        let _ = writeln!(out, "  get(file, &t.{name}, {digits});");
    }
    out += "  std::fputc('\\n', file);\n}\n\nint main() {\n  Veverything t;\n  std::ifstream from(\"stimuli.txt\");\n";
    out += "  std::FILE* to = std::fopen(\"verilator.txt\", \"w\");\n  std::string word;\n";
    let _ = writeln!(out, "  for (int i = 0; i < {}; ++i) {{", b.vectors());
    for (i, s) in b.stimuli().iter().enumerate() {
        out += "    from >> word;\n";
        if !s.inputs.is_empty() {
            let _ = writeln!(out, "    put(&t.x{i}, sizeof t.x{i}, word);");
        }
    }
    let clock = |level: u8| {
        if clocked {
            format!("    t.clock = {level};\n")
        } else {
            String::new()
        }
    };
    out += &clock(0);
    out += "    t.eval();\n    show(to, t);\n";
    if b.clocked {
        out += &clock(1);
        out += "    t.eval();\n    show(to, t);\n";
    }
    out + "  }\n  std::fclose(to);\n  return 0;\n}\n"
}

/// Lints the units with every warning on, except those named.
pub fn lint(names: &[String], directory: &Path, except: &[&str]) {
    let mut arguments = vec!["--lint-only", "-Wall", "--top-module", "everything"];
    arguments.extend(except);
    arguments.extend(names.iter().map(String::as_str));
    silent(directory, "verilator", &arguments);
}

/// Builds and runs the units; `except` are warnings that need not be heeded.
pub fn answers(b: &Bench, directory: &Path, except: &[&str]) -> Answers {
    let names = b.write_verilog(directory);
    b.write_stimuli(&directory.join("stimuli.txt"));
    lint(&names, directory, except);
    std::fs::write(directory.join("main.cpp"), main_program(b)).expect("writable");
    // The C++ compiler takes longer than the simulation: it must not optimise.
    let mut build = vec![
        "--cc",
        "--exe",
        "--build",
        "-j",
        "2",
        "-Wno-fatal",
        "-Wno-lint",
        "--output-split",
        "20000",
        "-MAKEFLAGS",
        "OPT_FAST=-O0",
        "-MAKEFLAGS",
        "OPT_GLOBAL=-O0",
        "-Mdir",
        "verilated",
        "--top-module",
        "everything",
        "main.cpp",
    ];
    build.extend(names.iter().map(String::as_str));
    run(directory, "verilator", &build);
    run(directory, "./verilated/Veverything", &[]);
    b.read_answers(&directory.join("verilator.txt"))
}
