//! What is synthesised: a core, the core of a scene, or a folder of Verilog.

use super::SynthArgs;
use crate::cosim::failure;
use crate::names::{check_names, drawing, drawing_of, set_up, Drawing};
use crate::outcome::Failure;
use serde_json::{json, Value};
use shadegate_gen::package::{rtl, PackageFile};
use shadegate_gen::scene::{drawable, order_for, suited};
use shadegate_gen::verilog::VerilogFile;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::scene;
use shadegate_testbench::cosim::CosimError;
use shadegate_testbench::synthesis::Design;
use std::path::Path;

/// Frame of a core that is synthesised without a scene.
const FRAME: (u32, u32) = (320, 240);

/// A design, and what is known of it besides.
pub struct Subject {
    /// The design.
    pub design: Design,
    /// For people.
    pub title: String,
    /// For programs: an object.
    pub about: Value,
}

/// What is to be synthesised.
pub fn subject(a: &SynthArgs, size: Option<(u32, u32)>) -> Result<Subject, Failure> {
    if let (Some(folder), Some(top)) = (&a.verilog, &a.top) {
        return verilog(folder, top);
    }
    let (drawn, scene_size) = match (&a.scene, &a.core) {
        (Some(file), _) => {
            check_names(a.method.as_deref(), None)?;
            let mut scene = scene::load(file).map_err(Failure::input)?;
            let mut drawing = drawing_of(a.method.as_deref(), None, &mut scene)?;
            if let Drawing::Shaded(method) = drawing {
                if let Some(order) = order_for(&scene, method).map_err(Failure::input)? {
                    drawable(&scene, order).map_err(Failure::input)?;
                    suited(&scene, order).map_err(Failure::input)?;
                    if matches!(order, Order::Glint(_) | Order::Textured(_) | Order::Bump(_)) {
                        drawing = Drawing::Core(order);
                    }
                }
            }
            (drawing, (scene.image.width, scene.image.height))
        }
        (None, Some(name)) if name.ends_with(".toml") => {
            return Err(Failure::input(format!(
                "'{name}' is not a core; for a scene: shadegate synth --scene {name}"
            )));
        }
        (None, Some(name)) => (drawing(name)?, FRAME),
        // clap demands one of them.
        (None, None) => return Err(Failure::input("expected a core or --scene FILE")),
    };
    let (width, height) = size.unwrap_or(scene_size);
    let by = set_up(None, a.core.as_deref())?;
    let core = drawn.core_by(by, width, height).map_err(failure)?;
    let rtl = rtl(&core).map_err(|e| failure(CosimError::Package(e)))?;
    let file = |f: &VerilogFile| PackageFile {
        path: format!("rtl/{}", f.file_name()),
        text: f.text.clone(),
    };
    let top = format!("{}_core", core.module());
    Ok(Subject {
        title: format!("{} core, {width}x{height}", core.name()),
        about: json!({
            "design": top,
            "core": core.name(),
            "frame": [width, height],
            "configuration": rtl.configuration,
        }),
        design: Design {
            top,
            files: rtl.files.iter().map(file).collect(),
        },
    })
}

/// A folder of Verilog files. Their names go into scripts, so they must be plain.
fn verilog(folder: &Path, top: &str) -> Result<Subject, Failure> {
    let plain = |name: &str| {
        name.bytes()
            .all(|b| b.is_ascii_alphanumeric() || b"_-.".contains(&b))
    };
    if !top.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') || top.is_empty() {
        return Err(Failure::input(format!(
            "top module '{top}' is not a name; expected letters, digits and underscores"
        )));
    }
    let cannot =
        |path: &Path, e: std::io::Error| Failure::input(format!("'{}': {e}", path.display()));
    let mut files = vec![];
    for file in std::fs::read_dir(folder).map_err(|e| cannot(folder, e))? {
        let path = file.map_err(|e| cannot(folder, e))?.path();
        let Some(name) = path.file_name().and_then(|n| n.to_str()) else {
            continue;
        };
        if !name.ends_with(".v") {
            continue;
        }
        if !plain(name) {
            return Err(Failure::input(format!(
                "'{}': expected a file name of letters, digits, '.', '-' and '_'",
                path.display()
            )));
        }
        files.push(PackageFile {
            path: format!("rtl/{name}"),
            text: std::fs::read_to_string(&path).map_err(|e| cannot(&path, e))?,
        });
    }
    if files.is_empty() {
        return Err(Failure::input(format!(
            "'{}' holds no Verilog; expected files that end in .v",
            folder.display()
        )));
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(Subject {
        title: top.to_string(),
        about: json!({ "design": top, "core": null, "frame": null, "configuration": null }),
        design: Design {
            top: top.to_string(),
            files,
        },
    })
}
