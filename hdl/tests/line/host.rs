//! A host for line cores: register words from a path, and the model run over them.

use rand::rngs::StdRng;
use rand::Rng;
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs, Order};
use shadegate_reference::line::set_up::SetUp;
use shadegate_reference::line::{Path, Pixel};

/// Frame of the tests.
pub const SIZE: (u32, u32) = (96, 64);

/// The core for a frame.
pub fn core(filter: Filter, (width, height): (u32, u32)) -> Core {
    Core::for_frame(Order::Line(filter), width, height).unwrap()
}

/// The writes before the first line.
pub fn frame_words((width, height): (u32, u32), background: [u8; 3]) -> Vec<(u8, u64)> {
    let colour = background.iter().fold(0, |w, c| w << 8 | u64::from(*c));
    vec![
        (11, u64::from(height) << 12 | u64::from(width)),
        (12, colour),
    ]
}

fn bits(v: i64, width: u32) -> u64 {
    v as u64 & ((1 << width) - 1)
}

/// The words of a whole line in one colour; it must lie within the coordinates of the walk.
pub fn words(filter: Filter, path: &Path, width: u32, rgb: [u8; 3]) -> Vec<(u8, u64)> {
    let (dx, dy) = (i64::from(path.major), i64::from(path.minor));
    let first = path.place(0, 0);
    let s = SetUp::new(path);
    let lanes = match filter {
        Filter::Bresenham => 0,
        Filter::Box => 1,
        Filter::Cone if dx == 0 => 0,
        Filter::Cone if s.fourth => 3,
        Filter::Cone => 2,
    };
    let (major, minor) = if path.steep {
        (first.y, first.x)
    } else {
        (first.x, first.y)
    };
    let error = match filter {
        // Behind the first column, which never moves the minor coordinate.
        Filter::Bresenham | Filter::Cone => [2 * dy - dx, 2 * dy, 2 * (dy - dx)],
        Filter::Box if dx == 0 => [0; 3],
        Filter::Box => [dy - dx + 1, dy, dy - dx],
    };
    let address = i64::from(first.y) * i64::from(width) + i64::from(first.x);
    let mut w = vec![
        lanes << 13 | u64::from(path.falling) << 12 | u64::from(path.steep) << 11 | bits(dx, 11),
        bits(i64::from(minor), 12) << 12 | bits(i64::from(major), 12),
        bits(address, 32),
        bits(error[0], 32),
        bits(error[1], 32),
        bits(error[2], 32),
    ];
    match filter {
        Filter::Bresenham => {}
        Filter::Box => {
            let (whole, rest) = match dx {
                0 => (0, 0),
                _ => (255 * dy / dx, 255 * dy % dx),
            };
            w.push(bits(whole, 8) << 8);
            let h = [2 * rest - dx + 1, 2 * rest, 2 * (rest - dx)];
            w.extend(h.map(|v| bits(v, 32)));
        }
        Filter::Cone => {
            let q = |v: f64| bits((v * f64::from(1u32 << 30)).round() as i64, 32);
            w.extend([q(s.cosine), 0, q(s.distance_stay), q(s.distance_step)]);
        }
    }
    let mut writes: Vec<(u8, u64)> = (0..).zip(w).collect();
    for (channel, level) in rgb.into_iter().enumerate() {
        let mask = 16 << channel;
        writes.push((mask, u64::from(level) << 20 | 1 << 19));
        writes.push((mask | 1, 0));
    }
    writes
}

/// What a core says about a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    pub x: i32,
    pub y: i32,
    pub rgb: [u8; 3],
    pub level: u16,
}

impl Drawn {
    pub fn of(o: &CoreOutputs) -> Self {
        Self {
            x: i32::from(o.x),
            y: i32::from(o.y),
            rgb: o.rgb,
            level: o.depth,
        }
    }
}

/// Writes whenever it may, `start` with the last word of each line; returns the outputs of every clock until the device
/// is idle. `step` clocks the device and gives its outputs.
pub fn draw(
    lines: &[Vec<(u8, u64)>],
    frame: &[(u8, u64)],
    mut now: CoreOutputs,
    ready: impl Fn(usize) -> bool,
    mut step: impl FnMut(&CoreInputs) -> CoreOutputs,
) -> Vec<CoreOutputs> {
    let single = |w: &(u8, u64)| (w.0, w.1, false);
    let mut words: Vec<(u8, u64, bool)> = frame.iter().map(single).collect();
    for line in lines {
        words.extend(line.iter().map(single));
        words.last_mut().unwrap().2 = true;
    }
    let mut words = words.into_iter().peekable();
    let mut trace = vec![];
    loop {
        let mut i = CoreInputs {
            ready: ready(trace.len()),
            ..CoreInputs::default()
        };
        if now.load_ready {
            if let Some((select, data, start)) = words.next() {
                (i.write, i.select, i.data, i.start) = (true, select, data, start);
            }
        }
        trace.push(now);
        now = step(&i);
        if words.peek().is_none() && !now.busy && !i.start {
            trace.push(now);
            return trace;
        }
        assert!(trace.len() < 4_000_000, "the core never gets idle");
    }
}

/// The pixels taken in such a trace.
pub fn taken(trace: &[CoreOutputs], ready: impl Fn(usize) -> bool) -> Vec<Drawn> {
    let clocks = trace.iter().enumerate();
    clocks
        .filter(|(t, o)| o.valid && ready(*t))
        .map(|(_, o)| Drawn::of(o))
        .collect()
}

/// A line between random pixels in and a little around a frame.
pub fn random_path(r: &mut StdRng, (width, height): (u32, u32), beside: i32) -> Path {
    let mut pixel = || Pixel {
        x: r.random_range(-beside..width as i32 + beside),
        y: r.random_range(-beside..height as i32 + beside),
    };
    Path::new(pixel(), pixel()).unwrap()
}
