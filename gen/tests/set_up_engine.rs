//! The set-up engine against the host's exact set-up and an f64 oracle: edge words bit for bit, colours at every covered
//! pixel within the stated bound, on random, large, thin, mirrored and clipped triangles.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::setup::{shell_words, MAX_COLUMN, MIN_COLUMN};
use shadegate_gen::stimulus::{build, sample, StimulusOptions, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::set_up::{clocks, EngineInputs, EngineModel};
use shadegate_hdl::shade::device::{longest_run, Core};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{Point, Viewport, Walk, SUBPIXELS};
use std::collections::BTreeMap;

/// A triangle in the engine's own units: corners, depths in 1/64, six knots per channel in 1/1024.
#[derive(Clone, Debug)]
struct Raw {
    position: [Point; 3],
    depth: [i64; 3],
    knots: [[i64; 6]; 3],
}

/// The engine by itself, for a core that always takes words.
struct Bench {
    engine: EngineModel,
    size: Viewport,
}

impl Bench {
    fn new(core: &Core, size: Viewport) -> Self {
        let mut engine = EngineModel::new(core.fraction_bits(), core.bus_bits());
        for (word, data) in [(11, size.width), (12, size.height)] {
            engine.clock(&EngineInputs {
                frame: Some((word, u64::from(data))),
                ..EngineInputs::default()
            });
        }
        Self { engine, size }
    }

    /// The words of a triangle; `None` if it was skipped.
    fn words(&mut self, t: &Raw) -> Option<BTreeMap<u8, i64>> {
        let mut writes = vec![];
        for i in 0..3u8 {
            let k = usize::from(i);
            writes.push((i, t.position[k].x as u64));
            writes.push((4 + i, t.position[k].y as u64));
            writes.push((8 + i, t.depth[k] as u64));
            for (c, knots) in (0u8..).zip(&t.knots) {
                writes.push((16 + 8 * c + i, knots[k] as u64));
                writes.push((20 + 8 * c + i, knots[5 - k] as u64));
            }
        }
        let last = writes.len() - 1;
        let idle = EngineInputs {
            ready: true,
            ..EngineInputs::default()
        };
        for (k, write) in writes.into_iter().enumerate() {
            self.engine.clock(&EngineInputs {
                write: Some(write),
                start: k == last,
                ..idle
            });
        }
        let mut words = BTreeMap::new();
        for clock in 1.. {
            let o = self.engine.outputs();
            words.extend(o.word.map(|(select, data)| (select, data as i64)));
            self.engine.clock(&idle);
            if o.skip {
                return None;
            }
            if o.start {
                assert_eq!(clock, clocks(), "every triangle takes the same time");
                return Some(words);
            }
        }
        None
    }
}

/// Triangles that are thin, tall, level, tiny, large, and needles through pixel centres.
fn shape(r: &mut StdRng, kind: usize, size: Viewport) -> [Point; 3] {
    let (w, h) = (size.width as i32, size.height as i32);
    let guard = |v: i32| (v / 2).min(2040 - v.min(2040));
    let mut point = || Point {
        x: r.random_range(-guard(w) * SUBPIXELS..(w + guard(w)) * SUBPIXELS),
        y: r.random_range(-h / 2 * SUBPIXELS..(h + h / 2) * SUBPIXELS),
    };
    let mut p = [point(), point(), point()];
    let mut off = |at: Point, by: i32| Point {
        x: at.x + r.random_range(-by..=by),
        y: at.y + r.random_range(-by..=by),
    };
    match kind {
        1 => {
            p[1] = off(p[0], 2600);
            p[2] = off(p[0], 2600);
        }
        2..=4 => {
            // Beside a point of the first edge, by less than 1/64, 1/6 and 1½ pixels.
            let part = off(Point { x: 500, y: 0 }, 500).x;
            let along = |a: i32, b: i32| a + ((b - a) as i64 * i64::from(part) / 1000) as i32;
            let at = Point {
                x: along(p[0].x, p[1].x),
                y: along(p[0].y, p[1].y),
            };
            p[2] = off(at, [2, 40, 400][kind - 2]);
        }
        5 => {
            // Along a direction that meets pixel centres, begun at one.
            let centre = |v: i32| v.div_euclid(SUBPIXELS) * SUBPIXELS + SUBPIXELS / 2;
            let way = off(Point { x: 0, y: 0 }, 7);
            let long = off(Point { x: 20, y: 0 }, 19).x * SUBPIXELS;
            p[0] = Point {
                x: centre(p[0].x / 3),
                y: centre(p[0].y / 3),
            };
            let at = |k: i32| Point {
                x: p[0].x + way.x * k,
                y: p[0].y + way.y * k,
            };
            (p[1], p[2]) = (at(long), off(at(long / 2), 3));
        }
        6 => {
            for k in 1..3 {
                p[k].x = off(p[0], 300).x;
            }
        }
        7 => {
            for k in 1..3 {
                p[k].y = off(p[0], 300).y;
            }
        }
        _ => {}
    }
    for v in &mut p {
        v.x = v.x.clamp(MIN_COLUMN * SUBPIXELS, MAX_COLUMN * SUBPIXELS);
    }
    p
}

fn raw(r: &mut StdRng, kind: usize, size: Viewport, most: i64) -> Raw {
    let position = shape(r, kind, size);
    let extreme = r.random_bool(0.5);
    let mut knot = |most: i64| match extreme {
        true if r.random_bool(0.5) => most,
        true => 0,
        false => r.random_range(0..=most),
    };
    Raw {
        position,
        depth: [0; 3].map(|_| knot(65_535 * 64)),
        knots: [[0; 6]; 3].map(|k| k.map(|_| knot(most * 1024))),
    }
}

/// Barycentric weights of a pixel centre.
fn weights(p: [Point; 3], column: i32, row: i32) -> [f64; 3] {
    let at = Point {
        x: column * SUBPIXELS + SUBPIXELS / 2,
        y: row * SUBPIXELS + SUBPIXELS / 2,
    };
    let cross = |a: Point, b: Point, c: Point| {
        let d = |a: i32, b: i32| i128::from(a) - i128::from(b);
        (d(b.x, a.x) * d(c.y, a.y) - d(b.y, a.y) * d(c.x, a.x)) as f64
    };
    let area = cross(p[0], p[1], p[2]);
    [
        cross(at, p[1], p[2]) / area,
        cross(p[0], at, p[2]) / area,
        cross(p[0], p[1], at) / area,
    ]
}

/// The edge words as far as they are used equal those of the host.
fn edges_are_exact(words: &BTreeMap<u8, i64>, t: &Raw, walk: &Walk, width: u32) {
    let want = shell_words(t.position, walk, width).expect("in range");
    let unused = usize::from(walk.upper_rows == walk.rows) * 3;
    for (k, want) in want.iter().enumerate().take(11 - unused) {
        let bits = if k > 1 && k % 3 == 1 { 20 } else { 32 };
        let got = words[&(k as u8)] & ((1 << bits) - 1);
        assert_eq!(got as u64, *want, "word {k} of {t:?}");
    }
}

/// Largest error of a colour (LSB) and of a depth (depth words) at the covered pixels, before the core rounds them.
fn errors(words: &BTreeMap<u8, i64>, t: &Raw, walk: &Walk, core: &Core, width: u32) -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    let bits = core.fraction_bits() as u32;
    let of = |mask: u8, k: u8| i128::from(*words.get(&(mask | k)).unwrap_or(&0));
    for (y, from, to) in walk.walk_spans() {
        let k = i128::from(y - walk.first_row);
        // Long spans at some of their pixels.
        let step = 1 + (to - from).max(0) as usize / 40;
        for c in (from..to).step_by(step) {
            let x = if walk.mirrored { !c } else { c };
            if !(0..width as i32).contains(&x) {
                continue;
            }
            let i =
                i128::from(c) - i128::from(walk.major.column) - i128::from(walk.major.whole) * k;
            let at = |mask: u8, width: u32| {
                let sum = of(mask, 0)
                    + i * of(mask, 1)
                    + k * of(mask, 2)
                    + i * (i - 1) / 2 * of(mask, 4)
                    + i * k * of(mask, 5)
                    + k * (k - 1) / 2 * of(mask, 7);
                (sum << (128 - width)) >> (128 - width)
            };
            let [s, u, v] = weights(t.position, x, y);
            for (channel, knots) in t.knots.iter().enumerate() {
                let [k0, k1, k2, k01, k02, k12] = knots.map(|k| k as f64 / 1024.0);
                let exact = k0 * s * (2.0 * s - 1.0)
                    + k1 * u * (2.0 * u - 1.0)
                    + k2 * v * (2.0 * v - 1.0)
                    + 4.0 * (k01 * s * u + k02 * s * v + k12 * u * v);
                let got = at(16 << channel, 12 + bits) as f64 / 2f64.powi(bits as i32) - 0.5;
                worst[0] = worst[0].max((got - exact).abs());
            }
            let [z0, z1, z2] = t.depth.map(|z| z as f64 / 64.0);
            let got = at(0x80, 32) as f64 / 65_536.0 + 32_768.0 - 0.5;
            worst[1] = worst[1].max((got - (z0 * s + z1 * u + z2 * v)).abs());
        }
    }
    worst
}

