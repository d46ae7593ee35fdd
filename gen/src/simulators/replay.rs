//! The C++ main program that every compiled simulator shares: reads the vectors into memory, clocks the device through
//! them, compares every output in every clock, and says how long that loop took.
//!
//! Nothing but the loop is timed: reading the vectors comes before it, writing the pixels after it. Inside are the
//! stimulus, the clocking, the comparison, and the capture of pixels in memory.

use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::lanes::LANE_PORTS;

/// What differs from simulator to simulator.
pub(super) struct Device {
    /// Bit of the inputs word that is `ready`.
    pub ready: usize,
    /// Further lanes of the load port.
    pub lanes: usize,
    /// Comment lines at the head of the program, with slashes.
    pub heading: String,
    /// `#include` lines.
    pub includes: String,
    /// Statements that clock `device` before the vectors.
    pub prologue: String,
    /// `struct Device`: `Device(argc, argv)`, `clock(number, inputs)`, `flags()`, `pixel()`, `finish()`.
    pub definition: String,
}

/// Statements that set the inputs of a core from the first word of a line; `set(port, value)` makes one.
pub(super) fn drive(core: &Core, set: impl Fn(&str, &str) -> String) -> String {
    let b = core.bus_bits();
    let data = format!("inputs & 0x{:x}ull", (1u64 << b) - 1);
    let fields = [
        ("data", data),
        ("select", format!("inputs >> {b} & 0xff")),
        ("write", format!("inputs >> {} & 1", b + 8)),
        ("start", format!("inputs >> {} & 1", b + 9)),
        ("clear", format!("inputs >> {} & 1", b + 10)),
        ("ready", format!("inputs >> {} & 1", b + 11)),
    ];
    let line = |(port, value): &(&str, String)| format!("    {}\n", set(port, value));
    let mut out: String = fields.iter().map(line).collect();
    for (k, [write, select, data]) in LANE_PORTS[..core.load_words - 1].iter().enumerate() {
        let fields = [
            (*data, format!("lanes[{k}] & 0x{:x}ull", (1u64 << b) - 1)),
            (*select, format!("lanes[{k}] >> {b} & 0xff")),
            (*write, format!("lanes[{k}] >> {} & 1", b + 8)),
        ];
        out.extend(fields.iter().map(line));
    }
    out
}

/// The head of the method that clocks a device; before it, for a core with several lanes, one that leaves all but the
/// first idle.
pub(super) fn clock_head(core: &Core, number: &str) -> String {
    let lanes = core.load_words - 1;
    if lanes == 0 {
        return format!("  void clock(size_t{number}, uint64_t inputs) {{\n");
    }
    format!(
        "  void clock(size_t number, uint64_t inputs) {{
    const uint64_t idle[{lanes}] = {{}};
    clock(number, inputs, idle);
  }}

  void clock(size_t{number}, uint64_t inputs, const uint64_t* lanes) {{\n"
    )
}

/// The methods that read a core's outputs as the second and third word of a line; `get(port)` reads one.
pub(super) fn observe(get: impl Fn(&str) -> String) -> String {
    let word = |fields: &[(&str, u32)]| {
        let one = |(port, low): &(&str, u32)| format!("(uint64_t){} << {low}", get(port));
        fields
            .iter()
            .map(one)
            .collect::<Vec<_>>()
            .join(" |\n           ")
    };
    let flags = word(&[("load_ready", 0), ("valid", 1), ("busy", 2), ("done", 3)]);
    let pixel = word(&[
        ("x", 0),
        ("y", 11),
        ("red", 22),
        ("green", 30),
        ("blue", 38),
        ("depth", 46),
    ]);
    format!(
        "  uint64_t flags() const {{\n    return {flags};\n  }}\n\n  \
         uint64_t pixel() const {{\n    return {pixel};\n  }}\n"
    )
}

