//! Designs that are refused, and names that do not exist, word for word.

use super::build::*;
use shadegate_gen::compile::Simulator;
use shadegate_gen::netlist::{
    elaborate, Bits, Expression, Format, Memory, Module, Node, ReadPort, SignalKind, Statement,
};

const BYTE: Format = Format::Unsigned(8);

fn refusal(m: &Module) -> String {
    let e = elaborate(m).expect_err("refused");
    let same = Simulator::new(m).err().expect("refused");
    assert_eq!(e, same);
    e.to_string()
}

/// Passes its input through.
fn through() -> Module {
    let mut m = module("through");
    signal(&mut m, "into", SignalKind::Input, BYTE);
    signal(&mut m, "out", SignalKind::Output, BYTE);
    push(&mut m, assign(wire("out"), read(wire("into"), BYTE)));
    m
}

#[test]
fn loops_are_named_in_full() {
    let mut m = module("ring");
    signal(&mut m, "a", SignalKind::Local, BYTE);
    signal(&mut m, "o", SignalKind::Output, BYTE);
    child(&mut m, "b", through());
    push(&mut m, assign(port("b", "into"), read(wire("a"), BYTE)));
    let not = Node::Not(Box::new(read(port("b", "out"), BYTE)));
    push(&mut m, assign(wire("a"), Expression::new(BYTE, not)));
    push(&mut m, assign(wire("o"), read(wire("a"), BYTE)));
    assert_eq!(
        refusal(&m),
        "module ring: combinational loop: a -> b.into -> b.out -> a"
    );
}

#[test]
fn loops_through_conditions_memories_and_other_bits_are_loops() {
    let mut m = module("condition");
    signal(&mut m, "o", SignalKind::Output, Format::Bit);
    let bit = |code| Expression::literal(code, Format::Bit);
    let invert = Statement::If {
        condition: read(wire("o"), Format::Bit),
        then: vec![assign(wire("o"), bit(0))],
        otherwise: vec![assign(wire("o"), bit(1))],
    };
    push(&mut m, invert);
    assert_eq!(refusal(&m), "module condition: combinational loop: o -> o");

    let mut m = module("bits");
    signal(&mut m, "o", SignalKind::Output, BYTE);
    let low = Node::Slice(Box::new(read(wire("o"), BYTE)), 0);
    let halves = [
        Expression::literal(3, Format::Unsigned(4)),
        Expression::new(Format::Unsigned(4), low),
    ];
    for (i, value) in halves.into_iter().enumerate() {
        let (at, width) = (4 * i, 4);
        push(&mut m, part(wire("o"), Some(Bits { at, width }), value));
    }
    assert_eq!(refusal(&m), "module bits: combinational loop: o -> o");

    let table = Memory {
        words: 256,
        width: 8,
        initial: vec![],
        outside_is_zero: true,
        read: ReadPort {
            address: "address".into(),
            data: "data".into(),
            enable: None,
            clock: None,
        },
        write: None,
    };
    let mut m = module("chase");
    signal(&mut m, "o", SignalKind::Output, BYTE);
    child(&mut m, "table", memory("table", BYTE, BYTE, table));
    let data = || read(port("table", "data"), BYTE);
    push(&mut m, assign(port("table", "address"), data()));
    push(&mut m, assign(wire("o"), data()));
    assert_eq!(
        refusal(&m),
        "module chase: combinational loop: table.address -> table.data -> table.address"
    );
}

#[test]
fn a_second_clock_is_refused() {
    let mut m = clocked("twice");
    signal(&mut m, "other", SignalKind::Input, Format::Clock);
    let mut inner = clocked("inner");
    register(&mut inner, "n", BYTE, 0);
    push(&mut inner, assign(held("n"), Expression::literal(1, BYTE)));
    register(&mut m, "a", BYTE, 0);
    push(&mut m, assign(held("a"), Expression::literal(1, BYTE)));
    child(&mut m, "inside", inner);
    let mut same = m.clone();
    push(
        &mut m,
        assign(port("inside", "clock"), read(wire("other"), Format::Clock)),
    );
    assert_eq!(
        refusal(&m),
        "module twice: two clocks: a is clocked by clock, inside.n by other"
    );
    connect_clock(&mut same, "inside");
    assert!(elaborate(&same).is_ok());
}

#[test]
fn latches_undriven_wires_and_wrong_widths_are_refused() {
    let mut m = module("latch");
    signal(&mut m, "go", SignalKind::Input, Format::Bit);
    signal(&mut m, "o", SignalKind::Output, BYTE);
    assert_eq!(refusal(&m), "module latch: o has no driver");
    push(
        &mut m,
        Statement::If {
            condition: read(wire("go"), Format::Bit),
            then: vec![assign(wire("o"), Expression::literal(1, BYTE))],
            otherwise: vec![],
        },
    );
    assert_eq!(refusal(&m), "module latch: o is not assigned on every path");

    let mut m = module("widths");
    signal(&mut m, "a", SignalKind::Input, Format::Signed(9));
    signal(&mut m, "o", SignalKind::Output, BYTE);
    let a = || Box::new(read(wire("a"), Format::Signed(9)));
    let not = Expression::new(BYTE, Node::Not(a()));
    let mut wrong = m.clone();
    push(&mut wrong, assign(wire("o"), not));
    assert_eq!(refusal(&wrong), "module widths: Not of S9 cannot be a U8");
    let mut wrong = m.clone();
    push(&mut wrong, assign(wire("o"), *a()));
    assert_eq!(refusal(&wrong), "module widths: o: 9 bits assigned to 8");
    push(&mut m, assign(wire("o"), read(wire("b"), BYTE)));
    assert_eq!(refusal(&m), "module widths: b is not declared");
}

#[test]
fn unknown_names_are_met_with_near_ones() {
    let mut m = module("names");
    signal(&mut m, "ready", SignalKind::Input, BYTE);
    signal(&mut m, "valid", SignalKind::Output, BYTE);
    child(&mut m, "walk", through());
    push(
        &mut m,
        assign(port("walk", "into"), read(wire("ready"), BYTE)),
    );
    push(
        &mut m,
        assign(wire("valid"), read(port("walk", "out"), BYTE)),
    );
    let s = Simulator::new(&m).unwrap_or_else(|e| panic!("{e}"));
    let input = s.input("redy").expect_err("unknown");
    assert_eq!(input.to_string(), "input 'redy' is unknown; nearest: ready");
    assert_eq!(s.output("x").expect_err("unknown").nearest, ["valid"]);
    let signal = s.signal("into").expect_err("unknown");
    assert_eq!(signal.nearest[0], "walk.into");
    let memory = s.memory("m").expect_err("unknown");
    assert_eq!(memory.to_string(), "memory 'm' is unknown");
}
