//! Set-ups of quadratic colour interpolation: from six knots at the vertices and mid-edges of a triangle on the screen to
//! the forward differences that walk it, left edge first and then along each line. Three papers go by way of the
//! polynomial φ = A·x² + B·y² + C·xy + D·x + E·y + F, the fourth way goes directly; all four give the same walk.
//!
//! | set-up | per triangle and channel (products + sums + divisions) | singular |
//! |---|---|---|
//! | [`seiler`] (Hast 2004, eqs 3.98–3.111) | 33 + 26 + 7, and 26 + 16 for the walk | x₁ = 0, y₂ = 0: guarded by turning the vertices |
//! | [`abbas`] (Abbas 2003 ch. 7; Hast 2004, eqs 3.112–3.144, signs corrected) | 34 + 24 + 3, and the walk | y₁ = 0: likewise |
//! | [`lee_jen`] (Hast 2004, eqs 3.145–3.158) | 33 + 21 + 2, and the walk | nothing but no area |
//! | [`direct`] (Hast 2004, eqs 3.159–3.175 and 3.213–3.233) | 20 + 24 + 2 | nothing but no area |
//!
//! (x₁, y₁) and (x₂, y₂) are the second and third vertex seen from the first. What the first three lose in thin triangles
//! is (longest edge)²/area squared, times 2⁻⁵³: their coefficients are that large and cancel. The renderer's own
//! ([`crate::shade::differences`]) is the direct one for any order of the vertices, started at each span.

pub mod abbas;
pub mod direct;
pub mod lee_jen;
pub mod polynomial;
pub mod seiler;

/// A triangle on the screen with six knots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knots {
    /// The vertices (x, y), pixels, y down.
    pub position: [(f64, f64); 3],
    /// Values at vertices 0, 1, 2 and mid-edges 01, 02, 12.
    pub value: [f64; 6],
}

/// A walk of one left edge: values at whole lines below its upper end and whole pixels right of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Part {
    /// Where the edge begins.
    pub start: (f64, f64),
    /// How far right it goes per line.
    pub slope: f64,
    /// Lines it goes on for.
    pub lines: f64,
    /// The value on the edge, its change per line, and the change of that.
    pub p: f64,
    /// See `p`.
    pub dp: f64,
    /// See `p`.
    pub d2p: f64,
    /// The first pixel difference on the edge, and its change per line.
    pub q: f64,
    /// See `q`.
    pub dq: f64,
    /// The second pixel difference.
    pub d2r: f64,
}

/// One part when the left edge is the long one, an upper and a lower one otherwise; those without height left out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Walk {
    /// Upper, lower.
    pub parts: [Option<Part>; 2],
}

/// A set-up: `None` for a triangle without area.
pub type SetUp = fn(&Knots) -> Option<Walk>;

/// All four, by name, in the order of the papers.
pub const ALL: [(&str, SetUp); 4] = [
    ("seiler", seiler::walk),
    ("abbas", abbas::walk),
    ("lee-jen", lee_jen::walk),
    ("direct", direct::walk),
];

impl Part {
    /// The value `line` lines below the start and `pixel` pixels right of the edge, as the additions give it.
    #[must_use]
    pub fn value(&self, line: f64, pixel: f64) -> f64 {
        self.p
            + line * (self.dp + 0.5 * (line - 1.0) * self.d2p)
            + pixel * (self.q + line * self.dq + 0.5 * (pixel - 1.0) * self.d2r)
    }
}

impl Knots {
    /// The same triangle with other vertices first: `order` lists old vertices.
    #[must_use]
    pub fn reordered(&self, order: [usize; 3]) -> Self {
        let [a, b, c] = order;
        let edge = |i: usize, j: usize| self.value[i + j + 2];
        Self {
            position: order.map(|i| self.position[i]),
            value: [
                self.value[a],
                self.value[b],
                self.value[c],
                edge(a, b),
                edge(a, c),
                edge(b, c),
            ],
        }
    }

