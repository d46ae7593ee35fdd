//! Hast 2004: Table 3.1 (coefficients of the six-knot quadratic), Table 3.3 (complete set-ups), Table 3.6 (normalising bump
//! normals) and section 3.5.4 (the spotlight by power and by a quadratic). The thesis times loops of millions of calls on
//! a Pentium 4; so do we, on inputs in the first-level cache, one call at a time (nothing is vectorised across calls), and
//! subtract an empty loop.
//!
//! Complete set-ups of Table 3.3 begin with three unit normals and a light: Lee & Jen's and the direct one normalise the
//! three mid-edge normals, X-shading takes (5 − c)/8·(Iᵢ + Iⱼ) for a mid-edge knot (3.254), c = nᵢ·nⱼ.

use super::super::clock::{in_turns, median, Effort};
use super::Claim;
use glam::DVec3;
use shadegate_reference::bump::normalise;
use shadegate_reference::scene::{Falloff, SpotWidth};
use shadegate_reference::setup::{abbas, direct, lee_jen, seiler, Knots};
use shadegate_reference::shade::spot::Cone;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Inputs of a loop; all of them fit into the first-level cache.
const INPUTS: usize = 64;
/// Calls with each input in one timed run.
const REPEATS: usize = 200;

/// The time of `REPEATS` passes over the inputs, in nanoseconds.
fn passes<I: Copy, O>(inputs: &[I], f: impl Fn(I) -> O) -> f64 {
    let begin = Instant::now();
    for _ in 0..REPEATS {
        for i in inputs {
            black_box(f(black_box(*i)));
        }
    }
    begin.elapsed().as_nanos() as f64
}

/// Times of jobs, each less the first one, which is the empty loop: how many times longer job `slow` takes than job
/// `fast`, as the median over the rounds.
struct Net(Vec<Vec<f64>>);

impl Net {
    fn measure(jobs: &[&dyn Fn() -> f64], effort: Effort) -> Self {
        let once: f64 = jobs.iter().map(|j| j()).sum();
        let rounds = effort.rounds(Duration::from_nanos(once as u64));
        Self(in_turns(jobs.len(), rounds, |j| jobs[j]()))
    }

    fn ratio(&self, slow: usize, fast: usize) -> f64 {
        let rounds = 0..self.0[0].len();
        // A job that costs nothing beyond the empty loop is taken to cost a hundredth of it.
        let net = |job: usize, r: usize| (self.0[job][r] - self.0[0][r]).max(self.0[0][r] / 100.0);
        median(rounds.map(|r| net(slow, r) / net(fast, r)))
    }
}

/// All claims of the thesis that are checked.
pub fn claims(effort: Effort) -> Vec<Claim> {
    let mut claims = coefficients(effort);
    claims.extend(complete(effort));
    claims.extend(bump(effort));
    claims.extend(spot(effort));
    claims
}

/// Numbers that look random and are the same every time (the minimal generator of Park & Miller 1988).
struct Numbers(u64);

impl Numbers {
    /// Uniform in `lo..hi`.
    fn next(&mut self, lo: f64, hi: f64) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        lo + (hi - lo) * self.0 as f64 / 2_147_483_647.0
    }
}

/// A triangle from top to bottom, with the middle vertex right (K > 0) or left of the long edge.
fn corners(n: &mut Numbers, right: bool) -> [(f64, f64); 3] {
    let (x, y) = (n.next(0.0, 500.0), n.next(0.0, 400.0));
    let (middle, height) = (n.next(4.0, 20.0), n.next(25.0, 60.0));
    let slant = n.next(-10.0, 10.0);
    let side = if right { 1.0 } else { -1.0 } * n.next(15.0, 50.0);
    [
        (x, y),
        (x + slant * middle / height + side, y + middle),
        (x + slant, y + height),
    ]
}

/// Table 3.1.
fn coefficients(effort: Effort) -> Vec<Claim> {
    let mut n = Numbers(1);
    let knots: Vec<Knots> = (0..INPUTS)
        .map(|i| Knots {
            position: corners(&mut n, i % 2 == 0),
            value: [0.0; 6].map(|_: f64| n.next(0.0, 255.0)),
        })
        .collect();
    let net = Net::measure(
        &[
            &|| passes(&knots, |k| k),
            &|| passes(&knots, |k| seiler::polynomial(&k)),
            &|| passes(&knots, |k| abbas::polynomial(&k)),
            &|| passes(&knots, |k| lee_jen::polynomial(&k)),
        ],
        effort,
    );
    let (seconds, note) = (
        [9.17, 8.24, 7.24],
        "ours of Seiler and Abbas turn the vertices first, to divide by nothing small",
    );
    [(0, "Seiler"), (1, "Abbas")]
        .map(|(i, name)| {
            let what = format!("coefficients: {name} to Lee & Jen");
            let paper = seconds[i] / seconds[2];
            Claim::ratio(
                "Hast 2004, Table 3.1",
                what,
                paper,
                net.ratio(1 + i, 3),
                note,
            )
        })
        .into()
}

/// A triangle with unit normals.
#[derive(Clone, Copy)]
struct Lit {
    position: [(f64, f64); 3],
    normal: [DVec3; 3],
}

