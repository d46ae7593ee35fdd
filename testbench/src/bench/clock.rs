//! Taking turns: several jobs in rounds, and medians over the rounds.

use std::time::Duration;

/// How long to measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Fewest rounds.
    pub least: usize,
    /// Most rounds.
    pub most: usize,
    /// Rounds are added up to this time, as far as `most` allows.
    pub budget: Duration,
}

impl Effort {
    /// For figures to be kept: medians of at least five rounds.
    pub const FULL: Self = Self {
        least: 5,
        most: 25,
        budget: Duration::from_millis(600),
    };
    /// For a first look.
    pub const QUICK: Self = Self {
        least: 3,
        most: 5,
        budget: Duration::from_millis(40),
    };

    /// Rounds for jobs that together take `once`.
    #[must_use]
    pub fn rounds(self, once: Duration) -> usize {
        let fit = self.budget.as_nanos() / once.as_nanos().max(1);
        usize::try_from(fit)
            .unwrap_or(self.most)
            .clamp(self.least, self.most)
    }
}

/// Runs `jobs` jobs in `rounds` rounds; the results by job, then by round. Each round begins with another job, so that
/// none of them always runs in the wake of the same one.
pub fn in_turns<T>(jobs: usize, rounds: usize, mut run: impl FnMut(usize) -> T) -> Vec<Vec<T>> {
    let mut results: Vec<Vec<T>> = (0..jobs).map(|_| Vec::with_capacity(rounds)).collect();
    for round in 0..rounds {
        for k in 0..jobs {
            let job = (round + k) % jobs;
            results[job].push(run(job));
        }
    }
    results
}

/// The middle one of the values, or the mean of the middle two; zero of none.
#[must_use]
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut v: Vec<f64> = values.into_iter().collect();
    v.sort_by(f64::total_cmp);
    let n = v.len();
    match n {
        0 => 0.0,
        _ if n % 2 == 1 => v[n / 2],
        _ => (v[n / 2 - 1] + v[n / 2]) / 2.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_ignores_one_disturbed_run() {
        assert_eq!(median([3.0, 1e9, 2.0]), 3.0);
        assert_eq!(median([4.0, 1.0, 2.0, 3.0]), 2.5);
        assert_eq!(median([]), 0.0);
    }

    #[test]
    fn every_job_has_its_turn_in_every_round() {
        let mut order = Vec::new();
        let results = in_turns(3, 3, |j| {
            order.push(j);
            j * 10
        });
        assert_eq!(results, [[0; 3], [10; 3], [20; 3]]);
        assert_eq!(order, [0, 1, 2, 1, 2, 0, 2, 0, 1]);
    }

    #[test]
    fn rounds_fill_the_budget_within_their_limits() {
        let ms = Duration::from_millis;
        assert_eq!(Effort::FULL.rounds(ms(600)), 5);
        assert_eq!(Effort::FULL.rounds(ms(60)), 10);
        assert_eq!(Effort::FULL.rounds(Duration::ZERO), 25);
    }
}
