//! The program of the set-up engine: a triangle's corners and knots to the register words of the quadratic core.
//!
//! What it computes is in [`super`]; this file is the order in which a person would write it down. [`super::schedule`]
//! finds the clocks.

use super::channels::{colour, depth, Lattice};
use super::instruction::{Constant, Division, Exponent, Function, Instruction, Layout, YFrom};
use super::schedule::{Builder, Value, X};
use std::sync::OnceLock;

/// Raw slot of x of vertex 0.
pub const SLOT_X: u8 = 0;
/// Raw slot of y of vertex 0.
pub const SLOT_Y: u8 = 4;
/// Raw slot of the depth at vertex 0.
pub const SLOT_DEPTH: u8 = 8;
/// Raw slot of red at vertex 0; the mid-edges follow at a distance of 4, by the vertex opposite; then green, blue.
pub const SLOT_COLOUR: u8 = 16;

/// y of an operation.
#[derive(Clone, Copy, Debug)]
pub(super) enum Y {
    Of(Value),
    /// A result times two.
    Double(Value),
    /// A result times 256.
    Pixel(Value),
    Raw(u8),
    /// A raw word of the top (0), middle (1) or bottom (2) vertex.
    Sorted(u8),
    /// The same, times two.
    SortedDouble(u8),
    /// A raw word, moved up by 26 places.
    RawHigh(u8),
    /// The same of a sorted vertex.
    SortedHigh(u8),
    Is(Constant),
}

/// Flags by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flag {
    Above01,
    Above02,
    Above12,
    Mirrored,
    NoArea,
    TopOutside,
    BottomInside,
    NoRows,
    SplitOutside,
    SplitBelow,
    NoUpper,
    Many,
    ManyUpper,
    ManyLower,
}

/// The writer: short names for the operations.
#[derive(Default)]
pub(super) struct Writer {
    builder: Builder,
    /// The comparisons that put the vertices in order.
    sorted: Vec<Value>,
    /// The tests that may skip the triangle.
    kept: Vec<Value>,
}

impl Writer {
    fn alu(&mut self, x: X, y: Y, i: Instruction, after: &[Value]) -> Value {
        let (y_from, y, shift, value) = match y {
            Y::Of(v) => (YFrom::Register, 0, 0, Some(v)),
            Y::Double(v) => (YFrom::Register, 0, 1, Some(v)),
            Y::Pixel(v) => (YFrom::Register, 0, 2, Some(v)),
            Y::Raw(slot) => (YFrom::Raw, slot, 0, None),
            Y::RawHigh(slot) => (YFrom::Raw, slot, 3, None),
            Y::Sorted(slot) => (YFrom::Sorted, slot, 0, None),
            Y::SortedDouble(slot) => (YFrom::Sorted, slot, 1, None),
            Y::SortedHigh(slot) => (YFrom::Sorted, slot, 3, None),
            Y::Is(c) => (YFrom::Constant, c as u8, 0, None),
        };
        let mut after = after.to_vec();
        if y_from == YFrom::Sorted {
            after.extend(&self.sorted);
        }
        if i.send.is_some() {
            after.extend(&self.kept);
        }
        let i = Instruction {
            y,
            y_from,
            y_shift: shift,
            ..i
        };
        self.builder.push(i, x, value, &after)
    }

    fn of(function: Function) -> Instruction {
        Instruction {
            function,
            to: Some(0),
            ..Instruction::default()
        }
    }

    pub(super) fn sum(&mut self, x: X, y: Y) -> Value {
        self.alu(x, y, Self::of(Function::Sum), &[])
    }

    pub(super) fn difference(&mut self, x: X, y: Y) -> Value {
        self.alu(x, y, Self::of(Function::Difference), &[])
    }

    /// y − x.
    pub(super) fn reversed(&mut self, x: X, y: Y) -> Value {
        self.alu(x, y, Self::of(Function::Reversed), &[])
    }

    /// x / 256 rounded down, plus y.
    pub(super) fn down(&mut self, x: X, y: Y) -> Value {
        let i = Instruction {
            x_down: true,
            ..Self::of(Function::Sum)
        };
        self.alu(x, y, i, &[])
    }

    /// The result with its sign as a flag.
    fn signed(&mut self, x: X, y: Y, function: Function, down: bool, flag: Flag) -> Value {
        let i = Instruction {
            flag: flag as u8,
            flag_write: true,
            x_down: down,
            ..Self::of(function)
        };
        self.alu(x, y, i, &[])
    }

    /// x if the flag is set, which `test` writes, else y.
    fn choice(&mut self, flag: Flag, test: Value, x: X, y: Y) -> Value {
        let i = Instruction {
            flag: flag as u8,
            ..Self::of(Function::Choice)
        };
        self.alu(x, y, i, &[test])
    }

