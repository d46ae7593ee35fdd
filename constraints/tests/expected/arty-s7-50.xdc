# XDC constraints of quadratic, for Vivado. Written by Shadegate.
# Device: xc7s50csga324-1 (spartan-7)
# Board:  Arty S7-50 by Digilent
# Pins:   Digilent, Arty-S7-50-Rev-E-Master.xdc and Arty-S7-50-Master.xdc (digilent-xdc)
#
# Left for you to place, as nothing on the board is bound to them:
#   start  input, 1 bit
#   pixel  output, 24 bits
#   flags  output, 2 of 4 bits
# Vivado writes no bitstream until each of them has a PACKAGE_PIN and an IOSTANDARD.

# Clock
create_clock -name clock -period 10.000 [get_ports {clock}]

# Pins
set_property -dict {PACKAGE_PIN R2 IOSTANDARD SSTL135} [get_ports {clock}]; # clk100: clock, 100 MHz
set_property -dict {PACKAGE_PIN H13 IOSTANDARD LVCMOS33} [get_ports {reset}]; # btn3: button
set_property -dict {PACKAGE_PIN E18 IOSTANDARD LVCMOS33} [get_ports {busy}]; # led0: LED
set_property -dict {PACKAGE_PIN F13 IOSTANDARD LVCMOS33} [get_ports {done}]; # led1: LED
set_property -dict {PACKAGE_PIN E13 IOSTANDARD LVCMOS33} [get_ports {flags[0]}]; # led2: LED
set_property -dict {PACKAGE_PIN H15 IOSTANDARD LVCMOS33} [get_ports {flags[3]}]; # led3: LED

# Timing at the pins
set_false_path -from [get_ports {reset}]
set_false_path -to [get_ports {busy}]
set_false_path -to [get_ports {done}]
set_false_path -to [get_ports {flags[0]}]
set_false_path -to [get_ports {flags[3]}]
# Nothing is known of what the other ports meet: add set_input_delay and set_output_delay.

# Board
set_property CFGBVS VCCO [current_design]
set_property CONFIG_VOLTAGE 3.3 [current_design]
set_property INTERNAL_VREF 0.675 [get_iobanks 34]
