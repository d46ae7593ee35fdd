//! Knots that triangles share are worked out once, colours and unit normals alike: a vertex of a closed mesh belongs to
//! about six triangles and an edge to two, so six knots for each of T triangles are about 2T in place of 6T. The knots are the
//! same bits as without sharing, because what decides them is compared before one is taken over.

use crate::geometry::{Prepared, ScreenTriangle, UNSHARED};
use crate::parallel;
use crate::shade::quadratic::EDGES;
use crate::shade::{gouraud, quadratic, unit_normal};
use glam::DVec3;
use std::ops::Range;

/// Where a knot is first met: triangle, and corner or edge.
type Place = (usize, usize);

/// Least number of triangles worth a part of their own, and parts for each thread. Knots are shared within a part only,
/// so that parts know nothing of each other; knots on their borders are shaded for each.
const LEAST: usize = 2048;
const PARTS: usize = 4;

/// The size of parts of the triangles of a scene.
fn part(p: &Prepared) -> usize {
    parallel::share(p.triangles.len(), LEAST, PARTS)
}

/// No slot.
const NONE: u32 = u32::MAX;

/// Slots by pairs of numbers: for each lower number a chain of the higher ones, of which a mesh has about three.
#[derive(Default)]
struct Pairs {
    first: Vec<u32>,
    chain: Vec<Link>,
}

struct Link {
    higher: u32,
    slot: u32,
    next: u32,
}

impl Pairs {
    /// Forgets all; for numbers below `numbers`.
    fn clear(&mut self, numbers: usize) {
        self.first.clear();
        self.first.resize(numbers, NONE);
        self.chain.clear();
        self.chain.reserve(3 * numbers);
    }

    /// The slot of a pair; `new` if it has none yet.
    #[inline]
    fn slot(&mut self, a: u32, b: u32, new: u32) -> u32 {
        let (lower, higher) = (a.min(b) as usize, a.max(b));
        let head = self.first[lower];
        let mut at = head;
        while let Some(link) = self.chain.get(at as usize) {
            if link.higher == higher {
                return link.slot;
            }
            at = link.next;
        }
        self.first[lower] = self.chain.len() as u32;
        self.chain.push(Link {
            higher,
            slot: new,
            next: head,
        });
        new
    }
}

/// Which corners, or which edges, of the triangles of a part have one knot: their slots, and where each slot is first
/// met.
struct Slots {
    slots: Vec<[u32; 3]>,
    met: Vec<Place>,
}

/// Everything a vertex knot depends on.
fn same_vertex((a, i): (&ScreenTriangle, usize), (b, j): (&ScreenTriangle, usize)) -> bool {
    a.material == b.material
        && a.world[i] == b.world[j]
        && a.normal[i] == b.normal[j]
        && a.inv_w[i] == b.inv_w[j]
}

/// Vertices of the triangles of a part that are `wanted`, by their numbers; that they are the same is made sure.
fn vertex_slots(
    p: &Prepared,
    range: Range<usize>,
    first: &mut Vec<u32>,
    wanted: impl Fn(usize) -> bool,
) -> Slots {
    let mut met: Vec<Place> = Vec::with_capacity(range.len());
    first.clear();
    let slots = range.map(|t| {
        if !wanted(t) {
            return [NONE; 3];
        }
        let numbers = p.vertices.get(t).copied().unwrap_or([UNSHARED; 3]);
        [0, 1, 2].map(|i| {
            let new = met.len() as u32;
            let number = numbers[i] as usize;
            if numbers[i] != UNSHARED {
                if first.len() <= number {
                    first.resize((number + 1).max(2 * first.len()), NONE);
                }
                if let Some((u, j)) = met.get(first[number] as usize) {
                    if same_vertex((&p.triangles[t], i), (&p.triangles[*u], *j)) {
                        return first[number];
                    }
                }
                first[number] = new;
            }
            met.push((t, i));
            new
        })
    });
    Slots {
        slots: slots.collect(),
        met,
    }
}

/// Whether the normals at the ends of edge `k` may cancel; they do not when less than 90 degrees apart and not short,
/// because weights are positive.
fn may_cancel(t: &ScreenTriangle, k: usize) -> bool {
    let (a, b) = (t.normal[EDGES[k].0], t.normal[EDGES[k].1]);
    let long = |n: DVec3| n.length_squared() > 0.01;
    !(a.dot(b) >= 0.0 && long(a) && long(b)) && quadratic::cancels(t, k)
}

/// Edges of the triangles of a part between the slots of their vertices.
fn edge_slots(p: &Prepared, start: usize, vertices: &Slots, pairs: &mut Pairs) -> Slots {
    pairs.clear(vertices.met.len());
    let mut met: Vec<Place> = Vec::with_capacity(2 * vertices.met.len());
    let slots = vertices.slots.iter().enumerate().map(|(n, ends)| {
        [0, 1, 2].map(|k| {
            let (a, b) = (ends[EDGES[k].0], ends[EDGES[k].1]);
            if a == NONE {
                return NONE;
            }
            let new = met.len() as u32;
            let slot = pairs.slot(a, b, new);
            if slot != new && !may_cancel(&p.triangles[start + n], k) {
                return slot;
            }
            met.push((start + n, k));
            new
        })
    });
    Slots {
        slots: slots.collect(),
        met,
    }
}

