//! Where results may go. Checked before any work is done, so that nobody waits for an error.

use crate::outcome::Failure;
use std::path::Path;

/// The folder that a path is in.
fn parent(path: &Path) -> &Path {
    match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p,
        _ => Path::new("."),
    }
}

fn in_a_folder(path: &Path) -> Result<(), Failure> {
    let folder = parent(path);
    if folder.is_dir() {
        return Ok(());
    }
    Err(Failure::input(format!(
        "cannot write '{}': '{}' is not a directory",
        path.display(),
        folder.display()
    )))
}

/// A file that will be written, with the ending that says what it is.
///
/// # Errors
/// Another ending, no folder to put it in, or something else in its place.
pub fn file(path: &Path, ending: &str) -> Result<(), Failure> {
    file_of(path, &[ending])
}

/// A file that will be written, with one of these endings.
///
/// # Errors
/// As [`file`].
pub fn file_of(path: &Path, endings: &[&str]) -> Result<(), Failure> {
    let fits = |ending: &&str| {
        let given = path.extension();
        given.is_some_and(|e| e.eq_ignore_ascii_case(ending))
    };
    if !endings.iter().any(fits) {
        return Err(Failure::input(format!(
            "cannot write '{}': expected a name that ends in .{}",
            path.display(),
            endings.join(" or .")
        )));
    }
    in_a_folder(path)?;
    match std::fs::metadata(path) {
        Ok(there) if !there.is_file() => Err(Failure::input(format!(
            "cannot write '{}': it is there and not a file",
            path.display()
        ))),
        _ => Ok(()),
    }
}

/// A folder that will be filled; made, with its parents, if it is missing.
///
/// # Errors
/// A file of that name, or one where a parent should be.
pub fn folder(path: &Path) -> Result<(), Failure> {
    match std::fs::metadata(path) {
        Ok(there) if there.is_dir() => Ok(()),
        Ok(_) => Err(Failure::input(format!(
            "cannot write to '{}': it is not a directory",
            path.display()
        ))),
        Err(_) => match parent(path) {
            up if up == path || up.is_dir() => Ok(()),
            up => folder(up),
        },
    }
}

/// Refuses to write over a file that is read.
///
/// # Errors
/// When both paths lead to one file.
pub fn not_over(output: &Path, input: &Path) -> Result<(), Failure> {
    match (output.canonicalize(), input.canonicalize()) {
        (Ok(o), Ok(i)) if o == i => Err(Failure::input(format!(
            "cannot write '{}': it is one of the inputs",
            output.display()
        ))),
        _ => Ok(()),
    }
}
