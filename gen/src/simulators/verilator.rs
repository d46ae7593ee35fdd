//! The C++ main program for Verilator.

use super::replay::{drive, observe, program, Device};
use shadegate_hdl::shade::device::Core;

/// Text of `main.cpp`. Arguments: vector file, then optionally a file for the pixels (`x y red green blue` per line).
#[must_use]
pub fn main_cpp(core: &Core) -> String {
    let name = core.name();
    let drive = drive(core, |port, value| format!("core.{port} = {value};"));
    let observe = observe(|port| format!("core.{port}"));
    program(&Device {
        ready: core.bus_bits() + 11,
        heading: format!(
            "// Replays a vector file on the Verilator model of {name}_core and compares every output in every clock.\n\
             //\n\
             // verilator -O3 --cc --exe --build --top-module {name}_core main.cpp ../rtl/*.v && ./obj_dir/V{name}_core vectors.txt\n"
        ),
        includes: format!(
            "#include \"V{name}_core.h\"\n#include \"verilated.h\"\n\n\
             double sc_time_stamp() {{ return 0; }}\n"
        ),
        definition: format!(
            "struct Device {{
  V{name}_core core;

  Device(int, char**) {{ core.clock = 0; }}

  void clock(size_t, uint64_t inputs) {{
{drive}    core.clock = 0;
    core.eval();
    core.clock = 1;
    core.eval();
  }}

{observe}
  bool finish() {{
    core.final();
    return true;
  }}
}};
"
        ),
    })
}
