//! Register writes of a frame of spans.

use super::surface::Surface;
use super::tables::Palette;
use super::words::{signed, Terms};
use super::{blake, slerp, spherical, trapezium};
use crate::stimulus::{Primitive, Stimulus, StimulusError, StimulusOptions, Triangle};
use shadegate_hdl::raster::span_shell;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_hdl::shade::{DEPTH_BIAS, DEPTH_FRACTION_BITS};
use shadegate_reference::raster::{Span, Viewport, Walk};
use shadegate_reference::shade::barycentric::{steps, weights};
use shadegate_reference::shade::circular::Ends;
use shadegate_reference::shade::curve::Pieces;
use shadegate_reference::shade::ends::slerped::arcs;
use shadegate_reference::shade::ends::{Blended, Slerped};
use std::collections::HashMap;

/// Target bits of a select code.
const DIFFUSE: u8 = 0x10;
const HIGHLIGHT: u8 = 0x20;
const DEPTH: u8 = 0x80;

struct Writer<'a> {
    options: &'a StimulusOptions,
    /// Last word written, by select code of a single target.
    held: HashMap<u8, u64>,
    /// Row of the words in the shell.
    row: Option<u64>,
    out: Stimulus,
}

impl Writer<'_> {
    /// Whether this word must be sent to this single target.
    fn needed(&mut self, target: u8, data: u64) -> bool {
        let old = self.held.insert(target, data);
        let needed = !self.options.skip_unchanged || old != Some(data);
        self.out.skipped_unchanged += u64::from(!needed);
        needed
    }

    fn one(&mut self, target: u8, data: u64, writes: &mut Vec<(u8, u64)>) {
        if self.needed(target, data) {
            writes.push((target, data));
        }
    }

    /// Words of the shell: where a part of a span lies. The row after that of the last span needs no word of its own.
    fn place(&mut self, (row, column): (u64, u64), pixels: u32, width: u32) -> Vec<(u8, u64)> {
        let mut writes = vec![];
        let follows = self.row.is_some_and(|old| old + 1 == row);
        let steps = follows && self.options.skip_unchanged;
        if !steps && (self.row != Some(row) || !self.options.skip_unchanged) {
            let address = row * u64::from(width);
            writes.push((span_shell::ROW as u8, row << 21 | address));
        } else {
            self.out.skipped_unchanged += 1;
        }
        self.row = Some(row);
        let place = u64::from(pixels) << 21 | column << 10 | u64::from(steps);
        writes.push((span_shell::PLACE as u8, place));
        writes
    }

    /// Words of both terms, equal ones together.
    fn terms(&mut self, t: &Terms, writes: &mut Vec<(u8, u64)>) {
        for (word, (d, h)) in (0u8..).zip(t.diffuse.into_iter().zip(t.highlight)) {
            let diffuse = self.needed(DIFFUSE | word, d);
            let highlight = self.needed(HIGHLIGHT | word, h);
            if diffuse && highlight && d == h && self.options.broadcast {
                writes.push((DIFFUSE | HIGHLIGHT | word, d));
                self.out.skipped_broadcast += 1;
                continue;
            }
            if diffuse {
                writes.push((DIFFUSE | word, d));
            }
            if highlight {
                writes.push((HIGHLIGHT | word, h));
            }
        }
    }
}

/// The parts of a span with the words of their terms.
fn parts(kind: SpanKind, s: &Surface, span: Span) -> Result<Vec<Terms>, String> {
    let (t, c) = (&s.triangle, &s.corners);
    let pixels = (span.end - span.start) as u32;
    let sweeps = match kind {
        SpanKind::Slerp | SpanKind::Chebyshev => Blended.sweeps(t, c, &(), span).first().copied(),
        SpanKind::BlakeTrapezium => trapezium::sweeps(s, span),
        _ => Slerped
            .sweeps(t, c, &arcs(&c.normal), span)
            .first()
            .copied(),
    };
    let both = sweeps.as_ref();
    let terms = [both.map(|b| &b.0), both.and_then(|b| b.1.as_ref())];
    Ok(match kind {
        SpanKind::Slerp => vec![slerp::terms(terms, pixels)],
        SpanKind::Chebyshev => vec![slerp::chebyshev_terms(terms, pixels)],
        SpanKind::Spherical(bits) | SpanKind::SphericalPower(bits) => {
            vec![spherical::terms(kind, bits, terms, c.shininess, pixels)?]
        }
        SpanKind::Blake | SpanKind::BlakeTrapezium => {
            blake::terms(Pieces::printed, terms, c.shininess, pixels)
        }
        SpanKind::BlakeRefit => blake::terms(Pieces::refit, terms, c.shininess, pixels),
    })
}

