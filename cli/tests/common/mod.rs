//! What several tests need: the program in a folder of its own, and scenes written there.

use assert_cmd::assert::Assert;
use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

/// A small scene that nothing is wrong with.
pub const GOOD: &str = r#"[image]
width = 48
height = 32

[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
fov = 40

[[light]]
kind = "directional"
direction = [-1, -1, -1]

[[material]]
name = "clay"

[[object]]
shape = "sphere"
material = "clay"
"#;

/// A folder that goes away with the test; the good scene is in it as `ball.toml`.
pub struct Folder(pub TempDir);

impl Folder {
    /// Makes it.
    pub fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        folder.write("ball.toml", GOOD);
        folder
    }

    /// Writes a file.
    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.path().join(name), text).unwrap();
    }

    /// Names of all files and folders here, in order.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries
            .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    /// The program, to be run here with arguments separated by blanks.
    pub fn shadegate(&self, arguments: &str) -> Command {
        let mut c = Command::new(env!("CARGO_BIN_EXE_shadegate"));
        c.current_dir(self.0.path())
            .args(arguments.split_whitespace());
        c
    }

    /// Runs it.
    pub fn run(&self, arguments: &str) -> Assert {
        self.shadegate(arguments).assert()
    }

    /// Runs it with `--json` and reads the one object, which must be all there is on standard output.
    #[allow(dead_code, reason = "not every test binary reads JSON")]
    pub fn json(&self, arguments: &str, code: i32) -> Value {
        let done = self.run(&format!("{arguments} --json")).code(code);
        let text = std::str::from_utf8(&done.get_output().stdout).unwrap();
        let value: Value = serde_json::from_str(text).unwrap();
        assert!(value.is_object() && text.lines().count() == 1, "{text}");
        value
    }

    /// Checks that a run is refused with this text, with and without `--json`, and leaves nothing behind.
    #[allow(dead_code, reason = "not every test binary makes mistakes")]
    pub fn refuses(&self, arguments: &str, message: &str) {
        let before = self.names();
        let line = format!("error: {message}\n");
        self.run(arguments).code(2).stdout("").stderr(line.clone());
        let json = serde_json::json!({ "error": message, "exit": 2 });
        self.run(&format!("{arguments} --json"))
            .code(2)
            .stdout(format!("{json}\n"))
            .stderr(line);
        assert_eq!(self.names(), before, "{arguments}");
    }
}

/// The keys of an object, in alphabetical order.
#[allow(dead_code, reason = "not every test binary reads JSON")]
pub fn keys(v: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = v.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}
