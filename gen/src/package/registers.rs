//! The register map of a core as data: for the manifest, the README and whoever writes a driver.

mod bump;
mod material;
mod texture;

use super::line;
use serde::Serialize;
use shadegate_hdl::light::{Glint, CONE_WORD};
use shadegate_hdl::raster::{COLUMN_BITS, ERROR_BITS};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::{DEPTH_FRACTION_BITS, DEPTH_INTEGER_BITS};

/// A part of a register word.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Field {
    /// Highest bit.
    pub high: usize,
    /// Lowest bit.
    pub low: usize,
    /// What it means.
    pub meaning: String,
}

/// One register word of one target.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Register {
    /// Select code that addresses this word alone: channel mask in bits 7 to 4, word number in bits 3 to 0.
    pub select: u8,
    /// `shell` (the walk and the weights of a line core), `depth`, and `red`, `green`, `blue`, or `light`, `lobe`, `cone`,
    /// `half`, `square`, `skips`, `material`, or `u`, `v`, `w`, `texture`, or `light u` to `half n`.
    pub target: &'static str,
    /// Word number.
    pub word: u8,
    /// Name.
    pub name: &'static str,
    /// Bits that are used.
    pub bits: usize,
    /// `fields`, or the fixed-point format of the whole word.
    pub format: String,
    /// What it means.
    pub meaning: &'static str,
    /// `triangle`, `line`: double-buffered, taken with `start`. `frame`: taken at once, written while the core is idle.
    /// `material`: taken at once, written behind the fence.
    pub per: &'static str,
    /// Parts, high to low; empty where the word is one number.
    pub fields: Vec<Field>,
}

/// Name and meaning of the words of a plane.
const PLANE: [(&str, &str); 4] = [
    ("value", "value at the first span start, plus one half"),
    ("d(p)", "first difference along the span"),
    ("d(s)", "first difference to the next span start"),
    (
        "d(t)",
        "d(s) + d(p): to the next span start when the edge carries",
    ),
];

/// Name and meaning of the words of a quadric.
const QUADRIC: [(&str, &str); 10] = [
    PLANE[0],
    PLANE[1],
    PLANE[2],
    (
        "d(t)",
        "d(s) + d(p) + dd(p, s): to the next span start when the edge carries",
    ),
    ("dd(p, p)", "second difference along the span"),
    ("dd(p, s)", "second difference, along and down"),
    ("dd(p, t)", "dd(p, s) + dd(p, p)"),
    ("dd(s, s)", "second difference, down twice"),
    ("dd(s, t)", "dd(s, s) + dd(p, s)"),
    ("dd(t, t)", "dd(s, t) + dd(p, t)"),
];

/// The whole map, in the order of the select codes of shell, red, green, blue, depth.
#[must_use]
pub fn registers(core: &Core) -> Vec<Register> {
    match core.order {
        Order::Line(filter) => return line::registers(filter, core.address_bits()),
        Order::Textured(t) => return texture::registers(core, t),
        Order::Bump(_) => return bump::registers(core),
        Order::Span(kind) => return super::span_registers::registers(core, kind),
        Order::QuadraticEngine => return super::engine_registers::registers(),
        _ => {}
    }
    let mut all = shell(core);
    let quadric = &QUADRIC[..];
    let plane = &PLANE[..];
    let colours = match core.order {
        Order::Linear | Order::Line(_) | Order::Span(_) | Order::Textured(_) | Order::Bump(_) => {
            &[("red", 1), ("green", 2), ("blue", 4)].map(|c| (c, plane))[..]
        }
        Order::Quadratic | Order::QuadraticEngine => {
            &[("red", 1), ("green", 2), ("blue", 4)].map(|c| (c, quadric))
        }
        Order::QuadraticDots => &[("light", 1), ("lobe", 2)].map(|c| (c, quadric)),
        Order::Glint(Glint::Kappa) => &[("light", 1), ("lobe", 2)].map(|c| (c, quadric)),
        Order::Glint(Glint::Spot) => {
            &[("light", 1), ("lobe", 2), ("cone", 8)].map(|c| (c, quadric))
        }
        Order::Duff => &[
            (("light", 1), plane),
            (("half", 1), plane),
            (("square", 2), quadric),
        ],
    };
    let formats = core.formats();
    for (i, ((target, mask), words)) in colours.iter().enumerate() {
        let (_, int, frac) = formats[i.min(formats.len() - 1)];
        channel(&mut all, target, *mask, words, int, frac);
    }
    if core.order == Order::Duff {
        // The words of N·H follow those of N·L.
        for r in all.iter_mut().filter(|r| r.target == "half") {
            (r.select, r.word) = (r.select | 4, r.word | 4);
        }
        all.push(material::scale());
    }
    // The words of the cone follow those of the depth.
    for r in all.iter_mut().filter(|r| r.target == "cone") {
        r.word += CONE_WORD as u8;
        r.select += CONE_WORD as u8;
    }
    if matches!(core.order, Order::QuadraticDots | Order::Duff) {
        all.extend(material::registers());
    }
    if let Order::Glint(glint) = core.order {
        all.extend(material::glints(glint));
    }
    channel(
        &mut all,
        "depth",
        8,
        plane,
        DEPTH_INTEGER_BITS,
        DEPTH_FRACTION_BITS,
    );
    all
}

