//! scratch
use shadegate_gen::scene::*;
use shadegate_gen::stimulus::*;
use shadegate_gen::vectors::Trace;
use shadegate_hdl::shade::device::Core;
use shadegate_reference::raster::Viewport;
use shadegate_reference::{scene, Method, Prepared, Skips};

#[test]
fn figures() {
    for (file, method, size) in [
        ("teapot", "quadratic", None),
        ("teapot", "gouraud", None),
        ("sphere-168", "quadratic", None),
        ("sphere-168", "slerp", None),
        ("sphere-168", "spherical-cos2-rom6", None),
        ("sphere-168", "blake", None),
        ("sphere-690", "slerp", None),
        ("sphere-690", "slerp", Some((640, 480))),
        ("sphere-690", "blake", Some((640, 480))),
        ("sphere-374", "slerp", None),
        ("sphere-168", "slerp", Some((640, 480))),
    ] {
        let method: Method = method.parse().unwrap();
        let s = scene::load(std::path::Path::new(&format!("../scenes/{file}.toml"))).unwrap();
        let (width, height) = size.unwrap_or((s.image.width, s.image.height));
        let prepared = Prepared::new(&s, Some((width, height)), &Skips::all()).unwrap();
        let triangles = triangles_of(&prepared, method);
        let mut core = Core::for_frame(order_of(method).unwrap(), width, height).unwrap();
        let stim = build(
            &core,
            &triangles,
            Viewport { width, height },
            &StimulusOptions::default(),
        )
        .unwrap();
        for w in [1, 2, 4] {
            core.load_words = w;
            let t = Trace::record(core, &stim, |_| true);
            println!("{file} {} {width} W{w}: prims {} tri {} pixels {} cycles {} ppc {:.3} {:?} writes {} sum {}", method.name(), stim.primitives.len(), triangles.len(), t.pixels.len(), t.cycles,
                t.pixels.len() as f64 / t.cycles as f64, t.spent, t.writes, t.spent.total());
        }
    }
}
