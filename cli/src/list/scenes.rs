//! Scene files in a folder.

use super::Section;
use crate::outcome::Failure;
use serde_json::json;
use shadegate_reference::scene;
use std::path::{Path, PathBuf};

/// Every scene in a folder; broken ones with what is wrong. A folder that does not exist has none.
pub fn scenes(dir: &Path) -> Result<Section, Failure> {
    let mut section = Section::new(&["scene", "size", "triangles", "method", "file"]);
    let files = files(dir)
        .map_err(|e| Failure::input(format!("'{}' cannot be read ({e})", dir.display())))?;
    for file in &files {
        let path = file.to_string_lossy().into_owned();
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        match scene::load(file) {
            Ok(s) => {
                let triangles: usize = s.objects.iter().map(|o| o.mesh.triangles.len()).sum();
                section.add(
                    [
                        s.name.clone(),
                        format!("{}x{}", s.image.width, s.image.height),
                        triangles.to_string(),
                        s.render.method.name().to_owned(),
                        path.clone(),
                    ],
                    json!({
                        "name": s.name,
                        "file": path,
                        "width": s.image.width,
                        "height": s.image.height,
                        "triangles": triangles,
                        "method": s.render.method.name(),
                    }),
                );
            }
            Err(e) => section.add(
                [
                    name.clone().into_owned(),
                    "-".to_owned(),
                    "-".to_owned(),
                    "-".to_owned(),
                    e.to_string(),
                ],
                json!({ "name": name, "file": path, "error": e.to_string() }),
            ),
        }
    }
    if files.is_empty() {
        section.note = Some(format!(
            "no scenes in '{}'; --dir names another folder",
            dir.display()
        ));
    }
    Ok(section)
}

fn files(dir: &Path) -> std::io::Result<Vec<PathBuf>> {
    if !dir.is_dir() {
        return Ok(Vec::new());
    }
    let mut files = Vec::new();
    for entry in std::fs::read_dir(dir)? {
        let path = entry?.path();
        if path.is_file() && path.extension().is_some_and(|e| e == "toml") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}
