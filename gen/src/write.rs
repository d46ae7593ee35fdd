//! Writing files whole: to a temporary beside the target, then renamed.

use std::io::Write;
use std::path::{Path, PathBuf};

/// A file that could not be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: cannot be written: {source}", path.display())]
pub struct WriteError {
    /// The file or directory.
    pub path: PathBuf,
    /// Why.
    pub source: std::io::Error,
}

/// Creates a directory and its parents.
///
/// # Errors
/// When the system refuses.
pub fn create_directory(path: &Path) -> Result<(), WriteError> {
    std::fs::create_dir_all(path).map_err(|source| WriteError {
        path: path.into(),
        source,
    })
}

/// The folder of a file.
fn folder_of(path: &Path) -> &Path {
    let parent = path.parent().filter(|p| !p.as_os_str().is_empty());
    parent.unwrap_or(Path::new("."))
}

/// A file to be written whole and then moved to its place, beside it. A temporary file is its owner's alone; this one
/// is to be as readable as any other.
///
/// # Errors
/// When the system refuses.
pub fn temporary_beside(path: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder_of(path))
}

/// Writes a file: readers see the old one or the whole new one, never a part. Missing directories are created.
///
/// # Errors
/// When the system refuses; then the old file, if any, is untouched.
pub fn write_file(path: &Path, contents: &[u8]) -> Result<(), WriteError> {
    let error = |source| WriteError {
        path: path.into(),
        source,
    };
    create_directory(folder_of(path))?;
    let mut file = temporary_beside(path).map_err(error)?;
    file.write_all(contents).map_err(error)?;
    file.persist(path).map_err(|e| error(e.error))?;
    Ok(())
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::PermissionsExt;

    #[test]
    fn a_result_is_as_readable_as_any_other_file() {
        let folder = tempfile::tempdir().expect("a folder");
        let (plain, whole) = (folder.path().join("plain"), folder.path().join("whole"));
        std::fs::write(&plain, "x").expect("writable");
        super::write_file(&whole, b"x").expect("writable");
        let mode = |p| std::fs::metadata(p).expect("exists").permissions().mode();
        assert_eq!(mode(&plain), mode(&whole));
        let temporary = super::temporary_beside(&whole).expect("a file");
        assert_eq!(mode(&plain), mode(&temporary.path().to_owned()));
    }
}
