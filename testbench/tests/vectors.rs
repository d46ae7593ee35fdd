//! Rung 4: the emitted Verilog equals the integer model on random vectors in every engine, for both cores in
//! both formats: mixed triangles under back pressure, and register noise that describes no triangle at all.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::package::{package, rtl, PackageFile};
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions};
use shadegate_gen::vectors::{Clock, Trace};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::{CoreInputs, Order};
use shadegate_reference::raster::Viewport;
use shadegate_testbench::engine::{run, Engine, Run};

const FRAMES: [(u32, u32); 2] = [(96, 64), (1030, 9)];

fn package_of(trace: &Trace, size: (u32, u32)) -> Vec<PackageFile> {
    package(&rtl(&trace.core).expect("emits"), trace, size, None)
        .expect("packs")
        .files
}

fn run_on(engine: Engine, trace: &Trace, files: &[PackageFile]) -> Run {
    let scratch = tempfile::tempdir().expect("temporary directory");
    run(engine, trace, files, scratch.path(), None).unwrap_or_else(|e| panic!("{e}"))
}

fn agree(trace: &Trace, size: (u32, u32)) {
    let files = package_of(trace, size);
    for engine in Engine::ALL {
        let r = run_on(engine, trace, &files);
        assert_eq!(
            (r.mismatches, r.cycles),
            (0, trace.clocks.len() as u64),
            "{engine}: {:?}",
            r.first
        );
    }
}

fn triangles(order: Order, (width, height): (u32, u32)) -> Trace {
    let viewport = Viewport { width, height };
    let core = Core::for_frame(order, width, height).expect("in range");
    let t = sample_triangles(order, viewport, 600, 7);
    let stimulus = build(&core, &t, viewport, &StimulusOptions::default()).expect("in range");
    let mut r = StdRng::seed_from_u64(8);
    // Long stalls, single stalls, none.
    let mut phase = 0;
    Trace::record(core, &stimulus, move |clock| {
        if clock % 500 == 0 {
            phase = r.random_range(0..3);
        }
        match phase {
            0 => true,
            1 => r.random_ratio(3, 4),
            _ => r.random_ratio(1, 5),
        }
    })
}

fn noise(order: Order, (width, height): (u32, u32), clocks: usize) -> Trace {
    let core = Core::for_frame(order, width, height).expect("in range");
    let mut r = StdRng::seed_from_u64(9);
    let mut model = core.model();
    let mut trace = Trace {
        core,
        clocks: vec![],
        pixels: vec![],
        cycles: 0,
        spent: Default::default(),
        writes: 0,
    };
    for clock in 0..clocks {
        let select: u8 = if r.random() {
            r.random_range(0..12)
        } else {
            r.random()
        };
        let rows = r.random_range(0..9u64);
        let inputs = CoreInputs {
            write: r.random_ratio(15, 16),
            select,
            // Few rows, or every triangle would take a million clocks.
            data: if select == 0 {
                r.random_range(0..2u64) << 22 | rows << 11 | rows
            } else {
                r.random()
            },
            start: r.random_ratio(1, 30),
            clear: clock > clocks / 2 && r.random_ratio(1, 2000),
            ready: r.random_ratio(7, 8),
            ..CoreInputs::default()
        };
        model.clock(&inputs);
        trace.clocks.push(Clock {
            inputs,
            outputs: model.outputs(),
        });
    }
    trace
}

#[test]
fn triangles_under_back_pressure() {
    for order in [Order::Quadratic, Order::Linear] {
        for size in FRAMES {
            let trace = triangles(order, size);
            assert!(trace.pixels.len() > 3_000, "{} pixels", trace.pixels.len());
            agree(&trace, size);
        }
    }
}

#[test]
fn register_noise() {
    for order in [Order::Quadratic, Order::Linear] {
        for size in FRAMES {
            let trace = noise(order, size, 40_000);
            agree(&trace, size);
        }
    }
}

/// A test that cannot fail proves nothing: a defect in one register of one channel is found and named.
#[test]
fn a_broken_adder_is_found_and_named() {
    let trace = triangles(Order::Quadratic, FRAMES[0]);
    let mut files = package_of(&trace, FRAMES[0]);
    let file = files
        .iter_mut()
        .find(|f| f.path == "rtl/quadratic_1_q11_20.v")
        .expect("emitted");
    let broken = file
        .text
        .replace("total <= total + first;", "total <= total - first;");
    assert_ne!(file.text, broken);
    file.text = broken;
    let r = run_on(Engine::Icarus, &trace, &files);
    let first = r.first.expect("found");
    assert!(
        r.mismatches > 0 && ["red", "green", "blue"].contains(&first.signal.as_str()),
        "{first:?}"
    );
    let clock = &trace.clocks[first.cycle as usize];
    assert_eq!(
        (first.x, first.y),
        (u32::from(clock.outputs.x), u32::from(clock.outputs.y))
    );
    assert_ne!(first.expected, first.got);
    // The others say the same of it.
    for engine in [Engine::Verilator, Engine::Cxxrtl] {
        let other = run_on(engine, &trace, &files);
        assert_eq!(
            (other.mismatches, other.first),
            (r.mismatches, Some(first.clone()))
        );
    }
}

#[test]
fn waveforms_of_a_window() {
    use shadegate_testbench::engine::Wave;
    let trace = triangles(Order::Linear, FRAMES[0]);
    let files = package_of(&trace, FRAMES[0]);
    for engine in [
        Engine::RustHdl,
        Engine::Compiled,
        Engine::Icarus,
        Engine::Cxxrtl,
    ] {
        let scratch = tempfile::tempdir().expect("temporary directory");
        let wave = Wave {
            file: scratch.path().join("window.vcd"),
            from: 100,
            to: 200,
            signals: vec![],
        };
        run(engine, &trace, &files, scratch.path(), Some(&wave)).unwrap_or_else(|e| panic!("{e}"));
        let text = std::fs::read_to_string(&wave.file).expect("written");
        assert!(
            text.contains("$enddefinitions") && text.contains("load_ready"),
            "{engine}"
        );
        let stamps = text.lines().filter(|l| l.starts_with('#')).count();
        assert!(stamps >= 90, "{engine}: {stamps} time stamps");
    }
    let scratch = tempfile::tempdir().expect("temporary directory");
    let wave = Wave {
        file: scratch.path().join("window.vcd"),
        from: 10_000_000,
        to: 10_000_001,
        signals: vec![],
    };
    for engine in [Engine::RustHdl, Engine::Compiled, Engine::Cxxrtl] {
        let e =
            run(engine, &trace, &files, scratch.path(), Some(&wave)).expect_err("nothing to show");
        let want = format!(
            "engine {engine} has no clock to show from 10000000 on: the run has {} clocks",
            trace.clocks.len()
        );
        assert_eq!(e.to_string(), want);
        assert!(!wave.file.exists());
    }
}
