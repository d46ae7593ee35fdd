//! rust-hdl's ROM, SyncROM and RAM, sparse and dense, and the project's frame memory.

use crate::harness::case::Case;
use crate::harness::code::drive;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;
use shadegate_hdl::depth::frame_memory::FrameMemory;
use shadegate_hdl::format::U;
use std::collections::BTreeMap;

fn dense<const N: usize, const W: usize>() -> BTreeMap<Bits<N>, Bits<W>> {
    let word = |i: u64| (i * 0x9e37 + 77) & ((1 << W) - 1);
    (0..1 << N).map(|i| (i.into(), word(i).into())).collect()
}

fn sparse<const N: usize>() -> BTreeMap<Bits<N>, Signed<9>> {
    [(0u64, 5i64), (3, -7), (9, 255), (12, -256)]
        .into_iter()
        .map(|(a, v)| (a.into(), v.into()))
        .collect()
}

/// Asynchronous and synchronous tables, dense and sparse.
#[derive(LogicBlock)]
struct Tables {
    clock: Signal<In, Clock>,
    at: Signal<In, Bits<4>>,
    now: Signal<Out, Bits<12>>,
    thin: Signal<Out, Signed<9>>,
    then: Signal<Out, Bits<12>>,
    later: Signal<Out, Signed<9>>,
    rom: ROM<Bits<12>, 4>,
    sparse_rom: ROM<Signed<9>, 4>,
    sync: SyncROM<Bits<12>, 4>,
    sparse_sync: SyncROM<Signed<9>, 4>,
}

impl Default for Tables {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            at: Default::default(),
            now: Default::default(),
            thin: Default::default(),
            then: Default::default(),
            later: Default::default(),
            rom: ROM::new(dense()),
            sparse_rom: ROM::new(sparse()),
            sync: SyncROM::new(dense()),
            sparse_sync: SyncROM::new(sparse()),
        }
    }
}

impl Logic for Tables {
    #[hdl_gen]
    fn update(&mut self) {
        self.rom.address.next = self.at.val();
        self.sparse_rom.address.next = self.at.val() + 1;
        self.sync.address.next = self.at.val();
        self.sync.clock.next = self.clock.val();
        self.sparse_sync.address.next = !self.at.val();
        self.sparse_sync.clock.next = self.clock.val();
        self.now.next = self.rom.data.val();
        self.thin.next = self.sparse_rom.data.val();
        self.then.next = self.sync.data.val() + 1;
        self.later.next = self.sparse_sync.data.val();
    }
}

drive!(Tables, clock; at);

/// A RAM that is written and read at once: a read gives the old word.
#[derive(LogicBlock)]
struct ReadAndWrite<const W: usize> {
    clock: Signal<In, Clock>,
    from: Signal<In, Bits<3>>,
    to: Signal<In, Bits<3>>,
    data: Signal<In, Bits<W>>,
    write: Signal<In, Bit>,
    o: Signal<Out, Bits<W>>,
    ram: RAM<Bits<W>, 3>,
}

impl<const W: usize> ReadAndWrite<W> {
    fn new(words: BTreeMap<Bits<3>, Bits<W>>) -> Self {
        Self {
            clock: Default::default(),
            from: Default::default(),
            to: Default::default(),
            data: Default::default(),
            write: Default::default(),
            o: Default::default(),
            ram: RAM::new(words),
        }
    }
}

impl<const W: usize> Logic for ReadAndWrite<W> {
    #[hdl_gen]
    fn update(&mut self) {
        self.ram.read_clock.next = self.clock.val();
        self.ram.write_clock.next = self.clock.val();
        self.ram.read_address.next = self.from.val();
        self.ram.write_address.next = self.to.val();
        self.ram.write_data.next = self.data.val();
        self.ram.write_enable.next = self.write.val();
        self.o.next = self.ram.read_data.val();
    }
}

drive!(ReadAndWrite<13>, clock; from, to, data, write);
drive!(ReadAndWrite<1>, clock; from, to, data, write);
drive!(ReadAndWrite<70>, clock; from, to, data, write);

/// The frame memory, with fewer words than addresses and with as many.
#[derive(LogicBlock)]
struct Frame {
    clock: Signal<In, Clock>,
    from: Signal<In, U<4>>,
    to: Signal<In, U<4>>,
    data: Signal<In, U<16>>,
    read: Signal<In, Bit>,
    write: Signal<In, Bit>,
    o: Signal<Out, U<16>>,
    memory: FrameMemory<4>,
}

impl Frame {
    fn new(words: usize) -> Self {
        Self {
            clock: Default::default(),
            from: Default::default(),
            to: Default::default(),
            data: Default::default(),
            read: Default::default(),
            write: Default::default(),
            o: Default::default(),
            memory: FrameMemory::new(words),
        }
    }
}

impl Logic for Frame {
    #[hdl_gen]
    fn update(&mut self) {
        self.memory.clock.next = self.clock.val();
        self.memory.read.next = self.read.val();
        self.memory.read_address.next = self.from.val();
        self.memory.write.next = self.write.val();
        self.memory.write_address.next = self.to.val();
        self.memory.write_data.next = self.data.val();
        self.o.next = self.memory.read_data.val();
    }
}

drive!(Frame, clock; from, to, data, read, write);

/// A table, a memory and a register feed each other.
#[derive(LogicBlock)]
struct Together {
    clock: Signal<In, Clock>,
    a: Signal<In, Bits<3>>,
    o: Signal<Out, Bits<13>>,
    words: ROM<Bits<13>, 3>,
    memory: ReadAndWrite<13>,
    count: DFF<Bits<3>>,
}

impl Default for Together {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            a: Default::default(),
            o: Default::default(),
            words: ROM::new(dense()),
            memory: ReadAndWrite::new(BTreeMap::new()),
            count: Default::default(),
        }
    }
}

impl Logic for Together {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, count);
        self.count.d.next = self.count.q.val() + self.a.val();
        self.words.address.next = self.count.q.val();
        self.memory.clock.next = self.clock.val();
        self.memory.from.next = self.a.val();
        self.memory.to.next = self.count.q.val();
        self.memory.data.next = self.words.data.val() ^ self.memory.o.val();
        self.memory.write.next = self.a.val().xor();
        self.o.next = self.memory.o.val();
    }
}

drive!(Together, clock; a);

pub fn cases() -> Vec<Case> {
    let some = |list: &[(u64, u64)]| {
        list.iter()
            .map(|(a, v)| ((*a).into(), (*v).into()))
            .collect()
    };
    vec![
        Case::of::<Tables>(),
        Case::named("ram_empty", ReadAndWrite::<13>::new(BTreeMap::new())),
        Case::named(
            "ram_sparse",
            ReadAndWrite::<13>::new(some(&[(1, 8191), (6, 4096)])),
        ),
        Case::named("ram_dense", ReadAndWrite::<13>::new(dense())),
        Case::named(
            "ram_of_bits",
            ReadAndWrite::<1>::new(BTreeMap::from([(2.into(), 1.into())])),
        ),
        Case::named(
            "ram_of_long_words",
            ReadAndWrite::<70>::new(BTreeMap::from([(7.into(), 12345.into())])),
        ),
        Case::named("frame_partial", Frame::new(11)),
        Case::named("frame_full", Frame::new(16)),
        Case::of::<Together>(),
    ]
}
