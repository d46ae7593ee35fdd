// What the interpolants along a span promise, in closed form: k steps after a load with the words c, d, dd, ddd
//   f(k)   = c + d C(k,1) + dd C(k,2) + ddd C(k,3)      (Newton)
// modulo 2^W. Nothing is accumulated but the number of steps. C(k,2) and C(k,3) repeat modulo 2^W every 2^(W+1) steps,
// so W + 1 bits of k are enough (W is at most 8). The differences of the polynomial are shown beside its value.
`default_nettype none

module golden_along #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire load, input wire run,
  input wire [W-1:0] c, input wire [W-1:0] d, input wire [W-1:0] dd, input wire [W-1:0] ddd,
  output wire [W-N-1:0] value
);
  reg [W-1:0] c0, d0, dd0, ddd0;
  reg [W:0] k;
  always @(posedge clock) begin
    if (load) {c0, d0, dd0, ddd0} <= {c, d, dd, ddd};
    k <= load ? 0 : k + run;
  end
  // k (k - 1) is even; what is divisible by 3 is divided by multiplying with the inverse of 3 modulo 256, 171.
  localparam [W:0] ONE = 1, TWO = 2;
  localparam [W-1:0] THIRD = 171;
  wire [W:0] product = k * (k - ONE);
  wire [W-1:0] k2 = product[W:1];
  wire [W-1:0] k3 = k2 * (k - TWO) * THIRD;
  wire [W-1:0] f = c0 + d0 * k + dd0 * k2 + ddd0 * k3;
  wire [W-1:0] df = d0 + dd0 * k + ddd0 * k2;
  wire [W-1:0] ddf = dd0 + ddd0 * k;
  assign value = f[W-1:N];
endmodule

module golden_constant_1 #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire load, input wire [W-1:0] start, output wire [W-N-1:0] value
);
  golden_along #(W, N) p (clock, load, 1'b0, start, {W{1'b0}}, {W{1'b0}}, {W{1'b0}}, value);
endmodule

module golden_linear_1 #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire load, input wire run,
  input wire [W-1:0] start, input wire [W-1:0] step, output wire [W-N-1:0] value
);
  golden_along #(W, N) p (clock, load, run, start, step, {W{1'b0}}, {W{1'b0}}, value);
endmodule

module golden_quadratic_1 #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire load, input wire run,
  input wire [W-1:0] start, input wire [W-1:0] step, input wire [W-1:0] bend, output wire [W-N-1:0] value
);
  golden_along #(W, N) p (clock, load, run, start, step, bend, {W{1'b0}}, value);
endmodule

module golden_cubic_1 #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire load, input wire run,
  input wire [W-1:0] start, input wire [W-1:0] step, input wire [W-1:0] bend, input wire [W-1:0] twist,
  output wire [W-N-1:0] value
);
  golden_along #(W, N) p (clock, load, run, start, step, bend, twist, value);
endmodule

`default_nettype wire
