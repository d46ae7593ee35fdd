//! Pictures that need no file: computed, 64 × 64 texels, without a seam when they are repeated.

use super::Texels;
use std::f64::consts::PI;

const SIDE: usize = 64;

/// Names of the colour patterns.
pub const NAMES: &[&str] = &["checker", "tiles"];
/// Names of the height patterns.
pub const HEIGHT_NAMES: &[&str] = &["bumps", "tiles"];

/// 8 × 8 squares, white and 20 % grey.
fn checker(x: usize, y: usize) -> [f32; 3] {
    if (x / 8 + y / 8).is_multiple_of(2) {
        [1.0; 3]
    } else {
        [0.2; 3]
    }
}

/// Whether a texel lies in the joint, 4 texels wide, around 2 × 2 tiles.
fn joint(x: usize, y: usize) -> bool {
    let rim = |v: usize| !(2..30).contains(&(v % 32));
    rim(x) || rim(y)
}

/// 2 × 2 tiles of different shades with grey joints.
fn tiles(x: usize, y: usize) -> [f32; 3] {
    if joint(x, y) {
        return [0.45; 3];
    }
    match (x / 32, y / 32) {
        (0, 0) => [0.95, 0.62, 0.45],
        (1, 1) => [0.90, 0.70, 0.52],
        (0, _) => [1.0, 0.80, 0.62],
        _ => [0.82, 0.55, 0.40],
    }
}

/// 4 × 4 round bumps: sin²·sin², 0 between them and 1 on top.
fn bumps(x: usize, y: usize) -> [f32; 3] {
    let wave = |v: usize| (4.0 * PI * (v as f64 + 0.5) / SIDE as f64).sin().powi(2);
    [(wave(x) * wave(y)) as f32; 3]
}

/// Flat tiles above their joints.
fn raised(x: usize, y: usize) -> [f32; 3] {
    if joint(x, y) {
        [0.0; 3]
    } else {
        [1.0; 3]
    }
}

/// The colour pattern of a name in [`NAMES`].
#[must_use]
pub fn colour(name: &str) -> Option<Texels> {
    let texel = match name {
        "checker" => checker,
        "tiles" => tiles,
        _ => return None,
    };
    Some(Texels::from_fn(SIDE, SIDE, texel))
}

/// The height pattern of a name in [`HEIGHT_NAMES`].
#[must_use]
pub fn height(name: &str) -> Option<Texels> {
    let texel = match name {
        "bumps" => bumps,
        "tiles" => raised,
        _ => return None,
    };
    Some(Texels::from_fn(SIDE, SIDE, texel))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_has_its_picture() {
        for (names, make) in [
            (NAMES, colour as fn(&str) -> Option<Texels>),
            (HEIGHT_NAMES, height),
        ] {
            for name in names {
                let t = make(name).unwrap();
                let (mut lo, mut hi) = (f64::INFINITY, 0.0f64);
                for i in 0..SIDE * SIDE {
                    let v = t.at(i % SIDE, i / SIDE)[0];
                    (lo, hi) = (lo.min(v), hi.max(v));
                }
                assert!(lo >= 0.0 && hi <= 1.0 && hi - lo > 0.4, "{name}: {lo} {hi}");
            }
            assert_eq!(make("stripes"), None);
        }
    }

    #[test]
    fn half_of_a_checker_is_white() {
        let t = colour("checker").unwrap();
        let white = (0..SIDE * SIDE).filter(|i| t.at(i % SIDE, i / SIDE) == [1.0; 3]);
        assert_eq!(white.count(), SIDE * SIDE / 2);
    }
}
