//! Register writes per line: the visible pieces of it that touch the frame.

use super::build::{Primitive, Stimulus, StimulusError, StimulusOptions};
use crate::setup::{cue_words, line_words, MAX_PIECE};
use shadegate_hdl::line::model::BACKGROUND;
use shadegate_hdl::line::walk::FRAME_SIZE;
use shadegate_hdl::line::Filter;
use shadegate_reference::line::wireframe::Stroke;
use shadegate_reference::raster::Viewport;
use std::collections::HashMap;

/// A line as a core sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its walk, its colour along the walk, and which of its columns are seen.
    pub stroke: Stroke,
    /// Where it comes from, for messages.
    pub label: String,
}

/// Whether some lane of a column may lie in the frame; lanes reach two pixels to either side.
fn touches(s: &Stroke, x: i32, frame: Viewport) -> bool {
    let row = i64::from(x) * i64::from(s.path.minor) / i64::from(s.path.major.max(1));
    let p = s.path.place(x, row as i32);
    let inside = |v: i32, size: u32, reach: i32| (-reach..size as i32 + reach).contains(&v);
    // The walk's row is this one or the next.
    if s.path.steep {
        inside(p.x, frame.width, 3) && inside(p.y, frame.height, 0)
    } else {
        inside(p.x, frame.width, 0) && inside(p.y, frame.height, 3)
    }
}

/// Runs of columns that are seen and touch the frame: first column, columns.
fn pieces(s: &Stroke, frame: Viewport) -> Vec<(i32, i32)> {
    let mut out: Vec<(i32, i32)> = vec![];
    for x in 0..=s.path.major {
        if s.visible.get(x as usize) != Some(&true) || !touches(s, x, frame) {
            continue;
        }
        match out.last_mut() {
            Some((first, columns)) if *first + *columns == x && *columns < MAX_PIECE => {
                *columns += 1;
            }
            _ => out.push((x, 1)),
        }
    }
    out
}

/// Sets up and quantises a list of lines for a frame, in drawing order.
///
/// # Errors
/// The first line that exceeds the core's error term.
pub fn build_lines(
    filter: Filter,
    lines: &[Line],
    viewport: Viewport,
    background: [u8; 3],
    options: &StimulusOptions,
) -> Result<Stimulus, StimulusError> {
    let mut out = Stimulus::default();
    let size = u64::from(viewport.height) << 12 | u64::from(viewport.width);
    out.frame.push((FRAME_SIZE as u8, size));
    if filter != Filter::Bresenham {
        let colour = background.iter().fold(0, |w, c| w << 8 | u64::from(*c));
        out.frame.push((BACKGROUND as u8, colour));
    }
    let mut held: HashMap<u8, u64> = HashMap::new();
    for (index, line) in lines.iter().enumerate() {
        let s = &line.stroke;
        let all = pieces(s, viewport);
        out.skipped_uncovered += u64::from(all.is_empty());
        for (first, columns) in all {
            let words = line_words(filter, &s.path, first, columns, viewport.width);
            let words = words.map_err(|what| StimulusError {
                primitive: "line",
                index,
                label: line.label.clone(),
                what,
            })?;
            let mut needed = |target: u8, data: u64| {
                let old = held.insert(target, data);
                let needed = !options.skip_unchanged || old != Some(data);
                out.skipped_unchanged += u64::from(!needed);
                needed
            };
            let mut writes: Vec<(u8, u64)> = (0u8..)
                .zip(words)
                .filter(|(word, data)| needed(*word, *data))
                .collect();
            let channels = s
                .colour
                .map(|c| cue_words(c * s.ramp.at(first), c * s.ramp.step));
            for word in 0..2u8 {
                let mut sent: Vec<(u8, u64)> = vec![];
                for (channel, words) in channels.iter().enumerate() {
                    let (mask, data) = (16u8 << channel, words[usize::from(word)]);
                    if !needed(mask | word, data) {
                        continue;
                    }
                    let same = sent.iter_mut().find(|s| options.broadcast && s.1 == data);
                    match same {
                        Some((masks, _)) => {
                            *masks |= mask;
                            out.skipped_broadcast += 1;
                        }
                        None => sent.push((mask | word, data)),
                    }
                }
                writes.extend(sent);
            }
            out.primitives.push(Primitive {
                triangle: index,
                writes,
            });
        }
    }
    Ok(out)
}
