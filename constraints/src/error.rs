//! What can be wrong with a name or a request; every message is one line.

use crate::Direction;
use thiserror::Error;

/// A device or board that is not in the data.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("unknown {kind} '{}'{} known: {known}", one_line(.name), did_you_mean(.suggestion))]
pub struct UnknownName {
    /// `device` or `board`.
    pub kind: &'static str,
    /// What was asked for.
    pub name: String,
    /// The nearest known name, if any is near.
    pub suggestion: Option<String>,
    /// All known names, separated by commas.
    pub known: String,
}

/// Why a constraint file cannot be written.
#[derive(Clone, Debug, PartialEq, Error)]
#[allow(missing_docs)] // each variant's message says what its fields are
pub enum ConstraintError {
    /// A name that the constraint languages cannot carry.
    #[error("{what} name '{}' is not a plain Verilog identifier", one_line(.name))]
    BadName { what: &'static str, name: String },
    /// Two ports with one name.
    #[error("port '{port}' is listed twice")]
    DuplicatePort { port: String },
    /// A port of no bits.
    #[error("port '{port}' is 0 bits wide")]
    NoBits { port: String },
    /// The clock port is not among the ports, or is not a one-bit input.
    #[error("clock port '{}' is not a one-bit input of the design", one_line(.port))]
    NoClock { port: String },
    /// A period that is no period, or beyond what the tools take.
    #[error("the clock period must be between 0.1 and 1000000 ns, not {period_ns}")]
    BadPeriod { period_ns: f64 },
    /// A board with another device than the one asked for.
    #[error("board '{board}' carries an {on_board}, not an {asked}")]
    WrongDevice {
        board: String,
        on_board: String,
        asked: String,
    },
    /// A binding without a board.
    #[error("port '{port}' is bound to '{resource}', but no board is given")]
    NoBoard { port: String, resource: String },
    /// A binding of a port that the design does not have.
    #[error("the design has no port '{}', bound to '{}'{} it has: {known}", one_line(.port), one_line(.resource), did_you_mean(.suggestion))]
    NoSuchPort {
        port: String,
        resource: String,
        suggestion: Option<String>,
        known: String,
    },
    /// A binding to a thing that the board does not have.
    #[error("board '{board}' has no '{}'{} it has: {known}", one_line(.resource), did_you_mean(.suggestion))]
    NoSuchResource {
        board: String,
        resource: String,
        suggestion: Option<String>,
        known: String,
    },
    /// A whole bus bound to one pin.
    #[error("port '{port}' is {width} bits wide: say which bit goes to '{resource}'")]
    BitNeeded {
        port: String,
        width: u32,
        resource: String,
    },
    /// A bit beyond the port.
    #[error("port '{port}' is {width} bits wide, so it has no bit {bit}")]
    NoSuchBit { port: String, width: u32, bit: u32 },
    /// One port bit on two pins.
    #[error("'{port}' is bound twice: to '{first}' and to '{second}'")]
    PortTwice {
        port: String,
        first: String,
        second: String,
    },
    /// One pin for two port bits.
    #[error("pin {pin} ('{resource}') is used twice: for '{first}' and for '{second}'")]
    PinTwice {
        pin: String,
        resource: String,
        first: String,
        second: String,
    },
    /// An output bound to something that drives, or an input to something that listens.
    #[error("'{port}' is an {direction}, so it cannot be bound to '{resource}', {kind}")]
    WrongDirection {
        port: String,
        direction: Direction,
        resource: String,
        kind: String,
    },
    /// The clock on something that does not tick, or another port on an oscillator.
    #[error("a board clock can be bound to the clock port '{clock_port}' and to nothing else, but '{port}' is bound to '{resource}'")]
    ClockMixUp {
        clock_port: String,
        port: String,
        resource: String,
    },
    /// A board clock faster than the design is to be built for.
    #[error("board clock '{resource}' ticks every {board_ns:.3} ns, which is faster than the {period_ns} ns asked for")]
    ClockTooFast {
        resource: String,
        board_ns: f64,
        period_ns: f64,
    },
}

/// `; did you mean 'x'?`, or a semicolon alone; the list of known names comes next.
fn did_you_mean(suggestion: &Option<String>) -> String {
    match suggestion {
        Some(name) => format!("; did you mean '{name}'?"),
        None => ";".to_owned(),
    }
}

/// Text of the caller's, with control characters escaped so that a message stays one line.
fn one_line(text: &str) -> String {
    text.chars()
        .flat_map(|c| {
            let escaped: Vec<char> = if c.is_control() {
                c.escape_default().collect()
            } else {
                vec![c]
            };
            escaped
        })
        .collect()
}

/// The candidate that `name` begins, or else the nearest one if it is near enough to be a slip of
/// the keyboard.
pub(crate) fn nearest<'a>(name: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let name = name.to_lowercase();
    let length = name.chars().count();
    let begun = candidates
        .iter()
        .find(|c| length >= 3 && c.to_lowercase().starts_with(&name));
    let distance = |c: &str| strsim::damerau_levenshtein(&name, &c.to_lowercase());
    let near = || {
        candidates
            .iter()
            .filter(|c| distance(c) <= (length / 3).max(1))
            .min_by_key(|c| distance(c))
    };
    begun.or_else(near).copied()
}
