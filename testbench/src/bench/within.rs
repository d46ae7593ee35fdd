//! The answer that the sweep is made for: the fastest method whose error stays within what one accepts.

use super::row::Row;
use super::write::groups;
use std::fmt::Write;

/// Errors that are asked about: the largest difference of a channel from `exact`, in LSB.
pub const ACCEPTED: [u8; 6] = [0, 1, 2, 5, 10, 20];

/// The fastest method of one task whose largest difference is at most `accepted`; of equally fast ones the nearer.
#[must_use]
pub fn fastest_within<'a>(task: &[&'a Row], accepted: u8) -> Option<&'a Row> {
    let good = task.iter().filter(|r| r.max_lsb <= accepted);
    good.min_by(|a, b| {
        let time = a.ns_per_frame.total_cmp(&b.ns_per_frame);
        time.then(a.rms_lsb.total_cmp(&b.rms_lsb))
    })
    .copied()
}

/// A table: a row per task, a column per accepted error. Times are those of a frame, as users get it.
#[must_use]
pub fn table(rows: &[Row]) -> String {
    let mut out = "| scene | n | size |".to_owned();
    for e in ACCEPTED {
        // Writing to a string cannot fail.
        let _ = write!(out, " at most {e} LSB |");
    }
    out += "\n|---|---:|---|";
    out += &"---|".repeat(ACCEPTED.len());
    out.push('\n');
    for task in groups(rows, Row::same_task) {
        let first = task[0];
        let _ = write!(
            out,
            "| {} | {} | {}x{} |",
            first.scene, first.exponent, first.width, first.height
        );
        for e in ACCEPTED {
            out += &match fastest_within(&task, e) {
                Some(r) => format!(" {} {:.3} ms |", r.method, r.ns_per_frame / 1e6),
                None => " - |".to_owned(),
            };
        }
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::row::sample;
    use super::*;

    #[test]
    fn the_fastest_that_is_near_enough() {
        let mut rows = vec![
            sample("exact", 9e6, 0, 0.0),
            sample("gouraud", 1e6, 30, 3.0),
            sample("quadratic", 2e6, 5, 0.5),
            sample("quadratic-dots", 2e6, 5, 0.1),
            sample("slow", 3e6, 5, 0.0),
        ];
        let task: Vec<&Row> = rows.iter().collect();
        let name = |e: u8| fastest_within(&task, e).map(|r| r.method);
        assert_eq!(name(0), Some("exact"));
        assert_eq!(name(4), Some("exact"));
        assert_eq!(name(5), Some("quadratic-dots"));
        assert_eq!(name(30), Some("gouraud"));
        assert_eq!(fastest_within(&task[1..], 4).map(|r| r.method), None);

        let mut other = sample("flat", 1e6, 90, 9.0);
        other.exponent = 50;
        rows.push(other);
        let text = table(&rows);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[2],
            "| sphere-690 | 20 | 320x240 | exact 9.000 ms | exact 9.000 ms | exact 9.000 ms | quadratic-dots 2.000 ms | \
             quadratic-dots 2.000 ms | quadratic-dots 2.000 ms |"
        );
        assert_eq!(
            lines[3],
            "| sphere-690 | 50 | 320x240 | - | - | - | - | - | - |"
        );
    }
}
