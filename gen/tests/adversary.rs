//! An adversary against the gouraud and quadratic cores: triangles of up to 1024x1024 pixels and beside the frame, colours
//! of the whole range, each looking for the pixel that is farthest from the definition in f64.

#[path = "common/hunt.rs"]
mod hunt;

use hunt::{hunt, Effort, Found};
use shadegate_gen::stimulus::{build, StimulusOptions, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::{longest_run, Core};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;

/// The colour of a pixel, not rounded: by three corners, or by six knots.
fn definition(t: &Triangle, x: u16, y: u16) -> [f64; 3] {
    let p = t.position.map(|p| [f64::from(p.x), f64::from(p.y)]);
    let c = [f64::from(x) * 256.0 + 128.0, f64::from(y) * 256.0 + 128.0];
    let twice = |a: [f64; 2], b: [f64; 2], o: [f64; 2]| {
        (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])
    };
    let area = twice(p[1], p[2], p[0]);
    let [a, b, c] = [
        twice(p[1], p[2], c) / area,
        twice(p[2], p[0], c) / area,
        twice(p[0], p[1], c) / area,
    ];
    let basis = match t.knots.len() {
        3 => vec![a, b, c],
        _ => vec![
            a * (2.0 * a - 1.0),
            b * (2.0 * b - 1.0),
            c * (2.0 * c - 1.0),
            4.0 * a * b,
            4.0 * a * c,
            4.0 * b * c,
        ],
    };
    std::array::from_fn(|channel| {
        let terms = basis.iter().zip(&t.knots).map(|(w, k)| w * k[channel]);
        terms.sum::<f64>().clamp(0.0, 255.0)
    })
}

/// A triangle by genes: corners, colours.
fn grown(genes: &[f64], knots: usize, size: (u32, u32), i: usize) -> Triangle {
    let corner = |k: usize| hunt::corner(&genes[2 * k..], 0.3, size);
    let knot = |k: usize| std::array::from_fn(|c| 255.0 * genes[6 + 3 * k + c]);
    Triangle {
        position: [0, 1, 2].map(corner),
        depth: [(100 * i + 1) as f64; 3],
        knots: (0..knots).map(knot).collect(),
        material: None,
        covering: None,
        relief: None,
        label: format!("grown {i}"),
    }
}

/// What it finds on a core, in LSB beyond the rounding to a byte.
fn found(core: Core, size: (u32, u32), generations: usize, population: usize) -> Found {
    let knots = if core.order == Order::Linear { 3 } else { 6 };
    let view = Viewport {
        width: size.0,
        height: size.1,
    };
    let effort = Effort {
        genes: 6 + 3 * knots,
        generations,
        population,
    };
    hunt(effort, 71, |crowd| {
        let crowd = crowd.iter().enumerate();
        let triangles: Vec<_> = crowd.map(|(i, g)| grown(g, knots, size, i)).collect();
        let stimulus = build(&core, &triangles, view, &StimulusOptions::default());
        let trace = Trace::record(core, &stimulus.expect("in range"), |_| true);
        hunt::errors(triangles.len(), &trace.pixels, |p| {
            definition(&triangles[p.triangle], p.x, p.y)
        })
    })
}

#[test]
fn no_pixel_is_beyond_the_bound() {
    for order in [Order::Linear, Order::Quadratic] {
        for (size, generations, population) in [((1024, 1024), 4, 4), ((320, 240), 30, 12)] {
            let core = Core::for_frame(order, size.0, size.1).expect("in range");
            let found = found(core, size, generations, population);
            let bound = core.error_bound(longest_run(size.0, size.1).expect("in range"));
            println!(
                "{order:?} {size:?}: {:.4}, random {:.4}, bound {bound:.4}",
                found.worst, found.random
            );
            assert!(found.worst <= bound, "{found:?}");
        }
    }
}

/// Words that are too short for the frame are found out.
#[test]
fn narrow_words_break_the_bound_of_wide_ones() {
    let size = (1024, 1024);
    let wide = Core::for_frame(Order::Quadratic, size.0, size.1).expect("in range");
    let bound = wide.error_bound(longest_run(size.0, size.1).expect("in range"));
    let narrow = Core {
        wide: false,
        ..wide
    };
    let found = found(narrow, size, 4, 4);
    println!("{:.4}, bound of wide words {bound:.4}", found.worst);
    assert!(wide.wide && found.worst > bound, "{found:?}");
}
