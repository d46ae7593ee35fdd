//! Clearing without stopping: drawing goes on at once, and no word of an earlier frame is ever taken for one of this.

mod support;

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::depth::pages::{pages, renewals, GENERATION_BITS, PAGE};
use shadegate_hdl::depth::pages_model::{PagesInputs, PagesModel};
use shadegate_hdl::depth::z_buffer::{ZBuffer, ZBufferInputs, ZBufferModel};
use shadegate_hdl::format::U;
use shadegate_hdl::shade::model::{CoreInputs, Order};
use shadegate_hdl::simulate::Simulator;
use std::collections::HashMap;
use support::{taken, Machine, Pixel, Triangle};

/// Clears after which a generation comes again.
const ROUND: usize = 1 << GENERATION_BITS;

/// A z-buffer, as its description or as its model.
trait Device {
    fn clock(&mut self, i: &ZBufferInputs);
    fn pass(&self) -> bool;
    fn clearing(&self) -> bool;
}

impl Device for ZBufferModel {
    fn clock(&mut self, i: &ZBufferInputs) {
        ZBufferModel::clock(self, i);
    }

    fn pass(&self) -> bool {
        ZBufferModel::pass(self)
    }

    fn clearing(&self) -> bool {
        ZBufferModel::clearing(self)
    }
}

impl<const A: usize> Device for Simulator<ZBuffer<A>> {
    fn clock(&mut self, i: &ZBufferInputs) {
        let d = &mut self.design;
        d.go.next = i.go;
        d.clear.next = i.clear;
        d.fragment.next = i.fragment;
        d.address.next = U::new(i.address);
        d.depth.next = U::new(u64::from(i.depth));
        Simulator::clock(self);
    }

    fn pass(&self) -> bool {
        self.design.pass.val()
    }

    fn clearing(&self) -> bool {
        self.design.clearing.val()
    }
}

/// What came of a run of frames.
#[derive(Default)]
struct Run {
    /// Fragments whose verdict was wrong.
    wrong: usize,
    /// Clocks that clears took beside their own, but for the first.
    waited: usize,
}

/// Draws `frames` frames, a clear before each, with as few clocks without a fragment as the pipeline allows, and judges
/// every verdict by a map that forgets at each clear. The adversary knows what is renewed next: it draws there in the
/// first clock, when the page is as old as it ever gets, and again once it has been renewed.
fn frames(device: &mut impl Device, pixels: usize, frames: usize, renewals: usize) -> Run {
    let mut r = StdRng::seed_from_u64(7);
    let mut out = Run::default();
    let idle = ZBufferInputs {
        go: true,
        ..ZBufferInputs::default()
    };
    for frame in 0..frames {
        device.clock(&ZBufferInputs {
            clear: true,
            ..idle
        });
        while device.clearing() {
            device.clock(&idle);
            out.waited += usize::from(frame > 0);
        }
        let next = frame.saturating_sub(1) * renewals % pages(pixels);
        let mut drawn = vec![];
        for place in 0..renewals {
            let cell = (next + place) % pages(pixels) * PAGE + r.random_range(0..PAGE);
            drawn.push(Some((cell, r.random_range(1..9u16))));
        }
        drawn.push(Some((r.random_range(0..pixels), r.random_range(1..9))));
        drawn.extend(vec![None; renewals]);
        for place in 0..renewals {
            let page = (next + place) % pages(pixels) * PAGE;
            drawn.extend((0..PAGE).map(|cell| Some((page + cell, 65_535))));
        }
        drawn.retain(|d| d.is_none_or(|(cell, _)| cell < pixels));
        let mut stored: HashMap<usize, u16> = HashMap::new();
        let mut want = None;
        for slot in drawn.into_iter().chain([None, None]) {
            let (address, depth) = slot.unwrap_or_default();
            device.clock(&ZBufferInputs {
                fragment: slot.is_some(),
                address: address as u64,
                depth,
                ..idle
            });
            out.wrong += usize::from(want.is_some_and(|visible| device.pass() != visible));
            want = slot.map(|_| {
                let old = stored.entry(address).or_default();
                let visible = depth > *old;
                *old = depth.max(*old);
                visible
            });
        }
    }
    out
}

