//! A host for whole cores: turns triangles and polynomials into legal register words, writes them, collects pixels.
#![allow(dead_code, unused_imports)]

mod bumps;
mod machine;
mod material;
mod picture;

pub use bumps::BUMPS;
pub use machine::{check_done, taken, Machine, Pixel};
pub use picture::TEXTURED;

use rand::rngs::StdRng;
use rand::Rng;
use shadegate_hdl::light::Glint;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::phong::root_model::arguments;
use shadegate_hdl::shade::saturate::saturate_model;
use shadegate_hdl::shade::{DEPTH_BIAS, DEPTH_FRACTION_BITS};
use shadegate_hdl::texture::model::colour_in;
use shadegate_hdl::texture::Mapping;
use shadegate_reference::raster::{EdgeDda, Point, Viewport, Walk};
use std::ops::Range;

/// A polynomial over the frame in integer codes: c + a·x + b·y + (d·x² + e·x·y + f·y²).
#[derive(Clone, Copy, Debug, Default)]
pub struct Polynomial(pub [i64; 6]);

impl Polynomial {
    /// A constant.
    pub fn constant(c: i64) -> Self {
        Self([c, 0, 0, 0, 0, 0])
    }

    /// Its code at a pixel.
    pub fn at(&self, x: i64, y: i64) -> i64 {
        let [c, a, b, d, e, f] = self.0;
        c + a * x + b * y + d * x * x + e * x * y + f * y * y
    }

    /// The ten register words from (x, y) along the pixel step and the two line steps; a plane uses the first four.
    fn words(&self, x: i64, y: i64, steps: [(i64, i64); 3]) -> [i64; 10] {
        let sum = |a: (i64, i64), b: (i64, i64)| (a.0 + b.0, a.1 + b.1);
        let f = |s: (i64, i64)| self.at(x + s.0, y + s.1);
        let d = |s| f(s) - f((0, 0));
        let dd = |s, t| f(sum(s, t)) - f(s) - f(t) + f((0, 0));
        let [p, s, t] = steps;
        let second = [dd(p, p), dd(p, s), dd(p, t), dd(s, s), dd(s, t), dd(t, t)];
        let mut words = [f((0, 0)), d(p), d(s), d(t), 0, 0, 0, 0, 0, 0];
        words[4..].copy_from_slice(&second);
        words
    }
}

/// The depth interpolant's code of a depth.
pub fn depth_code(depth: u16) -> i64 {
    (i64::from(depth) - DEPTH_BIAS) << DEPTH_FRACTION_BITS
}

/// A triangle with what is interpolated over it.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    /// Corners in 1/256 pixel.
    pub corners: [Point; 3],
    /// Red, green, blue in codes of the core's colour format; N·L, place in the lobe and nothing for a core that shades
    /// per pixel.
    pub colour: [Polynomial; 3],
    /// Depth in codes of the core's depth format, see [`depth_code`].
    pub depth: Polynomial,
}

impl Triangle {
    /// A triangle of one colour and depth; corners in pixels.
    pub fn flat(corners: [(f64, f64); 3], depth: u16) -> Self {
        Self {
            corners: corners.map(|(x, y)| Point::snap(x, y).unwrap()),
            colour: [Polynomial::default(); 3],
            depth: Polynomial::constant(depth_code(depth)),
        }
    }

    fn walk(&self, size: Viewport) -> Option<Walk> {
        Walk::new(self.corners, size)
    }