    fn skip(&mut self, flag: Flag, test: Value) {
        let i = Instruction {
            flag: flag as u8,
            skip: true,
            ..Instruction::default()
        };
        let v = self.alu(X::Zero, Y::Is(Constant::Zero), i, &[test]);
        self.kept.push(v);
    }

    /// x·y with `limbs` of 16 bits of y, times 2^(64 − 16(limbs − 1) − places), for one later operation to take.
    pub(super) fn multiply(
        &mut self,
        x: Value,
        y: Y,
        limbs: u8,
        places: u8,
        exponent: Exponent,
    ) -> X {
        let i = Instruction {
            multiply: Some((limbs, places, exponent)),
            ..Instruction::default()
        };
        X::Product(self.alu(X::Of(x), y, i, &[]))
    }

    /// The product as a result.
    pub(super) fn product(
        &mut self,
        x: Value,
        y: Y,
        limbs: u8,
        places: u8,
        exponent: Exponent,
    ) -> Value {
        let p = self.multiply(x, y, limbs, places, exponent);
        self.sum(p, Y::Is(Constant::Zero))
    }

    fn divide(&mut self, x: X, down: bool, y: Value, kind: Division) -> Value {
        let i = Instruction {
            divide: Some(kind),
            x_down: down,
            ..Instruction::default()
        };
        self.alu(x, Y::Of(y), i, &[])
    }

    /// Sends a word of a channel: the result cut to whole units.
    pub(super) fn word(
        &mut self,
        x: X,
        y: Y,
        function: Function,
        select: u8,
        depth: bool,
    ) -> Value {
        let i = Instruction {
            cut: true,
            send: Some((select, Layout::Word)),
            depth,
            ..Self::of(function)
        };
        self.alu(x, y, i, &[])
    }

    fn shell(&mut self, x: X, y: Value, word: u8, layout: Layout) {
        let i = Instruction {
            send: Some((word, layout)),
            ..Instruction::default()
        };
        self.alu(x, Y::Of(y), i, &[]);
    }
}

/// An edge as the walk takes it.
struct Edge {
    column: Value,
    error: Value,
    whole: Value,
    up: Value,
    down: Value,
    /// n of the first pixel centre at or behind the edge.
    reach: Value,
    /// What the division for the column leaves.
    rest: Value,
    /// The first row's centre below the edge's upper end.
    below: Value,
}

/// From a to b: x to b, y at a, height, x at a; from a row on; whether there is more than one.
struct Ends {
    dx: Value,
    y: Value,
    dy: Value,
    x: Value,
    row: Value,
    many: (Flag, Value),
}

impl Writer {
    fn edge(&mut self, e: &Ends, bias: Value) -> Edge {
        let half = self.reversed(X::Of(e.y), Y::Is(Constant::Half));
        let below = self.sum(X::Of(half), Y::Pixel(e.row));
        let x = self.sum(X::Of(e.x), Y::Is(Constant::Half));
        let p = self.multiply(e.dy, Y::Of(x), 2, 48, Exponent::None);
        let part = self.difference(p, Y::Of(bias));
        let p = self.multiply(e.dx, Y::Of(below), 2, 48, Exponent::None);
        let reach = self.sum(p, Y::Of(part));
        let slope = self.divide(X::Of(e.dx), false, e.dy, Division::Whole);
        let zero = Y::Is(Constant::Zero);
        let (many, test) = e.many;
        let whole = self.choice(many, test, X::Quotient(slope), zero);
        let up = self.choice(many, test, X::Remainder(slope), zero);
        let down = self.difference(X::Of(up), Y::Of(e.dy));
        let division = self.divide(X::Of(reach), true, e.dy, Division::Whole);
        let column = self.sum(X::Quotient(division), zero);
        let rest = self.sum(X::Remainder(division), zero);
        let error = self.sum(X::Of(rest), Y::Of(down));
        Edge {
            column,
            error,
            whole,
            up,
            down,
            reach,
            rest,
            below,
        }
    }

    fn send_edge(&mut self, words: [Value; 5], at: u8) {
        let [column, error, whole, up, down] = words;
        self.shell(X::Of(column), error, at, Layout::Edge);
        self.shell(X::Of(whole), up, at + 1, Layout::Edge);
        self.shell(X::Zero, down, at + 2, Layout::Edge);
    }

    /// Sorts the corners, and says where each stands.
    fn sort(&mut self) {
        let mut keys = vec![];
        for i in 0..3 {
            let high = self.sum(X::Zero, Y::RawHigh(SLOT_Y + i));
            keys.push(self.sum(X::Of(high), Y::Raw(SLOT_X + i)));
        }
        for (a, b, flag) in [
            (0, 1, Flag::Above01),
            (0, 2, Flag::Above02),
            (1, 2, Flag::Above12),
        ] {
            let (x, y) = (X::Of(keys[a]), Y::Of(keys[b]));
            let v = self.signed(x, y, Function::Difference, false, flag);
            self.sorted.push(v);
        }
    }
}

