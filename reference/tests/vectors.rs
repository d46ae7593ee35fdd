//! Drawing many pixels at a time: the same bytes for every width of registers, and what the pixel-by-pixel way draws; and
//! the promise of `auto`.

mod common;

use common::{difference, load, prepare, SCENES};
use shadegate_reference::render::Vectors;
use shadegate_reference::{render, Method, Prepared, RenderOptions, Skips};

fn with(vectors: Vectors) -> RenderOptions {
    RenderOptions {
        vectors,
        ..RenderOptions::default()
    }
}

#[test]
fn every_width_of_registers_draws_the_same_bytes() {
    for name in SCENES {
        for size in [(131, 97), (320, 240)] {
            let p = prepare(name, Some(size));
            for m in Method::ALL.iter().copied().filter(|m| *m != Method::Exact) {
                let (widest, a) = render(&p, m, &with(Vectors::Widest));
                let (baseline, b) = render(&p, m, &with(Vectors::Baseline));
                assert!(widest == baseline, "{name} {m}");
                assert_eq!(a.pixels_written, b.pixels_written, "{name} {m}");
            }
        }
    }
}

#[test]
fn many_pixels_at_a_time_are_as_one_by_one() {
    for name in SCENES {
        let p = prepare(name, None);
        for m in [
            Method::Flat,
            Method::Gouraud,
            Method::Quadratic,
            Method::QuadraticDots,
            Method::Phong,
        ] {
            let (many, a) = render(&p, m, &with(Vectors::Widest));
            let (single, b) = render(&p, m, &with(Vectors::None));
            let (max, _) = difference(&many, &single);
            // Fixed point is within 0.005 LSB and f32 within 0.02, which may turn a rounding.
            assert!(max <= 1, "{name} {m}: {max}");
            assert!(a.pixels_tested <= b.pixels_tested, "{name} {m}");
            assert_eq!(a.pixels_written, b.pixels_written, "{name} {m}");
        }
    }
}

#[test]
fn auto_keeps_its_promise() {
    for name in SCENES {
        for n in [5.0, 20.0, 100.0] {
            let mut scene = load(name);
            for m in &mut scene.materials {
                m.shininess = n;
            }
            let p = Prepared::new(&scene, Some((240, 180)), &Skips::all()).unwrap();
            let (truth, _) = render(&p, Method::Exact, &RenderOptions::default());
            for error in [0.0, 0.3, 1.0, 2.0, 5.0] {
                for list in ["", "flat-enough,products-enough", "specular,diffuse", "all"] {
                    let o = RenderOptions {
                        max_error: error,
                        skips: Skips::without(list).unwrap(),
                        ..RenderOptions::default()
                    };
                    let (frame, stats) = render(&p, Method::Auto, &o);
                    let (max, _) = difference(&truth, &frame);
                    // Real numbers at most `error` apart round to bytes at most its ceiling apart.
                    assert!(
                        f64::from(max) <= error.ceil(),
                        "{name} n={n} {error}: {max}"
                    );
                    for skip in list.split(',').filter(|l| *l != "all") {
                        assert_eq!(stats.skipped.get(skip), None, "{skip}");
                    }
                }
            }
        }
    }
}

#[test]
fn auto_works_less_where_more_error_is_allowed() {
    let p = prepare("teapot", None);
    let cheap = |error: f64| {
        let o = RenderOptions {
            max_error: error,
            ..RenderOptions::default()
        };
        let skipped = render(&p, Method::Auto, &o).1.skipped;
        ["flat-enough", "linear-enough", "quadratic-enough"]
            .map(|s| skipped.get(s).copied().unwrap_or(0))
            .iter()
            .sum::<u64>()
    };
    let counts = [0.0, 0.2, 1.0, 4.0, 20.0].map(cheap);
    assert!(
        counts.is_sorted() && counts[0] == 0 && counts[4] > 2 * counts[1],
        "{counts:?}"
    );
}
