// What the interpolants over a triangle promise, in closed form. After n plain and m carrying line steps from the first
// span start, with words f, p, s, t and second differences pp, ps, pt, ss, st, tt, the span start has the value
//   F(n,m) = f + n s + m t + C(n,2) ss + n m st + C(m,2) tt
// and the first difference along the span P(n,m) = p + n ps + m pt; k pixels further the value is
//   F + k P + C(k,2) pp                                                         modulo 2^W.
// Only steps are counted, in W + 1 bits, as binomials repeat. A plane has no second differences, a constant no steps.
`default_nettype none

module golden_over #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire write, input wire [3:0] word, input wire [W-1:0] data,
  input wire load, input wire step, input wire carry, input wire take, input wire run,
  output wire [W-N-1:0] value
);
  parameter WORDS = 10;
  // Words: 0 f, 1 p, 2 s, 3 t, 4 pp, 5 ps, 6 pt, 7 ss, 8 st, 9 tt. w of the next triangle, t of this one.
  reg [W-1:0] w0, w1, w2, w3, w4, w5, w6, w7, w8, w9;
  reg [W-1:0] f, p, s, t, pp, ps, pt, ss, st, tt;
  reg [W:0] n, m;
  // The span: its start value, difference and second difference, and the pixels since.
  reg [W-1:0] f0, p0, pp0;
  reg [W:0] k;

  localparam [W:0] ONE = 1;
  function [W-1:0] two(input [W:0] i);
    reg [W:0] product;
    begin
      product = i * (i - ONE);
      two = product[W:1];
    end
  endfunction

  wire [W-1:0] at_line = f + n * s + m * t + two(n) * ss + n * m * st + two(m) * tt;
  wire [W-1:0] along_line = p + n * ps + m * pt;
  wire [W-1:0] along_s = s + n * ss + m * st;
  wire [W-1:0] along_t = t + n * st + m * tt;
  wire [W-1:0] at_pixel = f0 + k * p0 + two(k) * pp0;
  wire [W-1:0] along_pixel = p0 + k * pp0;

  wire hears = write && word < WORDS;
  always @(posedge clock) begin
    if (hears) case (word)
      0: w0 <= data; 1: w1 <= data; 2: w2 <= data; 3: w3 <= data; 4: w4 <= data;
      5: w5 <= data; 6: w6 <= data; 7: w7 <= data; 8: w8 <= data; 9: w9 <= data;
    endcase
    if (load) begin
      {f, p, s, t, pp, ps, pt, ss, st, tt} <= {w0, w1, w2, w3, w4, w5, w6, w7, w8, w9};
      {n, m} <= 0;
    end else begin
      n <= n + (step && !carry);
      m <= m + (step && carry);
    end
    if (take) {f0, p0, pp0} <= {at_line, along_line, pp};
    k <= take ? 0 : k + run;
  end
  assign value = at_pixel[W-1:N];
endmodule

module golden_quadratic_2 #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire write, input wire [3:0] word, input wire [W-1:0] data,
  input wire load, input wire step, input wire carry, input wire take, input wire run,
  output wire [W-N-1:0] value
);
  golden_over #(W, N) p (clock, write, word, data, load, step, carry, take, run, value);
endmodule

module golden_linear_2 #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire write, input wire [3:0] word, input wire [W-1:0] data,
  input wire load, input wire step, input wire carry, input wire take, input wire run,
  output wire [W-N-1:0] value
);
  golden_over #(W, N) p (clock, write, word, data, load, step, carry, take, run, value);
  defparam p.WORDS = 4;
endmodule

module golden_constant_2 #(parameter W = 3, parameter N = 1) (
  input wire clock, input wire write, input wire [W-1:0] data, input wire load, input wire take,
  output wire [W-N-1:0] value
);
  golden_over #(W, N) p (clock, write, 4'd0, data, load, 1'b0, 1'b0, take, 1'b0, value);
  defparam p.WORDS = 1;
endmodule

`default_nettype wire