/// The rows of the frame that a triangle meets: first, upper, lower, in all.
struct Rows {
    first: Value,
    split: Value,
    upper: Value,
    lower: Value,
    rows: Value,
}

impl Writer {
    fn rows(&mut self, [top, middle, bottom]: [Value; 3]) -> Rows {
        let zero = Y::Is(Constant::Zero);
        let row = |y: Value, w: &mut Self| w.sum(X::Of(y), Y::Is(Constant::Below));
        let (t, m, b) = (row(top, self), row(middle, self), row(bottom, self));
        let top = self.signed(X::Of(t), zero, Function::Sum, true, Flag::TopOutside);
        let middle = self.down(X::Of(m), zero);
        let bottom = self.down(X::Of(b), zero);
        let first = self.choice(Flag::TopOutside, top, X::Zero, Y::Of(top));
        let height = Y::Is(Constant::Height);
        let inside = self.signed(
            X::Of(bottom),
            height,
            Function::Difference,
            false,
            Flag::BottomInside,
        );
        let end = self.choice(Flag::BottomInside, inside, X::Of(bottom), height);
        let rows = self.difference(X::Of(end), Y::Of(first));
        let minus = |x, y, flag, w: &mut Self| {
            w.signed(X::Of(x), Y::Of(y), Function::Difference, false, flag)
        };
        let outside = minus(middle, first, Flag::SplitOutside, self);
        let inner = self.choice(Flag::SplitOutside, outside, X::Of(first), Y::Of(middle));
        let below = minus(end, inner, Flag::SplitBelow, self);
        let split = self.choice(Flag::SplitBelow, below, X::Of(end), Y::Of(inner));
        let upper = self.difference(X::Of(split), Y::Of(first));
        let lower = self.difference(X::Of(end), Y::Of(split));
        Rows {
            first,
            split,
            upper,
            lower,
            rows,
        }
    }

    /// Whether a count of rows is below one.
    fn none(&mut self, count: Value, flag: Flag) -> Value {
        let one = Y::Is(Constant::One);
        self.signed(X::Of(count), one, Function::Difference, false, flag)
    }

    /// Whether it is above one.
    fn many(&mut self, count: Value, flag: Flag) -> (Flag, Value) {
        let one = Y::Is(Constant::One);
        let test = self.signed(X::Of(count), one, Function::Reversed, false, flag);
        (flag, test)
    }
}

/// The whole program, one instruction per clock.
#[must_use]
pub fn program() -> &'static [Instruction] {
    static PROGRAM: OnceLock<Vec<Instruction>> = OnceLock::new();
    PROGRAM.get_or_init(write)
}

