//! A second reading of emitted Verilog: refuses every shape whose meaning depends on context.
//!
//! It knows nothing of the netlist. It reads declarations and assignments from the text and accepts an expression only
//! if every operator is parenthesised and joins operands of one width and one sign, every literal is sized, every
//! slice is of a named signal and inside its range, and both sides of an assignment have one width. In that subset
//! Verilog's width and sign rules have nothing to decide. The traps of rust-hdl's own printer (a carry kept by a wider
//! context, an unsigned literal that makes a comparison unsigned, `a & b == c`) are all outside it.

mod expression;
mod token;

use expression::{Declared, Scope};
use std::fmt;
use token::tokens;

/// A refused line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct Refusal {
    /// File name.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// What is unsafe.
    pub what: String,
    /// The line's text.
    pub text: String,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}:{}: {}: {}",
            self.file, self.line, self.what, self.text
        )
    }
}

/// Without a trailing comment.
fn code(line: &str) -> &str {
    line.split("//").next().unwrap_or_default().trim()
}

/// `signed [31:0] name` after the keyword: width, sign, name, and the rest.
fn declaration(text: &str) -> Option<(usize, bool, String, String)> {
    let mut text = text.trim();
    let mut signed = false;
    if let Some(rest) = text.strip_prefix("signed") {
        signed = true;
        text = rest.trim();
    }
    let mut width = 1;
    if let Some(rest) = text.strip_prefix('[') {
        let (range, rest) = rest.split_once(']')?;
        let (high, low) = range.split_once(':')?;
        if low.trim() != "0" {
            return None;
        }
        width = high.trim().parse::<usize>().ok()? + 1;
        text = rest.trim();
    }
    let end = text
        .find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
        .unwrap_or(text.len());
    let (name, rest) = text.split_at(end);
    (!name.is_empty()).then(|| (width, signed, name.to_string(), rest.trim().to_string()))
}

const PORTS: &[&str] = &["input  wire", "output wire", "output reg"];
const NETS: &[&str] = &["localparam", "wire", "reg"];

fn declare(scope: &mut Scope, line: &str) -> Result<bool, String> {
    let Some(rest) = PORTS
        .iter()
        .chain(NETS)
        .find_map(|k| line.strip_prefix(k).filter(|r| r.starts_with([' ', '['])))
    else {
        return Ok(false);
    };
    let (width, signed, name, rest) = declaration(rest).ok_or("cannot read the declaration")?;
    let array = rest.starts_with('[');
    if let Some(value) = rest.strip_prefix('=') {
        let value = value.trim().trim_end_matches(';');
        scope.assign(
            Declared {
                width,
                signed,
                array,
            },
            value,
        )?;
    }
    if scope
        .names
        .insert(
            name.clone(),
            Declared {
                width,
                signed,
                array,
            },
        )
        .is_some()
    {
        return Err(format!("{name} is declared twice"));
    }
    Ok(true)
}

/// Statements of the form `if (…) statement` or `if (…) begin`: the condition and what follows.
fn conditional(line: &str) -> Option<(&str, &str)> {
    let line = line.strip_prefix("end else ").unwrap_or(line);
    let rest = line.strip_prefix("if (")?;
    let mut depth = 1;
    for (i, c) in rest.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some((&rest[..i], rest[i + 1..].trim()));
        }
    }
    None
}

/// `label: statement` of a `case`: what follows the label.
fn choice<'a>(scope: &Scope, line: &'a str) -> Option<Result<&'a str, String>> {
    let (label, rest) = line.split_once(": ")?;
    if label == "default" {
        return Some(Ok(rest));
    }
    // A slice has no blank behind its colon.
    Some(scope.label(label).map(|()| rest))
}

fn statement(scope: &Scope, line: &str) -> Result<(), String> {
    if let Some(rest) = choice(scope, line) {
        let rest = rest?;
        return if rest == "begin" {
            Ok(())
        } else {
            statement(scope, rest)
        };
    }
    if let Some(subject) = line
        .strip_prefix("case (")
        .and_then(|l| l.strip_suffix(')'))
    {
        return scope.label(subject);
    }
    if let Some((condition, rest)) = conditional(line) {
        scope.condition(condition)?;
        return if rest == "begin" || rest.is_empty() {
            Ok(())
        } else {
            statement(scope, rest)
        };
    }
    let body = line
        .strip_prefix("assign ")
        .or_else(|| line.strip_prefix("initial "))
        .unwrap_or(line);
    let Some(body) = body.strip_suffix(';') else {
        return Err("cannot read the statement".to_string());
    };
    // The first `=` assigns; a `<=` further on compares.
    let (to, value) = body
        .split_once('=')
        .ok_or_else(|| "cannot read the statement".to_string())?;
    let to = scope.left(to.strip_suffix('<').unwrap_or(to).trim())?;
    scope.assign(to, value.trim())
}

const STRUCTURE: &[&str] = &[
    "begin",
    "end",
    "end else begin",
    "endmodule",
    ");",
    "always @* begin",
    "endcase",
    "initial begin",
];

/// Reads one emitted file.
///
/// # Errors
/// The first line that is not in the safe subset.
pub fn check(file: &str, text: &str) -> Result<(), Refusal> {
    let mut scope = Scope::default();
    let mut modules = 0;
    let mut instance = false;
    for (i, raw) in text.lines().enumerate() {
        let refuse = |what: String| Refusal {
            file: file.into(),
            line: i + 1,
            what,
            text: raw.trim().into(),
        };
        let line = code(raw);
        if raw.split("//").next().is_some_and(|c| c.contains('$')) {
            return Err(refuse("`$` in an identifier or a system function".into()));
        }
        if line.is_empty() || line.starts_with('`') || STRUCTURE.contains(&line) {
            instance &= line != ");";
            continue;
        }
        if let Some(clock) = line
            .strip_prefix("always @(posedge ")
            .and_then(|l| l.strip_suffix(") begin"))
        {
            scope.condition(clock).map_err(refuse)?;
            continue;
        }
        if line.starts_with("module ") {
            modules += 1;
            if modules > 1 {
                return Err(refuse("a second module in one file".into()));
            }
            continue;
        }
        if line == "integer i;" {
            scope.names.insert(
                "i".into(),
                Declared {
                    width: 32,
                    signed: true,
                    array: false,
                },
            );
            continue;
        }
        if instance {
            let connected = line
                .trim_end_matches(',')
                .strip_suffix(')')
                .and_then(|l| l.rsplit_once('('));
            let name = connected.map(|(_, n)| n).unwrap_or_default();
            scope.left(name).map_err(refuse)?;
            continue;
        }
        if line.ends_with('(') && tokens(line).is_ok_and(|t| t.len() == 3) {
            instance = true;
            continue;
        }
        if let Some(rest) = line.strip_prefix("for (") {
            let body = rest.split_once(") ").map(|(_, b)| b).unwrap_or_default();
            statement(&scope, body).map_err(refuse)?;
            continue;
        }
        let declared = declare(&mut scope, line.trim_end_matches(',')).map_err(refuse)?;
        if !declared {
            statement(&scope, line).map_err(refuse)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
