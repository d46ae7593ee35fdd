//! A cosine p·y·2^e from a dot product p with a normal that is not normalised, and y·2^e, one over its length.
//!
//! p waits for the root of its pixel in six stages; then a product and a doubling. p and the cosine are in units of
//! 2^−28; products are cut to that, so the doublings leave at most 4 units of error.

use crate::format::{signed_cast_product, Q};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the dot product to the cosine.
pub const STAGES: usize = 8;

/// Latency: eight clocks.
#[derive(LogicBlock, Default)]
pub struct Cosine {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Dot product, in units of 2^-28.
    pub dot: Signal<In, Q<29, 0>>,
    /// One over the root of m, for the dot product of six clocks ago.
    pub root: Signal<In, Q<2, 22>>,
    /// The root is to be doubled once.
    pub once: Signal<In, Bit>,
    /// The root is to be doubled twice.
    pub twice: Signal<In, Bit>,
    /// The cosine of eight clocks ago, in units of 2^-28.
    pub cosine: Signal<Out, Q<31, 0>>,
    /// Dot product, one clock later.
    dot_1: Register<Q<29, 0>>,
    /// Two clocks later.
    dot_2: Register<Q<29, 0>>,
    /// Three clocks later.
    dot_3: Register<Q<29, 0>>,
    /// Four clocks later.
    dot_4: Register<Q<29, 0>>,
    /// Five clocks later.
    dot_5: Register<Q<29, 0>>,
    /// Six clocks later.
    dot_6: Register<Q<29, 0>>,
    /// Dot product times root.
    product_7: Register<Q<31, 0>>,
    /// It is to be doubled once.
    once_7: Register<Bit>,
    /// It is to be doubled twice.
    twice_7: Register<Bit>,
    /// The cosine.
    cosine_8: Register<Q<31, 0>>,
    /// Doubled once.
    doubled: Wire<Q<31, 0>>,
}

impl Logic for Cosine {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name cosine");
        comment!("title A cosine from a dot product and one over the root of the squared length.");
        comment!("equation cosine = dot root 2^e, e = twice ? 2 : once ? 1 : 0");
        comment!("source Duff 1979; Hast 2004, equation 2.44.");
        comment!("latency Eight clocks from dot, two from root, to cosine; one cosine per clock.");
        dff_setup!(
            self, clock, dot_1, dot_2, dot_3, dot_4, dot_5, dot_6, product_7, once_7, twice_7,
            cosine_8
        );
        self.doubled.next = self.product_7.q.val() + self.product_7.q.val();
        if self.go.val() {
            self.dot_1.d.next = self.dot.val();
            self.dot_2.d.next = self.dot_1.q.val();
            self.dot_3.d.next = self.dot_2.q.val();
            self.dot_4.d.next = self.dot_3.q.val();
            self.dot_5.d.next = self.dot_4.q.val();
            self.dot_6.d.next = self.dot_5.q.val();
            self.product_7.d.next =
                signed_cast_product::<31, 0>(self.dot_6.q.val() * self.root.val());
            self.once_7.d.next = self.once.val();
            self.twice_7.d.next = self.twice.val();
            self.cosine_8.d.next = self.product_7.q.val();
            if self.twice_7.q.val() {
                self.cosine_8.d.next = self.doubled.val() + self.doubled.val();
            } else if self.once_7.q.val() {
                self.cosine_8.d.next = self.doubled.val();
            }
        }
        self.cosine.next = self.cosine_8.q.val();
    }
}

crate::clocked!(Cosine;
    inputs go, dot, root, once, twice;
    outputs cosine);
