//! Results of slow tools, kept by content: simulators that were compiled, netlists that were synthesised.
//!
//! An entry is a folder named by the hash of everything that its files depend on. It appears under its name only when
//! it is whole, so that two runs may fill the cache at once. A cache that cannot be written costs the next run its
//! time, nothing else.

use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// Where entries are: `$SHADEGATE_CACHE`, `$XDG_CACHE_HOME/shadegate`, or `~/.cache/shadegate`.
fn directory() -> Option<PathBuf> {
    let set = |name: &str| {
        std::env::var_os(name)
            .filter(|v| !v.is_empty())
            .map(PathBuf::from)
    };
    set("SHADEGATE_CACHE")
        .or_else(|| set("XDG_CACHE_HOME").map(|p| p.join("shadegate")))
        .or_else(|| set("HOME").map(|p| p.join(".cache/shadegate")))
}

/// Hash of everything that goes into an entry. Parts are told apart: `["ab", "c"]` is not `["a", "bc"]`.
pub fn key<'a>(parts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hash = Sha256::new();
    for part in parts {
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part.as_bytes());
    }
    hash.finalize()
        .iter()
        .take(16)
        .map(|b| format!("{b:02x}"))
        .collect()
}

/// An entry, found or made.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its folder.
    pub directory: PathBuf,
    /// It was made by an earlier run.
    pub cached: bool,
}

/// Which entry is wanted.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// What it is: the name of a folder.
    pub kind: &'a str,
    /// What it depends on, see [`key`].
    pub key: &'a str,
    /// Look for it and keep it; otherwise it is made here and now.
    pub keep: bool,
}

/// Finds an entry, or has it made in a folder below `scratch` and keeps a copy.
///
/// # Errors
/// Those of `make`, and `failed` of not being able to make a folder below `scratch`.
pub fn entry<E>(
    wanted: Wanted,
    scratch: &Path,
    failed: impl FnOnce(std::io::Error) -> E,
    make: impl FnOnce(&Path) -> Result<(), E>,
) -> Result<Entry, E> {
    let kept = directory()
        .filter(|_| wanted.keep)
        .map(|d| d.join(wanted.kind).join(wanted.key));
    if let Some(kept) = kept.as_ref().filter(|k| k.is_dir()) {
        return Ok(Entry {
            directory: kept.clone(),
            cached: true,
        });
    }
    let made = scratch.join(format!("{}-{}", wanted.kind, wanted.key));
    std::fs::create_dir_all(&made).map_err(failed)?;
    make(&made)?;
    if let Some(kept) = &kept {
        // Not being able to keep it is no fault of this run.
        let _ = keep(&made, kept);
    }
    Ok(Entry {
        directory: made,
        cached: false,
    })
}

fn keep(made: &Path, kept: &Path) -> std::io::Result<()> {
    let parent = kept.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(parent)?;
    let whole = tempfile::Builder::new()
        .prefix("making")
        .tempdir_in(parent)?;
    // The folder itself is renamed, so it must be readable as others are.
    let inside = whole.path().join("entry");
    std::fs::create_dir(&inside)?;
    for file in std::fs::read_dir(made)? {
        let file = file?;
        if file.file_type()?.is_file() {
            std::fs::copy(file.path(), inside.join(file.file_name()))?;
        }
    }
    std::fs::rename(&inside, kept)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_tell_parts_apart() {
        assert_ne!(key(["ab", "c"]), key(["a", "bc"]));
        assert_ne!(key(["a", ""]), key(["a"]));
        assert_eq!(key(["a", "b"]), key(["a", "b"]));
        assert_eq!(key([]).len(), 32);
    }

    #[test]
    fn an_entry_that_fails_is_not_kept_and_one_that_is_whole_is() {
        let folder = tempfile::tempdir().unwrap();
        let made = folder.path().join("made");
        std::fs::create_dir(&made).unwrap();
        std::fs::write(made.join("a"), "1").unwrap();
        let kept = folder.path().join("cache/kind/key");
        keep(&made, &kept).unwrap();
        assert_eq!(std::fs::read_to_string(kept.join("a")).unwrap(), "1");
        // A second one changes nothing: somebody else was faster.
        std::fs::write(made.join("a"), "2").unwrap();
        assert!(keep(&made, &kept).is_err());
        assert_eq!(std::fs::read_to_string(kept.join("a")).unwrap(), "1");
        let left = std::fs::read_dir(kept.parent().unwrap()).unwrap().count();
        assert_eq!(left, 1, "nothing half made stays");
        let wanted = Wanted {
            kind: "kind",
            key: "other",
            keep: false,
        };
        let same = |e: std::io::Error| e;
        let failing = |_: &Path| Err(std::io::Error::other("no"));
        assert!(entry(wanted, folder.path(), same, failing).is_err());
        let making = |d: &Path| std::fs::write(d.join("b"), "3");
        let e = entry(wanted, folder.path(), same, making).unwrap();
        assert!(!e.cached && e.directory.join("b").is_file());
    }
}
