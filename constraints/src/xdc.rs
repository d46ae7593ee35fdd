//! The body of an XDC file, for Vivado.

use crate::check::Checked;
use crate::emit::{line, period};
use crate::{Pull, ResourceKind};

pub(crate) fn write(out: &mut String, checked: &Checked) {
    let clock = checked.request.clock_port;
    line(out, "");
    line(out, "# Clock");
    line(
        out,
        format!(
            "create_clock -name {clock} -period {} [get_ports {{{clock}}}]",
            period(checked)
        ),
    );
    if !checked.placed.is_empty() {
        line(out, "");
        line(out, "# Pins");
    }
    for placed in &checked.placed {
        let resource = placed.resource;
        let mut settings = format!("PACKAGE_PIN {} IOSTANDARD {}", resource.pin, resource.io);
        if let Some(drive) = resource.drive {
            settings.push_str(&format!(" DRIVE {drive}"));
        }
        match resource.pull {
            Some(Pull::Up) => settings.push_str(" PULLTYPE PULLUP"),
            Some(Pull::Down) => settings.push_str(" PULLTYPE PULLDOWN"),
            None => {}
        }
        let port = placed.name('[', ']');
        let remark = resource.remark();
        line(
            out,
            format!("set_property -dict {{{settings}}} [get_ports {{{port}}}]; # {remark}"),
        );
    }
    timing(out, checked);
    board(out, checked);
}

/// Paths to and from what a person sees or presses are not timed; nothing is said of the rest.
fn timing(out: &mut String, checked: &Checked) {
    line(out, "");
    line(out, "# Timing at the pins");
    for placed in &checked.placed {
        let port = placed.name('[', ']');
        let kind = placed.resource.kind;
        if kind == ResourceKind::Clock {
            continue;
        }
        let end = if kind.drives_fpga() { "-from" } else { "-to" };
        line(out, format!("set_false_path {end} [get_ports {{{port}}}]"));
    }
    let mut others = checked.unplaced.iter();
    line(
        out,
        if others.any(|u| u.port.name != checked.request.clock_port) {
            "# Nothing is known of what the other ports meet: add set_input_delay and set_output_delay."
        } else {
            "# No other port needs set_input_delay or set_output_delay."
        },
    );
}

fn board(out: &mut String, checked: &Checked) {
    let Some(board) = checked.request.board else {
        return;
    };
    if board.config_voltage.is_none() && board.internal_vref.is_empty() {
        return;
    }
    line(out, "");
    line(out, "# Board");
    if let Some(volts) = &board.config_voltage {
        line(out, "set_property CFGBVS VCCO [current_design]");
        line(
            out,
            format!("set_property CONFIG_VOLTAGE {volts} [current_design]"),
        );
    }
    for vref in &board.internal_vref {
        line(
            out,
            format!(
                "set_property INTERNAL_VREF {} [get_iobanks {}]",
                vref.volts, vref.bank
            ),
        );
    }
}
