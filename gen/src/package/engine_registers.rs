//! The register map of the cores with a set-up engine, as data.

use super::registers::{Field, Register};
use shadegate_hdl::set_up::{DEPTH_KNOT_FRACTION_BITS, KNOT_FRACTION_BITS, RAW_BITS};

/// How raw words are addressed, for the README of a package.
pub const ABOUT: &str = "## Registers\n\n\
    `select[7:4]` is a mask: bit 4 red, bit 5 green, bit 6 blue, bit 7 depth; of several bits the lowest counts; zero \
    selects corners and frame. `select[3:0]` is the word. A word is taken while `load_ready` is high. Words per triangle \
    are double-buffered, and the buffers take turns: write all words of every triangle. Triangles without area, and those \
    above or below the frame, are skipped.\n\n\
    ### Corners and frame\n\n";

/// A word of corners or of the frame.
fn shell(word: u8, name: &'static str, high: usize, meaning: &'static str) -> Register {
    Register {
        select: word,
        target: "shell",
        word,
        name,
        bits: high + 1,
        format: "fields".to_owned(),
        meaning,
        per: if word < 8 { "triangle" } else { "frame" },
        fields: vec![Field {
            high,
            low: 0,
            meaning: meaning.to_owned(),
        }],
    }
}

/// A word of a channel.
fn knot(
    (mask, target): (u8, &'static str),
    (word, name, meaning): (u8, &'static str, &'static str),
    (int, frac): (usize, u32),
) -> Register {
    Register {
        select: mask << 4 | word,
        target,
        word,
        name,
        bits: int + frac as usize,
        format: format!("U{int}.{frac}"),
        meaning,
        per: "triangle",
        fields: vec![],
    }
}

/// The whole map, in the order of the select codes of corners and frame, red, green, blue, depth.
pub fn registers() -> Vec<Register> {
    let mut all = vec![];
    let corner = RAW_BITS as usize - 1;
    for (word, name) in [(0, "x0"), (1, "x1"), (2, "x2")] {
        let meaning = "column of the corner, 1/256 pixel, signed";
        all.push(shell(word, name, corner, meaning));
    }
    for (word, name) in [(4, "y0"), (5, "y1"), (6, "y2")] {
        let meaning = "row of the corner, 1/256 pixel, signed";
        all.push(shell(word, name, corner, meaning));
    }
    all.push(shell(11, "width", 11, "columns of the frame"));
    all.push(shell(12, "height", 11, "rows of the frame"));
    for channel in [(1, "red"), (2, "green"), (4, "blue")] {
        for word in [
            (0, "k0", "colour at vertex 0, LSB"),
            (1, "k1", "colour at vertex 1, LSB"),
            (2, "k2", "colour at vertex 2, LSB"),
            (
                4,
                "k12",
                "colour in the middle of the edge from 1 to 2, LSB",
            ),
            (
                5,
                "k02",
                "colour in the middle of the edge from 0 to 2, LSB",
            ),
            (
                6,
                "k01",
                "colour in the middle of the edge from 0 to 1, LSB",
            ),
        ] {
            all.push(knot(channel, word, (11, KNOT_FRACTION_BITS)));
        }
    }
    for (word, name) in [(0, "z0"), (1, "z1"), (2, "z2")] {
        let word = (word, name, "depth at the vertex, depth words");
        all.push(knot((8, "depth"), word, (16, DEPTH_KNOT_FRACTION_BITS)));
    }
    all
}
