//! The AXI4-Lite and AXI4-Stream wrapper.

use super::bench::Protocol;
use super::parts::{core_instance, host_clock, wires, FRAMES, HOST_CORE};
use super::Context;

/// Text of `<core>_axi.v`.
pub fn module(c: &Context) -> String {
    let top = &c.top;
    let header = c.header(
        &format!("{top}_axi"),
        &format!("{top} behind AXI4-Lite, its pixels as AXI4-Stream."),
        &[
            ("Protocol", "AXI4-Lite slave, 32 bits: one write per two clocks. AXI4-Stream master, 64 bits: one pixel per clock."),
            ("Source", "AMBA AXI4-Lite and AXI4-Stream; no output depends on an input of the same clock."),
            ("Latency", "A write reaches the core two clocks after address and data, or when the core takes it."),
        ],
    );
    let host_clock = host_clock(c, "aclk");
    let core = core_instance(c, "aclk");
    format!(
        "{header}module {top}_axi (
  input  wire aclk,                              // Clock.
  input  wire aresetn,                           // Reset, active low, synchronous; the README says of what.
  input  wire [10:0] s_axi_awaddr,               // Write address.
  input  wire s_axi_awvalid,                     // A write address is offered.
  output wire s_axi_awready,                     // It is taken.
  input  wire [31:0] s_axi_wdata,                // Write data.
  input  wire [3:0] s_axi_wstrb,                 // Bytes of it; a write of fewer than four is refused.
  input  wire s_axi_wvalid,                      // Write data is offered.
  output wire s_axi_wready,                      // It is taken.
  output wire [1:0] s_axi_bresp,                 // OKAY (0) or SLVERR (2).
  output wire s_axi_bvalid,                      // A write response is offered.
  input  wire s_axi_bready,                      // It is taken.
  input  wire [10:0] s_axi_araddr,               // Read address.
  input  wire s_axi_arvalid,                     // A read address is offered.
  output wire s_axi_arready,                     // It is taken.
  output wire [31:0] s_axi_rdata,                // Read data.
  output wire [1:0] s_axi_rresp,                 // OKAY (0) or SLVERR (2).
  output wire s_axi_rvalid,                      // Read data is offered.
  input  wire s_axi_rready,                      // It is taken.
  output wire [63:0] m_axis_tdata,               // Pixel: depth[61:46], blue[45:38], green[37:30], red[29:22], y[21:11], x[10:0].
  output wire [7:0] m_axis_tkeep,                // All ones; all zeros in the only word of a frame without pixels.
  output wire m_axis_tlast,                      // The last word of a frame.
  output wire m_axis_tvalid,                     // A word is offered.
  input  wire m_axis_tready,                     // It is taken.
  output wire busy,                              // Something is waiting, being drawn or being cleared.
  output wire done                               // Pulses for one clock when `busy` falls.
);

  reg aw_full = 1'b0;                            // A write address waits.
  reg [10:2] aw_address = 9'd0;                  // It.
  reg aw_aligned = 1'b0;                         // It is that of a whole register.
  reg w_full = 1'b0;                             // Write data waits.
  reg [31:0] w_data = 32'd0;                     // It.
  reg w_whole = 1'b0;                            // It has all four bytes.
  reg b_valid = 1'b0;                            // A write response is offered.
  reg b_error = 1'b0;                            // It says that the write was refused.
  reg r_valid = 1'b0;                            // Read data is offered.
  reg [31:0] r_data = 32'd0;                     // It.
  reg r_error = 1'b0;                            // Nothing can be read there.
  wire reset = !aresetn;                         // Reset, active high.
  wire write_request;                            // Address and data are there, and room for the response.
  wire write_done;                               // The write is done at the next edge.
  wire write_error;                              // It is refused.
  wire [31:0] read_data;                         // What stands at the read address.
  wire read_error;                               // Nothing can be read there.
  wire pixel_keep;                               // The word of the stream holds a pixel.
{wires}
  // Addresses to register writes.
  {top}_host host (
{host_clock}    .write_request(write_request),
    .write_address(aw_address),
    .write_data(w_data),
    .write_whole(aw_aligned && w_whole),
    .write_done(write_done),
    .write_error(write_error),
    .read_address(s_axi_araddr[10:2]),
    .read_data(read_data),
    .read_error(read_error),
{host_core}  );

{core}
  // End-of-frame mark.
  {top}_frames frames (
    .clock(aclk),
{frames}    .pixel_valid(m_axis_tvalid),
    .pixel_data(m_axis_tdata),
    .pixel_keep(pixel_keep),
    .pixel_last(m_axis_tlast),
    .pixel_ready(m_axis_tready)
  );

  assign s_axi_awready = !aw_full;
  assign s_axi_wready = !w_full;
  assign s_axi_bvalid = b_valid;
  assign s_axi_bresp = {{b_error, 1'b0}};
  assign s_axi_arready = !r_valid;
  assign s_axi_rvalid = r_valid;
  assign s_axi_rdata = r_data;
  assign s_axi_rresp = {{r_error, 1'b0}};
  assign m_axis_tkeep = {{8{{pixel_keep}}}};
  assign write_request = aw_full && w_full && (!b_valid || s_axi_bready);

  always @(posedge aclk) begin
    if (s_axi_awvalid && !aw_full) begin
      aw_full <= 1'b1;
      aw_address <= s_axi_awaddr[10:2];
      aw_aligned <= s_axi_awaddr[1:0] == 2'd0;
    end
    if (s_axi_wvalid && !w_full) begin
      w_full <= 1'b1;
      w_data <= s_axi_wdata;
      w_whole <= &s_axi_wstrb;
    end
    if (s_axi_bready) b_valid <= 1'b0;
    if (write_done) begin
      aw_full <= 1'b0;
      w_full <= 1'b0;
      b_valid <= 1'b1;
      b_error <= write_error;
    end
    if (s_axi_rready) r_valid <= 1'b0;
    if (s_axi_arvalid && !r_valid) begin
      r_valid <= 1'b1;
      r_data <= read_data;
      r_error <= read_error || (s_axi_araddr[1:0] != 2'd0);
    end
    if (reset) begin
      aw_full <= 1'b0;
      w_full <= 1'b0;
      b_valid <= 1'b0;
      r_valid <= 1'b0;
    end
  end

endmodule

`default_nettype wire
",
        wires = wires(c),
        host_core = HOST_CORE,
        frames = FRAMES,
    )
}

/// What the test bench needs to know of the bus.
pub(super) const BENCH: Protocol = Protocol {
    declarations: "  reg aresetn = 1'b0;
  reg [10:0] awaddr = 11'd0;
  reg awvalid = 1'b0;
  wire awready;
  reg [31:0] wdata = 32'd0;
  reg [3:0] wstrb = 4'd0;
  reg wvalid = 1'b0;
  wire wready;
  wire [1:0] bresp;
  wire bvalid;
  reg bready = 1'b0;
  reg [10:0] araddr = 11'd0;
  reg arvalid = 1'b0;
  wire arready;
  wire [31:0] rdata;
  wire [1:0] rresp;
  wire rvalid;
  reg rready = 1'b0;
",
    connections: "    .aclk(clock), .aresetn(aresetn),
    .s_axi_awaddr(awaddr), .s_axi_awvalid(awvalid), .s_axi_awready(awready),
    .s_axi_wdata(wdata), .s_axi_wstrb(wstrb), .s_axi_wvalid(wvalid), .s_axi_wready(wready),
    .s_axi_bresp(bresp), .s_axi_bvalid(bvalid), .s_axi_bready(bready),
    .s_axi_araddr(araddr), .s_axi_arvalid(arvalid), .s_axi_arready(arready),
    .s_axi_rdata(rdata), .s_axi_rresp(rresp), .s_axi_rvalid(rvalid), .s_axi_rready(rready),
    .m_axis_tdata(pixel_data), .m_axis_tkeep(pixel_keep), .m_axis_tlast(pixel_last), .m_axis_tvalid(pixel_valid),
    .m_axis_tready(pixel_ready)",
    keep_bits: 8,
    tasks: "  // One write: address and data in any order, the response taken late.
  task bus_write(input [10:0] address, input [31:0] value, input [3:0] bytes);
    begin
      fork
        begin
          idle;
          awaddr = address;
          awvalid = 1'b1;
          @(posedge clock);
          while (!awready) @(posedge clock);
          #1 awvalid = 1'b0;
        end
        begin
          idle;
          wdata = value;
          wstrb = bytes;
          wvalid = 1'b1;
          @(posedge clock);
          while (!wready) @(posedge clock);
          #1 wvalid = 1'b0;
        end
        begin
          idle;
          bready = 1'b1;
          @(posedge clock);
          while (!bvalid) @(posedge clock);
          refused = bresp != 2'd0;
          #1 bready = 1'b0;
        end
      join
      writes = writes + 1;
    end
  endtask

  // One read.
  task bus_read(input [10:0] address);
    begin
      idle;
      araddr = address;
      arvalid = 1'b1;
      @(posedge clock);
      while (!arready) @(posedge clock);
      #1 arvalid = 1'b0;
      idle;
      rready = 1'b1;
      @(posedge clock);
      while (!rvalid) @(posedge clock);
      read_value = rdata;
      refused = rresp != 2'd0;
      #1 rready = 1'b0;
    end
  endtask
",
    leave_reset: "aresetn = 1'b1",
};
