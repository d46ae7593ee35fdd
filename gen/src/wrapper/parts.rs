//! What stands between the bus of a wrapper and its core, the same in every wrapper: host, core and frames, wired up.

use super::Context;

/// Wires between host, core and frames.
pub fn wires(c: &Context) -> String {
    format!(
        "  wire write;                                    // Register write.
  wire [7:0] select;                             // Channel mask and word number.
  wire [{}:0] data;                              // Register bus.
  wire start;                                    // The words are complete.
  wire clear;                                    // Clear the depth memory.
  wire load_ready;                               // Words may be written.
  wire end_frame;                                // What has been started is the rest of the frame.
  wire ending;                                   // The end of a frame has not left yet.
  wire valid;                                    // The core offers a pixel.
  wire ready;                                    // It is taken.
  wire [10:0] x;                                 // Its column.
  wire [10:0] y;                                 // Its row.
  wire [7:0] red;                                // Red.
  wire [7:0] green;                              // Green.
  wire [7:0] blue;                               // Blue.
  wire [15:0] depth;                             // Depth.
",
        c.bus_bits - 1
    )
}

/// Clock and reset of the host, where it has any.
pub fn host_clock(c: &Context, clock: &str) -> String {
    if c.high_bits() == 0 {
        String::new()
    } else {
        format!("    .clock({clock}),\n    .reset(reset),\n")
    }
}

/// The host's connections to core and frames.
pub const HOST_CORE: &str = "    .write(write),
    .select(select),
    .data(data),
    .start(start),
    .clear(clear),
    .load_ready(load_ready),
    .busy(busy),
    .end_frame(end_frame),
    .ending(ending)
";

/// The frames' connections to core and host.
pub const FRAMES: &str = "    .reset(reset),
    .valid(valid),
    .x(x),
    .y(y),
    .red(red),
    .green(green),
    .blue(blue),
    .depth(depth),
    .busy(busy),
    .ready(ready),
    .end_frame(end_frame),
    .ending(ending),
";

/// The core.
pub fn core_instance(c: &Context, clock: &str) -> String {
    let ports = [
        "write",
        "select",
        "data",
        "start",
        "clear",
        "ready",
        "load_ready",
        "valid",
        "x",
        "y",
        "red",
        "green",
        "blue",
        "depth",
        "busy",
        "done",
    ];
    let reset = c.reset.then_some("reset");
    let list: Vec<String> = reset
        .iter()
        .chain(&ports)
        .map(|p| format!("    .{p}({p})"))
        .collect();
    format!(
        "  // The core.\n  {} core (\n    .clock({clock}),\n{}\n  );\n",
        c.top,
        list.join(",\n")
    )
}
