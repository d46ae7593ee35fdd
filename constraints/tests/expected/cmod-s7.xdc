# XDC constraints of quadratic, for Vivado. Written by Shadegate.
# Device: xc7s25csga225-1 (spartan-7)
# Board:  Cmod S7-25 by Digilent
# Pins:   Digilent, Cmod-S7-25-Master.xdc (digilent-xdc); button level from its Vivado board file
#
# Every port has its pin below.

# Clock
create_clock -name clock -period 50.000 [get_ports {clock}]

# Pins
set_property -dict {PACKAGE_PIN M9 IOSTANDARD LVCMOS33} [get_ports {clock}]; # clk12: clock, 12 MHz
set_property -dict {PACKAGE_PIN E2 IOSTANDARD LVCMOS33} [get_ports {busy}]; # led0: LED
set_property -dict {PACKAGE_PIN K1 IOSTANDARD LVCMOS33} [get_ports {done}]; # led1: LED

# Timing at the pins
set_false_path -to [get_ports {busy}]
set_false_path -to [get_ports {done}]
# No other port needs set_input_delay or set_output_delay.