fn write() -> Vec<Instruction> {
    let mut w = Writer::default();
    let zero = Y::Is(Constant::Zero);
    w.sort();
    let load = |slot: u8, w: &mut Writer| w.sum(X::Zero, Y::Sorted(slot));
    let y = [0, 1, 2].map(|i| load(SLOT_Y + i, &mut w));
    let height = w.difference(X::Of(y[2]), Y::Of(y[0]));
    let fraction = w.divide(X::Zero, false, height, Division::Fraction);
    let upper_height = w.difference(X::Of(y[1]), Y::Of(y[0]));
    // Twice the area; its sign says on which side the major edge is.
    let x = [0, 1, 2].map(|i| load(SLOT_X + i, &mut w));
    let (dx_middle, dx_bottom) = (
        w.difference(X::Of(x[1]), Y::Of(x[0])),
        w.difference(X::Of(x[2]), Y::Of(x[0])),
    );
    let p = w.multiply(dx_middle, Y::Of(height), 2, 48, Exponent::None);
    let part = w.sum(p, zero);
    let p = w.multiply(upper_height, Y::Of(dx_bottom), 2, 48, Exponent::None);
    let area = w.signed(p, Y::Of(part), Function::Reversed, false, Flag::Mirrored);
    let negative = w.reversed(X::Of(area), zero);
    let area = w.choice(Flag::Mirrored, area, X::Of(negative), Y::Of(area));
    let mirrored = area;
    let rows = w.rows(y);
    let test = w.none(area, Flag::NoArea);
    w.skip(Flag::NoArea, test);
    let test = w.none(rows.rows, Flag::NoRows);
    w.skip(Flag::NoRows, test);
    // Mirrored triangles are set up in mirrored columns.
    let x = [0, 1, 2].map(|i| {
        let negative = w.reversed(X::Of(x[i]), zero);
        w.choice(Flag::Mirrored, mirrored, X::Of(negative), Y::Of(x[i]))
    });
    let one = Y::Is(Constant::One);
    let bias = w.choice(Flag::Mirrored, mirrored, X::Zero, one);
    let no_upper = w.none(rows.upper, Flag::NoUpper);
    let major = Ends {
        dx: w.difference(X::Of(x[2]), Y::Of(x[0])),
        y: y[0],
        dy: height,
        x: x[0],
        row: rows.first,
        many: w.many(rows.rows, Flag::Many),
    };
    let major = w.edge(&major, bias);
    let inverse = w.sum(X::Quotient(fraction), zero);
    let reciprocal = w.divide(X::Zero, false, area, Division::Reciprocal);
    let scale = w.sum(X::Quotient(reciprocal), zero);
    let lattice = lattice(&mut w, &major, bias, height, upper_height, inverse, scale);
    depth(&mut w, &lattice);
    let lower = Ends {
        dx: w.difference(X::Of(x[2]), Y::Of(x[1])),
        y: y[1],
        dy: w.difference(X::Of(y[2]), Y::Of(y[1])),
        x: x[1],
        row: rows.split,
        many: w.many(rows.lower, Flag::ManyLower),
    };
    let lower = w.edge(&lower, bias);
    let upper = Ends {
        dx: w.difference(X::Of(x[1]), Y::Of(x[0])),
        y: y[0],
        dy: upper_height,
        x: x[0],
        row: rows.first,
        many: w.many(rows.upper, Flag::ManyUpper),
    };
    let upper = w.edge(&upper, bias);
    // Row counts, and where the first row lies in the frame.
    let bit = w.sum(X::Zero, Y::Is(Constant::Mirror));
    let bit = w.choice(Flag::Mirrored, mirrored, X::Of(bit), zero);
    let counts = w.sum(X::Of(bit), Y::Of(rows.upper));
    w.shell(X::Of(counts), rows.rows, 0, Layout::Rows);
    let width = Y::Is(Constant::Width);
    let base = w.product(rows.first, width, 1, 64, Exponent::None);
    w.shell(X::Of(base), rows.first, 1, Layout::Rows);
    let of = |e: &Edge| [e.column, e.error, e.whole, e.up, e.down];
    w.send_edge(of(&major), 2);
    w.send_edge(of(&lower), 8);
    // Without an upper part the lower edge is the one to begin with.
    let (lower, upper) = (of(&lower), of(&upper));
    let first = [0, 1, 2, 3, 4]
        .map(|i| w.choice(Flag::NoUpper, no_upper, X::Of(lower[i]), Y::Of(upper[i])));
    w.send_edge(first, 5);
    for channel in 0..3 {
        colour(&mut w, &lattice, channel);
    }
    w.builder.schedule()
}

fn lattice(
    w: &mut Writer,
    major: &Edge,
    bias: Value,
    height: Value,
    upper_height: Value,
    inverse: Value,
    scale: Value,
) -> Lattice {
    let zero = Y::Is(Constant::Zero);
    // How far the first pixel centre lies behind the edge: 256·(dy − rem + floor(N / 256)) − N − bias.
    let gap = w.reversed(X::Of(major.rest), Y::Of(height));
    let gap = w.down(X::Of(major.reach), Y::Of(gap));
    let gap = w.reversed(X::Of(major.reach), Y::Pixel(gap));
    let start = w.difference(X::Of(gap), Y::Of(bias));
    let start_whole = w.down(X::Of(start), zero);
    let start_rest = w.difference(X::Of(start), Y::Pixel(start_whole));
    let ratio = w.product(upper_height, Y::Of(inverse), 3, 52, Exponent::None);
    let fall = w.product(major.below, Y::Of(inverse), 3, 52, Exponent::None);
    // The square of a row: (256/H)², from two parts of 1/H.
    let one = w.sum(X::Zero, Y::Is(Constant::One));
    let rounded = w.sum(X::Of(inverse), Y::Is(Constant::Rest));
    let high = w.product(one, Y::Of(rounded), 3, 57, Exponent::None);
    let part = w.product(high, Y::Of(inverse), 3, 30, Exponent::None);
    let p = w.multiply(inverse, Y::Of(inverse), 3, 55, Exponent::None);
    let square = w.sum(p, Y::Of(part));
    Lattice {
        height,
        up: major.up,
        height_pixels: w.sum(X::Zero, Y::Pixel(height)),
        up_pixels: w.sum(X::Zero, Y::Pixel(major.up)),
        start,
        start_whole,
        start_rest,
        ratio,
        fall,
        inverse,
        square,
        scale,
    }
}
