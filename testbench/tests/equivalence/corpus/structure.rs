//! Submodules, arrays of signals and of submodules, loops, constants and generic widths.

use crate::harness::case::Case;
use crate::harness::code::{circuit, drive};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;

/// A leaf with a state and a combinational path.
#[derive(LogicBlock, Default)]
struct Stage<const N: usize> {
    clock: Signal<In, Clock>,
    a: Signal<In, Bits<N>>,
    o: Signal<Out, Bits<N>>,
    sum: Signal<Out, Bits<N>>,
    last: DFF<Bits<N>>,
}

impl<const N: usize> Logic for Stage<N> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, last);
        self.last.d.next = self.a.val();
        self.o.next = self.last.q.val();
        self.sum.next = self.a.val() + self.last.q.val();
    }
}

/// An array of submodules, chained by `i + 1`; some of their outputs are read, some are not.
#[derive(LogicBlock, Default)]
struct Pipeline<const N: usize> {
    clock: Signal<In, Clock>,
    a: Signal<In, Bits<N>>,
    o: Signal<Out, Bits<N>>,
    sum: Signal<Out, Bits<N>>,
    stage: [Stage<N>; 4],
}

impl<const N: usize> Logic for Pipeline<N> {
    #[hdl_gen]
    fn update(&mut self) {
        for i in 0..4 {
            self.stage[i].clock.next = self.clock.val();
        }
        self.stage[0].a.next = self.a.val();
        for i in 0..3 {
            self.stage[i + 1].a.next = self.stage[i].o.val();
        }
        self.o.next = self.stage[3].o.val();
        self.sum.next = self.stage[2].sum.val();
    }
}

drive!(Pipeline<8>, clock; a);
drive!(Pipeline<65>, clock; a);

/// Arrays of signals, loops with computed positions, nested loops, and the index as a number.
#[derive(LogicBlock, Default)]
struct Arrays {
    a: [Signal<In, Bits<8>>; 4],
    o: [Signal<Out, Bits<8>>; 4],
    last: Signal<Out, Bits<8>>,
    count: Signal<Out, Bits<8>>,
    hit: Signal<Out, Bits<4>>,
    fourth: Signal<Out, Bit>,
    partial: [Signal<Local, Bits<8>>; 5],
    bits: Signal<Local, Bits<4>>,
    table: [Signal<Local, Bits<8>>; 6],
}

impl Logic for Arrays {
    #[hdl_gen]
    fn update(&mut self) {
        self.partial[0].next = 1.into();
        for i in 0..4 {
            self.partial[i + 1].next = self.partial[i].val() + self.a[3 - i].val();
            self.o[i].next = self.partial[(i + 1) % 5].val() ^ self.a[i].val();
        }
        self.last.next = self.partial[4].val();
        for i in 0..2 {
            for j in 0..3 {
                self.table[i * 3 + j].next = self.a[i].val() - self.a[j].val();
            }
        }
        self.count.next = self.table[0].val() + self.table[1].val()
            ^ self.table[2].val() + self.table[3].val()
            ^ self.table[4].val()
            ^ self.table[5].val();
        for i in 0..4 {
            if self.a[i].val().get_bit(i) {
                self.o[i].next = i.to_bits();
            }
        }
        self.bits.next = self.a[0].val().get_bits::<4>(2);
        self.hit.next = self.bits.val();
        self.fourth.next = self.bits.val().get_bit(3);
        for i in 2..4 {
            self.hit.next = self
                .bits
                .val()
                .replace_bit(i, self.a[1].val().get_bit(i + 3));
        }
    }
}

drive!(Arrays; a[0], a[1], a[2], a[3]);

/// Bounds of a loop from a generic.
#[derive(LogicBlock)]
struct GenericLoop<const N: usize> {
    a: [Signal<In, Bits<5>>; N],
    o: [Signal<Out, Bits<5>>; N],
}

impl<const N: usize> Default for GenericLoop<N> {
    fn default() -> Self {
        Self {
            a: std::array::from_fn(|_| Default::default()),
            o: std::array::from_fn(|_| Default::default()),
        }
    }
}

impl<const N: usize> Logic for GenericLoop<N> {
    #[hdl_gen]
    fn update(&mut self) {
        for i in 0..N {
            self.o[i].next = self.a[i].val() + 3;
        }
    }
}

drive!(GenericLoop<3>; a[0], a[1], a[2]);

/// Constants as fields, of every kind of word.
#[derive(LogicBlock)]
struct Constants {
    a: Signal<In, Bits<8>>,
    s: Signal<In, Signed<8>>,
    o: Signal<Out, Bits<8>>,
    p: Signal<Out, Bit>,
    q: Signal<Out, Signed<8>>,
    r: Signal<Out, Bits<8>>,
    cut: Signal<Out, Bits<3>>,
    wide: Signal<Out, Signed<16>>,
    mask: Constant<Bits<8>>,
    limit: Constant<Signed<8>>,
    yes: Constant<Bit>,
    list: [Constant<Bits<8>>; 3],
}

impl Default for Constants {
    fn default() -> Self {
        Self {
            a: Default::default(),
            s: Default::default(),
            o: Default::default(),
            p: Default::default(),
            q: Default::default(),
            r: Default::default(),
            cut: Default::default(),
            wide: Default::default(),
            mask: Constant::new(0xa5.into()),
            limit: Constant::new((-17).into()),
            yes: Constant::new(true),
            list: [3, 5, 250].map(|v: u64| Constant::new(v.into())),
        }
    }
}

impl Logic for Constants {
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() & self.mask.val();
        self.p.next = (self.s.val() < self.limit.val()) ^ self.yes.val();
        self.q.next = self.limit.val() - self.s.val();
        self.r.next = self.list[0].val();
        for i in 0..3 {
            if self.a.val() == self.list[i].val() {
                self.r.next = self.list[i].val() + 1;
            }
        }
        self.cut.next = self.mask.val().get_bits::<3>(2) ^ self.a.val().get_bits::<3>(1);
        self.wide.next = signed_bit_cast::<16, 8>(self.limit.val());
    }
}

drive!(Constants; a, s);

circuit! {
    /// A submodule's inputs assigned several times, its outputs read in expressions.
    ParentLogic { clock; in a: Bits<8>, f: Bit; out o: Bits<8>, p: Bits<4>; part inner: Stage<8>; }
    #[hdl_gen]
    fn update(&mut self) {
        self.inner.clock.next = self.clock.val();
        self.inner.a.next = 0.into();
        if self.f.val() {
            self.inner.a.next = self.a.val() + self.inner.o.val();
        }
        self.o.next = self.inner.sum.val() ^ self.inner.o.val();
        self.p.next = self.inner.sum.val().get_bits::<4>(2);
    }
}

pub fn cases() -> Vec<Case> {
    vec![
        Case::named("pipeline_8", Pipeline::<8>::default()),
        Case::named("pipeline_65", Pipeline::<65>::default()),
        Case::of::<Arrays>(),
        Case::named("generic_loop_3", GenericLoop::<3>::default()),
        Case::of::<Constants>(),
        Case::of::<ParentLogic>(),
    ]
}
