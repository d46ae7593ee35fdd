//! Random expression trees: rust-hdl computes each with its own types, the engines from the tree that `#[hdl_gen]`
//! makes of it.
//!
//! The trees are the same in every run. `SHADEGATE_TREES` says how many (10 000), `SHADEGATE_SEED` which ones (1):
//!
//! ```text
//! SHADEGATE_TREES=50000 SHADEGATE_SEED=7 cargo test --release -p shadegate-testbench --test equivalence trees
//! ```
//!
//! A tree that fails is shrunk with the engine that it failed in and printed as Rust, without `self.` and `.val()`.

mod batch;
mod grow;
mod shrink;
mod tree;
mod value;

use crate::harness::bench::{Answers, Bench};
use crate::harness::case::{translate, Stimulus, Unit};
use crate::harness::code::Driven;
use crate::harness::compare::{differences, Difference};
use crate::harness::stimulus::{ones, vectors};
use crate::harness::{compiled, icarus, native, verilator};
use batch::Batch;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::path::Path;
use std::rc::Rc;
use tree::Tree;

/// Trees in one description.
const BATCH: usize = 50;

/// Vectors per tree.
const VECTORS: usize = 24;

/// Warnings that random trees deserve: they compare with the ends of ranges and leave bits unread.
const DESERVED: &[&str] = &["-Wno-UNUSEDSIGNAL", "-Wno-CMPCONST", "-Wno-UNSIGNED"];

fn setting(name: &str, default: u64) -> u64 {
    let text = std::env::var(name).ok();
    text.map_or(default, |t| {
        t.parse()
            .unwrap_or_else(|_| panic!("{name} is a number, not `{t}`"))
    })
}

/// Different trees from one seed.
fn grown(count: usize, seed: u64) -> Vec<Tree> {
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let strategy = grow::trees();
    let mut trees: Vec<Tree> = vec![];
    let mut texts = std::collections::HashSet::new();
    while trees.len() < count {
        let tree = strategy
            .new_tree(&mut runner)
            .expect("every list makes a tree")
            .current();
        assert!(tree.allowed(), "{tree}");
        if tree.size() > 1 && texts.insert(tree.to_string()) {
            trees.push(tree);
        }
    }
    trees
}

/// All inputs at zero, at all ones, at the sign, and so on; then at random.
fn stimulus() -> Rc<Stimulus> {
    let inputs = Batch::new(&[]).inputs();
    let mut list = vectors("trees", &inputs, VECTORS, &|_| true);
    let all = |code: fn(usize) -> u128| inputs.iter().map(|p| code(p.width)).collect();
    list[0] = all(|_| 0);
    list[1] = all(ones);
    list[2] = all(|w| 1 << (w - 1));
    list[3] = all(|w| ones(w) >> 1);
    list[4] = all(|_| 1);
    Rc::new(Stimulus {
        inputs,
        vectors: list,
    })
}

/// A batch of trees, simulated by rust-hdl.
fn unit(name: &str, trees: &[Tree], stimulus: &Rc<Stimulus>) -> Result<Unit, String> {
    let mut design = Batch::new(trees);
    let (module, files) = translate(name, &design)?;
    let mut expected = vec![];
    let mut undefined = vec![];
    for vector in &stimulus.vectors {
        expected.extend(native::run(
            &mut design,
            std::slice::from_ref(vector),
            false,
        ));
        undefined.push(design.undefined.clone());
    }
    Ok(Unit {
        name: name.to_string(),
        module,
        files,
        outputs: native::outputs(&design)
            .into_iter()
            .map(|(p, _)| p)
            .collect(),
        stimulus: stimulus.clone(),
        clock: false,
        expected,
        undefined: Box::new(move |sample, output| undefined[sample][output]),
    })
}

/// All batches. Trees that are refused are named with the reason.
fn units(trees: &[Tree], stimulus: &Rc<Stimulus>) -> Vec<Unit> {
    let mut units = vec![];
    let mut refused = vec![];
    for (i, batch) in trees.chunks(BATCH).enumerate() {
        match unit(&format!("batch{i}"), batch, stimulus) {
            Ok(unit) => units.push(unit),
            Err(whole) => {
                let alone = |t: &Tree| {
                    Some(format!(
                        "{t}\n    {}",
                        unit("tree", std::slice::from_ref(t), stimulus).err()?
                    ))
                };
                refused.push(batch.iter().find_map(alone).unwrap_or(whole));
            }
        }
    }
    assert!(refused.is_empty(), "refused:\n{}", refused.join("\n"));
    units
}

/// An engine by name, and how it answers.
type Engine = (&'static str, fn(&Bench, &Path) -> Answers);

const ENGINES: &[Engine] = &[
    ("compiled", |b, _| compiled::answers(b)),
    ("icarus", icarus::answers),
    ("verilator", |b, d| verilator::answers(b, d, DESERVED)),
];

fn run(engine: Engine, units: &[Unit]) -> Vec<Difference> {
    let bench = Bench {
        units,
        clocked: false,
    };
    let directory = tempfile::tempdir().expect("temporary directory");
    differences(engine.0, &bench, &(engine.1)(&bench, directory.path()))
}

/// A failing tree, made small.
fn explain(engine: Engine, d: &Difference, trees: &[Tree], stimulus: &Rc<Stimulus>) -> String {
    let tree = &trees[d.unit * BATCH + d.output.0];
    let small = shrink::shrink(tree, &mut |candidates| {
        let found = run(engine, &units(candidates, stimulus));
        let fails = |i: usize| found.iter().any(|d| d.unit * BATCH + d.output.0 == i);
        (0..candidates.len()).map(fails).collect()
    });
    let again = run(engine, &units(std::slice::from_ref(&small), stimulus));
    match again.first() {
        Some(alone) => format!("{small}\n    {alone}\n    grown as {tree}"),
        None => format!("{tree}, but not alone\n    {d}"),
    }
}

#[test]
fn every_engine_computes_random_expressions_as_rust_hdl_does() {
    let count = setting("SHADEGATE_TREES", 10_000) as usize;
    let trees = grown(count, setting("SHADEGATE_SEED", 1));
    let stimulus = stimulus();
    let units = units(&trees, &stimulus);
    let nodes: usize = trees.iter().map(Tree::size).sum();
    let defined = units.iter().flat_map(|u| {
        let places = (0..VECTORS).flat_map(|s| (0..u.outputs.len()).map(move |o| (s, o)));
        places
            .filter(|(s, o)| !(u.undefined)(*s, *o))
            .collect::<Vec<_>>()
    });
    println!("{count} trees of {nodes} nodes, {} values", defined.count());
    let mut report = vec![];
    for engine in ENGINES {
        let begin = std::time::Instant::now();
        let found = run(*engine, &units);
        println!("{} in {:.1} s", engine.0, begin.elapsed().as_secs_f64());
        report.push(format!("{}: {} trees differ", engine.0, found.len()));
        report.extend(
            found
                .iter()
                .take(3)
                .map(|d| explain(*engine, d, &trees, &stimulus)),
        );
    }
    assert!(report.len() == ENGINES.len(), "{}", report.join("\n"));
}
