//! rust-hdl's own Verilog, measured: each known trap is run in Icarus as rust-hdl prints it and as this project does,
//! and compared with rust-hdl's simulation. `docs/printer.md` holds the result; write it anew with
//!
//! ```text
//! SHADEGATE_BLESS=1 cargo test --release -p shadegate-testbench --test equivalence printer
//! ```

mod traps;

use crate::harness::bench::Bench;
use crate::harness::case::Unit;
use crate::harness::compare::{differences, Difference};
use crate::harness::icarus;
use crate::harness::process::attempt;
use shadegate_gen::verilog::VerilogFile;
use std::path::Path;
use traps::{guard, invalid, traps, Trap};

const HEAD: &str = "\
# What rust-hdl prints

rust-hdl translates syntax, without widths and signs, and prints no parentheses. Its simulation and its Verilog are two
different circuits whenever Verilog's context rules have something to decide. Each row below is measured by
`testbench/tests/equivalence/printer`: the same description, simulated by rust-hdl, and its Verilog as rust-hdl 0.46 and
as this project prints it, in Icarus. rust-hdl's differs or is
no Verilog in every row; ours agrees, or the description is refused, but for the last row. Written by the test;
see there how to write it anew.

";

/// The first difference, or what Icarus says of text that it does not take.
fn verdict(unit: &Unit) -> Result<Option<Difference>, String> {
    let bench = Bench {
        units: std::slice::from_ref(unit),
        clocked: true,
    };
    let directory = tempfile::tempdir().expect("temporary directory");
    let answers = icarus::attempt(&bench, directory.path())?;
    Ok(differences("icarus", &bench, &answers).into_iter().next())
}

/// The lines of a module that say how `o` comes about.
fn essence(text: &str) -> String {
    let lines = text
        .lines()
        .map(|l| l.split("//").next().unwrap_or_default().trim());
    let lines: Vec<&str> = lines.filter(|l| l.contains(" = ")).collect();
    lines.join(" ")
}

/// The unit with rust-hdl's text instead of ours.
fn foreign(mut unit: Unit, text: &str) -> Unit {
    unit.module.name = "top".into();
    unit.files = vec![VerilogFile {
        name: "top".into(),
        text: text.into(),
    }];
    unit
}

/// What rust-hdl's text means, in a few words. Fails if it is right.
fn measured(rust: &str, unit: &Unit) -> String {
    match verdict(unit) {
        Ok(None) => panic!("{rust}: rust-hdl's Verilog agrees with its simulation"),
        Ok(Some(d)) => {
            let got = d.got.map_or("unknown".to_string(), |g| format!("{g:#x}"));
            format!("{got} instead of {:#x} for {}", d.expected, d.inputs)
        }
        Err(_) => "not Verilog".to_string(),
    }
}

fn cells(list: &[&str]) -> String {
    let list: Vec<String> = list.iter().map(|c| c.replace('|', "\\|")).collect();
    format!("| {} |\n", list.join(" | "))
}

/// A row of the document. Fails unless rust-hdl's text is wrong and ours is right.
fn row(trap: Trap) -> String {
    let Trap {
        rust,
        why,
        mut case,
    } = trap;
    let theirs = case.rust_hdl_text();
    let ours = case.run().unwrap_or_else(|e| panic!("{rust}: {e}"));
    let printed = ours
        .files
        .iter()
        .map(|f| f.text.as_str())
        .collect::<String>();
    assert_eq!(verdict(&ours), Ok(None), "{rust}: this project's Verilog");
    let means = format!("{why}: {}", measured(rust, &foreign(ours, &theirs)));
    let code = |text: &str| format!("`{text}`");
    cells(&[
        &code(rust),
        &code(&essence(&theirs)),
        &means,
        &code(&essence(&printed)),
    ])
}

/// A row for what this project refuses and Icarus does not take.
fn refused_row(trap: Trap) -> String {
    let Trap {
        rust,
        why,
        mut case,
    } = trap;
    let theirs = case.rust_hdl_text();
    let directory = tempfile::tempdir().expect("temporary directory");
    std::fs::write(directory.path().join("top.v"), &theirs).expect("writable");
    let taken = attempt(
        directory.path(),
        "iverilog",
        &["-g2001", "-o", "top", "top.v"],
    );
    assert!(taken.is_err(), "{rust}: Icarus takes rust-hdl's Verilog");
    let refusal = case
        .run()
        .err()
        .unwrap_or_else(|| panic!("{rust} is not refused"));
    let refusal = refusal.split(": ").nth(2).unwrap_or_default().to_string();
    let means = format!("{why}: not Verilog");
    cells(&[
        &format!("`{rust}`"),
        &format!("`{}`", essence(&theirs)),
        &means,
        &format!("refused: {refusal}"),
    ])
}

/// The row of the guard. Fails unless both texts are wrong: then the remark in the netlist's sources must go.
fn guard_row() -> String {
    let Trap {
        rust,
        why,
        mut case,
    } = guard();
    let theirs = case.rust_hdl_text();
    let ours = case.run().unwrap_or_else(|e| panic!("{rust}: {e}"));
    assert!(matches!(verdict(&ours), Ok(Some(_))), "the guard is seen");
    let means = format!("{why}: {}", measured(rust, &foreign(ours, &theirs)));
    cells(&[
        &format!("`{rust}`"),
        "the first arm for every `Left`",
        &means,
        "the same: the tree keeps no guard, only co-simulation finds it",
    ])
}

#[test]
fn rust_hdl_prints_other_circuits_than_it_simulates() {
    let mut text = HEAD.to_string();
    text += "| Rust | rust-hdl prints | which means | this project prints |\n|---|---|---|---|\n";
    text.extend(traps().into_iter().map(row));
    text.extend(invalid().into_iter().map(refused_row));
    text += &guard_row();
    println!("{text}");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/printer.md");
    if std::env::var_os("SHADEGATE_BLESS").is_some() {
        std::fs::write(&file, &text).expect("writable");
    }
    let kept = std::fs::read_to_string(&file).unwrap_or_default();
    assert_eq!(kept, text, "docs/printer.md is out of date");
}
