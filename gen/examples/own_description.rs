//! A description of your own, from Rust to Verilog and to a simulation in this process:
//! `cargo run --release -p shadegate-gen --example own_description`.

use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;
use shadegate_gen::compile::Simulator;
use shadegate_gen::netlist::{collect, elaborate};
use shadegate_gen::verilog::check::check;
use shadegate_gen::verilog::emit;

/// Sums bytes while `take` is high; remarks and doc comments are optional outside this project.
#[derive(LogicBlock, Default)]
struct Checksum {
    pub clock: Signal<In, Clock>,
    pub take: Signal<In, Bit>,
    pub data: Signal<In, Bits<8>>,
    pub high: Signal<Out, Bits<4>>,
    pub negative: Signal<Out, Bit>,
    total: DFF<Bits<8>>,
}

impl Logic for Checksum {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, total);
        // Rust wraps at eight bits here. Text without widths would keep the carry.
        self.high.next = (self.total.q.val() + self.data.val()).get_bits::<4>(4);
        self.negative.next = signed_cast::<8>(self.total.q.val()) < 0.into();
        if self.take.val() {
            self.total.d.next = self.total.q.val() + self.data.val();
        }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut design = Checksum::default();
    design.connect_all();
    let netlist = collect(&design)?;
    elaborate(&netlist)?;
    for file in emit(&netlist, "an example")? {
        check(&file.file_name(), &file.text)?;
        println!("{}", file.text);
    }

    let mut simulator = Simulator::new(&netlist)?;
    let (take, data) = (simulator.input("take")?, simulator.input("data")?);
    let high = simulator.output("high")?;
    let total = simulator.signal("total")?;
    simulator.set(take, 1);
    for code in [0x7f, 0x80, 0x34] {
        simulator.set(data, code);
        simulator.clock();
        let (high, total) = (simulator.get(high), simulator.peek(total)?);
        println!("data {code:02x}: total {total:02x}, high {high:x}");
    }
    Ok(())
}