/// Runs triangles; returns the largest errors.
fn sweep(size: (u32, u32), most: i64, count: usize, seed: u64) -> [f64; 2] {
    let core = Core::for_frame(Order::QuadraticEngine, size.0, size.1).expect("in range");
    let size = Viewport {
        width: size.0,
        height: size.1,
    };
    let bound = core.error_bound(longest_run(size.width, size.height).expect("in range"));
    assert!(bound < 1.0, "{bound}");
    let mut bench = Bench::new(&core, size);
    let mut r = StdRng::seed_from_u64(seed);
    let (mut worst, mut skipped) = ([0.0f64; 2], 0);
    for n in 0..count {
        let t = raw(&mut r, n % 8, size, most);
        let words = bench.words(&t);
        let Some(walk) = Walk::new(t.position, bench.size) else {
            assert!(words.is_none(), "{t:?}");
            skipped += 1;
            continue;
        };
        let words = words.unwrap_or_else(|| panic!("skipped: {t:?}"));
        edges_are_exact(&words, &t, &walk, size.width);
        let e = errors(&words, &t, &walk, &core, size.width);
        assert!(e[0] <= bound && e[1] <= 0.1, "{e:?} of {bound}: {t:?}");
        worst = [worst[0].max(e[0]), worst[1].max(e[1])];
    }
    assert_eq!(usize::from(bench.engine.skipped), skipped);
    assert!(skipped > count / 100, "{skipped}");
    println!("{size:?} knots to {most}: {worst:?} of {bound}, {skipped} skipped");
    worst
}

