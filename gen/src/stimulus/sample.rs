//! Triangles for a core that is generated without a scene: enough to exercise every register and every case of the walk.

use super::{
    build, sample_lines, Cone, Covering, GradientMap, Lobe, Material, Picture, Relief, Stimulus,
    StimulusError, StimulusOptions, Triangle,
};
use crate::spans;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::texture::{Mapping, Texturing};
use shadegate_reference::raster::{Point, Viewport, SUBPIXELS};
use std::sync::Arc;

/// A small linear congruential generator (Knuth's MMIX constants): vectors must be the same on every machine and in
/// every release, which no general-purpose generator promises.
pub(super) struct Draw(pub(super) u64);

impl Draw {
    pub(super) fn below(&mut self, limit: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit.max(1)
    }
}

/// Materials of the first and the second half of the triangles.
const MATERIALS: [Material; 2] = [
    Material {
        ambient: [20.0, 13.0, 15.0],
        diffuse: [160.0, 70.0, 50.0],
        specular: [110.0, 100.0, 105.0],
        shininess: 20.0,
        lobe: Lobe::Kappa {
            degree: 3,
            gamma: 0.8125,
        },
        cone: Some(Cone {
            hard: false,
            width: 0.5,
        }),
    },
    Material {
        ambient: [4.0, 6.0, 20.0],
        diffuse: [30.0, 60.0, 120.0],
        specular: [255.0, 240.0, 200.0],
        shininess: 90.5,
        lobe: Lobe::Kappa {
            degree: 4,
            gamma: 0.95,
        },
        cone: Some(Cone {
            hard: true,
            width: 0.5,
        }),
    },
];

/// The writes that exercise a core: of `count` triangles, or lines.
///
/// # Errors
/// When one cannot be set up, which no valid frame causes.
pub fn sample(
    core: &Core,
    viewport: Viewport,
    count: usize,
    seed: u64,
) -> Result<Stimulus, StimulusError> {
    if let Order::Line(filter) = core.order {
        return sample_lines(filter, viewport, count, seed);
    }
    let triangles = sample_triangles(core.order, viewport, count, seed);
    build(core, &triangles, viewport, &StimulusOptions::default())
}

/// A surface for a span core: normals that lean up to 45° and more, all of them towards the viewer.
fn surface(draw: &mut Draw) -> Vec<[f64; 3]> {
    let mut lean = || (draw.below(2001) as f64 - 1000.0) / 1000.0;
    let normals = [0; 3].map(|_| [lean(), lean(), 1.0]);
    let colours = [
        [20.0, 12.0, 30.0],
        [140.0, 90.0, 60.0],
        [90.0, 120.0, 110.0],
    ];
    spans::sample(normals, colours, 20.0)
}

/// Two pictures of texels that differ everywhere, small enough for any memory.
fn pictures() -> [Arc<Picture>; 2] {
    [(4usize, 2usize), (2, 4)].map(|(width, height)| {
        let texel = |i: usize| [31 * i % 256, 255 - 17 * i % 256, 101 * i % 256].map(|v| v as u8);
        Arc::new(Picture {
            width,
            height,
            texels: (width..width * height + width).map(texel).collect(),
        })
    })
}

/// A picture on a triangle: some tens of texels across, depths in a ratio of up to 16.
fn covering(draw: &mut Draw, t: Texturing, pictures: &[Arc<Picture>; 2], i: usize) -> Covering {
    let knots = match t.mapping {
        Mapping::Quadratic => 6,
        _ => 3,
    };
    let mut knot = |_| {
        let at = |v: u64| v as f64 / 64.0 - 20.0;
        let (u, v) = (at(draw.below(2560)), at(draw.below(2560)));
        [u, v, (1 + draw.below(16)) as f64]
    };
    Covering {
        address: (0..knots).map(&mut knot).collect(),
        picture: pictures[i / 3 % 2].clone(),
        nearest: i.is_multiple_of(4),
    }
}

