//! What rust-hdl's probe shows of a connected description: a tree of scopes with their atoms and bodies, nothing judged.

use rust_hdl_core::ast::Verilog;
use rust_hdl_core::prelude::{Atom, AtomKind, Block, Probe};
use rust_hdl_core::type_descriptor::TypeDescriptor;

/// A signal or constant of a scope.
pub struct RawAtom {
    /// Name, with its interfaces and array positions in front, joined by `$`.
    pub name: String,
    /// Direction.
    pub kind: AtomKind,
    /// Type.
    pub descriptor: TypeDescriptor,
    /// Its value as rust-hdl prints it; a constant's is its code.
    pub value: String,
}

/// A scope: a module of the description, or one of rust-hdl's own blocks.
pub struct RawNode {
    /// Name of the field, array positions joined by `$`.
    pub name: String,
    /// Signals in order of declaration.
    pub atoms: Vec<RawAtom>,
    /// Body.
    pub hdl: Verilog,
    /// Scopes inside, in order of declaration.
    pub children: Vec<RawNode>,
}

#[derive(Default)]
struct Walker {
    stack: Vec<RawNode>,
    root: Option<RawNode>,
    namespaces: Vec<String>,
}

impl Probe for Walker {
    fn visit_start_scope(&mut self, name: &str, node: &dyn Block) {
        self.stack.push(RawNode {
            name: name.to_string(),
            atoms: vec![],
            hdl: node.hdl(),
            children: vec![],
        });
    }

    fn visit_start_namespace(&mut self, name: &str, _: &dyn Block) {
        self.namespaces.push(name.to_string());
    }

    fn visit_end_namespace(&mut self, _: &str, _: &dyn Block) {
        self.namespaces.pop();
    }

    fn visit_atom(&mut self, name: &str, atom: &dyn Atom) {
        let mut path = self.namespaces.clone();
        path.push(name.to_string());
        if let Some(node) = self.stack.last_mut() {
            node.atoms.push(RawAtom {
                name: path.join("$"),
                kind: atom.kind(),
                descriptor: atom.descriptor(),
                value: format!("{:x}", atom.verilog()),
            });
        }
    }

    fn visit_end_scope(&mut self, _: &str, _: &dyn Block) {
        if let Some(node) = self.stack.pop() {
            match self.stack.last_mut() {
                Some(parent) => parent.children.push(node),
                None => self.root = Some(node),
            }
        }
    }
}

impl RawNode {
    /// Reads a description; `None` when it is not a module at all.
    pub fn of(design: &dyn Block) -> Option<Self> {
        let mut walker = Walker::default();
        design.accept("top", &mut walker);
        walker.root
    }

    /// The atom of this name.
    pub fn atom(&self, name: &str) -> Option<&RawAtom> {
        self.atoms.iter().find(|a| a.name == name)
    }

    /// The code at power-up, if this is a D flip-flop: exactly `d`, `q`, `clock`, and a body that says `q <= d`.
    pub fn register(&self) -> Option<u128> {
        let mut names: Vec<&str> = self.atoms.iter().map(|a| a.name.as_str()).collect();
        names.sort_unstable();
        let Verilog::Custom(text) = &self.hdl else {
            return None;
        };
        if names != ["clock", "d", "q"] || !self.children.is_empty() {
            return None;
        }
        let words: Vec<&str> = text.split_whitespace().collect();
        let value = words.get(4)?.strip_suffix(';')?;
        let shape =
            format!("initial begin q = {value}; end always @(posedge clock) begin q <= d; end");
        (words.join(" ") == shape).then(|| literal_code(value))?
    }
}

/// The code of a literal as rust-hdl prints it, `width'hdigits` or `width'bdigits`. (It keeps the number private.)
pub fn literal_code(text: &str) -> Option<u128> {
    let (radix, digits) = match text.split_once('\'') {
        Some((_, d)) if d.starts_with('b') => (2, &d[1..]),
        Some((_, d)) => (16, d.strip_prefix('h')?),
        None => (10, text),
    };
    u128::from_str_radix(digits, radix).ok()
}

#[cfg(test)]
mod tests {
    use super::literal_code;

    #[test]
    fn literals_are_read() {
        assert_eq!(literal_code("8'hff"), Some(255));
        assert_eq!(literal_code("3'b101"), Some(5));
        assert_eq!(literal_code("17"), Some(17));
        assert_eq!(literal_code("8'h-1"), None);
        assert_eq!(literal_code(""), None);
    }
}
