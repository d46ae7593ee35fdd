//! What cannot become a netlist or Verilog is refused with module, statement and reason, word for word.

mod conversions;
mod drivers;
mod elaboration;
mod names;

use rust_hdl_core::prelude::*;
use shadegate_gen::netlist::{collect, elaborate};
use shadegate_gen::verilog::emit;

/// What the netlist, else the printer, else the elaboration says of a description; inputs need not be connected for that.
fn refusal<T: Block + Default>() -> String {
    let mut design = T::default();
    design.connect_all();
    let module = match collect(&design) {
        Ok(module) => module,
        Err(e) => return e.to_string(),
    };
    let printed = emit(&module, "test").map(|_| ());
    match printed.and_then(|()| elaborate(&module).map(|_| ())) {
        Ok(()) => "not refused".to_string(),
        Err(e) => e.to_string(),
    }
}

/// Each description of a list is refused with its text.
macro_rules! refused {
    ($($type:ty => $text:literal),+ $(,)?) => {
        let wrong: Vec<(String, &str)> = [$(($crate::refusal::<$type>(), $text)),+]
            .into_iter()
            .filter(|(said, text)| said != text)
            .collect();
        assert!(wrong.is_empty(), "{wrong:#?}");
    };
}

/// A description with ports and wires by type, and its `update`.
macro_rules! circuit {
    ($name:ident { $($field:ident: $type:ty),+ } $($update:tt)*) => {
        #[derive(LogicBlock, Default)]
        struct $name {
            $($field: $type),+
        }
        impl Logic for $name {
            $($update)*
        }
    };
}

pub(crate) use {circuit, refused};
