//! The C++ main program for Verilator.

use shadegate_hdl::shade::device::Core;

/// Text of `main.cpp`. Arguments: vector file, then optionally a file for the pixels (`x y red green blue` per line).
#[must_use]
pub fn main_cpp(core: &Core) -> String {
    let name = core.name();
    let b = core.bus_bits();
    format!(
        r#"// Replays a vector file on the Verilator model of {name}_core and compares every output in every clock.
//
// verilator -O3 --cc --exe --build --top-module {name}_core main.cpp ../rtl/*.v && ./obj_dir/V{name}_core vectors.txt

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "V{name}_core.h"
#include "verilated.h"

double sc_time_stamp() {{ return 0; }}

namespace {{

struct Clock {{
  uint64_t inputs;
  uint64_t flags;
  uint64_t pixel;
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
    c.pixel = std::strtoull(end, &end, 16);
    clocks.push_back(c);
  }}
  std::fclose(file);
  return clocks;
}}

void report(long clock, const Clock& c, uint64_t flags, uint64_t pixel) {{
  static const struct {{ const char* name; int low; int bits; bool flag; }} fields[] = {{
      {{"load_ready", 0, 1, true}}, {{"valid", 1, 1, true}},  {{"busy", 2, 1, true}},   {{"done", 3, 1, true}},
      {{"x", 0, 11, false}},        {{"y", 11, 11, false}},   {{"red", 22, 8, false}},  {{"green", 30, 8, false}},
      {{"blue", 38, 8, false}},     {{"depth", 46, 16, false}}}};
  for (const auto& f : fields) {{
    uint64_t mask = (1ull << f.bits) - 1;
    uint64_t want = ((f.flag ? c.flags : c.pixel) >> f.low) & mask;
    uint64_t got = ((f.flag ? flags : pixel) >> f.low) & mask;
    if (want != got) {{
      std::printf("MISMATCH clock=%ld signal=%s expected=%04llx got=%04llx x=%llu y=%llu\n", clock, f.name,
                  (unsigned long long)want, (unsigned long long)got, (unsigned long long)(c.pixel & 2047),
                  (unsigned long long)(c.pixel >> 11 & 2047));
      return;
    }}
  }}
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
  FILE* pixels = argc > 2 ? std::fopen(argv[2], "w") : nullptr;
  V{name}_core* core = new V{name}_core;
  core->clock = 0;
  long pixel_count = 0;
  long mismatches = 0;
  for (size_t i = 0; i < clocks.size(); ++i) {{
    const Clock& c = clocks[i];
    core->data = c.inputs & 0x{data_mask:x}ull;
    core->select = c.inputs >> {b} & 0xff;
    core->write = c.inputs >> {w} & 1;
    core->start = c.inputs >> {s} & 1;
    core->clear = c.inputs >> {cl} & 1;
    core->ready = c.inputs >> {r} & 1;
    core->clock = 0;
    core->eval();
    if (core->valid && core->ready) {{
      ++pixel_count;
      if (pixels) std::fprintf(pixels, "%d %d %d %d %d\n", core->x, core->y, core->red, core->green, core->blue);
    }}
    core->clock = 1;
    core->eval();
    uint64_t flags = core->load_ready | core->valid << 1 | core->busy << 2 | core->done << 3;
    uint64_t pixel = (uint64_t)core->x | (uint64_t)core->y << 11 | (uint64_t)core->red << 22 |
                     (uint64_t)core->green << 30 | (uint64_t)core->blue << 38 | (uint64_t)core->depth << 46;
    if (flags != c.flags || pixel != c.pixel) {{
      if (mismatches == 0) report((long)i, c, flags, pixel);
      ++mismatches;
    }}
  }}
  if (pixels) std::fclose(pixels);
  if (mismatches == 0) {{
    std::printf("PASS clocks=%zu pixels=%ld\n", clocks.size(), pixel_count);
  }} else {{
    std::printf("FAIL clocks=%zu mismatches=%ld\n", clocks.size(), mismatches);
  }}
  delete core;
  return mismatches ? 1 : 0;
}}
"#,
        data_mask = (1u64 << b) - 1,
        w = b + 8,
        s = b + 9,
        cl = b + 10,
        r = b + 11,
    )
}
