//! VCD files.

use super::tree::{Header, Tree};
use super::Sink;
use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;
use vcd::{IdCode, SimulationCommand, TimescaleUnit, Value, VarType, Writer};

/// Output that the writer of the format, which does not give it back, shares with the one who completes it.
struct Shared<W: Write>(Rc<RefCell<W>>);

impl<W: Write> Write for Shared<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.borrow_mut().flush()
    }
}

/// A file whose header is written.
struct Vcd<W: Write> {
    writer: Writer<Shared<W>>,
    out: Shared<W>,
    /// Identifier and bits of each record.
    records: Vec<Option<(IdCode, u32)>>,
}

/// Writes the header.
pub fn begin<W: Write>(out: W, tree: &Tree) -> io::Result<impl Sink> {
    let out = Rc::new(RefCell::new(out));
    let mut v = Vcd {
        writer: Writer::new(Shared(out.clone())),
        out: Shared(out),
        records: vec![],
    };
    v.writer.timescale(1, TimescaleUnit::PS)?;
    tree.write("top", &mut v)?;
    v.writer.enddefinitions()?;
    Ok(v)
}

impl<W: Write> Header for Vcd<W> {
    fn scope(&mut self, name: &str) -> io::Result<()> {
        self.writer.add_module(name)
    }

    fn up(&mut self) -> io::Result<()> {
        self.writer.upscope()
    }

    fn variable(&mut self, name: &str, width: u32, record: usize) -> io::Result<()> {
        if self.records.len() <= record {
            self.records.resize(record + 1, None);
        }
        match self.records[record] {
            Some((id, _)) => self.writer.var_def(VarType::Wire, width, id, name, None),
            None => {
                let id = self.writer.add_wire(width, name)?;
                self.records[record] = Some((id, width));
                Ok(())
            }
        }
    }
}

impl<W: Write> Sink for Vcd<W> {
    fn time(&mut self, ps: u64) -> io::Result<()> {
        self.writer.timestamp(ps)
    }

    fn change(&mut self, record: usize, code: u128) -> io::Result<()> {
        let Some(Some((id, width))) = self.records.get(record).copied() else {
            return Ok(());
        };
        let bit = |i: u32| Value::from(code >> i & 1 == 1);
        if width == 1 {
            return self.writer.change_scalar(id, bit(0));
        }
        let bits: Vec<Value> = (0..width).rev().map(bit).collect();
        self.writer.change_vector(id, &bits)
    }

    fn initial(&mut self, begin: bool) -> io::Result<()> {
        if begin {
            self.writer.begin(SimulationCommand::Dumpvars)
        } else {
            self.writer.end()
        }
    }

    fn end(mut self: Box<Self>) -> io::Result<()> {
        self.out.flush()
    }
}
