//! The result as Markdown.

use shadegate_testbench::bench::machine::Machine;
use std::fmt::Write;

/// Paragraphs and tables.
pub struct Report(String);

impl Report {
    /// Begins with where it was taken.
    pub fn new() -> Self {
        Self(format!(
            "# Shadegate beside other renderers\n\nWritten by bench/; its README says what is compared. {}; {}.\n",
            Machine::here(),
            env!("PEERS_COMPILER")
        ))
    }

    /// A heading and what is to be said about the table below it.
    pub fn section(&mut self, title: &str, text: &str) {
        // Writing to a string cannot fail.
        let _ = write!(self.0, "\n## {title}\n\n{text}\n");
    }

    /// A table; numbers are set to the right by `|---:|` for columns after the first `words`.
    pub fn table(&mut self, headings: &[&str], words: usize, rows: &[Vec<String>]) {
        let line = |cells: &mut dyn Iterator<Item = &str>| {
            let cells: Vec<&str> = cells.collect();
            format!("| {} |\n", cells.join(" | "))
        };
        self.0.push('\n');
        self.0 += &line(&mut headings.iter().copied());
        let rule = |i| if i < words { "---" } else { "---:" };
        let rules: Vec<&str> = (0..headings.len()).map(rule).collect();
        self.0 += &format!("|{}|\n", rules.join("|"));
        for row in rows {
            self.0 += &line(&mut row.iter().map(String::as_str));
        }
    }

    /// The whole.
    pub fn text(&self) -> &str {
        &self.0
    }
}
