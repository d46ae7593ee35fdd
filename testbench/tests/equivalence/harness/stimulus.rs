//! Input vectors: every corner of every width, mixed with random words; everything when there is little to try.

use super::code::Port;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::collections::BTreeMap;

/// Named codes of one vector.
pub type Vector<'a> = BTreeMap<&'a str, u128>;

/// All bits of a width.
pub fn ones(width: usize) -> u128 {
    !0 >> (128 - width)
}

/// Codes at which words of this width behave in a special way.
fn corners(width: usize) -> Vec<u128> {
    let all = ones(width);
    let sign = 1 << (width - 1);
    let pattern = u128::MAX / 3 & all;
    let half = ones(width.div_ceil(2));
    let mut list = vec![
        0,
        1,
        2,
        all,
        all - 1,
        sign,
        sign - 1,
        sign | 1,
        sign.wrapping_sub(2) & all,
        pattern,
        !pattern & all,
        half,
        !half & all,
    ];
    list.retain(|c| *c <= all);
    list
}

/// A code: a corner, a random word, a word of few bits, or a small number.
pub fn code(rng: &mut StdRng, width: usize) -> u128 {
    let list = corners(width);
    let word: u128 = rng.random();
    let any = word & ones(width);
    match rng.random_range(0..8) {
        0..=2 => list[rng.random_range(0..list.len())],
        3 => any & rng.random::<u128>() & rng.random::<u128>(),
        4 => any % 20,
        _ => any,
    }
}

/// `count` vectors for these inputs that `keep` does not reject, the same in every run.
pub fn vectors(
    name: &str,
    inputs: &[Port],
    count: usize,
    keep: &dyn Fn(&Vector) -> bool,
) -> Vec<Vec<u128>> {
    let seed = name.bytes().fold(0xcbf2_9ce4_8422_2325u64, |h, b| {
        (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3)
    });
    let mut rng = StdRng::seed_from_u64(seed);
    let total: usize = inputs.iter().map(|p| p.width).sum();
    let kept = |vector: &[u128]| {
        let names = inputs.iter().map(|p| p.name.as_str());
        keep(&names.zip(vector.iter().copied()).collect())
    };
    let mut out: Vec<Vec<u128>> = vec![];
    if total < 32 && 1 << total <= count {
        for number in 0..1u128 << total {
            let mut rest = number;
            let take = |p: &Port| {
                let code = rest & ones(p.width);
                rest >>= p.width;
                code
            };
            out.push(inputs.iter().map(take).collect());
        }
        out.retain(|v| kept(v));
    }
    let mut tries = 0;
    while out.len() < count {
        tries += 1;
        assert!(tries < 1000 * count, "{name}: hardly any vector is allowed");
        let vector: Vec<u128> = inputs.iter().map(|p| code(&mut rng, p.width)).collect();
        if kept(&vector) {
            out.push(vector);
        }
    }
    out
}
