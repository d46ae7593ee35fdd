//! The optional synchronous reset: an input more, and nothing else while it is low.

use shadegate_gen::netlist::{collect, with_reset, Body, Module};
use shadegate_gen::verilog::check::check;
use shadegate_gen::verilog::emit;
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::Order;

fn top() -> Module {
    let core = Core::for_frame(Order::Linear, 16, 16).expect("in range");
    let simulator = CoreSimulator::new(core).expect("connects");
    collect(simulator.design()).expect("is typed")
}

fn every_module<'a>(m: &'a Module, out: &mut Vec<&'a Module>) {
    out.push(m);
    m.children.iter().for_each(|c| every_module(&c.module, out));
}

#[test]
fn every_register_is_reset_and_no_memory() {
    let reset = with_reset(&top()).expect("the name is free");
    let mut modules = vec![];
    every_module(&reset, &mut modules);
    for m in modules {
        let holds = |m: &Module| {
            let mut all = vec![];
            every_module(m, &mut all);
            all.iter().any(|m| !m.registers.is_empty())
        };
        assert_eq!(m.signal("reset").is_some(), holds(m), "{}", m.name);
        if matches!(m.body, Body::Memory(_)) {
            assert!(m.signal("reset").is_none());
        }
    }
    for f in emit(&reset, "the test").expect("prints") {
        check(&f.file_name(), &f.text).expect("is safe");
        let resets = f.text.matches("if (reset) begin").count();
        let blocks = f.text.matches("always @(posedge").count();
        assert!(
            resets == blocks
                || f.name.starts_with("frame_memory")
                || f.name.starts_with("page_memory"),
            "{}",
            f.text
        );
    }
}

#[test]
fn a_name_that_is_taken_is_refused() {
    let once = with_reset(&top()).expect("the name is free");
    let twice = with_reset(&once).expect_err("reset is taken");
    assert_eq!(
        twice.to_string(),
        "module gouraud_core: reset is already a name of this module"
    );
}
