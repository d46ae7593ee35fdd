//! Whole files, compared with text written down beside this test.

mod common;

use common::{ports, Case};
use shadegate_constraints::{board, default_bindings, Binding, Direction, Port};

/// Compares with the text written down; with `SHADEGATE_BLESS` set, writes it down instead.
fn expect(case: &Case, expected_name: &str, file_name: &str, expected: &str) {
    let file = case.run().unwrap();
    assert_eq!(file.name, file_name);
    assert_eq!(case.run().unwrap(), file, "not the same twice");
    if std::env::var_os("SHADEGATE_BLESS").is_some() {
        let dir = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/expected/");
        std::fs::write(format!("{dir}{expected_name}"), &file.text).unwrap();
        return;
    }
    assert_eq!(file.text, expected, "{expected_name}");
}

macro_rules! expect {
    ($case:expr, $expected:literal, $file:literal) => {
        expect(
            &$case,
            $expected,
            $file,
            include_str!(concat!("expected/", $expected)),
        )
    };
}

#[test]
fn ucf_of_a_board() {
    let case = Case::on_board("mimas-v2", 10.0).bound([
        Binding::bit("flags", 2, "led4"),
        Binding::new("start", "btn0"),
    ]);
    expect!(case, "mimas-v2.ucf", "quadratic.ucf");
}

#[test]
fn ucf_of_a_board_with_one_led_and_forbidden_pins() {
    expect!(
        Case::on_board("papilio-pro", 31.25),
        "papilio-pro.ucf",
        "quadratic.ucf"
    );
}

#[test]
fn ucf_of_a_bare_device() {
    expect!(Case::bare("xc2s100e", 20.0), "xc2s100e.ucf", "gouraud.ucf");
}

#[test]
fn xdc_of_a_board() {
    let case = Case::on_board("arty-s7-50", 10.0).bound([
        Binding::new("reset", "btn3"),
        Binding::bit("flags", 3, "led3"),
        Binding::bit("flags", 0, "led2"),
    ]);
    expect!(case, "arty-s7-50.xdc", "quadratic.xdc");
}

#[test]
fn xdc_of_a_bare_device_with_too_few_pins() {
    let mut case = Case::bare("xc7s15", 1000.0 / 150.0);
    case.ports.push(Port::new("setup", 128, Direction::Input));
    expect!(case, "xc7s15.xdc", "gouraud.xdc");
}

#[test]
fn xdc_with_every_port_placed() {
    let mut case = Case::on_board("cmod-s7", 50.0);
    case.ports
        .retain(|p| ["clock", "busy", "done"].contains(&p.name.as_str()));
    expect!(case, "cmod-s7.xdc", "quadratic.xdc");
}

#[test]
fn pcf_of_a_board() {
    let case = Case::on_board("icebreaker", 1e9 / 12e6).bound([Binding::new("start", "btn0")]);
    expect!(case, "icebreaker.pcf", "quadratic.pcf");
}

#[test]
fn lpf_of_a_board() {
    let case = Case::on_board("ulx3s-25f", 40.0).bound([
        Binding::new("start", "btn1"),
        Binding::new("reset", "btn0"),
        Binding::bit("flags", 1, "led5"),
    ]);
    expect!(case, "ulx3s-25f.lpf", "quadratic.lpf");
}

#[test]
fn frequencies_are_written_in_whole_kilohertz_rounded_up() {
    for (device, period, text) in [
        ("ice40up5k", 1e9 / 12e6, "set_frequency clock 12.000\n"),
        ("ice40up5k", 30.0, "set_frequency clock 33.334\n"),
        ("lfe5u-25f", 40.0, "FREQUENCY PORT \"clock\" 25.000 MHZ;\n"),
        ("lfe5u-25f", 7.0, "FREQUENCY PORT \"clock\" 142.858 MHZ;\n"),
    ] {
        let file = Case::bare(device, period).run().unwrap();
        assert!(file.text.contains(text), "{device} {period}: {}", file.text);
    }
}

#[test]
fn a_clock_that_no_board_clock_can_be_is_left_over_with_a_word() {
    expect!(
        Case::on_board("mojo-v3", 40.0),
        "mojo-v3.ucf",
        "quadratic.ucf"
    );
}

#[test]
fn periods_are_written_in_whole_picoseconds_rounded_down() {
    for (period, text) in [
        (2.3, "2.300"),
        (1e9 / 12e6, "83.333"),
        (0.1, "0.100"),
        (7.0, "7.000"),
    ] {
        let file = Case::bare("xc7s50", period).run().unwrap();
        assert!(file.text.contains(&format!("-period {text} ")), "{period}");
    }
}

#[test]
fn default_bindings_take_a_clock_slow_enough_and_the_leds_there_are() {
    let of = |name: &str, period| -> Vec<(String, String)> {
        default_bindings(board(name).unwrap(), &ports(), "clock", period)
            .into_iter()
            .map(|b| (b.port, b.resource))
            .collect()
    };
    let pairs = |p: &[(&str, &str)]| -> Vec<(String, String)> {
        p.iter()
            .map(|(a, b)| (a.to_string(), b.to_string()))
            .collect()
    };
    let leds = [("busy", "led0"), ("done", "led1")];
    assert_eq!(
        of("arty-s7-50", 10.0),
        pairs(&[("clock", "clk100"), leds[0], leds[1]])
    );
    assert_eq!(
        of("arty-s7-50", 12.5),
        pairs(&[("clock", "clk12"), leds[0], leds[1]])
    );
    assert_eq!(of("arty-s7-50", 100.0), pairs(&leds));
    assert_eq!(
        of("papilio-pro", 20.0),
        pairs(&[("clock", "clk32"), leds[0]])
    );
    assert_eq!(of("arty-s7-50", f64::NAN), pairs(&leds));
    let wide = [
        Port::new("busy", 2, Direction::Output),
        Port::new("done", 1, Direction::Input),
    ];
    assert!(default_bindings(board("mojo-v3").unwrap(), &wide, "clock", 20.0).is_empty());
}
