//! The body of a UCF file, for ISE.

use crate::check::Checked;
use crate::emit::{line, period};
use crate::Pull;

pub(crate) fn write(out: &mut String, checked: &Checked) {
    let clock = checked.request.clock_port;
    line(out, "");
    line(out, "# Clock");
    line(out, format!("NET \"{clock}\" TNM_NET = \"{clock}\";"));
    line(
        out,
        format!(
            "TIMESPEC \"TS_{clock}\" = PERIOD \"{clock}\" {} ns HIGH 50%;",
            period(checked)
        ),
    );
    line(
        out,
        "# PERIOD covers the paths between flip-flops. Nothing is known of what is outside the pins,",
    );
    line(
        out,
        "# so no OFFSET IN or OFFSET OUT is given, and ISE leaves paths to and from pins unchecked.",
    );
    if !checked.placed.is_empty() {
        line(out, "");
        line(out, "# Pins");
    }
    for placed in &checked.placed {
        let resource = placed.resource;
        let mut net = format!(
            "NET \"{}\" LOC = \"{}\" | IOSTANDARD = {}",
            placed.name('<', '>'),
            resource.pin,
            resource.io
        );
        if let Some(drive) = resource.drive {
            net.push_str(&format!(" | DRIVE = {drive}"));
        }
        match resource.pull {
            Some(Pull::Up) => net.push_str(" | PULLUP"),
            Some(Pull::Down) => net.push_str(" | PULLDOWN"),
            None => {}
        }
        line(out, format!("{net}; # {}", resource.remark()));
    }
    let Some(board) = checked.request.board else {
        return;
    };
    if board.vccaux.is_none() && board.prohibit.is_empty() {
        return;
    }
    line(out, "");
    line(out, "# Board");
    if let Some(volts) = &board.vccaux {
        line(out, format!("CONFIG VCCAUX = \"{volts}\";"));
    }
    for pin in &board.prohibit {
        line(out, format!("CONFIG PROHIBIT = \"{pin}\";"));
    }
}
