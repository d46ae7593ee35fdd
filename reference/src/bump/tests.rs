//! Bent normals against gradients from their definition: the vector in the plane of the triangle whose products with the
//! edges are the changes of height along them.

use super::*;
use crate::raster::Point;
use proptest::prelude::*;

fn triangle(world: [DVec3; 3], uv: [DVec2; 3]) -> ScreenTriangle {
    let normal = (world[1] - world[0]).cross(world[2] - world[0]);
    ScreenTriangle {
        position: [Point::default(); 3],
        inv_w: [1.0; 3],
        depth: [1.0; 3],
        world,
        normal: [normal.normalize_or_zero(); 3],
        uv,
        material: 0,
        object: 0,
        face: 0,
    }
}

fn relief(gradient: Gradient) -> Relief {
    Relief {
        scale: 0.7,
        gradient,
        normalise: Normalise::Exact,
        wrap: Wrap::Clamp,
        repeat: DVec2::ONE,
    }
}

const WAYS: [Normalise; 3] = [Normalise::Exact, Normalise::Reflection, Normalise::Newton];

fn point() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-3.0..3.0f64).prop_map(DVec3::from)
}

fn inside() -> impl Strategy<Value = DVec2> {
    prop::array::uniform2(0.2..0.8f64).prop_map(DVec2::from)
}

proptest! {
    /// On a ramp every filter is exact, so the bend is as exact as arithmetic: for any triangle and any coordinates,
    /// mirrored, stretched or all on one line.
    #[test]
    fn a_ramp_on_any_triangle(
        world in prop::array::uniform3(point()), mut uv in prop::array::uniform3(inside()), line: bool, cubic: bool,
    ) {
        let [e1, e2] = [world[1] - world[0], world[2] - world[0]];
        let area = e1.cross(e2).length();
        prop_assume!(area > 0.3);
        if line {
            uv[2] = uv[0].lerp(uv[1], 0.3);
        }
        let way = if cubic { Gradient::CatmullRom } else { Gradient::Linear };
        // Heights u/2 + v/4, but for the half sample at the border; 0.7 as high in space.
        let n = 64;
        let ramp = Texels::from_fn(n, n, |x, y| {
            [((x as f64 / 2.0 + y as f64 / 4.0) / n as f64) as f32; 3]
        });
        let map = BumpMap::new(&ramp, relief(way));
        let rise = |i: usize| (uv[i] - uv[0]).dot(DVec2::new(0.5, 0.25)) * 0.7;
        // G = a·e₁ + b·e₂ with G·e₁ and G·e₂ given.
        let (m11, m12, m22) = (e1.dot(e1), e1.dot(e2), e2.dot(e2));
        let det = m11 * m22 - m12 * m12;
        let a = (rise(1) * m22 - rise(2) * m12) / det;
        let b = (rise(2) * m11 - rise(1) * m12) / det;
        let gradient = e1 * a + e2 * b;
        let t = triangle(world, uv);
        let n = t.normal[0];
        let got = map.bend(&t, [0.5, 0.2, 0.3], n, Normalise::Exact);
        let want = (n - gradient).normalize();
        prop_assert!(got.distance(want) < 1e-4, "{got} {want}");
        prop_assert!((got.length() - 1.0).abs() < 1e-12);
    }

    /// Whatever the numbers are, the normal stays a number of at most unit length.
    #[test]
    fn never_beyond_unit_length(
        world in prop::array::uniform3(point()), uv in prop::array::uniform3(prop::array::uniform2(prop::num::f64::NORMAL)),
        size in -30..30i32,
    ) {
        let map = BumpMap::new(
            &crate::texture::pattern::height("bumps").unwrap(),
            Relief { wrap: Wrap::Repeat, ..relief(Gradient::CatmullRom) },
        );
        let world = world.map(|p| p * 10f64.powi(size));
        let t = triangle(world, uv.map(DVec2::from));
        for way in WAYS {
            let n = map.bend(&t, [0.1, 0.2, 0.7], DVec3::Z, way);
            prop_assert!(n.is_finite() && n.length() < 1.0 + 1e-9, "{n}");
        }
    }
}

#[test]
fn without_heights_area_or_coordinates_nothing_is_bent() {
    let plain = Texels::from_fn(8, 8, |_, _| [0.5; 3]);
    let bumps = crate::texture::pattern::height("bumps").unwrap();
    let world = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let uv = [DVec2::ZERO, DVec2::X, DVec2::Y];
    for (picture, world, uv) in [
        (&plain, world, uv),
        (&bumps, world, [DVec2::ONE; 3]),
        (&bumps, [DVec3::ONE; 3], uv),
        (&bumps, [DVec3::ZERO, DVec3::X, DVec3::X * 2.0], uv),
    ] {
        let t = triangle(world, uv);
        for way in WAYS {
            let map = BumpMap::new(picture, relief(Gradient::BSpline));
            let n = DVec3::new(0.6, 0.0, 0.8);
            assert!(map.bend(&t, [0.4, 0.3, 0.3], n, way).distance(n) < 1e-12);
        }
    }
}

/// A lifted surface has the normal of its own derivatives: a wave on the unit square.
#[test]
fn a_wave_by_its_derivatives() {
    use std::f64::consts::TAU;
    let n = 256;
    let wave = |u: f64, v: f64| 0.5 + 0.25 * (TAU * u).sin() + 0.25 * (TAU * 2.0 * v).cos();
    let map = BumpMap::new(
        &Texels::from_fn(n, n, |x, y| {
            [wave((x as f64 + 0.5) / n as f64, (y as f64 + 0.5) / n as f64) as f32; 3]
        }),
        Relief {
            scale: 0.1,
            wrap: Wrap::Repeat,
            ..relief(Gradient::CatmullRom)
        },
    );
    // The square is 2 wide and 1 high in space.
    let t = triangle(
        [DVec3::ZERO, DVec3::X * 2.0, DVec3::Y],
        [DVec2::ZERO, DVec2::X, DVec2::Y],
    );
    let mut worst = 0.0f64;
    for i in 0..60 {
        for j in 0..60 - i {
            let (u, v) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
            let fx = 0.1 * 0.25 * TAU * (TAU * u).cos() / 2.0;
            let fy = -0.1 * 0.25 * TAU * 2.0 * (TAU * 2.0 * v).sin();
            let want = DVec3::new(-fx, -fy, 1.0).normalize();
            let got = map.bend(&t, [1.0 - u - v, u, v], DVec3::Z, Normalise::Exact);
            worst = worst.max(got.angle_between(want));
        }
    }
    // Central differences of 128 samples per wave are sin w/w too flat: 0.04 % of a slope of 0.31.
    assert!(worst < 2e-4, "{worst}");
}
