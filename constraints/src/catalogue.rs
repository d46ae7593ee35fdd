//! The devices and boards that come with the crate, and their look-up by name.

use crate::error::{nearest, UnknownName};
use crate::{Board, Device};
use serde::Deserialize;
use std::sync::LazyLock;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DeviceFile {
    device: Vec<Device>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct BoardFile {
    board: Vec<Board>,
}

// The data is part of the program, so a fault in it is a fault of the build that every test
// would show; it is not input.
static DEVICES: LazyLock<Vec<Device>> = LazyLock::new(|| {
    let file: DeviceFile =
        toml::from_str(include_str!("../data/devices.toml")).expect("data/devices.toml is valid");
    file.device
});

static BOARDS: LazyLock<Vec<Board>> = LazyLock::new(|| {
    let file: BoardFile =
        toml::from_str(include_str!("../data/boards.toml")).expect("data/boards.toml is valid");
    file.board
});

/// All devices, oldest family first.
pub fn devices() -> &'static [Device] {
    &DEVICES
}

/// All boards.
pub fn boards() -> &'static [Board] {
    &BOARDS
}

/// The device called `name`, in either case.
pub fn device(name: &str) -> Result<&'static Device, UnknownName> {
    find("device", name, devices(), |d| &d.name)
}

/// The board called `name`, in either case.
pub fn board(name: &str) -> Result<&'static Board, UnknownName> {
    find("board", name, boards(), |b| &b.name)
}

fn find<T>(
    kind: &'static str,
    name: &str,
    all: &'static [T],
    name_of: impl Fn(&'static T) -> &'static str,
) -> Result<&'static T, UnknownName> {
    all.iter()
        .find(|item| name_of(item).eq_ignore_ascii_case(name))
        .ok_or_else(|| {
            let known: Vec<&str> = all.iter().map(name_of).collect();
            UnknownName {
                kind,
                name: name.to_owned(),
                suggestion: nearest(name, &known).map(str::to_owned),
                known: known.join(", "),
            }
        })
}
