//! Waveforms of the compiled engine: the window, the chosen signals, values that agree with the vectors, and the same
//! from FST as from VCD.

use fst_reader::{FstFilter, FstHierarchyEntry, FstReader, FstSignalValue};
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;
use shadegate_testbench::engine::{run, Engine, EngineError, Wave};
use shadegate_testbench::wave::CLOCK_PS;
use std::collections::BTreeMap;
use std::convert::Infallible;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

const WINDOW: std::ops::Range<u64> = 100..400;

fn trace() -> Trace {
    let viewport = Viewport {
        width: 96,
        height: 64,
    };
    let core = Core::for_frame(Order::Quadratic, 96, 64).expect("in range");
    let t = sample_triangles(Order::Quadratic, viewport, 20, 7);
    let stimulus = build(&core, &t, viewport, &StimulusOptions::default()).expect("in range");
    Trace::record(core, &stimulus, |_| true)
}

fn record(trace: &Trace, file: &Path, signals: &[&str]) -> Result<(), EngineError> {
    let wave = Wave {
        file: file.to_path_buf(),
        from: WINDOW.start,
        to: WINDOW.end,
        signals: signals.iter().map(ToString::to_string).collect(),
    };
    let scratch = tempfile::tempdir().expect("temporary directory");
    let r = run(Engine::Compiled, trace, &[], scratch.path(), Some(&wave))?;
    assert_eq!(r.mismatches, 0);
    Ok(())
}

/// Changes of every variable by dotted name: time and code.
type Changes = BTreeMap<String, Vec<(u64, u128)>>;

/// Reads a VCD file with a reader that is not the writer's.
fn read(text: &str) -> Changes {
    let (mut scopes, mut time) = (vec![], 0);
    let mut names: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    let mut out = Changes::new();
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let mut change = |id: &str, digits: &str, time| {
            let code = u128::from_str_radix(digits, 2).expect("two-valued");
            for name in &names[id] {
                out.entry(name.clone()).or_default().push((time, code));
            }
        };
        match words[..] {
            ["$scope", _, name, _] => scopes.push(name),
            ["$upscope", _] => drop(scopes.pop()),
            ["$var", _, _, id, name, _] => {
                let mut path = scopes[1..].to_vec();
                path.push(name);
                names.entry(id).or_default().push(path.join("."));
            }
            [stamp] if stamp.starts_with('#') => time = stamp[1..].parse().expect("a time"),
            [digits, id] if digits.starts_with('b') => change(id, &digits[1..], time),
            [bit] if bit.starts_with(['0', '1']) => change(&bit[1..], &bit[..1], time),
            _ => {}
        }
    }
    out
}

/// The code that a variable shows at a time.
fn at(changes: &[(u64, u128)], time: u64) -> Option<u128> {
    let before = changes.iter().take_while(|c| c.0 <= time);
    before.last().map(|c| c.1)
}

#[test]
fn a_vcd_shows_what_the_vectors_say() {
    let trace = trace();
    let directory = tempfile::tempdir().expect("temporary directory");
    let file = directory.path().join("all.vcd");
    record(&trace, &file, &[]).unwrap_or_else(|e| panic!("{e}"));
    let changes = read(&std::fs::read_to_string(&file).expect("written"));
    assert!(changes.len() > 150, "{} variables", changes.len());
    assert!(changes.contains_key("shell.major.position"));
    let first = changes.values().flatten().map(|c| c.0).min();
    assert_eq!(first, Some(WINDOW.start * CLOCK_PS));
    for cycle in WINDOW {
        let time = cycle * CLOCK_PS;
        let shown = |name: &str| at(&changes[name], time).expect("shown");
        let clock = &trace.clocks[cycle as usize];
        assert_eq!(shown("clock"), 1);
        assert_eq!(shown("data"), u128::from(clock.inputs.data));
        assert_eq!(shown("valid"), u128::from(clock.outputs.valid));
        assert_eq!(shown("stream.valid"), u128::from(clock.outputs.valid));
        assert_eq!(shown("x"), u128::from(clock.outputs.x));
        assert_eq!(shown("depth"), u128::from(clock.outputs.depth));
        // A wire between modules, from what it is made of.
        let accept = shown("write") & shown("load_ready");
        assert_eq!(shown("accept"), accept, "clock {cycle}");
    }
    let low = WINDOW.start * CLOCK_PS + CLOCK_PS / 2;
    assert_eq!(at(&changes["clock"], low), Some(0));
}

