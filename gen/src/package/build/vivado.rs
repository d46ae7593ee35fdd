//! The Vivado script, in non-project mode.

use super::Sources;
use crate::package::Target;

/// Text of `build/vivado.tcl`.
pub fn script(s: &Sources, t: Target) -> String {
    let top = s.top;
    let part = t.part();
    let rtl: String = s.rtl.iter().map(|f| format!("    {f}\n")).collect();
    let constraints = s.constraints.map_or(String::new(), |f| {
        format!("read_xdc [file join $package {f}]\n")
    });
    format!(
        "# {top}: synthesis, and with the argument `route` placement and routing, by Vivado for {part}.\n\
         #   vivado -mode batch -source build/vivado.tcl -tclargs route\n\
         # The core is built out of context, as a part of a design: it has more ports than most packages have pins.\n\
         # Results are in out/vivado.\n\
         set package [file join [file dirname [info script]] ..]\n\
         set results [file join $package out vivado]\n\
         file mkdir $results\n\
         \n\
         foreach name {{\n{rtl}}} {{\n    read_verilog [file join $package $name]\n}}\n\
         {constraints}\
         \n\
         synth_design -top {top} -part {part} -mode out_of_context\n\
         report_utilization -file [file join $results utilisation_synthesis.txt]\n\
         report_timing_summary -file [file join $results timing_synthesis.txt]\n\
         write_checkpoint -force [file join $results {top}_synthesis.dcp]\n\
         \n\
         if {{[lsearch $argv route] >= 0}} {{\n    \
             opt_design\n    \
             place_design\n    \
             route_design\n    \
             report_utilization -file [file join $results utilisation.txt]\n    \
             report_timing_summary -file [file join $results timing.txt]\n    \
             write_checkpoint -force [file join $results {top}.dcp]\n\
         }}\n"
    )
}
