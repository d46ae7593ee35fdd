//! From arguments to a command, and from its outcome to streams and an exit code.

use crate::args::{Cli, Command, Global};
use crate::outcome::{Exit, Failure, Outcome};
use anstyle::{AnsiColor, Style};
use clap::error::ErrorKind;
use clap::Parser;
use std::ffi::OsStr;
use std::io::Write;
use std::process::ExitCode;

/// The program.
pub fn main() -> ExitCode {
    match Cli::try_parse() {
        Ok(cli) => finish(dispatch(&cli), cli.global),
        Err(e) => refuse(&e),
    }
}

fn dispatch(cli: &Cli) -> Outcome {
    let global = cli.global;
    match &cli.command {
        Command::Cosim(a) => crate::cosim::run(a, global),
        Command::Render(a) => crate::render::run(a, global),
        Command::Gen(a) => crate::gen::run(a, global),
        Command::Synth(a) => crate::synth::run(a, global),
        Command::Plan(a) => crate::plan::run(a, global),
        Command::Compare(a) => crate::compare::run(a, global),
        Command::Bench(a) => crate::bench::run(a, global),
        Command::List(a) => crate::list::run(a, global),
        Command::Completions(a) => crate::completions::run(a),
        Command::Man(a) => crate::man::run(a, global),
    }
}

fn finish(outcome: Outcome, global: Global) -> ExitCode {
    let (text, json, exit) = match outcome {
        Ok(report) => (report.text, report.json, report.exit),
        Err(failure) => {
            complain(&failure.message);
            (String::new(), failure.json(), failure.exit)
        }
    };
    let said = if global.json {
        say(std::io::stdout().lock(), &format!("{json}\n"))
    } else {
        say(anstream::stdout().lock(), &text)
    };
    if said {
        exit.into()
    } else {
        Exit::ToolFailed.into()
    }
}

/// Writes to standard output. A reader that has gone away wanted no more; any other fault is reported.
fn say(mut out: impl Write, text: &str) -> bool {
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    match written {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            complain(&format!("cannot write to standard output: {e}"));
            false
        }
        _ => true,
    }
}

/// One line on standard error. Nowhere is left to report that it cannot be written.
fn complain(message: &str) {
    let red = Style::new().bold().fg_color(Some(AnsiColor::Red.into()));
    let _ = writeln!(anstream::stderr(), "{red}error:{red:#} {message}");
}

/// Help and version are wanted; everything else that clap returns is a usage error.
fn refuse(e: &clap::Error) -> ExitCode {
    match e.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            // A reader of the help that has gone away wanted no more.
            let _ = e.print();
            Exit::Done.into()
        }
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let _ = e.print();
            Exit::BadInput.into()
        }
        _ => {
            let json = std::env::args_os()
                .skip(1)
                .take_while(|a| a != OsStr::new("--"))
                .any(|a| a == OsStr::new("--json"));
            let global = Global {
                json,
                quiet: false,
                verbose: false,
            };
            finish(Err(Failure::input(usage(&e.render().to_string()))), global)
        }
    }
}

/// clap's paragraphs on one line: the fault and the hints, without the synopsis.
fn usage(rendered: &str) -> String {
    let mut line = String::new();
    let parts = rendered
        .lines()
        .map(str::trim)
        .filter(|l| !l.is_empty() && !l.starts_with("Usage:"));
    for part in parts {
        let part = part.strip_prefix("error: ").unwrap_or(part);
        let part = part.strip_prefix("For more information, ").unwrap_or(part);
        if !line.is_empty() {
            line += if line.ends_with(':') { " " } else { "; " };
        }
        line += part.trim_end_matches('.');
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn usage_errors_become_one_line() {
        let e = Cli::try_parse_from(["shadegate", "render"]).unwrap_err();
        assert_eq!(
            usage(&e.render().to_string()),
            "the following required arguments were not provided: <SCENE>; try '--help'"
        );
        let e = Cli::try_parse_from(["shadegate", "render", "a", "--sise", "1x1"]).unwrap_err();
        assert_eq!(
            usage(&e.render().to_string()),
            "unexpected argument '--sise' found; tip: a similar argument exists: '--size'; try '--help'"
        );
    }
}