    /// The register writes (select, data); none when no row is crossed.
    pub fn writes(&self, order: Order, size: Viewport) -> Vec<(u8, u64)> {
        let Some(w) = self.walk(size) else {
            return vec![];
        };
        let upper = w.minor[usize::from(w.upper_rows == 0)];
        let first = u64::from(w.first_row as u32);
        let mut shell = vec![
            u64::from(w.mirrored) << 22 | u64::from(w.upper_rows) << 11 | u64::from(w.rows),
            (first * u64::from(size.width)) << 11 | first,
        ];
        for e in [w.major, upper, w.minor[1]] {
            shell.extend(edge_words(&e));
        }
        let mut writes: Vec<(u8, u64)> = (0..).zip(shell).collect();
        let side = if w.mirrored { -1 } else { 1 };
        let column = i64::from(w.major.column);
        let x = if w.mirrored { !column } else { column };
        let whole = i64::from(w.major.whole);
        let steps = [(side, 0), (side * whole, 1), (side * (whole + 1), 1)];
        let mut channels = vec![self.colour[0], self.colour[1], self.colour[2], self.depth];
        if let Order::Textured(t) = order {
            let fraction = t.mapping.format(false).1;
            channels.extend(picture::addresses(self, t.mapping, fraction));
        }
        if let Order::Bump(_) = order {
            channels.extend(bumps::channels(self));
        }
        for (channel, polynomial) in channels.iter().enumerate() {
            let words = polynomial.words(x, i64::from(w.first_row), steps);
            let (select, count): (u8, u8) = match (order, channel) {
                (Order::QuadraticDots, 2) => (0, 0),
                (Order::Bump(_), channel) => bumps::words(channel),
                (Order::Textured(_), 0..=2) => (16 << channel, 10),
                (Order::Textured(t), 4 | 5) if t.mapping == Mapping::Quadratic => {
                    (0x80 | 1 << channel, 10)
                }
                (Order::Textured(t), 6) if t.mapping != Mapping::Perspective => (0, 0),
                (Order::Textured(_), 4..=6) => (0x80 | 1 << channel, 4),
                (Order::Duff, 0) => (0x10, 4),
                (Order::Duff, 1) => (0x14, 4),
                (Order::Duff, 2) => (0x20, 10),
                (Order::Glint(Glint::Kappa), 2) => (0, 0),
                (Order::Glint(Glint::Spot), 2) => (0x84, 10),
                (Order::Quadratic | Order::QuadraticDots | Order::Glint(_), 0..=2) => {
                    (16 << channel, 10)
                }
                _ => (16 << channel, 4),
            };
            writes.extend((0..count).map(|i| (select + i, words[usize::from(i)] as u64)));
        }
        writes
    }

    /// Its pixels in the order in which a core emits them: rows downwards, each from the major edge.
    pub fn pixels(&self, size: Viewport) -> Vec<(u16, u16)> {
        let Some(w) = self.walk(size) else {
            return vec![];
        };
        let mut out = vec![];
        for s in w.spans(size.width) {
            let mut row: Vec<_> = (s.start..s.end).map(|x| (x as u16, s.y as u16)).collect();
            if w.mirrored {
                row.reverse();
            }
            out.extend(row);
        }
        out
    }

    /// Its spans in walk columns (first, one past the last), unlimited by the frame and possibly empty, and whether
    /// the walk columns are mirrored.
    pub fn raw_spans(&self, size: Viewport) -> (bool, Vec<(i32, i32)>) {
        self.walk(size).map_or((false, vec![]), |w| {
            let spans = w.walk_spans().map(|(_, from, to)| (from, to)).collect();
            (w.mirrored, spans)
        })
    }

