//! Checks a request whole, and works out which port bits are placed and which are left over.

use crate::error::nearest;
use crate::request::SAME_PERIOD_NS;
use crate::{
    Binding, Board, ConstraintError, Direction, Package, Port, Request, Resource, ResourceKind,
};
use std::collections::{BTreeMap, BTreeSet};

/// One port bit on its pin.
pub(crate) struct Placed<'a> {
    pub port: &'a Port,
    pub bit: Option<u32>,
    pub resource: &'a Resource,
}

impl Placed<'_> {
    /// The bit's name with the index in the given brackets: `leds[2]`, or `busy`.
    pub fn name(&self, open: char, close: char) -> String {
        match self.bit {
            Some(bit) => format!("{}{open}{bit}{close}", self.port.name),
            None => self.port.name.clone(),
        }
    }
}

/// Some bits of one port that no pin is known for.
pub(crate) struct Unplaced<'a> {
    pub port: &'a Port,
    pub bits: u32,
}

/// A request that has been checked.
pub(crate) struct Checked<'a> {
    pub request: &'a Request<'a>,
    /// In the order of the ports, then of the bits.
    pub placed: Vec<Placed<'a>>,
    /// In the order of the ports.
    pub unplaced: Vec<Unplaced<'a>>,
    /// Whole picoseconds.
    pub period_ps: u64,
    pub package: Option<&'a Package>,
}

pub(crate) fn check<'a>(request: &'a Request<'a>) -> Result<Checked<'a>, ConstraintError> {
    identifier("design", request.design)?;
    let mut seen = BTreeSet::new();
    for port in request.ports {
        identifier("port", &port.name)?;
        if !seen.insert(&port.name) {
            let port = port.name.clone();
            return Err(ConstraintError::DuplicatePort { port });
        }
        if port.width == 0 {
            let port = port.name.clone();
            return Err(ConstraintError::NoBits { port });
        }
    }
    let is_clock =
        |p: &Port| p.name == request.clock_port && p.width == 1 && p.direction == Direction::Input;
    if !request.ports.iter().any(is_clock) {
        return Err(ConstraintError::NoClock {
            port: request.clock_port.to_owned(),
        });
    }
    let period_ps = period_ps(request.period_ns)?;
    if let Some(board) = request.board.filter(|b| b.device != request.device.name) {
        return Err(ConstraintError::WrongDevice {
            board: board.name.clone(),
            on_board: board.device.clone(),
            asked: request.device.name.clone(),
        });
    }
    let package_name = request
        .board
        .map_or(&request.device.package, |b| &b.package);
    let placed = place(request)?;
    let unplaced = leftovers(request.ports, &placed);
    Ok(Checked {
        request,
        placed,
        unplaced,
        period_ps,
        package: request.device.package_named(package_name),
    })
}

fn identifier(what: &'static str, name: &str) -> Result<(), ConstraintError> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if name.chars().all(plain) && name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        return Ok(());
    }
    Err(ConstraintError::BadName {
        what,
        name: name.to_owned(),
    })
}

fn period_ps(period_ns: f64) -> Result<u64, ConstraintError> {
    if !(0.1..=1e6).contains(&period_ns) {
        return Err(ConstraintError::BadPeriod { period_ns });
    }
    // Down, so that the file never asks for less than the caller; the millionth of a picosecond
    // undoes the binary rounding of decimal periods such as 2.3.
    Ok((period_ns * 1000.0 + 1e-6).floor() as u64)
}

fn place<'a>(request: &'a Request<'a>) -> Result<Vec<Placed<'a>>, ConstraintError> {
    // Keyed by the port's position and bit, which is also the order of the output.
    let mut by_port: BTreeMap<(usize, u32), Placed<'a>> = BTreeMap::new();
    let mut by_pin: BTreeMap<&str, String> = BTreeMap::new();
    for binding in request.bindings {
        let (index, placed) = resolve(request, binding)?;
        let name = placed.name('[', ']');
        let resource = placed.resource;
        let key = (index, placed.bit.unwrap_or(0));
        if let Some(first) = by_port.get(&key) {
            return Err(ConstraintError::PortTwice {
                port: name,
                first: first.resource.name.clone(),
                second: resource.name.clone(),
            });
        }
        if let Some(first) = by_pin.insert(&resource.pin, name.clone()) {
            return Err(ConstraintError::PinTwice {
                pin: resource.pin.clone(),
                resource: resource.name.clone(),
                first,
                second: name,
            });
        }
        by_port.insert(key, placed);
    }
    Ok(by_port.into_values().collect())
}

