//! What a package says of a line core: its registers, formats and measured size.

use super::manifest::{entry, FormatEntry};
use super::registers::{channel, Field, Register};
use super::resources::Measured;
use shadegate_hdl::line::{cone_words, cue, Filter};
use shadegate_hdl::raster::COLUMN_BITS;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::COLOUR_INTEGER_BITS;
use std::collections::BTreeMap;

/// What a core draws, as a word.
pub fn noun(core: &Core) -> &'static str {
    match core.order {
        Order::Line(_) => "line",
        _ => "triangle",
    }
}

/// The first paragraph of the README.
pub fn about(filter: Filter, (columns, rows): (u32, u32)) -> String {
    let how = match filter {
        Filter::Bresenham => {
            "the one pixel nearest to the line in every column, and hands it over with the line's colour"
        }
        Filter::Box => {
            "two pixels in every column, weighted by their shares of the line, blends them with what its frame memory \
             holds, writes them back and hands them over"
        }
        Filter::Cone => {
            "three pixels in every column, four near the diagonal, weighted by their distance from the line, blends them \
             with what its frame memory holds, writes them back and hands them over"
        }
    };
    format!(
        "A line core in Verilog, for frames of {columns}x{rows} pixels. A host writes the words of a line, or of a visible \
         piece of it, into registers and says `start`; the core walks it, one pixel per clock: {how}. The colour may change \
         along the line, for depth cueing."
    )
}

/// Formats by signal class.
pub fn formats(filter: Filter) -> BTreeMap<&'static str, FormatEntry> {
    let mut all = BTreeMap::from([
        ("colour", entry(COLOUR_INTEGER_BITS, cue::FRACTION_BITS)),
        ("column", entry(COLUMN_BITS - 1, 0)),
        ("error_term", entry(13, 0)),
    ]);
    if filter == Filter::Cone {
        all.insert("distance", entry(1, cone_words::FRACTION_BITS));
    }
    all
}

/// Name, meaning and fields (high, low, meaning) of a word of the walk.
type Word = (
    &'static str,
    &'static str,
    Vec<(usize, usize, &'static str)>,
);

fn walk(address_bits: usize) -> Vec<Word> {
    vec![
        (
            "columns",
            "length and direction of the line",
            vec![
                (14, 13, "last pixel of a column: 0, 1, 2 or 3"),
                (12, 12, "falling: the minor coordinate falls along the walk"),
                (11, 11, "steep: the major axis is y"),
                (10, 0, "columns after the first"),
            ],
        ),
        (
            "first",
            "where the line begins",
            vec![
                (23, 12, "minor coordinate, signed"),
                (11, 0, "major coordinate, signed"),
            ],
        ),
        (
            "address",
            "where the line begins",
            vec![(address_bits - 1, 0, "row * frame width + column, modulo its width")],
        ),
        (
            "error",
            "error term",
            vec![(13, 0, "E behind the first column, signed; the next column moves the minor coordinate if E > 0")],
        ),
        (
            "stay",
            "error term",
            vec![(13, 0, "added to E where the minor coordinate stays, signed")],
        ),
        (
            "step",
            "error term",
            vec![(13, 0, "added to E where it moves, signed")],
        ),
    ]
}

fn weights(filter: Filter) -> Vec<Word> {
    match filter {
        Filter::Bresenham => vec![],
        Filter::Box => vec![
            (
                "level",
                "weights of the first column",
                vec![
                    (16, 16, "both weights lie half-way between two levels"),
                    (15, 8, "whole levels per column: 255 dY / dX"),
                    (7, 0, "level of the second pixel, of 255"),
                ],
            ),
            (
                "level error",
                "remainder of the levels",
                vec![(
                    13,
                    0,
                    "H behind the first column, signed; the next column carries if H > 0",
                )],
            ),
            (
                "level up",
                "remainder of the levels",
                vec![(
                    13,
                    0,
                    "added to H without a carry, signed: 2 (255 dY mod dX)",
                )],
            ),
            (
                "level down",
                "remainder of the levels",
                vec![(13, 0, "added to H with a carry, signed: level up - 2 dX")],
            ),
        ],
        Filter::Cone => vec![
            (
                "cosine",
                "distance of neighbours",
                vec![(31, 0, "dX / sqrt(dX^2 + dY^2), Q1.30")],
            ),
            (
                "distance",
                "distance of the first column's middle pixel from the line",
                vec![(
                    31,
                    0,
                    "positive when the line runs on the side of Y + 1, Q1.30",
                )],
            ),
            (
                "distance stay",
                "change of the distance",
                vec![(
                    31,
                    0,
                    "dY / sqrt(dX^2 + dY^2), added where the minor coordinate stays, Q1.30",
                )],
            ),
            (
                "distance step",
                "change of the distance",
                vec![(
                    31,
                    0,
                    "(dX - dY) / sqrt(dX^2 + dY^2), subtracted where it moves, Q1.30",
                )],
            ),
        ],
    }
}

/// The register map, in the order of the select codes.
pub fn registers(filter: Filter, address_bits: usize) -> Vec<Register> {
    let mut all = vec![];
    let mut add = |word: u8, (name, meaning, parts): Word, per| {
        let field = |(high, low, meaning): &(usize, usize, &str)| Field {
            high: *high,
            low: *low,
            meaning: (*meaning).to_owned(),
        };
        all.push(Register {
            select: word,
            target: "shell",
            word,
            name,
            bits: parts.first().map_or(0, |p| p.0 + 1),
            format: "fields".to_owned(),
            meaning,
            per,
            fields: parts.iter().map(field).collect(),
        });
    };
    let words = walk(address_bits).into_iter().chain(weights(filter));
    for (word, w) in (0u8..).zip(words) {
        add(word, w, "line");
    }
    let size: Word = (
        "size",
        "size of the frame; not double-buffered",
        vec![(23, 12, "rows"), (11, 0, "columns")],
    );
    add(11, size, "frame");
    if filter != Filter::Bresenham {
        let background: Word = (
            "background",
            "colour of an empty frame; not double-buffered",
            vec![(23, 16, "red"), (15, 8, "green"), (7, 0, "blue")],
        );
        add(12, background, "frame");
    }
    let colour: [(&str, &str); 2] = [
        ("value", "level in the first column, plus one half"),
        ("step", "change per column"),
    ];
    for (target, mask) in [("red", 1), ("green", 2), ("blue", 4)] {
        channel(
            &mut all,
            target,
            mask,
            &colour,
            COLOUR_INTEGER_BITS,
            cue::FRACTION_BITS,
        );
    }
    for r in &mut all {
        if r.per == "triangle" {
            r.per = "line";
        }
    }
    all
}

/// What was measured of the cores for 320x240, see [`super::resources`].
pub fn measured(filter: Filter) -> [Measured; 3] {
    let row = |family, lut, ff, bram, dsp| Measured {
        family,
        lut,
        ff,
        bram,
        dsp,
    };
    match filter {
        Filter::Bresenham => [
            row("spartan-3", 507, 575, 0, 0),
            row("spartan-6", 764, 575, 0, 0),
            row("spartan-7", 763, 575, 0, 0),
        ],
        Filter::Box => [
            row("spartan-3", 1389, 997, 114, 3),
            row("spartan-6", 1035, 901, 114, 3),
            row("spartan-7", 1050, 901, 57, 3),
        ],
        Filter::Cone => [
            row("spartan-3", 2088, 1159, 115, 3),
            row("spartan-6", 1200, 1071, 114, 3),
            row("spartan-7", 1199, 1071, 57, 3),
        ],
    }
}
