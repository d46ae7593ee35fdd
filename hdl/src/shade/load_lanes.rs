//! The load port of a core that takes two or four register words per clock: each target of the register file gets the
//! word of the lowest lane that writes to it. See [`super::lanes`] for what a lane is.
//!
//! A core with one lane has nothing of this: [`LanePort`] is empty there, and the core's own text decodes `select`. With
//! more lanes that part of the text is replaced by one that takes each target's word from [`LoadLanes`]; see
//! [`Part`].

use super::lanes::{Lane, LANE_PORTS, MAX_LANES};
use crate::format::U;
use crate::simulate::{Quiet, Wire};
use rust_hdl_core::ast::{VerilogExpression, VerilogStatement};
use rust_hdl_core::prelude::*;
use std::ops::Deref;

/// Chooses the word of each target. `B` is the width of the register bus. Latency: none.
#[derive(LogicBlock, Default)]
pub struct LoadLanes<const B: usize> {
    /// Lane 0 writes.
    pub write_0: Signal<In, Bit>,
    /// Lane 0, channel mask and word number.
    pub select_0: Signal<In, U<8>>,
    /// Lane 0, register bus.
    pub data_0: Signal<In, U<B>>,
    /// Lane 1 writes.
    pub write_1: Signal<In, Bit>,
    /// Lane 1, channel mask and word number.
    pub select_1: Signal<In, U<8>>,
    /// Lane 1, register bus.
    pub data_1: Signal<In, U<B>>,
    /// Lane 2 writes.
    pub write_2: Signal<In, Bit>,
    /// Lane 2, channel mask and word number.
    pub select_2: Signal<In, U<8>>,
    /// Lane 2, register bus.
    pub data_2: Signal<In, U<B>>,
    /// Lane 3 writes.
    pub write_3: Signal<In, Bit>,
    /// Lane 3, channel mask and word number.
    pub select_3: Signal<In, U<8>>,
    /// Lane 3, register bus.
    pub data_3: Signal<In, U<B>>,
    /// A lane writes to the shell.
    pub shell_write: Signal<Out, Bit>,
    /// Word of the shell.
    pub shell_word: Signal<Out, U<4>>,
    /// Data for the shell.
    pub shell_data: Signal<Out, U<B>>,
    /// Channels that a lane writes to.
    pub channels: Signal<Out, U<4>>,
    /// Word of the channel of mask bit 4.
    pub first_word: Signal<Out, U<4>>,
    /// Data for it.
    pub first_data: Signal<Out, U<B>>,
    /// Word of the channel of mask bit 5.
    pub second_word: Signal<Out, U<4>>,
    /// Data for it.
    pub second_data: Signal<Out, U<B>>,
    /// Word of the channel of mask bit 6.
    pub third_word: Signal<Out, U<4>>,
    /// Data for it.
    pub third_data: Signal<Out, U<B>>,
    /// Word of the channel of mask bit 7.
    pub fourth_word: Signal<Out, U<4>>,
    /// Data for it.
    pub fourth_data: Signal<Out, U<B>>,
    /// Lane 0, channels written to.
    mask_0: Wire<U<4>>,
    /// Lane 1, channels written to.
    mask_1: Wire<U<4>>,
    /// Lane 2, channels written to.
    mask_2: Wire<U<4>>,
    /// Lane 3, channels written to.
    mask_3: Wire<U<4>>,
    /// Lane 0, word number.
    word_0: Wire<U<4>>,
    /// Lane 1, word number.
    word_1: Wire<U<4>>,
    /// Lane 2, word number.
    word_2: Wire<U<4>>,
    /// Lane 3, word number.
    word_3: Wire<U<4>>,
    /// Lane 0 writes to the shell.
    shell_0: Wire<Bit>,
    /// Lane 1 writes to the shell.
    shell_1: Wire<Bit>,
    /// Lane 2 writes to the shell.
    shell_2: Wire<Bit>,
    /// Lane 3 writes to the shell.
    shell_3: Wire<Bit>,
}