/// The whole program around a device.
pub(super) fn program(device: &Device) -> String {
    let Device {
        ready,
        lanes,
        heading,
        includes,
        prologue,
        definition,
    } = device;
    let (field, read, passed) = match lanes {
        0 => (String::new(), String::new(), ""),
        n => (
            format!("\n  uint64_t lanes[{n}];"),
            format!(
                "\n    for (int k = 0; k < {n}; ++k) c.lanes[k] = std::strtoull(end, &end, 16);"
            ),
            ", c.lanes",
        ),
    };
    format!(
        r#"{heading}
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

{includes}
namespace {{

{definition}
struct Clock {{
  uint64_t inputs;
  uint64_t flags;
  uint64_t pixel;{field}
}};

std::vector<Clock> read_vectors(const char* name) {{
  std::vector<Clock> clocks;
  FILE* file = std::fopen(name, "r");
  if (!file) return clocks;
  char line[256];
  while (std::fgets(line, sizeof line, file)) {{
    if (line[0] == '#') continue;
    char* end = line;
    Clock c;
    c.inputs = std::strtoull(end, &end, 16);
    c.flags = std::strtoull(end, &end, 16);
    c.pixel = std::strtoull(end, &end, 16);{read}
    clocks.push_back(c);
  }}
  std::fclose(file);
  return clocks;
}}

void report(size_t clock, const Clock& c, uint64_t flags, uint64_t pixel) {{
  static const struct {{ const char* name; int low; int bits; bool flag; }} fields[] = {{
      {{"load_ready", 0, 1, true}}, {{"valid", 1, 1, true}},  {{"busy", 2, 1, true}},   {{"done", 3, 1, true}},
      {{"x", 0, 11, false}},        {{"y", 11, 11, false}},   {{"red", 22, 8, false}},  {{"green", 30, 8, false}},
      {{"blue", 38, 8, false}},     {{"depth", 46, 16, false}}}};
  for (const auto& f : fields) {{
    uint64_t mask = (1ull << f.bits) - 1;
    uint64_t want = ((f.flag ? c.flags : c.pixel) >> f.low) & mask;
    uint64_t got = ((f.flag ? flags : pixel) >> f.low) & mask;
    if (want != got) {{
      std::printf("MISMATCH clock=%zu signal=%s expected=%04llx got=%04llx x=%llu y=%llu\n", clock, f.name,
                  (unsigned long long)want, (unsigned long long)got, (unsigned long long)(c.pixel & 2047),
                  (unsigned long long)(c.pixel >> 11 & 2047));
      return;
    }}
  }}
}}

bool write_pixels(const char* name, const std::vector<uint64_t>& pixels) {{
  FILE* file = std::fopen(name, "w");
  if (!file) return false;
  for (uint64_t p : pixels) {{
    std::fprintf(file, "%d %d %d %d %d\n", (int)(p & 2047), (int)(p >> 11 & 2047), (int)(p >> 22 & 255),
                 (int)(p >> 30 & 255), (int)(p >> 38 & 255));
  }}
  return std::fclose(file) == 0;
}}

}}  // namespace

int main(int argc, char** argv) {{
  if (argc < 2) {{
    std::printf("FAIL usage: %s VECTORS [PIXELS]\n", argv[0]);
    return 2;
  }}
  const std::vector<Clock> clocks = read_vectors(argv[1]);
  if (clocks.empty()) {{
    std::printf("FAIL no vectors in %s\n", argv[1]);
    return 2;
  }}
  Device device(argc, argv);
{prologue}  std::vector<uint64_t> pixels;
  pixels.reserve(clocks.size());
  uint64_t flags = 0;
  uint64_t pixel = 0;
  size_t mismatches = 0;
  size_t first = 0;
  uint64_t first_flags = 0;
  uint64_t first_pixel = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (size_t i = 0; i < clocks.size(); ++i) {{
    const Clock& c = clocks[i];
    // What was offered after the last edge is taken by this one.
    if ((flags >> 1 & 1) && (c.inputs >> {ready} & 1)) pixels.push_back(pixel);
    device.clock(i, c.inputs{passed});
    flags = device.flags();
    pixel = device.pixel();
    if (flags != c.flags || pixel != c.pixel) {{
      if (mismatches == 0) {{
        first = i;
        first_flags = flags;
        first_pixel = pixel;
      }}
      ++mismatches;
    }}
  }}
  const auto end = std::chrono::steady_clock::now();
  const long long loop_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(end - begin).count();
  if (!device.finish()) {{
    std::printf("FAIL cannot write the waveform\n");
    return 2;
  }}
  if (argc > 2 && !write_pixels(argv[2], pixels)) {{
    std::printf("FAIL cannot write %s\n", argv[2]);
    return 2;
  }}
  if (mismatches == 0) {{
    std::printf("PASS clocks=%zu pixels=%zu loop_ns=%lld\n", clocks.size(), pixels.size(), loop_ns);
  }} else {{
    report(first, clocks[first], first_flags, first_pixel);
    std::printf("FAIL clocks=%zu mismatches=%zu loop_ns=%lld\n", clocks.size(), mismatches, loop_ns);
  }}
  return mismatches ? 1 : 0;
}}
"#
    )
}
