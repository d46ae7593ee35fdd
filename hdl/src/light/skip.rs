//! What a whole triangle does without: its highlight, its diffuse reflection, or both. One word beside those of the interpolants, and like them
//! double-buffered, so that a host that knows a triangle to be dark need not send its cosines: the interpolants walk on
//! with whatever they hold, and nothing of it shows.

use crate::format::U;
use crate::simulate::Register;
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Register word: bit 0 no highlight, bit 1 no diffuse reflection.
#[derive(LogicBlock, Default)]
pub struct Skip {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes the register word.
    pub write: Signal<In, Bit>,
    /// Low bits of the register bus.
    pub data: Signal<In, U<2>>,
    /// Moves the register word to the line registers: a new triangle begins.
    pub load: Signal<In, Bit>,
    /// Moves the line registers to the pixel registers: a new span begins.
    pub take: Signal<In, Bit>,
    /// The triangle of the current pixel has no highlight.
    pub no_highlight: Signal<Out, Bit>,
    /// It has no diffuse reflection.
    pub no_diffuse: Signal<Out, Bit>,
    /// Next triangle.
    word: Register<U<2>>,
    /// Triangle of the next span.
    line: Register<U<2>>,
    /// Triangle of the current span.
    span: Register<U<2>>,
}

impl Logic for Skip {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name skip");
        comment!(
            "title What a triangle does without: highlight, diffuse reflection; double-buffered."
        );
        comment!("equation no_highlight = bit 0, no_diffuse = bit 1 of the word of the triangle that is drawn");
        comment!(
            "source Hast 2004, sections 3.5.1 and 3.5.5: what cannot show need not be computed."
        );
        comment!("latency One clock each from write, load and take.");
        dff_setup!(self, clock, word, line, span);
        if self.write.val() {
            self.word.d.next = self.data.val();
        }
        if self.load.val() {
            self.line.d.next = self.word.q.val();
        }
        if self.take.val() {
            self.span.d.next = self.line.q.val();
        }
        self.no_highlight.next = self.span.q.val().get_bit(0);
        self.no_diffuse.next = self.span.q.val().get_bit(1);
    }
}

crate::clocked!(Skip;
    inputs write, data, load, take;
    outputs no_highlight, no_diffuse);
