//! The body of a PCF file, for nextpnr-ice40.

use crate::check::Checked;
use crate::emit::{line, megahertz};
use crate::Pull;

pub(crate) fn write(out: &mut String, checked: &Checked) {
    line(out, "");
    line(out, "# Clock, in MHz");
    line(
        out,
        format!(
            "set_frequency {} {}",
            checked.request.clock_port,
            megahertz(checked)
        ),
    );
    if !checked.placed.is_empty() {
        line(out, "");
        line(out, "# Pins");
    }
    for placed in &checked.placed {
        let resource = placed.resource;
        // The only pull resistor an iCE40 has is one to the supply.
        let pull = match resource.pull {
            Some(Pull::Up) => " -pullup yes",
            Some(Pull::Down) | None => "",
        };
        let name = placed.name('[', ']');
        line(
            out,
            format!(
                "set_io{pull} {name} {} # {}",
                resource.pin,
                resource.remark()
            ),
        );
    }
}
