//! A map for the bump cores: every write of it, what is interpolated on a triangle, and the cosines that they give.

use super::{Polynomial, Triangle};
use shadegate_hdl::bump::core_model;
use shadegate_hdl::bump::{select, Bend, BUMPY_WORD, MAP_PLACE_WORD, MAP_WORD};
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::phong::unit_cosines::SCALE_WORD;

/// The bump cores.
pub const BUMPS: [Order; 2] = [Order::Bump(Bend::Newton), Order::Bump(Bend::Reflection)];

/// Scale of the lobe.
const SCALE: u64 = 1;

/// F_u and F_v of a sample, 2^-16.
fn sample(x: i64, y: i64) -> [i64; 2] {
    let (x, y) = (x.rem_euclid(64), y.rem_euclid(64));
    [
        (x * 977 + y * 313) % 110_000 - 55_000,
        (x * y * 41) % 140_000 - 70_000,
    ]
}

/// Scale, map and that there are bumps (select, data).
pub fn writes() -> Vec<(u8, u64)> {
    let word = |number: usize, data: u64| (select::MATERIAL | number as u8, data);
    let mut out = vec![word(SCALE_WORD, SCALE), word(MAP_PLACE_WORD, 0)];
    for i in 0..4096 {
        let [u, v] = sample(i % 64, i / 64).map(|s| s as u64 & 0x3_ffff);
        out.push(word(MAP_WORD, u << 18 | v));
    }
    out.push(word(BUMPY_WORD, 1));
    out
}

/// Half-way vector, u and v of a triangle in codes of their interpolants; the light is its colour.
pub fn channels(t: &Triangle) -> Vec<Polynomial> {
    let [a, b, c] = t.colour;
    let [p, q] = [t.corners[0].x, t.corners[1].y].map(i64::from);
    let plane = |c: i64, x: i64, y: i64| Polynomial([c << 10, x << 10, y << 10, 0, 0, 0]);
    vec![
        c,
        a,
        b,
        plane(p * 9, 1000 + q % 700, -300),
        plane(q * 5, 77, 2000 - p % 900),
    ]
}

/// First select code of a channel and its words: light, depth, half-way vector, u, v.
pub fn words(channel: usize) -> (u8, u8) {
    match channel {
        0..=2 => (select::LIGHT[channel], 10),
        3 => (select::DEPTH, 4),
        4..=6 => (select::HALF[channel - 4], 10),
        7 => (select::U, 4),
        _ => (select::V, 4),
    }
}

/// F_u and F_v between the samples, in integers of its own.
fn slope([u, v]: [i64; 2]) -> [i64; 2] {
    let ([x, y], [f, g]) = ([u >> 12, v >> 12], [u & 4095, v & 4095]);
    let between = |a: i64, b: i64, part: i64| a + ((b - a) * part).div_euclid(4096);
    [0, 1].map(|i| {
        let row = |y: i64| between(sample(x, y)[i], sample(x + 1, y)[i], f);
        between(row(y), row(y + 1), g)
    })
}

/// N·L and place in the lobe where the polynomials have these values.
pub fn arguments(t: &Triangle, bend: Bend, at: impl Fn(&Polynomial) -> i64) -> [i64; 2] {
    let rest = channels(t);
    let part = |p: &Polynomial| at(p) >> 19;
    let light = t.colour.map(|p| part(&p));
    let half = [part(&rest[0]), part(&rest[1]), part(&rest[2])];
    let slope = slope([at(&rest[3]) >> 10, at(&rest[4]) >> 10]);
    let cosines = [light, half].map(|v| core_model::cosine(bend, slope, v));
    core_model::arguments(cosines, SCALE)
}
