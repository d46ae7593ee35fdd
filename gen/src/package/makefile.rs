//! The package's Makefile: everything a person can run without Shadegate.

use shadegate_constraints::Device;
use shadegate_hdl::shade::device::Core;

/// Text of the Makefile; `make` alone runs the Icarus test bench.
pub fn makefile(core: &Core, device: Option<&Device>) -> String {
    let name = core.name();
    let family = device.map_or("xc7", |d| d.yosys_family.as_str());
    format!(
        "# {name}_core: simulate, lint and synthesise with free tools.\n\
         RTL := $(wildcard rtl/*.v)\n\
         TOP := {name}_core\n\
         FAMILY ?= {family}\n\n\
         .PHONY: icarus verilator lint yosys clean\n\n\
         icarus: build/icarus\n\
         \tvvp build/icarus +vectors=sim/vectors.txt\n\n\
         build/icarus: $(RTL) sim/tb_$(TOP).v\n\
         \tmkdir -p build\n\
         \tiverilog -g2001 -o $@ $^\n\n\
         verilator: build/verilator/V$(TOP)\n\
         \tbuild/verilator/V$(TOP) sim/vectors.txt\n\n\
         build/verilator/V$(TOP): sim/main.cpp $(RTL)\n\
         \tverilator -O3 --cc --exe --build --top-module $(TOP) -Mdir build/verilator -CFLAGS -O2 $(abspath sim/main.cpp) $(RTL)\n\n\
         lint:\n\
         \tverilator --lint-only -Wall --top-module $(TOP) $(RTL)\n\n\
         yosys:\n\
         \tyosys -q -p \"read_verilog $(RTL); synth_xilinx -family $(FAMILY) -top $(TOP); tee -o /dev/stdout stat\"\n\n\
         clean:\n\
         \trm -rf build\n"
    )
}
