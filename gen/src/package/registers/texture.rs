//! The words of a textured core: colours, addresses, the picture and its texels, and the fence.

use super::{channel, material, shell, Field, Register, PLANE, QUADRIC};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::{DEPTH_FRACTION_BITS, DEPTH_INTEGER_BITS};
use shadegate_hdl::texture::{select, Mapping, Texturing, BANK_BITS, W_FRACTION_BITS};

/// The whole map.
pub fn registers(core: &Core, t: Texturing) -> Vec<Register> {
    let mut all = shell(core);
    all.push(material::fence());
    for (target, mask) in [("red", 1), ("green", 2), ("blue", 4)] {
        let (_, int, frac) = core.formats()[0];
        channel(&mut all, target, mask, &QUADRIC, int, frac);
    }
    let (int, frac) = t.mapping.format(core.wide);
    let words: &[_] = match t.mapping {
        Mapping::Quadratic => &QUADRIC,
        _ => &PLANE,
    };
    for (target, mask) in [("u", select::U >> 4), ("v", select::V >> 4)] {
        channel(&mut all, target, mask, words, int, frac);
    }
    if t.mapping == Mapping::Perspective {
        channel(&mut all, "w", select::W >> 4, &PLANE, 1, W_FRACTION_BITS);
    }
    all.extend(words_of_the_texture());
    channel(
        &mut all,
        "depth",
        8,
        &PLANE,
        DEPTH_INTEGER_BITS,
        DEPTH_FRACTION_BITS,
    );
    all
}

fn words_of_the_texture() -> [Register; 4] {
    let field = |high, low, meaning: &str| Field {
        high,
        low,
        meaning: meaning.to_owned(),
    };
    let word = |select: u8, name, meaning, fields: Vec<Field>| Register {
        select,
        target: "texture",
        word: select & 15,
        name,
        bits: fields.first().map_or(0, |f| f.high + 1),
        format: "fields".to_owned(),
        meaning,
        per: "material",
        fields,
    };
    [
        word(
            select::PLACE,
            "place",
            "where the picture begins",
            vec![
                field(
                    BANK_BITS,
                    BANK_BITS,
                    "nearest texel instead of a bilinear mean",
                ),
                field(BANK_BITS - 1, 0, "texels before it, divided by four"),
            ],
        ),
        word(
            select::SIZE,
            "size",
            "sides of the picture",
            vec![
                field(21, 18, "logarithm of half the columns"),
                field(17, 9, "half the rows, less one"),
                field(8, 0, "half the columns, less one"),
            ],
        ),
        word(
            select::WRITE_PLACE,
            "texel place",
            "where the texture memory is written",
            vec![
                field(15, 2, "block of two by two texels"),
                field(1, 1, "its odd row"),
                field(0, 0, "its odd column"),
            ],
        ),
        word(
            select::TEXEL,
            "texel",
            "the texel there; the next place is meant afterwards",
            vec![
                field(23, 16, "red"),
                field(15, 8, "green"),
                field(7, 0, "blue"),
            ],
        ),
    ]
}
