//! What only shows in the whole hierarchy: loops without a register, and second clocks.

use crate::{circuit, refused};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;
use shadegate_gen::netlist::collect;
use shadegate_gen::verilog::emit;

circuit! {
    Loop { a: Signal<In, Bits<8>>, o: Signal<Out, Bits<8>>, t: Signal<Local, Bits<8>> }
    #[hdl_gen]
    fn update(&mut self) {
        self.t.next = self.o.val() + self.a.val();
        self.o.next = self.t.val() & self.a.val();
    }
}

circuit! {
    Inverter { a: Signal<In, Bit>, o: Signal<Out, Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        self.o.next = !self.a.val();
    }
}

circuit! {
    Ring { o: Signal<Out, Bit>, first: Inverter, second: Inverter }
    #[hdl_gen]
    fn update(&mut self) {
        self.first.a.next = self.second.o.val();
        self.second.a.next = self.first.o.val();
        self.o.next = self.first.o.val();
    }
}

circuit! {
    Toggle { clock: Signal<In, Clock>, o: Signal<Out, Bit>, state: DFF<Bit> }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, state);
        self.state.d.next = !self.state.q.val();
        self.o.next = self.state.q.val();
    }
}

circuit! {
    TwoClocks { clock: Signal<In, Clock>, other: Signal<In, Clock>, o: Signal<Out, Bit>, first: Toggle, second: Toggle }
    #[hdl_gen]
    fn update(&mut self) {
        self.first.clock.next = self.clock.val();
        self.second.clock.next = self.other.val();
        self.o.next = self.first.o.val() ^ self.second.o.val();
    }
}

#[test]
fn combinational_loops_are_refused() {
    refused! {
        Loop => "module top: combinational loop: o -> t -> o",
        Ring => "module top: combinational loop: first.a -> first.o -> second.a -> second.o -> first.a",
    }
}

#[test]
fn a_second_clock_is_refused() {
    refused! { TwoClocks => "module top: two clocks: first.state is clocked by clock, second.state by other" }
}

/// What cannot be simulated for its loop is not printed either; two clocks are.
#[test]
fn loops_are_not_printed_and_clocks_are() {
    fn printed<B: Block>(mut design: B) -> Result<usize, String> {
        design.connect_all();
        let top = collect(&design).map_err(|e| e.to_string())?;
        let files = emit(&top, "the test").map_err(|e| e.to_string())?;
        Ok(files.len())
    }
    let path = "first.a -> first.o -> second.a -> second.o -> first.a";
    assert_eq!(
        printed(Ring::default()),
        Err(format!("module top: combinational loop: {path}"))
    );
    assert_eq!(printed(TwoClocks::default()), Ok(2));
}
