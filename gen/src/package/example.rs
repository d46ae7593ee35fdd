//! An integration example: a module that draws one triangle or line with the core, from words in a table.

use super::timing::{cosines, material};
use crate::stimulus::{build, single_line, StimulusError, StimulusOptions, Triangle};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::lanes::LANE_PORTS;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{Point, Viewport, SUBPIXELS};
use std::fmt::Write;

/// A triangle over the upper left half of the frame, a colour at every knot.
fn triangle(order: Order, (width, height): (u32, u32)) -> Triangle {
    // Every row is a span of its own words there: a few rows will do.
    let size = match order {
        Order::Span(_) => (width.min(12), height.min(6)),
        _ => (width, height),
    };
    let point = |x: u32, y: u32| Point {
        x: (x * SUBPIXELS as u32) as i32,
        y: (y * SUBPIXELS as u32) as i32,
    };
    let mut knots = vec![
        [255.0, 32.0, 16.0],
        [16.0, 224.0, 48.0],
        [48.0, 64.0, 255.0],
    ];
    if order != Order::Linear {
        knots.extend([
            [200.0, 180.0, 40.0],
            [220.0, 90.0, 200.0],
            [40.0, 200.0, 220.0],
        ]);
    }
    if let Order::Span(_) = order {
        knots = crate::spans::sample([[0.3, 0.1, 1.0]; 3], [[40.0; 3], [180.0; 3], [0.0; 3]], 1.0);
    }
    Triangle {
        position: [point(0, 0), point(size.0, 0), point(0, size.1)],
        depth: [50_000.0, 30_000.0, 20_000.0],
        knots: cosines(order, knots),
        material: material(order),
        covering: None,
        relief: None,
        label: "example".to_owned(),
    }
}

/// The connections of further lanes, which the example leaves idle.
fn idle_lanes(core: &Core) -> String {
    let b = core.bus_bits();
    let ports = LANE_PORTS[..core.load_words - 1].iter();
    let idle = |[write, select, data]: &[&str; 3]| {
        format!("    .{write}(1'b0),\n    .{select}(8'd0),\n    .{data}({b}'d0),\n")
    };
    ports.map(idle).collect()
}

/// Text of `example/<top>_example.v`.
///
/// # Errors
/// When the triangle cannot be set up, which no valid frame causes.
pub fn example(
    core: &Core,
    size: (u32, u32),
    stamp: &str,
    reset: bool,
) -> Result<String, StimulusError> {
    let (width, height) = size;
    let viewport = Viewport { width, height };
    let stimulus = match core.order {
        Order::Line(filter) => single_line(filter, viewport, 1000)?,
        _ => {
            let one = [triangle(core.order, size)];
            build(core, &one, viewport, &StimulusOptions::default())?
        }
    };
    let (noun, memory, depth) = match core.order {
        Order::Line(_) => ("line", "frame memory", "weight"),
        _ => ("triangle", "depth memory", "depth"),
    };
    let span = matches!(core.order, Order::Span(_));
    let mut words: Vec<(bool, u8, u64)> =
        stimulus.frame.iter().map(|w| (false, w.0, w.1)).collect();
    for p in &stimulus.primitives {
        words.extend(p.writes.iter().map(|w| (false, w.0, w.1)));
        if let Some(last) = words.last_mut() {
            last.0 = true;
        }
    }
    let (top, b) = (format!("{}_core", core.module()), core.bus_bits());
    let digits = b.div_ceil(4);
    let count = words.len();
    // Spans begin with their own last words; a triangle begins with the last of all.
    let bits = match span || count > 63 {
        true => count.ilog2() as usize + 1,
        false => 6,
    };
    let begin = |start: bool| match (span, start) {
        (false, _) => "",
        (true, false) => "1'b0, ",
        (true, true) => "1'b1, ",
    };
    let start = if span {
        format!("word[{}]", b + 8)
    } else {
        format!("index == COUNT - {bits}'d1")
    };
    let per = if span { "of each span " } else { "" };
    let mut table = String::new();
    for (i, (start, select, data)) in words.iter().enumerate() {
        let begin = begin(*start);
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "      {bits}'d{i}: word = {{{begin}8'h{select:02x}, {b}'h{data:0digits$x}}};"
        );
    }
    Ok(format!(
        "// {top}_example: draws one {noun} with {top} whenever `go` is high and the core is idle.
//
// The words are a table here; a design computes them, as the core's guide says, or has a processor write them.
// The outputs are the write port of a frame buffer of {width} x {height} pixels that is never busy.
//
// {stamp}

`default_nettype none

module {top}_example (
  input  wire clock,                             // Clock.
  input  wire go,                                // Clears the {memory} and draws the {noun}.
  output wire idle,                              // A `go` would be taken.
  output wire done,                              // Pulses for one clock when the {noun} has been drawn.
  output wire frame_write,                       // A pixel is written.
  output wire [20:0] frame_address,              // Its place in the frame buffer.
  output wire [23:0] frame_colour,               // Its colour: red, green, blue.
  output wire [15:0] frame_depth                 // Its {depth}.
);

  localparam [{high}:0] COUNT = {bits}'d{count};

  reg [{high}:0] index = COUNT;                       // Word to write; COUNT when all are written.
  reg [{word_top}:0] word;                               // Its select code and its value.
  wire writing = index != COUNT;                 // A word is offered.
  wire begins = go && idle;                      // The triangle is begun.
  wire load_ready;                               // The core takes a word.
  wire busy;                                     // The core is at work.
  wire core_done;                                // It has become idle: drawn, or cleared before all words were written.
  wire [10:0] x;                                 // Column of the pixel.
  wire [10:0] y;                                 // Its row.

  assign idle = !busy && !writing;
  assign done = core_done && !writing;
  assign frame_address = {{10'd0, y}} * 21'd{width} + {{10'd0, x}};

  // The words of the {noun}, from Shadegate's set-up.
  always @* begin
    case (index)
{table}      default: word = {word_bits}'d0;
    endcase
  end

  // One word per clock; the last one {per}carries `start`. Words may be written in the clock of the clear already.
  always @(posedge clock) begin
    if (begins) index <= {bits}'d0;
    else if (writing && load_ready) index <= index + {bits}'d1;
  end

  {top} core (
    .clock(clock),
{reset_line}    .write(writing),
    .select(word[{top_bit}:{b}]),
    .data(word[{bus}:0]),
    .start(writing && {start}),
    .clear(begins),
    .ready(1'b1),
{lane_lines}    .load_ready(load_ready),
    .valid(frame_write),
    .x(x),
    .y(y),
    .red(frame_colour[23:16]),
    .green(frame_colour[15:8]),
    .blue(frame_colour[7:0]),
    .depth(frame_depth),
    .busy(busy),
    .done(core_done)
  );

endmodule

`default_nettype wire
",
        top_bit = b + 7,
        reset_line = if reset { "    .reset(1'b0),\n" } else { "" },
        lane_lines = idle_lanes(core),
        word_bits = b + 8 + usize::from(span),
        word_top = b + 7 + usize::from(span),
        high = bits - 1,
        bus = b - 1,
    ))
}
