//! The simulator: handles, values, clocks.

use super::graph::{Graph, Op, ValueId};
use super::handle::{Input, Memory, Output, Place, Signal};
use super::item;
use super::layout::{Layout, Slot, Words};
use super::lower::Values;
use super::merge::merge;
use super::names::{Named, Names, UnknownSignal};
use super::native::Native;
use super::plan::Plan;
use crate::netlist::{elaborate, Driver, Flat, Format, Module, NetlistError, SignalId};

/// Positions of the compiled functions.
const CLOCK: usize = 0;
const SETTLE: usize = 1;

/// A compiled design and its state. It starts at power-up with all inputs zero and settled.
pub struct Simulator {
    clock: Option<String>,
    native: Native,
    state: Vec<u64>,
    power_up: Vec<u64>,
    inputs: Names<Slot>,
    outputs: Names<Slot>,
    signals: Names<Place>,
    memories: Names<Words>,
    graph: Graph,
    layout: Layout,
    /// Every wire that has a place, and the function that keeps them, compiled when first asked for.
    wires: Vec<ValueId>,
    keep: Option<Native>,
    /// The wires' places are up to date.
    kept: bool,
}

impl Simulator {
    /// Elaborates and compiles a design.
    ///
    /// # Errors
    /// What [`elaborate`] refuses; a state that is too large; a processor that no code can be made for.
    pub fn new(module: &Module) -> Result<Self, NetlistError> {
        Self::from_flat(&elaborate(module)?)
    }

    /// Compiles an elaborated design.
    ///
    /// # Errors
    /// As [`Simulator::new`], but for elaboration.
    pub fn from_flat(flat: &Flat<'_>) -> Result<Self, NetlistError> {
        let fail = |what: String| NetlistError::new(&flat.name, what);
        let mut values = Values::new(flat);
        let items = item::edge(&mut values);
        let ids = || (0..flat.signals.len() as u32).map(SignalId);
        let valued = ids().filter(|id| flat.driver(*id) != Driver::Clock);
        let of: Vec<(SignalId, ValueId)> = valued.map(|id| (id, values.signal(id))).collect();
        let graph = values.graph;
        let loads = ids().filter(|id| match flat.signals[id.index()].driver {
            Driver::Input | Driver::Register(_) => true,
            Driver::Memory(m) => flat.memories[m.index()].memory.read.clock.is_some(),
            _ => false,
        });
        let outputs: Vec<ValueId> = of
            .iter()
            .filter(|(id, _)| flat.signals[id.index()].output)
            .map(|(_, v)| *v)
            .collect();
        let wires: Vec<ValueId> = of.iter().map(|(_, v)| *v).collect();
        let kept = outputs.iter().chain(&wires).copied();
        let layout = Layout::new(flat, &graph, loads, kept)?;

        let edge = Plan::edge(&graph, &merge(&graph, items));
        let show = Plan::keep(&graph, &outputs);
        let native = Native::new(&graph, &layout, &[&[&edge, &show], &[&show]]).map_err(fail)?;

        let power_up = power_up(flat, &layout);
        let place =
            |v: ValueId, wire: fn(Slot) -> Place| match (graph.op(v), layout.value(&graph, v)) {
                (Op::Constant(code), _) => Place::Constant(code),
                (Op::Load(_), Some(slot)) => Place::State(slot),
                (_, Some(slot)) => wire(slot),
                (_, None) => Place::Constant(0),
            };
        let named = |id: SignalId, place: Place| {
            let s = &flat.signals[id.index()];
            Named {
                name: s.name.clone(),
                format: s.format,
                place,
            }
        };
        let is_output = |v: ValueId| outputs.contains(&v);
        let signals = of.iter().map(|(id, v)| {
            let wire = if is_output(*v) {
                Place::State
            } else {
                Place::Wire
            };
            named(*id, place(*v, wire))
        });
        let output_list = of.iter().filter(|(id, _)| flat.signals[id.index()].output);
        let output_list = output_list.filter_map(|(id, v)| {
            let slot = layout.value(&graph, *v)?;
            let s = &flat.signals[id.index()];
            Some(Named {
                name: s.name.clone(),
                format: s.format,
                place: slot,
            })
        });
        let inputs = of.iter().filter_map(|(id, _)| {
            let s = &flat.signals[id.index()];
            let slot = layout.signal(*id)?;
            (s.driver == Driver::Input).then(|| Named {
                name: s.name.clone(),
                format: s.format,
                place: slot,
            })
        });
        let memories = flat
            .memories
            .iter()
            .zip(&layout.memories)
            .map(|(m, w)| Named {
                name: m.name.clone(),
                format: Format::Unsigned(m.memory.width),
                place: *w,
            });
        let clock = flat.clock.map(|c| flat.signals[c.index()].name.clone());
        let mut simulator = Self {
            clock,
            native,
            state: power_up.clone(),
            power_up,
            inputs: Names::new("input", inputs.collect()),
            outputs: Names::new("output", output_list.collect()),
            signals: Names::new("signal", signals.collect()),
            memories: Names::new("memory", memories.collect()),
            wires,
            keep: None,
            kept: false,
            graph,
            layout,
        };
        simulator.settle();
        Ok(simulator)
    }

