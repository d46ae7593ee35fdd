//! Names of a design and what is nearest to one that it does not have.

use crate::netlist::Format;
use std::collections::HashMap;

/// A name that the design does not have.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{kind} '{given}' is unknown{}", offer(.nearest))]
pub struct UnknownSignal {
    /// What was looked for: `input`, `output`, `signal`, `memory`.
    pub kind: &'static str,
    /// The name.
    pub given: String,
    /// Names that the design has, the nearest first; at most three.
    pub nearest: Vec<String>,
}

fn offer(nearest: &[String]) -> String {
    match nearest {
        [] => String::new(),
        names => format!("; nearest: {}", names.join(", ")),
    }
}

/// A named thing and where its value is found.
#[derive(Clone, Debug)]
pub(super) struct Named<T> {
    pub(super) name: String,
    pub(super) format: Format,
    pub(super) place: T,
}

/// Named things in order, found by name.
#[derive(Clone, Debug)]
pub(super) struct Names<T> {
    kind: &'static str,
    list: Vec<Named<T>>,
    index: HashMap<String, usize>,
}

impl<T: Copy> Names<T> {
    pub(super) fn new(kind: &'static str, list: Vec<Named<T>>) -> Self {
        let names = list.iter().enumerate();
        let index = names.map(|(i, n)| (n.name.clone(), i)).collect();
        Self { kind, list, index }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &Named<T>> {
        self.list.iter()
    }

    pub(super) fn find(&self, name: &str) -> Result<T, UnknownSignal> {
        if let Some(i) = self.index.get(name) {
            return Ok(self.list[*i].place);
        }
        let last = |n: &str| n.rsplit('.').next().unwrap_or(n).to_lowercase();
        let given = name.to_lowercase();
        let mut near: Vec<(usize, usize, &str)> = self
            .list
            .iter()
            .map(|n| {
                let whole = strsim::damerau_levenshtein(&given, &n.name.to_lowercase());
                // Who forgets the path still means the name.
                let tail = strsim::damerau_levenshtein(&last(&given), &last(&n.name));
                (whole.min(tail + 1), whole, n.name.as_str())
            })
            .collect();
        near.sort_unstable();
        Err(UnknownSignal {
            kind: self.kind,
            given: name.to_string(),
            nearest: near.iter().take(3).map(|n| n.2.to_string()).collect(),
        })
    }
}
