//! `match`: a choice by a word, its patterns as codes.

use super::expression::Lowering;
use super::statement::Lowered;
use crate::netlist::{Arm, Format, NetlistError, Statement};
use rust_hdl_core::ast::{VerilogMatch, VerilogStatement as S};

/// The number that a pattern spells, such as `3`, `0x1f_usize` or `true`.
fn pattern_number(text: &str) -> Option<u128> {
    match text {
        "true" => return Some(1),
        "false" => return Some(0),
        _ => {}
    }
    let text = text.replace('_', "");
    let (radix, digits) = match text.get(..2) {
        Some("0x") => (16, &text[2..]),
        Some("0b") => (2, &text[2..]),
        Some("0o") => (8, &text[2..]),
        _ => (10, text.as_str()),
    };
    let end = digits
        .find(|c: char| !c.is_digit(radix))
        .unwrap_or(digits.len());
    let suffix = &digits[end..];
    let known = ["", "u8", "u16", "u32", "u64", "u128", "usize", "i32", "i64"];
    known
        .contains(&suffix)
        .then(|| u128::from_str_radix(&digits[..end], radix).ok())?
}

impl Lowering<'_> {
    pub(super) fn choice(
        &mut self,
        m: &VerilogMatch,
        s: &S,
        out: &mut Lowered,
    ) -> Result<Statement, NetlistError> {
        let format = self
            .own_format(&m.test)?
            .ok_or_else(|| self.refuse("the matched value has no format", s))?;
        let subject = self.of_format(&m.test, format)?;
        let mut arms: Vec<Arm> = vec![];
        let mut otherwise = None;
        let mut complete = false;
        for case in &m.cases {
            let mut body = vec![];
            self.block(&case.block, false, out, &mut body)?;
            if otherwise.is_some() {
                continue;
            }
            if case.condition == "default" {
                otherwise = Some(body);
                continue;
            }
            let (label, name, variants) = self.label(&case.condition, format, s)?;
            if arms.iter().any(|a| a.label == label) {
                continue;
            }
            arms.push(Arm { label, name, body });
            let all = variants.map_or_else(
                || 1u128.checked_shl(format.width() as u32),
                |v| Some(v as u128),
            );
            complete |= all == Some(arms.len() as u128);
        }
        // A match that names every value needs no default: its last arm serves, so that no latch is suspected.
        if otherwise.is_none() && complete {
            otherwise = arms.pop().map(|a| a.body);
        }
        Ok(Statement::Case {
            subject,
            arms,
            otherwise: otherwise.unwrap_or_default(),
        })
    }

    /// Code and name of a pattern, and how many variants its enumeration has.
    pub(super) fn label(
        &self,
        pattern: &str,
        format: Format,
        s: &S,
    ) -> Result<(u128, String, Option<usize>), NetlistError> {
        if let Some((code, width, variants)) = self.scope.variant(pattern) {
            if format != Format::Enumeration(width) {
                return Err(self.refuse(format!("a {format} is matched with {pattern}"), s));
            }
            self.variants
                .borrow_mut()
                .insert(pattern.to_string(), (code, width));
            let name = super::scope::plain(pattern);
            return Ok((code, name, Some(variants)));
        }
        let code =
            pattern_number(pattern).filter(|_| matches!(format, Format::Bit | Format::Unsigned(_)));
        let code = code.ok_or_else(|| self.refuse(self.scope.not_a_variant(pattern), s))?;
        if format.width() < 128 && code >> format.width() != 0 {
            return Err(self.refuse(format!("pattern {code} does not fit {format}"), s));
        }
        Ok((code, String::new(), None))
    }
}

#[cfg(test)]
mod tests {
    use super::pattern_number;

    #[test]
    fn patterns_are_numbers() {
        assert_eq!(pattern_number("12"), Some(12));
        assert_eq!(pattern_number("0x1f_usize"), Some(31));
        assert_eq!(pattern_number("0b1_01u8"), Some(5));
        assert_eq!(pattern_number("true"), Some(1));
        assert_eq!(pattern_number("x"), None);
        assert_eq!(pattern_number("3cats"), None);
    }
}
