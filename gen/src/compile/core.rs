//! A core under the compiled simulation: the ports that all cores share, found once.

use super::{Input, Output, Simulator};
use crate::netlist::{collect, NetlistError};
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::lanes::LANE_PORTS;
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs};

/// A compiled core.
pub struct CompiledCore {
    simulator: Simulator,
    write: Input,
    select: Input,
    data: Input,
    start: Input,
    clear: Input,
    ready: Input,
    /// Write, select and data of each further lane.
    lanes: Vec<[Input; 3]>,
    load_ready: Output,
    valid: Output,
    x: Output,
    y: Output,
    red: Output,
    green: Output,
    blue: Output,
    depth: Output,
    busy: Output,
    done: Output,
}

impl CompiledCore {
    /// Compiles a core's description.
    ///
    /// # Errors
    /// What rust-hdl's checks, the netlist or [`Simulator::new`] refuse.
    pub fn new(core: Core) -> Result<Self, NetlistError> {
        let connected = CoreSimulator::new(core).map_err(|e| NetlistError::new(core.name(), e))?;
        Self::from_simulator(Simulator::new(&collect(connected.design())?)?)
    }

    /// Finds the ports of a compiled core.
    ///
    /// # Errors
    /// A port that the design does not have.
    pub fn from_simulator(s: Simulator) -> Result<Self, NetlistError> {
        let unknown = |e: super::UnknownSignal| NetlistError::new("core", e.to_string());
        let input = |name: &str| s.input(name).map_err(unknown);
        let output = |name: &str| s.output(name).map_err(unknown);
        let lane = |names: [&str; 3]| {
            let [write, select, data] = names.map(|n| s.input(n).ok());
            Some([write?, select?, data?])
        };
        let lanes = LANE_PORTS.into_iter().map_while(lane);
        Ok(Self {
            write: input("write")?,
            select: input("select")?,
            data: input("data")?,
            start: input("start")?,
            clear: input("clear")?,
            ready: input("ready")?,
            lanes: lanes.collect(),
            load_ready: output("load_ready")?,
            valid: output("valid")?,
            x: output("x")?,
            y: output("y")?,
            red: output("red")?,
            green: output("green")?,
            blue: output("blue")?,
            depth: output("depth")?,
            busy: output("busy")?,
            done: output("done")?,
            simulator: s,
        })
    }

    /// One clock with these inputs.
    #[inline]
    pub fn clock(&mut self, i: &CoreInputs) {
        let s = &mut self.simulator;
        s.set(self.write, u128::from(i.write));
        s.set(self.select, u128::from(i.select));
        s.set(self.data, u128::from(i.data));
        s.set(self.start, u128::from(i.start));
        s.set(self.clear, u128::from(i.clear));
        s.set(self.ready, u128::from(i.ready));
        for ([write, select, data], lane) in self.lanes.iter().zip(&i.more) {
            s.set(*write, u128::from(lane.write));
            s.set(*select, u128::from(lane.select));
            s.set(*data, u128::from(lane.data));
        }
        s.clock();
    }

    /// The outputs after the last clock. (They depend on state alone.)
    #[inline]
    #[must_use]
    pub fn outputs(&self) -> CoreOutputs {
        let get = |o: Output| self.simulator.get(o) as u64;
        CoreOutputs {
            load_ready: get(self.load_ready) != 0,
            valid: get(self.valid) != 0,
            x: get(self.x) as u16,
            y: get(self.y) as u16,
            rgb: [
                get(self.red) as u8,
                get(self.green) as u8,
                get(self.blue) as u8,
            ],
            depth: get(self.depth) as u16,
            busy: get(self.busy) != 0,
            done: get(self.done) != 0,
        }
    }

    /// The simulation behind it, for other signals.
    #[must_use]
    pub fn simulator(&mut self) -> &mut Simulator {
        &mut self.simulator
    }
}
