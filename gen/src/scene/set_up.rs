//! Who sets triangles up: the host, or an engine in front of the core.

use shadegate_hdl::shade::model::Order;

/// Cores with a set-up engine: name, core, the core that the host sets up.
pub const ENGINES: [(&str, Order, Order); 1] =
    [("quadratic-engine", Order::QuadraticEngine, Order::Quadratic)];

/// Who sets triangles up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SetUp {
    /// The host, which sends register words.
    #[default]
    Host,
    /// An engine, to which the host sends corners and knots.
    Engine,
}

impl SetUp {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Host, Self::Engine];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Host => "host",
            Self::Engine => "engine",
        }
    }

    /// The core that draws what the core `order` draws, set up in this way; `None` if there is none.
    #[must_use]
    pub fn of(self, order: Order) -> Option<Order> {
        match self {
            Self::Host => Some(order),
            Self::Engine => ENGINES.iter().find(|e| e.2 == order).map(|e| e.1),
        }
    }
}