/// A map of gradients that differ everywhere.
fn gradients() -> Arc<GradientMap> {
    let slope =
        |x: usize, y: usize| [(5 * x + 3 * y) % 64, (x * y) % 61].map(|s| s as f64 / 32.0 - 1.0);
    Arc::new(GradientMap::new(slope))
}

/// A map on a triangle; every fourth one is smooth.
fn relief(draw: &mut Draw, map: &Arc<GradientMap>, i: usize) -> Option<Relief> {
    let mut at = || [0; 2].map(|_| draw.below(2560) as f64 / 16.0 - 20.0);
    let address = [at(), at(), at()];
    let bumpy = !i.is_multiple_of(4);
    bumpy.then(|| Relief {
        map: map.clone(),
        address,
    })
}

/// `count` triangles of mixed size and shape in (and a little around) the frame: both orientations, level edges,
/// slivers, single pixels, shared corners, overlapping depths.
#[must_use]
pub fn sample_triangles(
    order: Order,
    viewport: Viewport,
    count: usize,
    seed: u64,
) -> Vec<Triangle> {
    let mut draw = Draw(seed);
    let (w, h) = (u64::from(viewport.width), u64::from(viewport.height));
    let sub = SUBPIXELS as u64;
    let material = |i: usize| {
        let shades = matches!(
            order,
            Order::QuadraticDots | Order::Duff | Order::Glint(_) | Order::Bump(_)
        );
        shades.then(|| MATERIALS[2 * i / count.max(1)])
    };
    let knots = match order {
        Order::Linear => 3,
        Order::Bump(_) => 12,
        _ => 6,
    };
    let map = gradients();
    let pictures = pictures();
    let mut out: Vec<Triangle> = vec![];
    for i in 0..count {
        let reach = [2, 5, 12, 40, w.max(h)][draw.below(5) as usize];
        let (cx, cy) = (draw.below(w * sub) as i64, draw.below(h * sub) as i64);
        let mut corner = || {
            let mut offset = || (draw.below(2 * reach * sub) as i64 - (reach * sub) as i64) / 2;
            let margin = |v: i64, size: u64| {
                v.clamp(-((size * sub) as i64) / 4, (size * sub * 5 / 4) as i64) as i32
            };
            Point {
                x: margin(cx + offset(), w),
                y: margin(cy + offset(), h),
            }
        };
        let mut position = [corner(), corner(), corner()];
        match i % 8 {
            1 => position[1].y = position[0].y,
            2 => position[2].y = position[1].y,
            3 => position[2].x = position[0].x + (position[2].x - position[0].x) / 16,
            4 if !out.is_empty() => position[0] = out[out.len() - 1].position[1],
            _ => {}
        }
        let depth = std::array::from_fn(|_| draw.below(65_536) as f64);
        let mut knot = |_| {
            let at = std::array::from_fn(|_| draw.below(256) as f64);
            match order {
                // Cosines from -0.5 to 1.
                Order::QuadraticDots => [at[0] / 170.0 - 0.5, at[1] / 170.0 - 0.5, 0.0],
                Order::Glint(_) => at.map(|c| c / 170.0 - 0.5),
                // Parts of vectors from -0.3 to 0.7.
                Order::Bump(_) => at.map(|c| c / 255.0 - 0.3),
                // Dot products from -0.5 to 1 with a normal of a length from 0.7 to 1 that does not change.
                Order::Duff => [
                    at[0] / 170.0 - 0.5,
                    at[1] / 170.0 - 0.5,
                    0.5 + (i % 8) as f64 / 14.0,
                ],
                _ => at,
            }
        };
        let knots = match order {
            Order::Span(_) => surface(&mut draw),
            _ => (0..knots).map(&mut knot).collect(),
        };
        out.push(Triangle {
            position,
            depth,
            knots,
            material: material(i),
            covering: match order {
                Order::Textured(t) => Some(covering(&mut draw, t, &pictures, i)),
                _ => None,
            },
            relief: match order {
                Order::Bump(_) => relief(&mut draw, &map, i),
                _ => None,
            },
            label: format!("sample {i}"),
        });
    }
    out
}
