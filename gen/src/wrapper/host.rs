//! The part of a wrapper that no bus shows in: addresses to register writes, control and status.

use super::Context;

/// Text of `<core>_host.v`.
pub fn module(c: &Context) -> String {
    let top = &c.top;
    let (b, high) = (c.bus_bits, c.high_bits());
    let header = c.header(
        &format!("{top}_host"),
        "register access of a bus, whichever it is.",
        &[
            ("Map", "0x000 words, by select code; 0x400 high part; 0x404 control; 0x408 status."),
            ("Source", "The register map of the core; see README.md."),
            ("Latency", "A write is done in the clock in which the core takes it; a request waits until then."),
        ],
    );
    let (declare_high, keep_high, read_high, data) = if high == 0 {
        (
            String::new(),
            String::new(),
            "32'd0".to_owned(),
            "write_data".to_owned(),
        )
    } else {
        (
            format!("  reg [{}:0] high = {high}'d0;                         // Upper bits of the words to come.\n", high - 1),
            format!(
                "\n  always @(posedge clock) begin\n    if (reset) high <= {high}'d0;\n    else if (write_done && is_high && !write_error) high <= write_data[{}:0];\n  end\n",
                high - 1
            ),
            format!("{{{}'d0, high}}", 32 - high),
            "{high, write_data}".to_owned(),
        )
    };
    // Without a high part nothing here is clocked; the ports go, so that no signal is without a reader.
    let clocked = if high == 0 {
        ""
    } else {
        "  input  wire clock,                             // Clock.\n  input  wire reset,                             // Clears the high part.\n"
    };
    let is_high =
        "  wire is_high = write_address == 9'h100;        // The high part is addressed.\n";
    format!(
        "{header}module {top}_host (
{clocked}  input  wire write_request,                     // A bus write is offered; held until `write_done`.
  input  wire [10:2] write_address,              // Its address.
  input  wire [31:0] write_data,                 // Its data.
  input  wire write_whole,                       // It is aligned and has all four bytes.
  output wire write_done,                        // It is done at the next edge.
  output wire write_error,                       // It is refused: not whole, or nothing to write there.
  input  wire [10:2] read_address,               // Address to read.
  output wire [31:0] read_data,                  // What stands there; 0 where nothing can be read.
  output wire read_error,                        // Nothing can be read there.
  output wire write,                             // To the core: register write.
  output wire [7:0] select,                      // To the core: channel mask and word number.
  output wire [{bus}:0] data,                       // To the core: register bus.
  output wire start,                             // To the core: the words are complete.
  output wire clear,                             // To the core: clear the depth memory.
  input  wire load_ready,                        // From the core: words may be written.
  input  wire busy,                              // From the core: not idle.
  output wire end_frame,                         // What has been started is the rest of the frame.
  input  wire ending                             // The end of a frame has not left yet.
);

  wire is_word = !write_address[10];             // A register word is addressed.
{is_high}  wire is_control = write_address == 9'h101;     // The control register is addressed.
  wire may_start = load_ready && !ending;        // A start would be taken.
  wire may_clear = !busy && !ending;             // A clear would be taken.
  wire may_control;                              // Every bit that is set would be taken.
  wire may_write;                                // The write can be done now.
  wire control;                                  // The control register is written.
{declare_high}
  assign may_control = (!write_data[0] || may_start) && (!write_data[1] || may_clear) && (!write_data[2] || !ending);
  assign may_write = is_word ? load_ready : (!is_control || may_control);
  assign write_error = !write_whole || !(is_word || is_high || is_control);
  assign write_done = write_request && (write_error || may_write);
  assign write = write_done && !write_error && is_word;
  assign control = write_done && !write_error && is_control;
  assign select = write_address[9:2];
  assign data = {data};
  assign start = control && write_data[0];
  assign clear = control && write_data[1];
  assign end_frame = control && write_data[2];
  assign read_error = !(read_address == 9'h100 || read_address == 9'h102);
  assign read_data = (read_address == 9'h102) ? {{29'd0, ending, busy, load_ready}}
                   : (read_address == 9'h100) ? {read_high} : 32'd0;
{keep_high}
endmodule

`default_nettype wire
",
        bus = b - 1,
    )
}
