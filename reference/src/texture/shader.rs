//! Any shading method with the textures of the materials: the colour of its run times the texel.

use super::mapping::{Address, Mapping, Track};
use super::{affine, Texture};
use crate::geometry::Prepared;
use crate::raster::Span;
use crate::shade::shader::{Draw, Run, Shader};
use crate::skips::{self, Skips};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};

/// A method with textures.
pub struct Textured<'a, S> {
    inner: &'a S,
    affine: bool,
    constant_depth: bool,
    skip_unseen: bool,
    counts: Counts,
}

/// Work left out.
#[derive(Default)]
struct Counts {
    /// Triangles with affine addresses in place of perspective ones.
    affine: AtomicU64,
    /// Spans with one reciprocal.
    constant_depth: AtomicU64,
    /// Hidden pixels for which no texel was looked up.
    unseen: AtomicU64,
}

fn add(count: &AtomicU64, n: u64) {
    count.fetch_add(n, Ordering::Relaxed);
}

impl<'a, S: Shader> Textured<'a, S> {
    /// Wraps a method. Around the truth every address is found by perspective, whatever mapping the materials ask for,
    /// and nothing is approximated.
    #[must_use]
    pub fn new(inner: &'a S, skips: &Skips) -> Self {
        Self {
            inner,
            affine: !S::EXACT && skips.is_on(skips::AFFINE),
            constant_depth: !S::EXACT && skips.is_on(skips::CONSTANT_DEPTH),
            skip_unseen: skips.is_on(skips::TEXTURE),
            counts: Counts::default(),
        }
    }

    /// Adds what has been skipped so far to `skipped`.
    pub fn count(&self, skipped: &mut BTreeMap<&'static str, u64>) {
        for (name, count) in [
            (skips::AFFINE, &self.counts.affine),
            (skips::CONSTANT_DEPTH, &self.counts.constant_depth),
            (skips::TEXTURE, &self.counts.unseen),
        ] {
            let n = count.load(Ordering::Relaxed);
            if n > 0 {
                skipped.insert(name, n);
            }
        }
    }
}

impl<S> Textured<'_, S> {
    /// The texels along a span, if the material has a texture.
    fn texels<'b, T>(
        &'b self,
        p: &'b Prepared,
        triangle: &TexturedTriangle<T>,
        span: Span,
    ) -> Option<TexelRun<'b>> {
        triangle.address.as_ref().and_then(|(address, material)| {
            let texture = p.surroundings.material(*material).texture.as_deref()?;
            let pixels = span.end - span.start;
            let track = address.start(span.start, span.y, pixels, self.constant_depth);
            if matches!(track, Track::Line(_)) {
                add(&self.counts.constant_depth, 1);
            }
            Some(TexelRun {
                texture,
                track,
                looked_up: Cell::new(false),
                unseen: 0,
                skip_unseen: self.skip_unseen,
                counts: &self.counts,
            })
        })
    }
}

/// A triangle of the wrapped method and its address, if its material has a texture.
pub struct TexturedTriangle<T> {
    inner: T,
    address: Option<(Address, usize)>,
}

/// A span of the wrapped method and its texels.
pub struct TexturedRun<'a, R> {
    inner: R,
    texels: Option<TexelRun<'a>>,
}

impl<S: Shader> Shader for Textured<'_, S> {
    const ONE_PIXEL: bool = S::ONE_PIXEL;
    type Triangle = TexturedTriangle<S::Triangle>;
    type Run<'b>
        = TexturedRun<'b, S::Run<'b>>
    where
        Self: 'b;

    fn triangle(&self, p: &Prepared, index: usize) -> Self::Triangle {
        let t = &p.triangles[index];
        let address = p
            .surroundings
            .material(t.material)
            .texture
            .as_ref()
            .map(|texture| {
                let uv = texture.in_texels(&t.uv);
                let mapping = match texture.layout().mapping {
                    _ if S::EXACT => Mapping::Perspective,
                    Mapping::Perspective
                        if self.affine && affine::bound(&t.inv_w, &uv) < affine::TOLERANCE =>
                    {
                        add(&self.counts.affine, 1);
                        Mapping::Affine
                    }
                    mapping => mapping,
                };
                (Address::new(t, &uv, mapping), t.material)
            });
        TexturedTriangle {
            inner: self.inner.triangle(p, index),
            address,
        }
    }

    fn start<'b>(
        &'b self,
        p: &'b Prepared,
        triangle: &'b Self::Triangle,
        span: Span,
    ) -> Self::Run<'b> {
        TexturedRun {
            inner: self.inner.start(p, &triangle.inner, span),
            texels: self.texels(p, triangle, span),
        }
    }

    fn one_pixel<D: Draw>(
        &self,
        p: &Prepared,
        triangle: &Self::Triangle,
        span: Span,
        draw: D,
    ) -> D::Out {
        let texels = self.texels(p, triangle, span);
        let on = On { texels, draw };
        self.inner.one_pixel(p, &triangle.inner, span, on)
    }
}

/// Lays texels on a run.
struct On<'a, D> {
    texels: Option<TexelRun<'a>>,
    draw: D,
}

impl<D: Draw> Draw for On<'_, D> {
    type Out = D::Out;

    fn draw(self, inner: impl Run) -> D::Out {
        let Self { texels, draw } = self;
        draw.draw(TexturedRun { inner, texels })
    }
}

/// The texels along a span.
struct TexelRun<'a> {
    texture: &'a Texture,
    track: Track,
    /// Whether the texel of the current pixel has been asked for.
    looked_up: Cell<bool>,
    /// Pixels passed without.
    unseen: u64,
    skip_unseen: bool,
    counts: &'a Counts,
}

impl TexelRun<'_> {
    fn texel(&self) -> [f64; 3] {
        let (at, footprint) = self.track.place();
        self.texture.sample(at, &footprint)
    }

    fn step(&mut self) {
        if !self.looked_up.replace(false) {
            if self.skip_unseen {
                self.unseen += 1;
            } else {
                // The work that the skip saves, done all the same.
                std::hint::black_box(self.texel());
            }
        }
        self.track.step();
    }
}

impl Drop for TexelRun<'_> {
    fn drop(&mut self) {
        if self.unseen > 0 {
            add(&self.counts.unseen, self.unseen);
        }
    }
}

impl<R: Run> Run for TexturedRun<'_, R> {
    fn colour(&self) -> [f64; 3] {
        let colour = self.inner.colour();
        match &self.texels {
            None => colour,
            Some(run) => {
                run.looked_up.set(true);
                let texel = run.texel();
                [0, 1, 2].map(|c| colour[c] * texel[c])
            }
        }
    }

    fn step(&mut self) {
        self.inner.step();
        if let Some(run) = &mut self.texels {
            run.step();
        }
    }
}
