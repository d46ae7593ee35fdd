//! Memories behind Verilog text.
//!
//! rust-hdl's own `RAM`, `ROM` and `SyncROM` print themselves as text, and keep their words private. Their text is
//! taken apart and then printed again from what was understood: only when both are equal, word for word, is it them.
//! A memory of this project says what it is in remarks, which its text carries for this reader:
//!
//! ```text
//! //! memory words=76800 width=16 outside=kept
//! //! read address=read_address data=read_data enable=read clock=clock
//! //! write address=write_address data=write_data enable=write clock=clock
//! //! initial 0 1f 3 …                 (hexadecimal, any number of lines)
//! ```

use crate::netlist::read::literal_code;
use crate::netlist::{Memory, NetlistError, ReadPort, Signal, WritePort};
use std::collections::HashMap;

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// `key=value` pairs of a remark.
fn pairs(text: &str) -> HashMap<&str, &str> {
    text.split_whitespace()
        .filter_map(|w| w.split_once('='))
        .collect()
}

/// `mem[3'h1] = 8'h2;` and the like: address and code.
fn entries<'a>(text: &'a str, begin: &str, between: &str) -> Option<Vec<(u128, u128)>> {
    let lines = text.split(';').map(str::trim).filter(|l| !l.is_empty());
    lines
        .map(|l: &'a str| {
            let (address, code) = l.strip_prefix(begin)?.split_once(between)?;
            Some((literal_code(address.trim())?, literal_code(code.trim())?))
        })
        .collect()
}

fn table(entries: &[(u128, u128)], size: usize) -> Option<Vec<u128>> {
    let mut out = vec![];
    for (address, code) in entries {
        let address = usize::try_from(*address).ok().filter(|a| *a < size)?;
        if out.len() <= address {
            out.resize(address + 1, 0);
        }
        out[address] = *code;
    }
    Some(out)
}

/// Words of a memory with this many address bits; more than this cannot be meant.
fn size(bits: usize) -> Option<usize> {
    (bits <= 28).then(|| 1 << bits)
}

fn width_of(signals: &[Signal], name: &str) -> Option<usize> {
    signals
        .iter()
        .find(|s| s.name == name)
        .map(|s| s.format.width())
}

fn has_ports(signals: &[Signal], names: &[&str]) -> bool {
    signals.len() == names.len() && names.iter().all(|n| signals.iter().any(|s| s.name == *n))
}

/// rust-hdl's `ROM`: the word follows the address; addresses that were not given hold the default.
fn rom(text: &str, signals: &[Signal]) -> Option<Memory> {
    if !has_ports(signals, &["address", "data"]) {
        return None;
    }
    let inner = text
        .strip_prefix("always @* case (address) ")?
        .strip_suffix(" endcase")?;
    let (cases, default) = inner.rsplit_once("default: data = ")?;
    let default = literal_code(default.strip_suffix(';')?)?;
    let size = size(width_of(signals, "address")?)?;
    let given = entries(cases, "", ": data = ")?;
    let mut initial = vec![default; size];
    for (address, code) in given {
        *initial.get_mut(usize::try_from(address).ok()?)? = code;
    }
    Some(Memory {
        words: size,
        width: width_of(signals, "data")?,
        initial,
        outside_is_zero: true,
        read: ReadPort {
            address: "address".into(),
            data: "data".into(),
            enable: None,
            clock: None,
        },
        write: None,
    })
}

/// rust-hdl's `SyncROM`.
fn sync_rom(text: &str, signals: &[Signal]) -> Option<Memory> {
    if !has_ports(signals, &["address", "clock", "data"]) {
        return None;
    }
    let width = width_of(signals, "data")?;
    let size = size(width_of(signals, "address")?)?;
    let head = format!("reg[{}:0] mem [{}:0]; initial begin ", width - 1, size - 1);
    let tail = " end always @(posedge clock) begin data <= mem[address]; end";
    let inner = text.strip_prefix(&head)?.strip_suffix(tail)?;
    let initial = table(&entries(&inner.replace("mem[", ""), "", "] = ")?, size)?;
    Some(Memory {
        words: size,
        width,
        initial,
        outside_is_zero: true,
        read: ReadPort {
            address: "address".into(),
            data: "data".into(),
            enable: None,
            clock: Some("clock".into()),
        },
        write: None,
    })
}

