//! Scenes with bump maps: the core that draws one, the gradients of its maps, light and half-way vector in the frame of a
//! triangle.
//!
//! The software bends a normal n by the gradient G = F_u·A + F_v·B, F being the height in the coordinates of the map and A, B
//! what the triangle makes of them: (e₂·Δu₁ − e₁·Δu₂) × n/|e₁ × e₂|, and so with v (see `reference/src/bump`). The core has
//! one normal, (−F_u, −F_v, 1), and a map of gradients in world units. So the map that it is sent is scaled by a = |A| and
//! b = |B| of the flat triangle, and light and half-way vector are turned into A/a, B/b and n: their products with the
//! gradient are then those of the software, whatever A and B are. The square g² = |G|² is F_u²·a² + F_v²·b² where A and B are
//! at right angles; a map that lies askew is refused, and one map per scale is sent.

use super::{reflected, Unsuited};
use crate::stimulus::{GradientMap, Lobe, Material, Relief, Triangle};
use glam::{DVec2, DVec3};
use shadegate_hdl::bump::{Bend, GRADIENT_LIMIT, MAP_SIZE};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::bump::{BumpMap, Gradient, Normalise};
use shadegate_reference::scene;
use shadegate_reference::shade::quadratic::EDGES;
use shadegate_reference::texture::Wrap;
use shadegate_reference::{depth, Method, Prepared, Scene, ScreenTriangle};
use std::sync::Arc;

/// Most maps of a scene, those of one material on surfaces of several scales counted each.
const MAPS: usize = 8;
/// Largest cosine between the directions of u and v.
const ASKEW: f64 = 0.02;

fn used(scene: &Scene) -> impl Iterator<Item = &scene::Material> {
    let of = |o: &scene::Object| scene.materials.get(o.material);
    scene.objects.iter().filter_map(of)
}

/// Whether a material of an object has a bump map.
#[must_use]
pub fn has_bumps(scene: &Scene) -> bool {
    used(scene).any(|m| m.bump.is_some())
}

/// The bump core of a scene for a method, if it asks for one: methods that shade at vertices do not show bumps.
pub(super) fn order_for(scene: &Scene, method: Method) -> Option<Order> {
    let bump = used(scene).find_map(|m| m.bump.as_ref())?;
    (method == Method::Phong).then_some(Order::Bump(match bump.relief().normalise {
        Normalise::Newton => Bend::Newton,
        // `suited` refuses the third.
        Normalise::Reflection | Normalise::Exact => Bend::Reflection,
    }))
}

fn refusal(scene: &Scene, bend: Bend, what: String, expected: &'static str) -> Unsuited {
    Unsuited {
        file: scene.file.display().to_string(),
        what,
        core: bend.name(),
        expected,
    }
}

/// Whether a bump core can draw the maps of a scene; lights and materials are judged with those of the other cores.
pub(super) fn suited(scene: &Scene, bend: Bend) -> Result<(), Unsuited> {
    let refuse = |m: &scene::Material, what: &str, expected| {
        let what = format!("material '{}' has {what}", m.name);
        Err(refusal(scene, bend, what, expected))
    };
    for m in used(scene) {
        if m.texture.is_some() {
            return refuse(m, "a texture", "bump maps without textures");
        }
        let Some(bump) = &m.bump else {
            continue;
        };
        let relief = bump.relief();
        let own = match relief.normalise {
            Normalise::Newton => Bend::Newton,
            Normalise::Reflection => Bend::Reflection,
            Normalise::Exact => {
                let what = "bumps that are normalised by a square root";
                return refuse(m, what, "bump_normalise = 'newton' or 'reflection'");
            }
        };
        if own != bend {
            let what = "bumps that are normalised otherwise than those before";
            return refuse(m, what, "one bump_normalise");
        }
        if relief.gradient != Gradient::Linear {
            return refuse(m, "another bump_gradient", "bump_gradient = 'linear'");
        }
        if relief.wrap != Wrap::Repeat {
            return refuse(m, "a bump map that does not repeat", "wrap = 'repeat'");
        }
        let [columns, rows] = bump.size().to_array();
        let side = |n: f64| (n as usize).is_power_of_two() && n as usize <= MAP_SIZE;
        if !side(columns) || !side(rows) {
            let what = format!("a bump map of {columns}x{rows} samples");
            return refuse(m, &what, "sides of a power of two, at most 64");
        }
    }
    Ok(())
}

/// What a triangle makes of the coordinates of a map, along both of them.
struct Frame {
    /// Half of the product that makes A and B, to be crossed with a normal.
    across: [DVec3; 2],
}

impl Frame {
    fn of(t: &ScreenTriangle) -> Self {
        let [e1, e2] = [1, 2].map(|i| t.world[i] - t.world[0]);
        let [d1, d2] = [1, 2].map(|i| t.uv[i] - t.uv[0]);
        let area = e1.cross(e2).length();
        let across = |a: f64, b: f64| {
            let v = (e2 * a - e1 * b) / area;
            if v.is_finite() {
                v
            } else {
                DVec3::ZERO
            }
        };
        Self {
            across: [across(d1.x, d2.x), across(d1.y, d2.y)],
        }
    }

    fn scale(&self) -> [f64; 2] {
        self.across.map(DVec3::length)
    }

    fn is_askew(&self) -> bool {
        let [a, b] = self.across.map(DVec3::normalize_or_zero);
        a.dot(b).abs() > ASKEW
    }
}

/// The maps of a prepared scene, each with its material and scale.
struct Maps(Vec<(usize, [f64; 2], Arc<GradientMap>)>);