impl<const B: usize> Logic for LoadLanes<B> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name load_lanes");
        comment!("title Load port of several register words per clock: the word for each target of the register file.");
        comment!("equation word of a target = word of the lowest lane whose mask has the target");
        comment!("source Ours: the register file of Abbas 2003, appendix, has one bus.");
        comment!("latency None.");
        self.word_0.next = self.select_0.val().get_bits::<4>(0);
        self.word_1.next = self.select_1.val().get_bits::<4>(0);
        self.word_2.next = self.select_2.val().get_bits::<4>(0);
        self.word_3.next = self.select_3.val().get_bits::<4>(0);
        self.mask_0.next = 0u64.into();
        self.shell_0.next = false;
        if self.write_0.val() {
            self.mask_0.next = self.select_0.val().get_bits::<4>(4);
            self.shell_0.next = self.select_0.val().get_bits::<4>(4) == 0u64.into();
        }
        self.mask_1.next = 0u64.into();
        self.shell_1.next = false;
        if self.write_1.val() {
            self.mask_1.next = self.select_1.val().get_bits::<4>(4);
            self.shell_1.next = self.select_1.val().get_bits::<4>(4) == 0u64.into();
        }
        self.mask_2.next = 0u64.into();
        self.shell_2.next = false;
        if self.write_2.val() {
            self.mask_2.next = self.select_2.val().get_bits::<4>(4);
            self.shell_2.next = self.select_2.val().get_bits::<4>(4) == 0u64.into();
        }
        self.mask_3.next = 0u64.into();
        self.shell_3.next = false;
        if self.write_3.val() {
            self.mask_3.next = self.select_3.val().get_bits::<4>(4);
            self.shell_3.next = self.select_3.val().get_bits::<4>(4) == 0u64.into();
        }
        self.channels.next =
            self.mask_0.val() | self.mask_1.val() | self.mask_2.val() | self.mask_3.val();
        self.shell_write.next =
            self.shell_0.val() || self.shell_1.val() || self.shell_2.val() || self.shell_3.val();

        self.shell_word.next = self.word_3.val();
        self.shell_data.next = self.data_3.val();
        if self.shell_0.val() {
            self.shell_word.next = self.word_0.val();
            self.shell_data.next = self.data_0.val();
        } else if self.shell_1.val() {
            self.shell_word.next = self.word_1.val();
            self.shell_data.next = self.data_1.val();
        } else if self.shell_2.val() {
            self.shell_word.next = self.word_2.val();
            self.shell_data.next = self.data_2.val();
        }

        self.first_word.next = self.word_3.val();
        self.first_data.next = self.data_3.val();
        if self.mask_0.val().get_bit(0) {
            self.first_word.next = self.word_0.val();
            self.first_data.next = self.data_0.val();
        } else if self.mask_1.val().get_bit(0) {
            self.first_word.next = self.word_1.val();
            self.first_data.next = self.data_1.val();
        } else if self.mask_2.val().get_bit(0) {
            self.first_word.next = self.word_2.val();
            self.first_data.next = self.data_2.val();
        }

        self.second_word.next = self.word_3.val();
        self.second_data.next = self.data_3.val();
        if self.mask_0.val().get_bit(1) {
            self.second_word.next = self.word_0.val();
            self.second_data.next = self.data_0.val();
        } else if self.mask_1.val().get_bit(1) {
            self.second_word.next = self.word_1.val();
            self.second_data.next = self.data_1.val();
        } else if self.mask_2.val().get_bit(1) {
            self.second_word.next = self.word_2.val();
            self.second_data.next = self.data_2.val();
        }

        self.third_word.next = self.word_3.val();
        self.third_data.next = self.data_3.val();
        if self.mask_0.val().get_bit(2) {
            self.third_word.next = self.word_0.val();
            self.third_data.next = self.data_0.val();
        } else if self.mask_1.val().get_bit(2) {
            self.third_word.next = self.word_1.val();
            self.third_data.next = self.data_1.val();
        } else if self.mask_2.val().get_bit(2) {
            self.third_word.next = self.word_2.val();
            self.third_data.next = self.data_2.val();
        }

        self.fourth_word.next = self.word_3.val();
        self.fourth_data.next = self.data_3.val();
        if self.mask_0.val().get_bit(3) {
            self.fourth_word.next = self.word_0.val();
            self.fourth_data.next = self.data_0.val();
        } else if self.mask_1.val().get_bit(3) {
            self.fourth_word.next = self.word_1.val();
            self.fourth_data.next = self.data_1.val();
        } else if self.mask_2.val().get_bit(3) {
            self.fourth_word.next = self.word_2.val();
            self.fourth_data.next = self.data_2.val();
        }
    }
}

crate::ports!(LoadLanes<B>, const B: usize;
    inputs write_0, select_0, data_0, write_1, select_1, data_1, write_2, select_2, data_2, write_3, select_3, data_3;
    outputs shell_write, shell_word, shell_data, channels, first_word, first_data, second_word, second_data,
        third_word, third_data, fourth_word, fourth_data);

/// The ports of a further lane.
#[derive(Default)]
struct LanePins<const B: usize> {
    write: Signal<In, Bit>,
    select: Signal<In, U<8>>,
    data: Signal<In, U<B>>,
}

