//! Exact frames of small scenes against pictures kept in `tests/golden/`.
//!
//! After a wanted change, `SHADEGATE_BLESS=1 cargo test --release -p shadegate-reference --test golden` writes them
//! anew; look at them before committing. On a failure the difference, amplified, is left in the build folder. Powers
//! and sines come from the system's mathematics library, so a last bit may turn a rounding: one LSB is allowed in one
//! pixel of a thousand.

mod common;

use common::{draw, load, prepare};
use shadegate_reference::animation::Player;
use shadegate_reference::antialias::{self, skips_for, Antialias};
use shadegate_reference::sample::{self, Filter, Wanted};
use shadegate_reference::{Frame, Method, Prepared, RenderOptions, Skips};
use std::path::PathBuf;

fn check(name: &str) {
    check_frame(name, &draw(&prepare(name, Some((96, 72))), Method::Exact));
}

fn check_frame(name: &str, frame: &Frame) {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/{name}.png"));
    if std::env::var_os("SHADEGATE_BLESS").is_some() {
        frame.save_png(&file).unwrap();
    }
    let want = Frame::load_png(&file).unwrap();
    assert_eq!((want.width, want.height), (frame.width, frame.height));
    let pairs = || frame.pixels.iter().zip(&want.pixels);
    let far = pairs()
        .filter(|(a, b)| (0..3).any(|c| a[c].abs_diff(b[c]) > 1))
        .count();
    let differing = pairs().filter(|(a, b)| a != b).count();
    if far > 0 || differing > frame.pixels.len() / 1000 {
        let mut diff = frame.clone();
        for (d, w) in diff.pixels.iter_mut().zip(&want.pixels) {
            *d = [0, 1, 2].map(|c| d[c].abs_diff(w[c]).saturating_mul(64));
        }
        let out = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}-difference.png"));
        diff.save_png(&out).unwrap();
        panic!(
            "{name}: {differing} pixels differ, {far} by more than 1 LSB; see {}",
            out.display()
        );
    }
}

#[test]
fn sphere() {
    check("sphere-374");
}

#[test]
fn teapot() {
    check("teapot");
}

#[test]
fn two_lights() {
    check("two-lights");
}

#[test]
fn rings() {
    check("rings");
}

#[test]
fn spot() {
    check("spot");
}

#[test]
fn materials() {
    check("materials");
}

/// Supersampling, motion blur and all that moves, in one frame.
#[test]
fn spin() {
    let wanted = Wanted {
        size: Some((96, 72)),
        method: Method::Exact,
        samples: 3,
        filter: Filter::Tent,
        antialias: Antialias::None,
        options: RenderOptions::default(),
    };
    let drawn = sample::draw(&mut Player::new(load("spin")), 7, &wanted).unwrap();
    check_frame("spin", &drawn.frame);
}

#[test]
fn wire() {
    check("wire-48");
}

#[test]
fn depth_cue() {
    check("depth-cue");
}

/// Blake's modulation and the A-buffer of the same scene.
#[test]
fn anti_aliased() {
    let skips = skips_for(Antialias::ABuffer, Skips::all());
    let p = Prepared::new(&load("two-lights"), Some((96, 72)), &skips).unwrap();
    for a in [Antialias::ABuffer, Antialias::Cubic] {
        let o = RenderOptions::default();
        let (frame, _) = antialias::draw(&p, Method::Quadratic, a, &o).unwrap();
        check_frame(&format!("two-lights-{a}"), &frame);
    }
}

#[test]
fn perspective_floor() {
    check("perspective-floor");
}

#[test]
fn tiles() {
    check("tiles");
}

#[test]
fn bump() {
    check("bump");
}
