//! What happens at an edge, case by case: who sees old values, what wins, what stays.

use super::build::*;
use super::interpreter::Interpreter;
use shadegate_gen::compile::Simulator;
use shadegate_gen::netlist::{
    Bits, Expression, Format, Memory, Module, Name, Node, Operator, ReadPort, SignalKind,
    Statement, WritePort,
};

const BYTE: Format = Format::Unsigned(8);

fn byte(name: Name) -> Expression {
    read(name, BYTE)
}

fn show(m: &mut Module, name: &str) {
    let output = format!("{name}_out");
    signal(m, &output, SignalKind::Output, BYTE);
    push(m, assign(wire(&output), byte(held(name))));
}

fn when(condition: &str, then: Vec<Statement>, otherwise: Vec<Statement>) -> Statement {
    Statement::If {
        condition: read(wire(condition), Format::Bit),
        then,
        otherwise,
    }
}

fn simulator(m: &Module) -> Simulator {
    Simulator::new(m).unwrap_or_else(|e| panic!("{e}"))
}

fn output(s: &Simulator, name: &str) -> u128 {
    s.get(s.output(name).expect("declared"))
}

fn set(s: &mut Simulator, name: &str, code: u128) {
    let input = s.input(name).expect("declared");
    s.set(input, code);
}

#[test]
fn registers_exchange_their_values() {
    let mut m = clocked("exchange");
    register(&mut m, "a", BYTE, 3);
    register(&mut m, "b", BYTE, 5);
    push(&mut m, assign(held("a"), byte(held("b"))));
    push(&mut m, assign(held("b"), byte(held("a"))));
    show(&mut m, "a");
    show(&mut m, "b");
    let mut s = simulator(&m);
    for want in [(3, 5), (5, 3), (3, 5)] {
        assert_eq!((output(&s, "a_out"), output(&s, "b_out")), want);
        s.clock();
    }
}

/// Rings and chains under different conditions, in both orders of declaration: no order of in-place stores is right
/// for all of them.
#[test]
fn rings_under_conditions_see_old_values() {
    for reverse in [false, true] {
        let mut m = clocked("ring");
        let mut order: Vec<usize> = (0..4).collect();
        for i in 0..4 {
            signal(&mut m, &format!("go{i}"), SignalKind::Input, Format::Bit);
            register(&mut m, &format!("r{i}"), BYTE, 10 + i as u128);
        }
        if reverse {
            order.reverse();
        }
        for i in order {
            let (to, from) = (format!("r{i}"), format!("r{}", (i + 1) % 4));
            let sum = Node::Binary(
                Operator::Add,
                Box::new(byte(held(&from))),
                Box::new(byte(held(&to))),
            );
            let store = assign(held(&to), byte(held(&from)));
            let other = assign(held(&to), Expression::new(BYTE, sum));
            push(&mut m, when(&format!("go{i}"), vec![store], vec![other]));
        }
        (0..4).for_each(|i| show(&mut m, &format!("r{i}")));
        let (mut s, mut model) = (simulator(&m), Interpreter::new(&m));
        for mask in 0..16 {
            for i in 0..4 {
                let name = format!("go{i}");
                set(&mut s, &name, mask >> i & 1);
                model.wires.insert(name, mask >> i & 1);
            }
            s.clock();
            model.clock();
            for i in 0..4 {
                let got = output(&s, &format!("r{i}_out"));
                assert_eq!(got, model.registers[&format!("r{i}")], "mask {mask}");
            }
        }
    }
}

#[test]
fn later_assignments_win_bit_by_bit_and_the_rest_stays() {
    let mut m = clocked("partial");
    signal(&mut m, "low", SignalKind::Input, Format::Bit);
    register(&mut m, "r", BYTE, 0xa5);
    let bits = |at, width| Some(Bits { at, width });
    let nibble = |code| Expression::literal(code, Format::Unsigned(4));
    let low = vec![
        part(held("r"), bits(0, 4), nibble(1)),
        part(held("r"), bits(2, 4), nibble(0xf)),
    ];
    let invert = Expression::new(BYTE, Node::Not(Box::new(byte(held("r")))));
    let high = vec![
        assign(held("r"), invert),
        part(held("r"), bits(4, 4), nibble(6)),
    ];
    push(&mut m, when("low", low, high));
    show(&mut m, "r");
    let mut s = simulator(&m);
    set(&mut s, "low", 1);
    s.clock();
    // 1010 0101 -> low nibble 0001, then bits 5..2 ones: 1011 1101.
    assert_eq!(output(&s, "r_out"), 0b1011_1101);
    set(&mut s, "low", 0);
    s.clock();
    assert_eq!(output(&s, "r_out"), 0x62);
    s.power_up();
    assert_eq!(output(&s, "r_out"), 0xa5);
}

fn frame(words: usize, outside_is_zero: bool) -> Module {
    let clock = || "clock".to_string();
    let data = Memory {
        words,
        width: 8,
        initial: vec![7, 8],
        outside_is_zero,
        read: ReadPort {
            address: "address".into(),
            data: "data".into(),
            enable: Some("enable".into()),
            clock: Some(clock()),
        },
        write: Some(WritePort {
            address: "write_address".into(),
            data: "write_data".into(),
            enable: "write_enable".into(),
            clock: clock(),
        }),
    };
    memory("frame", Format::Unsigned(4), BYTE, data)
}

#[test]
fn memories_give_the_old_word_and_keep_what_is_outside() {
    for outside_is_zero in [false, true] {
        let m = frame(5, outside_is_zero);
        let mut s = simulator(&m);
        let mut clock = |read: Option<u128>, write: Option<(u128, u128)>| {
            set(&mut s, "enable", u128::from(read.is_some()));
            set(&mut s, "address", read.unwrap_or(3));
            set(&mut s, "write_enable", u128::from(write.is_some()));
            let (address, data) = write.unwrap_or((1, 99));
            set(&mut s, "write_address", address);
            set(&mut s, "write_data", data);
            s.clock();
            output(&s, "data")
        };
        assert_eq!(clock(None, None), 0, "nothing read yet");
        assert_eq!(clock(Some(1), Some((1, 50))), 8, "the old word");
        assert_eq!(clock(Some(1), None), 50);
        assert_eq!(clock(None, Some((4, 60))), 50, "keeps its word");
        assert_eq!(clock(Some(4), None), 60);
        let outside = if outside_is_zero { 0 } else { 60 };
        assert_eq!(clock(Some(5), Some((5, 1))), outside);
        assert_eq!(clock(Some(15), Some((15, 2))), outside);
        let words = [7, 50, 0, 0, 60];
        let all = s.memory("").expect("declared");
        assert_eq!(all.len(), 5);
        for (address, word) in words.into_iter().enumerate() {
            assert_eq!(s.word(all, address), Some(word));
        }
        s.power_up();
        assert_eq!(s.word(all, 1), Some(8));
    }
}

#[test]
fn a_simulator_can_move_to_another_thread() {
    let mut m = clocked("count");
    register(&mut m, "n", BYTE, 0);
    let one = Box::new(Expression::literal(1, BYTE));
    let sum = Node::Binary(Operator::Add, Box::new(byte(held("n"))), one);
    push(&mut m, assign(held("n"), Expression::new(BYTE, sum)));
    show(&mut m, "n");
    let mut s = simulator(&m);
    s.clock();
    let n = std::thread::spawn(move || {
        s.clock();
        output(&s, "n_out")
    });
    assert_eq!(n.join().expect("runs"), 2);
}
