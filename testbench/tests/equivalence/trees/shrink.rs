//! From a failing tree to a small one: all trees that are one step smaller are tried at once, the smallest that still
//! fails is taken, until none does.

use super::tree::{inputs, Node, Tree};
use super::value::Format;

/// Trees tried in one step; each step costs a build of the failing engine.
const TRIES: usize = 400;

/// Subtrees of one format, the tree itself apart.
fn below(t: &Tree, format: Format, out: &mut Vec<Tree>) {
    for p in &t.parts {
        if p.format == format && !matches!(p.node, Node::Number(_)) {
            out.push(p.clone());
        }
        below(p, format, out);
    }
}

/// What can stand in this tree's place: what is inside it, or an input.
fn instead(t: &Tree) -> Vec<Tree> {
    let mut out = vec![];
    if matches!(t.node, Node::Input(_) | Node::Number(_)) {
        return out;
    }
    below(t, t.format, &mut out);
    let input = inputs().iter().position(|(_, f)| *f == t.format);
    out.extend(input.map(|i| Tree::new(t.format, Node::Input(i), vec![])));
    out
}

/// All trees in which one node is replaced by something smaller.
fn smaller(t: &Tree) -> Vec<Tree> {
    let mut out = instead(t);
    for (i, part) in t.parts.iter().enumerate() {
        for p in smaller(part) {
            let mut whole = t.clone();
            whole.parts[i] = p;
            out.push(whole);
        }
    }
    out
}

/// Every subtree, which may fail by itself.
fn subtrees(t: &Tree, out: &mut Vec<Tree>) {
    for p in &t.parts {
        if !matches!(p.node, Node::Number(_)) {
            out.push(p.clone());
        }
        subtrees(p, out);
    }
}

/// The smallest tree found for which `fails` still holds.
pub fn shrink(tree: &Tree, fails: &mut dyn FnMut(&[Tree]) -> Vec<bool>) -> Tree {
    let mut best = tree.clone();
    loop {
        let mut candidates = smaller(&best);
        subtrees(&best, &mut candidates);
        candidates.retain(|c| c.allowed() && c.size() < best.size());
        candidates.sort_by_key(Tree::size);
        candidates.dedup();
        candidates.truncate(TRIES);
        if candidates.is_empty() {
            return best;
        }
        let failing = fails(&candidates);
        match candidates
            .into_iter()
            .zip(failing)
            .find(|(_, fails)| *fails)
        {
            Some((c, _)) => best = c,
            None => return best,
        }
    }
}

#[test]
fn a_tree_shrinks_to_what_fails() {
    use super::grow::trees;
    use proptest::strategy::{Strategy, ValueTree};
    use proptest::test_runner::TestRunner;
    fn multiplies(t: &Tree) -> bool {
        t.node == Node::Product || t.parts.iter().any(multiplies)
    }
    let mut runner = TestRunner::deterministic();
    let strategy = trees();
    let mut grown = (0..100_000).map(|_| strategy.new_tree(&mut runner).expect("a tree").current());
    let tree = grown
        .find(|t| multiplies(t) && t.size() > 12)
        .expect("some tree multiplies");
    let small = shrink(&tree, &mut |list| list.iter().map(multiplies).collect());
    assert_eq!((small.node, small.size()), (Node::Product, 3), "{small}");
}
