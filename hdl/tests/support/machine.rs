//! A core under simulation, a host that writes whenever it may, and what comes out.

use super::{material, Triangle};
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs, Order};
use shadegate_reference::raster::Viewport;

/// What a core says about a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// Column.
    pub x: u16,
    /// Row.
    pub y: u16,
    /// Colour.
    pub rgb: [u8; 3],
    /// Depth.
    pub depth: u16,
}

impl Pixel {
    /// The pixel on offer.
    pub fn offered(o: &CoreOutputs) -> Self {
        Self {
            x: o.x,
            y: o.y,
            rgb: o.rgb,
            depth: o.depth,
        }
    }
}

/// The pixels taken in a trace of [`Machine::draw`].
pub fn taken(trace: &[CoreOutputs], ready: impl Fn(usize) -> bool) -> Vec<Pixel> {
    let clocks = trace.iter().enumerate();
    clocks
        .filter(|(t, o)| o.valid && ready(*t))
        .map(|(_, o)| Pixel::offered(o))
        .collect()
}

/// Checks that `done` is one in exactly the clocks in which `busy` has just fallen; returns how often.
pub fn check_done(trace: &[CoreOutputs]) -> usize {
    for (t, pair) in trace.windows(2).enumerate() {
        let falls = pair[0].busy && !pair[1].busy;
        assert_eq!(pair[1].done, falls, "clock {t}");
    }
    trace.iter().filter(|o| o.done).count()
}

/// A core under simulation with its frame width set.
pub struct Machine {
    core: CoreSimulator,
    /// Which core.
    pub kind: Core,
    /// Its frame.
    pub size: Viewport,
}

impl Machine {
    /// A core for a frame.
    pub fn new(order: Order, width: u32, height: u32) -> Self {
        let kind = Core::for_frame(order, width, height).unwrap();
        let mut core = CoreSimulator::new(kind).unwrap();
        let mut write = |select, data| {
            core.clock(&CoreInputs {
                write: core.outputs().load_ready,
                select,
                data,
                ..CoreInputs::default()
            });
        };
        write(11, u64::from(width));
        for (select, data) in material::writes(order) {
            write(select, data);
            if select == 12 {
                // The fence of an idle core takes a clock.
                write(select, data);
            }
        }
        Self {
            core,
            kind,
            size: Viewport { width, height },
        }
    }

    /// One clock.
    pub fn clock(&mut self, i: &CoreInputs) {
        self.core.clock(i);
    }

    /// The outputs now.
    pub fn outputs(&self) -> CoreOutputs {
        self.core.outputs()
    }

    /// One clock of a host that does nothing and takes pixels.
    pub fn idle(&mut self) {
        self.clock(&CoreInputs {
            ready: true,
            ..CoreInputs::default()
        });
    }

    /// Draws triangles with a host that writes whenever it may; `ready` decides per clock. Returns the outputs of
    /// every clock until the core is idle.
    pub fn draw(
        &mut self,
        triangles: &[Triangle],
        mut ready: impl FnMut(usize) -> bool,
    ) -> Vec<CoreOutputs> {
        let order = self.kind.order;
        let mut words: Vec<(u8, u64, bool)> = vec![];
        for t in triangles {
            let writes = t.writes(order, self.size);
            let last = writes.len().wrapping_sub(1);
            words.extend(
                writes
                    .iter()
                    .enumerate()
                    .map(|(i, w)| (w.0, w.1, i == last)),
            );
        }
        let mut words = words.into_iter().peekable();
        let mut trace = vec![];
        loop {
            let before = self.outputs();
            let mut i = CoreInputs {
                ready: ready(trace.len()),
                ..CoreInputs::default()
            };
            if before.load_ready {
                if let Some((select, data, start)) = words.next() {
                    i.write = true;
                    (i.select, i.data, i.start) = (select, data, start);
                }
            }
            trace.push(before);
            self.clock(&i);
            if words.peek().is_none() && !self.outputs().busy && !i.start {
                trace.push(self.outputs());
                return trace;
            }
            assert!(trace.len() < 1_000_000, "the core never gets idle");
        }
    }
}
