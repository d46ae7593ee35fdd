//! Targets that share a statement belong together: they become one block of Verilog.

use super::Target;
use std::collections::{BTreeMap, BTreeSet};

/// Groups of targets with a statement in common, in order of first appearance. `owners` names the statements that
/// drive each target, in order; none is empty.
#[must_use]
pub fn groups(owners: &BTreeMap<Target, Vec<usize>>) -> Vec<BTreeSet<Target>> {
    let mut groups: Vec<(BTreeSet<Target>, BTreeSet<usize>)> = vec![];
    let mut by_order: Vec<_> = owners.iter().collect();
    by_order.sort_by_key(|(_, at)| at.first().copied());
    for (target, at) in by_order {
        let mut merged = (
            BTreeSet::from([target.clone()]),
            at.iter().copied().collect::<BTreeSet<_>>(),
        );
        let mut place = groups.len();
        let mut i = 0;
        while i < groups.len() {
            if groups[i].1.is_disjoint(&merged.1) {
                i += 1;
                continue;
            }
            let (targets, at) = groups.remove(i);
            merged.0.extend(targets);
            merged.1.extend(at);
            place = place.min(i);
        }
        groups.insert(place.min(groups.len()), merged);
    }
    groups.into_iter().map(|g| g.0).collect()
}
