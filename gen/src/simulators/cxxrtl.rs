//! The C++ main program for CXXRTL, the simulation back end of Yosys.
//!
//! A step of CXXRTL evaluates the flattened design once: registers take their values at the rising edge, and what
//! follows from them is seen by the next step, which is that of the falling edge. So a clock is high first, then low.

use super::replay::{clock_head, drive, observe, program, Device};
use shadegate_hdl::shade::device::Core;

/// How CXXRTL spells a name of Verilog.
fn mangled(name: &str) -> String {
    format!("p_{}", name.replace('_', "__"))
}

/// Text of the program, which includes the model as `core.cpp`. Arguments: vector file, then optionally a file for the
/// pixels (`x y red green blue` per line). Compiled with `SHADEGATE_WAVE` it takes three more: a file for the waveform,
/// its first clock, and the clock before which it ends.
#[must_use]
pub fn cxxrtl_main(core: &Core) -> String {
    let name = core.module();
    let top = mangled(&format!("{name}_core"));
    let head = clock_head(core, " number");
    let drive = drive(core, |port, value| {
        format!("core.{}.set<uint64_t>({value});", mangled(port))
    });
    let observe = observe(|port| format!("core.{}.get<uint64_t>()", mangled(port)));
    program(&Device {
        ready: core.bus_bits() + 11,
        lanes: core.load_words - 1,
        prologue: String::new(),
        heading: format!(
            "// Replays a vector file on the CXXRTL model of {name}_core and compares every output in every clock.\n\
             //\n\
             // yosys -p \"read_verilog rtl/*.v; hierarchy -top {name}_core; write_cxxrtl core.cpp\"\n\
             // g++ -O2 -I$(yosys-config --datdir)/include main.cpp -o simulation && ./simulation vectors.txt\n\
             // With -DSHADEGATE_WAVE: ./simulation vectors.txt pixels.txt wave.vcd FROM TO\n"
        ),
        includes: "// The core looks at no word that it reads beyond its memory; CXXRTL reads first and would stop there.\n\
                   #define CXXRTL_NDEBUG\n\
                   #include \"core.cpp\"\n\
                   #ifdef SHADEGATE_WAVE\n\
                   #include <backends/cxxrtl/cxxrtl_vcd.h>\n\
                   #endif\n"
            .into(),
        definition: format!(
            "struct Device {{
  cxxrtl_design::{top} core;
#ifdef SHADEGATE_WAVE
  cxxrtl::debug_items items;
  cxxrtl::vcd_writer vcd;
  FILE* wave = nullptr;
  size_t from = 0;
  size_t to = 0;
  bool written = true;

  Device(int argc, char** argv) {{
    if (argc < 6) return;
    wave = std::fopen(argv[3], \"w\");
    written = wave != nullptr;
    from = std::strtoull(argv[4], nullptr, 10);
    to = std::strtoull(argv[5], nullptr, 10);
    core.debug_info(items, \"{name}_core \");
    vcd.timescale(1, \"ns\");
    vcd.add_without_memories(items);
  }}

  // Ten nanoseconds a clock; the edge rises at its beginning.
  void sample(size_t number, uint64_t ns) {{
    if (!wave || number < from || number >= to) return;
    vcd.sample(number * 10 + ns);
    written = std::fwrite(vcd.buffer.data(), 1, vcd.buffer.size(), wave) == vcd.buffer.size() && written;
    vcd.buffer.clear();
  }}

  void settle() {{ core.step(); }}

  bool finish() {{
    if (wave) written = std::fclose(wave) == 0 && written;
    return written;
  }}
#else
  Device(int, char**) {{}}
  void sample(size_t, uint64_t) {{}}
  void settle() {{}}
  bool finish() {{ return true; }}
#endif

{head}{drive}    core.p_clock.set<uint64_t>(1);
    core.step();
    settle();
    sample(number, 0);
    core.p_clock.set<uint64_t>(0);
    core.step();
    sample(number, 5);
  }}

{observe}}};
"
        ),
    })
}
