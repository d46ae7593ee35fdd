//! The pixel stream with an end-of-frame mark.
//!
//! Only the pixel after it shows that a pixel was not the last one. So one pixel is held back until another comes, or
//! until the host has ended the frame and the core is idle; then it leaves with the mark. A frame without a visible
//! pixel leaves as one word that is marked as the last and as holding nothing.

use super::Context;

/// Text of `<core>_frames.v`.
pub fn module(c: &Context) -> String {
    let top = &c.top;
    let header = c.header(
        &format!("{top}_frames"),
        "pixel words with an end-of-frame mark.",
        &[
            ("Word", "{2'b0, depth[15:0], blue[7:0], green[7:0], red[7:0], y[10:0], x[10:0]}"),
            ("Source", "The pixel word of the vector file; see README.md."),
            ("Latency", "A pixel leaves when the next one comes, the last one when the frame is ended and the core idle."),
        ],
    );
    format!(
        "{header}module {top}_frames (
  input  wire clock,                             // Clock.
  input  wire reset,                             // Forgets held pixels and a waiting end.
  input  wire valid,                             // From the core: a pixel is offered.
  input  wire [10:0] x,                          // Its column.
  input  wire [10:0] y,                          // Its row.
  input  wire [7:0] red,                         // Red.
  input  wire [7:0] green,                       // Green.
  input  wire [7:0] blue,                        // Blue.
  input  wire [15:0] depth,                      // Depth, larger is nearer.
  input  wire busy,                              // From the core: not idle.
  output wire ready,                             // To the core: the pixel is taken.
  input  wire end_frame,                         // What has been started is the rest of the frame.
  output wire ending,                            // The end of a frame has not left yet.
  output wire pixel_valid,                       // A word is offered; held until `pixel_ready`.
  output wire [63:0] pixel_data,                 // The pixel.
  output wire pixel_keep,                        // Low in the only word of a frame without pixels.
  output wire pixel_last,                        // The last word of its frame.
  input  wire pixel_ready                        // The word is taken.
);

  reg held = 1'b0;                               // A pixel is held back.
  reg [61:0] held_pixel = 62'd0;                 // That pixel.
  reg out_valid = 1'b0;                          // A word is offered.
  reg [61:0] out_pixel = 62'd0;                  // That word.
  reg out_keep = 1'b0;                           // It holds a pixel.
  reg out_last = 1'b0;                           // It is the last of its frame.
  reg is_ending = 1'b0;                          // The host has ended the frame.
  wire free = !out_valid || pixel_ready;         // The output can take a word.
  wire finish = is_ending && !busy && free;      // The last word moves to the output.

  assign ready = (!held || free) && !reset;
  assign ending = is_ending;
  assign pixel_valid = out_valid;
  assign pixel_data = {{2'd0, out_pixel}};
  assign pixel_keep = out_keep;
  assign pixel_last = out_last;

  always @(posedge clock) begin
    if (pixel_ready) out_valid <= 1'b0;
    if (end_frame) is_ending <= 1'b1;
    if (valid && ready) begin
      held <= 1'b1;
      held_pixel <= {{depth, blue, green, red, y, x}};
      if (held) begin
        out_valid <= 1'b1;
        out_pixel <= held_pixel;
        out_keep <= 1'b1;
        out_last <= 1'b0;
      end
    end else if (finish) begin
      held <= 1'b0;
      is_ending <= 1'b0;
      out_valid <= 1'b1;
      out_pixel <= held_pixel;
      out_keep <= held;
      out_last <= 1'b1;
    end
    if (reset) begin
      held <= 1'b0;
      is_ending <= 1'b0;
      out_valid <= 1'b0;
    end
  end

endmodule

`default_nettype wire
"
    )
}
