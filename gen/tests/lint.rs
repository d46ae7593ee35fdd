//! Verilator's strictest lint has no remark on any core of the catalogue: in both formats, with every load port, with a
//! reset, and with the example and the bus wrappers around it.

mod common;

use common::{need, silent};
use shadegate_gen::package::{package_with, rtl_with, Options};
use shadegate_gen::scene::catalogue;
use shadegate_gen::stimulus::sample;
use shadegate_gen::vectors::Trace;
use shadegate_gen::wrapper::Wrapper;
use shadegate_hdl::shade::device::Core;
use shadegate_reference::raster::Viewport;
use std::path::Path;

fn lint(folder: &Path, top: &str, files: &[&str]) {
    let flags = ["--lint-only", "-Wall", "--top-module", top];
    silent(folder, "verilator", &[&flags, files].concat());
}

/// The core alone.
fn alone(core: &Core, reset: bool) {
    let rtl = rtl_with(core, reset).expect("emits");
    let folder = tempfile::tempdir().expect("temporary directory");
    let names: Vec<String> = rtl.files.iter().map(|f| f.file_name()).collect();
    for (file, name) in rtl.files.iter().zip(&names) {
        std::fs::write(folder.path().join(name), &file.text).expect("writable");
    }
    let files: Vec<&str> = names.iter().map(String::as_str).collect();
    lint(folder.path(), &format!("{}_core", core.module()), &files);
}

#[test]
fn every_core_in_every_configuration() {
    need("verilator");
    for (_, order) in catalogue() {
        let narrow = Core::for_frame(order, 320, 240).expect("in range");
        let wide = Core::for_frame(order, 1024, 768).expect("in range");
        assert!(wide.wide && !narrow.wide);
        alone(&narrow, true);
        for core in [narrow, wide] {
            for words in Core::LOAD_WORDS {
                if let Ok(core) = core.with_load_words(words) {
                    alone(&core, false);
                }
            }
        }
    }
}

#[test]
fn what_comes_around_every_core() {
    need("verilator");
    let view = Viewport {
        width: 64,
        height: 48,
    };
    for (_, order) in catalogue() {
        let core = Core::for_frame(order, view.width, view.height).expect("in range");
        // Bus wrappers write one word per clock.
        let core = Core {
            load_words: 1,
            ..core
        };
        let stimulus = sample(&core, view, 8, 1).expect("set up");
        let trace = Trace::record(core, &stimulus, |_| true);
        let options = Options {
            target: None,
            wrappers: &Wrapper::ALL,
        };
        let rtl = rtl_with(&core, false).expect("emits");
        let made = package_with(&rtl, &trace, (view.width, view.height), &options).expect("packs");
        let folder = tempfile::tempdir().expect("temporary directory");
        for f in &made.files {
            let path = folder.path().join(&f.path);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
            std::fs::write(path, &f.text).expect("writable");
        }
        let top = format!("{}_core", core.module());
        let paths = made.files.iter().map(|f| f.path.as_str());
        let rtl = paths.filter(|p| p.starts_with("rtl/") && p.ends_with(".v"));
        let rtl: Vec<&str> = rtl.collect();
        let path = |end: &str| format!("wrappers/{top}_{end}.v");
        let parts = [path("host"), path("frames")];
        for (module, more) in [
            ("example", vec![format!("example/{top}_example.v")]),
            ("axi", [&parts[..], &[path("axi")]].concat()),
            ("wishbone", [&parts[..], &[path("wishbone")]].concat()),
        ] {
            let more: Vec<&str> = more.iter().map(String::as_str).collect();
            let files = [&rtl[..], &more].concat();
            lint(folder.path(), &format!("{top}_{module}"), &files);
        }
    }
}
