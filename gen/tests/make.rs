//! A package builds and passes in a directory that holds nothing but itself, and cleans up after itself.

mod common;

use common::{make, make_with, need, run, Made};
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::shade::model::Order;
use std::collections::BTreeSet;
use std::path::Path;

fn files_below(root: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut folders = vec![root.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("readable") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let inside = path.strip_prefix(root).expect("below");
                found.insert(inside.to_string_lossy().into_owned());
            }
        }
    }
    found
}

fn passes(made: &Made, goals: &[&str]) {
    let directory = made.unpacked();
    let root = directory.path();
    let before = files_below(root);
    let clocks = format!(
        "PASS clocks={} pixels={} ",
        made.trace.clocks.len(),
        made.trace.pixels.len()
    );
    for goal in goals {
        let (done, said) = run(root, "make", &[goal]);
        assert!(done, "make {goal}: {said}");
        match *goal {
            "icarus" | "verilator" => {
                // More may follow in the line.
                let line = said.lines().find(|l| l.starts_with("PASS "));
                let passed = line.is_some_and(|l| format!("{l} ").starts_with(&clocks));
                assert!(passed, "make {goal}: {said}");
            }
            "lint" => assert!(!said.contains('%'), "{said}"),
            wrapper => {
                let pixels = format!(" pixels={} ", made.trace.pixels.len());
                let line = said.lines().find(|l| l.starts_with("PASS writes="));
                assert!(
                    line.is_some_and(|l| l.contains(&pixels)),
                    "make {wrapper}: {said}"
                );
            }
        }
    }
    let made_now: Vec<String> = files_below(root).difference(&before).cloned().collect();
    assert!(!made_now.is_empty());
    assert!(
        made_now.iter().all(|f| f.starts_with("out/")),
        "{made_now:?}"
    );
    assert!(run(root, "make", &["clean"]).0);
    assert_eq!(files_below(root), before);
}

#[test]
fn both_engines_of_a_narrow_core() {
    for tool in ["iverilog", "verilator", "make", "g++"] {
        need(tool);
    }
    let made = make(Order::Linear, 64, 48, None, &[]);
    passes(&made, &["icarus", "verilator", "lint"]);
}

#[test]
fn both_engines_and_both_wrappers_of_a_wide_core() {
    for tool in ["iverilog", "verilator", "make", "g++"] {
        need(tool);
    }
    let made = make(Order::Quadratic, 64, 500, Some("arty-s7-50"), &Wrapper::ALL);
    assert!(made.core.wide);
    passes(&made, &["icarus", "verilator", "axi", "wishbone", "lint"]);
}

/// The benches fill every register with noise, reset, and must then see what a core at power-up shows.
#[test]
fn a_core_with_a_reset_and_both_wrappers() {
    let made = make_with(Order::Linear, (48, 32), None, &Wrapper::ALL, true);
    let top = made.text("rtl/gouraud_core.v");
    assert!(top.contains("input  wire reset,"), "{top}");
    passes(&made, &["icarus", "verilator", "axi", "wishbone", "lint"]);
    // The bench would notice a reset that does nothing.
    let deaf = top.replace(".reset(reset)", ".reset(1'b0)");
    assert_ne!(deaf, top);
    let directory = made.unpacked();
    std::fs::write(directory.path().join("rtl/gouraud_core.v"), deaf).unwrap();
    let (_, said) = run(directory.path(), "make", &["icarus"]);
    assert!(said.contains("FAIL clocks="), "{said}");
}

#[test]
fn what_else_lies_in_the_folder_stays_out_of_the_build() {
    need("iverilog");
    let made = make(Order::Linear, 16, 12, None, &[]);
    let directory = made.unpacked();
    let stray = directory.path().join("rtl/frame_memory_9.v");
    std::fs::write(&stray, "module broken (").unwrap();
    let (done, said) = run(directory.path(), "make", &["icarus"]);
    assert!(done && said.contains("PASS clocks="), "{said}");
    assert!(run(directory.path(), "make", &["clean"]).0);
    assert!(stray.is_file());
}

#[test]
fn a_wrong_vector_fails() {
    need("iverilog");
    let made = make(Order::Linear, 16, 12, None, &[]);
    let directory = made.unpacked();
    let vectors = made.text("sim/vectors.txt");
    // The last line's flags: `done` alone with load_ready becomes nothing at all.
    let wrong = vectors.trim_end().rsplit_once('\n').expect("lines");
    let mut words: Vec<&str> = wrong.1.split(' ').collect();
    words[1] = "0";
    let text = format!("{}\n{}\n", wrong.0, words.join(" "));
    std::fs::write(directory.path().join("sim/vectors.txt"), text).unwrap();
    let (_, said) = run(directory.path(), "make", &["icarus"]);
    assert!(said.contains("FAIL clocks="), "{said}");
}
