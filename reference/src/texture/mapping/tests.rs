//! Addresses against an oracle that knows no interpolation: rays through pixel centres meet the plane of a triangle in
//! space.

use super::*;
use crate::raster::{area2, Point, Viewport, Walk};
use glam::{DVec2, DVec3};
use proptest::prelude::*;

const VIEWPORT: Viewport = Viewport {
    width: 640,
    height: 400,
};

/// The point of a pinhole camera at the origin, looking along +z with the screen at z = 1 in pixels, that lies under a
/// snapped position at a depth.
fn unproject(p: Point, depth: f64) -> DVec3 {
    let (x, y) = p.pixels();
    DVec3::new(x, y, 1.0) * depth
}

/// The texture coordinates where the ray through (x, y) meets the plane: ratios of the areas in space.
fn by_ray(t: &ScreenTriangle, uv: &[DVec2; 3], x: f64, y: f64) -> DVec2 {
    let p = [0, 1, 2].map(|i| unproject(t.position[i], 1.0 / t.inv_w[i]));
    let normal = (p[1] - p[0]).cross(p[2] - p[0]);
    let ray = DVec3::new(x, y, 1.0);
    let hit = ray * (p[0].dot(normal) / ray.dot(normal));
    let area = |a: DVec3, b: DVec3| (a - hit).cross(b - hit).dot(normal);
    let (a, b, c) = (area(p[1], p[2]), area(p[2], p[0]), area(p[0], p[1]));
    (uv[0] * a + uv[1] * b + uv[2] * c) / normal.length_squared()
}

fn triangle(position: [Point; 3], depth: [f64; 3]) -> ScreenTriangle {
    ScreenTriangle {
        position,
        inv_w: depth.map(|d| 1.0 / d),
        depth: [1.0; 3],
        world: [DVec3::ZERO; 3],
        normal: [DVec3::Z; 3],
        uv: [DVec2::ZERO; 3],
        material: 0,
        object: 0,
        face: 0,
    }
}

fn corners() -> impl Strategy<Value = [Point; 3]> {
    prop::array::uniform3((-20_000..180_000i32, -20_000..120_000i32))
        .prop_map(|p| p.map(|(x, y)| Point { x, y }))
}

fn coordinates() -> impl Strategy<Value = [DVec2; 3]> {
    prop::array::uniform3((-300.0..300.0f64, -300.0..300.0f64)).prop_map(|p| p.map(DVec2::from))
}

