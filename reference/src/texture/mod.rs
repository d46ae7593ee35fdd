//! Textures: pictures on surfaces. A texel multiplies the whole colour that the shading method gives a pixel, highlight
//! included, channel by channel, and the product is rounded once ("modulate" of fixed-function hardware). Address
//! mapping, filters and what lies beside the picture are the material's; they work with every shading method through
//! [`Textured`], which wraps any of them.
//!
//! Places in a texture are given in texels, texel i covering i..i + 1; u runs to the right and v upwards.

pub mod affine;
pub mod area;
pub mod footprint;
pub mod mapping;
pub mod mipmap;
pub mod pattern;
pub mod point;
pub mod pyramid;
pub mod ripmap;
mod shader;
pub mod texels;
pub mod wrap;

pub use footprint::Footprint;
pub use mapping::Mapping;
pub use shader::Textured;
pub use texels::{Texels, TexelsError};
pub use wrap::Wrap;

use glam::DVec2;

/// How texels become a colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// The nearest texel.
    Nearest,
    /// Four texels.
    Bilinear,
    /// Trilinear between averages of squares.
    #[default]
    MipMap,
    /// Between averages of rectangles of 2ⁱ × 2ʲ.
    Ripmap,
    /// The mean of any box.
    SummedArea,
}

/// How a texture is laid on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// How addresses are interpolated.
    pub mapping: Mapping,
    /// How texels become a colour.
    pub filter: Filter,
    /// What lies beside the picture.
    pub wrap: Wrap,
    /// How often the picture fits between texture coordinates 0 and 1, in u and v.
    pub repeat: DVec2,
}

impl Default for Layout {
    fn default() -> Self {
        Self {
            mapping: Mapping::default(),
            filter: Filter::default(),
            wrap: Wrap::default(),
            repeat: DVec2::ONE,
        }
    }
}

/// A picture ready to be looked up.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    layout: Layout,
    size: DVec2,
    sampler: Sampler,
}

/// The picture in the form that its filter wants.
#[derive(Clone, Debug, PartialEq)]
enum Sampler {
    Nearest(Texels),
    Bilinear(Texels),
    MipMap(mipmap::MipMap),
    Ripmap(ripmap::Ripmap),
    SummedArea(area::SummedArea),
}

impl Texture {
    /// Prepares a picture for its filter.
    #[must_use]
    pub fn new(picture: Texels, layout: Layout) -> Self {
        Self {
            layout,
            size: DVec2::new(picture.width() as f64, picture.height() as f64),
            sampler: match layout.filter {
                Filter::Nearest => Sampler::Nearest(picture),
                Filter::Bilinear => Sampler::Bilinear(picture),
                Filter::MipMap => Sampler::MipMap(mipmap::MipMap::new(picture)),
                Filter::Ripmap => Sampler::Ripmap(ripmap::Ripmap::new(picture)),
                Filter::SummedArea => Sampler::SummedArea(area::SummedArea::new(&picture)),
            },
        }
    }

    /// How it is laid on a surface.
    #[must_use]
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The texture coordinates of a triangle in texels. Where the picture repeats, whole pictures are taken off, so that
    /// no digits are spent on them.
    #[must_use]
    pub fn in_texels(&self, uv: &[DVec2; 3]) -> [DVec2; 3] {
        let scaled = uv.map(|v| v * self.layout.repeat);
        let whole = match self.layout.wrap {
            Wrap::Repeat => scaled[0].floor(),
            Wrap::Clamp => DVec2::ZERO,
        };
        scaled.map(|v| (v - whole) * self.size)
    }

    /// The filtered colour at a place, fractions of full scale.
    #[must_use]
    pub fn sample(&self, at: DVec2, footprint: &Footprint) -> [f64; 3] {
        let wrap = self.layout.wrap;
        match &self.sampler {
            Sampler::Nearest(t) => point::nearest(t, wrap, at),
            Sampler::Bilinear(t) => point::bilinear(t, wrap, at),
            Sampler::MipMap(m) => m.sample(wrap, at, footprint),
            Sampler::Ripmap(r) => r.sample(wrap, at, footprint),
            Sampler::SummedArea(s) => s.sample(wrap, at, footprint),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FILTERS: [Filter; 5] = [
        Filter::Nearest,
        Filter::Bilinear,
        Filter::MipMap,
        Filter::Ripmap,
        Filter::SummedArea,
    ];

    fn texture(picture: Texels, filter: Filter, wrap: Wrap) -> Texture {
        Texture::new(
            picture,
            Layout {
                filter,
                wrap,
                ..Layout::default()
            },
        )
    }

    proptest! {
        /// Weights that sum to one leave a picture of one colour as it is; and no filter leaves the range of its texels.
        #[test]
        fn weights_sum_to_one(
            w in 1usize..20, h in 1usize..20, x in -1e3..1e3f64, y in -1e3..1e3f64,
            right in prop::array::uniform2(-40.0..40.0f64), down in prop::array::uniform2(-40.0..40.0f64), clamp: bool,
        ) {
            let wrap = if clamp { Wrap::Clamp } else { Wrap::Repeat };
            let f = Footprint { right: right.into(), down: down.into() };
            let at = DVec2::new(x, y);
            for filter in FILTERS {
                let plain = texture(Texels::from_fn(w, h, |_, _| [0.25, 0.5, 0.8]), filter, wrap);
                for (got, want) in plain.sample(at, &f).into_iter().zip([0.25, 0.5, 0.8]) {
                    prop_assert!((got - want).abs() < 1e-6, "{filter:?} {got}");
                }
                let mixed = texture(Texels::from_fn(w, h, |x, y| [((x + y) % 2) as f32; 3]), filter, wrap);
                prop_assert!(mixed.sample(at, &f).iter().all(|v| (0.0..=1.0).contains(v)), "{filter:?}");
            }
        }
    }

    #[test]
    fn where_a_pixel_covers_one_texel_all_smooth_filters_are_bilinear() {
        let f = Footprint {
            right: DVec2::X,
            down: DVec2::Y,
        };
        let [_, bilinear, rest @ ..] =
            FILTERS.map(|filter| texture(pattern::colour("tiles").unwrap(), filter, Wrap::Repeat));
        for k in 0..500 {
            let at = DVec2::new(f64::from(k) * 0.37, f64::from(k) * 0.71);
            let want = bilinear.sample(at, &f);
            for t in &rest {
                for (got, want) in t.sample(at, &f).into_iter().zip(want) {
                    assert!((got - want).abs() < 4e-6);
                }
            }
        }
    }

    #[test]
    fn whole_pictures_are_taken_off() {
        let layout = Layout {
            repeat: DVec2::new(2.0, 3.0),
            ..Layout::default()
        };
        let t = Texture::new(pattern::colour("checker").unwrap(), layout);
        let uv = [
            DVec2::new(100.25, -7.0),
            DVec2::new(101.0, -7.5),
            DVec2::new(100.0, 0.0),
        ];
        let moved = t.in_texels(&uv);
        assert_eq!(moved[0], DVec2::new(32.0, 0.0));
        assert_eq!(moved[1] - moved[0], DVec2::new(1.5, -1.5) * 64.0);
        assert_eq!(moved[2] - moved[0], DVec2::new(-0.5, 21.0) * 64.0);
    }
}
