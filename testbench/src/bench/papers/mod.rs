//! The comparisons that the papers printed, made again: ratios of run times, and break-even points from operation
//! counts. Absolute times of machines long gone mean nothing here, so each claim is a ratio or a count.

mod abbas;
mod blake;
mod hast;

use super::clock::Effort;
use super::{BenchError, OnStep};
use serde::Serialize;

/// Ratios this far apart, either way, still count as reproduced.
pub const TOLERANCE: f64 = 1.25;

/// Something that a paper says and we can check.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Claim {
    /// Author, year and place.
    pub source: &'static str,
    /// What is compared with what.
    pub what: String,
    /// In which unit: a ratio of times, or pixels.
    pub unit: &'static str,
    /// The figure of the paper.
    pub paper: f64,
    /// Our figure.
    pub ours: f64,
    /// Whether it is reproduced: a ratio within [`TOLERANCE`] with the same winner, a count exactly.
    pub reproduced: bool,
    /// Whether at least the same side wins; null for counts, where nobody does.
    pub same_winner: Option<bool>,
    /// What is to be said about it; may be empty.
    pub note: &'static str,
}

impl Claim {
    /// A ratio of times: `paper` and `ours` say how many times longer the first takes than the second.
    fn ratio(
        source: &'static str,
        what: String,
        paper: f64,
        ours: f64,
        note: &'static str,
    ) -> Self {
        let same_winner = (paper > 1.0) == (ours > 1.0);
        let apart = (paper / ours).max(ours / paper);
        Self {
            source,
            what,
            unit: "ratio",
            paper,
            ours,
            reproduced: same_winner && apart <= TOLERANCE,
            same_winner: Some(same_winner),
            note,
        }
    }

    /// A number of pixels, which is reproduced exactly or not at all.
    fn pixels(
        source: &'static str,
        what: String,
        paper: u32,
        ours: u32,
        note: &'static str,
    ) -> Self {
        Self {
            source,
            what,
            unit: "pixels",
            paper: paper.into(),
            ours: ours.into(),
            reproduced: paper == ours,
            same_winner: None,
            note,
        }
    }
}

impl Claim {
    /// A figure in its unit, as text.
    #[must_use]
    pub fn figure(&self, v: f64) -> String {
        if self.same_winner.is_some() {
            format!("{v:.3}")
        } else {
            format!("{v:.0}")
        }
    }

    /// Whether it is reproduced, in words.
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        match (self.reproduced, self.same_winner) {
            (true, _) => "yes",
            (false, Some(true)) => "no, but the same wins",
            (false, _) => "no",
        }
    }
}

/// A group of claims.
type Group = fn(Effort) -> Result<Vec<Claim>, BenchError>;

/// Checks every claim; each step is one group of them.
///
/// # Errors
/// When a scene cannot be prepared.
pub fn papers(effort: Effort, on_step: &mut OnStep<'_>) -> Result<Vec<Claim>, BenchError> {
    let groups: [(&str, Group); 3] = [
        ("Abbas: sphere of 690 triangles", abbas::claims),
        ("Hast: set-ups, bumps, spotlights", |e| Ok(hast::claims(e))),
        ("Blake: break-even points", |_| Ok(blake::claims())),
    ];
    let mut claims = Vec::new();
    for (i, (what, group)) in groups.iter().enumerate() {
        on_step(i, groups.len(), what);
        claims.extend(group(effort)?);
    }
    Ok(claims)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_is_reproduced_within_the_tolerance_and_on_the_same_side() {
        let claim = |paper, ours| Claim::ratio("", String::new(), paper, ours, "");
        assert!(claim(2.0, 2.4).reproduced && claim(2.0, 1.61).reproduced);
        assert!(!claim(2.0, 2.6).reproduced && claim(2.0, 2.6).same_winner == Some(true));
        assert!(!claim(1.1, 0.95).reproduced && claim(1.1, 0.95).same_winner == Some(false));
    }
}
