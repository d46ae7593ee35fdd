//! Where figures were taken: times mean nothing without it.

use serde::Serialize;

/// A machine, as far as it tells.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Machine {
    /// The processor's own name for itself, or its architecture.
    pub processor: String,
    /// Processors that this program may use.
    pub processors: usize,
    /// Operating system.
    pub system: &'static str,
    /// Version of this program.
    pub shadegate: &'static str,
}

impl Machine {
    /// This one.
    #[must_use]
    pub fn here() -> Self {
        let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        Self {
            processor: model(&info).unwrap_or(std::env::consts::ARCH).to_owned(),
            processors: std::thread::available_parallelism().map_or(1, usize::from),
            system: std::env::consts::OS,
            shadegate: env!("CARGO_PKG_VERSION"),
        }
    }
}

/// The name in the text of Linux's `/proc/cpuinfo`.
fn model(info: &str) -> Option<&str> {
    let line = info.lines().find(|l| l.starts_with("model name"))?;
    let name = line.split_once(':')?.1.trim();
    (!name.is_empty()).then_some(name)
}

impl std::fmt::Display for Machine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let s = if self.processors == 1 { "" } else { "s" };
        write!(
            f,
            "{}, {} processor{s}, {}, shadegate {}",
            self.processor, self.processors, self.system, self.shadegate
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_model_is_found_where_there_is_one() {
        assert_eq!(
            model("processor\t: 0\nmodel name\t: Good CPU @ 2 GHz\nflags\t: x\n"),
            Some("Good CPU @ 2 GHz")
        );
        assert_eq!(model("model name\t:\n"), None);
        assert_eq!(model(""), None);
        assert!(Machine::here().processors >= 1);
    }
}
