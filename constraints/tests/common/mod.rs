//! A request that owns its parts, for the tests to change one thing at a time.

use shadegate_constraints::{
    board, default_bindings, device, emit, Binding, Board, ConstraintFile, Device, Direction, Port,
    Request,
};

/// The ports of a small core with a pixel stream.
pub fn ports() -> Vec<Port> {
    use Direction::{Input, Output};
    vec![
        Port::new("clock", 1, Input),
        Port::new("reset", 1, Input),
        Port::new("start", 1, Input),
        Port::new("busy", 1, Output),
        Port::new("done", 1, Output),
        Port::new("pixel", 24, Output),
        Port::new("flags", 4, Output),
    ]
}

pub struct Case {
    pub design: &'static str,
    pub device: &'static Device,
    pub board: Option<&'static Board>,
    pub ports: Vec<Port>,
    pub clock_port: &'static str,
    pub period_ns: f64,
    pub bindings: Vec<Binding>,
}

impl Case {
    pub fn on_board(name: &str, period_ns: f64) -> Self {
        let board = board(name).unwrap();
        let bindings = default_bindings(board, &ports(), "clock", period_ns);
        Case {
            design: "quadratic",
            device: device(&board.device).unwrap(),
            board: Some(board),
            ports: ports(),
            clock_port: "clock",
            period_ns,
            bindings,
        }
    }

    pub fn bare(name: &str, period_ns: f64) -> Self {
        Case {
            design: "gouraud",
            device: device(name).unwrap(),
            board: None,
            ports: ports(),
            clock_port: "clock",
            period_ns,
            bindings: Vec::new(),
        }
    }

    pub fn bound(mut self, more: impl IntoIterator<Item = Binding>) -> Self {
        self.bindings.extend(more);
        self
    }

    pub fn run(&self) -> Result<ConstraintFile, String> {
        emit(&Request {
            design: self.design,
            device: self.device,
            board: self.board,
            ports: &self.ports,
            clock_port: self.clock_port,
            period_ns: self.period_ns,
            bindings: &self.bindings,
        })
        .map_err(|e| e.to_string())
    }
}
