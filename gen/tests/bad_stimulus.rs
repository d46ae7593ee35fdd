//! What a core cannot draw is refused by name and number, never wrapped or clamped.

use shadegate_gen::stimulus::{build, Covering, Picture, StimulusOptions, Triangle};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::texture::{Mapping, Texturing};
use shadegate_reference::raster::{Point, Viewport};
use std::sync::Arc;

const VIEW: Viewport = Viewport {
    width: 320,
    height: 240,
};

fn good() -> Triangle {
    let p = |x, y| Point {
        x: x * 256,
        y: y * 256,
    };
    Triangle {
        position: [p(10, 10), p(60, 20), p(20, 90)],
        depth: [1.0, 2.0, 3.0],
        knots: vec![[10.0; 3]; 6],
        material: None,
        covering: None,
        relief: None,
        label: "object 2, face 7".into(),
    }
}

fn refused(change: impl Fn(&mut Triangle)) -> String {
    let core = Core::for_frame(Order::Quadratic, 320, 240).expect("in range");
    let mut t = good();
    build(&core, &[t.clone()], VIEW, &StimulusOptions::default()).expect("good");
    change(&mut t);
    build(&core, &[good(), t], VIEW, &StimulusOptions::default())
        .expect_err("bad")
        .to_string()
}

#[test]
fn each_limit_has_its_line() {
    assert_eq!(
        refused(|t| t.position[1].x = 3000 * 256),
        "triangle 1 (object 2, face 7): column 3000.00 is outside the core's walk columns -2047 to 2046"
    );
    assert_eq!(
        refused(|t| t.position[2].y = 2060 * 256),
        "triangle 1 (object 2, face 7): 2050 rows high; the core's edges have at most 2048"
    );
    assert_eq!(
        refused(|t| t.knots[4][1] = f64::NAN),
        "triangle 1 (object 2, face 7): colour knot NaN is outside 0 to 1530"
    );
    assert_eq!(
        refused(|t| t.knots[0][0] = 1531.0),
        "triangle 1 (object 2, face 7): colour knot 1531 is outside 0 to 1530"
    );
    assert_eq!(
        refused(|t| t.depth[0] = -1.0),
        "triangle 1 (object 2, face 7): depth -1 is outside 0 to 65535"
    );
    assert_eq!(
        refused(|t| t.knots.truncate(3)),
        "triangle 1 (object 2, face 7): 3 colour knots where the core takes 6"
    );
}

#[test]
fn frames_beyond_the_coordinates_have_no_core() {
    for (w, h) in [
        (2041, 10),
        (10, 1025),
        (2040, 1025),
        (u32::MAX, u32::MAX),
        (1, 1),
    ] {
        assert_eq!(Core::for_frame(Order::Quadratic, w, h), None, "{w}x{h}");
    }
    for (w, h) in [(2040, 1024), (2, 1), (1, 2), (1024, 1024)] {
        assert!(Core::for_frame(Order::Quadratic, w, h).is_some(), "{w}x{h}");
    }
}

/// A textured triangle, changed, for a core with this mapping.
fn covered(mapping: Mapping, change: impl Fn(&mut Covering)) -> Result<(), String> {
    let texturing = Texturing {
        mapping,
        texels_log2: 5,
    };
    let core = Core::for_frame(Order::Textured(texturing), 320, 240).expect("in range");
    let knots = if mapping == Mapping::Quadratic { 6 } else { 3 };
    let mut covering = Covering {
        picture: Arc::new(Picture {
            width: 8,
            height: 4,
            texels: vec![[7; 3]; 32],
        }),
        nearest: false,
        address: vec![[5.0, 900.0, 0.25]; knots],
    };
    change(&mut covering);
    let t = Triangle {
        covering: Some(covering),
        ..good()
    };
    build(&core, &[t], VIEW, &StimulusOptions::default())
        .map(|_| ())
        .map_err(|e| e.to_string())
}

#[test]
fn textures_have_their_limits() {
    use Mapping::{Affine, Perspective, Quadratic};
    for mapping in [Affine, Quadratic, Perspective] {
        covered(mapping, |_| {}).expect("good");
        // Whole pictures are taken off.
        let far = |c: &mut Covering| c.address.iter_mut().for_each(|a| a[0] += 8e5);
        covered(mapping, far).expect("good");
        let bad = |change: &dyn Fn(&mut Covering)| covered(mapping, change).expect_err("bad");
        assert!(bad(&|c| c.address[1][0] = f64::NAN).contains("spans more than"));
        assert!(bad(&|c| c.address[1][1] = 1e6).contains("spans more than"));
        assert!(bad(&|c| {
            c.address.pop();
        })
        .contains("addresses where the core takes"));
        let picture = |width: usize, height: usize| {
            let texels = vec![[0; 3]; width * height];
            Arc::new(Picture {
                width,
                height,
                texels,
            })
        };
        assert!(bad(&|c| c.picture = picture(6, 4)).contains("a picture of 6x4 texels"));
        assert!(bad(&|c| c.picture = picture(8, 8))
            .contains("take 64 texels and the texture memory has 32"));
    }
    let ratio = |w: f64| covered(Perspective, |c| c.address[2][2] = w);
    ratio(0.25 / 30_000.0).expect("good");
    for w in [0.25 / 33_000.0, 0.0, -1.0, f64::NAN] {
        let message = ratio(w).expect_err("bad");
        assert!(message.contains("ratio of more than 32000"), "{message}");
    }
}
