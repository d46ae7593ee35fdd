//! Memories and tables: bodies that are data, not statements.
//!
//! All read ports give the old word when the same clock writes it. Words that no one has written are their initial
//! codes. Addresses beyond the last word read zero from a table ([`Memory::outside_is_zero`]), or read and write nothing.

/// How a word is read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadPort {
    /// Input that gives the address, an unsigned word.
    pub address: String,
    /// Output that shows the word.
    pub data: String,
    /// Input bit that allows the read; `None`: every clock. A port that does not read keeps its word.
    pub enable: Option<String>,
    /// Clock input whose rising edge reads; `None`: the word follows the address without a clock.
    pub clock: Option<String>,
}

/// How a word is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WritePort {
    /// Input that gives the address, an unsigned word.
    pub address: String,
    /// Input that gives the word.
    pub data: String,
    /// Input bit that allows the write.
    pub enable: String,
    /// Clock input whose rising edge writes.
    pub clock: String,
}

/// A memory: one read port, and a write port unless it is a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Memory {
    /// Number of words, at least one; never more than the address can name.
    pub words: usize,
    /// Bits of a word.
    pub width: usize,
    /// Initial codes of the first words; zeros follow.
    pub initial: Vec<u128>,
    /// Whether a read beyond the last word gives zero; otherwise it leaves the read data as they are.
    pub outside_is_zero: bool,
    /// The read port.
    pub read: ReadPort,
    /// The write port.
    pub write: Option<WritePort>,
}
