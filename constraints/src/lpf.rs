//! The body of an LPF file, for nextpnr-ecp5 and Diamond.

use crate::check::Checked;
use crate::emit::{line, megahertz};
use crate::Pull;

pub(crate) fn write(out: &mut String, checked: &Checked) {
    line(out, "");
    line(out, "# Clock");
    line(
        out,
        format!(
            "FREQUENCY PORT \"{}\" {} MHZ;",
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
        let name = placed.name('[', ']');
        line(out, format!("# {}", resource.remark()));
        line(
            out,
            format!("LOCATE COMP \"{name}\" SITE \"{}\";", resource.pin),
        );
        let pull = match resource.pull {
            Some(Pull::Up) => "UP",
            Some(Pull::Down) => "DOWN",
            None => "NONE",
        };
        let mut buffer = format!(
            "IOBUF PORT \"{name}\" IO_TYPE={} PULLMODE={pull}",
            resource.io
        );
        if let Some(drive) = resource.drive {
            buffer.push_str(&format!(" DRIVE={drive}"));
        }
        line(out, format!("{buffer};"));
    }
}