/// Depth at the first pixel of a span, half a word added, and its step.
fn depth_words(t: &Triangle, span: Span) -> Result<[u64; 2], String> {
    if let Some(d) = t.depth.iter().find(|d| !(0.0..=65535.0).contains(*d)) {
        return Err(format!("depth {d} is outside 0 to 65535"));
    }
    let blend = |w: [f64; 3]| w.iter().zip(t.depth).map(|(w, d)| w * d).sum::<f64>();
    let value = blend(weights(&t.position, span.start, span.y)) - DEPTH_BIAS as f64 + 0.5;
    let step = blend(steps(&t.position));
    let fraction = DEPTH_FRACTION_BITS as u32;
    let code = (step * 2f64.powi(fraction as i32)).round();
    // A span of one pixel may have any step, and a residue of it serves.
    let step = code.clamp(-9e18, 9e18) as i64 as u64 & 0xffff_ffff;
    // Rounding may carry a value at the end of the range beyond it; the registers' last code is as good.
    let value = value.clamp(-32_768.0, 32_767.999_98);
    Ok([signed("depth", value, fraction, 32)?, step])
}

/// Sets up and quantises a list of triangles, span by span.
///
/// # Errors
/// The first triangle that exceeds the core's coordinates, formats or palette; nothing wraps.
pub fn build(
    kind: SpanKind,
    triangles: &[Triangle],
    viewport: Viewport,
    options: &StimulusOptions,
) -> Result<Stimulus, StimulusError> {
    let mut w = Writer {
        options,
        held: HashMap::new(),
        row: None,
        out: Stimulus::default(),
    };
    let mut palette = Palette::default();
    let mut drawn = vec![];
    for (index, t) in triangles.iter().enumerate() {
        let walk = Walk::new(t.position, viewport);
        let Some(walk) = walk.filter(|walk| walk.spans(viewport.width).next().is_some()) else {
            w.out.skipped_uncovered += 1;
            continue;
        };
        let surface = Surface::new(t).and_then(|s| palette.add(kind, &s).map(|()| s));
        let surface = surface.map_err(|what| error(index, t, what))?;
        drawn.push((index, t, walk, surface));
    }
    w.out.frame = palette.writes(kind);
    let columns = u64::from(viewport.width);
    w.out.frame.push((span_shell::COLUMNS as u8, columns));
    for (index, t, walk, surface) in &drawn {
        let (material, shift) = palette.place(surface);
        for span in walk.spans(viewport.width) {
            let set_up = parts(kind, surface, span).and_then(|p| Ok((p, depth_words(t, span)?)));
            let (parts, [depth, step]) = set_up.map_err(|what| error(*index, t, what))?;
            for part in parts {
                let column = span.start as u64 + u64::from(part.first);
                let moved = depth.wrapping_add(step.wrapping_mul(u64::from(part.first)));
                let at = (span.y as u64, column);
                let mut writes = w.place(at, part.pixels, viewport.width);
                w.one(span_shell::STYLE as u8, shift << 2 | material, &mut writes);
                w.one(DEPTH, moved & 0xffff_ffff, &mut writes);
                w.one(DEPTH | 1, step, &mut writes);
                w.terms(&part, &mut writes);
                w.out.primitives.push(Primitive {
                    triangle: *index,
                    writes,
                });
            }
        }
    }
    Ok(w.out)
}

fn error(index: usize, t: &Triangle, what: String) -> StimulusError {
    StimulusError {
        primitive: "triangle",
        index,
        label: t.label.clone(),
        what,
    }
}
