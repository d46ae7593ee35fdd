//! Names that stand for nothing, for two things, or that Verilog reserves; bodies that are not descriptions.

use crate::{circuit, refused};
use rust_hdl_core::prelude::*;

const LIMIT: u64 = 5;

circuit! {
    RustConstant { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() & LIMIT;
    }
}

#[derive(LogicBlock, Default)]
struct Generic<const N: u64> {
    a: Signal<In, Bits<8>>,
    o: Signal<Out, Bit>,
}

impl<const N: u64> Logic for Generic<N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val() > N;
    }
}

circuit! {
    Child { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val();
    }
}

circuit! {
    RunTimeInstance { a: Signal<In, Bits<2>>, o: Signal<Out, Bits<8>>, child: [Child; 4] }
    #[hdl_gen]
    fn update(&mut self) {
        for i in 0..4 {
            self.child[i].a.next = 3.into();
        }
        self.o.next = self.child[self.a.val().index()].o.val();
    }
}

circuit! {
    InstanceInputRead { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>>, child: Child }
    #[hdl_gen]
    fn update(&mut self) {
        self.child.a.next = self.a.val();
        self.o.next = self.child.o.val() + self.child.a.val();
    }
}

circuit! {
    Keyword { a: Signal<In, Bit>, always: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.always.next = self.a.val();
    }
}

circuit! {
    TwoThings { a: Signal<In, Bits<8>>, child_o: Signal<Out, Bits<8>>, child: Child }
    #[hdl_gen]
    fn update(&mut self) {
        self.child.a.next = self.a.val();
        self.child_o.next = self.child.o.val();
    }
}

circuit! {
    BothWays { a: Signal<InOut, Bits<8>>, o: Signal<Out, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = self.a.val();
    }
}

circuit! {
    CustomText { a: Signal<In, Bit>, o: Signal<Out, Bit> }
    fn update(&mut self) {}
    fn hdl(&self) -> Verilog {
        Verilog::Custom("assign o = a;".into())
    }
}

circuit! {
    ForeignCore { a: Signal<In, Bit>, o: Signal<Out, Bit> }
    fn update(&mut self) {}
    fn hdl(&self) -> Verilog {
        Verilog::Blackbox(BlackBox { code: "module CORE(a, o); endmodule".into(), name: "CORE".into() })
    }
}

circuit! {
    WrappedCore { a: Signal<In, Bit>, o: Signal<Out, Bit> }
    fn update(&mut self) {}
    fn hdl(&self) -> Verilog {
        Verilog::Wrapper(Wrapper { code: "CORE core(a, o);".into(), cores: String::new() })
    }
}

circuit! {
    NoBody { a: Signal<In, Bit>, o: Signal<Out, Bit> }
    fn update(&mut self) {}
}

circuit! {
    BoundPattern { a: Signal<In, Bits<2>>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        match self.a.val().index() {
            0 => self.o.next = true,
            _other => self.o.next = false,
        }
    }
}

mod other {
    use rust_hdl_core::prelude::*;

    #[derive(Clone, Copy, Debug, PartialEq, LogicState)]
    pub enum Side {
        Right,
        Left,
    }

    #[derive(LogicBlock, Default)]
    pub struct Reversed {
        pub a: Signal<In, Bit>,
        pub side: Signal<Out, Side>,
    }

    impl Logic for Reversed {
        #[hdl_gen]
        fn update(&mut self) {
            self.side.next = Side::Right;
            if self.a.val() {
                self.side.next = Side::Left;
            }
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, LogicState)]
pub enum Side {
    Left,
    Right,
}

circuit! {
    TwoEnumerations { a: Signal<In, Bit>, o: Signal<Out, Side>, child: other::Reversed }
    #[hdl_gen]
    fn update(&mut self) {
        self.child.a.next = self.a.val();
        self.o.next = Side::Right;
    }
}

#[test]
fn constants_that_are_not_fields_are_refused() {
    refused! {
        RustConstant => "module top: LIMIT is not a signal of this module (a Rust constant must be a field of type Constant)",
        Generic<7> => "module top: N is not a signal of this module (a Rust constant must be a field of type Constant)",
    }
}

#[test]
fn a_run_time_choice_between_instances_is_refused() {
    refused! {
        RunTimeInstance => "module top: child[a$val()$index()]$o: the position a$val()$index() is not a constant (unexpected token); a run-time choice between instances is written as `if`s",
    }
}

#[test]
fn inputs_of_instances_are_not_read() {
    refused! {
        InstanceInputRead => "module top: child$a is an input of an instance; read what drives it",
    }
}

#[test]
fn names_that_verilog_does_not_take_are_refused() {
    refused! {
        Keyword => "module top: always is a Verilog word",
        TwoThings => "module top: child_o names two things",
    }
}

#[test]
fn foreign_text_is_refused() {
    refused! {
        CustomText => "module top: its Verilog text is not one of rust-hdl's memories and has no memory remarks",
        ForeignCore => "module top: neither statements nor a memory: black boxes are not supported",
        WrappedCore => "module top: neither statements nor a memory: black boxes are not supported",
        NoBody => "module top: neither statements nor a memory: black boxes are not supported",
    }
}

#[test]
fn wires_driven_from_both_ends_are_refused() {
    refused! {
        BothWays => "module top: signal a: wires that are driven from both ends are not supported",
    }
}

#[test]
fn patterns_that_are_no_codes_are_refused() {
    refused! {
        BoundPattern => "module top: pattern _other is neither a number nor a variant in sight: match a",
        TwoEnumerations => "module top: Side::Right: two different enumerations of that name are in sight",
    }
}
