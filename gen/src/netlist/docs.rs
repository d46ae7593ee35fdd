//! Doc comments of a description's fields, read from its source text, and the rule that none may be missing.

use super::{Module, NetlistError};
use std::collections::HashMap;

/// Remarks that a documented module has.
const REMARKS: [&str; 4] = ["title", "equation", "source", "latency"];

/// The first thing in a hierarchy that lacks a remark or a doc comment. The project's own cores have none.
#[must_use]
pub fn undocumented(m: &Module) -> Option<NetlistError> {
    let missing = |what: String| Some(NetlistError::new(&m.name, what));
    if let Some(key) = REMARKS
        .iter()
        .find(|k| !m.remarks.iter().any(|(own, _)| own == *k))
    {
        return missing(format!("has no {key} remark"));
    }
    if let Some(s) = m.signals.iter().find(|s| s.doc.is_empty()) {
        return missing(format!("signal {} has no doc comment", s.name));
    }
    if let Some(r) = m.registers.iter().find(|r| r.doc.is_empty()) {
        return missing(format!("register {} has no doc comment", r.name));
    }
    m.children.iter().find_map(|c| undocumented(&c.module))
}

/// First sentence-block of the doc comment above each `name: Type` field, by field name.
pub fn field_docs(source: &str) -> HashMap<String, String> {
    let mut docs = HashMap::new();
    let mut pending: Vec<&str> = vec![];
    for line in source.lines() {
        let line = line.trim();
        if let Some(text) = line.strip_prefix("///") {
            pending.push(text.trim());
            continue;
        }
        if line.starts_with("#[") {
            continue;
        }
        if let Some((name, _)) = line.trim_start_matches("pub ").split_once(": ") {
            let is_name =
                !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            if is_name && !pending.is_empty() {
                docs.entry(name.to_string())
                    .or_insert_with(|| ascii(&pending.join(" ")));
            }
        }
        pending.clear();
    }
    docs
}

/// The text in ASCII, as the older synthesis tools want their sources: mathematical signs are spelt.
pub fn ascii(text: &str) -> String {
    let spelt = |c: char| match c {
        '·' | '×' => "*".to_string(),
        '−' | '–' => "-".to_string(),
        '²' => "^2".to_string(),
        '≤' => "<=".to_string(),
        '≥' => ">=".to_string(),
        '±' => "+-".to_string(),
        '→' => "->".to_string(),
        c if c.is_ascii() => c.to_string(),
        _ => "?".to_string(),
    };
    text.chars().map(spelt).collect()
}

#[cfg(test)]
mod tests {
    use super::{ascii, field_docs};

    #[test]
    fn signs_are_spelt() {
        assert_eq!(ascii("row · width − 1 ≤ 2²"), "row * width - 1 <= 2^2");
    }

    #[test]
    fn docs_belong_to_the_field_below_them() {
        let d = field_docs("struct A {\n    /// The clock.\n    pub clock: Signal<In, Clock>,\n    /// Two\n    /// lines.\n    total: DFF<U<4>>,\n    bare: u8,\n}");
        assert_eq!(d["clock"], "The clock.");
        assert_eq!(d["total"], "Two lines.");
        assert!(!d.contains_key("bare"));
    }
}
