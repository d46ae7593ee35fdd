// What a z-buffer promises: four depths; a fragment is visible if it is nearer (larger) than the depth at its place when
// its turn comes, and then becomes that depth. Here the comparison is made with the memory as it is in that very clock,
// so there is no read ahead and no forwarding. While the memory is swept, every clock writes a zero.
`default_nettype none

module golden_z_buffer (
  input wire clock, input wire go, input wire clear, input wire fragment,
  input wire [1:0] address, input wire [15:0] depth,
  output wire pass, output wire waiting, output wire [15:0] waiting_depth, output wire clearing
);
  reg [15:0] d0, d1, d2, d3;
  reg here;
  reg [1:0] place, sweep;
  reg [15:0] mine;
  reg sweeping;
  wire [15:0] there = place == 0 ? d0 : place == 1 ? d1 : place == 2 ? d2 : d3;
  assign pass = here && mine > there;
  assign waiting = here;
  assign waiting_depth = mine;
  assign clearing = sweeping;
  wire writes = sweeping || (pass && go);
  wire [1:0] to = sweeping ? sweep : place;
  wire [15:0] what = sweeping ? 16'd0 : mine;
  always @(posedge clock) begin
    if (writes && to == 0) d0 <= what;
    if (writes && to == 1) d1 <= what;
    if (writes && to == 2) d2 <= what;
    if (writes && to == 3) d3 <= what;
    if (go) {here, place, mine} <= {fragment, address, depth};
    if (sweeping) begin
      sweeping <= sweep != 3;
      sweep <= sweep + 1;
    end else if (clear) begin
      sweeping <= 1;
      sweep <= 0;
    end
  end
endmodule

`default_nettype wire
