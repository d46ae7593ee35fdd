//! The compact unit draws the same in rust-hdl, compiled, in Icarus and in Verilator: triangles, with a host that waits
//! for `load_ready` and a consumer that stalls. That rust-hdl equals the integer model, and the model the quadratic core,
//! is shown elsewhere (`hdl/tests/compact.rs`, `gen/tests/compact.rs`).

use crate::harness::bench::Bench;
use crate::harness::case::Case;
use crate::harness::code::drive;
use crate::harness::{compare, compiled, icarus, verilator};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::compact::words;
use shadegate_gen::stimulus::{build, sample_triangles, StimulusOptions};
use shadegate_hdl::compact::unit::{CompactUnit, CompactUnit29, CompactUnit32};
use shadegate_hdl::compact::{CompactInputs, CompactModel};
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::raster::Viewport;

const CLOCKS: usize = 3000;

drive!(CompactUnit<32, 11, 20, 20>, clock; write, select, data, start, ready);
drive!(CompactUnit<29, 8, 20, 11>, clock; write, select, data, start, ready);

/// What a host and a consumer do with a unit in front of them, and the pixels that they get.
fn session(mut unit: CompactModel, dropped: u32) -> (Vec<Vec<u128>>, usize) {
    let viewport = Viewport {
        width: 40,
        height: 30,
    };
    let core = Core::for_frame(Order::Quadratic, 40, 30).expect("in range");
    let triangles = sample_triangles(Order::Quadratic, viewport, 60, 5);
    let options = StimulusOptions {
        skip_unchanged: false,
        broadcast: false,
        ..StimulusOptions::default()
    };
    let stimulus = build(&core, &triangles, viewport, &options).expect("in range");
    let mut writes = vec![(11, 40, false)];
    for t in &stimulus.primitives {
        let words = words(t, dropped);
        let last = words.len() - 1;
        writes.extend(words.iter().enumerate().map(|(i, w)| (w.0, w.1, i == last)));
    }
    let mut r = StdRng::seed_from_u64(u64::from(dropped));
    let (mut vectors, mut pixels, mut next) = (vec![], 0, 0);
    while vectors.len() < CLOCKS {
        let o = unit.outputs();
        let mut i = CompactInputs {
            ready: r.random_ratio(3, 4),
            ..CompactInputs::default()
        };
        if let Some((select, data, start)) = writes.get(next) {
            // What is offered while the unit is not ready must be passed over.
            (i.write, i.select, i.data, i.start) = (r.random_ratio(4, 5), *select, *data, *start);
            i.start &= i.write;
            next += usize::from(i.write && o.load_ready);
        }
        pixels += usize::from(o.valid && i.ready);
        let bit = u128::from;
        vectors.push(vec![
            bit(i.write),
            i.select.into(),
            i.data.into(),
            bit(i.start),
            bit(i.ready),
        ]);
        unit.clock(&i);
    }
    (vectors, pixels)
}

#[test]
fn every_engine_draws_the_triangles_of_the_compact_unit() {
    let (long, pixels) = session(CompactModel::new(11, 20, 20), 0);
    let (short, others) = session(CompactModel::new(8, 20, 11), 9);
    println!("{pixels} and {others} pixels");
    assert!(pixels.min(others) > CLOCKS / 4);
    let units = [
        Case::named("compact_32", CompactUnit32::default()).run_on(long),
        Case::named("compact_29", CompactUnit29::default()).run_on(short),
    ]
    .map(|unit| unit.unwrap_or_else(|e| panic!("{e}")));
    let bench = Bench {
        units: &units,
        clocked: true,
    };
    let directory = tempfile::tempdir().expect("temporary directory");
    let folder = directory.path();
    let mut found = compare::differences("compiled", &bench, &compiled::answers(&bench));
    found.extend(compare::differences(
        "icarus",
        &bench,
        &icarus::answers(&bench, folder),
    ));
    let verilator = verilator::answers(&bench, folder, &[]);
    found.extend(compare::differences("verilator", &bench, &verilator));
    compare::assert_none(&found);
}
