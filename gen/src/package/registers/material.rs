//! The words of a material, and the fence before them.

use super::{Field, Register};
use shadegate_hdl::light::{Glint, CURVE_WORD, SKIP_WORD};
use shadegate_hdl::shade::phong::unit_cosines::SCALE_WORD;
use shadegate_hdl::shade::phong::{
    AMBIENT_FRACTION_BITS, FENCE_WORD, TABLE_PLACE_WORD, TABLE_WORD, TINT_FRACTION_BITS,
};
use shadegate_hdl::shade::COLOUR_INTEGER_BITS;

/// Names of the colour words.
const COLOURS: [(&str, &str); 9] = [
    ("red ambient", "red without any light, plus one half"),
    ("red diffuse", "red of the diffuse reflection"),
    ("red specular", "red of the highlight"),
    ("green ambient", "green without any light, plus one half"),
    ("green diffuse", "green of the diffuse reflection"),
    ("green specular", "green of the highlight"),
    ("blue ambient", "blue without any light, plus one half"),
    ("blue diffuse", "blue of the diffuse reflection"),
    ("blue specular", "blue of the highlight"),
];

/// The fence.
pub fn fence() -> Register {
    fields(
        "shell",
        FENCE_WORD,
        "fence",
        "lowers load_ready until all pixels before it have been coloured",
        vec![field(0, 0, "anything")],
    )
}

/// Fence and colours.
fn colours() -> Vec<Register> {
    let mut all = vec![fence()];
    for (word, (name, meaning)) in (0u8..).zip(COLOURS) {
        let frac = match word % 3 {
            0 => AMBIENT_FRACTION_BITS,
            _ => TINT_FRACTION_BITS,
        };
        all.push(Register {
            select: 0x40 | word,
            target: "material",
            word,
            name,
            bits: 1 + COLOUR_INTEGER_BITS + frac,
            format: format!("Q{COLOUR_INTEGER_BITS}.{frac}"),
            meaning,
            per: "material",
            fields: vec![],
        });
    }
    all
}

/// Fence and material of a core without tables, and what a triangle does without.
pub fn glints(glint: Glint) -> Vec<Register> {
    let mut all = colours();
    let mut parts = vec![field(2, 0, "degree of the highlight: 2, 3 or 4")];
    if glint == Glint::Spot {
        parts.insert(0, field(3, 3, "the fall-off of the spot is the hard one"));
    }
    all.push(fields(
        "material",
        CURVE_WORD,
        "curves",
        "what makes highlight and spot",
        parts,
    ));
    all.push(Register {
        select: 0x80 | SKIP_WORD as u8,
        per: "triangle",
        ..fields(
            "skips",
            SKIP_WORD,
            "skips",
            "what the triangle does without; the words of those cosines need not be written",
            vec![
                field(1, 1, "no diffuse reflection"),
                field(0, 0, "no highlight; with both, no light at all"),
            ],
        )
    });
    all
}

/// Fence and material.
pub fn registers() -> Vec<Register> {
    let mut all = colours();
    all.push(fields(
        "material",
        TABLE_PLACE_WORD,
        "interval",
        "where the power table is written",
        vec![field(8, 0, "interval, 0 to 511")],
    ));
    all.push(fields(
        "material",
        TABLE_WORD,
        "power",
        "the power in that interval; the next interval is meant afterwards",
        vec![
            field(31, 14, "power at its beginning, in 2^-18"),
            field(13, 0, "how far it falls to its end, in 2^-18"),
        ],
    ));
    all
}

/// The scale of the lobe, for cores that work it out.
pub fn scale() -> Register {
    fields(
        "material",
        SCALE_WORD,
        "scale",
        "scale of the lobe",
        vec![field(2, 0, "s")],
    )
}

fn field(high: usize, low: usize, meaning: &str) -> Field {
    Field {
        high,
        low,
        meaning: meaning.to_owned(),
    }
}

fn fields(
    target: &'static str,
    word: usize,
    name: &'static str,
    meaning: &'static str,
    fields: Vec<Field>,
) -> Register {
    let mask = if target == "shell" { 0 } else { 0x40 };
    Register {
        select: mask | word as u8,
        target,
        word: word as u8,
        name,
        bits: fields.first().map_or(0, |f| f.high + 1),
        format: "fields".to_owned(),
        meaning,
        per: "material",
        fields,
    }
}
