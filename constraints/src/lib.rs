//! FPGA devices and boards as data, and the constraint files (UCF, XDC, PCF, LPF) that their tools need.
//!
//! This crate knows nothing of shading, scenes or hardware descriptions: it takes a device (or a
//! board), the ports of a top level and a clock period, and returns text.
//!
//! ```
//! use shadegate_constraints::{board, default_bindings, device, emit, Direction, Port, Request};
//!
//! let board = board("arty-s7-50").unwrap();
//! let ports = [Port::new("clock", 1, Direction::Input), Port::new("busy", 1, Direction::Output)];
//! let bindings = default_bindings(board, &ports, "clock", 10.0);
//! let file = emit(&Request {
//!     design: "blinker",
//!     device: device(&board.device).unwrap(),
//!     board: Some(board),
//!     ports: &ports,
//!     clock_port: "clock",
//!     period_ns: 10.0,
//!     bindings: &bindings,
//! })
//! .unwrap();
//! assert_eq!(file.name, "blinker.xdc");
//! assert!(file.text.contains("create_clock -name clock -period 10.000 [get_ports {clock}]"));
//! ```

mod board;
mod catalogue;
mod check;
mod device;
mod emit;
mod error;
mod lpf;
mod pcf;
mod request;
mod ucf;
mod xdc;

pub use board::{ActiveLevel, Board, InternalVref, Pull, Resource, ResourceKind};
pub use catalogue::{board, boards, device, devices};
pub use device::{Device, Format, Package, PackageShape};
pub use emit::{emit, ConstraintFile};
pub use error::{ConstraintError, UnknownName};
pub use request::{default_bindings, Binding, Direction, Port, Request};
