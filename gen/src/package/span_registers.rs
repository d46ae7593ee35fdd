//! The register map of the span cores, as data.

use super::registers::{Field, Register};
use shadegate_hdl::lit::angle::{FRACTION_BITS, TURNS_BITS};
use shadegate_hdl::lit::channel::COLOUR_FRACTION_BITS;
use shadegate_hdl::lit::loader;
use shadegate_hdl::raster::span_shell;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_hdl::shade::{COLOUR_INTEGER_BITS, DEPTH_FRACTION_BITS, DEPTH_INTEGER_BITS};

/// What a core draws, for the README of its package.
pub fn about(kind: SpanKind) -> &'static str {
    match kind {
        SpanKind::Slerp => {
            "the cosines of a normal that turns evenly along each span, by differences"
        }
        SpanKind::Chebyshev => {
            "the cosines of a normal that turns evenly along each span, by Chebyshev's recurrence"
        }
        SpanKind::Spherical(_) => {
            "cos and cos² from tables at angles that grow evenly along each span"
        }
        SpanKind::SphericalPower(_) => {
            "cos and a material's cosⁿ from tables at angles that grow evenly along each span"
        }
        SpanKind::Blake | SpanKind::BlakeRefit | SpanKind::BlakeTrapezium => {
            "cosines and their powers in quadratic pieces along each span"
        }
    }
}

/// Name, meaning and format of a term's words.
fn term(kind: SpanKind) -> [(&'static str, &'static str, usize, String); 3] {
    let cosine = || "Q1.30".to_owned();
    match kind {
        SpanKind::Slerp => [
            ("value", "cosine at the first pixel", 32, cosine()),
            ("change", "its change up to the first pixel", 32, cosine()),
            (
                "kappa",
                "4 sin²(K/2), K the angle between pixels",
                27,
                "fields".to_owned(),
            ),
        ],
        SpanKind::Chebyshev => [
            ("value", "cosine at the first pixel", 32, cosine()),
            ("before", "cosine a pixel before", 32, cosine()),
            (
                "twice",
                "2 cos K, K the angle between pixels",
                25,
                "Q2.22".to_owned(),
            ),
        ],
        SpanKind::Spherical(bits) | SpanKind::SphericalPower(bits) => {
            let (int, frac) = (bits + TURNS_BITS, FRACTION_BITS);
            let phase = format!("Q{int}.{frac}");
            let width = 1 + int + frac;
            [
                (
                    "phase",
                    "angle at the first pixel, in table words",
                    width,
                    phase.clone(),
                ),
                ("step", "its change from pixel to pixel", width, phase),
                (
                    "amplitude",
                    "amplitude times 2^K/(2^K - 1), K the bits of a table word",
                    18,
                    "U2.16".to_owned(),
                ),
            ]
        }
        SpanKind::Blake | SpanKind::BlakeRefit | SpanKind::BlakeTrapezium => [
            ("value", "factor at the first pixel", 32, cosine()),
            ("change", "its first difference there", 32, cosine()),
            ("bend", "its second difference", 32, cosine()),
        ],
    }
}

