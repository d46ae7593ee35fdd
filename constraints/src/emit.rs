//! Writes a constraint file: the comment at its head here, the rest in the format's own module.

use crate::check::{check, Checked};
use crate::{lpf, pcf, ucf, xdc, ConstraintError, Format, Request};

/// A file to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConstraintFile {
    /// File name: the design's, with the format's extension.
    pub name: String,
    /// Contents, ending in a line feed.
    pub text: String,
}

/// Writes the constraint file that `request.device`'s vendor tool reads.
///
/// The text depends on the request alone: the same request gives the same bytes.
pub fn emit(request: &Request) -> Result<ConstraintFile, ConstraintError> {
    let checked = check(request)?;
    let format = request.device.constraints;
    let mut text = header(&checked, format);
    match format {
        Format::Ucf => ucf::write(&mut text, &checked),
        Format::Xdc => xdc::write(&mut text, &checked),
        Format::Pcf => pcf::write(&mut text, &checked),
        Format::Lpf => lpf::write(&mut text, &checked),
    }
    Ok(ConstraintFile {
        name: format!("{}.{}", request.design, format.extension()),
        text,
    })
}

/// The clock period in nanoseconds with three decimals.
pub(crate) fn period(checked: &Checked) -> String {
    format!(
        "{}.{:03}",
        checked.period_ps / 1000,
        checked.period_ps % 1000
    )
}

/// The clock frequency in megahertz with three decimals, rounded up: the file never asks for less than the caller.
pub(crate) fn megahertz(checked: &Checked) -> String {
    // The millionth of a kilohertz undoes the binary rounding of periods such as 1000/12 ns.
    let kilohertz = (1e6 / checked.request.period_ns - 1e-6).ceil();
    format!("{:.3}", kilohertz / 1000.0)
}

/// Adds one line.
pub(crate) fn line(text: &mut String, content: impl AsRef<str>) {
    text.push_str(content.as_ref());
    text.push('\n');
}

fn header(checked: &Checked, format: Format) -> String {
    let request = checked.request;
    let device = request.device;
    let mut text = String::new();
    let out = &mut text;
    line(
        out,
        format!(
            "# {format} constraints of {}, for {}. Written by Shadegate.",
            request.design, device.vendor_tool
        ),
    );
    let (package, speed) = request
        .board
        .map_or((&device.package, device.speed), |b| (&b.package, b.speed));
    let part = device.part_in(package, speed);
    line(out, format!("# Device: {part} ({})", device.family));
    match request.board {
        Some(board) => {
            line(out, format!("# Board:  {} by {}", board.title, board.maker));
            line(out, format!("# Pins:   {}", board.source));
        }
        None => line(out, "# Board:  none given, so no pin is known"),
    }
    line(out, "#");
    left_over(out, checked, format);
    text
}

/// Says which ports have no pin, why, and what to do about it.
fn left_over(out: &mut String, checked: &Checked, format: Format) {
    let left: u64 = checked.unplaced.iter().map(|u| u64::from(u.bits)).sum();
    if left == 0 {
        line(out, "# Every port has its pin below.");
        return;
    }
    let why = if checked.request.board.is_some() {
        "nothing on the board is bound to them"
    } else {
        "there is no board"
    };
    line(out, format!("# Left for you to place, as {why}:"));
    let longest = checked.unplaced.iter().map(|u| u.port.name.len()).max();
    let column = longest.unwrap_or(0);
    for unplaced in &checked.unplaced {
        let port = unplaced.port;
        let bits = match (unplaced.bits, port.width) {
            (1, 1) => "1 bit".to_owned(),
            (bits, width) if bits == width => format!("{bits} bits"),
            (bits, width) => format!("{bits} of {width} bits"),
        };
        line(
            out,
            format!("#   {:column$}  {}, {bits}", port.name, port.direction),
        );
    }
    let clock = checked.request.clock_port;
    if checked.request.board.is_some() && checked.unplaced.iter().any(|u| u.port.name == clock) {
        line(out, "# The clock is among them: it needs a board clock that is not faster than the period below,");
        line(out, "# or one made from a board clock inside the device.");
    }
    if let Some(package) = checked.package {
        let used = checked.placed.len() as u64;
        let free = u64::from(package.user_io).saturating_sub(used);
        if left > free {
            line(
                out,
                format!("# These are {left} bits, and the package has {free} free user pins: wire the core into"),
            );
            line(
                out,
                "# a top level of your own and constrain that one's ports.",
            );
        }
    }
    line(
        out,
        match format {
            Format::Ucf => "# ISE places such ports itself, on pins of its own choice, until they get a LOC.",
            Format::Xdc => "# Vivado writes no bitstream until each of them has a PACKAGE_PIN and an IOSTANDARD.",
            Format::Pcf => "# nextpnr stops at a port without a pin, unless told --pcf-allow-unconstrained.",
            Format::Lpf => "# nextpnr stops at a port without a pin, unless told --lpf-allow-unconstrained.",
        },
    );
}
