//! FST files, much smaller than VCD.

use super::tree::{Header, Tree};
use super::Sink;
use fst_writer::{
    FstBodyWriter, FstFileType, FstHeaderWriter, FstInfo, FstScopeType, FstSignalId, FstSignalType,
    FstVarDirection, FstVarType, FstWriteError,
};
use std::io::{self, Seek, Write};

/// Bytes of changes that are kept before they are written as a block.
const BLOCK: usize = 1 << 24;

/// Records: identifier and bits.
type Records = Vec<Option<(FstSignalId, u32)>>;

struct Head<W: Write + Seek> {
    writer: FstHeaderWriter<W>,
    records: Records,
}

/// A file whose header is written.
struct Fst<W: Write + Seek> {
    writer: FstBodyWriter<W>,
    records: Records,
    digits: Vec<u8>,
}

fn error(e: FstWriteError) -> io::Error {
    match e {
        FstWriteError::Io(e) => e,
        other => io::Error::other(other),
    }
}

/// Writes the header.
pub fn begin<W: Write + Seek>(out: W, tree: &Tree) -> io::Result<impl Sink> {
    let info = FstInfo {
        start_time: 0,
        timescale_exponent: -12,
        version: format!("shadegate {}", env!("CARGO_PKG_VERSION")),
        date: String::new(),
        file_type: FstFileType::Verilog,
    };
    let mut head = Head {
        writer: FstHeaderWriter::new(out, &info).map_err(error)?,
        records: vec![],
    };
    tree.write("top", &mut head)?;
    Ok(Fst {
        writer: head.writer.finish().map_err(error)?,
        records: head.records,
        digits: vec![],
    })
}

impl<W: Write + Seek> Header for Head<W> {
    fn scope(&mut self, name: &str) -> io::Result<()> {
        let scope = self.writer.scope(name, "", FstScopeType::Module);
        scope.map_err(error)
    }

    fn up(&mut self) -> io::Result<()> {
        self.writer.up_scope().map_err(error)
    }

    fn variable(&mut self, name: &str, width: u32, record: usize) -> io::Result<()> {
        if self.records.len() <= record {
            self.records.resize(record + 1, None);
        }
        let alias = self.records[record].map(|r| r.0);
        let bits = FstSignalType::bit_vec(width);
        let direction = FstVarDirection::Implicit;
        let id = self
            .writer
            .var(name, bits, FstVarType::Wire, direction, alias)
            .map_err(error)?;
        self.records[record] = Some((id, width));
        Ok(())
    }
}

impl<W: Write + Seek> Sink for Fst<W> {
    fn time(&mut self, ps: u64) -> io::Result<()> {
        if self.writer.size() > BLOCK {
            self.writer.flush().map_err(error)?;
        }
        self.writer.time_change(ps).map_err(error)
    }

    fn change(&mut self, record: usize, code: u128) -> io::Result<()> {
        let Some(Some((id, width))) = self.records.get(record).copied() else {
            return Ok(());
        };
        self.digits.clear();
        let digits = (0..width).rev().map(|i| b'0' + (code >> i & 1) as u8);
        self.digits.extend(digits);
        let change = self.writer.signal_change(id, &self.digits);
        change.map_err(error)
    }

    fn initial(&mut self, _: bool) -> io::Result<()> {
        Ok(())
    }

    fn end(self: Box<Self>) -> io::Result<()> {
        self.writer.finish().map_err(error)?.flush()
    }
}