impl Maps {
    /// The map of a material on a triangle, and its scale.
    fn find(
        &mut self,
        material: usize,
        map: &BumpMap,
        scale: [f64; 2],
    ) -> ([f64; 2], Arc<GradientMap>) {
        let same = |a: [f64; 2]| (0..2).all(|i| (a[i] - scale[i]).abs() <= 1e-6 * scale[i]);
        let found = self.0.iter().find(|(m, s, _)| *m == material && same(*s));
        if let Some((_, scale, map)) = found {
            return (*scale, map.clone());
        }
        let samples = Arc::new(gradients(map, scale));
        self.0.push((material, scale, samples.clone()));
        (scale, samples)
    }
}

/// The gradients at the samples of a map, in world units.
fn gradients(map: &BumpMap, scale: [f64; 2]) -> GradientMap {
    let size = map.size() * map.relief().repeat;
    GradientMap::new(|x, y| {
        let at = DVec2::new(x as f64 + 0.5, y as f64 + 0.5) / size;
        let slope = map.slope(at);
        [slope.x * scale[0], slope.y * scale[1]]
    })
}

/// Whether the maps of a prepared scene lie on its triangles as a bump core takes them.
///
/// # Errors
/// The first triangle on which one does not.
pub fn fitting(scene: &Scene, p: &Prepared, order: Order) -> Result<(), Unsuited> {
    let Order::Bump(bend) = order else {
        return Ok(());
    };
    let mut maps = Maps(vec![]);
    for t in &p.triangles {
        let m = p.surroundings().material(t.material);
        let Some(bump) = &m.bump else {
            continue;
        };
        let refuse = |what: &str, expected| {
            let what = format!("material '{}' has a bump map {what}", m.name);
            Err(refusal(scene, bend, what, expected))
        };
        let frame = Frame::of(t);
        if frame.is_askew() {
            return refuse(
                "that lies askew on an object",
                "surfaces on which u and v are at right angles, as on planes and boxes",
            );
        }
        let (_, map) = maps.find(t.material, bump, frame.scale());
        if maps.0.len() > MAPS {
            return refuse(
                "in more scales than a core is sent",
                "surfaces on which it has at most 8 scales together",
            );
        }
        if map.steepest() > GRADIENT_LIMIT - 1.0 / 65_536.0 {
            return refuse("steeper than 2", "bumps of a smaller bump_scale");
        }
    }
    Ok(())
}

/// The material of a triangle as a core takes it.
fn material(p: &Prepared, t: &ScreenTriangle) -> Material {
    let s = p.surroundings();
    let m = s.material(t.material);
    let colour = |own: DVec3| match s.lights() {
        0 => [0.0; 3],
        _ => (s.light(0).0.colour * own * 255.0).to_array(),
    };
    Material {
        ambient: ((m.emission + m.ambient) * 255.0).to_array(),
        diffuse: colour(m.diffuse),
        specular: match reflected::shines(m) {
            true => colour(m.specular),
            false => [0.0; 3],
        },
        shininess: m.shininess,
        lobe: Lobe::Power,
        cone: None,
    }
}

/// Light and half-way vector at six knots, in the frame of the triangle whose map has a scale.
fn vectors(p: &Prepared, t: &ScreenTriangle, frame: &Frame, scale: [f64; 2]) -> Vec<[f64; 3]> {
    let s = p.surroundings();
    if s.lights() == 0 {
        return vec![[0.0; 3]; 12];
    }
    let vertex = (0..3).map(|i| (t.normal[i], t.world[i]));
    let edge = EDGES.into_iter().map(|(i, j)| {
        let (sum, place) = (t.normal[i] + t.normal[j], t.world[i] + t.world[j]);
        (sum, place / 2.0)
    });
    let knots: Vec<(DVec3, DVec3)> = vertex.chain(edge).collect();
    let turned = |normal: DVec3, v: DVec3| {
        let n = normal.try_normalize().unwrap_or_else(|| t.face_normal());
        let along = |i: usize| match scale[i] {
            0.0 => 0.0,
            a => frame.across[i].cross(n).dot(v) / a,
        };
        [along(0), along(1), n.dot(v)]
    };
    let light = |x: DVec3| s.incident(0, x).direction;
    let half = |x: DVec3| (light(x) + s.view(x)).normalize_or_zero();
    let lights = knots.iter().map(|(n, x)| turned(*n, light(*x)));
    let halves = knots.iter().map(|(n, x)| turned(*n, half(*x)));
    lights.chain(halves).collect()
}

/// The triangles of a prepared scene for a bump core: six knots of the light, then six of the half-way vector, each along
/// both tangents and the normal.
pub fn triangles(p: &Prepared) -> Vec<Triangle> {
    let mut maps = Maps(vec![]);
    let one = |t: &ScreenTriangle| {
        let frame = Frame::of(t);
        let own = p.surroundings().material(t.material).bump.as_ref();
        let mut scale = frame.scale();
        let relief = own.map(|bump| {
            let (own, map) = maps.find(t.material, bump, scale);
            scale = own;
            let size = bump.size() * bump.relief().repeat;
            // Whole maps off, so that places are small.
            let first = (t.uv[0] * size / MAP_SIZE as f64).floor() * MAP_SIZE as f64;
            Relief {
                map,
                address: t.uv.map(|uv| (uv * size - first).to_array()),
            }
        });
        Triangle {
            position: t.position,
            depth: t.depth.map(depth::scaled),
            knots: vectors(p, t, &frame, scale),
            material: Some(material(p, t)),
            covering: None,
            relief,
            label: format!("object {}, face {}", t.object, t.face),
        }
    };
    p.triangles.iter().map(one).collect()
}
