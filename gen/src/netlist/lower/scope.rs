//! What names mean inside a module: signals, registers, ports of instances, variants of enumerations, loop indices.
//!
//! rust-hdl's tree spells a name as the description does, with `$` between its parts (`total$q`, `span$bus$ready`,
//! `lane[i+1]$value`, `State$Idle`). The netlist's names are the same with `_` for `$`.

use crate::netlist::read::{literal_code, RawAtom, RawNode};
use crate::netlist::{Format, Name, NetlistError, Target};
use rust_hdl_core::prelude::AtomKind;
use rust_hdl_core::type_descriptor::{TypeDescriptor, TypeKind};
use std::collections::BTreeMap;

/// A name that is read: what it stands for.
pub enum Meaning {
    /// A signal, register or port, with its type.
    Value(Name, Format, TypeDescriptor),
    /// A variant of an enumeration: its code, its width and how the description spells it.
    Variant(u128, usize, String),
    /// A loop index.
    Index(u128),
}

/// Names of one module.
pub struct Scope<'a> {
    /// Name of the module, for errors.
    pub module: &'a str,
    node: &'a RawNode,
    /// The enumerations in sight: their variants as `Type$Variant`; `None` when two of one name differ.
    enumerations: BTreeMap<String, Option<Vec<String>>>,
    loops: Vec<(String, u128)>,
}

/// The netlist's spelling of a raw name.
pub fn plain(name: &str) -> String {
    name.replace('$', "_")
}

fn collect_variants(d: &TypeDescriptor, into: &mut BTreeMap<String, Option<Vec<String>>>) {
    match &d.kind {
        TypeKind::Enum(variants) => {
            let list: Vec<String> = variants.iter().map(|v| v.replace("::", "$")).collect();
            let known = into
                .entry(d.name.clone())
                .or_insert_with(|| Some(list.clone()));
            if known.as_ref() != Some(&list) {
                *known = None;
            }
        }
        TypeKind::Composite(fields) => fields.iter().for_each(|f| collect_variants(&f.kind, into)),
        _ => {}
    }
}

fn is_port(atom: &&RawAtom) -> bool {
    matches!(
        atom.kind,
        AtomKind::InputParameter | AtomKind::OutputParameter
    )
}

impl<'a> Scope<'a> {
    /// The scope of a module.
    pub fn new(module: &'a str, node: &'a RawNode) -> Self {
        let mut enumerations = BTreeMap::new();
        let own = node.atoms.iter();
        let inner = node.children.iter().flat_map(|c| c.atoms.iter());
        for atom in own.chain(inner.filter(is_port)) {
            collect_variants(&atom.descriptor, &mut enumerations);
        }
        Self {
            module,
            node,
            enumerations,
            loops: vec![],
        }
    }

    /// An error in this module.
    pub fn error(&self, what: impl Into<String>) -> NetlistError {
        NetlistError::new(self.module, what)
    }

    /// Enters an iteration of a loop.
    pub fn enter(&mut self, index: &str, value: u128) {
        self.loops.push((index.to_string(), value));
    }

    /// Leaves it.
    pub fn leave(&mut self) {
        self.loops.pop();
    }

    /// Code and width of a variant, spelt `Type$Variant`, and how many variants its enumeration has. `None` when no
    /// enumeration in sight has it, or two different ones of that name.
    pub fn variant(&self, path: &str) -> Option<(u128, usize, usize)> {
        let (name, _) = path.split_once('$')?;
        let list = self.enumerations.get(name)?.as_ref()?;
        let code = list.iter().position(|v| v == path)?;
        let width = rust_hdl_core::bits::clog2(list.len());
        Some((code as u128, width, list.len()))
    }

    /// Whether two different enumerations of this name are in sight.
    fn ambiguous(&self, path: &str) -> bool {
        let name = path.split('$').next().unwrap_or_default();
        matches!(self.enumerations.get(name), Some(None))
    }

    /// What to say of a name that is no variant.
    pub fn not_a_variant(&self, path: &str) -> String {
        let spelt = path.replace('$', "::");
        if self.ambiguous(path) {
            return format!("{spelt}: two different enumerations of that name are in sight");
        }
        format!("pattern {spelt} is neither a number nor a variant in sight")
    }

    /// The raw name behind a spelling: array positions evaluated, separators unified.
    pub fn resolve(&self, spelt: &str) -> Result<String, NetlistError> {
        let text = spelt
            .trim_start_matches('.')
            .replace('.', "$")
            .replace("::", "$");
        let mut text = text.strip_suffix("$next").unwrap_or(&text).to_string();
        while let Some(open) = text.find('[') {
            let close = text[open..]
                .find(']')
                .map(|c| open + c)
                .ok_or_else(|| self.error(format!("{spelt}: bracket is not closed")))?;
            let position = self.position(&text[open + 1..close]).map_err(|why| {
                self.error(format!(
                    "{spelt}: the position {} is not a constant ({why}); a run-time choice between instances is written as `if`s",
                    &text[open + 1..close]
                ))
            })?;
            text.replace_range(open..=close, &format!("${position}"));
        }
        Ok(text)
    }

    fn position(&self, text: &str) -> Result<u128, String> {
        let e: syn::Expr = syn::parse_str(text).map_err(|e| e.to_string())?;
        self.constant(&e)
            .ok_or_else(|| "numbers and loop indices only".to_string())
    }

