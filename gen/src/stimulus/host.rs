//! The host: one register write per clock whenever the core takes it, the last write of a triangle with `start`.

use super::Stimulus;
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs};

/// What the host does in a clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Inputs to present.
    Drive(CoreInputs),
    /// Everything is sent and the core is idle.
    Finished,
}

/// Feeds a stimulus to a core, reacting to `load_ready`.
#[derive(Clone, Debug)]
pub struct Host<'a> {
    stimulus: &'a Stimulus,
    frame: usize,
    primitive: usize,
    write: usize,
}

impl<'a> Host<'a> {
    /// A host at the first write.
    #[must_use]
    pub fn new(stimulus: &'a Stimulus) -> Self {
        Self {
            stimulus,
            frame: 0,
            primitive: 0,
            write: 0,
        }
    }

    /// Everything is written; the core may still be drawing.
    #[must_use]
    pub fn sent(&self) -> bool {
        self.frame == self.stimulus.frame.len() && self.primitive == self.stimulus.primitives.len()
    }

    /// The inputs for the next clock, given the outputs before it; `ready` is the consumer's.
    pub fn step(&mut self, outputs: &CoreOutputs, ready: bool) -> Step {
        let mut inputs = CoreInputs {
            ready,
            ..CoreInputs::default()
        };
        if self.sent() {
            return if outputs.busy {
                Step::Drive(inputs)
            } else {
                Step::Finished
            };
        }
        if !outputs.load_ready {
            return Step::Drive(inputs);
        }
        if let Some((select, data)) = self.stimulus.frame.get(self.frame) {
            self.frame += 1;
            inputs = CoreInputs {
                write: true,
                select: *select,
                data: *data,
                ..inputs
            };
            return Step::Drive(inputs);
        }
        let p = &self.stimulus.primitives[self.primitive];
        if let Some((select, data)) = p.writes.get(self.write) {
            self.write += 1;
            inputs = CoreInputs {
                write: true,
                select: *select,
                data: *data,
                ..inputs
            };
        }
        if self.write == p.writes.len() {
            inputs.start = true;
            self.primitive += 1;
            self.write = 0;
        }
        Step::Drive(inputs)
    }
}
