//! The compact quadratic unit: the same triangles as the quadratic core's walk and RGB part, on less than half the area.
//!
//! What is waiting lies in look-up tables used as memory (one of four inputs holds sixteen words of one bit), twice: the
//! words of this triangle, which the walk reads, and those of the next, which the host writes. So there is one set of
//! registers, not two, and only six words per channel, as in the appendix of Abbas (2003). The four words that are sums
//! of others are not stored: a carrying line step is a line step and then a pixel step on the same adders, as exact.
//! Line registers are not loaded through multiplexers but cleared and added to, so an adder with two addends to choose
//! from takes one look-up table per bit.
//!
//! The price: the line registers stand on the next span two clocks after a take, three if the step carries, and on the
//! next triangle seven clocks after the last row was taken; a host write holds them for a clock. Spans of three pixels
//! and more follow each other without a bubble, at one pixel per clock.
//!
//! | module | what |
//! |---|---|
//! | [`word_memory`] | sixteen words in look-up tables |
//! | [`channel`] | a colour over a triangle |
//! | [`clamp`] | its byte |
//! | [`walk`] | rows, edges, pixels, and the order of the additions |
//! | [`unit`] | the walk, three channels, clamp, pixel hand-over; no depth test |

pub mod channel;
pub mod clamp;
pub mod unit;
pub mod walk;
pub mod word_memory;

mod model;

pub use model::{channel_words, CompactInputs, CompactModel, CompactOutputs};

/// Words of a channel: value, d_line, d_pixel at the first span start; dd_pixel, dd_line, dd_pixel_line.
pub const CHANNEL_WORDS: usize = 6;
