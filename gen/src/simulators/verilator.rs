//! The C++ main program for Verilator.

use super::replay::{clock_head, drive, observe, program, Device};
use shadegate_hdl::shade::device::Core;

/// Text of `main.cpp`; `reset` says whether the core has one. Arguments: vector file, then optionally a file for the pixels (`x y red green blue` per line).
#[must_use]
pub fn main_cpp(core: &Core, reset: bool) -> String {
    let name = core.module();
    let head = clock_head(core, "");
    let drive = drive(core, |port, value| format!("core.{port} = {value};"));
    let observe = observe(|port| format!("core.{port}"));
    program(&Device {
        ready: core.bus_bits() + 11,
        lanes: core.load_words - 1,
        prologue: if reset { prologue(core) } else { String::new() },
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

{head}{drive}    core.clock = 0;
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

/// Noise in every register, reset, a cleared memory, reset: what follows must not notice any of it.
fn prologue(core: &Core) -> String {
    let b = core.bus_bits();
    format!(
        "  // Noise in every register, reset, a cleared memory, reset: what follows must not notice any of it.
  const uint64_t write = 1ull << {write}, start = 1ull << {start}, clear = 1ull << {clear}, ready = 1ull << {ready};
  for (uint64_t i = 0; i < 200; ++i) {{
    uint64_t noise = i * 0x9e3779b97f4a7c15ull & (write - 1);
    device.clock(0, noise | write | ready | (i % 32 == 31 ? start : 0));
  }}
  device.core.reset = 1;
  device.clock(0, 0);
  device.core.reset = 0;
  device.clock(0, clear);
  while (device.flags() >> 2 & 1) device.clock(0, 0);
  device.core.reset = 1;
  device.clock(0, 0);
  device.core.reset = 0;
",
        write = b + 8,
        start = b + 9,
        clear = b + 10,
        ready = b + 11,
    )
}
