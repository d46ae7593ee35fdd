//! Every refusal, word for word.

mod common;

use common::Case;
use shadegate_constraints::{device, Binding, Direction, Port};

fn refuse(case: Case, message: &str) {
    assert_eq!(case.run().unwrap_err(), message);
}

fn arty(more: impl IntoIterator<Item = Binding>) -> Case {
    Case::on_board("arty-s7-50", 10.0).bound(more)
}

#[test]
fn bindings_that_cannot_be_are_refused() {
    let new = Binding::new;
    refuse(
        arty([new("strat", "btn0")]),
        "the design has no port 'strat', bound to 'btn0'; did you mean 'start'? it has: clock, reset, start, busy, done, pixel, flags",
    );
    refuse(
        arty([new("start", "btm0")]),
        "board 'arty-s7-50' has no 'btm0'; did you mean 'btn0'? it has: clk100, clk12, reset, \
         btn0, btn1, btn2, btn3, sw0, sw1, sw2, sw3, led0, led1, led2, led3, uart_rx, uart_tx",
    );
    refuse(
        arty([new("flags", "led2")]),
        "port 'flags' is 4 bits wide: say which bit goes to 'led2'",
    );
    refuse(
        arty([Binding::bit("flags", 4, "led2")]),
        "port 'flags' is 4 bits wide, so it has no bit 4",
    );
    refuse(
        arty([new("busy", "led3")]),
        "'busy' is bound twice: to 'led0' and to 'led3'",
    );
    refuse(
        arty([Binding::bit("flags", 1, "led0")]),
        "pin E18 ('led0') is used twice: for 'busy' and for 'flags[1]'",
    );
    refuse(
        arty([new("start", "led3")]),
        "'start' is an input, so it cannot be bound to 'led3', an LED",
    );
    refuse(
        arty([Binding::bit("flags", 0, "sw0")]),
        "'flags[0]' is an output, so it cannot be bound to 'sw0', a switch",
    );
    refuse(
        arty([new("start", "clk12")]),
        "a board clock can be bound to the clock port 'clock' and to nothing else, but 'start' is bound to 'clk12'",
    );
    refuse(
        Case::bare("xc7s50", 10.0).bound([new("busy", "led0")]),
        "port 'busy' is bound to 'led0', but no board is given",
    );
}

#[test]
fn clocks_that_cannot_be_are_refused() {
    for (period, shown) in [
        (0.0, "0"),
        (-1.0, "-1"),
        (f64::NAN, "NaN"),
        (f64::INFINITY, "inf"),
    ] {
        refuse(
            Case::bare("xc7s50", period),
            &format!("the clock period must be between 0.1 and 1000000 ns, not {shown}"),
        );
    }
    let mut slow = Case::on_board("papilio-pro", 31.25);
    slow.period_ns = 40.0;
    refuse(
        slow,
        "board clock 'clk32' ticks every 31.250 ns, which is faster than the 40 ns asked for",
    );
    let mut clock_on_button = arty([]);
    clock_on_button.bindings = vec![Binding::new("clock", "btn0")];
    refuse(
        clock_on_button,
        "a board clock can be bound to the clock port 'clock' and to nothing else, but 'clock' is bound to 'btn0'",
    );
    for name in ["clk", "busy", "pixel"] {
        let mut case = Case::bare("xc7s50", 10.0);
        case.clock_port = name;
        let message = format!("clock port '{name}' is not a one-bit input of the design");
        refuse(case, &message);
    }
}

#[test]
fn designs_that_cannot_be_are_refused() {
    let bare = || Case::bare("xc6slx9", 10.0);
    let mut case = bare();
    case.ports.push(Port::new("busy", 1, Direction::Input));
    refuse(case, "port 'busy' is listed twice");
    let mut case = bare();
    case.ports.push(Port::new("empty", 0, Direction::Input));
    refuse(case, "port 'empty' is 0 bits wide");
    let mut case = bare();
    case.ports.push(Port::new("x\";\nNET", 1, Direction::Input));
    refuse(
        case,
        "port name 'x\";\\nNET' is not a plain Verilog identifier",
    );
    let mut case = bare();
    case.design = "../top";
    refuse(
        case,
        "design name '../top' is not a plain Verilog identifier",
    );
    let mut case = arty([]);
    case.device = device("xc7s25").unwrap();
    refuse(case, "board 'arty-s7-50' carries an xc7s50, not an xc7s25");
}
