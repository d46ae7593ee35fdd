//! Every node on corner and random operands, computed at run time and folded at compile time.

use super::build::*;
use super::interpreter::Interpreter;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::compile::Simulator;
use shadegate_gen::netlist::{
    Comparison, Expression, Format, Module, Node, Operator, Reduction, SignalKind,
};

const WIDTHS: [usize; 16] = [1, 2, 7, 8, 9, 15, 16, 17, 31, 32, 33, 63, 64, 65, 127, 128];

fn format(width: usize, signed: bool) -> Format {
    if signed {
        Format::Signed(width)
    } else {
        Format::Unsigned(width)
    }
}

fn ones(width: usize) -> u128 {
    u128::MAX >> (128 - width)
}

/// Operands of the test: a word, another of its format, an amount, a bit.
fn operands(f: Format, amount: usize) -> [(&'static str, Format); 4] {
    [
        ("a", f),
        ("b", f),
        ("n", Format::Unsigned(amount)),
        ("bit", Format::Bit),
    ]
}

/// Expressions of every kind over operands.
fn expressions(o: &[Expression; 4]) -> Vec<Expression> {
    let [a, b, n, bit] = o;
    let bx = |e: &Expression| Box::new(e.clone());
    let (f, w, signed) = (a.format, a.width(), a.format.signed());
    let one = |node| Expression::new(Format::Bit, node);
    let same = |node| Expression::new(f, node);
    let mut out = vec![same(Node::Not(bx(a))), same(Node::Negate(bx(a)))];
    for r in [Reduction::All, Reduction::Any, Reduction::Parity] {
        out.push(one(Node::Reduce(r, bx(a))));
    }
    for op in [
        Operator::Add,
        Operator::Subtract,
        Operator::And,
        Operator::Or,
        Operator::Xor,
    ] {
        out.push(same(Node::Binary(op, bx(a), bx(b))));
    }
    for c in [
        Comparison::Equal,
        Comparison::NotEqual,
        Comparison::Less,
        Comparison::LessEqual,
        Comparison::Greater,
        Comparison::GreaterEqual,
    ] {
        let test = one(Node::Compare(c, bx(a), bx(b)));
        // As a value, complemented, and as a condition.
        out.push(test.clone());
        out.push(one(Node::Not(Box::new(test))));
    }
    for part in [1, 7, w] {
        // The whole product of the word, or of its low bits, and of the other's.
        let (wa, wb) = (w.min(128 - w.min(part)), w.min(part));
        let low = |e: &Expression, w: usize| {
            Box::new(Expression::new(format(w, signed), Node::Slice(bx(e), 0)))
        };
        if wa + wb <= 128 && wa > 0 {
            let product = Node::Product(low(a, wa), low(b, wb));
            out.push(Expression::new(format(wa + wb, signed), product));
        }
    }
    out.push(same(Node::ShiftLeft(bx(a), bx(n))));
    out.push(same(Node::ShiftRight(bx(a), bx(n))));
    out.push(same(Node::ReplaceBit(bx(a), bx(n), bx(bit))));
    for to in WIDTHS {
        for signed in [false, true] {
            let to = format(to, signed);
            out.push(Expression::new(to, Node::Resize(bx(a))));
        }
        let unsigned = Format::Unsigned(to);
        if to <= w {
            for at in [0, 1, (w - to) / 2, w - to] {
                if at + to <= w {
                    out.push(Expression::new(unsigned, Node::Slice(bx(a), at)));
                }
            }
            out.push(Expression::new(unsigned, Node::Select(bx(a), bx(n))));
        }
        if to + w <= 128 {
            let wider = Format::Unsigned(to + w);
            out.push(Expression::new(wider, Node::Append(bx(a), to)));
        }
    }
    out.push(Expression::new(format(w, !signed), Node::Reformat(bx(a))));
    out
}

fn outputs(m: &mut Module, expressions: Vec<Expression>) {
    for e in expressions {
        let name = format!("o{}", m.signals.len());
        signal(m, &name, SignalKind::Output, e.format);
        push(m, assign(wire(&name), e));
    }
}

/// Codes worth trying.
fn corners(width: usize) -> Vec<u128> {
    let top = 1 << (width - 1);
    let mut all = vec![0, 1, ones(width), top, top - 1, top | 1, ones(width) / 3];
    all.iter_mut().for_each(|c| *c &= ones(width));
    all.sort_unstable();
    all.dedup();
    all
}

fn agree(m: &Module, codes: &[(String, Vec<u128>)]) {
    let mut simulator = Simulator::new(m).unwrap_or_else(|e| panic!("{e}"));
    let mut model = Interpreter::new(m);
    let rounds = codes.first().map_or(1, |c| c.1.len());
    for round in 0..rounds {
        for (name, list) in codes {
            let input = simulator.input(name).expect("declared");
            simulator.set(input, list[round]);
            model.wires.insert(name.clone(), list[round]);
        }
        simulator.settle();
        model.settle();
        for s in m.signals.iter().filter(|s| s.kind == SignalKind::Output) {
            let got = simulator.get(simulator.output(&s.name).expect("declared"));
            let inputs: Vec<_> = codes.iter().map(|(n, c)| (n, c[round])).collect();
            assert_eq!(
                got, model.wires[&s.name],
                "{} of {:?} with {inputs:x?}",
                s.name, m.body
            );
        }
    }
}

/// The codes of each operand, round by round: all corners with all corners, then random ones.
fn rounds(f: Format, amount: usize, r: &mut StdRng) -> Vec<(String, Vec<u128>)> {
    let w = f.width();
    let mut rounds = vec![];
    for a in corners(w) {
        for b in corners(w) {
            rounds.push([a, b]);
        }
    }
    for _ in 0..40 {
        rounds.push([r.random::<u128>() & ones(w), r.random::<u128>() & ones(w)]);
    }
    let mut amounts: Vec<u128> = (0..=w as u128 + 1).collect();
    amounts.extend([
        31,
        32,
        33,
        63,
        64,
        65,
        127,
        128,
        129,
        1 << 32,
        1 << 64,
        u128::MAX,
    ]);
    let n: Vec<u128> = (0..rounds.len())
        .map(|_| amounts[r.random_range(0..amounts.len())] & ones(amount))
        .collect();
    let bit = (0..rounds.len()).map(|_| u128::from(r.random::<bool>()));
    vec![
        ("a".into(), rounds.iter().map(|c| c[0]).collect()),
        ("b".into(), rounds.iter().map(|c| c[1]).collect()),
        ("n".into(), n),
        ("bit".into(), bit.collect()),
    ]
}

#[test]
fn every_node_at_run_time() {
    let mut r = StdRng::seed_from_u64(1);
    for w in WIDTHS {
        for (signed, amount) in [(false, 8), (true, 3), (false, w), (true, 64), (false, 128)] {
            let f = format(w, signed);
            let mut m = module("nodes");
            let operands = operands(f, amount).map(|(name, f)| {
                signal(&mut m, name, SignalKind::Input, f);
                read(wire(name), f)
            });
            outputs(&mut m, expressions(&operands));
            agree(&m, &rounds(f, amount, &mut r));
        }
    }
}

#[test]
fn every_node_on_constants() {
    let mut r = StdRng::seed_from_u64(2);
    for w in WIDTHS {
        for signed in [false, true] {
            let f = format(w, signed);
            let codes = rounds(f, 8, &mut r);
            let mut m = module("constants");
            for round in (0..codes[0].1.len()).step_by(7) {
                let of = |i: usize, f| Expression::literal(codes[i].1[round], f);
                let literals = [
                    of(0, f),
                    of(1, f),
                    of(2, Format::Unsigned(8)),
                    of(3, Format::Bit),
                ];
                outputs(&mut m, expressions(&literals));
            }
            agree(&m, &[]);
        }
    }
}

/// One operand constant: what the identities of folding look for.
#[test]
fn every_node_on_one_constant() {
    let mut r = StdRng::seed_from_u64(3);
    for w in [1, 2, 8, 31, 32, 33, 64, 65, 128] {
        for signed in [false, true] {
            let f = format(w, signed);
            let mut m = module("mixed");
            for (name, f) in operands(f, 8) {
                signal(&mut m, name, SignalKind::Input, f);
            }
            let of = |name: &str, f| read(wire(name), f);
            let (n, bit) = (of("n", Format::Unsigned(8)), of("bit", Format::Bit));
            for code in corners(w) {
                let literal = || Expression::literal(code, f);
                let amount = Expression::literal(code.min(255), Format::Unsigned(8));
                let on = Expression::literal(code & 1, Format::Bit);
                let left = [literal(), of("b", f), n.clone(), on];
                outputs(&mut m, expressions(&left));
                let right = [of("a", f), literal(), amount, bit.clone()];
                outputs(&mut m, expressions(&right));
            }
            let same = [of("a", f), of("a", f), n, bit];
            outputs(&mut m, expressions(&same));
            agree(&m, &rounds(f, 8, &mut r));
        }
    }
}