    /// The second and third vertex seen from the first: x₁, y₁, x₂, y₂.
    #[must_use]
    pub fn sides(&self) -> [f64; 4] {
        let [(x, y), (xm, ym), (xn, yn)] = self.position;
        [xm - x, ym - y, xn - x, yn - y]
    }

    /// Twice the signed area K = x₁y₂ − x₂y₁.
    #[must_use]
    pub fn area2(&self) -> f64 {
        let [x1, y1, x2, y2] = self.sides();
        x1 * y2 - x2 * y1
    }

    /// From top to bottom.
    #[must_use]
    pub fn sorted(&self) -> Self {
        let mut order = [0, 1, 2];
        order.sort_by(|i, j| {
            let (a, b) = (self.position[*i], self.position[*j]);
            a.1.total_cmp(&b.1).then(a.0.total_cmp(&b.0))
        });
        self.reordered(order)
    }

    /// The turn of the vertices for which `weight` of the sides is largest: what divides is farthest from zero.
    fn turned(&self, weight: impl Fn([f64; 4]) -> f64) -> Self {
        let mut best = *self;
        for order in [[1, 2, 0], [2, 0, 1]] {
            let other = self.reordered(order);
            if weight(other.sides()) > weight(best.sides()) {
                best = other;
            }
        }
        best
    }

    /// The left edges of the sorted triangle: where each begins, its slope and its lines.
    fn left_edges(&self) -> [Option<Part>; 2] {
        let edge = |a: (f64, f64), b: (f64, f64)| {
            let lines = b.1 - a.1;
            (lines > 0.0).then(|| Part {
                start: a,
                slope: (b.0 - a.0) / lines,
                lines,
                ..Part::default()
            })
        };
        let [top, middle, bottom] = self.position;
        if self.area2() > 0.0 {
            [edge(top, bottom), None]
        } else {
            [edge(top, middle), edge(middle, bottom)]
        }
    }
}

/// What the three polynomial set-ups share of the knots: T, U, V, G and H.
struct Bends {
    t: f64,
    u: f64,
    v: f64,
    g: f64,
    h: f64,
}

impl Bends {
    fn of(k: &Knots) -> Self {
        let [l, m, n, q, r, s] = k.value;
        let (t, u) = (l + m - 2.0 * q, l + n - 2.0 * r);
        Self {
            t,
            u,
            v: l + s - r - q,
            g: 2.0 * q - 2.0 * l - t,
            h: 2.0 * r - 2.0 * l - u,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The interpolant by its definition, the six basis functions of the weights.
    fn definition(k: &Knots, x: f64, y: f64) -> f64 {
        let p = k.position;
        let area = |a: (f64, f64), b: (f64, f64)| (a.0 - x) * (b.1 - y) - (b.0 - x) * (a.1 - y);
        let e = [area(p[1], p[2]), area(p[2], p[0]), area(p[0], p[1])];
        let sum: f64 = e.iter().sum();
        let w = e.map(|v| v / sum);
        let v = k.value;
        w[0] * (2.0 * w[0] - 1.0) * v[0]
            + w[1] * (2.0 * w[1] - 1.0) * v[1]
            + w[2] * (2.0 * w[2] - 1.0) * v[2]
            + 4.0 * (w[0] * w[1] * v[3] + w[0] * w[2] * v[4] + w[1] * w[2] * v[5])
    }

    /// Twice the area over the square of the longest edge.
    fn thickness(k: &Knots) -> f64 {
        let [x1, y1, x2, y2] = k.sides();
        let longest = (x1 * x1 + y1 * y1)
            .max(x2 * x2 + y2 * y2)
            .max((x2 - x1).powi(2) + (y2 - y1).powi(2));
        k.area2().abs() / longest
    }

    /// The largest difference from the definition over lines and pixels of the triangle, for each set-up, in fractions
    /// of the range of the knots.
    fn worst(k: &Knots) -> [f64; 4] {
        let (lo, hi) = k
            .value
            .iter()
            .fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(*v), h.max(*v)));
        let range = (hi - lo).max(1e-3);
        ALL.map(|(name, set_up)| {
            let walk = set_up(k).expect(name);
            let mut worst = 0.0f64;
            for part in walk.parts.iter().flatten() {
                for i in 0..=8 {
                    let line = (part.lines * f64::from(i) / 8.0).floor();
                    let (x, y) = (part.start.0 + part.slope * line, part.start.1 + line);
                    let width = right(k, y) - x;
                    for j in 0..=8 {
                        let pixel = (width * f64::from(j) / 8.0).floor().max(0.0);
                        let e = part.value(line, pixel) - definition(k, x + pixel, y);
                        worst = worst.max(e.abs() / range);
                    }
                }
            }
            worst
        })
    }