#[test]
fn no_stale_word_passes_when_generations_come_round() {
    // As many pages as one renewal per frame can keep young, one more, a few, and several renewals per frame.
    for pixels in [8 * (ROUND - 1), 8 * ROUND, 24, 65_521] {
        let mut model = ZBufferModel::new(pixels);
        let run = frames(&mut model, pixels, 3 * ROUND, renewals(pixels));
        assert_eq!((run.wrong, run.waited), (0, 0), "{pixels} pixels");
    }
}

#[test]
fn one_renewal_less_than_stated_lets_stale_words_pass() {
    for (pixels, too_few) in [(8 * ROUND, 1), (65_521, 8)] {
        assert_eq!(renewals(pixels), too_few + 1);
        let pages = PagesModel::with_renewals(pixels, too_few as u64);
        let mut model = ZBufferModel::with_pages(pixels, pages);
        let run = frames(&mut model, pixels, 3 * ROUND, too_few);
        assert!(run.wrong > 0, "{pixels} pixels: the adversary finds it");
    }
}

#[test]
fn the_description_forgets_likewise() {
    const PIXELS: usize = 8 * (ROUND - 1);
    let mut s = Simulator::new(ZBuffer::<13>::new(PIXELS)).unwrap();
    let run = frames(&mut s, PIXELS, 2 * ROUND + 9, 1);
    assert_eq!((run.wrong, run.waited), (0, 0));
}

#[test]
fn a_clear_waits_for_renewals_that_are_due() {
    // Nothing but clears: in each clock another, so that renewals never come in time by themselves.
    let pixels = 65_521;
    let mut model = PagesModel::new(pixels);
    let clear = |model: &mut PagesModel| {
        let mut i = PagesInputs {
            go: true,
            clear: true,
            ..Default::default()
        };
        let mut clocks = 0;
        loop {
            model.clock(&i);
            i.clear = false;
            clocks += 1;
            if !model.clearing() {
                return clocks;
            }
        }
    };
    assert_eq!(clear(&mut model), pages(pixels) + 1, "the first one sweeps");
    assert_eq!(clear(&mut model), 1);
    for _ in 0..3 * ROUND {
        assert_eq!(clear(&mut model), renewals(pixels) + 1);
    }
}

/// The pixels of triangles after an ordinary depth test.
fn visible(m: &Machine, triangles: &[Triangle]) -> Vec<Pixel> {
    let mut stored: HashMap<(u16, u16), u16> = HashMap::new();
    let mut drawn: Vec<Pixel> = triangles
        .iter()
        .flat_map(|t| t.drawn(m.kind, m.size))
        .collect();
    drawn.retain(|p| {
        let old = stored.entry((p.x, p.y)).or_default();
        let visible = p.depth > *old;
        *old = p.depth.max(*old);
        visible
    });
    drawn
}

#[test]
fn frames_follow_each_other_without_a_pause() {
    for order in [Order::Linear, Order::Quadratic] {
        let mut r = StdRng::seed_from_u64(8);
        let mut m = Machine::new(order, 40, 30);
        let mut latency = None;
        for frame in 0..if cfg!(debug_assertions) { 20 } else { 1_200 } {
            let triangles: Vec<Triangle> = (0..r.random_range(1..4))
                .map(|_| {
                    let mut at = || (r.random_range(0.0..40.0), r.random_range(0.0..30.0));
                    let corners = [at(), at(), at()];
                    Triangle::flat(corners, r.random_range(1..40))
                })
                .filter(|t| !t.pixels(m.size).is_empty())
                .collect();
            if triangles.is_empty() {
                continue;
            }
            // The clear comes with the first words; the first one sweeps.
            m.clock(&CoreInputs {
                clear: true,
                ready: true,
                ..CoreInputs::default()
            });
            let trace = m.draw(&triangles, |_| true);
            assert_eq!(
                taken(&trace, |_| true),
                visible(&m, &triangles),
                "{order:?}, frame {frame}"
            );
            let words = triangles[0].writes(order, m.size).len();
            let span = triangles[0].raw_spans(m.size).1[0];
            if frame > 0 && span.0 < span.1 && span.0 >= 0 {
                let first = trace.iter().position(|o| o.valid).unwrap() - words;
                assert_eq!(*latency.get_or_insert(first), first, "frame {frame}");
            }
        }
        assert_eq!(latency, Some(m.kind.latency() as usize - 1));
    }
}
