//! Widths and signs of the safe subset of expressions.

use super::token::{tokens, Token};
use std::collections::HashMap;

/// A declared name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Declared {
    /// Bits (of a word, for a memory).
    pub width: usize,
    /// Declared signed.
    pub signed: bool,
    /// A memory.
    pub array: bool,
}

/// Width and sign of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    width: usize,
    signed: bool,
}

/// Names in scope.
#[derive(Debug, Default)]
pub struct Scope {
    /// Declarations so far.
    pub names: HashMap<String, Declared>,
}

struct Parser<'a> {
    scope: &'a Scope,
    tokens: &'a [Token],
    at: usize,
}

impl Scope {
    fn parse(&self, text: &str) -> Result<Shape, String> {
        let tokens = tokens(text)?;
        let mut p = Parser {
            scope: self,
            tokens: &tokens,
            at: 0,
        };
        let shape = p.joined()?;
        if p.at != tokens.len() {
            return Err("operators are not fully parenthesised".into());
        }
        Ok(shape)
    }

    /// A condition: one bit.
    pub fn condition(&self, text: &str) -> Result<(), String> {
        match self.parse(text)?.width {
            1 => Ok(()),
            w => Err(format!("a condition of {w} bits")),
        }
    }

    /// A number, for the label of a choice.
    pub fn label(&self, text: &str) -> Result<(), String> {
        self.parse(text).map(|_| ())
    }

    /// The target of an assignment or connection: a signal, bits of one, or a word of a memory.
    pub fn left(&self, text: &str) -> Result<Declared, String> {
        let name = text.split('[').next().unwrap_or_default().trim();
        let d = *self
            .names
            .get(name)
            .ok_or_else(|| format!("`{name}` is not declared"))?;
        match (text.contains('['), d.array) {
            (true, true) => self.parse(text).map(|_| Declared { array: false, ..d }),
            (false, false) => Ok(d),
            // Constant bits of a signal.
            (true, false) => self.parse(text).map(|shape| Declared {
                width: shape.width,
                signed: false,
                array: false,
            }),
            (false, true) => Err("a whole memory is assigned".into()),
        }
    }

    /// Checks an assignment.
    pub fn assign(&self, to: Declared, value: &str) -> Result<(), String> {
        let shape = self.parse(value)?;
        if shape.width != to.width {
            return Err(format!("{} bits are assigned to {}", shape.width, to.width));
        }
        Ok(())
    }
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    fn symbol(&mut self, s: &str) -> bool {
        let found = matches!(self.peek(), Some(Token::Symbol(x)) if *x == s);
        self.at += usize::from(found);
        found
    }

    fn need(&mut self, s: &str) -> Result<(), String> {
        if self.symbol(s) {
            Ok(())
        } else {
            Err(format!("`{s}` expected"))
        }
    }

    fn number(&mut self) -> Result<usize, String> {
        match self.peek() {
            Some(Token::Number(n)) => {
                let n = *n;
                self.at += 1;
                Ok(n)
            }
            _ => Err("a constant position is needed".into()),
        }
    }

    /// One operand, or two joined by one operator.
    fn joined(&mut self) -> Result<Shape, String> {
        let a = self.operand()?;
        let Some(Token::Symbol(op)) = self.peek() else {
            return Ok(a);
        };
        let op = *op;
        let (compares, logical) = match op {
            "+" | "-" | "*" | "&" | "|" | "^" => (false, false),
            // A count of bits stands by itself; the shifted word keeps its width.
            "<<" | ">>" => {
                self.at += 1;
                let count = self.operand()?;
                return if count.signed {
                    Err(format!("`{op}` by a signed count"))
                } else {
                    Ok(a)
                };
            }
            "==" | "!=" | "<" | "<=" | ">" | ">=" => (true, false),
            "&&" | "||" => (false, true),
            ")" | "]" | "}" | "," | ":" => return Ok(a),
            other => return Err(format!("operator `{other}` is not in the safe subset")),
        };
        self.at += 1;
        let b = self.operand()?;
        if a.width != b.width {
            return Err(format!("`{op}` joins {} and {} bits", a.width, b.width));
        }
        if a.signed != b.signed {
            return Err(format!("`{op}` joins a signed and an unsigned operand"));
        }
        if logical && a.width != 1 {
            return Err(format!("`{op}` joins words of {} bits", a.width));
        }
        Ok(if compares || logical {
            Shape {
                width: 1,
                signed: false,
            }
        } else {
            a
        })
    }

    fn operand(&mut self) -> Result<Shape, String> {
        if self.symbol("(") {
            let inner = self.joined()?;
            self.need(")")?;
            return Ok(inner);
        }
        if self.symbol("!") {
            let inner = self.operand()?;
            return if inner.width == 1 {
                Ok(inner)
            } else {
                Err(format!("`!` of {} bits", inner.width))
            };
        }
        if self.symbol("~") || self.symbol("-") {
            return self.operand();
        }
        if self.symbol("|") || self.symbol("&") || self.symbol("^") {
            self.operand()?;
            return Ok(Shape {
                width: 1,
                signed: false,
            });
        }
        if self.symbol("{") {
            return self.concatenation();
        }
        match self.peek().cloned() {
            Some(Token::Sized(width, signed)) => {
                self.at += 1;
                Ok(Shape { width, signed })
            }
            Some(Token::Number(_)) => Err("a literal without a width".into()),
            Some(Token::Name(name)) => {
                self.at += 1;
                self.named(&name)
            }
            _ => Err("an operand is missing".into()),
        }
    }

    fn named(&mut self, name: &str) -> Result<Shape, String> {
        let d = *self
            .scope
            .names
            .get(name)
            .ok_or_else(|| format!("`{name}` is not declared"))?;
        if d.array {
            self.need("[")?;
            self.joined()?;
            self.need("]")?;
            return Ok(Shape {
                width: d.width,
                signed: d.signed,
            });
        }
        if !self.symbol("[") {
            return Ok(Shape {
                width: d.width,
                signed: d.signed,
            });
        }
        if matches!(self.peek(), Some(Token::Name(_))) {
            return self.chosen_bit(d);
        }
        let high = self.number()?;
        let low = if self.symbol(":") {
            self.number()?
        } else {
            high
        };
        self.need("]")?;
        if high >= d.width || low > high {
            return Err(format!(
                "bits {high}:{low} of `{name}`, which has {} bits",
                d.width
            ));
        }
        // A part-select is unsigned, whatever it is taken from.
        Ok(Shape {
            width: high - low + 1,
            signed: false,
        })
    }

    /// After `name[`: a bit chosen by a word that cannot leave the name.
    fn chosen_bit(&mut self, d: Declared) -> Result<Shape, String> {
        let position = self.joined()?;
        self.need("]")?;
        if position.signed || position.width >= 16 || 1 << position.width > d.width {
            return Err(format!("a position that can leave the {} bits", d.width));
        }
        Ok(Shape {
            width: 1,
            signed: false,
        })
    }

    /// After `{`: a list, or a repetition.
    fn concatenation(&mut self) -> Result<Shape, String> {
        let mut width = 0;
        if matches!(self.peek(), Some(Token::Number(_))) {
            let times = self.number()?;
            self.need("{")?;
            width = times * self.joined()?.width;
            self.need("}")?;
            self.need("}")?;
            return Ok(Shape {
                width,
                signed: false,
            });
        }
        loop {
            width += self.joined()?.width;
            if self.symbol("}") {
                return Ok(Shape {
                    width,
                    signed: false,
                });
            }
            self.need(",")?;
        }
    }
}
