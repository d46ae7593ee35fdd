//! Anti-aliased frames against supersampled ones.

mod common;

use common::{difference, load};
use shadegate_reference::antialias::a_buffer::Masks;
use shadegate_reference::antialias::mask::Grid;
use shadegate_reference::antialias::mask_table::MaskTable;
use shadegate_reference::antialias::{draw, draw_with_masks, skips_for, Antialias};
use shadegate_reference::{render, Frame, Method, Prepared, RenderOptions, RenderStats, Skips};

const SCENES: [&str; 5] = ["sphere-374", "torus-288", "gem", "rings", "two-lights"];
const METHODS: [Method; 4] = [
    Method::Exact,
    Method::Flat,
    Method::Gouraud,
    Method::Quadratic,
];
const SIZE: (u32, u32) = (80, 60);

/// Prepares a scene for anti-aliasing.
fn prepare(name: &str, size: Option<(u32, u32)>) -> Prepared {
    Prepared::new(
        &load(name),
        size,
        &skips_for(Antialias::ABuffer, Skips::all()),
    )
    .unwrap()
}

fn drawn(p: &Prepared, method: Method, a: Antialias, skips: Skips) -> (Frame, RenderStats) {
    let o = RenderOptions {
        skips,
        ..RenderOptions::default()
    };
    draw(p, method, a, &o).unwrap_or_else(|e| panic!("{e}"))
}

/// The mean of N × N pixels of a frame N times as large.
fn supersampled(name: &str, method: Method, n: u32) -> Frame {
    let (w, h) = SIZE;
    let p = prepare(name, Some((w * n, h * n)));
    let (large, _) = render(&p, method, &RenderOptions::default());
    let mut out = Frame::new(w, h, [0; 3]);
    for (i, pixel) in out.pixels.iter_mut().enumerate() {
        let (x, y) = (i as u32 % w * n, i as u32 / w * n);
        let mut sum = [0u32; 3];
        for v in 0..n {
            for u in 0..n {
                let c = large.pixels[((y + v) * large.width + x + u) as usize];
                sum = [0, 1, 2].map(|k| sum[k] + u32::from(c[k]));
            }
        }
        *pixel = sum.map(|s| ((s + n * n / 2) / (n * n)) as u8);
    }
    out
}

/// Largest and RMS errors in LSB against 16 × 16 samples of the same method: what was measured when this was written plus
/// some room. Without anti-aliasing the RMS is 2.0 to 12. What is left of the A-buffer's is its samples and, in
/// two-lights, the ball that pierces the floor: there is one depth per triangle and pixel. The ramps' is most where three
/// facets of different brightness meet.
#[test]
fn close_to_converged_supersampling() {
    let bounds = [
        ("sphere-374", (7, 0.2), (13, 0.45)),
        ("torus-288", (6, 0.35), (17, 0.8)),
        ("gem", (10, 0.3), (28, 0.55)),
        ("rings", (28, 1.05), (55, 2.4)),
        ("two-lights", (44, 1.0), (52, 1.15)),
    ];
    for (name, a_buffer, ramps) in bounds {
        for method in [Method::Gouraud, Method::Quadratic, Method::Exact] {
            let truth = supersampled(name, method, 16);
            let p = prepare(name, Some(SIZE));
            let error = |a| difference(&truth, &drawn(&p, method, a, Skips::all()).0);
            let none = error(Antialias::None);
            let (mask, cubic) = (error(Antialias::ABuffer), error(Antialias::Cubic));
            println!("{name} {method}: none {none:.2?}, a-buffer {mask:.2?}, cubic {cubic:.2?}");
            assert!(
                mask.0 <= a_buffer.0 && mask.1 <= a_buffer.1,
                "{name} {method}: {mask:?}"
            );
            assert!(
                cubic.0 <= ramps.0 && cubic.1 <= ramps.1,
                "{name} {method}: {cubic:?}"
            );
            assert!(
                mask.1 * 6.0 < none.1 && cubic.1 * 3.0 < none.1,
                "{name} {method}: {none:?}"
            );
        }
    }
}

#[test]
fn skips_are_counted_and_leave_the_frame_as_it_is() {
    for name in SCENES {
        let p = prepare(name, None);
        for a in [Antialias::ABuffer, Antialias::Cubic] {
            for method in [Method::Gouraud, Method::Exact] {
                let (want, all) = drawn(&p, method, a, Skips::all());
                for list in ["hidden", "masked", "hidden,masked"] {
                    let (got, some) = drawn(&p, method, a, Skips::without(list).unwrap());
                    assert!(got == want, "{name} {a} {method} without {list}");
                    for skip in list.split(',') {
                        assert_eq!(some.skipped.get(skip), None, "counted although off");
                    }
                    assert!(some.pixels_shaded >= all.pixels_shaded);
                }
                if name == "torus-288" {
                    assert!(all.skipped["hidden"] > 0 || all.skipped["masked"] > 0);
                    assert!(all.pixels_shaded < all.pixels_tested);
                }
            }
        }
    }
}

#[test]
fn any_number_of_threads_draws_the_same() {
    let p = prepare("two-lights", None);
    for a in [Antialias::ABuffer, Antialias::Cubic] {
        let frames = [1, 2, 5].map(|threads| {
            let o = RenderOptions {
                threads: Some(threads),
                ..RenderOptions::default()
            };
            draw(&p, Method::Quadratic, a, &o).unwrap()
        });
        assert!(frames[0].0 == frames[1].0 && frames[0].0 == frames[2].0);
        assert_eq!(frames[0].1.pixels_written, frames[2].1.pixels_written);
    }
}

