//! Typed access to a parsed TOML document, in which every refusal knows its line, its field and what would do.
//! The tree with byte positions that lies beneath the serde layer of the `toml` crate is used directly, because the
//! errors of derived deserialisers name neither ranges nor the nearest key.

use super::SceneError;
use crate::method::nearest;
use glam::DVec3;
use std::path::Path;
use toml::de::{DeTable, DeValue};
use toml::Spanned;

/// A scene file and its text.
#[derive(Clone, Copy)]
pub(super) struct Document<'a> {
    pub file: &'a Path,
    pub text: &'a str,
}

impl Document<'_> {
    pub(super) fn line(&self, offset: usize) -> usize {
        let end = offset.min(self.text.len());
        1 + self.text.as_bytes()[..end]
            .iter()
            .filter(|b| **b == b'\n')
            .count()
    }

    pub(super) fn error(&self, line: usize, field: &str, what: &str, accepted: &str) -> SceneError {
        SceneError::new(self.file, line, field, what, accepted)
    }
}

type Value<'a> = Spanned<DeValue<'a>>;

/// A table whose keys are all known.
#[derive(Clone)]
pub(super) struct Table<'a> {
    pub doc: Document<'a>,
    table: &'a DeTable<'a>,
    path: String,
    pub line: usize,
}

/// "a string", "an array" and so on, for messages.
fn kind(v: &DeValue<'_>) -> &'static str {
    match v {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) => "an integer",
        DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "a boolean",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "an array",
        DeValue::Table(_) => "a table",
    }
}

impl<'a> Table<'a> {
    /// Checks that every key is one of `known`.
    pub(super) fn new(
        doc: Document<'a>,
        table: &'a DeTable<'a>,
        path: &str,
        line: usize,
        known: &[&str],
    ) -> Result<Self, SceneError> {
        let unknown = table
            .iter()
            .filter(|(k, _)| !known.contains(&k.get_ref().as_ref()))
            .min_by_key(|(k, _)| k.span().start);
        let this = Self {
            doc,
            table,
            path: path.to_owned(),
            line,
        };
        if let Some((key, _)) = unknown {
            let name = key.get_ref().as_ref();
            let near = nearest(name, known).unwrap_or_default();
            return Err(doc.error(
                doc.line(key.span().start),
                &this.field(name),
                "unknown key",
                &format!("the nearest known key is '{near}' of {}", known.join(", ")),
            ));
        }
        Ok(this)
    }

