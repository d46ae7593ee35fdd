# XDC constraints of gouraud, for Vivado. Written by Shadegate.
# Device: xc7s15csga225-1 (spartan-7)
# Board:  none given, so no pin is known
#
# Left for you to place, as there is no board:
#   clock  input, 1 bit
#   reset  input, 1 bit
#   start  input, 1 bit
#   busy   output, 1 bit
#   done   output, 1 bit
#   pixel  output, 24 bits
#   flags  output, 4 bits
#   setup  input, 128 bits
# These are 161 bits, and the package has 100 free user pins: wire the core into
# a top level of your own and constrain that one's ports.
# Vivado writes no bitstream until each of them has a PACKAGE_PIN and an IOSTANDARD.

# Clock
create_clock -name clock -period 6.666 [get_ports {clock}]

# Timing at the pins
# Nothing is known of what the other ports meet: add set_input_delay and set_output_delay.