pub(super) fn channel(
    all: &mut Vec<Register>,
    target: &'static str,
    mask: u8,
    words: &[(&'static str, &'static str)],
    int: usize,
    frac: usize,
) {
    for (word, (name, meaning)) in (0u8..).zip(words) {
        all.push(Register {
            select: mask << 4 | word,
            target,
            word,
            name,
            bits: 1 + int + frac,
            format: format!("Q{int}.{frac}"),
            meaning,
            per: "triangle",
            fields: vec![],
        });
    }
}

fn shell(core: &Core) -> Vec<Register> {
    let field = |high, low, meaning: &str| Field {
        high,
        low,
        meaning: meaning.to_owned(),
    };
    let error = ERROR_BITS - 1;
    let column = ERROR_BITS + COLUMN_BITS - 1;
    let address = 10 + core.address_bits();
    let mut all = vec![];
    let mut add = |name, meaning, per, fields: Vec<Field>| {
        let word = all.len() as u8;
        let bits = fields.first().map_or(0, |f: &Field| f.high + 1);
        all.push(Register {
            select: word,
            target: "shell",
            word,
            name,
            bits,
            format: "fields".to_owned(),
            meaning,
            per,
            fields,
        });
    };
    add(
        "rows",
        "height and orientation of the triangle",
        "triangle",
        vec![
            field(22, 22, "mirrored: the major edge is the right one"),
            field(21, 11, "upper rows: rows that end at the upper minor edge"),
            field(10, 0, "rows in all"),
        ],
    );
    add(
        "first",
        "where the triangle begins",
        "triangle",
        vec![
            field(
                address,
                11,
                "address of column 0 of the first row: first row * frame width",
            ),
            field(10, 0, "first row"),
        ],
    );
    let edges = [
        ["major start", "major step", "major down"],
        ["upper start", "upper step", "upper down"],
        ["lower start", "lower step", "lower down"],
    ];
    for [start, step, down] in edges {
        let meaning = match start {
            "major start" => "edge from top to bottom",
            "upper start" => "edge from top to middle",
            _ => "edge from middle to bottom",
        };
        add(
            start,
            meaning,
            "triangle",
            vec![
                field(column, ERROR_BITS, "column at its first row, signed"),
                field(error, 0, "error term there, signed"),
            ],
        );
        add(
            step,
            meaning,
            "triangle",
            vec![
                field(column, ERROR_BITS, "whole columns per row, signed"),
                field(error, 0, "error step without a carry, signed"),
            ],
        );
        add(
            down,
            meaning,
            "triangle",
            vec![field(error, 0, "error step with a carry, signed")],
        );
    }
    add(
        "width",
        "width of the frame; not double-buffered",
        "frame",
        vec![field(11, 0, "columns")],
    );
    all
}
