//! Multipliers, memories and tables are written so that a synthesiser finds its hard blocks in them: Yosys does, for
//! Spartan-3, -6 and -7. (Vivado and ISE document the same templates; they were not run.)

use rust_hdl_core::prelude::*;
use rust_hdl_widgets::prelude::*;
use shadegate_gen::netlist::collect;
use shadegate_gen::verilog::check::check;
use shadegate_gen::verilog::emit;
use shadegate_hdl::format::{signed_cast_product, Q};
use std::process::Command;

/// A registered product with registered factors: the shape of a DSP block.
#[derive(LogicBlock, Default)]
struct Multiply {
    pub clock: Signal<In, Clock>,
    pub a: Signal<In, Q<1, 16>>,
    pub b: Signal<In, Q<1, 16>>,
    pub y: Signal<Out, Q<1, 16>>,
    left: DFF<Q<1, 16>>,
    right: DFF<Q<1, 16>>,
    product: DFF<Q<1, 16>>,
}

impl Logic for Multiply {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, left, right, product);
        self.left.d.next = self.a.val();
        self.right.d.next = self.b.val();
        self.product.d.next = signed_cast_product::<1, 16>(self.left.q.val() * self.right.q.val());
        self.y.next = self.product.q.val();
    }
}

/// Files of a description, checked, in a folder of their own.
fn files<B: Block>(mut design: B) -> (tempfile::TempDir, String) {
    design.connect_all();
    let top = collect(&design).expect("is typed");
    let directory = tempfile::tempdir().expect("a folder");
    let mut name = String::new();
    for f in emit(&top, "the test").expect("prints") {
        check(&f.file_name(), &f.text).expect("is safe");
        std::fs::write(directory.path().join(f.file_name()), &f.text).expect("writable");
        name = f.name;
    }
    (directory, name)
}

/// Cells that Yosys uses, by name.
fn cells(design: &(tempfile::TempDir, String), family: &str) -> String {
    let script = format!(
        "read_verilog *.v; synth_xilinx -noiopad -family {family} -top {}; tee -o stat.txt stat",
        design.1
    );
    let out = Command::new("yosys")
        .args(["-q", "-p", &script])
        .current_dir(design.0.path())
        .output()
        .expect("yosys runs");
    assert!(
        out.status.success(),
        "{}",
        String::from_utf8_lossy(&out.stderr)
    );
    std::fs::read_to_string(design.0.path().join("stat.txt")).expect("statistics")
}

#[track_caller]
fn uses(design: &(tempfile::TempDir, String), family: &str, cell: &str, count: usize) {
    let text = cells(design, family);
    let found: usize = text
        .lines()
        .filter(|l| {
            l.split_whitespace()
                .next()
                .is_some_and(|c| c.starts_with(cell))
        })
        .filter_map(|l| l.split_whitespace().nth(1)?.parse::<usize>().ok())
        .sum();
    assert_eq!(found, count, "{family}: {cell}\n{text}");
}

#[test]
fn a_product_becomes_one_multiplier() {
    let design = files(Multiply::default());
    uses(&design, "xc3s", "MULT18X18", 1);
    uses(&design, "xc6s", "DSP48A1", 1);
    uses(&design, "xc7", "DSP48E1", 1);
}

#[test]
fn a_clocked_table_becomes_block_ram() {
    let words = (0..1024u64).map(|i| Bits::<18>::from(i * i * 7 % 262_144));
    let design = files(SyncROM::<Bits<18>, 10>::from(words));
    uses(&design, "xc6s", "RAMB16", 1);
    uses(&design, "xc7", "RAMB18E1", 1);
}

#[test]
fn a_memory_becomes_block_ram() {
    let empty = RAM::<Bits<18>, 10>::default();
    let design = files(empty);
    uses(&design, "xc3s", "RAMB16", 1);
    uses(&design, "xc7", "RAMB18E1", 1);
    let words = (0..1024u64).map(Bits::<18>::from);
    uses(
        &files(RAM::<Bits<18>, 10>::from(words)),
        "xc7",
        "RAMB18E1",
        1,
    );
}