/// Knots by slot, and the slot of every corner or edge of every triangle.
struct Part {
    slots: Vec<[u32; 3]>,
    knots: Vec<[f64; 3]>,
}

impl Slots {
    fn shade(self, shade: impl Fn(Place) -> [f64; 3]) -> Part {
        Part {
            knots: self.met.iter().map(|place| shade(*place)).collect(),
            slots: self.slots,
        }
    }
}

/// Knots of every triangle.
pub(crate) struct Table {
    /// Triangles in a part.
    size: usize,
    parts: Vec<Part>,
}

impl Table {
    /// The knots of triangle `t`.
    #[inline]
    pub(crate) fn of(&self, t: usize) -> [[f64; 3]; 3] {
        let part = &self.parts[t / self.size];
        part.slots[t % self.size].map(|s| part.knots[s as usize])
    }
}

/// Vertex knots.
pub(crate) fn vertices(p: &Prepared) -> Table {
    let size = part(p);
    let parts = parallel::parts(p.triangles.len(), size, Vec::new, |first, range| {
        let slots = vertex_slots(p, range, first, |_| true);
        slots.shade(|(t, i)| gouraud::vertex(p, &p.triangles[t], i))
    });
    Table { size, parts }
}

/// [`gouraud::knots`] of every triangle.
pub(crate) fn linear(p: &Prepared) -> Vec<[[f64; 3]; 3]> {
    let v = vertices(p);
    parallel::fill(p.triangles.len(), |t| v.of(t))
}

/// Vertex and mid-edge knots.
pub(crate) struct Six {
    vertices: Table,
    edges: Table,
}

impl Six {
    /// Colours.
    pub(crate) fn colours(p: &Prepared) -> Self {
        Self::new(
            p,
            |t, i| gouraud::vertex(p, t, i),
            |t, k| quadratic::middle(p, t, k),
        )
    }

    /// Unit normals.
    pub(crate) fn normals(p: &Prepared) -> Self {
        let vertex = |t: &ScreenTriangle, i: usize| unit_normal(t, t.normal[i]).to_array();
        Self::new(p, vertex, |t, k| quadratic::mid_normal(t, k).to_array())
    }

    /// Works out every knot once in each part.
    fn new(
        p: &Prepared,
        vertex: impl Fn(&ScreenTriangle, usize) -> [f64; 3] + Sync + Send,
        edge: impl Fn(&ScreenTriangle, usize) -> [f64; 3] + Sync + Send,
    ) -> Self {
        let size = part(p);
        let both = |(first, pairs): &mut (Vec<u32>, Pairs), range: Range<usize>| {
            let start = range.start;
            let vertices = vertex_slots(p, range, first, |_| true);
            let edges = edge_slots(p, start, &vertices, pairs);
            let edges = edges.shade(|(t, k)| edge(&p.triangles[t], k));
            let vertices = vertices.shade(|(t, i)| vertex(&p.triangles[t], i));
            (vertices, edges)
        };
        let parts = parallel::parts(p.triangles.len(), size, Default::default, both);
        let (vertices, edges) = parts.into_iter().unzip();
        let table = |parts| Table { size, parts };
        Self {
            vertices: table(vertices),
            edges: table(edges),
        }
    }

    /// The knots of triangle `t`.
    #[inline]
    pub(crate) fn of(&self, t: usize) -> [[f64; 3]; 6] {
        let ([a, b, c], [d, e, f]) = (self.vertices.of(t), self.edges.of(t));
        [a, b, c, d, e, f]
    }
}

/// [`quadratic::knots`] of every triangle.
pub(crate) fn square(p: &Prepared) -> Vec<[[f64; 3]; 6]> {
    let six = Six::colours(p);
    parallel::fill(p.triangles.len(), |t| six.of(t))
}

/// Mid-edge knots of the triangles that are `wanted`; those of others must not be asked for.
pub(crate) fn edges(p: &Prepared, wanted: impl Fn(usize) -> bool + Sync + Send) -> Table {
    let size = part(p);
    let edges = |(first, pairs): &mut (Vec<u32>, Pairs), range: Range<usize>| {
        let start = range.start;
        let vertices = vertex_slots(p, range, first, &wanted);
        let slots = edge_slots(p, start, &vertices, pairs);
        slots.shade(|(t, k)| quadratic::middle(p, &p.triangles[t], k))
    };
    let parts = parallel::parts(p.triangles.len(), size, Default::default, edges);
    Table { size, parts }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::paint::Dots;
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
                let normals = Six::normals(&p);
                for (i, t) in p.triangles.iter().enumerate() {
                    let own = Dots::normals(t).map(|n| n.to_array());
                    assert_eq!(normals.of(i), own, "{name}");
                }
                for (t, knots) in p.triangles.iter().zip(linear(&p)) {
                    assert_eq!(knots, gouraud::knots(&p, t), "{name}");
                }
                // Again with triangles out of order: numbers that no longer fit must do no harm.
                p.triangles.reverse();
            }
            if name == "sphere-690" {
                let v = vertices(&p);
                let knots: usize = v.parts.iter().map(|part| part.knots.len()).sum();
                assert!(knots * 4 < p.triangles.len() * 3, "{knots}");
            }
        }
    }
}
