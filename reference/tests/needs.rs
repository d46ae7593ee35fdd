//! What frames need, against counts made pixel by pixel and corner by corner.

use glam::DVec3;
use shadegate_reference::needs::{Needs, Range};
use shadegate_reference::raster::{covers, Point};
use shadegate_reference::{scene, Prepared, Skips};
use std::path::PathBuf;

fn prepared(name: &str, skips: &Skips) -> Prepared {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/{name}.toml"));
    let scene = scene::load(&file).expect("a scene");
    Prepared::new(&scene, Some((80, 60)), skips).expect("prepares")
}

/// Triangles over every pixel, and pixels of every triangle, by the coverage rule alone.
fn layers(p: &Prepared) -> (Vec<u32>, Vec<u64>) {
    let mut over = vec![0; (p.width * p.height) as usize];
    let pixels = p.triangles.iter().map(|t| {
        let mut n = 0;
        for y in 0..p.height {
            for x in 0..p.width {
                if covers(t.position, x as i32, y as i32) {
                    over[(y * p.width + x) as usize] += 1;
                    n += 1;
                }
            }
        }
        n
    });
    let pixels = pixels.collect();
    (over, pixels)
}

#[test]
fn counts_are_those_of_the_pixels() {
    for name in ["sphere-168", "rings", "two-lights", "gem"] {
        for skips in [Skips::all(), Skips::none()] {
            let p = prepared(name, &skips);
            let n = Needs::of(&p, 1.0);
            let (over, pixels) = layers(&p);
            assert_eq!(n.triangles, p.triangles.len() as u64, "{name}");
            assert_eq!(n.deepest, over.iter().copied().max().unwrap(), "{name}");
            assert_eq!(n.pixels, pixels.iter().sum::<u64>(), "{name}");
            assert_eq!(n.empty, pixels.iter().filter(|k| **k == 0).count() as u64);
            let o = n.orders;
            let all = o.constant + o.linear + o.quadratic + o.products + o.per_pixel;
            assert_eq!(all, n.triangles, "{name}");
        }
    }
}

/// One closed convex object: its back faces are culled, and nothing lies over anything.
#[test]
fn a_sphere_needs_no_depth_test() {
    let n = Needs::of(&prepared("sphere-690", &Skips::all()), 1.0);
    assert_eq!((n.deepest, n.perspective), (1, 1.0));
    let both = Needs::of(&prepared("sphere-690", &Skips::none()), 1.0);
    assert_eq!(both.deepest, 2);
    assert!(Needs::of(&prepared("rings", &Skips::all()), 1.0).deepest > 1);
}

/// More error, cheaper ways; none at all, everything per pixel or exact by itself.
#[test]
fn more_error_wants_less() {
    let p = prepared("sphere-374", &Skips::all());
    let dear = |error: f64| {
        let o = Needs::of(&p, error).orders;
        [
            o.per_pixel,
            o.per_pixel + o.products,
            o.per_pixel + o.products + o.quadratic,
        ]
    };
    let all = [0.5, 1.0, 2.0, 5.0, 20.0, 200.0].map(dear);
    for pair in all.windows(2) {
        // Products and vectors are no chain: what is quadratic or less is.
        assert!(
            pair[1][1] <= pair[0][1] && pair[1][2] <= pair[0][2],
            "{all:?}"
        );
    }
    assert!(all[0][1] > 0 && all[5][2] == 0, "{all:?}");
}

#[test]
fn ranges_hold_every_corner_and_slopes_every_step() {
    let p = prepared("two-lights", &Skips::all());
    let n = Needs::of(&p, 1.0);
    let inside = |r: Range, v: f64| r.least <= v && v <= r.most;
    let mut steepest = 0.0f64;
    let mut widest = 0.0f64;
    for t in &p.triangles {
        for i in 0..3 {
            let Point { x, y } = t.position[i];
            assert!(inside(n.columns, f64::from(x) / 256.0));
            assert!(inside(n.rows, f64::from(y) / 256.0));
            assert!(inside(n.depth, t.depth[i]));
            let (a, b) = (t.normal[i], t.normal[(i + 1) % 3]);
            widest = widest.max(a.angle_between(b).to_degrees());
        }
        // The plane of the depth, by its normal.
        let at = |i: usize| {
            let Point { x, y } = t.position[i];
            DVec3::new(f64::from(x) / 256.0, f64::from(y) / 256.0, t.depth[i])
        };
        let normal = (at(1) - at(0)).cross(at(2) - at(0));
        let covering =
            (0..p.height as i32).any(|y| (0..p.width as i32).any(|x| covers(t.position, x, y)));
        if covering {
            steepest = steepest.max((normal.x.abs().max(normal.y.abs())) / normal.z.abs());
        }
    }
    assert!(
        (steepest - n.depth_slope).abs() <= 1e-9 * steepest,
        "{steepest} {n:?}"
    );
    assert!((widest - n.curvature).abs() < 1e-5, "{widest} {n:?}");
}

#[test]
fn frames_are_joined() {
    let [a, b] = ["sphere-168", "textures"].map(|s| Needs::of(&prepared(s, &Skips::all()), 1.0));
    let both = a.clone().join(&b);
    assert_eq!(both.triangles, a.triangles + b.triangles);
    assert_eq!(both.deepest, a.deepest.max(b.deepest));
    assert_eq!(both.columns, a.columns.join(b.columns));
    assert!(both.textures > 0 && a.textures == 0 && both.perspective > 1.0);
    assert!(both.exponents.windows(2).all(|w| w[0] < w[1]));
    assert_eq!(a.clone().join(&a).exponents, a.exponents);
    assert!(Range::NONE.is_none() && !Range::NONE.with(3.0).is_none());
}

/// The longest run is what the walk of a core adds up: in a frame of one triangle it is counted by hand.
#[test]
fn a_run_is_lines_carries_and_pixels() {
    let p = prepared("sphere-168", &Skips::all());
    let mut one = p.triangles[0];
    // The major edge goes from the first row down to the left by one pixel per row without any carry; spans grow by one.
    one.position = [(0, 0), (0, 2560), (2560, 2560)].map(|(x, y)| Point { x, y });
    let surroundings = shadegate_reference::shade::light::Surroundings::of(
        vec![],
        vec![shadegate_reference::scene::Material::default()],
        &scene::load(&PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../scenes/sphere-168.toml"))
            .expect("a scene")
            .camera,
    );
    one.material = 0;
    let p = Prepared::from_triangles((20, 20), [0; 3], vec![one], surroundings);
    let n = Needs::of(&p, 1.0);
    assert_eq!((n.most_rows, n.longest_span), (10, 9));
    // Nine lines of the vertical edge to the last row, then eight pixels.
    assert_eq!(n.longest_run, 9 + 8, "{n:?}");
    assert_eq!(n.pixels, 45);
}
