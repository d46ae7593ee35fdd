//! The data files: complete, consistent with themselves, and nothing used twice.

use shadegate_constraints::{
    board, boards, device, devices, Board, Device, Format, PackageShape, Pull, Resource,
    ResourceKind,
};
use std::collections::BTreeSet;

fn unique<'a>(names: impl Iterator<Item = &'a str>, of: &str) {
    let mut seen = BTreeSet::new();
    for name in names {
        assert!(seen.insert(name), "{of}: '{name}' twice");
    }
}

fn device_of(board: &Board) -> &'static Device {
    device(&board.device).unwrap()
}

#[test]
fn names_are_unique() {
    unique(devices().iter().map(|d| d.name.as_str()), "devices");
    unique(boards().iter().map(|b| b.name.as_str()), "boards");
    for board in boards() {
        unique(board.resources.iter().map(|r| r.name.as_str()), &board.name);
    }
    for device in devices() {
        unique(
            device.packages.iter().map(|p| p.name.as_str()),
            &device.name,
        );
    }
}

#[test]
fn capacities_follow_from_the_slices() {
    for d in devices() {
        let (luts, flip_flops) = match (d.lut_inputs, d.constraints) {
            (4, Format::Pcf) => (8, 8),
            (4, _) => (2, 2),
            (6, _) => (4, 8),
            (n, _) => panic!("{}: {n}-input LUTs", d.name),
        };
        assert_eq!(d.luts, luts * d.slices, "{} LUTs", d.name);
        assert_eq!(d.flip_flops, flip_flops * d.slices, "{} flip-flops", d.name);
        assert_eq!(d.multipliers > 0, d.multiplier_bits[0] > 0, "{}", d.name);
    }
}

/// Totals as the data sheets print them, independently of the data file's block counts.
#[test]
fn block_ram_totals_are_the_data_sheets() {
    let expected = [
        ("xc2s100e", 40),
        ("xc3s200", 216),
        ("xc3s500e", 360),
        ("xc6slx9", 576),
        ("xc6slx16", 576),
        ("xc7s15", 360),
        ("xc7s25", 1620),
        ("xc7s50", 2700),
        ("ice40up5k", 120),
        ("lfe5u-25f", 1008),
    ];
    assert_eq!(devices().len(), expected.len());
    for (name, kbit) in expected {
        assert_eq!(device(name).unwrap().block_ram_total_kbit(), kbit, "{name}");
    }
}

#[test]
fn families_tools_and_formats_go_together() {
    for d in devices() {
        let (yosys, format) = match d.family.as_str() {
            "spartan-2e" => ("xcve", Format::Ucf),
            "spartan-3" => ("xc3s", Format::Ucf),
            "spartan-3e" => ("xc3se", Format::Ucf),
            "spartan-6" => ("xc6s", Format::Ucf),
            "spartan-7" => ("xc7", Format::Xdc),
            "ice40-ultraplus" => ("ice40", Format::Pcf),
            "ecp5" => ("ecp5", Format::Lpf),
            other => panic!("{}: family {other}", d.name),
        };
        assert_eq!(d.yosys_family, yosys, "{}", d.name);
        assert_eq!(d.constraints, format, "{}", d.name);
        let tool = match format {
            Format::Ucf => "ISE",
            Format::Xdc => "Vivado",
            Format::Pcf => "nextpnr-ice40",
            Format::Lpf => "nextpnr-ecp5",
        };
        assert!(d.vendor_tool.starts_with(tool), "{}", d.name);
        assert!(d.package_named(&d.package).is_some(), "{}", d.name);
        assert!(!d.source.is_empty());
        for p in &d.packages {
            assert!(p.user_io > 0 && p.user_io < p.pins, "{} {}", d.name, p.name);
            let digits = p.name.trim_start_matches(|c: char| c.is_ascii_alphabetic());
            assert_eq!(digits, p.pins.to_string(), "{} {}", d.name, p.name);
        }
    }
}

#[test]
fn parts_are_spelt_as_their_tools_want() {
    assert_eq!(device("xc2s100e").unwrap().part(), "xc2s100e-6-tq144");
    assert_eq!(device("xc6slx9").unwrap().part(), "xc6slx9-2-tqg144");
    assert_eq!(device("xc7s50").unwrap().part(), "xc7s50csga324-1");
    assert_eq!(device("ice40up5k").unwrap().part(), "ICE40UP5K-SG48I");
    assert_eq!(device("lfe5u-25f").unwrap().part(), "LFE5U-25F-6BG381C");
    assert_eq!(
        device("xc6slx9").unwrap().part_in("csg324", 3),
        "xc6slx9-3-csg324"
    );
}

