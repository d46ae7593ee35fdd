//! The Yosys script.

use super::Sources;
use crate::package::Target;

/// Text of `build/yosys.ys`.
pub fn script(s: &Sources, target: Option<Target>) -> String {
    let top = s.top;
    let (synthesis, place) = match target {
        Some(t) => (
            t.device.yosys_synthesis(),
            format!(" for {}", t.device.name),
        ),
        None => ("synth_xilinx -family xc7".to_owned(), String::new()),
    };
    let read: String = s
        .rtl
        .iter()
        .map(|f| format!("read_verilog {f}\n"))
        .collect();
    // Without pads and clock buffers a core is counted as the part of a design that it is. Lattice's commands
    // flatten of themselves and leave pads to the placer. Shift registers stay flip-flops: Yosys 0.23 leaves out the
    // clock enable of those that it makes look-up tables of, and pixels that wait for their colours would not wait.
    let bare = if synthesis.starts_with("synth_xilinx") {
        " -flatten -noiopad -noclkbuf -nosrl"
    } else {
        ""
    };
    format!(
        "# {top}: synthesis by Yosys{place}. Run from the package's folder, with out/ made before:\n\
         #   mkdir -p out && yosys -s build/yosys.ys\n\
         # Writes out/{top}.json (netlist, for nextpnr), out/{top}_netlist.v and out/yosys.txt (cells).\n\
         {read}\
         hierarchy -check -top {top}\n\
         {synthesis} -top {top}{bare}\n\
         check\n\
         tee -o out/yosys.txt stat -top {top}\n\
         write_json out/{top}.json\n\
         write_verilog -noattr out/{top}_netlist.v\n"
    )
}