    /// An input by name. The clock is none: [`Simulator::clock`] is its edge.
    ///
    /// # Errors
    /// An unknown name, with the nearest known ones.
    pub fn input(&self, name: &str) -> Result<Input, UnknownSignal> {
        self.inputs.find(name).map(Input)
    }

    /// An output by name.
    ///
    /// # Errors
    /// An unknown name, with the nearest known ones.
    pub fn output(&self, name: &str) -> Result<Output, UnknownSignal> {
        self.outputs.find(name).map(Output)
    }

    /// Any wire, register, constant or instance port by its dotted name, such as `shell.walk.column`.
    ///
    /// # Errors
    /// An unknown name, with the nearest known ones.
    pub fn signal(&self, path: &str) -> Result<Signal, UnknownSignal> {
        self.signals.find(path).map(Signal)
    }

    /// A memory by the dotted name of its instance.
    ///
    /// # Errors
    /// An unknown name, with the nearest known ones.
    pub fn memory(&self, path: &str) -> Result<Memory, UnknownSignal> {
        self.memories.find(path).map(Memory)
    }

    /// Every signal: dotted name, format, handle; in order of the hierarchy.
    pub fn signals(&self) -> impl Iterator<Item = (&str, Format, Signal)> {
        let all = self.signals.iter();
        all.map(|n| (n.name.as_str(), n.format, Signal(n.place)))
    }

    /// The name of the clock input.
    #[must_use]
    pub fn clock_name(&self) -> Option<&str> {
        self.clock.as_deref()
    }

    /// Presents a code at an input; bits beyond its width are dropped. Seen by the next clock or settling.
    #[inline]
    pub fn set(&mut self, input: Input, code: u128) {
        input.0.set(&mut self.state, code);
        self.kept = false;
    }

    /// The code of an output, as of the last clock or settling.
    #[inline]
    #[must_use]
    pub fn get(&self, output: Output) -> u128 {
        output.0.get(&self.state)
    }

    /// The code of any signal: registers and inputs as they are, wires and outputs as these imply.
    pub fn peek(&mut self, signal: Signal) -> Result<u128, NetlistError> {
        if matches!(signal.0, Place::Wire(_)) {
            self.settle_all()?;
        }
        Ok(signal.0.get(&self.state))
    }

    /// A word of a memory; `None` beyond its last.
    #[must_use]
    pub fn word(&self, memory: Memory, address: usize) -> Option<u128> {
        (address < memory.0.count).then(|| memory.0.get(&self.state, address))
    }

    /// One rising edge with the inputs as they are; then the outputs show the new state.
    #[inline]
    pub fn clock(&mut self) {
        self.native.call(CLOCK, &mut self.state);
        self.kept = false;
    }

    /// Brings the outputs up to date with the inputs.
    #[inline]
    pub fn settle(&mut self) {
        self.native.call(SETTLE, &mut self.state);
    }

    /// Brings every wire up to date.
    ///
    /// # Errors
    /// The first call compiles a function, which the processor may refuse.
    pub fn settle_all(&mut self) -> Result<(), NetlistError> {
        if self.kept {
            return Ok(());
        }
        if self.keep.is_none() {
            let plan = Plan::keep(&self.graph, &self.wires);
            let native = Native::new(&self.graph, &self.layout, &[&[&plan]]);
            self.keep = Some(native.map_err(|e| NetlistError::new("simulation", e))?);
        }
        if let Some(keep) = &self.keep {
            keep.call(0, &mut self.state);
        }
        self.kept = true;
        Ok(())
    }

    /// Back to power-up: registers and memories have their initial codes, all inputs are zero.
    pub fn power_up(&mut self) {
        self.state.copy_from_slice(&self.power_up);
        self.kept = false;
        self.settle();
    }
}

/// The state at power-up.
fn power_up(flat: &Flat<'_>, layout: &Layout) -> Vec<u64> {
    let mut state = vec![0; layout.words];
    for (i, s) in flat.signals.iter().enumerate() {
        if let (Driver::Register(code), Some(slot)) = (s.driver, layout.signal(SignalId(i as u32)))
        {
            slot.set(&mut state, code);
        }
    }
    for (m, words) in flat.memories.iter().zip(&layout.memories) {
        for (address, code) in m.memory.initial.iter().enumerate() {
            words.set(&mut state, address, *code);
        }
    }
    state
}
