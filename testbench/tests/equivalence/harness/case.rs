//! A description under test, from its Rust type to what every engine must answer.

use super::code::{Driven, Port};
use super::native;
use super::stimulus::{vectors, Vector};
use rust_hdl_core::prelude::check_all;
use shadegate_gen::netlist::{collect, Module};
use shadegate_gen::verilog::{check::check, emit, module_name, VerilogFile};
use std::rc::Rc;

/// Vectors per case.
pub const VECTORS: usize = 256;

/// Input vectors that one or several units share.
#[derive(Debug)]
pub struct Stimulus {
    /// The inputs, the clock apart.
    pub inputs: Vec<Port>,
    /// Codes per vector and input.
    pub vectors: Vec<Vec<u128>>,
}

/// A module with its stimulus and its expected outputs.
pub struct Unit {
    /// Name in reports.
    pub name: String,
    /// The netlist; all module names begin with the unit's.
    pub module: Module,
    /// Emitted files, the top module's last.
    pub files: Vec<VerilogFile>,
    /// The outputs.
    pub outputs: Vec<Port>,
    /// Inputs.
    pub stimulus: Rc<Stimulus>,
    /// It has a clock input called `clock`.
    pub clock: bool,
    /// What rust-hdl's simulation gave, per sample and output.
    pub expected: Vec<Vec<u128>>,
    /// Samples and outputs that rust-hdl leaves undefined.
    pub undefined: Box<dyn Fn(usize, usize) -> bool>,
}

impl Unit {
    /// The Verilog name of its top module.
    pub fn verilog_name(&self) -> String {
        module_name(&self.module)
    }
}

fn rename(module: &mut Module, prefix: &str) {
    module.name = format!("{prefix}_{}", module.name);
    for child in &mut module.children {
        rename(&mut child.module, prefix);
    }
}

/// The netlist and the checked text of a connected design, its module names made unique by a prefix.
///
/// # Errors
/// What the netlist, the printer or the text's check refuses.
pub fn translate(name: &str, design: &dyn Driven) -> Result<(Module, Vec<VerilogFile>), String> {
    let mut module = collect(design).map_err(|e| format!("{name}: {e}"))?;
    rename(&mut module, name);
    let files = emit(&module, "test").map_err(|e| format!("{name}: {e}"))?;
    for f in &files {
        check(&f.file_name(), &f.text).map_err(|e| format!("{name}: {e}"))?;
    }
    Ok((module, files))
}

/// A description that has not run yet.
pub struct Case {
    /// Name in reports, and prefix of its modules.
    pub name: String,
    design: Box<dyn Driven>,
    keep: Box<dyn Fn(&Vector) -> bool>,
}

fn snake(type_name: &str) -> String {
    let plain = type_name.split('<').next().unwrap_or_default();
    let plain = plain.rsplit("::").next().unwrap_or_default();
    let mut out = String::new();
    for c in plain.chars() {
        if c.is_uppercase() && !out.is_empty() {
            out.push('_');
        }
        out.extend(c.to_lowercase());
    }
    out
}

impl Case {
    /// A description named after its type.
    pub fn of<T: Driven + Default + 'static>() -> Self {
        Self::named(&snake(std::any::type_name::<T>()), T::default())
    }

    /// A description with a name.
    pub fn named<T: Driven + 'static>(name: &str, design: T) -> Self {
        Self {
            name: name.to_string(),
            design: Box::new(design),
            keep: Box::new(|_| true),
        }
    }

    /// Only vectors for which this holds; the others are undefined in rust-hdl's own simulation.
    pub fn keep(mut self, keep: impl Fn(&Vector) -> bool + 'static) -> Self {
        self.keep = Box::new(keep);
        self
    }

    /// What rust-hdl's own printer makes of it.
    pub fn rust_hdl_text(&mut self) -> String {
        self.design.connect_inputs();
        self.design.connect_all();
        self.design.rust_hdl_text()
    }

    /// Connects, checks, translates and simulates it.
    ///
    /// # Errors
    /// What rust-hdl's own check or the translation refuses.
    pub fn run(self) -> Result<Unit, String> {
        let inputs = self.design.inputs();
        let vectors = vectors(&self.name, &inputs, VECTORS, self.keep.as_ref());
        self.run_on(vectors)
    }

    /// The same, on these vectors.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub fn run_on(mut self, vectors: Vec<Vec<u128>>) -> Result<Unit, String> {
        let design = self.design.as_mut();
        design.connect_inputs();
        design.connect_all();
        check_all(design).map_err(|e| format!("{}: rust-hdl's check: {e:?}", self.name))?;
        let (module, files) = translate(&self.name, design)?;
        let inputs = design.inputs();
        let expected = native::run(design, &vectors, true);
        let outputs = native::outputs(design)
            .into_iter()
            .map(|(p, _)| p)
            .collect();
        Ok(Unit {
            name: self.name,
            module,
            files,
            outputs,
            clock: design.has_clock(),
            stimulus: Rc::new(Stimulus { inputs, vectors }),
            expected,
            undefined: Box::new(|_, _| false),
        })
    }
}
