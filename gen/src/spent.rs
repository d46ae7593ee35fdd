//! What the clocks of a frame are spent on: drawing, loading, waiting. Each clock is counted once, by what the pixel
//! registers do in it, so the sum is the total.

use shadegate_hdl::shade::pace::Pace;

/// Clocks by what they are spent on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spent {
    /// The pixel registers hold a pixel and move on, whether the depth test lets it pass or not.
    pub drawing: u64,
    /// They are empty because words are being written, or are on their way through the register levels.
    pub loading: u64,
    /// They hold a pixel that the consumer, or a pixel ahead, keeps from moving on.
    pub back_pressure: u64,
    /// The walk stands on a row without a pixel.
    pub empty_rows: u64,
    /// The memory of the frame is being cleared.
    pub clear: u64,
    /// They are empty, and the last pixels are on their way out: of the frame, or before new words of a material.
    pub drain: u64,
}

impl Spent {
    /// Counts a clock; `writing` says whether the host has words to write and the core takes them.
    pub(crate) fn count(&mut self, pace: Pace, writing: bool) {
        *match pace {
            Pace::Pixel => &mut self.drawing,
            Pace::Stalled => &mut self.back_pressure,
            Pace::Clearing => &mut self.clear,
            Pace::EmptyRow => &mut self.empty_rows,
            Pace::Moving => &mut self.loading,
            Pace::Idle if writing => &mut self.loading,
            Pace::Idle => &mut self.drain,
        } += 1;
    }

    /// Clocks that are neither drawing nor loading.
    #[must_use]
    pub fn waiting(&self) -> u64 {
        self.back_pressure + self.empty_rows + self.clear + self.drain
    }

    /// All clocks.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.drawing + self.loading + self.waiting()
    }
}