    /// The value of an array position.
    fn constant(&self, e: &syn::Expr) -> Option<u128> {
        match e {
            syn::Expr::Paren(inner) => self.constant(&inner.expr),
            syn::Expr::Lit(l) => match &l.lit {
                syn::Lit::Int(i) => i.base10_parse().ok(),
                _ => None,
            },
            syn::Expr::Path(p) => {
                let name = p.path.get_ident()?.to_string();
                self.loops
                    .iter()
                    .rev()
                    .find(|(n, _)| *n == name)
                    .map(|(_, v)| *v)
            }
            syn::Expr::Binary(b) => {
                let (x, y) = (self.constant(&b.left)?, self.constant(&b.right)?);
                match b.op {
                    syn::BinOp::Add(_) => x.checked_add(y),
                    syn::BinOp::Sub(_) => x.checked_sub(y),
                    syn::BinOp::Mul(_) => x.checked_mul(y),
                    syn::BinOp::Div(_) => x.checked_div(y),
                    syn::BinOp::Rem(_) => x.checked_rem(y),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    fn child_port(&self, raw: &str) -> Option<(&RawNode, &RawAtom)> {
        self.node.children.iter().find_map(|c| {
            let port = raw.strip_prefix(c.name.as_str())?.strip_prefix('$')?;
            Some((c, c.atom(port)?))
        })
    }

    fn format(&self, raw: &str, d: &TypeDescriptor) -> Result<Format, NetlistError> {
        format_of(d).map_err(|why| self.error(format!("signal {}: {why}", plain(raw))))
    }

    /// What a name stands for when it is read.
    pub fn read(&self, spelt: &str) -> Result<Meaning, NetlistError> {
        if let Some((_, value)) = self.loops.iter().rev().find(|(n, _)| n == spelt) {
            return Ok(Meaning::Index(*value));
        }
        let raw = self.resolve(spelt)?;
        if let Some(atom) = self.node.atom(&raw) {
            let format = self.format(&raw, &atom.descriptor)?;
            let name = Name::Signal(plain(&raw));
            return Ok(Meaning::Value(name, format, atom.descriptor.clone()));
        }
        if let Some((code, width, _)) = self.variant(&raw) {
            return Ok(Meaning::Variant(code, width, raw));
        }
        if self.ambiguous(&raw) {
            return Err(self.error(self.not_a_variant(&raw)));
        }
        let (child, port) = self.child_port(&raw).ok_or_else(|| {
            self.error(format!(
                "{spelt} is not a signal of this module (a Rust constant must be a field of type Constant)"
            ))
        })?;
        let format = self.format(&raw, &port.descriptor)?;
        if child.register().is_some() {
            return match port.name.as_str() {
                "q" => Ok(Meaning::Value(
                    Name::Register(plain(&child.name)),
                    format,
                    port.descriptor.clone(),
                )),
                other => Err(self.error(format!(
                    "{other} of register {} is read; only its q can be",
                    plain(&child.name)
                ))),
            };
        }
        let name = Name::Port {
            child: plain(&child.name),
            port: plain(&port.name),
        };
        if port.kind == AtomKind::InputParameter {
            return Err(self.error(format!(
                "{spelt} is an input of an instance; read what drives it"
            )));
        }
        Ok(Meaning::Value(name, format, port.descriptor.clone()))
    }

    /// What a name stands for when it is driven. `None` for the clock of a register, which is named instead.
    pub fn driven(&self, spelt: &str) -> Result<Driven, NetlistError> {
        let raw = self.resolve(spelt)?;
        if let Some(atom) = self.node.atom(&raw) {
            let format = self.format(&raw, &atom.descriptor)?;
            return match atom.kind {
                AtomKind::OutputParameter | AtomKind::LocalSignal => Ok(Driven::Target(
                    Target::Wire(Name::Signal(plain(&raw))),
                    format,
                    atom.descriptor.clone(),
                )),
                _ => Err(self.error(format!(
                    "cannot assign to {}: it is not an output or a wire",
                    plain(&raw)
                ))),
            };
        }
        let (child, port) = self
            .child_port(&raw)
            .ok_or_else(|| self.error(format!("cannot assign to {spelt}: no such signal")))?;
        let format = self.format(&raw, &port.descriptor)?;
        if child.register().is_some() {
            let name = plain(&child.name);
            return match port.name.as_str() {
                "d" => Ok(Driven::Target(
                    Target::Register(name),
                    format,
                    port.descriptor.clone(),
                )),
                "clock" => Ok(Driven::RegisterClock(name)),
                _ => Err(self.error(format!("cannot assign to the output of register {name}"))),
            };
        }
        if port.kind != AtomKind::InputParameter {
            return Err(self.error(format!(
                "cannot assign to {}: it is not an input of {}",
                plain(&port.name),
                plain(&child.name)
            )));
        }
        let name = Name::Port {
            child: plain(&child.name),
            port: plain(&port.name),
        };
        Ok(Driven::Target(
            Target::Wire(name),
            format,
            port.descriptor.clone(),
        ))
    }
}

/// A name that is driven.
pub enum Driven {
    /// A wire, output, instance input or register, with its type.
    Target(Target, Format, TypeDescriptor),
    /// The clock of this register.
    RegisterClock(String),
}

/// The format of a type, or why it has none.
pub fn format_of(d: &TypeDescriptor) -> Result<Format, String> {
    Format::from_descriptor(d).ok_or_else(|| {
        format!(
            "{} is not a type of 1 to {} bits that the netlist knows",
            d.name,
            crate::netlist::MAX_WIDTH
        )
    })
}

/// The code of a constant.
pub fn constant_code(value: &str) -> Option<u128> {
    literal_code(value)
}
