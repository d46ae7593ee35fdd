// What the walk of a line promises. Words of the next line wait until the walk is free. A line of "last" + 1 columns
// begins at (major, minor); i columns on, after r moves of the minor coordinate, it stands at major + i and, falling,
// at minor - r, otherwise at minor + r. It moves with the next column where the error term is positive, and the error
// term then rises by "move", else by "stay". A column takes a clock for each of its lanes, or one if it is taken whole.
`default_nettype none

module golden_line_walk #(parameter A = 3) (
  input wire clock, input wire write, input wire [3:0] word, input wire [23:0] data,
  input wire start, input wire hold, input wire go, input wire whole,
  output wire load_ready, output wire load, output wire run, output wire turn, output wire rises, output wire active,
  output wire [1:0] lane, output wire [1:0] last_lane, output wire [11:0] major, output wire [11:0] minor,
  output wire [A-1:0] address, output wire steep, output wire falling,
  output wire [11:0] frame_width, output wire [11:0] frame_height, output wire busy
);
  // The register file as it was written, and what the walk took of it.
  reg [14:0] w0;
  reg [23:0] w1;
  reg [A-1:0] w2;
  reg [13:0] w3, w4, w5;
  reg [23:0] size;
  reg full;
  reg [14:0] shape;
  reg [11:0] x0, y0;
  reg [A-1:0] place;
  reg signed [13:0] e;
  reg [13:0] stay, move;
  reg on;
  reg [11:0] i, r;
  reg [1:0] l;

  assign {last_lane, falling, steep} = shape[14:11];
  wire [10:0] last = shape[10:0];
  wire end_of_column = whole || l == last_lane;
  wire [10:0] left = last - i;  // columns that follow
  wire end_of_line = end_of_column && left == 0;
  wire next = on && go;
  wire begins = full && !hold && !(on && !(next && end_of_line));
  assign rises = e > 0;
  wire moves = next && end_of_column && !end_of_line && !begins;

  // One row and one column of the frame as steps of an address.
  wire [A-1:0] row = size[11:0];
  wire [A-1:0] along = steep ? row : 1;
  wire [A-1:0] across = steep ? 1 : row;
  wire [A-1:0] sideways = !rises ? 0 : falling ? -across : across;

  always @(posedge clock) begin
    if (write && !full) case (word)
      0: w0 <= data; 1: w1 <= data; 2: w2 <= data; 3: w3 <= data; 4: w4 <= data; 5: w5 <= data; 11: size <= data;
    endcase
    full <= full ? !begins : start;
    on <= begins || (on && !(next && end_of_line));
    if (begins) begin
      shape <= w0; {y0, x0} <= w1; place <= w2; e <= w3; stay <= w4; move <= w5;
      i <= 0; r <= 0; l <= 0;
    end else if (moves) begin
      i <= i + 1;
      r <= r + rises;
      e <= rises ? e + move : e + stay;
      place <= place + along + sideways;
      l <= 0;
    end else if (next && !end_of_column) l <= l + 1;
  end

  assign load_ready = !full;
  assign load = begins;
  assign run = next;
  assign turn = end_of_column;
  assign active = on;
  assign lane = l;
  assign major = x0 + i;
  assign minor = falling ? y0 - r : y0 + r;
  assign address = place;
  assign {frame_height, frame_width} = size;
  assign busy = full || on;
endmodule

`default_nettype wire
