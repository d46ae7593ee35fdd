//! What a host may do at the wrong time: writes, starts and clears that come too early are ignored.

mod support;

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_hdl::depth::pages::pages;
use shadegate_hdl::shade::model::{CoreInputs, Order};
use support::{check_done, taken, Machine, Pixel, Triangle};

const WIDTH: u32 = 40;
const HEIGHT: u32 = 30;

fn large(depth: u16) -> Triangle {
    Triangle::flat([(0.0, 0.0), (40.0, 0.0), (0.0, 30.0)], depth)
}

fn small(depth: u16) -> Triangle {
    Triangle::flat([(20.0, 5.0), (39.0, 8.0), (25.0, 29.0)], depth)
}

#[test]
fn writes_and_starts_while_not_ready_are_ignored() {
    for order in [Order::Quadratic, Order::Linear] {
        let mut m = Machine::new(order, WIDTH, HEIGHT);
        let mut r = StdRng::seed_from_u64(1);
        let triangles = [large(1000), small(2000), large(3000)];
        let mut words = vec![];
        for t in &triangles {
            let w = t.writes(order, m.size);
            let last = w.len() - 1;
            words.extend(w.into_iter().enumerate().map(|(i, w)| (w, i == last)));
        }
        let mut words = words.into_iter();
        let (mut trace, mut ignored) = (vec![m.outputs()], 0);
        for _ in 0..5000 {
            let o = m.outputs();
            let mut i = CoreInputs {
                ready: true,
                ..CoreInputs::default()
            };
            if !o.load_ready {
                // Any word, the frame width included.
                i.write = true;
                i.start = r.random();
                i.select = if r.random() { 11 } else { r.random() };
                i.data = r.random();
                ignored += 1;
            } else if let Some(((select, data), start)) = words.next() {
                i.write = true;
                (i.select, i.data, i.start) = (select, data, start);
            }
            m.clock(&i);
            trace.push(m.outputs());
        }
        assert!(ignored > 100, "the host must have waited: {ignored}");
        let want: Vec<Pixel> = triangles
            .iter()
            .flat_map(|t| t.drawn(m.kind, m.size))
            .collect();
        assert_eq!(taken(&trace, |_| true), want, "{order:?}");
        assert!(!m.outputs().busy);
        assert_eq!(check_done(&trace), 1);
    }
}

fn clear(m: &mut Machine, with: CoreInputs) -> usize {
    m.clock(&CoreInputs {
        clear: true,
        ready: true,
        ..with
    });
    let (mut clocks, mut trace) = (0, vec![m.outputs()]);
    while m.outputs().busy {
        clocks += 1;
        m.idle();
        trace.push(m.outputs());
        assert!(clocks < 1_000_000);
    }
    check_done(&trace);
    clocks
}

#[test]
fn only_the_first_clear_takes_time_and_each_forgets_everything() {
    for (width, height) in [(WIDTH, HEIGHT), (3, 1), (33, 17)] {
        let mut m = Machine::new(Order::Linear, width, height);
        let (w, h) = (f64::from(width), f64::from(height));
        let halves = |depth| {
            [
                Triangle::flat([(0.0, 0.0), (w, 0.0), (0.0, h)], depth),
                Triangle::flat([(w, 0.0), (w, h), (0.0, h)], depth),
            ]
        };
        let pixels = (width * height) as usize;
        let visible = |m: &mut Machine, depth| {
            let trace = m.draw(&halves(depth), |_| true);
            check_done(&trace);
            taken(&trace, |_| true).len()
        };
        assert_eq!(visible(&mut m, 65535), pixels);
        assert_eq!(visible(&mut m, 65535), 0, "equal depth, the first wins");
        for clocks in [pages(pixels), 1, 1] {
            assert_eq!(clear(&mut m, CoreInputs::default()), clocks);
            assert_eq!(visible(&mut m, 0), 0, "depth 0 is nothing");
            assert_eq!(visible(&mut m, 1), pixels, "every depth test passes again");
            assert_eq!(visible(&mut m, 1), 0);
        }
    }
}

