//! The host: register writes whenever the core takes them, as many per clock as it can, the last of a triangle with
//! `start`.

use super::{clocks, Stimulus};
use shadegate_hdl::shade::lanes::Lane;
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
    lanes: usize,
    frame: usize,
    primitive: usize,
    /// What is left of the primitive that is being written, clock by clock, the last clock first.
    writes: Vec<Vec<(u8, u64)>>,
}

impl<'a> Host<'a> {
    /// A host at the first write of a core that takes one word per clock.
    #[must_use]
    pub fn new(stimulus: &'a Stimulus) -> Self {
        Self::with_lanes(stimulus, 1)
    }

    /// A host at the first write of a core that takes `lanes` words per clock.
    #[must_use]
    pub fn with_lanes(stimulus: &'a Stimulus, lanes: usize) -> Self {
        Self {
            stimulus,
            lanes,
            frame: 0,
            primitive: 0,
            writes: vec![],
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
        if self.writes.is_empty() {
            let p = &self.stimulus.primitives[self.primitive];
            self.writes = clocks(&p.writes, self.lanes);
            self.writes.reverse();
        }
        let clock = self.writes.pop().unwrap_or_default();
        for (lane, (select, data)) in clock.into_iter().enumerate() {
            let write = true;
            match lane {
                0 => (inputs.write, inputs.select, inputs.data) = (write, select, data),
                _ => {
                    inputs.more[lane - 1] = Lane {
                        write,
                        select,
                        data,
                    }
                }
            }
        }
        if self.writes.is_empty() {
            inputs.start = true;
            self.primitive += 1;
        }
        Step::Drive(inputs)
    }
}
