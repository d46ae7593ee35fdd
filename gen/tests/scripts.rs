//! Scripts of tools that are not installed: complete Tcl, whose commands, run against stubs, name files that exist.
//! And the FuseSoC file: YAML that names files, file sets and modules that exist.

mod common;

use common::{make, need, run, Made};
use saphyr::{LoadableYamlNode, Yaml};
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::shade::model::Order;

/// Runs a script in an interpreter that knows the tool's commands only as stubs, which print what they are called with.
const HARNESS: &str = r#"
set channel [open [lindex $argv 0]]
set text [read $channel]
close $channel
if {![info complete $text]} { puts "incomplete"; exit 1 }
set script [lindex $argv 0]
set child [interp create]
interp eval $child [list set argv [lrange $argv 1 end]]
interp eval $child {
  proc unknown args { puts "undefined: $args"; exit 1 }
  foreach name {read_verilog read_xdc synth_design report_utilization report_timing_summary write_checkpoint
                opt_design place_design route_design project xfile process} {
    proc $name args "puts \[list $name {*}\$args\]"
  }
}
interp eval $child [list source $script]
puts finished
"#;

/// The commands that a script gives, one per line.
fn commands(made: &Made, script: &str, arguments: &[&str]) -> Vec<String> {
    need("tclsh");
    let directory = made.unpacked();
    let harness = tempfile::NamedTempFile::new().expect("temporary file");
    std::fs::write(harness.path(), HARNESS).expect("writable");
    let path = harness.path().to_string_lossy().into_owned();
    let (done, said) = run(
        directory.path(),
        "tclsh",
        &[&[&path, script], arguments].concat(),
    );
    assert!(done && said.ends_with("finished\n"), "{said}");
    let root = directory.path().canonicalize().expect("exists");
    let root = format!("{}/", root.to_string_lossy());
    let lines = said.lines().filter(|l| *l != "finished");
    // ISE's script changes its folder, so it makes paths absolute when it runs.
    lines
        .map(|l| l.replace(&root, "").replace("build/../", ""))
        .collect()
}

fn words_after<'a>(lines: &'a [String], start: &str) -> Vec<&'a str> {
    lines.iter().filter_map(|l| l.strip_prefix(start)).collect()
}

#[test]
fn vivado_reads_every_source_and_goes_as_far_as_it_is_told() {
    for place in ["arty-s7-50", "xc7s15"] {
        let made = make(Order::Quadratic, 16, 12, Some(place), &Wrapper::ALL);
        let part = made.package.manifest.target.clone().expect("a part");
        let synthesis = commands(&made, "build/vivado.tcl", &[]);
        assert_eq!(
            words_after(&synthesis, "read_verilog "),
            made.paths("rtl/", ".v")
        );
        assert_eq!(
            words_after(&synthesis, "read_xdc "),
            ["constraints/quadratic_core.xdc"]
        );
        let want = format!("-top quadratic_core -part {part} -mode out_of_context");
        assert_eq!(words_after(&synthesis, "synth_design "), [want]);
        assert!(!synthesis.iter().any(|l| l.starts_with("route_design")));
        let all = commands(&made, "build/vivado.tcl", &["route"]);
        let steps = ["synth_design", "opt_design", "place_design", "route_design"];
        let order: Vec<&str> = (all.iter())
            .filter_map(|l| l.split(' ').next())
            .filter(|w| steps.contains(w))
            .collect();
        assert_eq!(order, steps);
        for line in all
            .iter()
            .filter(|l| l.starts_with("report") || l.starts_with("write"))
        {
            assert!(line.contains(" out/vivado/"), "{line}");
        }
    }
}

#[test]
fn ise_reads_every_source_and_goes_as_far_as_it_is_told() {
    for (place, family, device, package, speed) in [
        ("mimas-v2", "Spartan6", "xc6slx9", "csg324", "-2"),
        ("xc3s200", "Spartan3", "xc3s200", "ft256", "-4"),
        ("xc3s500e", "Spartan3E", "xc3s500e", "fg320", "-4"),
        ("xc2s100e", "Spartan2E", "xc2s100e", "tq144", "-6"),
    ] {
        let made = make(Order::Linear, 16, 12, Some(place), &Wrapper::ALL);
        let lines = commands(&made, "build/ise.tcl", &[]);
        let mut sources = made.paths("rtl/", ".v");
        sources.push("constraints/gouraud_core.ucf");
        assert_eq!(words_after(&lines, "xfile add "), sources);
        for (key, value) in [
            ("family", family),
            ("device", device),
            ("package", package),
            ("speed", speed),
            ("top", "gouraud_core"),
        ] {
            let set = format!("project set {key} ");
            assert_eq!(words_after(&lines, &set), [value], "{place}");
        }
        assert_eq!(words_after(&lines, "process run "), ["{Synthesize - XST}"]);
        let lines = commands(&made, "build/ise.tcl", &["implement"]);
        let steps = ["{Synthesize - XST}", "{Implement Design}"];
        assert_eq!(words_after(&lines, "process run "), steps);
        assert_eq!(lines.last().map(String::as_str), Some("project close"));
        // The project of the last ISE names the same files; older ones have none.
        let project = made.paths("build/", ".xise");
        assert_eq!(project.len(), usize::from(place != "xc2s100e"), "{place}");
        for path in project {
            let text = made.text(path);
            let named: Vec<&str> = (text.split("<file xil_pn:name=\"../").skip(1))
                .filter_map(|t| t.split('"').next())
                .collect();
            assert_eq!(named, sources);
            for value in [family, device, package, speed, "Module|gouraud_core"] {
                assert!(
                    text.contains(&format!("xil_pn:value=\"{value}\"")),
                    "{value}"
                );
            }
        }
    }
}

