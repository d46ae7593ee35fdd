//! `cosim` and `gen`: what comes out of a run, and what happens without the tools.

mod common;

use common::{keys, Folder};

#[test]
fn every_pixel_of_a_small_scene() {
    let f = Folder::new();
    let r = f.json("cosim ball.toml --size 24x16", 0);
    for key in [
        "scene",
        "method",
        "core",
        "engine",
        "cycles",
        "pixels",
        "pixels_per_cycle",
        "cycles_per_second",
        "mismatches",
        "first_mismatch",
        "error",
        "formats",
        "time_ns",
    ] {
        assert!(keys(&r).contains(&key), "{key}");
    }
    assert_eq!(
        (&r["method"], &r["core"]),
        (&"quadratic".into(), &"quadratic".into())
    );
    assert_eq!(
        (&r["engine"], &r["mismatches"]),
        (&"compiled".into(), &0.into())
    );
    assert!(r["pixels"].as_u64() > Some(0) && r["first_mismatch"].is_null());
    assert_eq!(
        keys(&r["error"]),
        ["flip_mean", "max_lsb", "psnr_db", "rms_lsb"]
    );
    for key in ["setup", "emit", "simulate", "compare"] {
        assert!(r["time_ns"][key].is_u64(), "{key}");
    }
    assert_eq!(
        f.names(),
        ["ball.toml", "out"],
        "results go to ./out unless told otherwise"
    );
    let r = f.json("cosim ball.toml --size 24x16 --core gouraud", 0);
    assert_eq!(
        (&r["method"], &r["mismatches"]),
        (&"gouraud".into(), &0.into())
    );
}

#[test]
fn a_run_leaves_frames_verilog_reports_and_a_waveform() {
    let f = Folder::new();
    let done = f
        .run("cosim ball.toml --size 24x16 -o out --wave w.vcd --from 5 --to 40")
        .code(0)
        .stderr("");
    let text = String::from_utf8(done.get_output().stdout.clone()).unwrap();
    assert!(
        text.starts_with("ball: 24x16, quadratic core, compiled\nno mismatch in "),
        "{text}"
    );
    assert!(text.ends_with("\nwrote w.vcd\nwrote out\n"), "{text}");
    for file in [
        "expected.png",
        "simulated.png",
        "difference.png",
        "report.json",
        "report.html",
    ] {
        assert!(f.0.path().join("out").join(file).is_file(), "{file}");
    }
    assert!(f.0.path().join("out/core/rtl/quadratic_core.v").is_file());
    f.run("compare out/expected.png out/simulated.png -q")
        .code(0);
}

#[test]
fn a_missing_tool_is_named() {
    let f = Folder::new();
    let none = f.0.path().join("empty");
    std::fs::create_dir(&none).unwrap();
    for (engine, tool) in [
        ("icarus", "iverilog"),
        ("verilator", "verilator"),
        ("cxxrtl", "yosys"),
    ] {
        let message = format!(
            "engine {engine}: `{tool}` is not installed; install it with `apt-get install {tool}`"
        );
        let arguments = format!("cosim ball.toml --size 24x16 --engine {engine}");
        let line = format!("error: {message}\n");
        f.shadegate(&arguments)
            .env("PATH", &none)
            .assert()
            .code(3)
            .stdout("")
            .stderr(line.clone());
        let json = serde_json::json!({ "error": message, "exit": 3 });
        f.shadegate(&format!("{arguments} --json"))
            .env("PATH", &none)
            .assert()
            .code(3)
            .stdout(format!("{json}\n"))
            .stderr(line);
    }
}

#[test]
fn packages() {
    let f = Folder::new();
    let m = f.json("gen gouraud --size 32x24 --board arty-s7-50 --period 20", 0);
    for key in [
        "core",
        "target",
        "files",
        "ports",
        "formats",
        "latency",
        "error_bound_lsb",
        "output",
    ] {
        assert!(keys(&m).contains(&key), "{key}");
    }
    assert_eq!(
        (&m["core"], &m["target"]),
        (&"gouraud".into(), &"xc7s50csga324-1".into())
    );
    assert_eq!(
        (&m["board"], &m["output"]),
        (&"arty-s7-50".into(), &"gouraud-core".into())
    );
    for file in m["files"].as_array().unwrap() {
        assert!(
            f.0.path()
                .join("gouraud-core")
                .join(file.as_str().unwrap())
                .is_file(),
            "{file}"
        );
    }
    let xdc = std::fs::read_to_string(f.0.path().join("gouraud-core/constraints/gouraud_core.xdc"))
        .unwrap();
    assert!(xdc.contains("-period 20.000"), "{xdc}");

    let done = f
        .run("gen --scene ball.toml --target xc6slx9 -o here -v")
        .code(0)
        .stderr("");
    let text = String::from_utf8(done.get_output().stdout.clone()).unwrap();
    assert!(
        text.starts_with("quadratic core, 48x32, xc6slx9-2-tqg144\nformats    colour Q11.20,"),
        "{text}"
    );
    assert!(
        text.contains("  constraints/quadratic_core.ucf\n"),
        "{text}"
    );
    assert!(text.ends_with("files to here\n"), "{text}");
    f.run("gen --scene ball.toml -q")
        .code(0)
        .stdout("")
        .stderr("");
    assert_eq!(
        f.names(),
        ["ball-quadratic-core", "ball.toml", "gouraud-core", "here"]
    );
}

#[test]
fn packages_with_wrappers() {
    let f = Folder::new();
    let there = f.0.path().join("here");
    std::fs::create_dir(&there).unwrap();
    f.write("here/notes.txt", "mine");
    let arguments =
        "gen gouraud --size 32x24 --board ulx3s-25f --wrapper wishbone,axi --wrapper axi -o here";
    let m = f.json(arguments, 0);
    assert_eq!(
        m["wrappers"]["names"],
        serde_json::json!(["axi", "wishbone"])
    );
    assert_eq!(m["target"], "LFE5U-25F-6BG381C");
    let files: Vec<&str> = (m["files"].as_array().unwrap().iter())
        .filter_map(|f| f.as_str())
        .collect();
    for path in [
        "README.md",
        "constraints/gouraud_core.lpf",
        "doc/timing.svg",
        "example/gouraud_core_example.v",
        "gouraud_core.core",
        "sim/tb_gouraud_core_axi.v",
        "sim/tb_gouraud_core_wishbone.v",
        "wrappers/gouraud_core_axi.v",
        "wrappers/gouraud_core_wishbone.v",
    ] {
        assert!(files.contains(&path), "{path}");
    }
    let read = |path: &str| std::fs::read(there.join(path)).unwrap();
    let first: Vec<Vec<u8>> = files.iter().map(|path| read(path)).collect();
    assert_eq!(f.json(arguments, 0), m);
    let second: Vec<Vec<u8>> = files.iter().map(|path| read(path)).collect();
    assert!(first == second, "not the same bytes again");
    assert_eq!(read("notes.txt"), b"mine");

    let plain = f.json("gen gouraud --size 32x24 -o plain", 0);
    assert!(plain["wrappers"].is_null() && plain["resources"]["measured"].is_null());
    f.refuses(
        "gen gouraud --wrapper axi,pci",
        "unknown wrapper 'pci'; expected axi or wishbone",
    );
}
