//! How fast a power of a cosine can change: for f = N·H at an angle of at least φ from N to H, the largest sizes of the
//! derivatives of max(0, f)ⁿ, as tables of φ made once per exponent.
//!
//! Let |N'|+|H'| ≤ F₁, so |f'| ≤ F₁ sin φ, and |f''| ≤ F₂, |f'''| ≤ F₃. Then, c = cos φ and s = sin φ,
//!
//! * |(fⁿ)''| ≤ n(n−1)cⁿ⁻²s²·F₁² + n·cⁿ⁻¹·F₂,
//! * |(fⁿ)'''| ≤ n(n−1)(n−2)cⁿ⁻³s³·F₁³ + 3n(n−1)cⁿ⁻²s·F₁F₂ + n·cⁿ⁻¹·F₃.
//!
//! Where H is constant the terms share signs that may be used: with q = f', |q| ≤ κs, m ≤ κ², f'' = −2σq − mf and
//! f''' = (6σ² − 3m)q + 6σmf (see [`super::field`]),
//!
//! * |(fⁿ)''| ≤ κ²·n·max(cⁿ, cⁿ⁻²|(n−1)s² − c²|) + 2σκ·n·cⁿ⁻¹s,
//! * |(fⁿ)'''| ≤ κ³·n·cⁿ⁻³·max over |p| ≤ s of |(n−1)(n−2)p³ − 3nc²p| + 6σκ²·n·max(cⁿ, (n−1)cⁿ⁻²s²) + 6σ²κ·n·cⁿ⁻¹s.
//!
//! Exponents below 3 (but for 0, 1 and 2, whose clamped powers are rougher than three derivatives) promise nothing.

/// Entries of a table over the chord t = |N − H| = 2 sin(φ/2), from 0 to √2.
const ENTRIES: usize = 256;
const STEP: f64 = std::f64::consts::SQRT_2 / ENTRIES as f64;

/// Bounds at an angle of at least φ, as factors of F and κ.
#[derive(Clone, Copy, Debug, Default)]
pub struct Factors {
    /// Of F₁², F₂.
    pub second: [f64; 2],
    /// Of F₁³, F₁F₂, F₃.
    pub third: [f64; 3],
    /// Constant H: of κ², 2σκ.
    pub second_constant: [f64; 2],
    /// Constant H: of κ³, 6σκ², 6σ²κ.
    pub third_constant: [f64; 3],
    /// cⁿ itself.
    pub value: f64,
    /// n·cⁿ⁻¹, the slope of the power.
    pub slope: f64,
}

/// The tables of one exponent.
#[derive(Clone, Debug)]
pub struct Power {
    entries: Vec<Factors>,
}

impl Power {
    /// The tables of an exponent of at least 3; `None` for less.
    #[must_use]
    pub fn new(n: f64) -> Option<Self> {
        if n < 3.0 {
            return None;
        }
        // From the rim inwards, so that every entry is the largest of all from its angle on.
        let mut entries = vec![Factors::default(); ENTRIES + 1];
        let mut largest = Factors::default();
        for i in (0..ENTRIES).rev() {
            let here = Factors::between(n, i as f64 * STEP, (i + 1) as f64 * STEP);
            largest = largest.or(&here);
            entries[i] = largest;
        }
        Some(Self { entries })
    }

    /// Bounds for chords |N − H| of at least `t`.
    #[must_use]
    pub fn from_chord(&self, t: f64) -> &Factors {
        let i = (t.max(0.0) / STEP) as usize;
        &self.entries[i.min(ENTRIES)]
    }
}

