//! The software renderer: set-up per triangle, then bands of rows in parallel. The frame is the same for any number of
//! threads.

mod bands;
mod frame;
mod lanes;
mod scalar;

pub use frame::{Frame, FrameError};

use crate::bump::Bumped;
use crate::geometry::{Prepared, ScreenTriangle};
use crate::line::wireframe;
use crate::method::Method;
use crate::parallel;
use crate::shade::dispatch::{dispatch, Visitor};
use crate::shade::paint::{is_plain, Dots, Paint, Phong};
use crate::shade::shader::Shader;
use crate::shade::{auto, flat, shared};
use crate::skips::{self, Skips};
use crate::texture::Textured;
use bands::Tally;
use fearless_simd::Level;
use glam::DVec3;
use std::collections::BTreeMap;
use std::time::Instant;

/// How to draw.
#[derive(Clone, Copy, Debug)]
pub struct RenderOptions {
    /// Threads to use; as many as there are processors when not given (or zero).
    pub threads: Option<usize>,
    /// Skips per pixel (`hidden`). Those per triangle were decided when the scene was prepared.
    pub skips: Skips,
    /// How many pixels are drawn at a time, for methods that can draw several.
    pub vectors: Vectors,
    /// The largest error of `auto`, LSB, beside the rounding to a byte.
    pub max_error: f64,
}

impl Default for RenderOptions {
    fn default() -> Self {
        Self {
            threads: None,
            skips: Skips::all(),
            vectors: Vectors::default(),
            max_error: 1.0,
        }
    }
}

/// Vector registers to use. The frame is the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Vectors {
    /// The widest that the processor has.
    #[default]
    Widest,
    /// Those that every processor of its kind has.
    Baseline,
    /// None: pixel by pixel, as the methods of the papers are drawn; for comparisons between methods. Colours then are real
    /// numbers to the end and may round differently in rare pixels.
    None,
}

impl Vectors {
    fn level(self) -> Level {
        match self {
            Self::Baseline | Self::None => Level::baseline(),
            Self::Widest => Level::new(),
        }
    }
}

/// What drawing took.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RenderStats {
    /// Pixels covered, counted once for every triangle that covers them.
    pub pixels_tested: u64,
    /// Of these, given a colour.
    pub pixels_shaded: u64,
    /// Of these, written to the frame.
    pub pixels_written: u64,
    /// Triangles and pixels skipped, by reason.
    pub skipped: BTreeMap<&'static str, u64>,
    /// Time for the set-up of all triangles, ns.
    pub setup_ns: u64,
    /// Time for walking, testing and writing, ns.
    pub raster_ns: u64,
    /// Threads used.
    pub threads: usize,
}

/// Draws a prepared scene.
#[must_use]
pub fn render(p: &Prepared, method: Method, o: &RenderOptions) -> (Frame, RenderStats) {
    parallel::with(o.threads, || {
        let (mut frame, stats) = draw(p, method, o);
        if !p.wires.is_empty() {
            wireframe::draw(&p.wires, &mut frame);
        }
        (frame, stats)
    })
}

/// Many pixels at a time where that is known, else by the method's shader.
fn draw(p: &Prepared, method: Method, o: &RenderOptions) -> (Frame, RenderStats) {
    let start = Instant::now();
    if o.vectors != Vectors::None && !p.is_textured() {
        match method {
            Method::Flat => {
                let colours = parallel::map(p.triangles.len(), |i| flat::knot(p, &p.triangles[i]));
                return vectors(p, o, start, &|i| Paint::Constant(colours[i]));
            }
            Method::Gouraud => {
                let knots = shared::vertices(p);
                return vectors(p, o, start, &|i| Paint::Linear(knots.of(i)));
            }
            Method::Quadratic => {
                let knots = shared::Six::colours(p);
                return vectors(p, o, start, &|i| Paint::Quadratic(knots.of(i)));
            }
            Method::QuadraticDots if all_plain(p) => {
                let normals = shared::Six::normals(p);
                let paint = |i: usize| {
                    let knots = normals.of(i).map(DVec3::from);
                    Dots::new(p, &p.triangles[i], knots).map_or(Paint::Exact, Paint::Dots)
                };
                return vectors(p, o, start, &paint);
            }
            Method::Phong if !p.has_bumps() => {
                let paint =
                    |i: usize| Phong::new(p, &p.triangles[i]).map_or(Paint::Exact, Paint::Phong);
                return vectors(p, o, start, &paint);
            }
            _ => {}
        }
    }
    if method == Method::Phong && p.has_bumps() {
        return scalar(p, &Bumped, o, start);
    }
    if let Some(drawn) = dispatch(p, method, Draw { p, o, start }) {
        return drawn;
    }
    let auto = auto::Auto::new(p, o.max_error, &o.skips, o.vectors.level());
    let (frame, mut stats) = if p.is_textured() {
        scalar(p, &auto, o, start)
    } else {
        vectors(p, o, start, &|i| auto.paint(i))
    };
    for (name, count) in auto.skipped() {
        stats.skipped.insert(name, count);
    }
    (frame, stats)
}

