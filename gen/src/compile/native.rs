//! Generated code in memory, and the calls into it: the one place of the project that is `unsafe`.
#![allow(unsafe_code)]

use super::emit::emit;
use super::graph::Graph;
use super::layout::Layout;
use super::plan::Plan;
use cranelift_codegen::ir::{types, AbiParam, InstBuilder};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_codegen::Context;
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{default_libcall_names, Linkage, Module as _};

/// A compiled function of the state.
type Entry = extern "C" fn(*mut u64);

/// Functions over one layout of the state.
pub(super) struct Native {
    /// `Some` until dropped.
    module: Option<JITModule>,
    entries: Vec<Entry>,
    /// Words of the state that the functions were compiled for.
    words: usize,
}

fn module() -> Result<JITModule, String> {
    let mut flags = settings::builder();
    for (name, value) in [
        ("opt_level", "speed"),
        ("use_colocated_libcalls", "false"),
        ("is_pic", "false"),
        ("unwind_info", "false"),
        ("enable_verifier", "false"),
        ("enable_probestack", "false"),
        ("enable_table_access_spectre_mitigation", "false"),
    ] {
        flags.set(name, value).map_err(|e| e.to_string())?;
    }
    let isa = cranelift_native::builder()?;
    let isa = isa.finish(settings::Flags::new(flags));
    let isa = isa.map_err(|e| e.to_string())?;
    Ok(JITModule::new(JITBuilder::with_isa(
        isa,
        default_libcall_names(),
    )))
}

impl Native {
    /// Compiles functions, each a sequence of plans.
    pub(super) fn new(g: &Graph, l: &Layout, functions: &[&[&Plan]]) -> Result<Self, String> {
        let mut module = module()?;
        let (mut context, mut builder) = (Context::new(), FunctionBuilderContext::new());
        let mut ids = vec![];
        for (i, plans) in functions.iter().enumerate() {
            let pointer = module.target_config().pointer_type();
            if pointer != types::I64 {
                return Err("the compiled simulation needs a 64-bit processor".into());
            }
            context.func.signature = module.make_signature();
            context.func.signature.params.push(AbiParam::new(pointer));
            let mut code = FunctionBuilder::new(&mut context.func, &mut builder);
            let block = code.create_block();
            code.append_block_params_for_function_params(block);
            code.switch_to_block(block);
            let state = code.block_params(block)[0];
            for plan in *plans {
                emit(&mut code, state, g, plan, l)?;
            }
            code.ins().return_(&[]);
            code.seal_all_blocks();
            code.finalize(module.target_config());
            let signature = &context.func.signature;
            let id = module.declare_function(&format!("function_{i}"), Linkage::Local, signature);
            let id = id.map_err(|e| e.to_string())?;
            let defined = module.define_function(id, &mut context);
            defined.map_err(|e| format!("{e:?}"))?;
            ids.push(id);
            module.clear_context(&mut context);
        }
        module.finalize_definitions().map_err(|e| e.to_string())?;
        let entries = ids.iter().map(|id| {
            let address = module.get_finalized_function(*id);
            // SAFETY: the address is that of a function that was compiled above with the host's default calling
            // convention and the signature of `Entry`: one pointer, no result.
            unsafe { std::mem::transmute::<*const u8, Entry>(address) }
        });
        Ok(Self {
            entries: entries.collect(),
            module: Some(module),
            words: l.words,
        })
    }

    /// Calls a function, by its position among those compiled.
    ///
    /// # Panics
    /// If the state is not as long as the layout, which would be a defect of this crate.
    #[inline]
    pub(super) fn call(&self, function: usize, state: &mut [u64]) {
        assert!(state.len() >= self.words, "the state has its layout's size");
        // The code lives as long as `self` (it is freed in `drop`). It does nothing but load and store inside
        // `state[..words]`, which is exclusively borrowed and long enough by the line above: slots lie inside by
        // layout, and every index into a memory is compared with its number of words next to the access (see
        // `emit::access`). It calls nothing, and no operation that it is made of can trap.
        (self.entries[function])(state.as_mut_ptr());
    }
}

impl Drop for Native {
    fn drop(&mut self) {
        self.entries.clear();
        if let Some(module) = self.module.take() {
            // SAFETY: the pointers into the code are gone with `entries`, which never leave this type, and `self` is
            // exclusively borrowed, so nobody executes the code or will.
            unsafe { module.free_memory() };
        }
    }
}