#[test]
fn clear_while_busy_is_ignored() {
    let order = Order::Linear;
    let mut m = Machine::new(order, WIDTH, HEIGHT);
    let draw = |m: &mut Machine, t: &Triangle, clear_while_busy: bool| {
        let words = t.writes(order, m.size);
        let mut words = words.iter().enumerate();
        let last = words.len() - 1;
        let mut trace = vec![];
        for _ in 0..3000 {
            let o = m.outputs();
            trace.push(o);
            let mut i = CoreInputs {
                ready: true,
                clear: clear_while_busy && o.busy,
                ..CoreInputs::default()
            };
            if let Some((n, w)) = words.next() {
                i.write = true;
                (i.select, i.data, i.start) = (w.0, w.1, n == last);
            }
            m.clock(&i);
        }
        assert_eq!(check_done(&trace), 1);
        taken(&trace, |_| true)
    };
    let t = large(1000);
    assert_eq!(draw(&mut m, &t, true), t.drawn(m.kind, m.size));
    assert_eq!(draw(&mut m, &large(999), true), vec![]);
    assert_eq!(draw(&mut m, &large(1000), false), vec![]);
    // Clearing again while clearing does not prolong it.
    m.clock(&CoreInputs {
        clear: true,
        ..CoreInputs::default()
    });
    let clocks = pages((WIDTH * HEIGHT) as usize);
    for clock in 0..clocks {
        assert!(m.outputs().busy, "clock {clock}");
        m.clock(&CoreInputs {
            clear: clock < clocks - 1,
            ..CoreInputs::default()
        });
    }
    assert!(!m.outputs().busy && m.outputs().done);
}

#[test]
fn a_triangle_started_while_clearing_is_drawn_afterwards() {
    for order in [Order::Quadratic, Order::Linear] {
        let mut m = Machine::new(order, WIDTH, HEIGHT);
        m.draw(&[large(60_000)], |_| true);
        // Words and start arrive during the clearing.
        m.clock(&CoreInputs {
            clear: true,
            ..CoreInputs::default()
        });
        let trace = m.draw(&[large(5)], |_| true);
        assert_eq!(taken(&trace, |_| true), large(5).drawn(m.kind, m.size));
        let first = trace.iter().position(|o| o.valid).unwrap();
        assert!(first > pages((WIDTH * HEIGHT) as usize), "{first}");
        assert_eq!(check_done(&trace), 1);
        // Start and clear in the same clock.
        let words = large(7).writes(order, m.size);
        for (select, data) in &words[1..] {
            m.clock(&CoreInputs {
                write: true,
                select: *select,
                data: *data,
                ready: true,
                ..CoreInputs::default()
            });
        }
        m.clock(&CoreInputs {
            write: true,
            select: words[0].0,
            data: words[0].1,
            start: true,
            clear: true,
            ready: true,
            ..CoreInputs::default()
        });
        let trace = m.draw(&[], |_| true);
        assert_eq!(taken(&trace, |_| true), large(7).drawn(m.kind, m.size));
    }
}

#[test]
fn done_pulses_once_per_idle_transition() {
    for order in [Order::Quadratic, Order::Linear] {
        let mut m = Machine::new(order, WIDTH, HEIGHT);
        let mut trace = vec![m.outputs()];
        let mut times = 0;
        for depth in 1..20u16 {
            let words = large(depth * 100).writes(order, m.size);
            for (n, w) in words.iter().enumerate() {
                m.clock(&CoreInputs {
                    write: true,
                    select: w.0,
                    data: w.1,
                    start: n == words.len() - 1,
                    clear: false,
                    ready: true,
                    ..CoreInputs::default()
                });
                trace.push(m.outputs());
            }
            times += 1;
            for clock in 0..1500usize {
                m.clock(&CoreInputs {
                    ready: clock % usize::from(depth) == 0,
                    clear: clock == 1400,
                    ..CoreInputs::default()
                });
                trace.push(m.outputs());
            }
            while m.outputs().busy {
                m.idle();
                trace.push(m.outputs());
            }
        }
        assert!(check_done(&trace) >= times);
    }
}
