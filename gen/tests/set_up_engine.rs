//! The set-up engine's words against the host's exact ones.

use shadegate_gen::setup::{fixed_knot, plane_words, quadric_words, shell_words, Frame};
use shadegate_hdl::set_up::{EngineInputs, EngineModel};
use shadegate_reference::raster::{Point, Viewport, Walk};

const SIZE: Viewport = Viewport {
    width: 320,
    height: 240,
};

struct Lcg(u64);
impl Lcg {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) % n
    }
    fn within(&mut self, low: i64, high: i64) -> i64 {
        low + self.below((high - low + 1) as u64) as i64
    }
}

#[derive(Clone, Debug)]
struct Raw {
    position: [Point; 3],
    depth: [i64; 3],
    knots: [[i64; 6]; 3],
}

fn run(engine: &mut EngineModel, t: &Raw) -> (Option<Vec<(u8, u64)>>, usize) {
    let mut writes = vec![];
    for i in 0..3 {
        writes.push((i as u8, t.position[i].x as u64));
        writes.push((4 + i as u8, t.position[i].y as u64));
        writes.push((8 + i as u8, t.depth[i] as u64));
        for c in 0..3 {
            writes.push((16 + 8 * c as u8 + i as u8, t.knots[c][i] as u64));
            // Opposite vertex 0 is 12, 1: 02, 2: 01.
            writes.push((20 + 8 * c as u8 + i as u8, t.knots[c][5 - i] as u64));
        }
    }
    let last = writes.len() - 1;
    for (k, write) in writes.into_iter().enumerate() {
        engine.clock(&EngineInputs {
            write: Some(write),
            start: k == last,
            ready: true,
            ..Default::default()
        });
    }
    let mut words = vec![];
    for clock in 0.. {
        let o = engine.outputs();
        words.extend(o.word);
        if o.skip {
            return (None, clock);
        }
        if o.start {
            engine.clock(&EngineInputs {
                ready: true,
                ..Default::default()
            });
            return (Some(words), clock);
        }
        engine.clock(&EngineInputs {
            ready: true,
            ..Default::default()
        });
    }
    unreachable!()
}

#[test]
fn words() {
    let mut e = EngineModel::new(20, 32);
    e.clock(&EngineInputs {
        frame: Some((11, 320)),
        ..Default::default()
    });
    e.clock(&EngineInputs {
        frame: Some((12, 240)),
        ..Default::default()
    });
    println!("program {}", e.length());
    let mut r = Lcg(5);
    let mut worst = [0i64; 40];
    let mut skipped = 0;
    for n in 0..3000 {
        let p = |r: &mut Lcg| Point {
            x: r.within(-160 * 256, 480 * 256) as i32,
            y: r.within(-120 * 256, 360 * 256) as i32,
        };
        let mut position = [p(&mut r), p(&mut r), p(&mut r)];
        if n % 3 == 1 {
            position[2] = Point {
                x: position[0].x + r.within(-600, 600) as i32,
                y: position[0].y + r.within(-600, 600) as i32,
            };
        }
        if n % 3 == 2 {
            let f = r.within(0, 1000) as i32;
            position[2] = Point {
                x: position[0].x
                    + ((position[1].x - position[0].x) as i64 * f as i64 / 1000) as i32
                    + r.within(-2, 2) as i32,
                y: position[0].y
                    + ((position[1].y - position[0].y) as i64 * f as i64 / 1000) as i32
                    + r.within(-2, 2) as i32,
            };
        }
        let t = Raw {
            position,
            depth: [0; 3].map(|_| r.within(0, 65535 * 64)),
            knots: [0; 3].map(|_| [0; 6].map(|_| r.within(0, 255 * 1024))),
        };
        let (got, clocks) = run(&mut e, &t);
        if n == 0 {
            println!("clocks {clocks}");
        }
        let walk = Walk::new(t.position, SIZE);
        let Some(walk) = walk else {
            assert!(got.is_none());
            skipped += 1;
            continue;
        };
        let got = got.expect("drawn");
        let want = shell_words(t.position, &walk, 320).unwrap();
        let of = |select: u8| got.iter().find(|w| w.0 == select).expect("sent").1;
        for (k, w) in want.iter().enumerate() {
            let m = if k % 3 == 1 && k > 1 {
                (1 << 20) - 1
            } else {
                u64::MAX
            };
            if walk.upper_rows == walk.rows && k >= 8 {
                continue;
            }
            assert_eq!(of(k as u8) & m, *w, "word {k} of {t:?} {walk:?}");
        }
        let frame = Frame::new(t.position, &walk);
        for c in 0..3 {
            let knots = t.knots[c].map(|k| fixed_knot(k as f64 / 1024.0).unwrap());
            let want = quadric_words(&frame, knots, 20, 32, 1 << 19);
            for (k, w) in want.iter().enumerate() {
                if walk.rows == 1 && k != 0 && k != 1 && k != 4 {
                    continue;
                }
                let d = (of((16 << c) | k as u8).wrapping_sub(*w)) as i32;
                worst[k] = worst[k].max(i64::from(d).abs());
                if n < 0 {
                    println!("{c} {k} {d}");
                }
            }
        }
        let z = t
            .depth
            .map(|d| fixed_knot(d as f64 / 64.0 - 32768.0).unwrap());
        for (k, w) in plane_words(&frame, z, 16, 32, 1 << 15).iter().enumerate() {
            if walk.rows == 1 && k > 1 {
                continue;
            }
            let d = (of(0x80 | k as u8).wrapping_sub(*w)) as i32;
            worst[20 + k] = worst[20 + k].max(i64::from(d).abs());
        }
    }
    println!("skipped {skipped} worst {worst:?}");
}
