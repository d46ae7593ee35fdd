//! Knots that triangles share are shaded once: a vertex of a closed mesh belongs to about six triangles and an edge to
//! two, so six knots for each of T triangles are about 2T shadings in place of 6T. The knots are the same bits as
//! without sharing, because what decides them is compared before one is taken over.

use crate::geometry::{Prepared, ScreenTriangle, UNSHARED};
use crate::parallel;
use crate::shade::quadratic::EDGES;
use crate::shade::{gouraud, quadratic};

/// Where a shared knot is first met: triangle, and corner or edge.
type Place = (usize, usize);

/// Slots by pairs of vertex numbers: for each lower number a chain of the higher ones, of which a mesh has about three.
struct Pairs {
    first: Vec<u32>,
    chain: Vec<Link>,
}

struct Link {
    higher: u32,
    slot: u32,
    next: u32,
}

/// The end of a chain.
const NONE: u32 = u32::MAX;

impl Pairs {
    /// For vertex numbers below `vertices`.
    fn new(vertices: usize) -> Self {
        Self {
            first: vec![NONE; vertices],
            chain: Vec::with_capacity(vertices),
        }
    }

    /// The slot of a pair; `new` if it has none yet.
    fn slot(&mut self, (lower, higher): (u32, u32), new: u32) -> u32 {
        let head = self.first[lower as usize];
        let mut at = head;
        while let Some(link) = self.chain.get(at as usize) {
            if link.higher == higher {
                return link.slot;
            }
            at = link.next;
        }
        self.first[lower as usize] = self.chain.len() as u32;
        self.chain.push(Link {
            higher,
            slot: new,
            next: head,
        });
        new
    }
}

/// Knots by slot, and the slot of every corner or edge of every triangle.
pub(crate) struct Table {
    slots: Vec<[u32; 3]>,
    knots: Vec<[f64; 3]>,
}

/// Everything a vertex knot depends on.
fn same_vertex(a: &ScreenTriangle, i: usize, b: &ScreenTriangle, j: usize) -> bool {
    a.material == b.material
        && a.world[i] == b.world[j]
        && a.normal[i] == b.normal[j]
        && a.inv_w[i] == b.inv_w[j]
}

fn same_edge(a: &ScreenTriangle, k: usize, b: &ScreenTriangle, m: usize) -> bool {
    let ((i, j), (x, y)) = (EDGES[k], EDGES[m]);
    let straight = same_vertex(a, i, b, x) && same_vertex(a, j, b, y);
    let crossed = same_vertex(a, i, b, y) && same_vertex(a, j, b, x);
    (straight || crossed) && !quadratic::cancels(a, k)
}

/// Gives out slots: `key` names what may be shared (none: not at all), `same` makes sure, `shade` fills.
fn table(
    p: &Prepared,
    wanted: impl Fn(usize) -> bool,
    key: impl Fn(usize, usize) -> Option<(u32, u32)>,
    same: impl Fn(Place, Place) -> bool,
    shade: impl Fn(Place) -> [f64; 3] + Sync + Send,
) -> Table {
    let mut places: Vec<Place> = Vec::new();
    let numbers = p.vertices.iter().flatten().filter(|n| **n != UNSHARED);
    let mut seen = Pairs::new(numbers.max().map_or(0, |n| *n as usize + 1));
    let mut slots = Vec::with_capacity(p.triangles.len());
    for t in 0..p.triangles.len() {
        if !wanted(t) {
            slots.push([0; 3]);
            continue;
        }
        slots.push([0, 1, 2].map(|i| {
            let new = places.len() as u32;
            if let Some(key) = key(t, i) {
                let slot = seen.slot(key, new);
                if slot != new && same((t, i), places[slot as usize]) {
                    return slot;
                }
            }
            places.push((t, i));
            new
        }));
    }
    let knots = parallel::map(places.len(), |i| shade(places[i]));
    Table { slots, knots }
}

impl Table {
    /// The knots of triangle `t`.
    pub(crate) fn of(&self, t: usize) -> [[f64; 3]; 3] {
        self.slots[t].map(|s| self.knots[s as usize])
    }
}

/// Vertex knots.
pub(crate) fn vertices(p: &Prepared) -> Table {
    let number = |t: usize, i: usize| p.vertices.get(t).map(|v| v[i]).filter(|n| *n != UNSHARED);
    table(
        p,
        |_| true,
        |t, i| number(t, i).map(|n| (n, n)),
        |(t, i), (u, j)| same_vertex(&p.triangles[t], i, &p.triangles[u], j),
        |(t, i)| gouraud::vertex(p, &p.triangles[t], i),
    )
}

/// [`gouraud::knots`] of every triangle.
pub(crate) fn linear(p: &Prepared) -> Vec<[[f64; 3]; 3]> {
    let v = vertices(p);
    (0..p.triangles.len()).map(|t| v.of(t)).collect()
}

/// Vertex and mid-edge knots.
pub(crate) struct Six {
    vertices: Table,
    edges: Table,
}

impl Six {
    /// Shades every knot once.
    pub(crate) fn new(p: &Prepared) -> Self {
        Self {
            vertices: vertices(p),
            edges: edges(p, |_| true),
        }
    }

    /// The knots of triangle `t`.
    pub(crate) fn of(&self, t: usize) -> [[f64; 3]; 6] {
        let ([a, b, c], [d, e, f]) = (self.vertices.of(t), self.edges.of(t));
        [a, b, c, d, e, f]
    }
}

/// [`quadratic::knots`] of every triangle.
pub(crate) fn square(p: &Prepared) -> Vec<[[f64; 3]; 6]> {
    let six = Six::new(p);
    (0..p.triangles.len()).map(|t| six.of(t)).collect()
}

/// Mid-edge knots of the triangles that are `wanted`; those of others must not be asked for.
pub(crate) fn edges(p: &Prepared, wanted: impl Fn(usize) -> bool) -> Table {
    let number = |t: usize, i: usize| p.vertices.get(t).map(|v| v[i]).filter(|n| *n != UNSHARED);
    table(
        p,
        wanted,
        |t, k| {
            let (a, b) = (number(t, EDGES[k].0)?, number(t, EDGES[k].1)?);
            Some((a.min(b), a.max(b)))
        },
        |(t, k), (u, m)| same_edge(&p.triangles[t], k, &p.triangles[u], m),
        |(t, k)| quadratic::middle(p, &p.triangles[t], k),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{scene, Skips};
    use std::path::Path;

    #[test]
    fn shared_knots_are_the_same_bits_and_few() {
        for name in ["sphere-690", "two-lights", "teapot", "gem", "rings"] {
            let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/{name}.toml"));
            let scene = scene::load(&file).unwrap();
            let mut p = Prepared::new(&scene, None, &Skips::all()).unwrap();
            for _ in 0..2 {
                for (t, knots) in p.triangles.iter().zip(square(&p)) {
                    assert_eq!(knots, quadratic::knots(&p, t), "{name}");
                }
                for (t, knots) in p.triangles.iter().zip(linear(&p)) {
                    assert_eq!(knots, gouraud::knots(&p, t), "{name}");
                }
                // Again with triangles out of order: numbers that no longer fit must do no harm.
                p.triangles.reverse();
            }
            if name == "sphere-690" {
                let v = vertices(&p);
                assert!(
                    v.knots.len() * 4 < p.triangles.len() * 3,
                    "{}",
                    v.knots.len()
                );
            }
        }
    }
}
