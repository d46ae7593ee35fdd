//! What a constraint file is asked for: the top level's ports and what they are wired to.

use crate::{Board, Device, ResourceKind};
use std::fmt;

/// Which way a port carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Into the FPGA.
    Input,
    /// Out of the FPGA.
    Output,
    /// Both.
    InOut,
}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Direction::Input => "input",
            Direction::Output => "output",
            Direction::InOut => "inout",
        })
    }
}

/// One port of the top level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Name in the Verilog.
    pub name: String,
    /// Bits; bit 0 is the lowest index, as in `[width-1:0]`.
    pub width: u32,
    /// Direction.
    pub direction: Direction,
}

impl Port {
    /// A port.
    pub fn new(name: impl Into<String>, width: u32, direction: Direction) -> Self {
        Port {
            name: name.into(),
            width,
            direction,
        }
    }
}

/// One port bit on one thing of the board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// Port.
    pub port: String,
    /// Bit of a port that is wider than one bit.
    pub bit: Option<u32>,
    /// Name of the board's resource.
    pub resource: String,
}

impl Binding {
    /// Binds a one-bit port.
    pub fn new(port: impl Into<String>, resource: impl Into<String>) -> Self {
        Binding {
            port: port.into(),
            bit: None,
            resource: resource.into(),
        }
    }

    /// Binds one bit of a wider port.
    pub fn bit(port: impl Into<String>, bit: u32, resource: impl Into<String>) -> Self {
        Binding {
            port: port.into(),
            bit: Some(bit),
            resource: resource.into(),
        }
    }
}

/// Everything a constraint file depends on.
#[derive(Clone, Copy, Debug)]
pub struct Request<'a> {
    /// Name of the top-level module; the file is named after it.
    pub design: &'a str,
    /// Device; it decides the format.
    pub device: &'a Device,
    /// Board, if there is one. It decides package and speed grade.
    pub board: Option<&'a Board>,
    /// All ports of the top level.
    pub ports: &'a [Port],
    /// Which of them is the clock.
    pub clock_port: &'a str,
    /// Clock period the design is to meet, in nanoseconds; written rounded down to a picosecond.
    pub period_ns: f64,
    /// What is wired to what.
    pub bindings: &'a [Binding],
}

/// A period this much longer than the oscillator's still counts as the same: a frequency such as
/// 12 MHz has no exact period in picoseconds.
pub(crate) const SAME_PERIOD_NS: f64 = 0.001;

/// The bindings that make sense for any core on `board`.
///
/// The clock goes to the first of the board's clocks that is not faster than `period_ns` allows
/// (to none if all are), `busy` to the first LED and `done` to the second, where such one-bit
/// output ports and LEDs exist.
pub fn default_bindings(
    board: &Board,
    ports: &[Port],
    clock_port: &str,
    period_ns: f64,
) -> Vec<Binding> {
    let has = |name: &str, direction| {
        ports
            .iter()
            .any(|p| p.name == name && p.width == 1 && p.direction == direction)
    };
    let mut bindings = Vec::new();
    let slow_enough = board.of_kind(ResourceKind::Clock).find(|r| {
        r.period_ns()
            .is_some_and(|p| p + SAME_PERIOD_NS >= period_ns)
    });
    if let Some(clock) = slow_enough.filter(|_| has(clock_port, Direction::Input)) {
        bindings.push(Binding::new(clock_port, &clock.name));
    }
    let leds = board.of_kind(ResourceKind::Led);
    for (port, led) in ["busy", "done"].into_iter().zip(leds) {
        if has(port, Direction::Output) {
            bindings.push(Binding::new(port, &led.name));
        }
    }
    bindings
}
