//! Scopes and variables from dotted names.

use std::collections::BTreeMap;
use std::io;

/// The variables of a scope and the scopes below it.
#[derive(Debug, Default)]
pub struct Tree {
    variables: Vec<(String, u32, usize)>,
    scopes: BTreeMap<String, Tree>,
}

/// A header that takes them.
pub trait Header {
    fn scope(&mut self, name: &str) -> io::Result<()>;
    fn up(&mut self) -> io::Result<()>;
    /// A variable of so many bits that shows a record; several may show one.
    fn variable(&mut self, name: &str, width: u32, record: usize) -> io::Result<()>;
}

impl Tree {
    /// Adds a variable by its dotted name.
    pub fn add(&mut self, name: &str, width: u32, record: usize) {
        match name.split_once('.') {
            Some((scope, rest)) => {
                let below = self.scopes.entry(scope.to_string()).or_default();
                below.add(rest, width, record);
            }
            None => self.variables.push((name.to_string(), width, record)),
        }
    }

    /// Writes the tree as a scope of this name.
    pub fn write(&self, name: &str, header: &mut impl Header) -> io::Result<()> {
        header.scope(name)?;
        for (name, width, record) in &self.variables {
            header.variable(name, *width, *record)?;
        }
        for (name, tree) in &self.scopes {
            tree.write(name, header)?;
        }
        header.up()
    }
}