/// The further lanes of a core: their ports, and the choice of words as instance `lanes`. Empty in a core of one word
/// per clock. The docs of the ports are those of [`LoadLanes`], which has the same names.
///
/// The number of lanes is no const generic, so that a core is compiled once for all of them.
#[derive(Default)]
pub struct LanePort<const B: usize> {
    /// Lanes behind the first.
    further: usize,
    pins: [LanePins<B>; MAX_LANES - 1],
    router: Quiet<LoadLanes<B>>,
}

impl<const B: usize> Deref for LanePort<B> {
    type Target = LoadLanes<B>;
    #[inline(always)]
    fn deref(&self) -> &LoadLanes<B> {
        &self.router
    }
}

impl<const B: usize> LanePort<B> {
    /// Makes the port take `words` register words per clock, [`MAX_LANES`] at most, before the core is connected.
    pub fn widen(&mut self, words: usize) {
        self.further = words.clamp(1, MAX_LANES) - 1;
    }

    /// Whether there are lanes behind the first.
    #[must_use]
    #[inline(always)]
    pub fn several(&self) -> bool {
        self.further > 0
    }

    fn used(&self) -> &[LanePins<B>] {
        &self.pins[..self.further]
    }

    fn used_mut(&mut self) -> &mut [LanePins<B>] {
        &mut self.pins[..self.further]
    }

    /// Presents the inputs of the further lanes.
    pub fn set(&mut self, lanes: &[Lane; MAX_LANES - 1]) {
        for (pins, lane) in self.used_mut().iter_mut().zip(lanes) {
            pins.write.next = lane.write;
            pins.select.next = U::new(u64::from(lane.select));
            pins.data.next = U::new(lane.data);
        }
    }

    /// An input was given a value that the block has not seen.
    #[inline(always)]
    pub fn inputs_pending(&self) -> bool {
        let pending = |p: &LanePins<B>| {
            p.write.next != p.write.val()
                || p.select.next != p.select.val()
                || p.data.next != p.data.val()
        };
        self.used().iter().any(pending)
    }

    /// Makes the inputs' new values visible to the block.
    #[inline(always)]
    pub fn take_inputs(&mut self) {
        for p in self.used_mut() {
            p.write.update_all();
            p.select.update_all();
            p.data.update_all();
        }
    }

    /// Hands the lanes to the choice; lane 0 comes from the core's own ports.
    pub fn feed(&mut self, write: Bit, select: U<8>, data: U<B>) {
        let router: &mut LoadLanes<B> = &mut self.router;
        router.write_0.next = write;
        router.select_0.next = select;
        router.data_0.next = data;
        let lane = |i: usize| {
            let p = &self.pins[i];
            (p.write.val(), p.select.val(), p.data.val())
        };
        (
            router.write_1.next,
            router.select_1.next,
            router.data_1.next,
        ) = lane(0);
        (
            router.write_2.next,
            router.select_2.next,
            router.data_2.next,
        ) = lane(1);
        (
            router.write_3.next,
            router.select_3.next,
            router.data_3.next,
        ) = lane(2);
    }

    /// Marks the inputs of the choice as driven.
    pub fn connect_lanes(&mut self) {
        let r: &mut LoadLanes<B> = &mut self.router;
        for write in [
            &mut r.write_0,
            &mut r.write_1,
            &mut r.write_2,
            &mut r.write_3,
        ] {
            write.connect();
        }
        for select in [
            &mut r.select_0,
            &mut r.select_1,
            &mut r.select_2,
            &mut r.select_3,
        ] {
            select.connect();
        }
        for data in [&mut r.data_0, &mut r.data_1, &mut r.data_2, &mut r.data_3] {
            data.connect();
        }
    }

    /// What [`LanePort::feed`] does, as statements: a lane that the core does not have never writes.
    #[must_use]
    pub fn links(&self) -> Vec<VerilogStatement> {
        let mut out = vec![];
        for lane in 0..MAX_LANES {
            for port in ["write", "select", "data"] {
                let to = VerilogExpression::Signal(format!("lanes${port}_{lane}"));
                let from = if lane == 0 {
                    VerilogExpression::Signal(port.to_owned())
                } else if lane <= self.further {
                    VerilogExpression::Signal(format!("{port}_{lane}"))
                } else if port == "write" {
                    VerilogExpression::Literal(false.into())
                } else {
                    VerilogExpression::Literal(0u32.into())
                };
                out.push(VerilogStatement::Assignment(to, from));
            }
        }
        out
    }
}

impl<const B: usize> Logic for LanePort<B> {
    fn update(&mut self) {}
}

impl<const B: usize> Block for LanePort<B> {
    fn connect_all(&mut self) {
        if self.several() {
            self.router.connect_all();
        }
    }

