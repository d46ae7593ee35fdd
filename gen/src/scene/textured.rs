//! Textured scenes: the core that draws one, the pictures of its materials as bytes, and the address of a triangle.

use super::Unsuited;
use crate::stimulus::{Covering, Picture, Triangle};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::texture::Mapping as Address;
use shadegate_hdl::texture::{Texturing, MAX_SIDE, MAX_TEXELS_LOG2, USUAL_TEXELS_LOG2};
use shadegate_reference::scene::Material;
use shadegate_reference::texture::{Filter, Footprint, Mapping, Texture, Wrap};
use shadegate_reference::{Prepared, Scene, ScreenTriangle};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The materials of the objects of a scene.
fn used(scene: &Scene) -> impl Iterator<Item = &Material> {
    let of = |o: &shadegate_reference::scene::Object| scene.materials.get(o.material);
    scene.objects.iter().filter_map(of)
}

/// Whether a material of an object has a texture.
#[must_use]
pub fn is_textured(scene: &Scene) -> bool {
    used(scene).any(|m| m.texture.is_some())
}

/// Columns and rows of a picture.
fn size(texture: &Texture) -> [usize; 2] {
    // Where texture coordinates of 1 lie, in texels, is the size times the repetitions.
    let [_, one, _] = texture.in_texels(&[[0.0; 2].into(), [1.0; 2].into(), [0.0; 2].into()]);
    let repeat = texture.layout().repeat;
    [one.x / repeat.x, one.y / repeat.y].map(|n| n.round() as usize)
}

/// The picture of a texture with the filter nearest or bilinear, rounded to bytes.
fn picture(texture: &Texture) -> Picture {
    let [width, height] = size(texture);
    let still = Footprint {
        right: [0.0; 2].into(),
        down: [0.0; 2].into(),
    };
    let texel = |i: usize| {
        // At its centre a texel is what either filter gives.
        let at = [(i % width) as f64 + 0.5, (i / width) as f64 + 0.5];
        let rgb = texture.sample(at.into(), &still);
        rgb.map(|v| shadegate_reference::to_byte(255.0 * v))
    };
    Picture {
        width,
        height,
        texels: (0..width * height).map(texel).collect(),
    }
}

/// The textured core for a scene.
///
/// # Errors
/// The first texture that it cannot draw, and textures that one core cannot draw together.
pub fn texturing(scene: &Scene) -> Result<Texturing, Unsuited> {
    let mut mapping = None::<(Mapping, &str)>;
    let mut pictures: Vec<&Arc<Texture>> = vec![];
    let refuse = |what: String, expected: &'static str| Unsuited {
        file: scene.file.display().to_string(),
        what,
        core: "textured",
        expected,
    };
    let mut words = 0;
    if used(scene).any(|m| m.texture.is_none()) {
        words += Picture::white().bank_words();
    }
    for m in used(scene) {
        let (name, Some(texture)) = (m.name.as_str(), &m.texture) else {
            continue;
        };
        let layout = texture.layout();
        if !matches!(layout.filter, Filter::Nearest | Filter::Bilinear) {
            let what = format!("material '{name}' has a texture with a filter of several levels");
            return Err(refuse(what, "filter = 'nearest' or 'bilinear'"));
        }
        if layout.wrap != Wrap::Repeat {
            let what = format!("material '{name}' has a texture that does not repeat");
            return Err(refuse(what, "wrap = 'repeat'"));
        }
        let [width, height] = size(texture);
        let side = |n: usize| n.is_power_of_two() && n <= MAX_SIDE as usize;
        if !side(width) || !side(height) {
            let what = format!("material '{name}' has a texture of {width}x{height} texels");
            return Err(refuse(what, "sides of a power of two, at most 1024"));
        }
        mapping = match (mapping, layout.mapping) {
            // Both other generators draw affine addresses too.
            (None, new) | (Some((Mapping::Affine, _)), new) => Some((new, name)),
            (old, Mapping::Affine) => old,
            (Some((old, _)), new) if old == new => Some((old, name)),
            (Some((_, first)), _) => {
                let what =
                    format!("materials '{first}' and '{name}' have textures of different mappings");
                return Err(refuse(
                    what,
                    "quadratic or perspective mapping, beside affine",
                ));
            }
        };
        if !pictures.iter().any(|t| Arc::ptr_eq(t, texture)) {
            words += width.div_ceil(2) * height.div_ceil(2);
            pictures.push(texture);
        }
    }
    let texels_log2 = (4 * words).next_power_of_two().trailing_zeros();
    if texels_log2 > u32::from(MAX_TEXELS_LOG2) {
        let what = format!("its textures have {} texels together", 4 * words);
        return Err(refuse(what, "at most 65536 texels"));
    }
    Ok(Texturing {
        mapping: match mapping.map(|m| m.0) {
            Some(Mapping::Quadratic) => Address::Quadratic,
            Some(Mapping::Perspective) => Address::Perspective,
            Some(Mapping::Affine) | None => Address::Affine,
        },
        texels_log2: (texels_log2 as u8).max(USUAL_TEXELS_LOG2),
    })
}

/// The core that draws a scene with the colours of `order`: a textured one where the scene has textures.
///
/// # Errors
/// Textures that no core draws.
pub(super) fn order_for(scene: &Scene, order: Order) -> Result<Order, Unsuited> {
    let Some(m) = used(scene).find(|m| m.texture.is_some()) else {
        return Ok(order);
    };
    match order {
        Order::Linear | Order::Quadratic | Order::Textured(_) => {
            texturing(scene).map(Order::Textured)
        }
        _ => Err(Unsuited {
            file: scene.file.display().to_string(),
            what: format!("material '{}' has a texture", m.name),
            core: Core {
                order,
                wide: false,
                pixels: 2,
                load_words: 1,
            }
            .name(),
            expected: "method gouraud or quadratic",
        }),
    }
}

/// u, v in texels and w at the knots of a triangle.
fn address(t: &ScreenTriangle, texture: &Texture, mapping: Address) -> Vec<[f64; 3]> {
    let uv = texture.in_texels(&t.uv);
    let own = texture.layout().mapping;
    let vertex = |i: usize| {
        let w = match own {
            Mapping::Perspective => t.inv_w[i],
            _ => 1.0,
        };
        [uv[i].x, uv[i].y, w]
    };
    let mut all: Vec<[f64; 3]> = (0..3).map(vertex).collect();
    if mapping == Address::Quadratic {
        // The true place at the middle of an edge on the screen; of an affine address, half-way.
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let part = match own {
                Mapping::Affine => 0.5,
                _ => t.inv_w[j] / (t.inv_w[i] + t.inv_w[j]),
            };
            let between = |a: f64, b: f64| a + (b - a) * part;
            let (a, b) = (all[i], all[j]);
            all.push([between(a[0], b[0]), between(a[1], b[1]), 1.0]);
        }
    }
    all
}

/// Adds the pictures of a prepared scene to its triangles.
pub fn cover(p: &Prepared, mapping: Address, triangles: &mut [Triangle]) {
    let mut pictures: BTreeMap<usize, Arc<Picture>> = BTreeMap::new();
    for (t, to) in p.triangles.iter().zip(triangles) {
        let Some(texture) = &p.surroundings().material(t.material).texture else {
            continue;
        };
        let own = || Arc::new(picture(texture));
        to.covering = Some(Covering {
            picture: pictures.entry(t.material).or_insert_with(own).clone(),
            nearest: texture.layout().filter == Filter::Nearest,
            address: address(t, texture, mapping),
        });
    }
}
