//! The compact unit draws what the quadratic core draws, pixel for pixel and in the same order; with the word lengths of
//! triangles of 512 pixels every byte is within one of the definition; and its rate.

use shadegate_gen::compact::words;
use shadegate_gen::stimulus::{build, sample_triangles, Stimulus, StimulusOptions, Triangle};
use shadegate_gen::vectors::Trace;
use shadegate_hdl::compact::{CompactInputs, CompactModel};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::{Point, Viewport};
use shadegate_reference::shade::barycentric::weights;

fn every_word() -> StimulusOptions {
    StimulusOptions {
        skip_unchanged: false,
        broadcast: false,
        ..StimulusOptions::default()
    }
}

type Pixel = (u16, u16, [u8; 3]);

/// The pixels that a unit offers, and the clocks that it took.
fn draw(
    mut unit: CompactModel,
    stimulus: &Stimulus,
    width: u32,
    dropped: u32,
) -> (Vec<Pixel>, u64) {
    let mut writes: Vec<(u8, u32, bool)> = vec![(11, width, false)];
    for t in &stimulus.primitives {
        let words = words(t, dropped);
        let last = words.len() - 1;
        writes.extend(words.iter().enumerate().map(|(i, w)| (w.0, w.1, i == last)));
    }
    let (mut pixels, mut clocks, mut next) = (vec![], 0u64, 0);
    loop {
        let o = unit.outputs();
        let mut i = CompactInputs {
            ready: clocks % 11 != 5,
            ..CompactInputs::default()
        };
        match writes.get(next) {
            Some((select, data, start)) if o.load_ready => {
                (i.write, i.select, i.data, i.start) = (true, *select, *data, *start);
                next += 1;
            }
            None if !o.busy => return (pixels, clocks),
            _ => {}
        }
        if o.valid && i.ready {
            pixels.push((o.x as u16, o.y as u16, o.rgb));
        }
        unit.clock(&i);
        clocks += 1;
    }
}

#[test]
fn pixel_for_pixel_the_quadratic_core() {
    let viewport = Viewport {
        width: 120,
        height: 90,
    };
    let core = Core::for_frame(Order::Quadratic, 120, 90).expect("in range");
    let mut triangles = sample_triangles(Order::Quadratic, viewport, 300, 7);
    // Each nearer than all before, so that the depth test passes everything.
    for (i, t) in triangles.iter_mut().enumerate() {
        t.depth = [1000.0 + 100.0 * i as f64; 3];
    }
    let stimulus = build(&core, &triangles, viewport, &every_word()).expect("in range");
    let trace = Trace::record(core, &stimulus, |_| true);
    let want: Vec<Pixel> = trace.pixels.iter().map(|p| (p.x, p.y, p.rgb)).collect();
    assert!(want.len() > 20_000, "{}", want.len());
    let (got, _) = draw(CompactModel::new(11, 20, 20), &stimulus, 120, 0);
    let differs = want.iter().zip(&got).position(|(a, b)| a != b);
    assert_eq!((differs, got.len()), (None, want.len()));
}

fn triangle(corners: [(i32, i32); 3], colours: [f64; 6]) -> Triangle {
    Triangle {
        position: corners.map(|(x, y)| Point { x, y }),
        depth: [30_000.0; 3],
        knots: colours.map(|c| [c, 255.0 - c, c / 2.0]).to_vec(),
        material: None,
        covering: None,
        relief: None,
        label: String::new(),
    }
}

#[test]
fn short_words_are_faithful_over_512_pixels() {
    let core = Core {
        order: Order::Quadratic,
        wide: false,
        pixels: 1 << 17,
        load_words: 1,
    };
    let viewport = Viewport {
        width: 512,
        height: 512,
    };
    // Steep and flat, left and right, thin ones; knots that swing over the whole range.
    let corners = [
        [(0, 0), (512 * 256, 100), (40, 512 * 256)],
        [(512 * 256, 3), (0, 512 * 256 - 7), (512 * 256, 512 * 256)],
        [(0, 0), (512 * 256, 512 * 256), (505 * 256, 512 * 256)],
        [
            (256 * 256, 0),
            (255 * 256 + 77, 512 * 256),
            (0, 400 * 256 + 9),
        ],
        [(33, 51), (512 * 256, 700), (300 * 256, 1400)],
    ];
    let knots = [
        [0.0, 255.0, 0.0, 255.0, 0.0, 255.0],
        [255.0, 255.0, 0.0, 0.0, 128.0, 255.0],
        [3.0, 250.0, 121.0, 77.0, 31.0, 200.0],
    ];
    let mut worst = 0.0f64;
    let mut total = 0;
    for at in corners {
        for colours in knots {
            let t = triangle(at, colours);
            let one = std::slice::from_ref(&t);
            let stimulus = build(&core, one, viewport, &every_word()).expect("in range");
            let (pixels, _) = draw(CompactModel::new(8, 20, 11), &stimulus, 512, 9);
            total += pixels.len();
            for (x, y, rgb) in pixels {
                let w = weights(&t.position, i32::from(x), i32::from(y));
                for (c, byte) in rgb.into_iter().enumerate() {
                    let k = |i: usize| t.knots[i][c];
                    let corner = |i: usize| w[i] * (2.0 * w[i] - 1.0) * k(i);
                    let middle = |i: usize, a: usize, b: usize| 4.0 * w[a] * w[b] * k(i);
                    let f = corner(0) + corner(1) + corner(2);
                    let f = f + middle(3, 0, 1) + middle(4, 0, 2) + middle(5, 1, 2);
                    worst = worst.max((f.clamp(0.0, 255.0) - f64::from(byte)).abs());
                }
            }
        }
    }
    println!("{total} pixels, {worst:.3} LSB with the rounding to bytes");
    assert!(total > 900_000 && worst > 0.5 && worst <= 1.5, "{worst}");
}

/// Pixels per clock beside the quadratic core's, by size of triangle.
#[test]
fn the_rate_by_size_of_triangle() {
    let viewport = Viewport {
        width: 320,
        height: 240,
    };
    let core = Core::for_frame(Order::Quadratic, 320, 240).expect("in range");
    for (legs, least) in [(6, 0.2), (14, 0.6), (32, 0.85), (100, 0.93)] {
        let one = |i: i32| {
            let (x, y) = (i * 256 % (180 * 256), i * 77 % (120 * 256));
            let leg = legs * 256;
            let mut t = triangle([(x, y), (x + leg, y), (x, y + leg)], [9.0; 6]);
            t.depth = [1000.0 + 100.0 * f64::from(i); 3];
            t
        };
        let triangles: Vec<_> = (0..200).map(one).collect();
        let stimulus = build(&core, &triangles, viewport, &every_word()).expect("in range");
        let trace = Trace::record(core, &stimulus, |clock| clock % 11 != 5);
        let full = trace.pixels.len() as f64 / trace.cycles as f64;
        let (pixels, clocks) = draw(CompactModel::new(11, 20, 20), &stimulus, 320, 0);
        let rate = pixels.len() as f64 / clocks as f64;
        let each = pixels.len() / 200;
        // The consumer takes ten pixels in eleven clocks.
        println!(
            "{each} pixels: {:.3} a clock, quadratic core {:.3}",
            rate * 1.1,
            full * 1.1
        );
        assert!(rate * 1.1 > least && rate * 1.1 <= 1.001, "{each}: {rate}");
    }
}
