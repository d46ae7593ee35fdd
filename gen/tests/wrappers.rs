//! Wrappers: a frame through the bus gives the pixels of the vector file, whatever the waits; and the benches notice
//! when it does not.

mod common;

use common::{make, need, run, Made};
use shadegate_gen::package::PackageFile;
use shadegate_gen::wrapper::{map, Wrapper};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;

/// What a wrapper's bench says, with these changes made to the package's files (path ending, old text, new text).
fn bench(made: &Made, wrapper: Wrapper, seed: u32, changes: &[(&str, &str, &str)]) -> String {
    let directory = made.unpacked();
    for (ending, old, new) in changes {
        let file = made.package.files.iter().find(|f| f.path.ends_with(ending));
        let PackageFile { path, text } = file.expect("file");
        assert!(text.contains(old), "{path} has no `{old}`");
        std::fs::write(directory.path().join(path), text.replacen(old, new, 1)).unwrap();
    }
    let top = &made.package.manifest.top;
    let bench = format!("sim/tb_{top}_{wrapper}.v");
    let parts = [
        format!("wrappers/{top}_host.v"),
        format!("wrappers/{top}_frames.v"),
        format!("wrappers/{top}_{wrapper}.v"),
    ];
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    let flags = ["-g2001", "-o", "bench"];
    let arguments = [&flags, &made.paths("rtl/", ".v")[..], &parts, &[&bench]].concat();
    let (done, said) = run(directory.path(), "iverilog", &arguments);
    assert!(done, "{said}");
    let seed = format!("+seed={seed}");
    run(
        directory.path(),
        "vvp",
        &["-N", "bench", "+vectors=sim/vectors.txt", &seed],
    )
    .1
}

#[test]
fn a_frame_through_each_bus_gives_the_pixels_of_the_vectors() {
    need("iverilog");
    for (order, width, height) in [
        (Order::Linear, 64, 48),
        (Order::Quadratic, 64, 48),
        (Order::Quadratic, 32, 510),
        (Order::Linear, 2, 1),
        (Order::Span(SpanKind::Slerp), 40, 30),
    ] {
        let made = make(order, width, height, None, &Wrapper::ALL);
        for wrapper in Wrapper::ALL {
            for seed in [1, 7] {
                let said = bench(&made, wrapper, seed, &[]);
                let pixels = format!(" pixels={} ", made.trace.pixels.len());
                let passed = said
                    .lines()
                    .any(|l| l.starts_with("PASS") && l.contains(&pixels));
                assert!(
                    passed,
                    "{order:?} {width}x{height} {wrapper} {seed}: {said}"
                );
            }
        }
    }
}

#[test]
fn benches_notice_what_is_wrong() {
    need("iverilog");
    let made = make(Order::Quadratic, 32, 510, None, &Wrapper::ALL);
    assert_eq!(made.core.bus_bits(), 36);
    let changes = [
        // The upper bits never reach the core.
        (
            "_host.v",
            "assign data = {high, write_data}",
            "assign data = {4'd0, write_data}",
        ),
        // Words are not waited for.
        ("_host.v", "is_word ? load_ready", "is_word ? 1'b1"),
        // A clear does not wait.
        (
            "_host.v",
            "wire may_clear = !busy && !ending;",
            "wire may_clear = 1'b1;",
        ),
        // A write of some bytes passes.
        (
            "_host.v",
            "assign write_error = !write_whole || ",
            "assign write_error = ",
        ),
        // The mark comes without the core being idle.
        (
            "_frames.v",
            "is_ending && !busy && free",
            "is_ending && free",
        ),
        // Back pressure is not heard.
        (
            "_frames.v",
            "wire free = !out_valid || pixel_ready;",
            "wire free = 1'b1;",
        ),
        // Red and green change places.
        (
            "_frames.v",
            "{depth, blue, green, red, y, x}",
            "{depth, blue, red, green, y, x}",
        ),
        // No word for a frame without pixels.
        ("_frames.v", "out_keep <= held;", "out_keep <= 1'b1;"),
    ];
    for change in changes {
        for wrapper in Wrapper::ALL {
            let said = bench(&made, wrapper, 1, &[change]);
            assert!(said.contains("FAIL"), "{wrapper}, {change:?}: {said}");
            assert!(!said.contains("PASS"), "{wrapper}, {change:?}: {said}");
        }
    }
}

#[test]
fn names_are_read_and_wrong_ones_refused_in_one_line() {
    for w in Wrapper::ALL {
        assert_eq!(w.name().parse(), Ok(w));
    }
    let refused = "ax\ni".parse::<Wrapper>().unwrap_err().to_string();
    assert_eq!(
        refused,
        "unknown wrapper 'ax\\ni'; expected axi or wishbone"
    );
}

#[test]
fn order_and_repetition_of_the_wish_do_not_matter() {
    let both = make(Order::Linear, 16, 12, None, &Wrapper::ALL);
    let again = make(
        Order::Linear,
        16,
        12,
        None,
        &[Wrapper::Wishbone, Wrapper::Axi, Wrapper::Wishbone],
    );
    assert_eq!(both.package.files, again.package.files);
}

#[test]
fn the_map_says_where_the_upper_bits_go() {
    let wide = Core::for_frame(Order::Quadratic, 640, 480).unwrap();
    let high = &map::entries(wide.bus_bits())[1];
    assert!(
        high.meaning.starts_with("bits 35 to 32 of every word"),
        "{}",
        high.meaning
    );
    assert!(map::entries(32)[1].meaning.starts_with("no bits"));
    let mut next = 0;
    for e in map::entries(36) {
        assert_eq!(e.address, next, "{}", e.name);
        next = e.last + 4;
    }
    assert!(next <= 1 << map::ADDRESS_BITS);
}
