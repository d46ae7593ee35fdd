//! Lines for a core that is generated without a scene, and the one line of examples and diagrams.

use super::build::{Stimulus, StimulusError, StimulusOptions};
use super::lines::{build_lines, Line};
use super::sample::Draw;
use shadegate_hdl::line::Filter;
use shadegate_reference::line::cue::Ramp;
use shadegate_reference::line::wireframe::Stroke;
use shadegate_reference::line::{Path, Pixel};
use shadegate_reference::raster::Viewport;

/// Colour of the empty frame of samples.
const BACKGROUND: [u8; 3] = [16, 24, 40];

fn line(
    ends: [Pixel; 2],
    colour: [f64; 3],
    fade: f64,
    hidden: bool,
    label: String,
) -> Option<Line> {
    let path = Path::new(ends[0], ends[1])?;
    let visible = (0..=path.major).map(|x| !hidden || x % 16 < 9).collect();
    Some(Line {
        stroke: Stroke {
            path,
            colour,
            ramp: Ramp::new(1.0, fade, path.major),
            visible,
            edge: 0,
        },
        label,
    })
}

/// The writes of `count` lines in (and a little around) the frame: all octants, points, diagonals, ends on each other,
/// crossings, hidden pieces, depth cueing.
///
/// # Errors
/// When a line cannot be set up, which no valid frame causes.
pub fn sample_lines(
    filter: Filter,
    viewport: Viewport,
    count: usize,
    seed: u64,
) -> Result<Stimulus, StimulusError> {
    let mut draw = Draw(seed);
    let mut last = Pixel::default();
    let mut all = vec![];
    for i in 0..count {
        let mut end = || {
            let mut along =
                |size: u32| draw.below(u64::from(size) * 5 / 4 + 3) as i32 - size as i32 / 8;
            Pixel {
                x: along(viewport.width),
                y: along(viewport.height),
            }
        };
        let [mut from, mut to] = [end(), end()];
        match i % 8 {
            1 => to.y = from.y,
            2 => to.x = from.x,
            3 => to.y = from.y + to.x - from.x,
            4 => from = last,
            5 => to = from,
            _ => {}
        }
        last = to;
        let colour = std::array::from_fn(|_| draw.below(256) as f64);
        let fade = if i % 3 == 0 { 0.25 } else { 1.0 };
        all.extend(line(
            [from, to],
            colour,
            fade,
            i % 5 == 4,
            format!("sample {i}"),
        ));
    }
    build_lines(
        filter,
        &all,
        viewport,
        BACKGROUND,
        &StimulusOptions::default(),
    )
}

/// The writes of one fading line from the top left corner, as far as the frame and `reach` go.
///
/// # Errors
/// As [`sample_lines`].
pub fn single_line(
    filter: Filter,
    viewport: Viewport,
    reach: u32,
) -> Result<Stimulus, StimulusError> {
    let end = |size: u32, part: u32| (size.min(reach) / part).saturating_sub(1) as i32;
    let to = Pixel {
        x: end(viewport.width, 1),
        y: end(viewport.height, 2).max(0),
    };
    let one = line(
        [Pixel::default(), to],
        [255.0, 160.0, 48.0],
        0.5,
        false,
        "example".to_owned(),
    );
    let one: Vec<Line> = one.into_iter().collect();
    build_lines(
        filter,
        &one,
        viewport,
        BACKGROUND,
        &StimulusOptions::default(),
    )
}
