//! Register writes per triangle, and what need not be written.

use super::bump::Relief;
use super::material::Material;
use super::picture::Pictures;
use super::raw::{raw_words, FRAME_ROWS};
use super::texture::Covering;
use crate::scene::DepthFormat;
use crate::setup::{fixed_knot, plane_words, quadric_words, shell_words, Frame};
use shadegate_hdl::raster::shell::FRAME_WIDTH;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::{DEPTH_BIAS, DEPTH_FRACTION_BITS};
use shadegate_reference::raster::{Point, Viewport, Walk};

/// A triangle as a core sees it: snapped corners, depth words at the corners, colour knots.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    /// Corners in 1/256 pixel.
    pub position: [Point; 3],
    /// Depth at the corners, in depth words (0 to 65535, larger is nearer), not rounded.
    pub depth: [f64; 3],
    /// RGB knots in LSB: three for the Gouraud core, six (vertices, then mid-edges 01, 02, 12) for the quadratic core.
    /// For the quadratic-dots cores six of N·L, N·H and the cosine from the axis of a spot; for the Duff core six of N·L, N·H and |N|² of normals that are not
    /// normalised; for the bump cores six of the light and six
    /// of the half-way vector along both tangents and the normal; for span cores the rows of a [`crate::spans::Surface`].
    pub knots: Vec<[f64; 3]>,
    /// What cores take that shade per pixel, and others ignore.
    pub material: Option<Material>,
    /// The picture that multiplies its colour, for textured cores; others ignore it.
    pub covering: Option<Covering>,
    /// The map that bends its normals, for bump cores; others ignore it.
    pub relief: Option<Relief>,
    /// Where it comes from, for messages.
    pub label: String,
}

/// What to leave out, what depths measure, and how wide the load port is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StimulusOptions {
    /// Do not send a word that the register already holds.
    pub skip_unchanged: bool,
    /// Send equal words of several channels in one write.
    pub broadcast: bool,
    /// Register words per clock of the core, 1, 2 or 4, where they are not the usual ones.
    pub load_words: Option<usize>,
    /// What the depth words of a scene are linear in.
    pub depth: DepthFormat,
}

impl Default for StimulusOptions {
    fn default() -> Self {
        Self {
            skip_unchanged: true,
            broadcast: true,
            load_words: None,
            depth: DepthFormat::default(),
        }
    }
}

/// The writes of one triangle, or of one piece of a line; the last one carries `start`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Primitive {
    /// Index in the list of triangles or lines.
    pub triangle: usize,
    /// (select, data) in order.
    pub writes: Vec<(u8, u64)>,
}

/// Everything a host writes to draw a frame.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stimulus {
    /// Writes before the first triangle.
    pub frame: Vec<(u8, u64)>,
    /// Triangles in drawing order.
    pub primitives: Vec<Primitive>,
    /// Words not sent because the register held them.
    pub skipped_unchanged: u64,
    /// Words not sent because another channel's write carried them.
    pub skipped_broadcast: u64,
    /// Words not sent because the triangle has no highlight or no light.
    pub skipped_dark: u64,
    /// Triangles not sent because they cover no pixel of the frame.
    pub skipped_uncovered: u64,
}

/// A triangle or line that the core cannot draw.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{primitive} {index} ({label}): {what}")]
pub struct StimulusError {
    /// `triangle` or `line`.
    pub primitive: &'static str,
    /// Index in the list.
    pub index: usize,
    /// Where it comes from.
    pub label: String,
    /// Why.
    pub what: String,
}

pub(super) struct Writer<'a> {
    options: &'a StimulusOptions,
    /// Last word written, by select code of a single target.
    held: std::collections::HashMap<u8, u64>,
    /// What is sent so far.
    pub(super) out: Stimulus,
}

impl Writer<'_> {
    /// Whether this word must be sent to this single target.
    pub(super) fn needed(&mut self, target: u8, data: u64) -> bool {
        let old = self.held.insert(target, data);
        let needed = !self.options.skip_unchanged || old != Some(data);
        self.out.skipped_unchanged += u64::from(!needed);
        needed
    }

    /// Whether words are left out at all.
    pub(super) fn leaves_out(&self) -> bool {
        self.options.skip_unchanged
    }

    /// Counts words of cosines that a triangle does without.
    pub(super) fn dark(&mut self, words: u64) {
        self.out.skipped_dark += words;
    }

    /// The words of a target from its first one on, as far as they are needed.
    pub(super) fn words(
        &mut self,
        target: u8,
        words: impl IntoIterator<Item = u64>,
        writes: &mut Vec<(u8, u64)>,
    ) {
        for (word, data) in (0u8..).zip(words) {
            if self.needed(target | word, data) {
                writes.push((target | word, data));
            }
        }
    }

    /// Words of the three colour channels, equal ones together.
    pub(super) fn colours<const W: usize>(
        &mut self,
        channels: &[[u64; W]; 3],
        writes: &mut Vec<(u8, u64)>,
    ) {
        for word in 0..W {
            let mut sent: Vec<(u8, u64)> = vec![];
            for (channel, words) in channels.iter().enumerate() {
                let mask = 1u8 << (4 + channel);
                if !self.needed(mask | word as u8, words[word]) {
                    continue;
                }
                let same = sent
                    .iter_mut()
                    .find(|(_, data)| self.options.broadcast && *data == words[word]);
                if let Some((masks, _)) = same {
                    *masks |= mask;
                    self.out.skipped_broadcast += 1;
                } else {
                    sent.push((mask, words[word]));
                }
            }
            writes.extend(
                sent.into_iter()
                    .map(|(masks, data)| (masks | word as u8, data)),
            );
        }
    }
}

