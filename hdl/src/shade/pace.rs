//! What a clock of a core is spent on, as its model knows it.

/// What the pixel registers do in a clock, and why they are empty if they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// They hold a pixel and move on.
    Pixel,
    /// They hold a pixel and stand still: the consumer, or a pixel ahead, is not ready.
    Stalled,
    /// They are empty while the memory of the frame is cleared.
    Clearing,
    /// They are empty since the line registers stand on a row without a pixel.
    EmptyRow,
    /// They are empty while words move through the register levels.
    Moving,
    /// They are empty, and so are the levels before them.
    Idle,
}

impl Pace {
    /// The pace of pixel registers that hold a pixel, if they do.
    pub(crate) fn of_pixel(held: bool, go: bool) -> Option<Self> {
        held.then_some(if go { Self::Pixel } else { Self::Stalled })
    }

    /// The pace of empty pixel registers before which there is no row to skip.
    pub(crate) fn of_empty(clearing: bool, pending: bool) -> Self {
        match (clearing, pending) {
            (true, _) => Self::Clearing,
            (false, true) => Self::Moving,
            (false, false) => Self::Idle,
        }
    }
}
