//! The ISE project and the script for `xtclsh`.

use super::Sources;
use crate::package::Target;

/// The only ISE whose project file is written; older ones take the script alone.
pub const PROJECT_TOOL: &str = "ISE 14.7";

/// The family as ISE names it.
pub fn family(name: &str) -> &'static str {
    match name {
        "spartan-2e" => "Spartan2E",
        "spartan-3" => "Spartan3",
        "spartan-3e" => "Spartan3E",
        _ => "Spartan6",
    }
}

/// Package and speed grade of the part.
fn package(t: Target) -> (String, u8) {
    match t.board {
        Some(b) => (b.package.clone(), b.speed),
        None => (t.device.package.clone(), t.device.speed),
    }
}

/// Text of `build/ise.tcl`.
pub fn script(s: &Sources, t: Target) -> String {
    let top = s.top;
    let (device, family) = (&t.device.name, family(&t.device.family));
    let (package, speed) = package(t);
    let files: String = s
        .rtl
        .iter()
        .copied()
        .chain(s.constraints)
        .map(|f| format!("    {f}\n"))
        .collect();
    format!(
        "# {top}: synthesis, and with the argument `implement` mapping, placement and routing, by {tool} for {part}.\n\
         #   xtclsh build/ise.tcl implement\n\
         # The project and all results are in out/ise.\n\
         set package [file normalize [file join [file dirname [info script]] ..]]\n\
         set results [file join $package out ise]\n\
         file mkdir $results\n\
         cd $results\n\
         if {{[file exists {top}.xise]}} {{ file delete {top}.xise }}\n\
         \n\
         project new {top}.xise\n\
         project set family {family}\n\
         project set device {device}\n\
         project set package {package}\n\
         project set speed -{speed}\n\
         project set top_level_module_type HDL\n\
         project set synthesis_tool {{XST (VHDL/Verilog)}}\n\
         foreach name {{\n{files}}} {{\n    xfile add [file join $package $name]\n}}\n\
         project set top {top}\n\
         process run {{Synthesize - XST}}\n\
         if {{[lsearch $argv implement] >= 0}} {{\n    \
             process run {{Implement Design}}\n\
         }}\n\
         project close\n",
        tool = t.device.vendor_tool,
        part = t.part(),
    )
}

/// Text of `build/<top>.xise`.
pub fn project(s: &Sources, t: Target) -> String {
    let top = s.top;
    let (package, speed) = package(t);
    let file = |path: &str, kind: &str, sequence: usize| {
        format!(
            "    <file xil_pn:name=\"../{path}\" xil_pn:type=\"{kind}\">\n      \
             <association xil_pn:name=\"Implementation\" xil_pn:seqID=\"{sequence}\"/>\n    </file>\n"
        )
    };
    let mut files = String::new();
    for (i, path) in s.rtl.iter().enumerate() {
        files.push_str(&file(path, "FILE_VERILOG", i + 1));
    }
    if let Some(path) = s.constraints {
        files.push_str(&file(path, "FILE_UCF", 0));
    }
    let properties: String = [
        ("Device", t.device.name.clone()),
        ("Device Family", family(&t.device.family).to_owned()),
        ("Package", package),
        ("Speed Grade", format!("-{speed}")),
        ("Top-Level Source Type", "HDL".to_owned()),
        ("Synthesis Tool", "XST (VHDL/Verilog)".to_owned()),
        ("Preferred Language", "Verilog".to_owned()),
        ("Implementation Top", format!("Module|{top}")),
        ("Implementation Top Instance Path", format!("/{top}")),
        ("Working Directory", "../out/ise".to_owned()),
    ]
    .iter()
    .map(|(name, value)| {
        format!("    <property xil_pn:name=\"{name}\" xil_pn:value=\"{value}\" xil_pn:valueState=\"non-default\"/>\n")
    })
    .collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\" ?>\n\
         <!-- {top} for {part}, {PROJECT_TOOL}. -->\n\
         <project xmlns=\"http://www.xilinx.com/XMLSchema\" xmlns:xil_pn=\"http://www.xilinx.com/XMLSchema\">\n\
         \x20 <version xil_pn:ise_version=\"14.7\" xil_pn:schema_version=\"2\"/>\n\
         \x20 <files>\n{files}  </files>\n\
         \x20 <properties>\n{properties}  </properties>\n\
         \x20 <bindings/>\n\
         \x20 <libraries/>\n\
         </project>\n",
        part = t.part(),
    )
}
