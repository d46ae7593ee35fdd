//! Stalls on both sides at once: a host that pauses whenever it likes and a consumer that takes a pixel whenever it likes
//! get the pixels of a run without pauses, in that order, from every core of the catalogue and through every load port.
//! Description, compiled netlist and integer model agree in every clock of it.

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::compile::CompiledCore;
use shadegate_gen::scene::catalogue;
use shadegate_gen::stimulus::{sample, Host, Step, Stimulus};
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs};
use shadegate_reference::raster::Viewport;

const SIZE: Viewport = Viewport {
    width: 32,
    height: 24,
};

/// A pixel: place, colour, depth.
type Pixel = (u16, u16, [u8; 3], u16);

fn offered(o: &CoreOutputs) -> Pixel {
    (o.x, o.y, o.rgb, o.depth)
}

/// What a run gave.
#[derive(Default)]
struct Drawn {
    pixels: Vec<Pixel>,
    clocks: usize,
    /// Clocks in which a pixel waited, and in which the core did while the host paused.
    waits: [usize; 2],
}

/// Draws with a host that acts in `host` of ten clocks and a consumer that is ready in `ready` of ten.
fn draw(core: Core, stimulus: &Stimulus, [host, ready]: [u32; 2], seed: u64) -> Drawn {
    let name = core.name();
    let mut r = StdRng::seed_from_u64(seed);
    let mut description = CoreSimulator::new(core).expect("connects");
    let mut compiled = CompiledCore::new(core).expect("compiles");
    let mut model = core.model();
    let mut writer = Host::with_lanes(stimulus, core.load_words);
    let mut out = Drawn::default();
    let mut waiting = None;
    loop {
        let o = model.outputs();
        assert_eq!(description.outputs(), o, "{name}, clock {}", out.clocks);
        assert_eq!(compiled.outputs(), o, "{name}, clock {}", out.clocks);
        if let Some(before) = waiting {
            assert_eq!((o.valid, offered(&o)), (true, before), "{name}: moved");
        }
        let ready = r.random_ratio(ready, 10);
        let inputs = if !r.random_ratio(host, 10) {
            out.waits[1] += usize::from(o.load_ready && !writer.sent());
            CoreInputs {
                ready,
                ..CoreInputs::default()
            }
        } else {
            match writer.step(&o, ready) {
                Step::Drive(inputs) => inputs,
                Step::Finished => return out,
            }
        };
        waiting = (o.valid && !ready).then(|| offered(&o));
        out.waits[0] += usize::from(waiting.is_some());
        if o.valid && ready {
            out.pixels.push(offered(&o));
        }
        description.clock(&inputs);
        compiled.clock(&inputs);
        model.clock(&inputs);
        out.clocks += 1;
    }
}

#[test]
fn every_core_under_stalls_on_both_sides() {
    for (name, order) in catalogue() {
        let core = Core::for_frame(order, SIZE.width, SIZE.height).expect("in range");
        let ports = Core::LOAD_WORDS.map(|words| core.with_load_words(words).ok());
        for core in ports.into_iter().flatten() {
            let words = core.load_words;
            let stimulus = sample(&core, SIZE, 16, 5).expect("set up");
            let free = draw(core, &stimulus, [10, 10], 0);
            assert!(free.pixels.len() > 100, "{name}: {}", free.pixels.len());
            assert_eq!(free.waits, [0, 0], "{name}");
            for (seed, pauses) in [[5, 5], [9, 2], [2, 9]].into_iter().enumerate() {
                let held = draw(core, &stimulus, pauses, seed as u64 + 1);
                assert!(
                    held.pixels == free.pixels,
                    "{name}, {words} words, {pauses:?}"
                );
                assert!(held.clocks > free.clocks, "{name}, {pauses:?}");
                assert!(
                    held.waits.iter().all(|w| *w > 0),
                    "{name}: {:?}",
                    held.waits
                );
            }
        }
    }
}
