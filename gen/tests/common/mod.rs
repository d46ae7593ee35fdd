//! Helpers of the generator's tests.

// Every test file takes what it needs.
#![allow(dead_code)]

use shadegate_constraints::{board, device};
use shadegate_gen::package::{package_with, rtl_with, Options, Package, Target};
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;
use std::path::Path;
use std::process::Command;

/// Fails with the command that installs the tool, if it is missing: tests never skip silently.
pub fn need(tool: &str) {
    let found = Command::new(tool).arg("--version").output().is_ok()
        || Command::new(tool).arg("-V").output().is_ok();
    assert!(found, "`{tool}` is needed by this test: apt-get install iverilog verilator yosys tcl (scripts/test does it)");
}

/// A package and the run it was made from.
pub struct Made {
    pub core: Core,
    pub trace: Trace,
    pub package: Package,
}

impl Made {
    /// The text of a file.
    pub fn text(&self, path: &str) -> &str {
        let file = self.package.files.iter().find(|f| f.path == path);
        &file.unwrap_or_else(|| panic!("no {path}")).text
    }

    /// Paths of the files in a folder with an ending.
    pub fn paths(&self, folder: &str, ending: &str) -> Vec<&str> {
        let paths = self.package.files.iter().map(|f| f.path.as_str());
        paths
            .filter(|p| p.starts_with(folder) && p.ends_with(ending))
            .collect()
    }

    /// The package in a fresh directory that holds nothing else.
    pub fn unpacked(&self) -> tempfile::TempDir {
        let directory = tempfile::tempdir().expect("temporary directory");
        for f in &self.package.files {
            shadegate_gen::write::write_file(&directory.path().join(&f.path), f.text.as_bytes())
                .expect("writable");
        }
        directory
    }
}

/// Makes a package with sample vectors; `place` is a board or a device.
pub fn make(
    order: Order,
    width: u32,
    height: u32,
    place: Option<&str>,
    wrappers: &[Wrapper],
) -> Made {
    make_with(order, (width, height), place, wrappers, false)
}

/// The same, with a synchronous reset if that is wanted.
pub fn make_with(
    order: Order,
    (width, height): (u32, u32),
    place: Option<&str>,
    wrappers: &[Wrapper],
    reset: bool,
) -> Made {
    let core = Core::for_frame(order, width, height).expect("in range");
    // A bus writes one word at a time.
    let words = if wrappers.is_empty() {
        core.load_words
    } else {
        1
    };
    let core = core.with_load_words(words).expect("a port");
    let viewport = Viewport { width, height };
    let triangles = sample_triangles(order, viewport, 20, 1);
    let stimulus =
        build(&core, &triangles, viewport, &StimulusOptions::default()).expect("in range");
    let trace = Trace::record(core, &stimulus, |_| true);
    let board = place.and_then(|p| board(p).ok());
    let name = board.map(|b| b.device.as_str()).or(place);
    let target = name.map(|name| Target {
        device: device(name).expect("known"),
        board,
        period_ns: 20.0,
    });
    let options = Options { target, wrappers };
    let rtl = rtl_with(&core, reset).expect("emits");
    let package = package_with(&rtl, &trace, (width, height), &options).expect("packs");
    Made {
        core,
        trace,
        package,
    }
}

/// Runs a tool to its end: whether it succeeded, and what it said.
pub fn run(directory: &Path, tool: &str, arguments: &[&str]) -> (bool, String) {
    let out = Command::new(tool)
        .current_dir(directory)
        .args(arguments)
        .output()
        .unwrap_or_else(|e| panic!("{tool}: {e}"));
    let said =
        String::from_utf8_lossy(&out.stdout).to_string() + &String::from_utf8_lossy(&out.stderr);
    (out.status.success(), said)
}

/// Runs a tool; it must succeed and say nothing.
pub fn silent(directory: &Path, tool: &str, arguments: &[&str]) {
    let (done, said) = run(directory, tool, arguments);
    assert!(
        done && said.trim().is_empty(),
        "{tool} {arguments:?}: {said}"
    );
}