/// Calls `check` with the column, the row and the track of every covered pixel.
fn visit(
    t: &ScreenTriangle,
    address: &Address,
    constant_depth: bool,
    mut check: impl FnMut(f64, f64, &Track) -> Result<(), TestCaseError>,
) -> Result<(), TestCaseError> {
    let Some(walk) = Walk::new(t.position, VIEWPORT) else {
        return Ok(());
    };
    // A few rows are enough.
    for s in walk.spans(VIEWPORT.width).step_by(17) {
        let mut track = address.start(s.start, s.y, s.end - s.start, constant_depth);
        for x in s.start..s.end {
            check(f64::from(x) + 0.5, f64::from(s.y) + 0.5, &track)?;
            track.step();
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Perspective addresses are those of the ray to a billionth of a texel, and the footprint is its derivative.
    #[test]
    fn perspective_is_the_ray(p in corners(), d in prop::array::uniform3(0.5..20.0f64), uv in coordinates()) {
        prop_assume!(area2(p).abs() > 400_000);
        let t = triangle(p, d);
        let address = Address::new(&t, &uv, Mapping::Perspective);
        visit(&t, &address, false, |x, y, track| {
            let (at, footprint) = track.place();
            prop_assert!(at.distance(by_ray(&t, &uv, x, y)) < 1e-7);
            let right = |h: f64| (by_ray(&t, &uv, x + h, y) - by_ray(&t, &uv, x - h, y)) / (2.0 * h);
            let down = |h: f64| (by_ray(&t, &uv, x, y + h) - by_ray(&t, &uv, x, y - h)) / (2.0 * h);
            // Steep places: twice the step shows three times the error of the difference quotient.
            let agrees = |got: DVec2, quotient: &dyn Fn(f64) -> DVec2| {
                let (want, coarse) = (quotient(1e-4), quotient(2e-4));
                got.distance(want) < 1e-5 * (1.0 + want.length()) + want.distance(coarse)
            };
            prop_assert!(agrees(footprint.right, &right), "{:?} {}", footprint.right, right(1e-4));
            prop_assert!(agrees(footprint.down, &down), "{:?} {}", footprint.down, down(1e-4));
            Ok(())
        })?;
    }

    /// One reciprocal per span, where it is used, keeps its tolerance; it is used on planes level with the rows.
    #[test]
    fn constant_depth_keeps_its_tolerance(
        p in corners(), near in 0.5..5.0f64, slope in 0.0..0.01f64, lean in prop_oneof![Just(0.0), -1e-6..1e-6f64], uv in coordinates(),
    ) {
        prop_assume!(area2(p).abs() > 400_000);
        // Planes on which 1/depth changes with the row, and hardly with the column.
        let inv_w = p.map(|q| {
            let (x, y) = q.pixels();
            1.0 / near + slope * (y + 80.0) + lean * x
        });
        prop_assume!(inv_w.iter().all(|w| *w > 0.01));
        let t = triangle(p, inv_w.map(|w| 1.0 / w));
        let address = Address::new(&t, &uv, Mapping::Perspective);
        let (mut lines, mut others) = (0, 0);
        visit(&t, &address, true, |x, y, track| {
            let (at, footprint) = track.place();
            let off = (at - by_ray(&t, &uv, x, y)).abs().max_element();
            prop_assert!(off < CONSTANT_DEPTH_TOLERANCE + 1e-7, "{off}");
            lines += u32::from(matches!(track, Track::Line(_)));
            others += u32::from(!matches!(track, Track::Line(_)));
            prop_assert!(footprint.right.is_finite() && footprint.down.is_finite());
            Ok(())
        })?;
        // On level planes only spans of one pixel are not lines.
        prop_assert!(lean != 0.0 || others <= 30, "{lines} {others}");
    }

    /// The quadratic meets the truth at its six knots, and its footprint is its derivative.
    #[test]
    fn the_six_knots_are_true(p in corners(), d in prop::array::uniform3(0.5..5.0f64), uv in coordinates()) {
        prop_assume!(area2(p).abs() > 400_000);
        // Even pixel centres, so that the middles of the edges are pixel centres too.
        let p = p.map(|q| Point { x: (q.x & !511) + 128, y: (q.y & !511) + 128 });
        prop_assume!(area2(p).abs() > 400_000);
        let t = triangle(p, d);
        let address = Address::new(&t, &uv, Mapping::Quadratic);
        for (i, j) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)] {
            let x = (p[i].x + p[j].x) / 2 / SUBPIXELS;
            let y = (p[i].y + p[j].y) / 2 / SUBPIXELS;
            let x = if (p[i].x + p[j].x) < 0 { (p[i].x + p[j].x).div_euclid(2 * SUBPIXELS) } else { x };
            let y = if (p[i].y + p[j].y) < 0 { (p[i].y + p[j].y).div_euclid(2 * SUBPIXELS) } else { y };
            let (at, f) = address.start(x, y, 1, false).place();
            let want = by_ray(&t, &uv, f64::from(x) + 0.5, f64::from(y) + 0.5);
            prop_assert!(at.distance(want) < 1e-7, "{at} {want}");
            // Central differences are exact for quadratics.
            let near = |dx, dy| address.start(x + dx, y + dy, 1, false).place().0;
            let right = (near(1, 0) - near(-1, 0)) / 2.0;
            let down = (near(0, 1) - near(0, -1)) / 2.0;
            let allowed = 1e-8 * (1.0 + right.length() + down.length());
            prop_assert!(f.right.distance(right) < allowed && f.down.distance(down) < allowed);
        }
        // Along a span, steps are as good as starts.
        visit(&t, &address, false, |x, y, track| {
            let (at, f) = track.place();
            let (want, g) = address.start((x - 0.5) as i32, (y - 0.5) as i32, 1, false).place();
            prop_assert!(at.distance(want) < 1e-6);
            prop_assert!(f.right.distance(g.right) < 1e-6 && f.down.distance(g.down) < 1e-6);
            Ok(())
        })?;
    }

    /// Affine addresses on a triangle parallel to the screen are the truth.
    #[test]
    fn affine_is_true_at_one_depth(p in corners(), d in 0.5..20.0f64, uv in coordinates()) {
        prop_assume!(area2(p).abs() > 400_000);
        let t = triangle(p, [d; 3]);
        for mapping in [Mapping::Affine, Mapping::Quadratic, Mapping::Perspective] {
            let address = Address::new(&t, &uv, mapping);
            visit(&t, &address, true, |x, y, track| {
                prop_assert!(track.place().0.distance(by_ray(&t, &uv, x, y)) < 1e-6);
                Ok(())
            })?;
        }
    }
}

/// The largest errors of the three mappings over triangles whose depths are 1 and r at two vertices and anything
/// between at the third, as parts of the extent of the texture; measured against the ray.
fn worst(r: f64, mapping: Mapping) -> f64 {
    let p =
        [(128, 128), (128 + 600 * 256, 128), (128, 128 + 380 * 256)].map(|(x, y)| Point { x, y });
    let mut worst = 0.0f64;
    for third in 0..=8 {
        for flip in [false, true] {
            let between = r.powf(f64::from(third) / 8.0);
            let t = triangle(p, [1.0, r, between]);
            // The extent runs along the edge of the whole ratio; at the third vertex the texture is at either end.
            let uv = [0.0, 1.0, f64::from(u8::from(flip))].map(|u| DVec2::new(u, 0.0));
            let address = Address::new(&t, &uv, mapping);
            visit(&t, &address, false, |x, y, track| {
                worst = worst.max((track.place().0 - by_ray(&t, &uv, x, y)).x.abs());
                Ok(())
            })
            .unwrap();
        }
    }
    worst
}

/// The table of the literature study: largest errors of the six-knot address by depth ratio, as parts of the extent.
#[test]
fn errors_by_depth_ratio() {
    for (r, six, digits) in [
        (1.1, 0.0004, 4),
        (1.25, 0.0025, 4),
        (1.5, 0.0087, 4),
        (2.0, 0.027, 3),
        (3.0, 0.070, 3),
        (4.0, 0.111, 3),
        (8.0, 0.239, 3),
    ] {
        let got = worst(r, Mapping::Quadratic);
        let rounding = 0.5001 * 0.1f64.powi(digits);
        println!(
            "r = {r}: six knots {got:.5} of {six}, affine {:.5}",
            worst(r, Mapping::Affine)
        );
        assert!((got - six).abs() <= rounding + 2e-3 * six, "{r}: {got}");
        if r <= 2.0 {
            assert!(got <= 0.056 * r.ln().powi(2));
        }
        let affine = worst(r, Mapping::Affine);
        let law = super::super::affine::worst_part(r);
        assert!(
            affine <= law + 1e-9 && affine > 0.998 * law,
            "{r}: {affine} {law}"
        );
        assert!(worst(r, Mapping::Perspective) < 1e-10);
    }
}