    pub(super) fn field(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    fn get(&self, key: &str) -> Option<&'a Value<'a>> {
        self.table
            .iter()
            .find(|(k, _)| k.get_ref().as_ref() == key)
            .map(|(_, v)| v)
    }

    pub(super) fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// The line of a key's value, or of the table when it is absent.
    pub(super) fn line_of(&self, key: &str) -> usize {
        self.get(key)
            .map_or(self.line, |v| self.doc.line(v.span().start))
    }

    /// An error about `key`.
    pub(super) fn error(&self, key: &str, what: &str, accepted: &str) -> SceneError {
        self.doc
            .error(self.line_of(key), &self.field(key), what, accepted)
    }

    pub(super) fn missing(&self, key: &str, accepted: &str) -> SceneError {
        self.error(key, "missing", &format!("expected {accepted}"))
    }

    fn wrong(&self, key: &str, v: &Value<'_>, accepted: &str) -> SceneError {
        self.error(
            key,
            &format!("is {}", kind(v.get_ref())),
            &format!("expected {accepted}"),
        )
    }

    fn number(&self, key: &str, v: &Value<'_>, accepted: &str) -> Result<f64, SceneError> {
        let x = match v.get_ref() {
            DeValue::Integer(i) => i64::from_str_radix(i.as_str(), i.radix())
                .ok()
                .map(|i| i as f64),
            DeValue::Float(f) => f.as_str().parse().ok(),
            _ => return Err(self.wrong(key, v, accepted)),
        };
        match x {
            Some(x) if x.is_finite() && x.abs() <= 1e12 => Ok(x),
            _ => Err(self.error(
                key,
                "is not a finite number below 1e12",
                &format!("expected {accepted}"),
            )),
        }
    }

    /// A number that satisfies `ok`; `accepted` says which do.
    pub(super) fn number_if(
        &self,
        key: &str,
        accepted: &str,
        ok: impl Fn(f64) -> bool,
    ) -> Result<Option<f64>, SceneError> {
        let Some(v) = self.get(key) else {
            return Ok(None);
        };
        let x = self.number(key, v, accepted)?;
        if ok(x) {
            Ok(Some(x))
        } else {
            Err(self.error(key, &format!("is {x}"), &format!("expected {accepted}")))
        }
    }

    /// An integer in a range.
    pub(super) fn integer(&self, key: &str, from: u32, to: u32) -> Result<Option<u32>, SceneError> {
        let accepted = format!("an integer from {from} to {to}");
        let Some(v) = self.get(key) else {
            return Ok(None);
        };
        let DeValue::Integer(i) = v.get_ref() else {
            return Err(self.wrong(key, v, &accepted));
        };
        match u32::from_str_radix(i.as_str(), i.radix()) {
            Ok(n) if (from..=to).contains(&n) => Ok(Some(n)),
            _ => Err(self.error(key, &format!("is {i}"), &format!("expected {accepted}"))),
        }
    }

    /// Two numbers that satisfy `ok` one by one.
    pub(super) fn pair_if(
        &self,
        key: &str,
        accepted: &str,
        ok: impl Fn(f64) -> bool,
    ) -> Result<Option<[f64; 2]>, SceneError> {
        let Some(v) = self.get(key) else {
            return Ok(None);
        };
        let DeValue::Array(a) = v.get_ref() else {
            return Err(self.wrong(key, v, accepted));
        };
        let mut out = [0.0; 2];
        if a.len() != out.len() {
            let what = format!("has {} elements", a.len());
            return Err(self.error(key, &what, &format!("expected {accepted}")));
        }
        for (x, v) in out.iter_mut().zip(a.iter()) {
            *x = self.number(key, v, accepted)?;
            if !ok(*x) {
                return Err(self.error(key, &format!("has {x}"), &format!("expected {accepted}")));
            }
        }
        Ok(Some(out))
    }

    /// Three numbers.
    pub(super) fn vector(&self, key: &str) -> Result<Option<DVec3>, SceneError> {
        self.vector_if(key, "three numbers [x, y, z]", false, |_| true)
    }

    /// Three numbers that satisfy `ok` one by one; one number for all three when `scalar` allows it.
    pub(super) fn vector_if(
        &self,
        key: &str,
        accepted: &str,
        scalar: bool,
        ok: impl Fn(f64) -> bool,
    ) -> Result<Option<DVec3>, SceneError> {
        Ok(self
            .numbers_if(key, accepted, scalar, ok)?
            .map(DVec3::from_array))
    }

    /// `N` numbers that satisfy `ok` one by one; one number for all of them when `scalar` allows it.
    pub(super) fn numbers_if<const N: usize>(
        &self,
        key: &str,
        accepted: &str,
        scalar: bool,
        ok: impl Fn(f64) -> bool,
    ) -> Result<Option<[f64; N]>, SceneError> {
        let Some(v) = self.get(key) else {
            return Ok(None);
        };
        let checked = |v: &Value<'_>| {
            let x = self.number(key, v, accepted)?;
            if ok(x) {
                Ok(x)
            } else {
                Err(self.error(key, &format!("has {x}"), &format!("expected {accepted}")))
            }
        };
        match v.get_ref() {
            DeValue::Array(a) if a.len() == N => {
                let mut out = [0.0; N];
                for (i, x) in a.iter().enumerate() {
                    out[i] = checked(x)?;
                }
                Ok(Some(out))
            }
            DeValue::Array(a) => Err(self.error(
                key,
                &format!("has {} elements", a.len()),
                &format!("expected {accepted}"),
            )),
            DeValue::Integer(_) | DeValue::Float(_) if scalar => Ok(Some([checked(v)?; N])),
            _ => Err(self.wrong(key, v, accepted)),
        }
    }

    /// A string.
    pub(super) fn string(&self, key: &str, accepted: &str) -> Result<Option<&'a str>, SceneError> {
        match self.get(key).map(|v| (v, v.get_ref())) {
            None => Ok(None),
            Some((_, DeValue::String(s))) => Ok(Some(s.as_ref())),
            Some((v, _)) => Err(self.wrong(key, v, accepted)),
        }
    }

    /// One of some words, or the error that names the nearest.
    pub(super) fn word(
        &self,
        key: &str,
        known: &[&'static str],
    ) -> Result<Option<&'static str>, SceneError> {
        let Some(given) = self.string(key, &format!("one of {}", known.join(", ")))? else {
            return Ok(None);
        };
        if let Some(found) = known.iter().find(|k| **k == given) {
            return Ok(Some(found));
        }
        let near = nearest(given, known).unwrap_or_default();
        Err(self.error(
            key,
            &format!("unknown '{given}'"),
            &format!("the nearest is '{near}' of {}", known.join(", ")),
        ))
    }

    /// A sub-table.
    pub(super) fn table(&self, key: &str, known: &[&str]) -> Result<Option<Table<'a>>, SceneError> {
        match self.get(key).map(|v| (v, v.get_ref())) {
            None => Ok(None),
            Some((v, DeValue::Table(t))) => {
                let line = self.doc.line(v.span().start);
                Table::new(self.doc, t, &self.field(key), line, known).map(Some)
            }
            Some((v, _)) => Err(self.wrong(key, v, &format!("a table [{key}]"))),
        }
    }

    /// An array of tables, possibly absent.
    pub(super) fn tables(&self, key: &str, known: &[&str]) -> Result<Vec<Table<'a>>, SceneError> {
        let accepted = format!("tables [[{key}]]");
        let Some(v) = self.get(key) else {
            return Ok(Vec::new());
        };
        let DeValue::Array(a) = v.get_ref() else {
            return Err(self.wrong(key, v, &accepted));
        };
        a.iter()
            .enumerate()
            .map(|(i, v)| match v.get_ref() {
                DeValue::Table(t) => {
                    let path = format!("{}[{i}]", self.field(key));
                    Table::new(self.doc, t, &path, self.doc.line(v.span().start), known)
                }
                _ => Err(self.wrong(key, v, &accepted)),
            })
            .collect()
    }
}
