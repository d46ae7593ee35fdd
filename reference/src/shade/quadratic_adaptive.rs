//! Quadratic colours on triangles cut as finely as a tolerance asks for: the safe split, decided from normals before
//! anything is shaded.
//!
//! An edge is cut in its middle when the error that the six-knot quadratic may have on a triangle of which it is the
//! *longest* (in the angle s between its end normals) exceeds the tolerance, summed over lights; with z = s·√n,
//!
//! | part | LSB |
//! |---|---|
//! | highlight | min(255·ks·cosⁿφ, 0.036·255·ks·z³·g(√n·φ)) |
//! | diffuse | 255·kd·0.027·s³(1 + 0.1s²) |
//! | terminator, where N·L = 0 may lie in the triangle | 0.097·255·kd·s |
//!
//! φ is the least angle to H in the triangle: no less than the nearer end's minus s, since no point of a spherical triangle
//! is farther from any other than its longest side. For the same reason the terminator is near an end, within s. So when no
//! edge is to be cut the longest one has vouched for the triangle, and since each edge decides for itself, both triangles at
//! an edge cut it alike: no T-junction, no crack, and the knots on common edges are the same bits. g falls with the third
//! derivative of e^(−u²/2), which cosⁿ tends to: 1 up to its first maximum, its envelope beyond.
//!
//! The constants are measured, not proved: 0.0252 is the largest error of a six-knot quadratic for a third derivative of 1
//! (proved: 0.0256, Ciarlet and Raviart 1972), 1.38 the third derivative's largest value; 0.0962 the largest error at a kink.
//! Those of the study (0.0145, 0.012 and 0.093, fitted to random triangles) are exceeded by a chosen light.
//!
//! Near lights turn as well: an edge of length e at a distance of at least d turns L by e/d at most. N and L may have
//! different longest edges, so s is twice the larger of both. Perspective stretches an edge unevenly; with r the largest
//! ratio of weights in any triangle of the object, ρ = r − 1, s³ becomes (rs)³ + 6r²ρs² + 6rρ²s (the chain rule for
//! t·w/(1 + t(w − 1))). A light that fades within a triangle is not looked at.
//!
//! A piece of few pixels is not cut but drawn by the definition: a set-up would cost more (Blake's break-even, 3 to 10
//! pixels).
//!
//! | work | |
//! |---|---|
//! | pixel | 6 additions, as `quadratic` |
//! | span | 1 set-up (27 mul 30 add) for each leaf it meets |
//! | triangle | about 3 corners shaded per leaf; no shading to decide |

use super::case::Case;
use super::quadratic::EDGES;
use super::quadratic_dots::cosine_error;
use super::shader::Shader;
use super::subdivision::{along::Cut, edge, Along, Corner, Corners, Leaf, Node, Piece, Tree};
use crate::geometry::{Prepared, ScreenTriangle};
use crate::raster::{area2, Span, SUBPIXELS};
use glam::DVec3;

/// What the method promises, LSB.
pub const TOLERANCE: f64 = 1.0;

/// Pieces with an area below this, in pixels, are drawn by the definition and not cut.
const FEW_PIXELS: f64 = 4.0;

/// The method.
#[derive(Clone, Debug)]
pub struct QuadraticAdaptive {
    /// The error that is allowed, LSB.
    tolerance: f64,
    /// For each object the largest ratio of perspective weights in one of its triangles.
    ratio: Vec<f64>,
}

/// g: how far the third derivative of e^(−u²/2) has fallen at u, as a fraction of its largest value; never rising.
fn fall(u: f64) -> f64 {
    if u <= 0.742 {
        return 1.0;
    }
    let here = (3.0 * u - u.powi(3)).abs() * (-0.5 * u * u).exp() / 1.38;
    here.max(if u < 2.334 { 0.272 } else { 0.0 })
}

/// The same for its first two derivatives, as fractions of 0.61 and 1.
fn fall_lower(u: f64) -> f64 {
    if u * u <= 3.0 {
        1.0
    } else {
        ((u * u + 1.7 * u) * (-0.5 * u * u).exp()).min(1.0)
    }
}

/// What is known at one end of an edge.
struct End {
    normal: DVec3,
    light: DVec3,
    view: DVec3,
    /// Largest channel of the light times the material, fractions of full scale.
    diffuse: f64,
    specular: f64,
}

