//! The z-buffer's hazards: a pixel that is tested again in one of the next two clocks, while its depth is on its way.

mod support;

use shadegate_hdl::depth::z_buffer::ZBuffer;
use shadegate_hdl::format::U;
use shadegate_hdl::shade::model::{CoreInputs, Order};
use shadegate_hdl::simulate::Simulator;
use support::{depth_code, taken, Machine, Triangle};

/// A z-buffer, and the verdict that the fragment of the clock before must get.
struct Bench(Simulator<ZBuffer<5>>, Option<bool>);

impl Bench {
    fn new() -> Self {
        Self(Simulator::new(ZBuffer::new(24)).unwrap(), None)
    }

    /// One clock with a fragment and its verdict, or none.
    fn test(&mut self, fragment: Option<(u64, u64, bool)>) {
        let d = &mut self.0.design;
        let (address, depth, _) = fragment.unwrap_or_default();
        d.go.next = true;
        d.clear.next = false;
        d.fragment.next = fragment.is_some();
        d.address.next = U::new(address);
        d.depth.next = U::new(depth);
        self.0.clock();
        let want = self.1;
        assert_eq!(self.0.design.pass.val(), want == Some(true), "{fragment:?}");
        self.1 = fragment.map(|f| f.2);
        assert_eq!(
            self.0.design.waiting.val(),
            want.is_some() || fragment.is_some()
        );
    }

    /// A clock in which the pipeline stands still, with noise at the inputs; the verdict must wait.
    fn stall(&mut self) {
        let before = self.0.design.pass.val();
        let d = &mut self.0.design;
        d.go.next = false;
        d.fragment.next = true;
        d.address.next = U::new(3);
        d.depth.next = U::new(65535);
        self.0.clock();
        assert_eq!(self.0.design.pass.val(), before, "the verdict is held");
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
        b.test(Some((3, depth, visible)));
    }
    b.test(None);
}

#[test]
fn with_stalls_between() {
    for stalls in 1..4 {
        let mut b = Bench::new();
        for (depth, visible) in STORY {
            b.test(Some((3, depth, visible)));
            for _ in 0..stalls {
                b.stall();
            }
        }
        b.test(None);
    }
}

#[test]
fn with_gaps_and_other_pixels_between() {
    for gap in 0..4 {
        for others in [&[][..], &[23], &[2, 0], &[23, 0, 4]] {
            let mut b = Bench::new();
            for (depth, visible) in STORY {
                b.test(Some((3, depth, visible)));
                for other in others {
                    b.test(Some((*other, depth, visible)));
                }
                for _ in 0..gap {
                    b.test(None);
                }
            }
            b.test(None);
        }
    }
}

#[test]
fn a_fragment_that_failed_is_not_forwarded() {
    let mut b = Bench::new();
    b.test(Some((4, 100, true)));
    b.test(Some((4, 50, false)));
    // Compared with 100, not with 50.
    b.test(Some((4, 60, false)));
    b.test(Some((4, 101, true)));
    // A gap carries the address and depth of no fragment, and depth 0 is nothing.
    b.test(None);
    b.test(Some((0, 1, true)));
    b.test(Some((1, 0, false)));
    b.test(Some((1, 1, true)));
    b.test(None);
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