const LIGHT: DVec3 = DVec3::new(0.48, 0.6, 0.64);
/// Ends of the mid-edge knots.
const EDGES: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// Six knots of N·L, mid-edges by `middle` of both normals and both values.
fn knots(t: Lit, middle: impl Fn([DVec3; 2], [f64; 2]) -> f64) -> Knots {
    let v = t.normal.map(|n| n.dot(LIGHT));
    let m = EDGES.map(|(i, j)| middle([t.normal[i], t.normal[j]], [v[i], v[j]]));
    Knots {
        position: t.position,
        value: [v[0], v[1], v[2], m[0], m[1], m[2]],
    }
}

fn normalised([a, b]: [DVec3; 2], _: [f64; 2]) -> f64 {
    (a + b).normalize_or_zero().dot(LIGHT)
}

fn x_shading([a, b]: [DVec3; 2], [va, vb]: [f64; 2]) -> f64 {
    (5.0 - a.dot(b)) / 8.0 * (va + vb)
}

/// Table 3.3.
fn complete(effort: Effort) -> Vec<Claim> {
    let mut claims = Vec::new();
    // Seconds of Lee & Jen, direct and X-shading.
    for (name, right, seconds) in [
        ("K > 0", true, [51.9, 49.4, 12.5]),
        ("K < 0", false, [54.2, 50.8, 13.0]),
    ] {
        let mut n = Numbers(2);
        let lit: Vec<Lit> = (0..INPUTS)
            .map(|_| Lit {
                position: corners(&mut n, right),
                normal: [(); 3]
                    .map(|()| DVec3::new(n.next(-0.3, 0.3), n.next(-0.3, 0.3), 1.0).normalize()),
            })
            .collect();
        let net = Net::measure(
            &[
                &|| passes(&lit, |t| t),
                &|| passes(&lit, |t| lee_jen::walk(&knots(t, normalised))),
                &|| passes(&lit, |t| direct::walk(&knots(t, normalised))),
                &|| passes(&lit, |t| direct::walk(&knots(t, x_shading))),
            ],
            effort,
        );
        for (slow, fast, what) in [
            (0, 1, "Lee & Jen to direct"),
            (0, 2, "Lee & Jen to X-shading"),
            (1, 2, "direct to X-shading"),
        ] {
            let ours = net.ratio(1 + slow, 1 + fast);
            let paper = seconds[slow] / seconds[fast];
            let what = format!("complete set-up, {name}: {what}");
            claims.push(Claim::ratio("Hast 2004, Table 3.3", what, paper, ours, ""));
        }
    }
    claims
}

/// Table 3.6, in single precision.
fn bump(effort: Effort) -> Vec<Claim> {
    let mut n = Numbers(3);
    let gradients: Vec<[f32; 2]> = (0..INPUTS)
        .map(|_| [n.next(-0.8, 0.8) as f32, n.next(-0.8, 0.8) as f32])
        .collect();
    let net = Net::measure(
        &[
            &|| passes(&gradients, |[u, v]| [u, v, 0.0]),
            &|| passes(&gradients, |[u, v]| normalise::exact(u, v)),
            &|| passes(&gradients, |[u, v]| normalise::reflection(u, v)),
            &|| passes(&gradients, |[u, v]| normalise::newton(u, v)),
        ],
        effort,
    );
    // Seconds: the empty loop, exact, reflection, Newton.
    let seconds = [0.21, 8.24, 2.45, 1.37];
    [(2, "reflection"), (3, "Newton")]
        .map(|(i, name)| {
            let what = format!("bump normal: exact to {name}, net of the empty loop");
            let paper = (seconds[1] - seconds[0]) / (seconds[i] - seconds[0]);
            Claim::ratio("Hast 2004, Table 3.6", what, paper, net.ratio(1, i), "")
        })
        .into()
}

/// Section 3.5.4.
fn spot(effort: Effort) -> Vec<Claim> {
    let mut n = Numbers(4);
    let cosines: Vec<f64> = (0..INPUTS).map(|_| n.next(0.97, 1.0)).collect();
    let width = SpotWidth::Field(30.0);
    let [warn, soft] = [Falloff::Warn, Falloff::Soft].map(|f| Cone::new(f, width));
    let net = Net::measure(
        &[
            &|| passes(&cosines, |e| e),
            &|| passes(&cosines, |e| warn.factor(e)),
            &|| passes(&cosines, |e| soft.factor(e)),
        ],
        effort,
    );
    let what = "spotlight: power to soft quadratic".to_owned();
    let paper = 300.27 / 6.29;
    vec![Claim::ratio(
        "Hast 2004, section 3.5.4",
        what,
        paper,
        net.ratio(1, 2),
        "",
    )]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eleven_ratios_and_the_dear_ones_are_dearer() {
        let claims = claims(Effort::QUICK);
        assert_eq!(claims.len(), 11);
        assert!(claims
            .iter()
            .all(|c| c.paper > 1.0 && c.ours.is_finite() && c.ours > 0.0));
    }

    #[test]
    fn triangles_lie_on_the_side_they_should() {
        let mut n = Numbers(9);
        for right in [true, false].repeat(50) {
            let k = Knots {
                position: corners(&mut n, right),
                value: [0.0; 6],
            };
            assert_eq!(k.area2() > 0.0, right);
            assert_eq!(k.sorted().position, k.position);
        }
    }

    #[test]
    fn the_middle_of_equal_normals_is_their_value() {
        let n = DVec3::new(0.1, -0.2, 1.0).normalize();
        let v = n.dot(LIGHT);
        for f in [normalised, x_shading] {
            assert!((f([n, n], [v, v]) - v).abs() < 1e-15);
        }
    }
}