#[test]
fn patterns_choose_signals() {
    let trace = trace();
    let directory = tempfile::tempdir().expect("temporary directory");
    let file = directory.path().join("some.vcd");
    record(&trace, &file, &["shell.major", "*red", "x"]).unwrap_or_else(|e| panic!("{e}"));
    let changes = read(&std::fs::read_to_string(&file).expect("written"));
    let names: Vec<&str> = changes.keys().map(String::as_str).collect();
    assert!(names.contains(&"x") && names.contains(&"red") && names.contains(&"stream.red"));
    assert!(names.contains(&"shell.major.column"));
    let fits = |n: &&str| n.starts_with("shell.major.") || n.ends_with("red") || *n == "x";
    assert!(names.iter().all(fits), "{names:?}");

    let e = record(&trace, &file, &["nonsense"]).expect_err("refused");
    let want = format!(
        "engine compiled cannot write '{}': no signal fits 'nonsense'",
        file.display()
    );
    assert_eq!(e.to_string(), want);
}

/// Reads an FST file with a reader that is not the writer's.
fn read_fst(file: &Path) -> Changes {
    let input = BufReader::new(File::open(file).expect("written"));
    let mut reader = FstReader::open(input).expect("an FST file");
    let mut scopes = vec![];
    let mut names: BTreeMap<usize, Vec<String>> = BTreeMap::new();
    let hierarchy = reader.read_hierarchy(|entry| match entry {
        FstHierarchyEntry::Scope { name, .. } => scopes.push(name),
        FstHierarchyEntry::UpScope => drop(scopes.pop()),
        FstHierarchyEntry::Var { name, handle, .. } => {
            let mut path = scopes[1..].to_vec();
            path.push(name);
            let id = handle.get_index();
            names.entry(id).or_default().push(path.join("."));
        }
        _ => {}
    });
    hierarchy.expect("a hierarchy");
    let mut out = Changes::new();
    let changes = reader.read_signals(
        &FstFilter::all(),
        |time, handle, value| -> Result<(), Infallible> {
            let FstSignalValue::String(digits) = value else {
                panic!("not bits");
            };
            let digits = std::str::from_utf8(digits).expect("digits");
            // A block begins with what was before its first change: at the very beginning, unknown.
            let Ok(code) = u128::from_str_radix(digits, 2) else {
                return Ok(());
            };
            for name in &names[&handle.get_index()] {
                out.entry(name.clone()).or_default().push((time, code));
            }
            Ok(())
        },
    );
    changes.expect("changes");
    out
}

#[test]
fn an_fst_file_shows_the_same_and_is_smaller() {
    let trace = trace();
    let directory = tempfile::tempdir().expect("temporary directory");
    let [vcd, fst] = ["w.vcd", "w.fst"].map(|f| directory.path().join(f));
    for file in [&vcd, &fst] {
        record(&trace, file, &[]).unwrap_or_else(|e| panic!("{e}"));
    }
    let text = std::fs::read_to_string(&vcd).expect("written");
    let (want, got) = (read(&text), read_fst(&fst));
    assert!(want.keys().eq(got.keys()));
    for (name, changes) in &want {
        for cycle in WINDOW {
            for time in [cycle * CLOCK_PS, cycle * CLOCK_PS + CLOCK_PS / 2] {
                assert_eq!(at(&got[name], time), at(changes, time), "{name} at {time}");
            }
        }
    }
    let bytes = std::fs::metadata(&fst).expect("written").len();
    assert!(bytes * 4 < text.len() as u64, "{bytes} bytes");
    // Nothing is left beside them.
    let left = std::fs::read_dir(directory.path()).expect("a directory");
    assert_eq!(left.count(), 2);
}