/// Where one triangle covers a pixel and all its neighbours, nothing changes but the roundings of another order of sums.
#[test]
fn inside_triangles_nothing_changes() {
    for name in ["sphere-374", "two-lights"] {
        let p = prepare(name, None);
        let mut interior = vec![false; (p.width * p.height) as usize];
        for t in &p.triangles {
            let covers = |x, y| shadegate_reference::raster::covers(t.position, x, y);
            let (xs, ys) = (t.position.map(|q| q.x / 256), t.position.map(|q| q.y / 256));
            for y in ys.iter().min().unwrap() - 1..=ys.iter().max().unwrap() + 1 {
                for x in xs.iter().min().unwrap() - 1..=xs.iter().max().unwrap() + 1 {
                    let inside =
                        (0..p.width as i32).contains(&x) && (0..p.height as i32).contains(&y);
                    let around = [(0, 0), (1, 1), (-1, 1), (1, -1), (-1, -1)];
                    if inside && around.iter().all(|(u, v)| covers(x + u, y + v)) {
                        interior[(y as u32 * p.width + x as u32) as usize] = true;
                    }
                }
            }
        }
        for method in METHODS {
            let (plain, _) = render(&p, method, &RenderOptions::default());
            for a in [Antialias::ABuffer, Antialias::Cubic] {
                let (frame, _) = drawn(&p, method, a, Skips::all());
                let mut compared = 0;
                for (i, inside) in interior.iter().enumerate() {
                    if *inside && name == "sphere-374" {
                        compared += 1;
                        let (u, v) = (plain.pixels[i], frame.pixels[i]);
                        assert!(
                            (0..3).all(|c| u[c].abs_diff(v[c]) <= 1),
                            "{method} {a} {i}: {u:?} {v:?}"
                        );
                    }
                }
                assert!(compared > 10_000 || name != "sphere-374", "{compared}");
            }
        }
    }
}

/// Errors fall as samples rise; a table of 5 + 5 address bits (64 Kbit for 8×8 samples) is nearly as good as exact masks.
#[test]
fn grids_and_tables() {
    let truth = supersampled("torus-288", Method::Gouraud, 16);
    let p = prepare("torus-288", Some(SIZE));
    let rms = |masks: &Masks<'_>| {
        let frame = draw_with_masks(&p, Method::Gouraud, masks, Skips::all()).unwrap();
        difference(&truth, &frame).1
    };
    let grids = [
        Grid::ONE,
        Grid::FOUR_BY_FOUR,
        Grid::FOUR_BY_EIGHT,
        Grid::EIGHT_BY_EIGHT,
    ];
    let direct = grids.map(|g| rms(&Masks::Direct(g)));
    println!("samples 1, 16, 32, 64: {direct:.2?}");
    assert!(direct.windows(2).all(|w| w[1] < w[0]));
    let tables = [3, 5, 7].map(|bits| {
        let table = MaskTable::new(Grid::EIGHT_BY_EIGHT, bits, bits);
        (table.bits(), rms(&Masks::Table(&table)))
    });
    println!("tables of 8x8: {tables:.2?}");
    assert!(tables[1].1 < tables[0].1 && tables[2].1 < tables[0].1);
    assert!(tables[1].1 < direct[3] * 1.5 && tables[2].1 < direct[3] * 1.5);
}

/// One sample per pixel is no anti-aliasing at all: the frame of the renderer, but for its depth at other places.
#[test]
fn one_sample_is_the_plain_frame() {
    for name in ["sphere-374", "gem", "torus-288"] {
        let p = prepare(name, None);
        let (plain, _) = render(&p, Method::Exact, &RenderOptions::default());
        let frame =
            draw_with_masks(&p, Method::Exact, &Masks::Direct(Grid::ONE), Skips::all()).unwrap();
        let (max, _) = difference(&plain, &frame);
        assert!(max <= 1, "{name}: {max}");
    }
}

#[test]
fn only_colours_that_are_known_everywhere() {
    let p = prepare("gem", Some((8, 6)));
    for method in Method::ALL.iter().copied() {
        let o = RenderOptions::default();
        assert!(draw(&p, method, Antialias::None, &o).is_ok());
        for a in [Antialias::ABuffer, Antialias::Cubic] {
            match draw(&p, method, a, &o) {
                Ok(_) => assert!(METHODS.contains(&method)),
                Err(e) => {
                    assert!(!METHODS.contains(&method));
                    let want = format!(
                        "method '{method}' has no anti-aliased form '{a}'; expected a method of "
                    );
                    assert!(e.to_string().starts_with(&want), "{e}");
                }
            }
        }
    }
}

/// Scenes of nothing but wire, and frames of one pixel.
#[test]
fn small_and_empty_frames() {
    for name in ["wire-48", "two-lights", "gem"] {
        let scene = load(name);
        for size in [(1, 1), (1, 40), (33, 1)] {
            let p = Prepared::new(&scene, Some(size), &Skips::none()).unwrap();
            for a in Antialias::ALL {
                let (frame, _) = drawn(&p, Method::Quadratic, a, Skips::all());
                assert_eq!(frame.pixels.len() as u32, size.0 * size.1);
            }
        }
    }
}
