//! The z-buffer's hazard: a pixel that is tested again in the very next clock, while its depth is being written.

mod support;

use shadegate_hdl::depth::z_buffer::ZBuffer;
use shadegate_hdl::format::U;
use shadegate_hdl::shade::model::{CoreInputs, Order};
use shadegate_hdl::simulate::Simulator;
use support::{depth_code, taken, Machine, Triangle};

struct Bench(Simulator<ZBuffer<5>>);

impl Bench {
    fn new() -> Self {
        Self(Simulator::new(ZBuffer::new(24)).unwrap())
    }

    /// One clock with a fragment or none; the verdict on it.
    fn test(&mut self, fragment: Option<(u64, u64)>) -> bool {
        let d = &mut self.0.design;
        let (address, depth) = fragment.unwrap_or_default();
        d.go.next = true;
        d.clear.next = false;
        d.fragment.next = fragment.is_some();
        d.address.next = U::new(address);
        d.depth.next = U::new(depth);
        self.0.clock();
        assert_eq!(self.0.design.waiting.val(), fragment.is_some());
        self.0.design.pass.val()
    }

    /// A clock in which the pipeline stands still, with noise at the inputs; the verdict must wait.
    fn stall(&mut self) -> bool {
        let d = &mut self.0.design;
        d.go.next = false;
        d.fragment.next = true;
        d.address.next = U::new(3);
        d.depth.next = U::new(65535);
        self.0.clock();
        self.0.design.pass.val()
    }
}

/// Depths and verdicts on one pixel: nearer, farther, equal, nearer, equal, last value.
const STORY: [(u64, bool); 8] = [
    (5, true),
    (9, true),
    (7, false),
    (9, false),
    (10, true),
    (10, false),
    (65535, true),
    (65535, false),
];

#[test]
fn the_same_pixel_in_consecutive_clocks() {
    let mut b = Bench::new();
    for (depth, visible) in STORY {
        assert_eq!(b.test(Some((3, depth))), visible, "{depth}");
    }
}

#[test]
fn with_stalls_between() {
    for stalls in 1..4 {
        let mut b = Bench::new();
        for (depth, visible) in STORY {
            assert_eq!(b.test(Some((3, depth))), visible, "{depth}");
            for _ in 0..stalls {
                assert_eq!(b.stall(), visible, "{depth} is held");
            }
        }
    }
}

#[test]
fn with_gaps_and_other_pixels_between() {
    for gap in 0..3 {
        let mut b = Bench::new();
        for (depth, visible) in STORY {
            for other in [23, 0] {
                assert_eq!(b.test(Some((other, depth))), visible, "{depth} at {other}");
            }
            for _ in 0..gap {
                assert!(!b.test(None));
            }
        }
    }
}

#[test]
fn a_fragment_that_failed_is_not_forwarded() {
    let mut b = Bench::new();
    assert!(b.test(Some((4, 100))));
    assert!(!b.test(Some((4, 50))));
    assert!(!b.test(Some((4, 60))), "compared with 100, not with 50");
    assert!(b.test(Some((4, 101))));
    // A gap carries the address and depth of no fragment.
    assert!(!b.test(None));
    assert!(b.test(Some((0, 1))), "address 0 after a gap at address 0");
}

/// Through a whole core: triangles of one pixel piled up by back pressure reach the depth test in consecutive steps.
#[test]
fn one_pixel_drawn_again_and_again() {
    for order in [Order::Quadratic, Order::Linear] {
        for period in 1..6 {
            let mut m = Machine::new(order, 8, 8);
            let pixel = Triangle::flat([(2.0, 2.0), (3.4, 2.0), (2.0, 3.4)], 1);
            assert_eq!(pixel.pixels(m.size), [(2, 2)]);
            for (select, data) in pixel.writes(order, m.size) {
                m.clock(&CoreInputs {
                    write: true,
                    select,
                    data,
                    ..CoreInputs::default()
                });
            }
            // Only the depth's first word changes from triangle to triangle; a busy pixel first, so that it stalls.
            let story = [(1, true)].into_iter().chain(STORY);
            let mut trace = vec![];
            let mut depths = story.clone();
            for t in 0..200 {
                let o = m.outputs();
                trace.push(o);
                let mut i = CoreInputs {
                    ready: t % period == 0,
                    ..CoreInputs::default()
                };
                if o.load_ready {
                    if let Some((depth, _)) = depths.next() {
                        (i.write, i.start) = (true, true);
                        (i.select, i.data) = (0x80, depth_code(depth as u16) as u64);
                    }
                }
                m.clock(&i);
            }
            assert!(!m.outputs().busy);
            let got: Vec<u64> = taken(&trace, |t| t % period == 0)
                .iter()
                .map(|p| u64::from(p.depth))
                .collect();
            let want: Vec<u64> = story.filter(|s| s.1).map(|s| s.0).collect();
            assert_eq!(got, want, "{order:?}, ready every {period} clocks");
        }
    }
}