#[test]
fn colours_are_within_the_bound() {
    let worst = [
        sweep((320, 240), 255, 1600, 1),
        sweep((320, 240), 1530, 1600, 2),
        sweep((2040, 1024), 1530, 500, 3),
        sweep((60, 1024), 255, 300, 4),
    ];
    // The bound is for the longest walk; what was found is a good part of it.
    assert!(worst[0][0] > 0.03 && worst[1][0] > 0.04, "{worst:?}");
}

/// A unit more in the second difference is seen: the comparison is not blind.
#[test]
fn a_wrong_word_is_found() {
    let size = Viewport {
        width: 320,
        height: 240,
    };
    let core = Core::for_frame(Order::QuadraticEngine, 320, 240).expect("in range");
    let point = |x, y| Point { x, y };
    let t = Raw {
        position: [point(0, 0), point(81_000, 100), point(40_000, 61_000)],
        depth: [0, 64, 128],
        knots: [[1024, 200_000, 90_000, 30_000, 0, 261_120]; 3],
    };
    let walk = Walk::new(t.position, size).expect("covers");
    let mut words = Bench::new(&core, size).words(&t).expect("drawn");
    let right = errors(&words, &t, &walk, &core, 320)[0];
    for (select, by) in [(0x14, 16), (0x25, 32), (0x41, 4096), (0x17, 64)] {
        *words.entry(select).or_default() += by;
        let wrong = errors(&words, &t, &walk, &core, 320)[0];
        assert!(right < 0.1 && wrong > 0.3, "{select:x}: {right} {wrong}");
        *words.entry(select).or_default() -= by;
    }
}

fn large(knot: f64) -> Triangle {
    let point = |x, y| Point {
        x: x * SUBPIXELS,
        y: y * SUBPIXELS,
    };
    Triangle {
        position: [point(0, 0), point(60, 0), point(0, 40)],
        depth: [40_000.0 + knot; 3],
        knots: vec![[knot, 255.0 - knot, 128.0]; 6],
        material: None,
        covering: None,
        relief: None,
        label: "large".to_owned(),
    }
}

/// The next triangle is set up while one is drawn: only the first one waits for the engine.
#[test]
fn set_up_and_drawing_overlap() {
    let core = Core::for_frame(Order::QuadraticEngine, 64, 48).expect("in range");
    let viewport = Viewport {
        width: 64,
        height: 48,
    };
    let triangles: Vec<Triangle> = (0..5).map(|k| large(f64::from(k) * 40.0)).collect();
    let stimulus = build(&core, &triangles, viewport, &StimulusOptions::default()).expect("fits");
    let trace = Trace::record(core, &stimulus, |_| true);
    let (pixels, wait) = (trace.pixels.len() as u64, u64::from(core.latency()));
    assert_eq!(pixels, 5 * 1200);
    assert!(
        wait < 500 && trace.cycles < pixels + wait + 40,
        "{} {wait}",
        trace.cycles
    );
    let first = trace
        .clocks
        .iter()
        .position(|c| c.inputs.start)
        .expect("started");
    let pixel = trace.pixels[0].clock;
    // The pixel is shown by one edge and taken by the next.
    assert_eq!((pixel + 1 - first) as u32, core.latency());
}

/// Back pressure and pauses change no pixel.
#[test]
fn any_pattern_of_ready_gives_the_same_frame() {
    let core = Core::for_frame(Order::QuadraticEngine, 64, 48).expect("in range");
    let viewport = Viewport {
        width: 64,
        height: 48,
    };
    let stimulus = sample(&core, viewport, 40, 7).expect("fits");
    let pixels = |ready: &mut dyn FnMut(u64) -> bool| -> Vec<_> {
        let trace = Trace::record(core, &stimulus, ready);
        let all = trace.pixels.iter();
        all.map(|p| (p.x, p.y, p.rgb, p.depth, p.triangle))
            .collect()
    };
    let free = pixels(&mut |_| true);
    assert!(free.len() > 1000, "{}", free.len());
    for seed in 0..3 {
        let mut r = StdRng::seed_from_u64(seed);
        assert_eq!(pixels(&mut |_| r.random_bool(0.3)), free);
    }
    // Long pauses: the engine waits for the core.
    assert_eq!(pixels(&mut |clock| clock / 2000 % 2 == 1), free);
}