#[test]
fn boards_fit_their_devices() {
    for b in boards() {
        let package = device_of(b).package_named(&b.package);
        let package = package.unwrap_or_else(|| panic!("{}: package {}", b.name, b.package));
        unique(
            (b.resources.iter().map(|r| r.pin.as_str()))
                .chain(b.prohibit.iter().map(|p| p.as_str())),
            &b.name,
        );
        for pin in b.resources.iter().map(|r| &r.pin).chain(&b.prohibit) {
            assert!(package.accepts_pin(pin), "{}: pin {pin}", b.name);
        }
        assert!(b.resources.len() as u32 <= package.user_io);
        assert!(!b.source.is_empty());
        assert!(b.of_kind(ResourceKind::Led).count() > 0, "{}", b.name);
        assert!(b.of_kind(ResourceKind::Clock).count() > 0, "{}", b.name);
        for r in &b.resources {
            let is_clock = r.kind == ResourceKind::Clock;
            assert_eq!(r.hz.is_some(), is_clock, "{} {}", b.name, r.name);
            assert!(r.drive.is_none() || !r.kind.drives_fpga(), "{}", r.name);
            assert!(r.pull.is_none() || r.kind.drives_fpga(), "{}", r.name);
        }
        match device_of(b).constraints {
            Format::Ucf => assert!(b.config_voltage.is_none() && b.internal_vref.is_empty()),
            Format::Xdc => assert!(b.vccaux.is_none() && b.prohibit.is_empty()),
            // Their files say nothing of these, and PCF has no pull-down.
            Format::Pcf | Format::Lpf => {
                assert!(b.config_voltage.is_none() && b.internal_vref.is_empty());
                assert!(b.vccaux.is_none() && b.prohibit.is_empty());
                let down = |r: &Resource| r.pull == Some(Pull::Down);
                let pcf = device_of(b).constraints == Format::Pcf;
                assert!(!pcf || !b.resources.iter().any(down), "{}", b.name);
            }
        }
    }
}

#[test]
fn pins_are_checked_by_package() {
    let quad = device("xc6slx9").unwrap().package_named("tqg144").unwrap();
    assert_eq!(quad.shape, PackageShape::Quad);
    for (pin, ok) in [("P1", true), ("P144", true), ("P145", false), ("P0", false)] {
        assert_eq!(quad.accepts_pin(pin), ok, "{pin}");
    }
    for pin in ["", "P", "A1", "P01", "1", "P1x", "PP1", "P99999999999"] {
        assert!(!quad.accepts_pin(pin), "{pin}");
    }
    let grid = device("xc7s50").unwrap().package_named("csga324").unwrap();
    for (pin, ok) in [("A1", true), ("V18", true), ("W1", false), ("A19", false)] {
        assert_eq!(grid.accepts_pin(pin), ok, "{pin}");
    }
    for pin in ["I1", "O2", "Q3", "S4", "", "A", "a1", "A1 ", "é1"] {
        assert!(!grid.accepts_pin(pin), "{pin}");
    }
    let numbered = device("ice40up5k").unwrap().package_named("sg48").unwrap();
    for (pin, ok) in [
        ("1", true),
        ("48", true),
        ("49", false),
        ("0", false),
        ("P1", false),
        ("A1", false),
    ] {
        assert_eq!(numbered.accepts_pin(pin), ok, "{pin}");
    }
    let big = device("xc7s50").unwrap().package_named("fgga484").unwrap();
    assert!(big.accepts_pin("AB22") && !big.accepts_pin("AC1") && big.accepts_pin("Y1"));
}

#[test]
fn unknown_names_are_answered_with_the_nearest() {
    let known = "xc2s100e, xc3s200, xc3s500e, xc6slx9, xc6slx16, xc7s15, xc7s25, xc7s50, ice40up5k, lfe5u-25f";
    let text = |name: &str| device(name).unwrap_err().to_string();
    assert_eq!(
        text("xc7s26"),
        format!("unknown device 'xc7s26'; did you mean 'xc7s25'? known: {known}")
    );
    assert_eq!(
        text("ep4\nce22"),
        format!("unknown device 'ep4\\nce22'; known: {known}")
    );
    let known = "papilio-pro, mojo-v3, mimas-v2, arty-s7-50, cmod-s7, icebreaker, ulx3s-25f";
    assert_eq!(
        board("de10").unwrap_err().to_string(),
        format!("unknown board 'de10'; known: {known}")
    );
    assert_eq!(
        board("mojo").unwrap_err().suggestion.as_deref(),
        Some("mojo-v3")
    );
    assert_eq!(
        board("Arty-S7").unwrap_err().suggestion.as_deref(),
        Some("arty-s7-50")
    );
    assert_eq!(device("XC7S50").unwrap().name, "xc7s50");
}
