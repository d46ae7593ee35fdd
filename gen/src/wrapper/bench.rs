//! The self-checking test bench of a wrapper: the register writes of the vector file go through the bus, with random
//! waits, and the pixels that come out under random back pressure must be those of the vector file, in their order.

use super::{Context, Wrapper};

/// What differs from bus to bus.
pub(super) struct Protocol {
    /// Signals of the bus.
    pub declarations: &'static str,
    /// Connections of the wrapper, bus and stream.
    pub connections: &'static str,
    /// Width of the stream's keep.
    pub keep_bits: usize,
    /// `bus_write` and `bus_read`; they set `refused` and `read_value`, and count `writes`.
    pub tasks: &'static str,
    /// Ends the reset.
    pub leave_reset: &'static str,
}

/// Text of `tb_<core>_<wrapper>.v`. Plusargs: `+vectors=FILE` (default `vectors.txt`), `+seed=N`.
pub(super) fn text(c: &Context, wrapper: Wrapper, p: Protocol, limit: usize) -> String {
    let top = &c.top;
    let module = format!("{top}_{wrapper}");
    let b = c.bus_bits;
    let write_high = match c.high_bits() {
        0 => String::new(),
        bits => format!(
            "        if (data[{}:32] != high) begin\n          high = data[{}:32];\n          must_write(11'h400, {{{}'d0, high}});\n        end\n",
            b - 1,
            b - 1,
            32 - bits
        ),
    };
    let declare_high = match c.high_bits() {
        0 => String::new(),
        bits => format!("  reg [{}:0] high = {bits}'d0;\n", bits - 1),
    };
    format!(
        r##"// tb_{module}: the register writes of a vector file through {module}, with random waits; the pixels must be
// those of the vector file, in their order, the last one marked.
//
// iverilog -g2001 -o sim ../rtl/*.v ../wrappers/*.v tb_{module}.v && vvp sim +vectors=vectors.txt [+seed=N]

`default_nettype none

module tb_{module};

  reg clock = 1'b0;
{declarations}  wire [63:0] pixel_data;
  wire [{keep}:0] pixel_keep;
  wire pixel_last;
  wire pixel_valid;
  reg pixel_ready = 1'b0;
  wire busy;
  wire done;

  {module} dut (
{connections},
    .busy(busy), .done(done)
  );

  reg [8*1024-1:0] vectors_name;
  reg [8*256-1:0] comment_line;
  integer seed;
  integer write_file;
  integer pixel_file;
  integer character;
  integer status;
  integer clocks;
  integer writes;
  integer pixels;
  integer frames;
  integer dones;
  integer failures;
  reg refused;
  reg [31:0] read_value;
{declare_high}
  // A line of the vector file, as the writer reads it.
  reg [{inputs}:0] inputs;
  reg ready;
  reg clear;
  reg start;
  reg write;
  reg [7:0] select;
  reg [{bus}:0] data;
  reg [3:0] flags;
  reg [61:0] pixel;

  // The same as the reader of pixels sees it, and the next pixels that it expects.
  reg [{inputs}:0] line_inputs;
  reg [3:0] line_flags;
  reg [61:0] line_pixel;
  reg offered;
  reg [61:0] offered_pixel;
  reg more;
  reg [61:0] want;
  reg more_after;
  reg [61:0] want_after;

  // The word of the clock before that was not taken.
  reg stalled;
  reg [63:0] stalled_data;
  reg stalled_last;

  always #5 clock = !clock;

  task fail(input [8*40-1:0] what);
    begin
      if (failures == 0) $display("MISMATCH clock=%0d writes=%0d pixels=%0d %0s", clocks, writes, pixels, what);
      failures = failures + 1;
    end
  endtask

  task skip_comments(input integer file);
    begin
      character = $fgetc(file);
      while (character == "#") begin
        status = $fgets(comment_line, file);
        character = $fgetc(file);
      end
      status = $ungetc(character, file);
    end
  endtask

  // The next pixel that the vector file hands over: offered after one line, taken by the next.
  task next_pixel;
    begin
      want = want_after;
      more = more_after;
      more_after = 1'b0;
      status = 3;
      while (status == 3 && !more_after) begin
        status = $fscanf(pixel_file, "%h %h %h\n", line_inputs, line_flags, line_pixel);
        if (status == 3) begin
          if (offered && line_inputs[{inputs}]) begin
            more_after = 1'b1;
            want_after = offered_pixel;
          end
          offered = line_flags[1];
          offered_pixel = line_pixel;
        end
      end
    end
  endtask

  // Zero to three clocks; leaves just after an edge.
  task idle;
    begin
      repeat ($random(seed) & 3) @(posedge clock);
      #1;
    end
  endtask

{tasks}
  task must_write(input [10:0] address, input [31:0] value);
    begin
      bus_write(address, value, 4'd15);
      if (refused) fail("a write was refused");
    end
  endtask

  task must_refuse(input [10:0] address, input [3:0] bytes);
    begin
      bus_write(address, 32'd7, bytes);
      if (!refused) fail("a write was not refused");
    end
  endtask

  // The consumer: random back pressure, every word checked.
  always @(posedge clock) begin
    clocks = clocks + 1;
    if (clocks > {limit}) begin
      $display("FAIL no end after %0d clocks, writes=%0d pixels=%0d", clocks, writes, pixels);
      $finish;
    end
    if (done) dones = dones + 1;
    if (stalled && (!pixel_valid || pixel_data !== stalled_data || pixel_last !== stalled_last))
      fail("a word changed before it was taken");
    stalled = pixel_valid && !pixel_ready;
    stalled_data = pixel_data;
    stalled_last = pixel_last;
    if (pixel_valid && pixel_ready) begin
      if (pixel_keep === {keep_bits}'d0) begin
        if (!pixel_last || more) fail("an empty word out of place");
      end else begin
        if (pixel_keep !== ~{keep_bits}'d0) fail("a word in part");
        if (!more) fail("a pixel too many");
        if (pixel_data !== {{2'd0, want}}) fail("another pixel than expected");
        if (pixel_last !== !more_after) fail("the end of the frame in the wrong place");
        pixels = pixels + 1;
        next_pixel;
      end
      if (pixel_last) frames = frames + 1;
    end
    #1 pixel_ready = ($random(seed) & 3) != 0;
  end

  initial begin
    if (!$value$plusargs("vectors=%s", vectors_name)) vectors_name = "vectors.txt";
    if (!$value$plusargs("seed=%d", seed)) seed = 1;
    clocks = 0;
    writes = 0;
    pixels = 0;
    frames = 0;
    dones = 0;
    failures = 0;
    stalled = 1'b0;
    offered = 1'b0;
    more_after = 1'b0;
    write_file = $fopen(vectors_name, "r");
    pixel_file = $fopen(vectors_name, "r");
    if (write_file == 0 || pixel_file == 0) begin
      $display("FAIL cannot open %0s", vectors_name);
      $finish;
    end
    skip_comments(write_file);
    skip_comments(pixel_file);
    next_pixel;
    next_pixel;
    repeat (4) @(posedge clock);
    #1 {leave_reset};

    // Nothing to write there, and not all bytes: refused, without a trace.
    must_refuse(11'h408, 4'd15);
    must_refuse(11'h40c, 4'd15);
    must_refuse(11'h404, 4'd1);
    bus_read(11'h404);
    if (!refused) fail("a read was not refused");

    while ($fscanf(write_file, "%h %h %h\n", inputs, flags, pixel) == 3) begin
      {{ready, clear, start, write, select, data}} = inputs;
      if (write) begin
{write_high}        must_write({{1'b0, select, 2'd0}}, data[31:0]);
      end
      if (start) must_write(11'h404, 32'd1);
      if (clear) must_write(11'h404, 32'd2);
      if (write && ($random(seed) & 15) == 0) begin
        bus_read(11'h408);
        if (refused || read_value[31:2] != 30'd0) fail("a status that cannot be");
      end
    end
    must_write(11'h404, 32'd4);

    // A clear waits for the frame to end; a frame without pixels ends too.
    must_write(11'h404, 32'd2);
    if (frames == 0 && !pixel_valid) fail("a clear before the end of the frame");
    must_write(11'h404, 32'd4);
    while (frames < 2) @(posedge clock);
    if (more) fail("a pixel too few");
    if (pixels > 0 && dones == 0) fail("no done");
    bus_read(11'h408);
    if (refused || read_value != 32'd1) fail("not idle in the end");
    if (failures == 0) $display("PASS writes=%0d pixels=%0d clocks=%0d", writes, pixels, clocks);
    else $display("FAIL writes=%0d pixels=%0d failures=%0d", writes, pixels, failures);
    $finish;
  end

endmodule

`default_nettype wire
"##,
        declarations = p.declarations,
        connections = p.connections,
        keep = p.keep_bits - 1,
        keep_bits = p.keep_bits,
        tasks = p.tasks,
        leave_reset = p.leave_reset,
        bus = b - 1,
        inputs = b + 11,
    )
}
