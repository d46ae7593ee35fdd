//! The corpus: one file per theme, each with small descriptions named after what they do.

mod buses;
mod casts;
mod choices;
mod lines;
mod memories;
mod operators;
mod positions;
mod products;
mod registers;
mod structure;
mod widths;

use crate::harness::bench::Bench;
use crate::harness::case::{Case, Unit};
use crate::harness::{compare, compiled, icarus, verilator};

fn cases() -> Vec<Case> {
    [
        operators::cases(),
        widths::cases(),
        positions::cases(),
        casts::cases(),
        products::cases(),
        registers::cases(),
        choices::cases(),
        structure::cases(),
        buses::cases(),
        memories::cases(),
        lines::cases(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

#[test]
fn every_engine_agrees_with_rust_hdl_on_the_corpus() {
    let (units, refused): (Vec<_>, Vec<_>) =
        cases().into_iter().map(Case::run).partition(Result::is_ok);
    let refused: Vec<String> = refused.into_iter().filter_map(Result::err).collect();
    assert!(refused.is_empty(), "refused:\n{}", refused.join("\n"));
    let units: Vec<Unit> = units.into_iter().flatten().collect();
    println!("{} descriptions", units.len());
    let bench = Bench {
        units: &units,
        clocked: true,
    };
    let directory = tempfile::tempdir().expect("temporary directory");
    let mut found = compare::differences("compiled", &bench, &compiled::answers(&bench));
    found.extend(compare::differences(
        "icarus",
        &bench,
        &icarus::answers(&bench, directory.path()),
    ));
    let verilator = verilator::answers(&bench, directory.path(), &[]);
    found.extend(compare::differences("verilator", &bench, &verilator));
    compare::assert_none(&found);
}

/// A negative control: one wrong operator in the text, and one wrong expectation, are found and named.
#[test]
fn a_difference_is_found_and_named() {
    let mut unit = operators::cases().swap_remove(0).run().expect("translates");
    let directory = tempfile::tempdir().expect("temporary directory");
    unit.expected[10][0] ^= 4;
    let wrong = unit.expected[10][0];
    let found = |unit: &Unit| {
        let bench = Bench {
            units: std::slice::from_ref(unit),
            clocked: true,
        };
        let icarus = icarus::answers(&bench, directory.path());
        let all = [("compiled", compiled::answers(&bench)), ("icarus", icarus)];
        all.iter()
            .flat_map(|(name, a)| compare::differences(name, &bench, a))
            .collect::<Vec<_>>()
    };
    for d in found(&unit) {
        assert_eq!((d.sample, d.expected, d.got), (10, wrong, Some(wrong ^ 4)));
    }
    assert_eq!(found(&unit).len(), 2);
    unit.expected[10][0] ^= 4;
    assert_eq!(found(&unit), []);
    let text = &mut unit.files[0].text;
    *text = text.replace(" + ", " - ");
    let differs = found(&unit);
    assert_eq!(differs.len(), 1, "{differs:?}");
    let said = differs[0].to_string();
    assert!(
        said.starts_with("icarus: carry_is_lost sample ") && said.contains(": output o is "),
        "{said}"
    );
}
