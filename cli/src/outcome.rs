//! How a command ends: a report or an error, and the exit code of each.

use serde_json::{json, Value};
use std::fmt;
use std::process::ExitCode;

/// The exit codes of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// Done, and all checks hold.
    Done = 0,
    /// Done, but a check failed.
    CheckFailed = 1,
    /// Bad input or usage.
    BadInput = 2,
    /// A tool that was needed is missing or failed.
    ToolFailed = 3,
}

impl From<Exit> for ExitCode {
    fn from(e: Exit) -> Self {
        Self::from(e as u8)
    }
}

/// What a command that came to its end has to say.
#[derive(Debug)]
pub struct Report {
    /// For people; may hold ANSI styles.
    pub text: String,
    /// For programs; an object.
    pub json: Value,
    /// Whether the checks hold.
    pub exit: Exit,
}

impl Report {
    /// A report of a command that checks nothing.
    pub fn done(text: String, json: Value) -> Self {
        Self {
            text,
            json,
            exit: Exit::Done,
        }
    }
}

/// Why a command did not come to its end.
#[derive(Debug)]
pub struct Failure {
    /// One line.
    pub message: String,
    /// [`Exit::BadInput`] or [`Exit::ToolFailed`].
    pub exit: Exit,
}

impl Failure {
    /// The user's input cannot be used.
    pub fn input(why: impl fmt::Display) -> Self {
        Self {
            message: one_line(&why.to_string()),
            exit: Exit::BadInput,
        }
    }

    /// A tool is missing or failed.
    pub fn tool(why: impl fmt::Display) -> Self {
        Self {
            message: one_line(&why.to_string()),
            exit: Exit::ToolFailed,
        }
    }

    /// For programs.
    pub fn json(&self) -> Value {
        json!({ "error": self.message, "exit": self.exit as u8 })
    }
}

/// What every command returns.
pub type Outcome = Result<Report, Failure>;

/// Text on one line, control characters made visible: file names may hold any.
fn one_line(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.trim().chars() {
        if c.is_control() {
            out.extend(c.escape_default());
        } else {
            out.push(c);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_one_line() {
        let f = Failure::input("a\nb\u{1b}[1mc\n");
        assert_eq!(f.message, "a\\nb\\u{1b}[1mc");
        assert_eq!(f.json()["exit"], 2);
        assert_eq!(Failure::tool("x").json()["exit"], 3);
    }
}