    /// Where a line leaves the triangle on the right.
    fn right(k: &Knots, y: f64) -> f64 {
        let p = k.position;
        [(0, 1), (0, 2), (1, 2)]
            .into_iter()
            .filter_map(|(i, j)| {
                let (a, b) = (p[i], p[j]);
                let t = (y - a.1) / (b.1 - a.1);
                (0.0..=1.0).contains(&t).then_some(a.0 + (b.0 - a.0) * t)
            })
            .fold(f64::MIN, f64::max)
    }

    fn check(k: &Knots) {
        let thin = 256.0 * f64::EPSILON / thickness(k).powi(2);
        for (e, (name, _)) in worst(k).into_iter().zip(ALL) {
            let bound = if name == "direct" {
                1e-9
            } else {
                f64::max(1e-9, thin)
            };
            assert!(e <= bound, "{name}: {e:e} > {bound:e}: {k:?}");
        }
    }

    fn knots() -> impl Strategy<Value = [f64; 6]> {
        prop::array::uniform6(0.0..255.0)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn all_four_are_the_definition(
            p in prop::array::uniform3((-1000.0..1000.0f64, -1000.0..1000.0f64)), value in knots(),
        ) {
            let k = Knots { position: p, value };
            prop_assume!(thickness(&k) > 1e-4);
            check(&k);
        }

        /// Vertices on a coarse grid: level and upright edges, shared rows and columns, both orientations.
        #[test]
        fn also_where_the_printed_forms_divide_by_zero(
            p in prop::array::uniform3((0..4i32, 0..4i32)), value in knots(), size in 1..300i32,
        ) {
            let position = p.map(|(x, y)| (f64::from(x * size), f64::from(y * size)));
            let k = Knots { position, value };
            if k.area2() == 0.0 {
                for (name, set_up) in ALL {
                    prop_assert!(set_up(&k).is_none(), "{}", name);
                }
            } else {
                check(&k);
            }
        }

        /// Nearly so: the direct way must not notice, the others only as much as they say.
        #[test]
        fn and_close_to_it(
            p in prop::array::uniform3((0..4i32, 0..4i32)), value in knots(), e in -1.0..1.0f64, exponent in -12.0..-1.0f64,
        ) {
            let position = p.map(|(x, y)| (f64::from(x) * 90.0, f64::from(y) * 90.0));
            let mut k = Knots { position, value };
            prop_assume!(k.area2() != 0.0);
            k.position[1].1 += e * 10f64.powf(exponent);
            k.position[2].0 += e * 10f64.powf(exponent);
            check(&k);
        }
    }

    #[test]
    fn the_four_agree_on_the_numbers_themselves() {
        let k = Knots {
            position: [(3.0, 2.0), (40.0, 17.0), (11.0, 60.0)],
            value: [10.0, 200.0, 35.0, 120.0, 5.0, 90.0],
        };
        let walks = ALL.map(|(_, set_up)| set_up(&k).expect("area").parts[0].expect("height"));
        for w in walks {
            let d = walks[3];
            for (a, b) in [
                (w.p, d.p),
                (w.dp, d.dp),
                (w.d2p, d.d2p),
                (w.q, d.q),
                (w.dq, d.dq),
                (w.d2r, d.d2r),
            ] {
                assert!((a - b).abs() < 1e-12 * 255.0, "{a} {b}");
            }
        }
    }
}