#[test]
fn the_harness_notices_what_is_wrong() {
    need("tclsh");
    let directory = tempfile::tempdir().expect("temporary directory");
    for (text, said) in [
        ("synth_design -top {a", "incomplete"),
        ("sinth_design -top a", "undefined: sinth_design -top a"),
    ] {
        std::fs::write(directory.path().join("harness.tcl"), HARNESS).expect("writable");
        std::fs::write(directory.path().join("wrong.tcl"), text).expect("writable");
        let (done, out) = run(directory.path(), "tclsh", &["harness.tcl", "wrong.tcl"]);
        assert!(!done && out.contains(said), "{out}");
    }
}

#[test]
fn scripts_name_no_absolute_path_and_only_files_that_are_there() {
    for place in [
        None,
        Some("arty-s7-50"),
        Some("mimas-v2"),
        Some("icebreaker"),
        Some("ulx3s-25f"),
    ] {
        let made = make(Order::Linear, 16, 12, place, &Wrapper::ALL);
        for f in made
            .package
            .files
            .iter()
            .filter(|f| !f.path.starts_with("sim/"))
        {
            for word in f.text.split_whitespace() {
                let bare = word.trim_matches(['"', '(', ')', '[', ']', '{', '}', '\'', ';']);
                let absolute = bare.starts_with('/')
                    && bare.chars().nth(1).is_some_and(|c| c.is_ascii_alphabetic());
                assert!(!absolute, "{}: {word}", f.path);
                let inside = ["rtl/", "constraints/", "wrappers/", "example/"];
                let named = inside.iter().any(|i| bare.starts_with(i)) && bare.contains('.');
                let plain = !bare.contains(['$', '*', '`', '"', ',']);
                if named && plain && f.path.starts_with("build/") {
                    let there = made.package.files.iter().any(|g| g.path == bare);
                    assert!(there, "{}: {word}", f.path);
                }
            }
        }
    }
}

#[test]
fn the_fusesoc_file_is_yaml_that_names_what_is_there() {
    for (place, tool) in [
        (None, "yosys"),
        (Some("arty-s7-50"), "vivado"),
        (Some("mimas-v2"), "ise"),
        (Some("icebreaker"), "icestorm"),
        (Some("ulx3s-25f"), "trellis"),
    ] {
        let made = make(Order::Linear, 16, 12, place, &Wrapper::ALL);
        let text = made.text("gouraud_core.core");
        assert!(text.starts_with("CAPI=2:\n"));
        let documents = Yaml::load_from_str(text).expect("YAML");
        let [whole] = &documents[..] else {
            panic!("{} documents", documents.len())
        };
        let text_of = |y: &Yaml, key: &str| -> String {
            let value = y.as_mapping_get(key).and_then(Yaml::as_str);
            value.unwrap_or_else(|| panic!("no {key}")).to_owned()
        };
        let version = env!("CARGO_PKG_VERSION");
        assert_eq!(
            text_of(whole, "name"),
            format!("shadegate::gouraud_core:{version}")
        );
        let sets = whole
            .as_mapping_get("filesets")
            .and_then(Yaml::as_mapping)
            .expect("filesets");
        let mut named = vec![];
        for set in sets.values() {
            for file in set
                .as_mapping_get("files")
                .and_then(Yaml::as_sequence)
                .expect("files")
            {
                let with_options = file.as_mapping().and_then(|m| m.keys().next());
                named.push(with_options.unwrap_or(file).as_str().expect("a path"));
            }
        }
        for path in &named {
            assert!(made.package.files.iter().any(|f| f.path == *path), "{path}");
        }
        for path in made
            .paths("rtl/", ".v")
            .iter()
            .chain(&made.paths("wrappers/", ".v"))
        {
            assert!(named.contains(path), "{path} is missing");
        }
        let targets = whole
            .as_mapping_get("targets")
            .and_then(Yaml::as_mapping)
            .expect("targets");
        let names: Vec<&str> = targets.keys().filter_map(Yaml::as_str).collect();
        assert_eq!(names, ["default", "sim", "verilate", "lint", "synth"]);
        for target in targets.values() {
            let top = text_of(target, "toplevel");
            let module = format!("\nmodule {top}");
            assert!(
                made.package.files.iter().any(|f| f.text.contains(&module)),
                "{top}"
            );
            for set in target
                .as_mapping_get("filesets")
                .and_then(Yaml::as_sequence)
                .expect("list")
            {
                assert!(sets.contains_key(set), "{set:?}");
            }
        }
        let synthesis = targets
            .iter()
            .find(|t| t.0.as_str() == Some("synth"))
            .expect("synth")
            .1;
        assert_eq!(text_of(synthesis, "default_tool"), tool);
        let options = synthesis
            .as_mapping_get("tools")
            .and_then(|t| t.as_mapping_get(tool));
        assert!(options.is_some(), "{tool}");
    }
}
