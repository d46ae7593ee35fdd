//! The register words of a cone-filtered line, double-buffered: both forms of the filter take the same.
//!
//! | word | content |
//! |---|---|
//! | 6 | cos φ = dX·d, the distance of neighbours in a column |
//! | 7 | D of the first column |
//! | 8 | dY·d, added to D where the minor coordinate stays |
//! | 9 | (dX − dY)·d, subtracted where it moves |
//!
//! d = 1/√(dX² + dY²). (Eq. 3.12 as printed flips the sign of D and keeps adding; its listing starts one step late.)
//!
//! # Range and rounding
//! Q1.30 in pixels, or the same 32 bits in bins of the table, Q9.22 for 8 fraction bits. |D| ≤ ½ behind every step; cos φ ∓ D lie in 0.2..=1.5; 2·cos φ − |D| is used where dY > dX/2, so below 1.79.
//! cos φ = 1 is the word 2³⁰. Words are rounded to nearest, so D is off by at most k·2^−31 after k columns, 2^−20 pixels for
//! 2040 columns: a weight differs from that of the true distance only where |D| lies within that of a border between two
//! entries of the table, and then by one level of 255. The host rounds D of the first column by itself.

use crate::format::{signed_cast_bits, wrap, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// First register word.
pub const FIRST_WORD: usize = 6;
/// Register words.
pub const WORDS: usize = 4;
/// Fraction bits of a distance.
pub const FRACTION_BITS: usize = 30;

/// Distances in bins of a table of weights, a word of Q`M`.`N`: `M` − 1 fraction bits of a pixel before the point, `M` + `N`
/// = 31. Latency: one clock from `write` to the words, one from `load` to the steps.
#[derive(LogicBlock, Default)]
pub struct ConeWords<const M: usize, const N: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes `data` to register word `word`.
    pub write: Signal<In, Bit>,
    /// Register word, 6 to 9; others are ignored.
    pub word: Signal<In, U<4>>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// A new line begins.
    pub load: Signal<In, Bit>,
    /// Distance of the next line's first column.
    pub first: Signal<Out, Q<M, N>>,
    /// Distance of neighbours in a column.
    pub cosine: Signal<Out, Q<M, N>>,
    /// Twice that.
    pub cosine_2: Signal<Out, Q<M, N>>,
    /// Added where the minor coordinate stays.
    pub stay: Signal<Out, Q<M, N>>,
    /// Subtracted where it moves.
    pub step: Signal<Out, Q<M, N>>,
    /// Register bus as a distance.
    bus: Wire<Q<M, N>>,
    /// Next line, distance of neighbours in a column.
    word_cosine: Register<Q<M, N>>,
    /// Next line, distance of the first column.
    word_first: Register<Q<M, N>>,
    /// Next line, added where the minor coordinate stays.
    word_stay: Register<Q<M, N>>,
    /// Next line, subtracted where it moves.
    word_step: Register<Q<M, N>>,
    /// Distance of neighbours in a column.
    held_cosine: Register<Q<M, N>>,
    /// Added where the minor coordinate stays.
    held_stay: Register<Q<M, N>>,
    /// Subtracted where it moves.
    held_step: Register<Q<M, N>>,
    /// Bits of the cosine below its sign.
    cosine_bits: Wire<U<32>>,
    /// The same, one place up.
    doubled: Wire<U<32>>,
}

impl<const M: usize, const N: usize> Logic for ConeWords<M, N> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name cone_words");
        comment!("title Register words of a cone-filtered line, one line ahead.");
        comment!(
            "equation cos = dX d, stay = dY d, step = (dX - dY) d,  d = 1 / sqrt(dX^2 + dY^2)"
        );
        comment!("source Abbas 2003, section 3.3, equation 3.12 corrected.");
        comment!("latency One clock each from write and load.");
        dff_setup!(
            self,
            clock,
            word_cosine,
            word_first,
            word_stay,
            word_step,
            held_cosine,
            held_stay,
            held_step
        );
        self.bus.next = signed_cast_bits::<M, N, 32>(self.data.val());
        if self.write.val() {
            if self.word.val() == 6u64.into() {
                self.word_cosine.d.next = self.bus.val();
            }
            if self.word.val() == 7u64.into() {
                self.word_first.d.next = self.bus.val();
            }
            if self.word.val() == 8u64.into() {
                self.word_stay.d.next = self.bus.val();
            }
            if self.word.val() == 9u64.into() {
                self.word_step.d.next = self.bus.val();
            }
        }
        if self.load.val() {
            self.held_cosine.d.next = self.word_cosine.q.val();
            self.held_stay.d.next = self.word_stay.q.val();
            self.held_step.d.next = self.word_step.q.val();
        }
        self.cosine_bits.next = self.held_cosine.q.val().get_bits::<32>(0);
        self.doubled.next = self.cosine_bits.val() << 1u64;
        self.first.next = self.word_first.q.val();
        self.cosine.next = self.held_cosine.q.val();
        self.cosine_2.next = signed_cast_bits::<M, N, 32>(self.doubled.val());
        self.stay.next = self.held_stay.q.val();
        self.step.next = self.held_step.q.val();
    }
}

crate::clocked!(ConeWords<M, N>, const M: usize, const N: usize;
    inputs write, word, data, load;
    outputs first, cosine, cosine_2, stay, step);

/// Integer model of [`ConeWords`].
#[derive(Clone, Copy, Debug, Default)]
pub struct ConeWordsModel {
    words: [i64; WORDS],
    /// Distance of neighbours in a column.
    pub cosine: i64,
    /// Added where the minor coordinate stays.
    pub stay: i64,
    /// Subtracted where it moves.
    pub step: i64,
}

impl ConeWordsModel {
    /// Distance of the next line's first column.
    #[must_use]
    pub fn first(&self) -> i64 {
        self.words[1]
    }

    /// D of the next column.
    #[must_use]
    pub fn next(&self, d: i64, rises: bool) -> i64 {
        wrap(if rises { d - self.step } else { d + self.stay }, 32)
    }

    /// Distance of a lane from the line in a column with this D.
    #[must_use]
    pub fn distance(&self, d: i64, lane: u64) -> i64 {
        let distance = match lane {
            0 => d,
            1 => self.cosine - d,
            2 => self.cosine + d,
            _ if d < 0 => 2 * self.cosine + d,
            _ => 2 * self.cosine - d,
        };
        wrap(distance, 32)
    }

    /// One clock edge; `write` is a register word and its data.
    pub fn clock(&mut self, write: Option<(usize, u64)>, load: bool) {
        if load {
            [self.cosine, _, self.stay, self.step] = self.words;
        }
        if let Some((word, data)) = write {
            if let Some(to) = word
                .checked_sub(FIRST_WORD)
                .and_then(|i| self.words.get_mut(i))
            {
                *to = wrap(data as i64, 32);
            }
        }
    }
}
