//! Completions, manual pages, help, and what happens when the reader goes away.

mod common;

use common::{keys, Folder};
use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn completions_know_commands_and_names() {
    let f = Folder::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let done = f.run(&format!("completions {shell}")).code(0).stderr("");
        let script = String::from_utf8(done.get_output().stdout.clone()).unwrap();
        for word in ["cosim", "render", "against"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    let script = f.json("completions bash", 0);
    assert_eq!(keys(&script), ["script", "shell"]);
    let script = script["script"].as_str().unwrap();
    assert!(script.contains("quadratic") && script.contains("arty-s7-50"));
}

#[test]
fn a_page_for_every_command() {
    let f = Folder::new();
    f.run("man -o man")
        .code(0)
        .stderr("")
        .stdout("wrote 11 pages to man\n");
    let main = std::fs::read_to_string(f.0.path().join("man/shadegate.1")).unwrap();
    let written = f.json("man -o man", 0);
    for file in written["files"].as_array().unwrap() {
        let name = file.as_str().unwrap();
        let page = std::fs::read_to_string(f.0.path().join("man").join(name)).unwrap();
        assert!(
            page.contains(".SH NAME") && page.contains(".SH SYNOPSIS"),
            "{name}"
        );
    }
    assert!(main.contains("shadegate\\-render(1)"), "{main}");
}

#[test]
fn help_documents_exit_codes() {
    let f = Folder::new();
    for (arguments, text) in [
        (
            "--help",
            "Exit codes: 0 done and all checks hold; 1 done but a check failed;",
        ),
        (
            "compare --help",
            "Exit codes: 0 the images are equal; 1 they differ; 2 they cannot be compared.",
        ),
        ("cosim --help", "Exit codes: 0 every check holds;"),
    ] {
        let done = f.run(arguments).code(0).stderr("");
        let help = String::from_utf8(done.get_output().stdout.clone()).unwrap();
        assert!(help.contains(text), "{help}");
    }
    f.run("").code(2).stdout("");
    f.run("--version")
        .code(0)
        .stdout(format!("shadegate {}\n", env!("CARGO_PKG_VERSION")));
}

/// Nobody reads: the program ends quietly, with the code of what it did.
#[test]
fn a_broken_pipe_is_no_fault() {
    let f = Folder::new();
    for arguments in [
        &["completions", "zsh"][..],
        &["list", "targets", "--json"],
        &["--help"],
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_shadegate"))
            .args(arguments)
            .current_dir(f.0.path())
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut said = String::new();
        child
            .stderr
            .take()
            .unwrap()
            .read_to_string(&mut said)
            .unwrap();
        assert_eq!((child.wait().unwrap().code(), said.as_str()), (Some(0), ""));
    }
}