/// Whether every triangle is of the kinds that [`Dots`] and [`Phong`] draw.
fn all_plain(p: &Prepared) -> bool {
    let other = |t: &ScreenTriangle| !is_plain(p, t);
    let others =
        |range: std::ops::Range<usize>| p.triangles[range].iter().filter(|t| other(t)).count();
    parallel::sum(p.triangles.len(), |range| others(range) as u64) == 0
}

/// Draws with any shader.
struct Draw<'a> {
    p: &'a Prepared,
    o: &'a RenderOptions,
    start: Instant,
}

impl Visitor for Draw<'_> {
    type Out = (Frame, RenderStats);

    fn visit<S: Shader>(self, shader: &S) -> Self::Out {
        scalar(self.p, shader, self.o, self.start)
    }
}

/// Draws eight pixels at a time; `start` is when the method began to look at the scene.
fn vectors(
    p: &Prepared,
    o: &RenderOptions,
    start: Instant,
    paint: &lanes::Painter<'_>,
) -> (Frame, RenderStats) {
    let setup_ns = nanoseconds(start);
    let start = Instant::now();
    let level = o.vectors.level();
    let skip_hidden = o.skips.is_on(skips::HIDDEN);
    let (frame, mut tally) = lanes::draw(p, level, &o.skips, paint);
    if skip_hidden {
        tally.hidden = tally.tested - tally.written;
    }
    (frame, stats(p, tally, setup_ns, nanoseconds(start)))
}

/// Draws pixel by pixel, with textures where there are any; `start` is when the method began to look at the scene.
fn scalar<S: Shader>(
    p: &Prepared,
    shader: &S,
    o: &RenderOptions,
    start: Instant,
) -> (Frame, RenderStats) {
    if !p.is_textured() {
        return plain(p, shader, o, start);
    }
    let textured = Textured::new(shader, &o.skips);
    let (frame, mut stats) = plain(p, &textured, o, start);
    textured.count(&mut stats.skipped);
    (frame, stats)
}

fn plain<S: Shader>(
    p: &Prepared,
    shader: &S,
    o: &RenderOptions,
    start: Instant,
) -> (Frame, RenderStats) {
    let ready = bands::ready(p, |i| shader.triangle(p, i));
    let bins = bands::bin(&ready, p.height);
    let setup_ns = nanoseconds(start);

    let start = Instant::now();
    let mut frame = Frame::new(p.width, p.height, p.background);
    let skip_hidden = o.skips.is_on(skips::HIDDEN);
    let skip_one_pixel = o.skips.is_on(skips::ONE_PIXEL);
    let tally = bands::each(&mut frame, &bins, |first_row, pixels, bin| {
        let mut band = scalar::Band {
            prepared: p,
            shader,
            first_row,
            pixels,
            skip_hidden,
            skip_one_pixel,
        };
        band.draw(bin, &ready)
    });
    (frame, stats(p, tally, setup_ns, nanoseconds(start)))
}

fn stats(p: &Prepared, tally: Tally, setup_ns: u64, raster_ns: u64) -> RenderStats {
    let mut skipped = p.skipped.clone();
    let counts = [
        (skips::HIDDEN, tally.hidden),
        (skips::TILES, tally.tiles),
        (skips::ONE_PIXEL, tally.one_pixel),
    ];
    skipped.extend(counts.into_iter().filter(|(_, n)| *n > 0));
    RenderStats {
        pixels_tested: tally.tested,
        pixels_shaded: tally.tested - tally.hidden,
        pixels_written: tally.written,
        skipped,
        setup_ns,
        raster_ns,
        threads: parallel::threads(),
    }
}

fn nanoseconds(since: Instant) -> u64 {
    u64::try_from(since.elapsed().as_nanos()).unwrap_or(u64::MAX)
}
