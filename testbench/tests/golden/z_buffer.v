// What a z-buffer promises, for four words of it: a fragment is visible if it is nearer (larger) than the depth at its
// place when its turn comes, two moves of the pipeline after it arrived, and then becomes that depth. A clear makes all
// depths zero between two clocks. There are no pages here, no reading ahead and no forwarding.
`default_nettype none

module golden_z_buffer (
  input wire clock, input wire go, input wire clear, input wire fragment, input wire [1:0] place, input wire [15:0] depth,
  output wire pass, output wire waiting, output wire [15:0] tested_depth
);
  reg [15:0] d0, d1, d2, d3;
  reg here1, here2;
  reg [1:0] place1, place2;
  reg [15:0] mine1, mine2;
  wire [15:0] there = place2 == 0 ? d0 : place2 == 1 ? d1 : place2 == 2 ? d2 : d3;
  assign pass = here2 && mine2 > there;
  assign waiting = here1 || here2;
  assign tested_depth = mine2;
  always @(posedge clock) begin
    if (go) begin
      {here1, place1, mine1} <= {fragment, place, depth};
      {here2, place2, mine2} <= {here1, place1, mine1};
      if (pass && place2 == 0) d0 <= mine2;
      if (pass && place2 == 1) d1 <= mine2;
      if (pass && place2 == 2) d2 <= mine2;
      if (pass && place2 == 3) d3 <= mine2;
    end
    if (clear) {d0, d1, d2, d3} <= 64'd0;
  end
endmodule

// Both, for a host that keeps the rules: it clears while nothing comes and nothing waits, and sends nothing while the
// unit says that it is clearing. Of two pages two words each; depths of two bits.
module pair (
  input wire clock, input wire go, input wire clear, input wire fragment, input wire [1:0] place, input wire [1:0] depth
);
  wire unit_pass, unit_waiting, unit_clearing, unit_cleared, golden_pass, golden_waiting;
  wire [15:0] unit_depth, golden_depth;
  wire comes = fragment && !unit_clearing;
  wire clears = clear && !fragment && !unit_clearing && !golden_waiting;
  z_buffer unit (
    .clock(clock), .go(go), .clear(clears), .fragment(comes), .address({place[1], 2'b00, place[0]}),
    .depth({14'd0, depth}), .pass(unit_pass), .waiting(unit_waiting), .tested_depth(unit_depth),
    .clearing(unit_clearing), .cleared(unit_cleared)
  );
  golden_z_buffer golden (
    .clock(clock), .go(go), .clear(clears), .fragment(comes), .place(place), .depth({14'd0, depth}),
    .pass(golden_pass), .waiting(golden_waiting), .tested_depth(golden_depth)
  );
endmodule

`default_nettype wire
