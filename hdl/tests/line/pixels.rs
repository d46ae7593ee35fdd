//! What the cores draw is what the software renderer draws, pixel for pixel and level for level: in all octants, in both
//! directions, from points to lines of a thousand columns, blended over each other.

use super::host::{core, draw, frame_words, random_path, taken, words, Drawn, SIZE};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::line::Filter;
use shadegate_hdl::shade::device::CoreSimulator;
use shadegate_hdl::shade::model::CoreInputs;
use shadegate_reference::line::blend::blend;
use shadegate_reference::line::coverage::Table;
use shadegate_reference::line::fixed::{Form, Words};
use shadegate_reference::line::set_up::SetUp;
use shadegate_reference::line::{box_filter, bresenham, cone, Path, Pixel};

type Lines = Vec<(Path, [u8; 3])>;

/// Pixels and levels of the software's integer forms: the box filter's from exact fractions, the cone's by
/// [`Words`] with 30 fraction bits.
fn exact(filter: Filter, path: &Path) -> Vec<(Pixel, u16)> {
    match filter {
        Filter::Bresenham => bresenham::pixels(path).map(|p| (p, 255)).collect(),
        Filter::Box => {
            let (dx, dy) = (i64::from(path.major.max(1)), i64::from(path.minor));
            // Halves up, of both shares.
            let level = |n: i64| ((510 * n + dx) / (2 * dx)) as u16;
            let column = |x: i32| {
                let n = i64::from(x) * dy;
                let (y, rest) = ((n / dx) as i32, n % dx);
                [(y, level(dx - rest)), (y + 1, level(rest))].map(|(y, l)| (path.place(x, y), l))
            };
            let all = (0..=path.major).flat_map(column);
            all.filter(|(_, level)| *level > 0).collect()
        }
        Filter::Cone => {
            let words = Words::new(&SetUp::new(path), 30, Form::Increments);
            words.pixels(path, &Table::new(8, 255)).collect()
        }
    }
}

/// The same by the renderer's f64.
fn real(filter: Filter, path: &Path) -> Vec<(Pixel, u16)> {
    let table = Table::new(8, 255);
    let all: Vec<(Pixel, u16)> = match filter {
        Filter::Bresenham => bresenham::pixels(path).map(|p| (p, 255)).collect(),
        Filter::Box => box_filter::pixels(path)
            .map(|(p, w)| (p, (w * 255.0).round() as u16))
            .collect(),
        Filter::Cone => cone::pixels(path, cone::Fourth::NearDiagonal)
            .map(|(p, d)| (p, table.level(d)))
            .collect(),
    };
    all.into_iter().filter(|(_, level)| *level > 0).collect()
}

/// Lines over a background, the pixels in the order in which they are written.
fn expected(filter: Filter, lines: &Lines, (w, h): (u32, u32), background: [u8; 3]) -> Vec<Drawn> {
    let mut frame = vec![background; (w * h) as usize];
    let mut out = vec![];
    for (path, rgb) in lines {
        for (p, level) in exact(filter, path) {
            if (0..w as i32).contains(&p.x) && (0..h as i32).contains(&p.y) {
                let at = &mut frame[p.y as usize * w as usize + p.x as usize];
                *at = blend(*at, *rgb, level, 255);
                out.push(Drawn {
                    x: p.x,
                    y: p.y,
                    rgb: *at,
                    level,
                });
            }
        }
    }
    out
}

fn check(filter: Filter, lines: &Lines, size: (u32, u32)) {
    let background = [8, 200, 16];
    let core = core(filter, size);
    let writes: Vec<_> = lines
        .iter()
        .map(|(path, rgb)| words(filter, path, size.0, *rgb))
        .collect();
    let mut m = core.model();
    let start = m.outputs();
    let trace = draw(
        &writes,
        &frame_words(size, background),
        start,
        |_| true,
        |i| {
            m.clock(i);
            m.outputs()
        },
    );
    let got = taken(&trace, |_| true);
    let want = expected(filter, lines, size, background);
    let first = got.iter().zip(&want).position(|(a, b)| a != b);
    assert_eq!(first.map(|i| (got[i], want[i])), None, "{filter:?}");
    assert_eq!(got.len(), want.len(), "{filter:?}");
}

#[test]
fn random_lines_blended_over_each_other() {
    for (seed, filter) in (1..).zip(Filter::ALL) {
        let mut r = StdRng::seed_from_u64(seed);
        let lines: Lines = (0..600)
            .map(|_| (random_path(&mut r, SIZE, 30), r.random()))
            .collect();
        check(filter, &lines, SIZE);
    }
}

#[test]
fn every_octant_points_and_both_directions() {
    for filter in Filter::ALL {
        let mut lines = Lines::new();
        for dx in -9..=9 {
            for dy in -9..=9 {
                let p = |x, y| Pixel { x, y };
                let (a, b) = (p(40, 30), p(40 + dx, 30 + dy));
                let there = Path::new(a, b).unwrap();
                assert_eq!(
                    words(filter, &there, 96, [9; 3]),
                    words(filter, &Path::new(b, a).unwrap(), 96, [9; 3])
                );
                lines.push((there, [250, 120, 5]));
            }
        }
        check(filter, &lines, SIZE);
    }
}

