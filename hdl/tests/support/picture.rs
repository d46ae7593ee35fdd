//! A picture for the textured cores: every write of it, addresses on a triangle, and the colour they give in integers.

use super::{Polynomial, Triangle};
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::texture::blend::blend_model;
use shadegate_hdl::texture::division::division_model;
use shadegate_hdl::texture::modulate::modulate_model;
use shadegate_hdl::texture::{select, Mapping, Texturing};

/// The textured cores.
pub const TEXTURED: [Order; 3] = [
    textured(Mapping::Affine),
    textured(Mapping::Quadratic),
    textured(Mapping::Perspective),
];

const fn textured(mapping: Mapping) -> Order {
    Order::Textured(Texturing {
        mapping,
        texels_log2: 8,
    })
}

/// Columns and rows.
const SIZE: [i64; 2] = [16, 8];
/// Word of a bank at which it begins.
const BASE: i64 = 5;

/// Red, green, blue of a texel.
fn texel(x: i64, y: i64) -> [i64; 3] {
    [
        (x * 37 + y * 11) % 256,
        255 - (x * y) % 256,
        (x ^ y) * 16 % 256,
    ]
}

/// Fence, place, size and texels (select, data).
pub fn writes() -> Vec<(u8, u64)> {
    let [columns, rows] = SIZE.map(|n| n as u64 / 2 - 1);
    let shift = 3;
    let mut out = vec![
        (12, 0),
        (select::PLACE, BASE as u64),
        (select::SIZE, columns | rows << 9 | shift << 18),
        (select::WRITE_PLACE, 4 * BASE as u64),
    ];
    for pair in 0..SIZE[0] * SIZE[1] / 4 {
        for bank in 0..4 {
            let (x, y) = (2 * (pair % 8) + bank % 2, 2 * (pair / 8) + bank / 2);
            let [r, g, b] = texel(x, y);
            out.push((select::TEXEL, (r << 16 | g << 8 | b) as u64));
        }
    }
    out
}

/// u, v and w of a triangle in codes of their interpolants.
pub fn addresses(t: &Triangle, mapping: Mapping, fraction: usize) -> [Polynomial; 3] {
    let [a, b] = [t.corners[0].x, t.corners[1].y].map(i64::from);
    let unit = 1i64 << (fraction - 12);
    let plane = |c: i64, x: i64, y: i64| Polynomial([c * unit, x * unit, y * unit, 0, 0, 0]);
    let (mut u, mut v) = (
        plane(a * 9, 1000 + b % 700, -300),
        plane(b * 5, 77, 2000 - a % 900),
    );
    if mapping == Mapping::Quadratic {
        u.0[3] = 13 * unit;
        v.0[4] = -7 * unit;
    }
    // 1/z falls from 0.6 to about a third of it over a frame of 64 columns.
    let w = Polynomial([0x2666_6666_6666, -(0x2666_6666_6666 / 96), 1 << 36, 0, 0, 0]);
    [u, v, w]
}

/// The colour of codes with six fraction bits at an address in codes.
pub fn level(colour: [i64; 3], address: [i64; 3], mapping: Mapping, fraction: usize) -> [i64; 3] {
    let [u, v, w] = address;
    let place = match mapping {
        Mapping::Perspective => division_model(u >> 9, v >> 9, w >> 7),
        _ => [u, v].map(|x| x >> (fraction - 12)),
    };
    let [x, y] = place.map(|p| p >> 12);
    let [f, g] = place.map(|p| p & 4095);
    let at = |dx: i64, dy: i64| texel((x + dx).rem_euclid(SIZE[0]), (y + dy).rem_euclid(SIZE[1]));
    // The even column first, the even row first.
    let (odd_x, odd_y) = (x & 1, y & 1);
    let weight = |odd: i64, f: i64| if odd == 1 { 4096 - f } else { f };
    std::array::from_fn(|c| {
        let of = |i: i64, j: i64| at(i ^ odd_x, j ^ odd_y)[c];
        let four = [of(0, 0), of(1, 0), of(0, 1), of(1, 1)];
        let mean = blend_model(four, weight(odd_x, f), weight(odd_y, g));
        modulate_model(colour[c], mean)
    })
}
