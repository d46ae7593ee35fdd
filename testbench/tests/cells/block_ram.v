// Block RAMs of Spartan-6 and Spartan-7 for the simulation of netlists; Yosys has no behaviour for them.
//
// One array of bytes with their parity bits, two ports. A port of 9, 18, 36 or 72 bits reads what stood there before the
// edge (READ_FIRST) and writes the bytes that are enabled. A memory of another mode may be read by port A and written by
// port B, but what is read while it is written is unknown; one that is never written reads the same in every mode. Bits
// without a code at power-up are zeros. Any other use shows as unknown outputs.

`default_nettype none

module block_ram (
  input wire clock_a, input wire enable_a, input wire [7:0] write_a, input wire [15:0] address_a,
  input wire [63:0] data_in_a, input wire [7:0] parity_in_a,
  output reg [63:0] data_a, output reg [7:0] parity_a,
  input wire clock_b, input wire enable_b, input wire [7:0] write_b, input wire [15:0] address_b,
  input wire [63:0] data_in_b, input wire [7:0] parity_in_b,
  output reg [63:0] data_b, output reg [7:0] parity_b
);
  parameter BYTES = 2048;              // without parity
  parameter READ_A = 0, WRITE_A = 0;   // bits of a port with parity, 0 if it is not used
  parameter READ_B = 0, WRITE_B = 0;
  parameter FITS = 1;                  // the modes are those described above
  parameter APART = 0;                 // not READ_FIRST: a word must not be read while it is written
  parameter [8*BYTES-1:0] DATA = 0;
  parameter [BYTES-1:0] PARITY = 0;

  reg [8:0] words [0:BYTES-1];
  reg [255:0] row;
  reg [31:0] row_parity;
  reg [8:0] word;
  integer i, a, b;

  // Bytes of a port, or 0 for what is not described here.
  function integer bytes(input integer bits);
    bytes = bits == 9 ? 1 : bits == 18 ? 2 : bits == 36 ? 4 : bits == 72 ? 8 : 0;
  endfunction

  initial begin
    // Row by row: a simulator copies a parameter whenever it takes a part of it.
    for (i = 0; i < BYTES; i = i + 32) begin
      row = DATA[8*i +: 256];
      row_parity = PARITY[i +: 32];
      for (b = 0; b < 32; b = b + 1) begin
        for (a = 0; a < 8; a = a + 1) word[a] = row[8*b+a] === 1'b1;
        word[8] = row_parity[b] === 1'b1;
        words[i+b] = word;
      end
    end
    data_a = FITS ? 64'd0 : 64'bx;
    data_b = FITS ? 64'd0 : 64'bx;
    parity_a = FITS ? 8'd0 : 8'bx;
    parity_b = FITS ? 8'd0 : 8'bx;
  end

  // The first byte of a port: addresses count bits.
  wire [15:0] first_a = address_a[15:3] & ~(bytes(READ_A ? READ_A : WRITE_A) - 1) & (BYTES - 1);
  wire [15:0] first_b = address_b[15:3] & ~(bytes(READ_B ? READ_B : WRITE_B) - 1) & (BYTES - 1);

  // Where port B writes, and whether port A reads there.
  wire [15:0] written = address_b[15:3] & ~(bytes(WRITE_B) - 1) & (BYTES - 1);
  wire meet = APART && enable_b && write_b != 0 && first_a < written + bytes(WRITE_B) && written < first_a + bytes(READ_A);

  always @(posedge clock_a) if (FITS && enable_a) begin
    for (a = 0; a < bytes(READ_A); a = a + 1) begin
      data_a[8*a +: 8] <= meet ? 8'bx : words[first_a + a][7:0];
      parity_a[a] <= meet ? 1'bx : words[first_a + a][8];
    end
    for (a = 0; a < bytes(WRITE_A); a = a + 1)
      if (write_a[a]) words[first_a + a] <= {parity_in_a[a], data_in_a[8*a +: 8]};
  end

  always @(posedge clock_b) if (FITS && enable_b) begin
    for (b = 0; b < bytes(READ_B); b = b + 1) begin
      data_b[8*b +: 8] <= words[first_b + b][7:0];
      parity_b[b] <= words[first_b + b][8];
    end
    for (b = 0; b < bytes(WRITE_B); b = b + 1)
      if (write_b[b]) words[first_b + b] <= {parity_in_b[b], data_in_b[8*b +: 8]};
  end
endmodule

`default_nettype wire