fn knots<const K: usize>(t: &Triangle, channel: usize) -> Result<[i128; K], String> {
    fixed_colours(t, channel, 1530.0, |k| k)
}

/// Knots of a channel, from 0 to `brightest`, each mapped.
pub(super) fn fixed_colours<const K: usize>(
    t: &Triangle,
    channel: usize,
    brightest: f64,
    map: impl Fn(f64) -> f64,
) -> Result<[i128; K], String> {
    if t.knots.len() != K {
        return Err(format!(
            "{} colour knots where the core takes {K}",
            t.knots.len()
        ));
    }
    let mut out = [0; K];
    for (to, knot) in out.iter_mut().zip(&t.knots) {
        let value = knot[channel];
        *to = fixed_knot(map(value))
            .filter(|_| (0.0..=brightest).contains(&value))
            .ok_or_else(|| format!("colour knot {value} is outside 0 to {brightest}"))?;
    }
    Ok(out)
}

/// Depth words are walked less their bias, with half a word for rounding.
fn depth_words(t: &Triangle, frame: &Frame) -> Result<[u64; 4], String> {
    let mut k = [0; 3];
    for (to, d) in k.iter_mut().zip(t.depth) {
        *to = fixed_knot(d - DEPTH_BIAS as f64)
            .filter(|_| (0.0..=65535.0).contains(&d))
            .ok_or_else(|| format!("depth {d} is outside 0 to 65535"))?;
    }
    let fraction = DEPTH_FRACTION_BITS as u32;
    let half = 1 << (fraction - 1);
    Ok(plane_words(frame, k, fraction, 32, half))
}

fn channel_words(
    core: &Core,
    t: &Triangle,
    walk: &Walk,
    pictures: &Pictures,
    w: &mut Writer,
    writes: &mut Vec<(u8, u64)>,
) -> Result<(), String> {
    let frame = Frame::new(t.position, walk);
    let fraction = core.fraction_bits() as u32;
    let (width, half) = (12 + fraction, 1i128 << (fraction - 1));
    match core.order {
        Order::Linear => {
            let mut c = [[0; 4]; 3];
            for (channel, words) in c.iter_mut().enumerate() {
                *words = plane_words(&frame, knots(t, channel)?, fraction, width, half);
            }
            w.colours(&c, writes);
        }
        Order::Quadratic => {
            let mut c = [[0; 10]; 3];
            for (channel, words) in c.iter_mut().enumerate() {
                *words = quadric_words(&frame, knots(t, channel)?, fraction, width, half);
            }
            w.colours(&c, writes);
        }
        Order::QuadraticDots => w.dots(core, t, &frame, writes)?,
        Order::Duff => w.duff(core, t, &frame, writes)?,
        Order::Bump(_) => w.bump(core, t, &frame, writes)?,
        Order::Glint(glint) => w.glint(core, glint, t, &frame, writes)?,
        // Corners and knots instead of words: see `build`.
        Order::QuadraticEngine => {}
        Order::Line(_) => return Err("a line core draws no triangles".to_owned()),
        Order::Textured(texturing) => w.textured((core, texturing), t, &frame, pictures, writes)?,
        // Built span by span: see `build`.
        Order::Span(_) => {}
    }
    for (word, data) in depth_words(t, &frame)?.into_iter().enumerate() {
        let target = 0x80 | word as u8;
        if w.needed(target, data) {
            writes.push((target, data));
        }
    }
    Ok(())
}

/// Sets up and quantises a list of triangles for a frame.
///
/// # Errors
/// The first triangle that exceeds the core's coordinates or formats; nothing is clamped or wrapped.
pub fn build(
    core: &Core,
    triangles: &[Triangle],
    viewport: Viewport,
    options: &StimulusOptions,
) -> Result<Stimulus, StimulusError> {
    if let Order::Span(kind) = core.order {
        return crate::spans::build(kind, triangles, viewport, options);
    }
    let mut w = Writer {
        options,
        held: Default::default(),
        out: Stimulus::default(),
    };
    w.out
        .frame
        .push((FRAME_WIDTH as u8, u64::from(viewport.width)));
    let mut pictures = Pictures::default();
    if let Order::Textured(texturing) = core.order {
        pictures = Pictures::new(triangles);
        let error = |what| StimulusError {
            primitive: "triangle",
            index: 0,
            label: triangles.first().map_or(String::new(), |t| t.label.clone()),
            what,
        };
        let texels = pictures.writes(texturing).map_err(error)?;
        w.out.frame.extend(texels);
    }
    let engine = core.order == Order::QuadraticEngine;
    if engine {
        let rows = u64::from(viewport.height);
        w.out.frame.push((FRAME_ROWS, rows));
    }
    for (index, t) in triangles.iter().enumerate() {
        let Some(walk) = Walk::new(t.position, viewport)
            .filter(|walk| walk.spans(viewport.width).next().is_some())
        else {
            w.out.skipped_uncovered += 1;
            continue;
        };
        let mut writes = vec![];
        let error = |what| StimulusError {
            primitive: "triangle",
            index,
            label: t.label.clone(),
            what,
        };
        if engine {
            w.out.primitives.push(Primitive {
                triangle: index,
                writes: raw_words(t, &walk, viewport).map_err(error)?,
            });
            continue;
        }
        let shell = shell_words(t.position, &walk, viewport.width).map_err(error)?;
        w.words(0, shell, &mut writes);
        channel_words(core, t, &walk, &pictures, &mut w, &mut writes).map_err(error)?;
        w.out.primitives.push(Primitive {
            triangle: index,
            writes,
        });
    }
    Ok(w.out)
}
