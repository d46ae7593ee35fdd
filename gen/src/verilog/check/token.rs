//! Tokens of a Verilog expression.

/// A token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Token {
    /// Identifier.
    Name(String),
    /// Sized literal: width and sign.
    Sized(usize, bool),
    /// Bare number, legal only as a position or a repeat count.
    Number(usize),
    /// Operator or bracket.
    Symbol(&'static str),
}

const SYMBOLS: &[&str] = &[
    ">>>", "<<<", "===", "!==", "&&", "||", "==", "!=", "<=", ">=", "<<", ">>", "**", "+", "-",
    "*", "/", "%", "&", "|", "^", "~", "!", "<", ">", "?", ":", "(", ")", "[", "]", "{", "}", ",",
];

/// Splits an expression.
pub fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let mut out = vec![];
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let word = |p: fn(char) -> bool| rest.find(|c| !p(c)).unwrap_or(rest.len());
        if first.is_ascii_digit() {
            let digits = word(|c| c.is_ascii_digit());
            let number: usize = rest[..digits]
                .parse()
                .map_err(|_| "number out of range".to_string())?;
            rest = &rest[digits..];
            if let Some(tail) = rest.strip_prefix('\'') {
                let signed = tail.starts_with('s');
                let tail = tail.trim_start_matches('s');
                let base = tail.chars().next().unwrap_or(' ');
                let digits = tail[1..]
                    .find(|c: char| !c.is_ascii_hexdigit())
                    .unwrap_or(tail.len() - 1);
                if !"bdh".contains(base) || digits == 0 {
                    return Err("literal without base or digits".into());
                }
                out.push(Token::Sized(number, signed));
                rest = &tail[1 + digits..];
            } else {
                out.push(Token::Number(number));
            }
        } else if first.is_ascii_alphabetic() || first == '_' {
            let end = word(|c| c.is_ascii_alphanumeric() || c == '_');
            out.push(Token::Name(rest[..end].to_string()));
            rest = &rest[end..];
        } else {
            let symbol = SYMBOLS
                .iter()
                .find(|s| rest.starts_with(**s))
                .ok_or_else(|| format!("unexpected character {first}"))?;
            out.push(Token::Symbol(symbol));
            rest = &rest[symbol.len()..];
        }
        rest = rest.trim_start();
    }
    Ok(out)
}
