//! The words of a bump core: both vectors, the place in the map, the material with its map, and the fence.

use super::{channel, material, shell, Field, Register, PLANE, QUADRIC};
use shadegate_hdl::bump::{select, BUMPY_WORD, MAP_PLACE_WORD, MAP_WORD};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::{DEPTH_FRACTION_BITS, DEPTH_INTEGER_BITS};

const LIGHT: [&str; 3] = ["light u", "light v", "light n"];
const HALF: [&str; 3] = ["half u", "half v", "half n"];

/// The whole map.
pub fn registers(core: &Core) -> Vec<Register> {
    let mut all = shell(core);
    all.extend(material::registers());
    all.push(material::scale());
    all.extend(words_of_the_map());
    let [(_, int, frac), (_, u_int, u_frac)] = core.formats()[..] else {
        return all;
    };
    let vectors = LIGHT.into_iter().zip(select::LIGHT);
    for (target, mask) in vectors.chain(HALF.into_iter().zip(select::HALF)) {
        channel(&mut all, target, mask >> 4, &QUADRIC, int, frac);
    }
    for (target, mask) in [("u", select::U), ("v", select::V)] {
        channel(&mut all, target, mask >> 4, &PLANE, u_int, u_frac);
    }
    let (int, frac) = (DEPTH_INTEGER_BITS, DEPTH_FRACTION_BITS);
    channel(&mut all, "depth", select::DEPTH >> 4, &PLANE, int, frac);
    all
}

fn words_of_the_map() -> [Register; 3] {
    let field = |high, low, meaning: &str| Field {
        high,
        low,
        meaning: meaning.to_owned(),
    };
    let word = |word: usize, name, meaning, fields: Vec<Field>| Register {
        select: select::MATERIAL | word as u8,
        target: "material",
        word: word as u8,
        name,
        bits: fields.first().map_or(0, |f| f.high + 1),
        format: "fields".to_owned(),
        meaning,
        per: "material",
        fields,
    };
    [
        word(
            MAP_PLACE_WORD,
            "sample place",
            "where the map is written",
            vec![field(11, 6, "row"), field(5, 0, "column")],
        ),
        word(
            MAP_WORD,
            "sample",
            "the gradient there, plus one unit; the next place is meant afterwards",
            vec![
                field(35, 18, "along the columns, signed, 2^-16"),
                field(17, 0, "along the rows, signed, 2^-16"),
            ],
        ),
        word(
            BUMPY_WORD,
            "bumpy",
            "whether the map bends normals",
            vec![field(0, 0, "it does")],
        ),
    ]
}