/// The whole map, in the order of the select codes.
pub fn registers(core: &Core, kind: SpanKind) -> Vec<Register> {
    let field = |high, low, meaning: &str| Field {
        high,
        low,
        meaning: meaning.to_owned(),
    };
    let mut all = vec![];
    let mut add = |select: u8, target, name, bits, format: &str, meaning, per, fields| {
        all.push(Register {
            select,
            target,
            word: select & 15,
            name,
            bits,
            format: format.to_owned(),
            meaning,
            per,
            fields,
        });
    };
    let place = vec![
        field(31, 21, "pixels"),
        field(20, 10, "first column"),
        field(0, 0, "the span lies one row below the words' last one"),
    ];
    add(
        0,
        "shell",
        "place",
        32,
        "fields",
        "where the span lies",
        "triangle",
        place,
    );
    let row = vec![
        field(30, 21, "row"),
        field(
            core.address_bits() - 1,
            0,
            "address of its column 0: row * frame width",
        ),
    ];
    let meaning = "row of the span; word 0 may step it";
    add(1, "shell", "row", 31, "fields", meaning, "triangle", row);
    let code = |word: usize| word as u8;
    let tables = match kind {
        SpanKind::Slerp | SpanKind::Chebyshev => Some(32),
        SpanKind::Spherical(bits) | SpanKind::SphericalPower(bits) => Some(bits),
        SpanKind::Blake | SpanKind::BlakeRefit | SpanKind::BlakeTrapezium => None,
    };
    if tables.is_some() {
        let at = vec![field(11, 0, "place of the next table word")];
        let meaning = "where table words go; every table word moves it on";
        add(
            code(loader::POINTER),
            "shell",
            "pointer",
            12,
            "fields",
            meaning,
            "frame",
            at,
        );
    }
    match (kind, tables) {
        (SpanKind::Slerp | SpanKind::Chebyshev, _) => {
            let chord = vec![
                field(31, 14, "value at the begin of the interval, 2^17 is 1"),
                field(13, 0, "what the chord falls by along it"),
            ];
            let meaning = "a word of the highlight table, place 4 * interval + material";
            add(
                code(loader::HIGHLIGHT),
                "shell",
                "chord",
                32,
                "fields",
                meaning,
                "frame",
                chord,
            );
        }
        (_, Some(bits)) => {
            let word = vec![field(bits - 1, 0, "highlight, 2^K - 1 is 1")];
            let meaning = "a word of the highlight table, place 4 * angle + material";
            add(
                code(loader::HIGHLIGHT),
                "shell",
                "power",
                bits,
                "fields",
                meaning,
                "frame",
                word,
            );
            let word = vec![field(bits - 1, 0, "cosine, 2^K - 1 is 1")];
            let meaning = "a word of the cosine table, place the angle";
            add(
                code(loader::COSINE),
                "shell",
                "cosine",
                bits,
                "fields",
                meaning,
                "frame",
                word,
            );
        }
        _ => {}
    }
    let columns = vec![field(10, 0, "columns of the frame")];
    let meaning = "frame width in columns; written while the core is idle";
    add(
        code(span_shell::COLUMNS),
        "shell",
        "columns",
        11,
        "fields",
        meaning,
        "frame",
        columns,
    );
    let style = vec![
        field(
            4,
            2,
            "binary places that the highlight table is stretched by",
        ),
        field(1, 0, "material"),
    ];
    let meaning = "material of the span";
    add(
        code(span_shell::STYLE),
        "shell",
        "style",
        5,
        "fields",
        meaning,
        "triangle",
        style,
    );
    let colour = vec![
        field(31, 30, "material"),
        field(
            29,
            26,
            "3 * channel + part; parts ambient, diffuse, highlight",
        ),
        field(17, 0, "colour in LSB; the ambient one plus one half"),
    ];
    let q = format!("fields, Q{COLOUR_INTEGER_BITS}.{COLOUR_FRACTION_BITS}");
    let meaning = "a colour of a material";
    add(
        code(loader::COLOUR),
        "shell",
        "colour",
        32,
        &q,
        meaning,
        "frame",
        colour,
    );
    for (target, mask) in [("diffuse", 1u8), ("highlight", 2)] {
        for (word, (name, meaning, bits, format)) in (0u8..).zip(term(kind)) {
            let fields = if name == "kappa" {
                vec![
                    field(26, 25, "exponent e"),
                    field(23, 0, "mantissa; kappa = mantissa * 2^(-22 - 8 e)"),
                ]
            } else {
                vec![]
            };
            add(
                mask << 4 | word,
                target,
                name,
                bits,
                &format,
                meaning,
                "triangle",
                fields,
            );
        }
    }
    let depth = format!("Q{DEPTH_INTEGER_BITS}.{DEPTH_FRACTION_BITS}");
    let meaning = "depth at the first pixel, plus one half";
    add(
        0x80,
        "depth",
        "value",
        32,
        &depth,
        meaning,
        "triangle",
        vec![],
    );
    let meaning = "its change from pixel to pixel";
    add(
        0x81,
        "depth",
        "step",
        32,
        &depth,
        meaning,
        "triangle",
        vec![],
    );
    all
}
