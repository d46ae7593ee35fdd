//! Several renderers at one task, taking turns.

use shadegate_testbench::bench::clock::{in_turns, median, Effort};
use std::time::{Duration, Instant};

/// What one run took, in nanoseconds.
#[derive(Clone, Copy, Debug)]
pub struct Took {
    /// The part that a comparison singles out, for instance drawing without set-up.
    pub part: f64,
    /// Everything.
    pub whole: f64,
}

impl Took {
    /// Of a job that is left out.
    pub const NOTHING: Self = Self {
        part: f64::NAN,
        whole: f64::NAN,
    };
}

/// The time of something that is not divided.
pub fn time(what: impl FnOnce()) -> Took {
    let begin = Instant::now();
    what();
    let ns = begin.elapsed().as_nanos() as f64;
    Took {
        part: ns,
        whole: ns,
    }
}

/// A renderer at the task.
pub type Job<'a> = Box<dyn FnMut() -> Took + 'a>;

/// Which of the two times.
pub type Which = fn(&Took) -> f64;
/// The part.
pub const PART: Which = |t| t.part;
/// The whole.
pub const WHOLE: Which = |t| t.whole;

/// Times by renderer and round.
pub struct Times(Vec<Vec<Took>>);

impl Times {
    /// Runs each once to warm up, then in rounds.
    pub fn measure(mut jobs: Vec<Job<'_>>, effort: Effort) -> Self {
        let begin = Instant::now();
        for job in &mut jobs {
            job();
        }
        let rounds = effort.rounds(begin.elapsed().max(Duration::from_nanos(1)));
        Self(in_turns(jobs.len(), rounds, |j| jobs[j]()))
    }

    /// Median nanoseconds of a job; none if there was no such job.
    pub fn ns(&self, job: usize, which: Which) -> Option<f64> {
        Some(median(self.0.get(job)?.iter().map(which)))
    }

    /// Median over the rounds of how many times longer `a` takes than `b`.
    pub fn ratio(&self, a: (usize, Which), b: (usize, Which)) -> Option<f64> {
        let pairs = self.0.get(a.0)?.iter().zip(self.0.get(b.0)?);
        Some(median(pairs.map(|(s, t)| a.1(s) / b.1(t))))
    }
}

/// A cell of a table; a dash for what was not measured.
pub fn cell(v: Option<f64>, show: impl FnOnce(f64) -> String) -> String {
    v.filter(|v| v.is_finite())
        .map_or_else(|| "-".to_owned(), show)
}