impl Factors {
    /// The largest values for chords t₀ to t₁: every factor with its own worst end.
    fn between(n: f64, t0: f64, t1: f64) -> Self {
        let cosine = |t: f64| 1.0 - t * t / 2.0;
        // c is largest at t₀, s at t₁ (both within a quarter turn).
        let (c, low) = (cosine(t0), cosine(t1).max(0.0));
        let s = (1.0 - low * low).max(0.0).sqrt();
        let least_s = (1.0 - c * c).max(0.0).sqrt();
        // cⁿ⁻³ to cⁿ from one power.
        let p3 = c.powf(n - 3.0);
        let powers = [p3 * c * c * c, p3 * c * c, p3 * c, p3];
        let p = |k: usize| powers[k];
        let two = (n - 1.0) * s * s - low * low;
        let two_least = c * c - (n - 1.0) * least_s * least_s;
        let (a, b) = ((n - 1.0) * (n - 2.0), 3.0 * n * c * c);
        // |a·p³ − b·p| on 0..=s, for b between its value here and at the other end.
        let b_low = 3.0 * n * low * low;
        let end = (a * s * s * s - b_low * s).max(b * s - a * least_s.powi(2) * s);
        let inner = if a > 0.0 { (b / (3.0 * a)).sqrt() } else { s };
        let hump = 2.0 / 3.0 * b * inner.min(s);
        let cubic = if a <= 0.0 { b * s } else { end.max(hump) };
        Self {
            second: [n * (n - 1.0) * p(2) * s * s, n * p(1)],
            third: [
                n * (n - 1.0) * (n - 2.0) * p(3) * s * s * s,
                3.0 * n * (n - 1.0) * p(2) * s,
                n * p(1),
            ],
            second_constant: [
                n * p(0).max(p(2) * two.max(two_least).max(0.0)),
                n * p(1) * s,
            ],
            third_constant: [
                n * p(3) * cubic.max(0.0),
                n * p(0).max((n - 1.0) * p(2) * s * s),
                n * p(1) * s,
            ],
            value: p(0),
            slope: n * p(1),
        }
    }

    fn or(&self, o: &Self) -> Self {
        let max2 = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
        let max3 = |a: [f64; 3], b: [f64; 3]| [a[0].max(b[0]), a[1].max(b[1]), a[2].max(b[2])];
        Self {
            second: max2(self.second, o.second),
            third: max3(self.third, o.third),
            second_constant: max2(self.second_constant, o.second_constant),
            third_constant: max3(self.third_constant, o.third_constant),
            value: self.value.max(o.value),
            slope: self.slope.max(o.slope),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_bound_what_they_promise() {
        for n in [3.0, 4.0, 5.0, 7.5, 20.0, 50.0, 100.0, 500.0] {
            let power = Power::new(n).unwrap();
            for i in 0..4000 {
                let t = f64::from(i) / 4000.0 * 1.414;
                let c: f64 = 1.0 - t * t / 2.0;
                let s = (1.0 - c * c).sqrt();
                // All entries from smaller chords on must hold here.
                for back in [0.0, 0.1, 0.5] {
                    let f = power.from_chord((t - back).max(0.0));
                    let p = |k: f64| c.powf(n - k);
                    assert!(p(0.0) <= f.value + 1e-12 && n * p(1.0) <= f.slope + 1e-12);
                    assert!(n * (n - 1.0) * p(2.0) * s * s <= f.second[0] + 1e-9);
                    assert!(n * (n - 1.0) * (n - 2.0) * p(3.0) * s.powi(3) <= f.third[0] + 1e-9);
                    for k in 0..=20 {
                        let q = s * f64::from(k) / 20.0;
                        let third = n
                            * p(3.0)
                            * ((n - 1.0) * (n - 2.0) * q.powi(3) - 3.0 * n * c * c * q).abs();
                        assert!(
                            third <= f.third_constant[0] * (1.0 + 1e-9) + 1e-9,
                            "{n} {t} {q}"
                        );
                        let second = n * p(2.0) * ((n - 1.0) * q * q - c * c).abs();
                        assert!(
                            second <= f.second_constant[0] * (1.0 + 1e-9) + 1e-9,
                            "{n} {t} {q}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn and_not_much_more() {
        // At the peak of a highlight the third derivative along a great circle is 1.38·n^1.5.
        let power = Power::new(100.0).unwrap();
        let third = power.from_chord(0.0).third_constant[0];
        assert!(third > 1.3 * 1000.0 && third < 1.7 * 1000.0, "{third}");
    }

    #[test]
    fn small_exponents_promise_nothing() {
        assert!(Power::new(2.9).is_none() && Power::new(0.0).is_none());
    }
}
