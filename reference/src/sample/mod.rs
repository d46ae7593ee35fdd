//! Frames from many samples: N × N in space, drawn as a frame N times as large and filtered down, and some in time, drawn
//! while the shutter is open and averaged (Loisel 1996, sections on antialiasing: supersampling and motion blur).
//!
//! All sums are of bytes with integer weights, rounded once at the end: a frame of one colour stays that colour, and one
//! sample is the frame itself.

pub mod filter;
mod motion;

pub use filter::Filter;

use crate::animation::Player;
use crate::antialias::{self, skips_for, Antialias};
use crate::geometry::Prepared;
use crate::method::Method;
use crate::parallel;
use crate::render::{render, Frame, RenderOptions, RenderStats};
use crate::scene::{Scene, SceneError, IMAGE_LIMIT};
use crate::skips;
use std::time::Instant;

/// The greatest N.
pub const SAMPLE_LIMIT: u32 = 16;

/// What is to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// Frame size, when it is not the scene's.
    pub size: Option<(u32, u32)>,
    /// The method.
    pub method: Method,
    /// N: samples in each direction of a pixel, 1 to [`SAMPLE_LIMIT`].
    pub samples: u32,
    /// How they are weighted.
    pub filter: Filter,
    /// How edges of polygons are anti-aliased; methods that have no such form are drawn without.
    pub antialias: Antialias,
    /// Threads and skips.
    pub options: RenderOptions,
}

/// A frame, and what drawing it took.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The frame.
    pub frame: Frame,
    /// The scene as prepared for the last sub-frame, at the size of its samples.
    pub prepared: Prepared,
    /// Sums over all sub-frames; pixels are samples.
    pub stats: RenderStats,
    /// Time for preparing, ns.
    pub prepare_ns: u64,
    /// Sub-frames drawn.
    pub subframes: u32,
}

impl Drawn {
    /// Takes the place of this one, with the work of both.
    pub fn follow(&mut self, next: Self) {
        let (a, b) = (&mut self.stats, next.stats);
        a.pixels_tested += b.pixels_tested;
        a.pixels_shaded += b.pixels_shaded;
        a.pixels_written += b.pixels_written;
        a.setup_ns += b.setup_ns;
        a.raster_ns += b.raster_ns;
        for (reason, n) in b.skipped {
            *a.skipped.entry(reason).or_default() += n;
        }
        self.prepare_ns += next.prepare_ns;
        self.subframes += next.subframes;
        self.prepared = next.prepared;
        self.frame = next.frame;
    }
}

/// Draws frame `number` of a scene, or its only one.
///
/// # Errors
/// A size of zero, or one that is beyond [`IMAGE_LIMIT`] together with the samples.
pub fn draw(player: &mut Player, number: u32, wanted: &Wanted) -> Result<Drawn, SceneError> {
    let scene = player.at(f64::from(number));
    let (width, height) = wanted
        .size
        .unwrap_or((scene.image.width, scene.image.height));
    let n = wanted.samples.clamp(1, SAMPLE_LIMIT);
    if width.max(height) > IMAGE_LIMIT / n {
        let what = format!("is {width}x{height} with {n} samples in each direction");
        let most = IMAGE_LIMIT / n;
        return Err(SceneError::new(
            &scene.file,
            1,
            "size",
            &what,
            &format!("expected at most {most}x{most} with so many"),
        ));
    }
    let large = (width * n, height * n);
    let all = times(scene, number);
    let still = wanted.options.skips.is_on(skips::BLUR)
        && all.len() > 1
        && motion::at_most(player, &all, large) < f64::from(n);
    let middle = [f64::from(number)];
    let used = if still { &middle[..] } else { &all[..] };
    let mut drawn = shot(player, used[0], large, n, wanted)?;
    if let [_, rest @ ..] = used {
        let mut sums = Sums::new(&drawn.frame);
        for time in rest {
            let next = shot(player, *time, large, n, wanted)?;
            sums.add(&next.frame);
            drawn.follow(next);
        }
        drawn.frame = sums.mean();
    }
    if still {
        let skipped = all.len() as u64 - 1;
        drawn.stats.skipped.insert(skips::BLUR, skipped);
    }
    Ok(drawn)
}

/// The times of a frame's sub-frames: in the middle of equal parts of the time that the shutter is open. At least one.
fn times(scene: &Scene, number: u32) -> Vec<f64> {
    let middle = f64::from(number);
    let Some(a) = &scene.animation else {
        return vec![middle];
    };
    let count = a.subframes.max(1);
    (0..count)
        .map(|k| middle + a.shutter * ((f64::from(k) + 0.5) / f64::from(count) - 0.5))
        .collect()
}

/// One sub-frame.
fn shot(
    player: &mut Player,
    time: f64,
    large: (u32, u32),
    n: u32,
    wanted: &Wanted,
) -> Result<Drawn, SceneError> {
    let skips = skips_for(wanted.antialias, wanted.options.skips);
    let (m, o) = (wanted.method, &wanted.options);
    let scene = player.at(time);
    // All in one, so that each thread finds what it has made itself.
    let (prepared, prepare_ns, frame, mut stats) = parallel::with(o.threads, || {
        let start = Instant::now();
        let prepared = Prepared::new(scene, Some(large), &skips)?;
        let prepare_ns = nanoseconds(start);
        let (frame, stats) = antialias::draw(&prepared, m, wanted.antialias, o)
            .unwrap_or_else(|_| render(&prepared, m, o));
        Ok::<_, SceneError>((prepared, prepare_ns, frame, stats))
    })?;
    let start = Instant::now();
    let frame = filter::down(frame, n, wanted.filter);
    stats.raster_ns += nanoseconds(start);
    Ok(Drawn {
        frame,
        prepared,
        stats,
        prepare_ns,
        subframes: 1,
    })
}

fn nanoseconds(since: Instant) -> u64 {
    u64::try_from(since.elapsed().as_nanos()).unwrap_or(u64::MAX)
}

/// Sums of frames, byte by byte.
struct Sums {
    size: (u32, u32),
    sums: Vec<[u32; 3]>,
    frames: u32,
}

impl Sums {
    fn new(frame: &Frame) -> Self {
        Self {
            size: (frame.width, frame.height),
            sums: frame.pixels.iter().map(|p| p.map(u32::from)).collect(),
            frames: 1,
        }
    }

    fn add(&mut self, frame: &Frame) {
        for (sum, p) in self.sums.iter_mut().zip(&frame.pixels) {
            for (s, v) in sum.iter_mut().zip(p) {
                *s += u32::from(*v);
            }
        }
        self.frames += 1;
    }

    /// The mean, rounded to nearest.
    fn mean(&self) -> Frame {
        let n = self.frames;
        let mean = |s: u32| ((s + n / 2) / n) as u8;
        Frame {
            width: self.size.0,
            height: self.size.1,
            pixels: self.sums.iter().map(|s| s.map(mean)).collect(),
        }
    }
}
