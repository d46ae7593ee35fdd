//! Integer model of a core behind a set-up engine.

use super::model::{EngineInputs, EngineModel};
use crate::shade::model::{CoreInputs, CoreModel, CoreOutputs, Order};

/// State of both.
#[derive(Clone, Debug)]
pub struct EngineCoreModel {
    engine: EngineModel,
    core: CoreModel,
    was_busy: bool,
    /// For each triangle that the core was given, which one of those the host started it is, from 1.
    drawn: Vec<u64>,
}

impl EngineCoreModel {
    /// The quadratic core with an engine, at power-up.
    #[must_use]
    pub fn new(fraction_bits: usize, bus_bits: usize, address_bits: usize, pixels: usize) -> Self {
        Self {
            engine: EngineModel::new(fraction_bits, bus_bits),
            core: CoreModel::new(Order::Quadratic, fraction_bits, address_bits, pixels),
            was_busy: false,
            drawn: vec![],
        }
    }

    /// The outputs of the current state.
    #[must_use]
    pub fn outputs(&self) -> CoreOutputs {
        let engine = self.engine.outputs();
        let core = self.core.outputs();
        let busy = core.busy || engine.busy;
        CoreOutputs {
            load_ready: engine.load_ready,
            busy,
            done: self.was_busy && !busy,
            ..core
        }
    }

    /// Ordinal, from 1, of the triangle that the offered pixel belongs to, among those the host started.
    #[must_use]
    pub fn ordinal(&self) -> u64 {
        let of_core = self.core.ordinal() as usize;
        let before = of_core.checked_sub(1);
        before.and_then(|i| self.drawn.get(i).copied()).unwrap_or(0)
    }

    /// Triangles that the engine skipped.
    #[must_use]
    pub fn skipped(&self) -> u16 {
        self.engine.skipped
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &CoreInputs) {
        let engine = self.engine.outputs();
        let core = self.core.outputs();
        let (mask, word) = (i.select >> 4, i.select & 15);
        let frame = mask == 0 && word & 8 != 0;
        let group = match mask.trailing_zeros() {
            0 => 16,
            1 => 24,
            2 => 32,
            3 => 8,
            _ => 0,
        };
        let accept = i.write && engine.load_ready;
        let raw = (accept && !frame).then_some((group | word & 7, i.data));
        let of_frame = (accept && frame).then_some((usize::from(word), i.data));
        let sent = engine.word.or(of_frame.map(|(_, data)| (i.select, data)));
        if engine.start && core.load_ready {
            self.drawn.push(self.engine.begun);
        }
        self.was_busy = core.busy || engine.busy;
        self.core.clock(&CoreInputs {
            write: sent.is_some(),
            select: sent.map_or(0, |s| s.0),
            data: sent.map_or(0, |s| s.1),
            start: engine.start,
            clear: i.clear && !engine.busy,
            ready: i.ready,
        });
        self.engine.clock(&EngineInputs {
            write: raw,
            frame: of_frame,
            start: i.start,
            ready: core.load_ready,
        });
    }
}
