//! A material for the cores that shade per pixel: every write of it, and the colour it gives.

use shadegate_hdl::light::Glint;
use shadegate_hdl::shade::model::Order;

/// Ambient, diffuse and specular colour words of red, green and blue.
const COLOURS: [u64; 9] = [
    (20 << 12) + 2048,
    150 << 6,
    90 << 6,
    (10 << 12) + 2048,
    (80 << 6) + 5,
    120 << 6,
    2048,
    0,
    255 << 6,
];

/// A table that falls evenly from 1 to 0.
fn table() -> impl Iterator<Item = u32> {
    (0..512).map(|i| (((1 << 18) - 1 - 512 * i) << 14) | 511)
}

/// Fence and material (select, data).
pub fn writes(order: Order) -> Vec<(u8, u64)> {
    match order {
        Order::Linear
        | Order::Quadratic
        | Order::QuadraticEngine
        | Order::Line(_)
        | Order::Span(_) => vec![],
        Order::Textured(_) => super::picture::writes(),
        Order::Glint(_) => {
            let colours = (0x40..).zip(COLOURS);
            let curve = [(0x49, 3 | 1 << 3)];
            [(12, 0)].into_iter().chain(colours).chain(curve).collect()
        }
        Order::Bump(_) => {
            let mut all = writes(Order::Duff);
            all.extend(super::bumps::writes());
            all
        }
        Order::QuadraticDots | Order::Duff => {
            let colours = (0x40..).zip(COLOURS);
            let words = table().map(|w| (0x4a, u64::from(w)));
            [(12, 0)]
                .into_iter()
                .chain(colours)
                .chain([(0x49, 0)])
                .chain(words)
                .collect()
        }
    }
}

/// The colour of N·L in units of 2^-16 and places in lobe and cone in units of 2^-19, in integers of its own: a cube and
/// a hard spot.
pub fn glint(channel: usize, glint: Glint, [light, place, cone]: [i64; 3]) -> i64 {
    let word = |i: usize| COLOURS[3 * channel + i] as i64;
    let one = (1i64 << 17) - 1;
    let within = |place: i64| (place < 1 << 19).then_some(place.max(0) / 4);
    let cube = |t: i64| ((one - t) * (one - t) / (1 << 17)) * (one - t) / (1 << 17);
    let mut power = within(place).map_or(0, cube);
    let mut light = light.clamp(0, 1 << 16);
    if glint == Glint::Spot {
        let spot = within(cone).map_or(0, |v| one - v * v / (1 << 17));
        (light, power) = (light * spot / (1 << 17), power * spot / (1 << 17));
    }
    let matt = word(0) + ((word(1) * light) >> 10);
    (matt + ((word(2) * power) >> 11)) >> 12
}

/// The colour of N·L in units of 2^-16 and of a place in the lobe in units of 2^-19, in integers of its own.
pub fn level(channel: usize, light: i64, place: i64) -> i64 {
    let word = |i: usize| COLOURS[3 * channel + i] as i64;
    let light = light.clamp(0, 1 << 16);
    let power = match place.max(0) {
        beyond if beyond >= 1 << 19 => 0,
        place => {
            let start = (1 << 18) - 1 - 512 * (place >> 10);
            (start - ((511 * (place & 1023)) >> 10)) >> 1
        }
    };
    let matt = word(0) + ((word(1) * light) >> 10);
    (matt + ((word(2) * power) >> 11)) >> 12
}
