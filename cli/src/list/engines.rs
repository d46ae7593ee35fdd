//! Engines: which are installed, in which version, and how to install the others.

use super::Section;
use serde_json::json;
use shadegate_testbench::engine::{find_tool, Engine};
use std::process::{Command, Stdio};

/// Every engine.
pub fn engines() -> Section {
    let mut section = Section::new(&["engine", "installed", "version, or how to install it"]);
    for e in Engine::ALL {
        let tools = e.tools();
        let missing: Vec<&str> = tools
            .iter()
            .filter(|(tool, _)| find_tool(tool).is_none())
            .map(|(tool, _)| *tool)
            .collect();
        let mut packages: Vec<&str> = tools
            .iter()
            .filter(|(tool, _)| missing.contains(tool))
            .map(|(_, package)| *package)
            .collect();
        packages.dedup();
        let installed = missing.is_empty();
        let install = (!installed).then(|| format!("apt install {}", packages.join(" ")));
        let version = if installed { version(e) } else { None };
        let remark = match (&install, &version) {
            (Some(install), _) => format!("missing {}: {install}", missing.join(", ")),
            (None, Some(version)) => version.clone(),
            (None, None) => "unknown version".to_owned(),
        };
        section.add(
            [
                e.name().to_owned(),
                if installed { "yes" } else { "no" }.to_owned(),
                remark,
            ],
            json!({
                "name": e.name(),
                "installed": installed,
                "version": version,
                "tools": tools.iter().map(|t| t.0).collect::<Vec<_>>(),
                "missing": missing,
                "install": install,
            }),
        );
    }
    section
}

/// What the first tool of an engine says of itself.
fn version(e: Engine) -> Option<String> {
    let (tool, option) = match e {
        Engine::RustHdl | Engine::Compiled => return Some("part of this program".to_owned()),
        Engine::Icarus => ("iverilog", "-V"),
        Engine::Verilator => ("verilator", "--version"),
        Engine::Cxxrtl => ("yosys", "-V"),
    };
    let said = Command::new(find_tool(tool)?)
        .arg(option)
        .stdin(Stdio::null())
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&said.stdout);
    let line = text.lines().map(str::trim).find(|l| !l.is_empty())?;
    let visible: String = line.chars().filter(|c| !c.is_control()).collect();
    Some(visible)
}
