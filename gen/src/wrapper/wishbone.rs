//! The Wishbone wrapper.

use super::bench::Protocol;
use super::parts::{core_instance, host_clock, wires, FRAMES, HOST_CORE};
use super::Context;

/// Text of `<core>_wishbone.v`.
pub fn module(c: &Context) -> String {
    let top = &c.top;
    let header = c.header(
        &format!("{top}_wishbone"),
        &format!("{top} behind Wishbone, its pixels as a stream."),
        &[
            ("Protocol", "Wishbone B4 classic slave, 32 bits, registered feedback. Pixel stream with valid and ready, 64 bits."),
            ("Source", "Wishbone B4, classic cycles: ADR_I counts registers, SEL_I must be all ones in a write."),
            ("Latency", "Two clocks per access; a write waits, without ACK_O, until the core takes it."),
        ],
    );
    format!(
        "{header}module {top}_wishbone (
  input  wire wb_clk_i,                          // Clock.
  input  wire wb_rst_i,                          // Reset, synchronous; the README says of what.
  input  wire wb_cyc_i,                          // A cycle is under way.
  input  wire wb_stb_i,                          // An access is offered.
  input  wire wb_we_i,                           // It is a write.
  input  wire [10:2] wb_adr_i,                   // Its address, without the two bits that count bytes.
  input  wire [3:0] wb_sel_i,                    // Its bytes; a write of fewer than four is refused.
  input  wire [31:0] wb_dat_i,                   // Write data.
  output wire [31:0] wb_dat_o,                   // Read data.
  output wire wb_ack_o,                          // The access is done.
  output wire wb_err_o,                          // The access is refused.
  output wire [63:0] pixel_data,                 // Pixel: depth[61:46], blue[45:38], green[37:30], red[29:22], y[21:11], x[10:0].
  output wire pixel_keep,                        // Low in the only word of a frame without pixels.
  output wire pixel_last,                        // The last word of a frame.
  output wire pixel_valid,                       // A word is offered.
  input  wire pixel_ready,                       // It is taken.
  output wire busy,                              // Something is waiting, being drawn or being cleared.
  output wire done                               // Pulses for one clock when `busy` falls.
);

  reg ack = 1'b0;                                // The access was done.
  reg refused = 1'b0;                            // The access was refused.
  reg [31:0] read = 32'd0;                       // Read data.
  wire reset = wb_rst_i;                         // Reset.
  wire answered = ack || refused;                // The access has been answered.
  wire offered = wb_cyc_i && wb_stb_i;           // An access is offered.
  wire request = offered && !answered && !reset; // It waits for an answer.
  wire write_request = request && wb_we_i;       // It is a write.
  wire write_done;                               // The write is done at the next edge.
  wire write_error;                              // It is refused.
  wire [31:0] read_data;                         // What stands at the address.
  wire read_error;                               // Nothing can be read there.
{wires}
  // Addresses to register writes.
  {top}_host host (
{host_clock}    .write_request(write_request),
    .write_address(wb_adr_i),
    .write_data(wb_dat_i),
    .write_whole(&wb_sel_i),
    .write_done(write_done),
    .write_error(write_error),
    .read_address(wb_adr_i),
    .read_data(read_data),
    .read_error(read_error),
{host_core}  );

{core}
  // End-of-frame mark.
  {top}_frames frames (
    .clock(wb_clk_i),
{frames}    .pixel_valid(pixel_valid),
    .pixel_data(pixel_data),
    .pixel_keep(pixel_keep),
    .pixel_last(pixel_last),
    .pixel_ready(pixel_ready)
  );

  assign wb_ack_o = ack;
  assign wb_err_o = refused;
  assign wb_dat_o = read;

  always @(posedge wb_clk_i) begin
    ack <= (write_done && !write_error) || (request && !wb_we_i && !read_error);
    refused <= (write_done && write_error) || (request && !wb_we_i && read_error);
    read <= read_data;
  end

endmodule

`default_nettype wire
",
        wires = wires(c),
        host_clock = host_clock(c, "wb_clk_i"),
        host_core = HOST_CORE,
        core = core_instance(c, "wb_clk_i"),
        frames = FRAMES,
    )
}

/// What the test bench needs to know of the bus.
pub(super) const BENCH: Protocol = Protocol {
    declarations: "  reg rst = 1'b1;
  reg cyc = 1'b0;
  reg stb = 1'b0;
  reg we = 1'b0;
  reg [10:2] adr = 9'd0;
  reg [3:0] sel = 4'd0;
  reg [31:0] dat_w = 32'd0;
  wire [31:0] dat_r;
  wire ack;
  wire err;
",
    connections: "    .wb_clk_i(clock), .wb_rst_i(rst), .wb_cyc_i(cyc), .wb_stb_i(stb), .wb_we_i(we), .wb_adr_i(adr),
    .wb_sel_i(sel), .wb_dat_i(dat_w), .wb_dat_o(dat_r), .wb_ack_o(ack), .wb_err_o(err),
    .pixel_data(pixel_data), .pixel_keep(pixel_keep), .pixel_last(pixel_last), .pixel_valid(pixel_valid),
    .pixel_ready(pixel_ready)",
    keep_bits: 1,
    tasks: "  // One access: strobe with or after cycle, then wait for an answer.
  task access(input write_access, input [10:0] address, input [31:0] value, input [3:0] bytes);
    begin
      idle;
      cyc = 1'b1;
      if ($random(seed) & 1) idle;
      stb = 1'b1;
      we = write_access;
      adr = address[10:2];
      sel = bytes;
      dat_w = value;
      @(posedge clock);
      while (!ack && !err) @(posedge clock);
      refused = err;
      read_value = dat_r;
      #1 stb = 1'b0;
      cyc = 1'b0;
      we = 1'b0;
    end
  endtask

  task bus_write(input [10:0] address, input [31:0] value, input [3:0] bytes);
    begin
      access(1'b1, address, value, bytes);
      writes = writes + 1;
    end
  endtask

  task bus_read(input [10:0] address);
    access(1'b0, address, 32'd0, 4'd15);
  endtask
",
    leave_reset: "rst = 1'b0",
};