#[test]
fn long_lines_do_not_drift() {
    let size = (1500, 1020);
    for filter in Filter::ALL {
        let mut r = StdRng::seed_from_u64(9);
        let mut lines: Lines = (0..12)
            .map(|_| (random_path(&mut r, size, 0), r.random()))
            .collect();
        for (a, b) in [
            ((0, 0), (1499, 1019)),
            ((1499, 3), (0, 4)),
            ((7, 1019), (8, 0)),
        ] {
            let p = |(x, y)| Pixel { x, y };
            lines.push((Path::new(p(a), p(b)).unwrap(), [255, 0, 128]));
        }
        check(filter, &lines, size);
    }
}

/// The description itself, for fewer lines: [`super::cores`] shows that it is the model.
#[test]
fn the_description_draws_them_too() {
    for filter in Filter::ALL {
        let mut r = StdRng::seed_from_u64(17);
        let lines: Lines = (0..40)
            .map(|_| (random_path(&mut r, SIZE, 4), r.random()))
            .collect();
        let mut s = CoreSimulator::new(core(filter, SIZE)).unwrap();
        let writes: Vec<_> = lines
            .iter()
            .map(|(path, rgb)| words(filter, path, SIZE.0, *rgb))
            .collect();
        let trace = draw(
            &writes,
            &frame_words(SIZE, [1, 2, 3]),
            s.outputs(),
            |_| true,
            |i| {
                s.clock(i);
                s.outputs()
            },
        );
        assert_eq!(
            taken(&trace, |_| true),
            expected(filter, &lines, SIZE, [1, 2, 3])
        );
    }
}

/// A second frame: clearing brings the background back, whatever it is.
#[test]
fn clearing_gives_an_empty_frame() {
    let size = (20, 12);
    for filter in [Filter::Box, Filter::Cone] {
        let mut r = StdRng::seed_from_u64(23);
        let lines: Lines = (0..30)
            .map(|_| (random_path(&mut r, size, 2), r.random()))
            .collect();
        let writes: Vec<_> = lines
            .iter()
            .map(|(p, c)| words(filter, p, size.0, *c))
            .collect();
        let mut m = core(filter, size).model();
        for background in [[0; 3], [255, 7, 99]] {
            let now = m.outputs();
            let trace = draw(
                &writes,
                &frame_words(size, background),
                now,
                |_| true,
                |i| {
                    m.clock(i);
                    m.outputs()
                },
            );
            assert_eq!(
                taken(&trace, |_| true),
                expected(filter, &lines, size, background)
            );
            let clear = CoreInputs {
                clear: true,
                ..CoreInputs::default()
            };
            m.clock(&clear);
            let mut clocks = 0;
            while m.outputs().busy {
                m.clock(&CoreInputs::default());
                clocks += 1;
            }
            assert_eq!((clocks, m.outputs().done), (240, true));
        }
    }
}

/// Whether 255·f lies half-way between two levels in a pixel's column.
fn is_tie(path: &Path, p: Pixel) -> bool {
    let first = path.place(0, 0);
    let x = if path.steep {
        p.y - first.y
    } else {
        p.x - first.x
    };
    let (dx, dy) = (i64::from(path.major), i64::from(path.minor));
    (510 * (i64::from(x) * dy % dx) + dx) % (2 * dx) == 0
}

/// How far the integers are from the renderer's f64: in a cone's weights by one level at the border of two entries, in a
/// box filter's where 255·f lies exactly between two levels and f64 rounds f; elsewhere not at all.
#[test]
fn against_the_renderer_s_real_numbers() {
    let mut r = StdRng::seed_from_u64(29);
    for filter in Filter::ALL {
        let (mut pixels, mut differ, mut worst) = (0u32, 0u32, 0u16);
        for _ in 0..20_000 {
            let path = random_path(&mut r, (320, 240), 20);
            let (a, b) = (exact(filter, &path), real(filter, &path));
            pixels += a.len() as u32;
            for (x, y) in a.iter().zip(&b) {
                if a.len() == b.len() {
                    assert_eq!(x.0, y.0, "{path:?}");
                    differ += u32::from(x.1 != y.1);
                    worst = worst.max(x.1.abs_diff(y.1));
                    if filter == Filter::Box && x.1 != y.1 {
                        assert!(is_tie(&path, x.0), "{path:?} {x:?}");
                    }
                }
            }
        }
        println!("{filter:?}: {differ} of {pixels} levels differ, by at most {worst}");
        let most = if filter == Filter::Box { 300 } else { 10_000 };
        assert!(worst <= 1 && differ < pixels / most, "{filter:?}");
    }
}
