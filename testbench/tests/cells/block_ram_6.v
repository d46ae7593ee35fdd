// Block RAMs of Spartan-6 as pins around block_ram.v.

`default_nettype none

// Spartan-6, 18 kbit. A port of width zero is not used.
module RAMB16BWER (
  input wire CLKA, input wire CLKB, input wire ENA, input wire ENB, input wire REGCEA, input wire REGCEB,
  input wire RSTA, input wire RSTB, input wire [13:0] ADDRA, input wire [13:0] ADDRB,
  input wire [31:0] DIA, input wire [31:0] DIB, input wire [3:0] DIPA, input wire [3:0] DIPB,
  input wire [3:0] WEA, input wire [3:0] WEB,
  output wire [31:0] DOA, output wire [31:0] DOB, output wire [3:0] DOPA, output wire [3:0] DOPB
);
  parameter DATA_WIDTH_A = 0, DATA_WIDTH_B = 0, DOA_REG = 0, DOB_REG = 0;
  parameter EN_RSTRAM_A = "TRUE", EN_RSTRAM_B = "TRUE", RSTTYPE = "SYNC", RST_PRIORITY_A = "CE", RST_PRIORITY_B = "CE";
  parameter WRITE_MODE_A = "WRITE_FIRST", WRITE_MODE_B = "WRITE_FIRST";
  parameter [35:0] INIT_A = 0, INIT_B = 0, SRVAL_A = 0, SRVAL_B = 0;
  parameter [255:0] INITP_00 = 0, INITP_01 = 0, INITP_02 = 0, INITP_03 = 0;
  parameter [255:0] INITP_04 = 0, INITP_05 = 0, INITP_06 = 0, INITP_07 = 0;
  parameter [255:0] INIT_00 = 0, INIT_01 = 0, INIT_02 = 0, INIT_03 = 0;
  parameter [255:0] INIT_04 = 0, INIT_05 = 0, INIT_06 = 0, INIT_07 = 0;
  parameter [255:0] INIT_08 = 0, INIT_09 = 0, INIT_0A = 0, INIT_0B = 0;
  parameter [255:0] INIT_0C = 0, INIT_0D = 0, INIT_0E = 0, INIT_0F = 0;
  parameter [255:0] INIT_10 = 0, INIT_11 = 0, INIT_12 = 0, INIT_13 = 0;
  parameter [255:0] INIT_14 = 0, INIT_15 = 0, INIT_16 = 0, INIT_17 = 0;
  parameter [255:0] INIT_18 = 0, INIT_19 = 0, INIT_1A = 0, INIT_1B = 0;
  parameter [255:0] INIT_1C = 0, INIT_1D = 0, INIT_1E = 0, INIT_1F = 0;
  parameter [255:0] INIT_20 = 0, INIT_21 = 0, INIT_22 = 0, INIT_23 = 0;
  parameter [255:0] INIT_24 = 0, INIT_25 = 0, INIT_26 = 0, INIT_27 = 0;
  parameter [255:0] INIT_28 = 0, INIT_29 = 0, INIT_2A = 0, INIT_2B = 0;
  parameter [255:0] INIT_2C = 0, INIT_2D = 0, INIT_2E = 0, INIT_2F = 0;
  parameter [255:0] INIT_30 = 0, INIT_31 = 0, INIT_32 = 0, INIT_33 = 0;
  parameter [255:0] INIT_34 = 0, INIT_35 = 0, INIT_36 = 0, INIT_37 = 0;
  parameter [255:0] INIT_38 = 0, INIT_39 = 0, INIT_3A = 0, INIT_3B = 0;
  parameter [255:0] INIT_3C = 0, INIT_3D = 0, INIT_3E = 0, INIT_3F = 0;
  localparam [16383:0] DATA = {
    INIT_3F, INIT_3E, INIT_3D, INIT_3C, INIT_3B, INIT_3A, INIT_39, INIT_38,
    INIT_37, INIT_36, INIT_35, INIT_34, INIT_33, INIT_32, INIT_31, INIT_30,
    INIT_2F, INIT_2E, INIT_2D, INIT_2C, INIT_2B, INIT_2A, INIT_29, INIT_28,
    INIT_27, INIT_26, INIT_25, INIT_24, INIT_23, INIT_22, INIT_21, INIT_20,
    INIT_1F, INIT_1E, INIT_1D, INIT_1C, INIT_1B, INIT_1A, INIT_19, INIT_18,
    INIT_17, INIT_16, INIT_15, INIT_14, INIT_13, INIT_12, INIT_11, INIT_10,
    INIT_0F, INIT_0E, INIT_0D, INIT_0C, INIT_0B, INIT_0A, INIT_09, INIT_08,
    INIT_07, INIT_06, INIT_05, INIT_04, INIT_03, INIT_02, INIT_01, INIT_00
  };
  localparam [2047:0] PARITY = {
    INITP_07, INITP_06, INITP_05, INITP_04, INITP_03, INITP_02, INITP_01, INITP_00
  };

  block_ram #(
    .BYTES(2048), .READ_A(DATA_WIDTH_A), .WRITE_A(DATA_WIDTH_A), .READ_B(DATA_WIDTH_B), .WRITE_B(DATA_WIDTH_B),
    .FITS(WRITE_MODE_A == "READ_FIRST" && WRITE_MODE_B == "READ_FIRST" && DOA_REG == 0 && DOB_REG == 0),
    .DATA(DATA), .PARITY(PARITY)
  ) words (
    .clock_a(CLKA), .enable_a(ENA), .write_a(WEA), .address_a({2'd0, ADDRA}),
    .data_in_a(DIA), .parity_in_a(DIPA), .data_a(DOA), .parity_a(DOPA),
    .clock_b(CLKB), .enable_b(ENB), .write_b(WEB), .address_b({2'd0, ADDRB}),
    .data_in_b(DIB), .parity_in_b(DIPB), .data_b(DOB), .parity_b(DOPB)
  );
endmodule

// Spartan-6, 9 kbit. In simple dual-port mode port A writes and port B reads both halves.
module RAMB8BWER (
  input wire CLKAWRCLK, input wire CLKBRDCLK, input wire ENAWREN, input wire ENBRDEN,
  input wire REGCEA, input wire REGCEBREGCE, input wire RSTA, input wire RSTBRST,
  input wire [12:0] ADDRAWRADDR, input wire [12:0] ADDRBRDADDR,
  input wire [15:0] DIADI, input wire [15:0] DIBDI, input wire [1:0] DIPADIP, input wire [1:0] DIPBDIP,
  input wire [1:0] WEAWEL, input wire [1:0] WEBWEU,
  output wire [15:0] DOADO, output wire [15:0] DOBDO, output wire [1:0] DOPADOP, output wire [1:0] DOPBDOP
);
  parameter RAM_MODE = "TDP";
  parameter DATA_WIDTH_A = 0, DATA_WIDTH_B = 0, DOA_REG = 0, DOB_REG = 0;
  parameter EN_RSTRAM_A = "TRUE", EN_RSTRAM_B = "TRUE", RSTTYPE = "SYNC", RST_PRIORITY_A = "CE", RST_PRIORITY_B = "CE";
  parameter WRITE_MODE_A = "WRITE_FIRST", WRITE_MODE_B = "WRITE_FIRST";
  parameter [17:0] INIT_A = 0, INIT_B = 0, SRVAL_A = 0, SRVAL_B = 0;
  parameter [255:0] INITP_00 = 0, INITP_01 = 0, INITP_02 = 0, INITP_03 = 0;
  parameter [255:0] INIT_00 = 0, INIT_01 = 0, INIT_02 = 0, INIT_03 = 0;
  parameter [255:0] INIT_04 = 0, INIT_05 = 0, INIT_06 = 0, INIT_07 = 0;
  parameter [255:0] INIT_08 = 0, INIT_09 = 0, INIT_0A = 0, INIT_0B = 0;
  parameter [255:0] INIT_0C = 0, INIT_0D = 0, INIT_0E = 0, INIT_0F = 0;
  parameter [255:0] INIT_10 = 0, INIT_11 = 0, INIT_12 = 0, INIT_13 = 0;
  parameter [255:0] INIT_14 = 0, INIT_15 = 0, INIT_16 = 0, INIT_17 = 0;
  parameter [255:0] INIT_18 = 0, INIT_19 = 0, INIT_1A = 0, INIT_1B = 0;
  parameter [255:0] INIT_1C = 0, INIT_1D = 0, INIT_1E = 0, INIT_1F = 0;
  localparam [8191:0] DATA = {
    INIT_1F, INIT_1E, INIT_1D, INIT_1C, INIT_1B, INIT_1A, INIT_19, INIT_18,
    INIT_17, INIT_16, INIT_15, INIT_14, INIT_13, INIT_12, INIT_11, INIT_10,
    INIT_0F, INIT_0E, INIT_0D, INIT_0C, INIT_0B, INIT_0A, INIT_09, INIT_08,
    INIT_07, INIT_06, INIT_05, INIT_04, INIT_03, INIT_02, INIT_01, INIT_00
  };
  localparam [1023:0] PARITY = {
    INITP_03, INITP_02, INITP_01, INITP_00
  };

  localparam SIMPLE = RAM_MODE == "SDP";
  wire [63:0] data_a, data_b;
  wire [7:0] parity_a, parity_b;

  block_ram #(
    .BYTES(1024), .READ_A(SIMPLE ? 0 : DATA_WIDTH_A), .WRITE_A(DATA_WIDTH_A), .READ_B(DATA_WIDTH_B),
    .WRITE_B(SIMPLE ? 0 : DATA_WIDTH_B),
    .FITS(WRITE_MODE_A == "READ_FIRST" && WRITE_MODE_B == "READ_FIRST" && DOA_REG == 0 && DOB_REG == 0),
    .DATA(DATA), .PARITY(PARITY)
  ) words (
    .clock_a(CLKAWRCLK), .enable_a(ENAWREN), .write_a(SIMPLE ? {WEBWEU, WEAWEL} : WEAWEL),
    .address_a({3'd0, ADDRAWRADDR}), .data_in_a(SIMPLE ? {DIBDI, DIADI} : DIADI),
    .parity_in_a(SIMPLE ? {DIPBDIP, DIPADIP} : DIPADIP), .data_a(data_a), .parity_a(parity_a),
    .clock_b(CLKBRDCLK), .enable_b(ENBRDEN), .write_b(SIMPLE ? 8'd0 : WEBWEU), .address_b({3'd0, ADDRBRDADDR}),
    .data_in_b(DIBDI), .parity_in_b(DIPBDIP), .data_b(data_b), .parity_b(parity_b)
  );

  assign DOADO = SIMPLE ? data_b : data_a;
  assign DOPADOP = SIMPLE ? parity_b : parity_a;
  assign DOBDO = SIMPLE ? data_b[31:16] : data_b;
  assign DOPBDOP = SIMPLE ? parity_b[3:2] : parity_b;
endmodule

`default_nettype wire
