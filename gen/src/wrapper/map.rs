//! The address map of the wrappers: byte addresses of 32-bit registers.

use serde::Serialize;

/// Address bits of a wrapper, bytes included.
pub const ADDRESS_BITS: usize = 11;
/// First register word; the word with select code `s` is at `WORDS + 4 * s`.
pub const WORDS: u32 = 0x000;
/// Upper part of the next words written.
pub const HIGH: u32 = 0x400;
/// Start, clear, end of frame.
pub const CONTROL: u32 = 0x404;
/// What the core is doing.
pub const STATUS: u32 = 0x408;

/// A register, or a range of them, of the wrappers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Entry {
    /// First byte address.
    pub address: u32,
    /// Last byte address of the range, the same for a single register.
    pub last: u32,
    /// Name.
    pub name: &'static str,
    /// `write`, `read`, or both.
    pub access: &'static str,
    /// What it means.
    pub meaning: String,
}

/// The map for a core with a register bus of `bus_bits`.
#[must_use]
pub fn entries(bus_bits: usize) -> Vec<Entry> {
    let high = match bus_bits.saturating_sub(32) {
        0 => "no bits in this core, whose register bus has 32: reads as 0, writes change nothing".to_owned(),
        bits => format!(
            "bits {} to 32 of every word written from now on, in bits {} to 0; 0 after reset. A word's upper bits are written here first, and need not be written again while they stay the same",
            bus_bits - 1,
            bits - 1
        ),
    };
    let entry = |address, last, name, access, meaning| Entry {
        address,
        last,
        name,
        access,
        meaning,
    };
    vec![
        entry(
            WORDS,
            HIGH - 4,
            "word",
            "write",
            "register word with select code address / 4 (see the register map); the write waits while the core's load_ready is low"
                .to_owned(),
        ),
        entry(HIGH, HIGH, "high", "read, write", high),
        entry(
            CONTROL,
            CONTROL,
            "control",
            "write",
            "bit 0 start: the words are complete, waits for load_ready. Bit 1 clear: clears the depth memory, waits until the core is idle. Bit 2 end: the last pixel of what has been started is marked as the last of its frame. Start and clear also wait until the frame before has left. Start and end may be written together"
                .to_owned(),
        ),
        entry(
            STATUS,
            STATUS,
            "status",
            "read",
            "bit 0 load_ready, bit 1 busy, bit 2 an end is waiting for its last pixel".to_owned(),
        ),
    ]
}
