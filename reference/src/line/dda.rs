//! The line by repeated addition of a rounded slope (a digital differential analyser). One addition and no comparison per
//! column, but the rounding of the slope adds up: at F fraction bits many pixels are wrong unless the slope is rounded
//! *up* and F ≥ 1 + 2·log₂ dX. Nothing draws with it; it is the negative control of [`super::bresenham`].

/// How the slope becomes a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// Towards zero.
    Down,
    /// To nearest.
    Nearest,
    /// Away from zero.
    Up,
}

/// Minor coordinates of columns 0..=dX of the line to (`dx`, `dy`), 0 ≤ dY ≤ dX, with `fraction` bits below the point,
/// at most 32.
pub fn rows(dx: u32, dy: u32, fraction: u32, rounding: Rounding) -> impl Iterator<Item = i64> {
    let (n, d) = (u64::from(dy) << fraction, u64::from(dx.max(1)));
    let slope = match rounding {
        Rounding::Down => n / d,
        Rounding::Nearest => (2 * n + d) / (2 * d),
        Rounding::Up => n.div_ceil(d),
    };
    let half = (1u64 << fraction) / 2;
    (0..=u64::from(dx)).map(move |x| ((half + x * slope) >> fraction) as i64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::rngs::StdRng;
    use rand::{Rng, SeedableRng};

    /// Shares of wrong pixels and of wrong end points over random lines of dX < 1024.
    fn wrong(fraction: u32, rounding: Rounding) -> (f64, f64) {
        let mut rng = StdRng::seed_from_u64(31);
        let (mut pixels, mut bad, mut ends) = (0u64, 0u64, 0u64);
        const LINES: u64 = 3000;
        for _ in 0..LINES {
            let dx = rng.random_range(1..1024u32);
            let dy = rng.random_range(0..=dx);
            let mut last = false;
            for (x, y) in (0u64..).zip(rows(dx, dy, fraction, rounding)) {
                // floor(y + 1/2), exactly.
                let exact = (2 * x * u64::from(dy) + u64::from(dx)) / (2 * u64::from(dx));
                last = y != exact as i64;
                pixels += 1;
                bad += u64::from(last);
            }
            ends += u64::from(last);
        }
        (bad as f64 / pixels as f64, ends as f64 / LINES as f64)
    }

    #[test]
    fn the_slope_drifts_as_measured_in_the_study() {
        use Rounding::{Down, Nearest, Up};
        // Shares in percent: rounding, fraction bits, figure of the study.
        let rows = [
            (Down, 12, 4.2),
            (Down, 16, 0.39),
            (Down, 20, 0.17),
            (Nearest, 12, 2.05),
            (Nearest, 16, 0.15),
            (Nearest, 20, 0.09),
        ];
        for (rounding, f, want) in rows {
            let got = wrong(f, rounding).0 * 100.0;
            println!("{rounding:?} F={f}: {got:.3} % wrong pixels ({want})");
            assert!(
                (0.6..1.6).contains(&(got / want)),
                "{rounding:?} F={f}: {got}"
            );
        }
        assert_eq!(wrong(21, Up), (0.0, 0.0));
        assert!(wrong(18, Up).0 > 0.0);
        let (pixels, ends) = wrong(8, Down);
        println!(
            "F=8 truncated: {:.0} % of pixels, {:.0} % of ends",
            pixels * 100.0,
            ends * 100.0
        );
        assert!(pixels > 0.3 && ends > 0.4, "{pixels} {ends}");
    }

    #[test]
    fn rounded_up_and_long_enough_it_is_exact() {
        for dx in (1..1024u32).step_by(37) {
            for dy in (0..=dx).step_by(5) {
                let needed = 1 + (2.0 * f64::from(dx).log2()).ceil() as u32;
                for (x, y) in (0u64..).zip(super::rows(dx, dy, needed, Rounding::Up)) {
                    let exact = (2 * x * u64::from(dy) + u64::from(dx)) / (2 * u64::from(dx));
                    assert_eq!(y, exact as i64, "{dx} {dy} {x}");
                }
            }
        }
    }
}