    /// Its pixels with colours and depths, as a core of this kind emits them when nothing hides them.
    pub fn drawn(&self, kind: Core, size: Viewport) -> Vec<Pixel> {
        let shade = |(x, y): (u16, u16)| {
            let (column, row) = (i64::from(x), i64::from(y));
            let values = self
                .colour
                .map(|c| c.at(column, row) >> kind.fraction_bits());
            let levels = match kind.order {
                Order::Linear
                | Order::Quadratic
                | Order::QuadraticEngine
                | Order::Line(_)
                | Order::Span(_) => values,
                Order::QuadraticDots => [0, 1, 2].map(|c| material::level(c, values[0], values[1])),
                Order::Textured(t) => {
                    let fraction = t.mapping.format(false).1;
                    let address = picture::addresses(self, t.mapping, fraction);
                    let colour = self
                        .colour
                        .map(|c| colour_in(c.at(column, row), kind.fraction_bits()));
                    let address = address.map(|c| c.at(column, row));
                    picture::level(colour, address, t.mapping, fraction)
                }
                Order::Bump(bend) => {
                    let at = |p: &Polynomial| p.at(column, row);
                    let [light, place] = bumps::arguments(self, bend, at);
                    [0, 1, 2].map(|c| material::level(c, light, place))
                }
                Order::Glint(g) => [0, 1, 2].map(|c| material::glint(c, g, values)),
                Order::Duff => {
                    let [light, place] = arguments(values, 0);
                    [0, 1, 2].map(|c| material::level(c, light, place))
                }
            };
            Pixel {
                x,
                y,
                rgb: levels.map(saturate_model),
                depth: ((self.depth.at(column, row) >> DEPTH_FRACTION_BITS) + DEPTH_BIAS) as u16,
            }
        };
        self.pixels(size).into_iter().map(shade).collect()
    }
}

/// Triangles with corners in these columns and rows, colours and depths random but within range, each deeper ones
/// first so that all are visible where a core has drawn before.
pub fn random_triangles(
    r: &mut StdRng,
    kind: Core,
    size: Viewport,
    columns: Range<i32>,
    rows: Range<i32>,
    count: usize,
    mut wanted: impl FnMut(&Triangle) -> bool,
) -> Vec<Triangle> {
    let unit = 1i64 << kind.fraction_bits();
    let bend = |unit: i64| match kind.order {
        Order::Linear | Order::Line(_) | Order::Span(_) => 0,
        Order::Quadratic
        | Order::QuadraticEngine
        | Order::QuadraticDots
        | Order::Textured(_)
        | Order::Bump(_)
        | Order::Glint(_) => unit / 32,
        Order::Duff => 0,
    };
    // What a step of 8-bit colour is to an interpolant.
    let units = match kind.order {
        Order::Linear
        | Order::Quadratic
        | Order::QuadraticEngine
        | Order::Line(_)
        | Order::Span(_)
        | Order::Textured(_) => [unit; 3],
        Order::QuadraticDots => [unit << (16 - 8), unit << (19 - 8), 0],
        Order::Bump(_) => [unit << (16 - 8); 3],
        Order::Glint(_) => [unit << (16 - 8), unit << (19 - 8), unit << (19 - 8)],
        Order::Duff => [unit << (28 - 8); 3],
    };
    let mut out: Vec<Triangle> = vec![];
    for _ in 0..1_000_000 {
        if out.len() == count {
            return out;
        }
        let mut corner = || Point {
            x: r.random_range(columns.start * 256..columns.end * 256),
            y: r.random_range(rows.start * 256..rows.end * 256),
        };
        let corners = [corner(), corner(), corner()];
        let mut colour = |unit: i64| {
            let bend = bend(unit);
            let mut slope = |limit: i64| r.random_range(-limit..=limit);
            let [a, b] = [slope(2 * unit), slope(2 * unit)];
            let [d, e, f] = [slope(bend), slope(bend), slope(bend)];
            Polynomial([r.random_range(0..=255 * unit), a, b, d, e, f])
        };
        let colour = units.map(&mut colour);
        let depth = 1000 + 60_000 / count * out.len();
        let triangle = Triangle {
            corners,
            colour,
            depth: Polynomial::constant(depth_code(depth as u16)),
        };
        if triangle.walk(size).is_some() && wanted(&triangle) {
            out.push(triangle);
        }
    }
    panic!("no such triangles");
}

fn edge_words(e: &EdgeDda) -> [u64; 3] {
    let pack = |high: i32, low: i32| {
        assert!(
            (-2048..2048).contains(&high),
            "column {high} leaves the register"
        );
        (high as u64 & 0xfff) << 20 | low as u64 & 0xf_ffff
    };
    [
        pack(e.column, e.error),
        pack(e.whole, e.up),
        pack(0, e.down),
    ]
}
