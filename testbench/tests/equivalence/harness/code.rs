//! Raw codes in and out of typed signals: inputs by position through [`Driven`], outputs by name through a probe.

use rust_hdl_core::prelude::*;
use shadegate_hdl::format::{Q, U};

/// A signal type whose values are made from codes below 2^width.
pub trait Code: Synth {
    /// The value with this code.
    fn of(code: u128) -> Self;
}

impl Code for bool {
    fn of(code: u128) -> Self {
        code == 1
    }
}

impl<const N: usize> Code for Bits<N> {
    fn of(code: u128) -> Self {
        code.to_bits()
    }
}

impl<const N: usize> Code for Signed<N> {
    fn of(code: u128) -> Self {
        signed_cast(code.to_bits())
    }
}

impl<const N: usize> Code for U<N> {
    fn of(code: u128) -> Self {
        Self::new(code as u64)
    }
}

impl<const M: usize, const N: usize> Code for Q<M, N> {
    fn of(code: u128) -> Self {
        Self::from_code(code as i64)
    }
}

/// A port: its name in the netlist and its width.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Name.
    pub name: String,
    /// Bits.
    pub width: usize,
}

/// A description whose inputs can be set by position. Write it with [`drive!`] or [`circuit!`].
pub trait Driven: Block {
    /// The inputs, without the clock.
    fn inputs(&self) -> Vec<Port>;
    /// Gives an input its next code.
    fn set(&mut self, input: usize, code: u128);
    /// Marks the inputs as driven from outside.
    fn connect_inputs(&mut self);
    /// Sets the clock, if there is one.
    fn set_clock(&mut self, high: bool);
    /// Whether there is one.
    fn has_clock(&self) -> bool;
    /// What rust-hdl's own printer makes of it.
    fn rust_hdl_text(&self) -> String;
}

/// Sets the next value of a signal from a code.
pub fn put<D: Direction, T: Code>(signal: &mut Signal<D, T>, code: u128) {
    signal.next = T::of(code);
}

/// A port for a signal that a description spells like this, such as `bus.data` or `lane[1]`.
pub fn port_of<D: Direction, T: Synth>(spelling: &str, _: &Signal<D, T>) -> Port {
    let plain = spelling.replace(' ', "").replace(['.', '['], "_");
    Port {
        name: plain.replace(']', ""),
        width: T::BITS,
    }
}

/// Implements [`Driven`]: `drive!(Type; a, bus.data, lane[1])`, or `drive!(Type, clock; a)` with a clock input.
macro_rules! drive {
    (@common $($head:ident $([$at:literal])? $(.$tail:ident)*),*) => {
        fn inputs(&self) -> Vec<$crate::harness::code::Port> {
            vec![$($crate::harness::code::port_of(stringify!($head $([$at])? $(.$tail)*), &self.$head $([$at])? $(.$tail)*)),*]
        }
        #[allow(unused_assignments, unused_mut, unused_variables)]
        fn set(&mut self, input: usize, code: u128) {
            let mut i = 0;
            $(
                if i == input {
                    $crate::harness::code::put(&mut self.$head $([$at])? $(.$tail)*, code);
                }
                i += 1;
            )*
        }
        fn rust_hdl_text(&self) -> String {
            rust_hdl_core::prelude::generate_verilog_unchecked(self)
        }
    };
    ($type:ty; $($head:ident $([$at:literal])? $(.$tail:ident)*),*) => {
        impl $crate::harness::code::Driven for $type {
            drive!(@common $($head $([$at])? $(.$tail)*),*);
            fn connect_inputs(&mut self) {
                $(rust_hdl_core::prelude::Logic::connect(&mut self.$head $([$at])? $(.$tail)*);)*
            }
            fn set_clock(&mut self, _: bool) {}
            fn has_clock(&self) -> bool {
                false
            }
        }
    };
    ($type:ty, $clock:ident; $($head:ident $([$at:literal])? $(.$tail:ident)*),*) => {
        impl $crate::harness::code::Driven for $type {
            drive!(@common $($head $([$at])? $(.$tail)*),*);
            fn connect_inputs(&mut self) {
                rust_hdl_core::prelude::Logic::connect(&mut self.$clock);
                $(rust_hdl_core::prelude::Logic::connect(&mut self.$head $([$at])? $(.$tail)*);)*
            }
            fn set_clock(&mut self, high: bool) {
                self.$clock.next = high.into();
            }
            fn has_clock(&self) -> bool {
                true
            }
        }
    };
}

/// Defines a description and its [`Driven`]: ports and wires by type, then its `update` (which brings
/// its own `#[hdl_gen]`: `self` belongs to the place where both are written).
macro_rules! circuit {
    ($(#[$meta:meta])* $name:ident { in $($i:ident: $it:ty),+; out $($o:ident: $ot:ty),+; $(wire $($w:ident: $wt:ty),+;)? }
     $($update:tt)*) => {
        $(#[$meta])*
        #[derive(LogicBlock, Default)]
        pub struct $name {
            $(pub $i: Signal<In, $it>,)+
            $(pub $o: Signal<Out, $ot>,)+
            $($($w: Signal<Local, $wt>,)+)?
        }
        impl Logic for $name {
            $($update)*
        }
        drive!($name; $($i),+);
    };
    ($(#[$meta:meta])* $name:ident { clock; $(in $($i:ident: $it:ty),+;)? out $($o:ident: $ot:ty),+;
     $(wire $($w:ident: $wt:ty),+;)? $(reg $($r:ident: $rt:ty),+;)? $(part $($p:ident: $pt:ty),+;)? } $($update:tt)*) => {
        $(#[$meta])*
        #[derive(LogicBlock, Default)]
        pub struct $name {
            pub clock: Signal<In, Clock>,
            $($(pub $i: Signal<In, $it>,)+)?
            $(pub $o: Signal<Out, $ot>,)+
            $($($w: Signal<Local, $wt>,)+)?
            $($($r: DFF<$rt>,)+)?
            $($($p: $pt,)+)?
        }
        impl Logic for $name {
            $($update)*
        }
        drive!($name, clock; $($($i),+)?);
    };
}

pub(crate) use {circuit, drive};
