//! Blake, Disselkoen & Kuijk 1992, Tables 2 and 3: how large a facet must be before a method that costs more per facet
//! and scanline, but less per pixel, is the cheaper one.
//!
//! With costs F per facet, L per scanline and P per pixel, a facet of h lines has N = h² pixels, and two methods cost
//! the same where ΔF + ΔL·h + ΔP·h² = 0. Table 3 prints ⌈h²⌉, but ⌈h⌉ (lines, not pixels) where both methods cost the
//! same per pixel, 41 for method 7 over 4 with varying vectors, where h² is 41.64, and 1 for method 5 over 4 with varying
//! vectors, where h² is 3.008.

use super::Claim;

const SOURCE: &str = "Blake et al. 1992, Table 3";

/// Elementary operations per facet, scanline and pixel.
type Cost = [i32; 3];

/// Table 2, methods 1 to 7: Phong; rotation-independent Phong; Duff computed; Duff by differences; Bishop & Weimer;
/// angular on trapezia; angular on triangles.
const CONSTANT: [Cost; 7] = [
    [24, 21, 46],
    [73, 2, 46],
    [130, 19, 32],
    [167, 6, 32],
    [273, 8, 12],
    [434, 282, 5],
    [198, 282, 5],
];
/// The same where light and half-way vectors vary over the facet.
const VARYING: [Cost; 7] = [
    [144, 45, 64],
    [247, 2, 64],
    [426, 67, 57],
    [581, 17, 57],
    [732, 8, 12],
    [1080, 353, 5],
    [578, 353, 5],
];
/// Table 3: rows are methods 2 to 7, columns the methods that they are compared with, from 1.
type Printed = [&'static [u32]; 6];
const PRINTED_CONSTANT: Printed = [
    &[3],
    &[8, 8],
    &[8, 8, 3],
    &[7, 7, 6, 6],
    &[59, 64, 117, 124, 1578],
    &[49, 53, 100, 107, 1511],
];
const PRINTED_VARYING: Printed = [
    &[3],
    &[66, 133],
    &[38, 65, 4],
    &[10, 10, 5, 1],
    &[55, 61, 53, 60, 2528],
    &[41, 46, 36, 41, 2385],
];

/// Lines of the facet at which `new` becomes cheaper than `old`: the positive root, if there is one.
fn lines(new: Cost, old: Cost) -> Option<f64> {
    let [f, l, p] = [0, 1, 2].map(|i| f64::from(new[i] - old[i]));
    let h = if p == 0.0 {
        -f / l
    } else {
        let root = (l * l - 4.0 * p * f).sqrt();
        (-l - root) / (2.0 * p)
    };
    (h.is_finite() && h > 0.0).then_some(h)
}

/// The smallest whole number of pixels of a facet for which `new` is at least as cheap as `old`.
fn pixels(new: Cost, old: Cost) -> Option<u32> {
    lines(new, old).map(|h| (h * h).ceil() as u32)
}

/// All forty entries of Table 3.
pub fn claims() -> Vec<Claim> {
    let mut claims = Vec::new();
    for (name, costs, printed) in [
        ("constant vectors", CONSTANT, PRINTED_CONSTANT),
        ("varying vectors", VARYING, PRINTED_VARYING),
    ] {
        for (i, row) in printed.iter().enumerate() {
            for (old, paper) in row.iter().enumerate() {
                let new = i + 1;
                let (a, b) = (costs[new], costs[old]);
                let what = format!("break-even of method {} over {}, {name}", new + 1, old + 1);
                let ours = pixels(a, b).unwrap_or(0);
                let note = match lines(a, b) {
                    _ if *paper == ours => "",
                    Some(h) if a[2] == b[2] && h.ceil() == f64::from(*paper) => {
                        "printed in lines, not pixels"
                    }
                    Some(h) if (h * h).floor() == f64::from(*paper) => "printed rounded down",
                    _ => "an error of the table: the counts of Table 2 say otherwise",
                };
                claims.push(Claim::pixels(SOURCE, what, *paper, ours, note));
            }
        }
    }
    claims
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cost of a facet of `n` pixels.
    fn cost(c: Cost, n: f64) -> f64 {
        f64::from(c[0]) + f64::from(c[1]) * n.sqrt() + f64::from(c[2]) * n
    }

    #[test]
    fn forty_entries_of_which_six_are_errata() {
        let claims = claims();
        assert_eq!(claims.len(), 40);
        let wrong: Vec<(&str, f64, f64)> = claims
            .iter()
            .filter(|c| !c.reproduced)
            .map(|c| (c.what.as_str(), c.paper, c.ours))
            .collect();
        assert_eq!(
            wrong,
            [
                ("break-even of method 2 over 1, constant vectors", 3.0, 7.0),
                ("break-even of method 4 over 3, constant vectors", 3.0, 9.0),
                ("break-even of method 2 over 1, varying vectors", 3.0, 6.0),
                ("break-even of method 4 over 3, varying vectors", 4.0, 10.0),
                ("break-even of method 5 over 4, varying vectors", 1.0, 4.0),
                ("break-even of method 7 over 4, varying vectors", 41.0, 42.0),
            ]
        );
    }

    #[test]
    fn the_new_method_is_cheaper_from_the_break_even_on_and_not_before() {
        for costs in [CONSTANT, VARYING] {
            for new in 1..7 {
                for old in 0..new.min(5) {
                    let n = f64::from(pixels(costs[new], costs[old]).unwrap());
                    assert!(cost(costs[new], n) <= cost(costs[old], n));
                    assert!(cost(costs[new], n - 1.0) > cost(costs[old], n - 1.0));
                }
            }
        }
    }
}
