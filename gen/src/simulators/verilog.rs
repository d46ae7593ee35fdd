//! The self-checking Verilog test bench.

use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::lanes::LANE_PORTS;
use std::fmt::Write;

/// What the test bench of a core with several lanes has more.
#[derive(Default)]
struct Lanes {
    declaration: String,
    connection: String,
    words: String,
    names: String,
    driven: String,
}

/// What the test bench of a core with a reset has more.
#[derive(Default)]
struct Reset {
    declaration: &'static str,
    connection: &'static str,
    prologue: &'static str,
}

impl Reset {
    fn new(wanted: bool) -> Self {
        if !wanted {
            return Self::default();
        }
        Self {
            declaration: "  reg reset = 1'b0;\n",
            connection: ".reset(reset), ",
            prologue: "    // Noise in every register, reset, a cleared memory, reset: what follows must not notice any of it.
    for (clocks = 0; clocks < 200; clocks = clocks + 1) begin
      {ready, clear, start, write} = {2'b10, clocks[4:0] == 5'd31, 1'b1};
      {select, data} = clocks * 64'h9e3779b97f4a7c15;
      #5 clock = 1'b1;
      #5 clock = 1'b0;
    end
    {ready, clear, start, write, select, data} = 0;
    reset = 1'b1;
    #5 clock = 1'b1;
    #5 clock = 1'b0;
    {reset, clear} = 2'b01;
    #5 clock = 1'b1;
    #5 clock = 1'b0;
    clear = 1'b0;
    while (busy) begin
      #5 clock = 1'b1;
      #5 clock = 1'b0;
    end
    reset = 1'b1;
    #5 clock = 1'b1;
    #5 clock = 1'b0;
    reset = 1'b0;
    clocks = 0;
",
        }
    }
}

/// Text of `tb_<core>_core.v`; `reset` says whether the core has one. Plusargs: `+vectors=FILE` (default `vectors.txt`), `+pixels=FILE` writes every pixel as
/// `x y red green blue`, `+wave=FILE` dumps a waveform, `+from=CLOCK` and `+to=CLOCK` limit it.
#[must_use]
pub fn test_bench(core: &Core, reset: bool) -> String {
    let Reset {
        declaration,
        connection,
        prologue,
    } = Reset::new(reset);
    let name = core.module();
    let b = core.bus_bits();
    let top = b - 1;
    let inputs = b + 11;
    let ports = &LANE_PORTS[..core.load_words - 1];
    let mut lanes = Lanes::default();
    for (k, [write, select, data]) in ports.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = write!(
            lanes.declaration,
            "  reg {write} = 1'b0;\n  reg [7:0] {select} = 8'd0;\n  reg [{top}:0] {data} = {b}'d0;\n"
        );
        let _ = writeln!(
            lanes.connection,
            "    .{write}({write}), .{select}({select}), .{data}({data}),"
        );
        let _ = writeln!(lanes.words, "  reg [{}:0] lane_{k};", b + 8);
        let _ = write!(lanes.names, ", lane_{k}");
        let _ = writeln!(
            lanes.driven,
            "      {{{write}, {select}, {data}}} = lane_{k};"
        );
    }
    let Lanes {
        declaration: lane_ports,
        connection: lane_connection,
        words: lane_words,
        names: lane_names,
        driven: lane_driven,
    } = lanes;
    let (scanned, count) = (" %h".repeat(ports.len()), 3 + ports.len());
    format!(
        r##"// tb_{name}_core: replays a vector file and compares every output of {name}_core in every clock.
//
// iverilog -g2001 -o sim ../rtl/*.v tb_{name}_core.v && vvp sim +vectors=vectors.txt
// Options: +pixels=FILE writes every pixel, +wave=FILE [+from=CLOCK] [+to=CLOCK] dumps a waveform.

`default_nettype none

module tb_{name}_core;

  reg clock = 1'b0;
{declaration}  reg write = 1'b0;
  reg [7:0] select = 8'd0;
  reg [{top}:0] data = {b}'d0;
  reg start = 1'b0;
  reg clear = 1'b0;
  reg ready = 1'b0;
{lane_ports}  wire load_ready;
  wire valid;
  wire [10:0] x;
  wire [10:0] y;
  wire [7:0] red;
  wire [7:0] green;
  wire [7:0] blue;
  wire [15:0] depth;
  wire busy;
  wire done;

  {name}_core core (
    .clock(clock), {connection}.write(write), .select(select), .data(data), .start(start), .clear(clear), .ready(ready),
{lane_connection}    .load_ready(load_ready), .valid(valid), .x(x), .y(y), .red(red), .green(green), .blue(blue), .depth(depth),
    .busy(busy), .done(done)
  );

  reg [8*1024-1:0] vectors_name;
  reg [8*1024-1:0] pixels_name;
  reg [8*1024-1:0] wave_name;
  reg [8*256-1:0] comment_line;
  integer vectors;
  integer pixels;
  integer character;
  integer status;
  integer from;
  integer to;
  integer clocks;
  integer pixel_count;
  integer mismatches;
  reg dumping;
  reg [{inputs}:0] in_word;
  reg [3:0] want_flags;
  reg [61:0] want_pixel;
{lane_words}
  // Reports the first difference of a clock, counts it once.
  task compare;
    begin
      if ({{done, busy, valid, load_ready}} !== want_flags || {{depth, blue, green, red, y, x}} !== want_pixel) begin
        if (mismatches == 0) begin
          if (load_ready !== want_flags[0]) report("load_ready", want_flags[0], load_ready);
          else if (valid !== want_flags[1]) report("valid", want_flags[1], valid);
          else if (busy !== want_flags[2]) report("busy", want_flags[2], busy);
          else if (done !== want_flags[3]) report("done", want_flags[3], done);
          else if (x !== want_pixel[10:0]) report("x", want_pixel[10:0], x);
          else if (y !== want_pixel[21:11]) report("y", want_pixel[21:11], y);
          else if (red !== want_pixel[29:22]) report("red", want_pixel[29:22], red);
          else if (green !== want_pixel[37:30]) report("green", want_pixel[37:30], green);
          else if (blue !== want_pixel[45:38]) report("blue", want_pixel[45:38], blue);
          else report("depth", want_pixel[61:46], depth);
        end
        mismatches = mismatches + 1;
      end
    end
  endtask

  task report(input [8*12-1:0] signal, input [15:0] expected, input [15:0] got);
    $display("MISMATCH clock=%0d signal=%0s expected=%h got=%h x=%0d y=%0d", clocks, signal, expected, got,
             want_pixel[10:0], want_pixel[21:11]);
  endtask

  initial begin
    if (!$value$plusargs("vectors=%s", vectors_name)) vectors_name = "vectors.txt";
    if (!$value$plusargs("from=%d", from)) from = 0;
    if (!$value$plusargs("to=%d", to)) to = 2147483647;
    vectors = $fopen(vectors_name, "r");
    if (vectors == 0) begin
      $display("FAIL cannot open %0s", vectors_name);
      $finish;
    end
    pixels = 0;
    if ($value$plusargs("pixels=%s", pixels_name)) pixels = $fopen(pixels_name, "w");
    dumping = $value$plusargs("wave=%s", wave_name) != 0;
    if (dumping) begin
      $dumpfile(wave_name);
      $dumpvars(0, core);
      if (from > 0) $dumpoff;
    end
    clocks = 0;
    pixel_count = 0;
    mismatches = 0;
    character = $fgetc(vectors);
    while (character == "#") begin
      status = $fgets(comment_line, vectors);
      character = $fgetc(vectors);
    end
    status = $ungetc(character, vectors);
{prologue}    while ($fscanf(vectors, "%h %h %h{scanned}\n", in_word, want_flags, want_pixel{lane_names}) == {count}) begin
      if (dumping && clocks == from && from > 0) $dumpon;
      if (dumping && clocks == to) $dumpoff;
      {{ready, clear, start, write, select, data}} = in_word;
{lane_driven}      #4;
      if (valid && ready) begin
        pixel_count = pixel_count + 1;
        if (pixels != 0) $fdisplay(pixels, "%0d %0d %0d %0d %0d", x, y, red, green, blue);
      end
      #1 clock = 1'b1;
      #4 compare;
      clocks = clocks + 1;
      #1 clock = 1'b0;
    end
    if (clocks == 0) $display("FAIL no vectors in %0s", vectors_name);
    else if (mismatches == 0) $display("PASS clocks=%0d pixels=%0d", clocks, pixel_count);
    else $display("FAIL clocks=%0d mismatches=%0d", clocks, mismatches);
    if (pixels != 0) $fclose(pixels);
    $finish;
  end

endmodule

`default_nettype wire
"##
    )
}