/// rust-hdl's `RAM`.
fn ram(text: &str, signals: &[Signal]) -> Option<Memory> {
    let ports = [
        "read_address",
        "read_clock",
        "read_data",
        "write_address",
        "write_clock",
        "write_data",
        "write_enable",
    ];
    if !has_ports(signals, &ports) {
        return None;
    }
    let width = width_of(signals, "read_data")?;
    let size = size(width_of(signals, "read_address")?)?;
    let head = format!("reg[{}:0] mem[{}:0];", width - 1, size - 1);
    let tail = "always @(posedge read_clock) begin read_data <= mem[read_address]; end \
                always @(posedge write_clock) begin if (write_enable) begin mem[write_address] <= write_data; end end";
    let inner = text.strip_prefix(&head)?.strip_suffix(tail)?.trim();
    let initial = match inner {
        "" => vec![],
        _ => {
            let inner = inner.strip_prefix("initial begin ")?.strip_suffix(" end")?;
            table(&entries(&inner.replace("mem[", ""), "", "] = ")?, size)?
        }
    };
    Some(Memory {
        words: size,
        width,
        initial,
        outside_is_zero: true,
        read: ReadPort {
            address: "read_address".into(),
            data: "read_data".into(),
            enable: None,
            clock: Some("read_clock".into()),
        },
        write: Some(WritePort {
            address: "write_address".into(),
            data: "write_data".into(),
            enable: "write_enable".into(),
            clock: "write_clock".into(),
        }),
    })
}

/// A memory that says so in remarks.
fn described(text: &str) -> Option<Result<Memory, String>> {
    let remarks: Vec<&str> = text
        .lines()
        .filter_map(|l| l.strip_prefix("//! "))
        .collect();
    let of = |key: &str| {
        remarks
            .iter()
            .find_map(|r| r.strip_prefix(key)?.strip_prefix(' '))
    };
    let head = pairs(of("memory")?);
    let number = |key: &str| head.get(key).and_then(|v| v.parse::<usize>().ok());
    let read = || -> Option<ReadPort> {
        let p = pairs(of("read")?);
        Some(ReadPort {
            address: (*p.get("address")?).into(),
            data: (*p.get("data")?).into(),
            enable: p.get("enable").map(|e| (*e).into()),
            clock: p.get("clock").map(|c| (*c).into()),
        })
    };
    let write = |text: &str| -> Option<WritePort> {
        let p = pairs(text);
        Some(WritePort {
            address: (*p.get("address")?).into(),
            data: (*p.get("data")?).into(),
            enable: (*p.get("enable")?).into(),
            clock: (*p.get("clock")?).into(),
        })
    };
    let initial = remarks.iter().filter_map(|r| r.strip_prefix("initial "));
    let initial: Option<Vec<u128>> = initial
        .flat_map(str::split_whitespace)
        .map(|w| u128::from_str_radix(w, 16).ok())
        .collect();
    let made = || -> Option<Memory> {
        Some(Memory {
            words: number("words")?,
            width: number("width")?,
            initial: initial?,
            outside_is_zero: match *head.get("outside")? {
                "zero" => true,
                "kept" => false,
                _ => return None,
            },
            read: read()?,
            write: match of("write") {
                Some(text) => Some(write(text)?),
                None => None,
            },
        })
    };
    Some(made().ok_or_else(|| "its memory remarks are incomplete".to_string()))
}

/// Whether ports, widths and sizes agree.
fn agrees(m: &Memory, signals: &[Signal]) -> Result<(), String> {
    let width =
        |name: &str| width_of(signals, name).ok_or_else(|| format!("port {name} does not exist"));
    let expect = |name: &str, bits: usize| match width(name)? {
        w if w == bits => Ok(()),
        w => Err(format!("port {name} has {w} bits, not {bits}")),
    };
    expect(&m.read.data, m.width)?;
    let bits = width(&m.read.address)?;
    if m.words == 0 || bits < 64 && m.words as u64 > 1 << bits {
        return Err(format!("{} words do not have {bits} address bits", m.words));
    }
    if m.initial.len() > m.words || m.initial.iter().any(|c| m.width < 128 && c >> m.width != 0) {
        return Err("its initial words do not fit".into());
    }
    for name in m.read.enable.iter().chain(&m.read.clock) {
        expect(name, 1)?;
    }
    if let Some(w) = &m.write {
        expect(&w.data, m.width)?;
        expect(&w.address, bits)?;
        expect(&w.enable, 1)?;
        expect(&w.clock, 1)?;
    }
    Ok(())
}

/// The memory that a body of Verilog text is.
///
/// # Errors
/// Text that is none, or contradicts its ports.
pub fn read(module: &str, text: &str, signals: &[Signal]) -> Result<Memory, NetlistError> {
    let flat = words(text);
    let own = || {
        rom(&flat, signals)
            .or_else(|| sync_rom(&flat, signals))
            .or_else(|| ram(&flat, signals))
    };
    let memory = match described(text) {
        Some(made) => made.map_err(|why| NetlistError::new(module, why))?,
        None => own().ok_or_else(|| {
            NetlistError::new(
                module,
                "its Verilog text is not one of rust-hdl's memories and has no memory remarks",
            )
        })?,
    };
    agrees(&memory, signals).map_err(|why| NetlistError::new(module, why))?;
    Ok(memory)
}
