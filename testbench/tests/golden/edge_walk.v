// What an edge walk promises: the column moves by the whole columns of a row, and by one more whenever the error term,
// which then falls by "down" instead of rising by "up", has reached zero.
`default_nettype none

module golden_edge_walk (
  input wire clock, input wire load, input wire step,
  input wire signed [11:0] first_column, input wire signed [19:0] first_error, input wire signed [11:0] whole,
  input wire signed [19:0] up, input wire signed [19:0] down,
  output wire signed [11:0] column, output wire carry
);
  integer at, e, slope, more, less;
  // Integers are wider than the registers; what counts is their low bits.
  wire [11:0] at_12 = at, slope_12 = slope;
  wire [19:0] e_20 = e, more_20 = more, less_20 = less;
  wire reached = $signed(e_20) >= 0;
  always @(posedge clock)
    if (load) begin
      at <= first_column; e <= first_error; slope <= whole; more <= up; less <= down;
    end else if (step) begin
      at <= reached ? at + slope + 1 : at + slope;
      e <= reached ? e + less : e + more;
    end
  assign column = at_12;
  assign carry = reached;
endmodule

`default_nettype wire
