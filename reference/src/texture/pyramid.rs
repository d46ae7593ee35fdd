//! Pictures of half the width, half the height, and so on: what mip-maps and ripmaps hold. A new texel is the average of
//! exactly the area it covers, so every level has the mean of the picture, also where a side is odd: of 2m + 1 texels,
//! m new ones cover 2 + 1/m each.

use super::Texels;

/// For every one of `n / 2` new texels (at least one), the old texels it covers and their shares.
fn shares(n: usize) -> Vec<Vec<(usize, f64)>> {
    let m = (n / 2).max(1);
    // In units of 1/m texel, old texel i covers i·m..(i + 1)·m and new texel k covers k·n..(k + 1)·n.
    let one = |k: usize| {
        let (from, to) = (k * n, (k + 1) * n);
        (from / m..to.div_ceil(m))
            .map(|i| {
                let overlap = to.min((i + 1) * m) - from.max(i * m);
                (i, overlap as f64 / n as f64)
            })
            .collect()
    };
    (0..m).map(one).collect()
}

fn average(parts: &[(usize, f64)], texel: impl Fn(usize) -> [f64; 3]) -> [f32; 3] {
    let mut sum = [0.0; 3];
    for (i, share) in parts {
        let t = texel(*i);
        for c in 0..3 {
            sum[c] += share * t[c];
        }
    }
    sum.map(|v| v as f32)
}

/// Half the columns; the picture itself when there is only one.
#[must_use]
pub fn halve_width(t: &Texels) -> Texels {
    let parts = shares(t.width());
    Texels::from_fn(parts.len(), t.height(), |x, y| {
        average(&parts[x], |i| t.at(i, y))
    })
}

/// Half the rows; the picture itself when there is only one.
#[must_use]
pub fn halve_height(t: &Texels) -> Texels {
    let parts = shares(t.height());
    Texels::from_fn(t.width(), parts.len(), |x, y| {
        average(&parts[y], |i| t.at(x, i))
    })
}

/// How many levels there are from `n` texels down to one.
#[must_use]
pub fn levels(n: usize) -> usize {
    n.max(1).ilog2() as usize + 1
}

/// The first picture and those that `next` makes of it, `count` in all.
pub(super) fn chain(first: Texels, count: usize, next: impl Fn(&Texels) -> Texels) -> Vec<Texels> {
    let mut all = vec![first];
    while all.len() < count {
        let smaller = next(&all[all.len() - 1]);
        all.push(smaller);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mean(t: &Texels) -> f64 {
        let n = t.width() * t.height();
        (0..n)
            .map(|i| t.at(i % t.width(), i / t.width())[0])
            .sum::<f64>()
            / n as f64
    }

    #[test]
    fn every_level_has_the_mean_of_the_picture() {
        for (w, h) in [(64, 64), (13, 7), (1, 9), (5, 1), (31, 30), (1, 1)] {
            let t = Texels::from_fn(w, h, |x, y| [((x * 7 + y * 13) % 11) as f32 / 11.0; 3]);
            let count = levels(w.max(h));
            let all = chain(t, count, |t| halve_height(&halve_width(t)));
            let last = &all[count - 1];
            assert_eq!((last.width(), last.height()), (1, 1));
            for level in &all {
                assert!((mean(level) - mean(&all[0])).abs() < 1e-6, "{w}x{h}");
            }
        }
    }

    #[test]
    fn an_odd_side_by_hand() {
        // Five texels become two of 2.5.
        let t = Texels::from_fn(5, 1, |x, _| [x as f32; 3]);
        let half = halve_width(&t);
        assert_eq!(half.width(), 2);
        assert!((half.at(0, 0)[0] - (0.0 + 1.0 + 0.5 * 2.0) / 2.5).abs() < 1e-6);
        assert!((half.at(1, 0)[0] - (0.5 * 2.0 + 3.0 + 4.0) / 2.5).abs() < 1e-6);
    }
}