fn resolve<'a>(
    request: &'a Request<'a>,
    binding: &'a Binding,
) -> Result<(usize, Placed<'a>), ConstraintError> {
    let Some((index, port)) = request
        .ports
        .iter()
        .enumerate()
        .find(|(_, p)| p.name == binding.port)
    else {
        let known: Vec<&str> = request.ports.iter().map(|p| p.name.as_str()).collect();
        return Err(ConstraintError::NoSuchPort {
            port: binding.port.clone(),
            resource: binding.resource.clone(),
            suggestion: nearest(&binding.port, &known).map(str::to_owned),
            known: known.join(", "),
        });
    };
    let Some(board) = request.board else {
        return Err(ConstraintError::NoBoard {
            port: port.name.clone(),
            resource: binding.resource.clone(),
        });
    };
    let resource = resource(board, &binding.resource)?;
    let bit = match binding.bit {
        None if port.width > 1 => {
            return Err(ConstraintError::BitNeeded {
                port: port.name.clone(),
                width: port.width,
                resource: resource.name.clone(),
            })
        }
        Some(bit) if bit >= port.width => {
            return Err(ConstraintError::NoSuchBit {
                port: port.name.clone(),
                width: port.width,
                bit,
            })
        }
        // Bit 0 of a one-bit port is the port.
        bit => bit.filter(|_| port.width > 1),
    };
    let placed = Placed {
        port,
        bit,
        resource,
    };
    direction(&placed)?;
    clock(request, &placed)?;
    Ok((index, placed))
}

fn resource<'a>(board: &'a Board, name: &str) -> Result<&'a Resource, ConstraintError> {
    board.resource(name).ok_or_else(|| {
        let known: Vec<&str> = board.resources.iter().map(|r| r.name.as_str()).collect();
        ConstraintError::NoSuchResource {
            board: board.name.clone(),
            resource: name.to_owned(),
            suggestion: nearest(name, &known).map(str::to_owned),
            known: known.join(", "),
        }
    })
}

fn direction(placed: &Placed) -> Result<(), ConstraintError> {
    let fits = match placed.port.direction {
        Direction::Input => placed.resource.kind.drives_fpga(),
        Direction::Output => !placed.resource.kind.drives_fpga(),
        Direction::InOut => false,
    };
    if fits {
        return Ok(());
    }
    Err(ConstraintError::WrongDirection {
        port: placed.name('[', ']'),
        direction: placed.port.direction,
        resource: placed.resource.name.clone(),
        kind: placed.resource.kind.with_article(),
    })
}

fn clock(request: &Request, placed: &Placed) -> Result<(), ConstraintError> {
    let resource = placed.resource;
    let is_clock_port = placed.port.name == request.clock_port;
    if is_clock_port != (resource.kind == ResourceKind::Clock) {
        return Err(ConstraintError::ClockMixUp {
            clock_port: request.clock_port.to_owned(),
            port: placed.name('[', ']'),
            resource: resource.name.clone(),
        });
    }
    match resource.period_ns() {
        Some(board_ns) if board_ns + SAME_PERIOD_NS < request.period_ns => {
            Err(ConstraintError::ClockTooFast {
                resource: resource.name.clone(),
                board_ns,
                period_ns: request.period_ns,
            })
        }
        _ => Ok(()),
    }
}

fn leftovers<'a>(ports: &'a [Port], placed: &[Placed]) -> Vec<Unplaced<'a>> {
    ports
        .iter()
        .filter_map(|port| {
            let on_pins = placed.iter().filter(|p| p.port.name == port.name).count();
            let bits = port.width - u32::try_from(on_pins).unwrap_or(port.width).min(port.width);
            (bits > 0).then_some(Unplaced { port, bits })
        })
        .collect()
}