    #[inline(always)]
    fn update_all(&mut self) {
        if self.several() {
            self.take_inputs();
            self.router.update_all();
        }
    }

    #[inline(always)]
    fn has_changed(&self) -> bool {
        self.several() && self.router.has_changed()
    }

    fn accept(&self, _name: &str, probe: &mut dyn Probe) {
        if !self.several() {
            return;
        }
        for (pins, [write, select, data]) in self.used().iter().zip(LANE_PORTS) {
            pins.write.accept(write, probe);
            pins.select.accept(select, probe);
            pins.data.accept(data, probe);
        }
        self.router.accept("lanes", probe);
    }
}

/// Marks the text that decodes one word per clock.
pub struct OneLane;
/// Marks the text that takes each target's word from [`LoadLanes`].
pub struct Lanes;
/// Marks the text that is the same for any load port.
pub struct Rest;

/// A part of a core's text, made with `#[hdl_gen]` as a whole one is. A core is [`OneLane`] or [`Lanes`], then [`Rest`].
pub trait Part<P> {
    /// Simulates it.
    fn update(&mut self);
    /// Marks what it drives.
    fn connect(&mut self);
    /// Its statements.
    fn hdl(&self) -> Verilog;
}

/// The statements of one text after those of another.
#[must_use]
pub fn joined(first: Verilog, more: Vec<VerilogStatement>, second: Verilog) -> Verilog {
    match (first, second) {
        (Verilog::Combinatorial(mut all), Verilog::Combinatorial(rest)) => {
            all.extend(more);
            all.extend(rest);
            Verilog::Combinatorial(all)
        }
        (_, second) => second,
    }
}

/// Makes a core of its [`Part`]s, with the ports of its lanes: the field `lanes` is its [`LanePort`], declared behind
/// `ready`.
#[macro_export]
macro_rules! lane_core {
    ($type:ty $(, const $n:ident: $t:ty)*; outputs $($output:ident),+) => {
        impl<$(const $n: $t),*> Logic for $type {
            #[inline]
            fn update(&mut self) {
                use $crate::shade::load_lanes::{Lanes, OneLane, Part, Rest};
                if self.lanes.several() {
                    let (write, select, data) = (self.write.val(), self.select.val(), self.data.val());
                    self.lanes.feed(write, select, data);
                    Part::<Lanes>::update(self);
                } else {
                    Part::<OneLane>::update(self);
                }
                Part::<Rest>::update(self);
            }

            fn connect(&mut self) {
                use $crate::shade::load_lanes::{Lanes, OneLane, Part, Rest};
                if self.lanes.several() {
                    self.lanes.connect_lanes();
                    Part::<Lanes>::connect(self);
                } else {
                    Part::<OneLane>::connect(self);
                }
                Part::<Rest>::connect(self);
            }

            fn hdl(&self) -> Verilog {
                use $crate::shade::load_lanes::{joined, Lanes, OneLane, Part, Rest};
                let rest = Part::<Rest>::hdl(self);
                if self.lanes.several() {
                    joined(Part::<Lanes>::hdl(self), self.lanes.links(), rest)
                } else {
                    joined(Part::<OneLane>::hdl(self), vec![], rest)
                }
            }
        }

        impl<$(const $n: $t),*> $crate::simulate::Ports for $type {
            fn port_names() -> (&'static [&'static str], &'static [&'static str]) {
                // Those of the core with one lane.
                const INPUTS: [&str; 7] = ["clock", "write", "select", "data", "start", "clear", "ready"];
                (&INPUTS, &[$(stringify!($output)),+])
            }

            #[inline(always)]
            fn inputs_pending(&self) -> bool {
                self.clock.next != self.clock.val()
                    || self.write.next != self.write.val()
                    || self.select.next != self.select.val()
                    || self.data.next != self.data.val()
                    || self.start.next != self.start.val()
                    || self.clear.next != self.clear.val()
                    || self.ready.next != self.ready.val()
                    || self.lanes.inputs_pending()
            }

            #[inline(always)]
            fn take_inputs(&mut self) {
                self.clock.update_all();
                self.write.update_all();
                self.select.update_all();
                self.data.update_all();
                self.start.update_all();
                self.clear.update_all();
                self.ready.update_all();
                self.lanes.take_inputs();
            }

            #[inline(always)]
            fn take_output_changes(&mut self) -> bool {
                let changed = $(self.$output.changed)||+;
                $(self.$output.changed = false;)+
                changed
            }
        }

        impl<$(const $n: $t),*> $crate::simulate::Clocked for $type {
            fn clock_input(&mut self) -> &mut Signal<In, Clock> {
                &mut self.clock
            }
        }
    };
}
