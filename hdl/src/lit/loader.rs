//! Where the words of tables go: a pointer that moves on by itself, and the strobes of the tables.
//!
//! Tables are not double-buffered: a host writes them before the first span of a frame.
//!
//! | word | content |
//! |---|---|
//! | 2 | pointer\[11:0\]: where the next table word goes |
//! | 3 | a word of the highlight table, {angle or cosine, material}; moves the pointer on |
//! | 4 | a colour: material\[31:30\], cell\[29:26\], Q11.6\[17:0\]; cell 3·channel + part, parts ambient, diffuse, highlight |
//! | 5 | a word of the cosine table, where the core has one; moves the pointer on |

use crate::format::{mask, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Word of the pointer.
pub const POINTER: usize = 2;
/// Word of the highlight table.
pub const HIGHLIGHT: usize = 3;
/// Word of the colours.
pub const COLOUR: usize = 4;
/// Word of the cosine table.
pub const COSINE: usize = 5;

/// Latency: none from a write to its strobe.
#[derive(LogicBlock, Default)]
pub struct TableLoader {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// A shell word is written.
    pub write: Signal<In, Bit>,
    /// Which.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// Where the next table word goes.
    pub address: Signal<Out, U<12>>,
    /// `data` is a word of the highlight table.
    pub write_highlight: Signal<Out, Bit>,
    /// `data` is a colour.
    pub write_colour: Signal<Out, Bit>,
    /// `data` is a word of the cosine table.
    pub write_cosine: Signal<Out, Bit>,
    /// Where the next table word goes.
    pointer: Register<U<12>>,
    /// The highlight table is written.
    to_highlight: Wire<Bit>,
    /// The cosine table is written.
    to_cosine: Wire<Bit>,
}

impl Logic for TableLoader {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name table_loader");
        comment!("title Strobes and address of the tables that a host writes before a frame.");
        comment!("equation pointer = data, then pointer + 1 with every table word");
        comment!("source Ours: tables are loaded again for other materials.");
        comment!("latency None from a write to its strobe.");
        dff_setup!(self, clock, pointer);
        self.to_highlight.next = self.write.val() && (self.word.val() == 3u64.into());
        self.to_cosine.next = self.write.val() && (self.word.val() == 5u64.into());
        if self.write.val() && (self.word.val() == 2u64.into()) {
            self.pointer.d.next = self.data.val().get_bits::<12>(0);
        } else if self.to_highlight.val() || self.to_cosine.val() {
            self.pointer.d.next = self.pointer.q.val() + 1u64.into();
        }
        self.address.next = self.pointer.q.val();
        self.write_highlight.next = self.to_highlight.val();
        self.write_colour.next = self.write.val() && (self.word.val() == 4u64.into());
        self.write_cosine.next = self.to_cosine.val();
    }
}

crate::clocked!(TableLoader;
    inputs write, word, data;
    outputs address, write_highlight, write_colour, write_cosine);

/// Integer model of [`TableLoader`].
#[derive(Clone, Copy, Debug, Default)]
pub struct TableLoaderModel {
    pointer: u64,
}

impl TableLoaderModel {
    /// Address and data for the table of register word `table`, if this write is for it.
    #[must_use]
    pub fn table(&self, write: Option<(usize, u64)>, table: usize) -> Option<(u64, u64)> {
        let (_, data) = write.filter(|(word, _)| *word == table)?;
        Some((self.pointer, data))
    }

    /// One clock.
    pub fn clock(&mut self, write: Option<(usize, u64)>) {
        match write {
            Some((POINTER, data)) => self.pointer = data & mask(12),
            Some((HIGHLIGHT | COSINE, _)) => self.pointer = (self.pointer + 1) & mask(12),
            _ => {}
        }
    }
}
