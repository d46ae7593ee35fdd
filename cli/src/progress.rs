//! A sign of life on standard error while something takes long; nothing at all when that is not a terminal.

use crate::args::Global;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::Duration;

/// A spinner with a text; gone when dropped.
pub struct Progress(ProgressBar);

impl Progress {
    /// Starts to spin, unless standard error is no terminal or quiet is wanted.
    pub fn new(text: impl Into<String>, global: Global) -> Self {
        let target = if global.quiet {
            ProgressDrawTarget::hidden()
        } else {
            // Hides itself where there is no terminal.
            ProgressDrawTarget::stderr()
        };
        let bar = ProgressBar::with_draw_target(None, target)
            .with_style(ProgressStyle::default_spinner())
            .with_message(text.into());
        if !bar.is_hidden() {
            bar.enable_steady_tick(Duration::from_millis(100));
        }
        Self(bar)
    }

    /// Says how much is done and what is done now; from here on there is a bar in place of the spinner.
    pub fn at(&self, done: usize, of: usize, text: &str) {
        if self.0.length() != Some(of as u64) {
            self.0.set_length(of as u64);
            if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}") {
                self.0.set_style(style);
            }
        }
        self.0.set_position(done as u64);
        self.0.set_message(text.to_owned());
    }

    /// Says what is done now.
    pub fn say(&self, text: impl Into<String>) {
        self.0.set_message(text.into());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
