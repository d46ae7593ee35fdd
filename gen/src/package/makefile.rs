//! The package's Makefile: everything a person can run without Shadegate.

use crate::wrapper::Wrapper;
use shadegate_constraints::{Device, Format};

/// Text of the Makefile; `make` alone runs the Icarus test bench. The Verilog files are listed, so that nothing else that
/// lies in `rtl/`, say from a core made there before, gets into a build.
pub fn makefile(
    top: &str,
    rtl: &[String],
    wrappers: &[Wrapper],
    device: Option<&Device>,
) -> String {
    let rtl = rtl.join(" \\\n  ");
    let vendor = match device.map(|d| d.constraints) {
        Some(Format::Xdc) => {
            "vivado:\n\
             \tmkdir -p $(OUT)\n\
             \tcd $(OUT) && vivado -mode batch -source ../build/vivado.tcl\n\n"
        }
        Some(Format::Ucf) => {
            "ise:\n\
             \txtclsh build/ise.tcl\n\n"
        }
        Some(Format::Pcf | Format::Lpf) | None => "",
    };
    let benches: String = wrappers.iter().map(|w| bench(*w)).collect();
    let lint: String = wrappers
        .iter()
        .map(|w| {
            format!("\tverilator --lint-only -Wall --top-module $(TOP)_{w} $(RTL) wrappers/$(TOP)_host.v wrappers/$(TOP)_frames.v wrappers/$(TOP)_{w}.v\n")
        })
        .collect();
    let mut names = vec!["icarus", "verilator"];
    names.extend(wrappers.iter().map(|w| w.name()));
    names.extend(["lint", "yosys"]);
    names.extend(vendor.split_once(':').map(|(name, _)| name));
    names.push("clean");
    let names = names.join(" ");
    format!(
        "# {top}: simulate, lint and synthesise. Everything made is below out/.\n\
         RTL := {rtl}\n\
         TOP := {top}\n\
         OUT := out\n\n\
         .PHONY: {names}\n\n\
         icarus: $(OUT)/icarus\n\
         \tvvp $(OUT)/icarus +vectors=sim/vectors.txt\n\n\
         $(OUT)/icarus: $(RTL) sim/tb_$(TOP).v\n\
         \tmkdir -p $(OUT)\n\
         \tiverilog -g2001 -o $@ $^\n\n\
         verilator: $(OUT)/verilator/V$(TOP)\n\
         \t$(OUT)/verilator/V$(TOP) sim/vectors.txt\n\n\
         $(OUT)/verilator/V$(TOP): sim/main.cpp $(RTL)\n\
         \tmkdir -p $(OUT)\n\
         \tverilator -O3 --cc --exe --build --top-module $(TOP) -Mdir $(OUT)/verilator -CFLAGS -O2 $(abspath sim/main.cpp) $(RTL)\n\n\
         {benches}\
         lint:\n\
         \tverilator --lint-only -Wall --top-module $(TOP) $(RTL)\n\
         \tverilator --lint-only -Wall --top-module $(TOP)_example $(RTL) example/$(TOP)_example.v\n\
         {lint}\n\
         yosys:\n\
         \tmkdir -p $(OUT)\n\
         \tyosys -q -s build/yosys.ys\n\n\
         {vendor}\
         clean:\n\
         \trm -rf $(OUT)\n"
    )
}

/// The rules of a wrapper's test bench.
fn bench(wrapper: Wrapper) -> String {
    format!(
        "{wrapper}: $(OUT)/{wrapper}\n\
         \tvvp $(OUT)/{wrapper} +vectors=sim/vectors.txt\n\n\
         $(OUT)/{wrapper}: $(RTL) wrappers/$(TOP)_host.v wrappers/$(TOP)_frames.v wrappers/$(TOP)_{wrapper}.v sim/tb_$(TOP)_{wrapper}.v\n\
         \tmkdir -p $(OUT)\n\
         \tiverilog -g2001 -o $@ $^\n\n"
    )
}
