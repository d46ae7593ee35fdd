//! Waveforms of the compiled simulation: chosen signals in a window of clocks, as VCD or FST by the name of the file.
//!
//! The file is written beside its place and moved there when it is whole. Time is in picoseconds, [`CLOCK_PS`] per
//! clock; the values at a clock are those behind its edge. Signals that are one wire under several names share one
//! record. Nothing here runs while no clock of the window is simulated.

mod fst;
mod pattern;
mod tree;
mod vcd;

use crate::engine::Wave;
use pattern::chosen;
use shadegate_gen::compile::{Signal, Simulator};
use shadegate_gen::netlist::NetlistError;
use shadegate_gen::write::temporary_beside;
use std::collections::HashMap;
use std::io;
use tempfile::NamedTempFile;
use tree::Tree;

/// Picoseconds per clock.
pub const CLOCK_PS: u64 = 10_000;

/// Why there is no waveform.
#[derive(Debug, thiserror::Error)]
pub enum WaveError {
    /// A pattern fits no signal.
    #[error("no signal fits '{0}'")]
    NoSignal(String),
    /// The file.
    #[error(transparent)]
    File(#[from] io::Error),
    /// The simulation.
    #[error(transparent)]
    Netlist(#[from] NetlistError),
}

/// A format of waveform files, once the header is written. Records are counted from 0 as they appear in the tree.
trait Sink {
    /// Begins a time.
    fn time(&mut self, ps: u64) -> io::Result<()>;
    /// A new value of a record.
    fn change(&mut self, record: usize, code: u128) -> io::Result<()>;
    /// The first values of all records follow, or (`false`) are complete.
    fn initial(&mut self, begin: bool) -> io::Result<()>;
    /// Completes the file.
    fn end(self: Box<Self>) -> io::Result<()>;
}

/// A waveform under construction.
pub struct Waveform {
    sink: Box<dyn Sink>,
    file: NamedTempFile,
    /// Record of the clock, which has two values in a clock.
    clock: Option<usize>,
    /// What the other records show, and the value last written.
    records: Vec<(usize, Signal, Option<u128>)>,
}

impl Waveform {
    /// Writes the header for the signals that the patterns choose; all without a pattern.
    ///
    /// # Errors
    /// A pattern that fits nothing, a file that cannot be written.
    pub fn begin(wave: &Wave, simulator: &Simulator) -> Result<Self, WaveError> {
        let names: Vec<&str> = simulator.signals().map(|s| s.0).collect();
        let clock = simulator.clock_name();
        for p in &wave.signals {
            let fits = |n: &&str| chosen(n, std::slice::from_ref(p));
            if !names.iter().copied().chain(clock).any(|n| fits(&n)) {
                return Err(WaveError::NoSignal(p.clone()));
            }
        }
        let mut tree = Tree::default();
        let mut count = 0;
        let mut next = || {
            count += 1;
            count - 1
        };
        let clock = clock.filter(|c| chosen(c, &wave.signals)).map(|name| {
            let record = next();
            tree.add(name, 1, record);
            record
        });
        let mut known: HashMap<(Signal, usize), usize> = HashMap::new();
        let mut records = vec![];
        for (name, format, signal) in simulator.signals() {
            if chosen(name, &wave.signals) {
                let record = *known.entry((signal, format.width())).or_insert_with(|| {
                    let record = next();
                    records.push((record, signal, None));
                    record
                });
                tree.add(name, format.width() as u32, record);
            }
        }
        let file = temporary_beside(&wave.file)?;
        let out = io::BufWriter::new(file.reopen()?);
        let ending = wave.file.extension();
        let sink: Box<dyn Sink> = if ending.is_some_and(|e| e.eq_ignore_ascii_case("fst")) {
            Box::new(fst::begin(out, &tree)?)
        } else {
            Box::new(vcd::begin(out, &tree)?)
        };
        Ok(Self {
            sink,
            file,
            clock,
            records,
        })
    }

    /// Shows the state behind the edge of a clock.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn clock(&mut self, cycle: u64, simulator: &mut Simulator) -> Result<(), WaveError> {
        simulator.settle_all()?;
        let first = self.records.iter().all(|r| r.2.is_none());
        self.sink.time(cycle * CLOCK_PS)?;
        if first {
            self.sink.initial(true)?;
        }
        if let Some(clock) = self.clock {
            self.sink.change(clock, 1)?;
        }
        for (record, signal, last) in &mut self.records {
            let code = simulator.peek(*signal)?;
            if *last != Some(code) {
                *last = Some(code);
                self.sink.change(*record, code)?;
            }
        }
        if first {
            self.sink.initial(false)?;
        }
        if let Some(clock) = self.clock {
            self.sink.time(cycle * CLOCK_PS + CLOCK_PS / 2)?;
            self.sink.change(clock, 0)?;
        }
        Ok(())
    }

    /// Moves the whole file to its place.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn end(self, wave: &Wave) -> Result<(), WaveError> {
        self.sink.end()?;
        self.file.persist(&wave.file).map_err(io::Error::from)?;
        Ok(())
    }
}
