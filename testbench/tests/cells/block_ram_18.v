// block_ram_18: a block RAM of Spartan-7 (RAMB18E1) as depth memory and power table use it, for simulation of netlists.
//
// Depth memory, 1024 words of 18 bits: port A writes bytes with their parity bit, port B reads what stood there before
// the edge. Power table, 512 words of 36 bits (SDP): port B writes bytes with their parity bit, port A reads.
// It powers up as zeros. Any other use shows as unknown outputs.

`default_nettype none

module block_ram_18 (
  input wire CLKARDCLK,
  input wire CLKBWRCLK,
  input wire ENARDEN,
  input wire ENBWREN,
  input wire REGCEAREGCE,
  input wire REGCEB,
  input wire RSTRAMARSTRAM,
  input wire RSTRAMB,
  input wire RSTREGARSTREG,
  input wire RSTREGB,
  input wire [13:0] ADDRARDADDR,
  input wire [13:0] ADDRBWRADDR,
  input wire [15:0] DIADI,
  input wire [15:0] DIBDI,
  input wire [1:0] DIPADIP,
  input wire [1:0] DIPBDIP,
  input wire [1:0] WEA,
  input wire [3:0] WEBWE,
  output wire [15:0] DOADO,
  output wire [1:0] DOPADOP,
  output wire [15:0] DOBDO,
  output wire [1:0] DOPBDOP
);
  parameter RAM_MODE = "TDP";
  parameter READ_WIDTH_A = 0;
  parameter READ_WIDTH_B = 0;
  parameter WRITE_WIDTH_A = 0;
  parameter WRITE_WIDTH_B = 0;
  parameter WRITE_MODE_A = "WRITE_FIRST";
  parameter WRITE_MODE_B = "WRITE_FIRST";
  parameter DOA_REG = 0;
  parameter DOB_REG = 0;

  localparam FITS = RAM_MODE == "TDP" && READ_WIDTH_B == 18 && WRITE_WIDTH_A == 18 && WRITE_WIDTH_B == 0
                    && WRITE_MODE_A == "READ_FIRST" && DOB_REG == 0;

  localparam WIDE = RAM_MODE == "SDP" && READ_WIDTH_A == 36 && WRITE_WIDTH_B == 36 && WRITE_WIDTH_A == 0
                    && READ_WIDTH_B == 0 && WRITE_MODE_B == "READ_FIRST" && DOA_REG == 0;

  reg [17:0] words [0:1023];
  reg [35:0] wide_words [0:511];
  reg [35:0] wide_shown;
  wire [8:0] wide_address = ADDRBWRADDR[13:5];
  reg [17:0] shown;
  integer i;

  initial begin
    for (i = 0; i < 1024; i = i + 1) words[i] = 18'd0;
    shown = FITS ? 18'd0 : 18'bx;
    for (i = 0; i < 512; i = i + 1) wide_words[i] = 36'd0;
    wide_shown = WIDE ? 36'd0 : 36'bx;
  end

  always @(posedge CLKARDCLK) if (ENARDEN) begin
    if (WEA[0]) {words[ADDRARDADDR[13:4]][16], words[ADDRARDADDR[13:4]][7:0]} <= {DIPADIP[0], DIADI[7:0]};
    if (WEA[1]) {words[ADDRARDADDR[13:4]][17], words[ADDRARDADDR[13:4]][15:8]} <= {DIPADIP[1], DIADI[15:8]};
  end

  always @(posedge CLKBWRCLK) if (ENBWREN) shown <= FITS && WEBWE === 4'd0 ? words[ADDRBWRADDR[13:4]] : 18'bx;

  always @(posedge CLKBWRCLK) if (WIDE && ENBWREN) begin
    if (WEBWE[0]) {wide_words[wide_address][16], wide_words[wide_address][7:0]} <= {DIPADIP[0], DIADI[7:0]};
    if (WEBWE[1]) {wide_words[wide_address][17], wide_words[wide_address][15:8]} <= {DIPADIP[1], DIADI[15:8]};
    if (WEBWE[2]) {wide_words[wide_address][34], wide_words[wide_address][25:18]} <= {DIPBDIP[0], DIBDI[7:0]};
    if (WEBWE[3]) {wide_words[wide_address][35], wide_words[wide_address][33:26]} <= {DIPBDIP[1], DIBDI[15:8]};
  end

  always @(posedge CLKARDCLK) if (WIDE && ENARDEN) wide_shown <= wide_words[ADDRARDADDR[13:5]];

  assign {DOPBDOP, DOBDO} = WIDE ? wide_shown[35:18] : shown;
  assign {DOPADOP, DOADO} = WIDE ? wide_shown[17:0] : 18'bx;
endmodule

`default_nettype wire
