//! Equal instances share one module, and different modules have different names.
//!
//! A module is known by its text with every module name left out. Two descriptions of one name that differ, a generic
//! one in two widths, say, are told apart by four digits of the hash of that text: neither depends on the order of
//! instances, so nothing is renamed by an unrelated line.

use super::module::{hash, module_name};
use crate::netlist::{Module, NetlistError};
use std::collections::{BTreeMap, HashMap};

/// Stands for a module name in texts that are compared; no text of a module holds it.
const NAMELESS: &str = "\u{1}";

/// One module of the output.
pub struct Unit<'a> {
    /// One of its occurrences.
    pub module: &'a Module,
    /// The units of its instances, by instance name.
    pub children: BTreeMap<String, usize>,
    /// Its text without names.
    text: String,
}

/// The modules of a design, each once, instances before what instantiates them.
#[derive(Default)]
pub struct Shared<'a> {
    /// The modules.
    pub units: Vec<Unit<'a>>,
    known: HashMap<(Option<String>, String), usize>,
}

/// Prints a module under a name, its instances under others: head and body.
type Print<'p> =
    &'p dyn Fn(&Module, &str, &BTreeMap<String, String>) -> Result<(String, String), NetlistError>;

impl<'a> Shared<'a> {
    /// Adds a hierarchy; the unit of its top.
    ///
    /// # Errors
    /// What printing refuses.
    pub fn add(&mut self, m: &'a Module, print: Print<'_>) -> Result<usize, NetlistError> {
        let mut children = BTreeMap::new();
        for c in &m.children {
            children.insert(c.name.clone(), self.add(&c.module, print)?);
        }
        let of = |(child, unit): (&String, &usize)| (child.clone(), format!("{NAMELESS}{unit}"));
        let names = children.iter().map(of).collect();
        let (head, body) = print(m, NAMELESS, &names)?;
        // A module without remarks has no name of its own, only that of its place.
        let own = (!m.remarks.is_empty()).then(|| module_name(m));
        let text = head + &body;
        let next = self.units.len();
        let unit = *self.known.entry((own, text.clone())).or_insert(next);
        if unit == next {
            self.units.push(Unit {
                module: m,
                children,
                text,
            });
        }
        Ok(unit)
    }

    /// The name of every unit.
    pub fn names(&self) -> Vec<String> {
        let plain: Vec<String> = self.units.iter().map(|u| module_name(u.module)).collect();
        let alone = |name: &String| plain.iter().filter(|n| *n == name).count() == 1;
        let named = plain.iter().zip(&self.units).map(|(name, unit)| {
            if alone(name) {
                name.clone()
            } else {
                format!("{name}_{}", &hash(&[&self.outline(unit)])[..4])
            }
        });
        named.collect()
    }

    /// The text of a unit with the texts of its instances, whose numbers say nothing outside this design.
    fn outline(&self, unit: &Unit) -> String {
        let inner = unit
            .children
            .values()
            .map(|i| self.outline(&self.units[*i]));
        let inner: String = inner.collect();
        let text: String = unit
            .text
            .split(NAMELESS)
            .map(|t| t.trim_start_matches(|c: char| c.is_ascii_digit()))
            .collect();
        text + &inner
    }
}