fn end(p: &Prepared, t: &ScreenTriangle, c: &Corner, k: usize) -> End {
    let (s, x) = (&p.surroundings, c.world());
    let (incident, m) = (s.incident(k, x), s.material(t.material));
    End {
        normal: c.normal(t),
        light: incident.direction,
        view: s.view(x),
        diffuse: (incident.colour * m.diffuse).max_element(),
        specular: (incident.colour * m.specular).max_element(),
    }
}

fn angle(x: DVec3, y: DVec3) -> f64 {
    x.cross(y).length().atan2(x.dot(y))
}

/// How far a direction from places of a triangle to a point turns when this is its longest edge, in units in which the
/// third derivative is at most the third power: e/(d − e), e the edge's length and d the lesser distance of its ends.
/// From the directions at its ends alone, since the edge, seen from the point, is a triangle; infinite when they differ
/// by more than the edge's own direction allows for.
fn turn(edge: DVec3, a: DVec3, b: DVec3) -> f64 {
    if a == b {
        return 0.0;
    }
    // The law of sines: each distance is to the sine at the other end as the edge is to the sine of the turn.
    let along = edge.normalize_or_zero();
    let across = a.cross(b).length();
    let distance = a.cross(along).length().min(b.cross(along).length());
    if distance > across {
        across / (distance - across)
    } else {
        f64::INFINITY
    }
}

/// The error, LSB, that a triangle with this longest edge may have from one light.
fn one(a: &End, b: &End, edge: DVec3, n: f64, r: f64) -> f64 {
    let spread = angle(a.normal, b.normal);
    let (kd, ks) = (a.diffuse.max(b.diffuse), a.specular.max(b.specular));
    let (light, view) = (turn(edge, a.light, b.light), turn(edge, a.view, b.view));
    // Twice the larger: the other may be larger along another edge.
    let both = |turned: f64| {
        if turned > 0.0 {
            2.0 * spread.max(turned)
        } else {
            spread
        }
    };

    let s = both(light);
    let height = |e: &End| e.normal.dot(e.light).clamp(-1.0, 1.0).asin();
    let (low, high) = (height(a).min(height(b)), height(a).max(height(b)));
    let dark = high < -s;
    let mut diffuse = if dark { 0.0 } else { stretched(s, r) };
    if !dark && low <= s {
        diffuse += 0.097 * s * r;
    }

    let half = |e: &End| e.light + e.view;
    // The mean of two directions turns by their turns over its length, doubled.
    let shortest = half(a).length().min(half(b).length()) - light - view;
    let turned = if light + view == 0.0 {
        0.0
    } else if shortest > 0.0 {
        (light + view) / shortest
    } else {
        f64::INFINITY
    };
    let s = both(turned);
    let far = |e: &End| angle(e.normal, half(e));
    let phi = (far(a).min(far(b)) - s).max(0.0);
    255.0 * (kd * diffuse.min(4.0 / 3.0) + ks * highlight(s, phi, n, r))
}

/// The error of a cosine for a turn of `s`, stretched by perspective.
fn stretched(s: f64, r: f64) -> f64 {
    let rho = r - 1.0;
    cosine_error(s * r) + 0.027 * 6.0 * r * rho * s * (r * s + rho)
}

/// The error of a highlight, as a fraction of ks, where H is at least `phi` away and normals turn by up to `s`.
fn highlight(s: f64, phi: f64, n: f64, r: f64) -> f64 {
    if s == 0.0 || phi >= std::f64::consts::FRAC_PI_2 {
        return 0.0;
    }
    // A quadratic overshoots by a third at most.
    let whole = 4.0 / 3.0 * phi.cos().powf(n);
    if n < 1.0 || !s.is_finite() {
        return whole;
    }
    let (root, rho) = (n.sqrt(), r - 1.0);
    let z = s * root;
    let mut e = 0.036 * (z * r).powi(3) * fall(root * phi);
    e += 0.027 * 6.0 * r * rho * z * (r * z + rho) * fall_lower(root * phi);
    // Up to the third power, max(0, x)ⁿ is not smooth enough where it begins.
    if n < 3.0 {
        e += 0.097 * n * s * r;
    }
    e.min(whole)
}

