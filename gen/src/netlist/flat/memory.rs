//! Memories: their ports are the ports of their module.

use super::build::Builder;
use super::report::{error, join};
use super::{check, Driver, FlatMemory, MemoryId, SignalId};
use crate::netlist::{Format, Memory, Module, NetlistError, SignalKind};
use std::collections::{BTreeSet, HashMap};

/// Most bits of all words of a memory.
const MAX_BITS: usize = 1 << 33;

struct Ports<'a> {
    m: &'a Module,
    path: &'a str,
    ids: &'a HashMap<String, SignalId>,
}

impl Ports<'_> {
    fn fail<T>(&self, what: String) -> Result<T, NetlistError> {
        Err(error(&self.m.name, self.path, what))
    }

    /// A port of this direction and width (0: any).
    fn port(&self, name: &str, kind: SignalKind, width: usize) -> Result<SignalId, NetlistError> {
        let found = self.m.signal(name).filter(|s| {
            s.kind == kind && s.format != Format::Clock && (width == 0 || s.format.width() == width)
        });
        match found {
            Some(s) => Ok(self.ids[&s.name]),
            None => self.fail(format!("memory port {name} is not declared as such")),
        }
    }

    fn clock(&self, name: &str) -> Result<SignalId, NetlistError> {
        let found = self.m.signal(name);
        match found.filter(|s| s.kind == SignalKind::Input && s.format == Format::Clock) {
            Some(s) => Ok(self.ids[&s.name]),
            None => self.fail(format!("memory clock {name} is not a clock input")),
        }
    }
}

/// Adds a memory and makes its read data a driven signal.
pub(super) fn add<'a>(
    b: &mut Builder<'a>,
    m: &'a Module,
    path: &str,
    memory: &'a Memory,
    ids: &HashMap<String, SignalId>,
) -> Result<(), NetlistError> {
    let ports = Ports { m, path, ids };
    let fits = memory.words.checked_mul(memory.width.max(1));
    if memory.words == 0 || fits.is_none_or(|bits| bits > MAX_BITS) {
        return ports.fail(format!("a memory cannot have {} words", memory.words));
    }
    if memory.initial.len() > memory.words {
        return ports.fail("has more initial words than words".into());
    }
    for word in &memory.initial {
        check::code(m, path, "an initial word", *word, memory.width)?;
    }
    let r = &memory.read;
    let read_address = ports.port(&r.address, SignalKind::Input, 0)?;
    let read_data = ports.port(&r.data, SignalKind::Output, memory.width)?;
    let enable = r.enable.as_ref();
    let read_enable = enable
        .map(|e| ports.port(e, SignalKind::Input, 1))
        .transpose()?;
    let name = join(path, "memory");
    match &r.clock {
        Some(clock) => b.clocked.push((name.clone(), ports.clock(clock)?)),
        None => {
            let address = b.flat.signals[read_address.index()].format.width();
            let inside = address < usize::BITS as usize && 1 << address <= memory.words;
            if read_enable.is_some() || !(inside || memory.outside_is_zero) {
                return ports.fail("a read without a clock cannot keep its word".into());
            }
        }
    }
    let write = match &memory.write {
        None => None,
        Some(w) => {
            b.clocked.push((name, ports.clock(&w.clock)?));
            Some([
                ports.port(&w.address, SignalKind::Input, 0)?,
                ports.port(&w.data, SignalKind::Input, memory.width)?,
                ports.port(&w.enable, SignalKind::Input, 1)?,
            ])
        }
    };
    let id = MemoryId(b.flat.memories.len() as u32);
    let outputs: BTreeSet<&str> = m
        .signals
        .iter()
        .filter(|s| matches!(s.kind, SignalKind::Output | SignalKind::Local))
        .map(|s| s.name.as_str())
        .collect();
    if outputs.len() != 1 {
        return ports.fail("a memory drives its read data and nothing else".into());
    }
    b.flat.signals[read_data.index()].driver = Driver::Memory(id);
    b.flat.memories.push(FlatMemory {
        name: path.to_string(),
        memory,
        read_address,
        read_data,
        read_enable,
        write,
    });
    Ok(())
}
