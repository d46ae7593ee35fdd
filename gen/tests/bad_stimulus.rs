//! What a core cannot draw is refused by name and number, never wrapped or clamped.

use shadegate_gen::stimulus::{build, StimulusOptions, Triangle};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{Point, Viewport};

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