impl QuadraticAdaptive {
    /// For a scene, with the error that is allowed, LSB.
    #[must_use]
    pub fn new(p: &Prepared, tolerance: f64) -> Self {
        let objects = p.triangles.iter().map(|t| t.object + 1).max().unwrap_or(0);
        let mut ratio = vec![1.0f64; objects];
        for t in &p.triangles {
            let [a, b, c] = t.inv_w;
            ratio[t.object] = ratio[t.object].max(a.max(b).max(c) / a.min(b).min(c));
        }
        Self { tolerance, ratio }
    }

    /// The pieces of a triangle and how many corners were shaded for them.
    #[must_use]
    pub fn cut(&self, p: &Prepared, t: &ScreenTriangle) -> (Tree, u32) {
        let (corners, whole) = Corners::new(p, t);
        let mut tree = Tree::new(Leaf::Direct);
        let scale = f64::from(SUBPIXELS).powi(2);
        let area = area2(t.position).abs() as f64 / (2.0 * scale);
        let mut work = Work {
            prepared: p,
            triangle: t,
            corners,
            tolerance: self.tolerance,
            ratio: self.ratio[t.object],
        };
        let errors = EDGES.map(|(i, j)| work.error(whole.vertex[i], whole.vertex[j]));
        work.piece(&mut tree, 0, &whole, errors, area);
        (tree, work.corners.shaded)
    }
}

/// A triangle being cut.
struct Work<'a> {
    prepared: &'a Prepared,
    triangle: &'a ScreenTriangle,
    corners: Corners<'a>,
    tolerance: f64,
    ratio: f64,
}

impl Work<'_> {
    /// The error, LSB, that a triangle with this edge as its longest may have.
    fn error(&self, i: u32, j: u32) -> f64 {
        let (p, t) = (self.prepared, self.triangle);
        let (a, b) = (self.corners.get(i), self.corners.get(j));
        let n = p.surroundings.material(t.material).shininess;
        let edge = b.world() - a.world();
        (0..p.surroundings.lights())
            .map(|k| one(&end(p, t, a, k), &end(p, t, b, k), edge, n, self.ratio))
            .sum()
    }

    /// Cuts a piece on the edge with the largest error until none exceeds the tolerance. The area halves each time.
    fn piece(&mut self, tree: &mut Tree, at: u32, p: &Piece, errors: [f64; 3], area: f64) {
        let worst = (0..3).fold(0, |w, e| if errors[e] > errors[w] { e } else { w });
        // An error that is not a number must not pass.
        if errors[worst] <= self.tolerance {
            let quadrics = self.corners.quadrics(p);
            tree.set(at, Node::Leaf(Leaf::Smooth(quadrics)));
            return;
        }
        if area < FEW_PIXELS {
            return;
        }
        let (i, j) = EDGES[worst];
        let k = 3 - i - j;
        let halves = self.corners.halve(p, i, j);
        let m = p.middle[worst];
        let median = self.error(m, p.vertex[k]);
        let first = tree.grow(2);
        tree.set(
            at,
            Node::Halves {
                i: i as u8,
                j: j as u8,
                first,
            },
        );
        for (c, (kept, replaced)) in [(i, j), (j, i)].into_iter().enumerate() {
            let mut own = errors;
            own[worst] = self.error(p.vertex[kept], m);
            own[edge(replaced, k)] = median;
            self.piece(tree, first + c as u32, &halves[c], own, area / 2.0);
        }
    }
}

impl Shader for QuadraticAdaptive {
    type Triangle = Cut;
    type Run<'a> = Along<'a>;

    fn triangle(&self, p: &Prepared, index: usize) -> Cut {
        let (tree, _) = self.cut(p, &p.triangles[index]);
        Cut { index, tree }
    }

    fn start<'a>(&'a self, p: &'a Prepared, cut: &'a Cut, span: Span) -> Along<'a> {
        Along::new(p, cut, span)
    }
}

/// Bound on |method − truth|, LSB, for lights that do not fade within a triangle. Measured, as its constants are.
#[must_use]
pub fn bound(_: &Case) -> f64 {
    TOLERANCE + super::case::ROUNDING
}
