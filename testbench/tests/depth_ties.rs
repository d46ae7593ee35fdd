//! Where a wall meets a floor, their depths differ by less than the step of a depth word. The renderer compares depths in
//! real numbers, a core words of 16 bits, of which equal ones leave what was drawn first. Each pixel of a large frame in
//! which they differ by more than rounding is shown to be such a tie, and nothing else.

use shadegate_gen::stimulus::{StimulusOptions, Triangle};
use shadegate_gen::vectors::Pixel;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::covers;
use shadegate_reference::{render, scene, shade, skips, to_byte, Method, RenderOptions};
use shadegate_testbench::cosim::prelude;
use shadegate_testbench::cosim::texture_oracle::colour;
use std::path::Path;

const SIZE: (u32, u32) = (640, 480);

/// The depth of a triangle at a pixel, in steps of a depth word, not rounded.
fn depth(t: &Triangle, x: i32, y: i32) -> f64 {
    let knots = t.depth.map(|d| [d, 0.0, 0.0]);
    shade::gouraud::value(&t.position, &knots, x, y)[0]
}

fn apart(a: [u8; 3], b: [u8; 3]) -> u8 {
    let channels = a.into_iter().zip(b);
    channels.map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

#[test]
fn large_textured_frames_differ_in_depth_ties_alone() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/textures.toml");
    let text = std::fs::read_to_string(&path).expect("a scene");
    // Bilinear texels do not jump, so what is left are surfaces.
    let text = text.replace("\"nearest\"", "\"bilinear\"");
    let scene = scene::parse(&path, &text).expect("a scene");
    let options = StimulusOptions::default();
    let p = prelude(&scene, Method::Quadratic, Some(SIZE), &options).expect("set up");
    let Order::Textured(texturing) = p.trace.core.order else {
        panic!("{:?}", p.trace.core);
    };
    let mut rendering = RenderOptions::default();
    rendering.skips = rendering
        .skips
        .but(skips::AFFINE)
        .but(skips::CONSTANT_DEPTH);
    let rendered = render(&p.prepared, Method::Quadratic, &rendering).0.pixels;
    let at = |x: u16, y: u16| usize::from(y) * SIZE.0 as usize + usize::from(x);
    let mut shown: Vec<Option<&Pixel>> = vec![None; rendered.len()];
    for pixel in &p.trace.pixels {
        shown[at(pixel.x, pixel.y)] = Some(pixel);
    }
    // Half a unit of each register word, walked along the longest run.
    let run = 1.5 * f64::from(SIZE.0) + 2.0 * f64::from(SIZE.1);
    let walked = (1.0 + run) / f64::from(1 << 17);
    let mut ties = 0;
    for pixel in shown.into_iter().flatten() {
        let want = rendered[at(pixel.x, pixel.y)];
        let by = apart(pixel.rgb, want);
        if by <= 1 {
            continue;
        }
        let (x, y) = (i32::from(pixel.x), i32::from(pixel.y));
        let mut nearest = (0.0, usize::MAX);
        for (i, t) in p.triangles.iter().enumerate() {
            if covers(t.position, x, y) && depth(t, x, y) > nearest.0 {
                nearest = (depth(t, x, y), i);
            }
        }
        let [core, renderer] = [pixel.triangle, nearest.1].map(|i| &p.triangles[i]);
        let depths = [core, renderer].map(|t| depth(t, x, y));
        let what = format!(
            "({x}, {y}): {by} LSB, core {} at {:.4}, renderer {} at {:.4}",
            core.label, depths[0], renderer.label, depths[1]
        );
        println!("{what}");
        assert_ne!(pixel.triangle, nearest.1, "{what}");
        // Less than a step from each other, and in one word but for what the walk adds.
        let behind = depths[1] - depths[0];
        assert!((0.0..1.0 + walked).contains(&behind), "{what}");
        let word = |d: f64| (d + 0.5).floor();
        assert!(
            word(depths[0] + walked) >= word(depths[1] - walked),
            "{what}"
        );
        let equal = word(depths[0] - walked) == word(depths[1] + walked);
        assert!(!equal || pixel.triangle < nearest.1, "{what}");
        // Each shows the surface that it shows as it should be.
        let own = colour(core, texturing, p.trace.core.wide, pixel).colour;
        assert!(apart(own.map(to_byte), pixel.rgb) <= 1, "{what}");
        let other = colour(renderer, texturing, p.trace.core.wide, pixel).colour;
        assert!(apart(other.map(to_byte), want) <= 1, "{what}");
        ties += 1;
    }
    println!("{ties} ties; the walk is off by at most {walked:.4} steps");
    assert!((1..50).contains(&ties), "{ties}");
}
