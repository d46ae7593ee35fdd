//! Register words of a line from one of its columns on: exact integers, and the real numbers rounded to nearest once.
//!
//! A line core starts at any column of the walk, so a host sends only what is visible and in the frame; the words of that
//! column are formed from the line's own ends, not from the piece's, and so the pixels are the same.

use super::rational::residue;
use shadegate_hdl::format::quantise;
use shadegate_hdl::line::{cone_words, cue, Filter};
use shadegate_reference::line::set_up::SetUp;
use shadegate_reference::line::{cone, Path};

/// Most columns of a whole line: its error term has 14 bits.
pub const MAX_COLUMNS: i32 = 4095;
/// Most columns of a piece.
pub const MAX_PIECE: i32 = 1 << 11;

/// Exact state of a walk behind column `x`: rows passed, then error term, stay, step.
struct Walk {
    row: i64,
    error: [i64; 3],
}

fn walk(filter: Filter, path: &Path, x: i64) -> Walk {
    let (dx, dy) = (i64::from(path.major), i64::from(path.minor));
    if dx == 0 {
        return Walk {
            row: 0,
            error: [0; 3],
        };
    }
    match filter {
        // The row nearest to the line, halves down.
        Filter::Bresenham | Filter::Cone => {
            let row = (2 * dy * x + dx - 1).div_euclid(2 * dx);
            Walk {
                row,
                error: [2 * dy * (x + 1) - 2 * dx * row - dx, 2 * dy, 2 * (dy - dx)],
            }
        }
        // The row below the line; E > 0 where the next column reaches the row after it.
        Filter::Box => {
            let row = dy * x / dx;
            Walk {
                row,
                error: [dy * (x + 1) - dx * (row + 1) + 1, dy, dy - dx],
            }
        }
    }
}

/// Level, whole levels, tie and error term of the box filter behind column `x` in row `row`.
fn box_words(path: &Path, x: i64, row: i64) -> [i64; 4] {
    let (dx, dy) = (i64::from(path.major), i64::from(path.minor));
    if dx == 0 {
        return [0; 4];
    }
    let (whole, rest) = (255 * dy / dx, 255 * dy % dx);
    let doubled = 2 * rest * x + dx;
    let carries = doubled / (2 * dx);
    let level = whole * x + carries - 255 * row;
    let tie = x > 0 && doubled % (2 * dx) == 0;
    [
        i64::from(tie) << 16 | whole << 8 | level,
        2 * rest * (x + 1) + dx - 2 * dx * (carries + 1) + 1,
        2 * rest,
        2 * (rest - dx),
    ]
}

/// Words of the walk and the weights, from word 0 on, for `columns` columns of a line from column `first` on, in a frame
/// of `width` columns.
///
/// # Errors
/// Lines longer than the core's error term holds.
pub fn line_words(
    filter: Filter,
    path: &Path,
    first: i32,
    columns: i32,
    width: u32,
) -> Result<Vec<u64>, String> {
    if path.major >= MAX_COLUMNS || !(1..=MAX_PIECE).contains(&columns) {
        return Err(format!(
            "{} columns; the core's lines have at most {MAX_COLUMNS}",
            i64::from(path.major) + 1
        ));
    }
    let s = SetUp::new(path);
    let x = i64::from(first);
    let w = walk(filter, path, x);
    let place = path.place(first, w.row as i32);
    let (major, minor) = if path.steep {
        (place.y, place.x)
    } else {
        (place.x, place.y)
    };
    let last_lane = match filter {
        Filter::Bresenham => 0,
        Filter::Box => 1,
        Filter::Cone if path.major == 0 => 0,
        Filter::Cone if s.fourth => 3,
        Filter::Cone => 2,
    };
    let word = |v: i64, bits: u32| residue(i128::from(v), bits);
    let address = i64::from(place.y) * i64::from(width) + i64::from(place.x);
    let mut out = vec![
        last_lane << 13
            | u64::from(path.falling) << 12
            | u64::from(path.steep) << 11
            | word(i64::from(columns) - 1, 11),
        word(i64::from(minor), 12) << 12 | word(i64::from(major), 12),
        word(address, 32),
    ];
    out.extend(w.error.map(|v| word(v, 14)));
    match filter {
        Filter::Bresenham => {}
        Filter::Box => {
            let [level, error, up, down] = box_words(path, x, w.row);
            out.push(word(level, 32));
            out.extend([error, up, down].map(|v| word(v, 14)));
        }
        Filter::Cone => {
            let at = path.columns().nth(first as usize);
            let d = at.map_or(0.0, |c| cone::distance(path, c));
            for v in [s.cosine, d, s.distance_stay, s.distance_step] {
                let code = quantise(v, 1, cone_words::FRACTION_BITS as u32);
                // All are within ±1, see the ranges of the set-up.
                out.push(word(code.unwrap_or(0), 32));
            }
        }
    }
    Ok(out)
}

/// The two words of a colour channel, LSB, from `value` on by `step` per column.
#[must_use]
pub fn cue_words(value: f64, step: f64) -> [u64; 2] {
    let code = |v: f64| {
        let clamped = v.clamp(-255.0, 255.0);
        quantise(clamped, 11, cue::FRACTION_BITS as u32).unwrap_or(0)
    };
    let half = 1 << (cue::FRACTION_BITS - 1);
    [code(value) + half, code(step)].map(|c| residue(i128::from(c), 32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use shadegate_hdl::line::walk_model::{WalkInputs, WalkModel};
    use shadegate_reference::line::Pixel;

    /// Walking to a column and starting there are the same, for every column of many lines.
    #[test]
    fn a_piece_continues_its_line() {
        for (dx, dy) in [
            (40, 17),
            (40, 40),
            (40, 0),
            (1, 1),
            (0, 0),
            (17, -5),
            (6, 30),
            (-9, 30),
        ] {
            let p = |x, y| Pixel { x, y };
            let path = Path::new(p(50, 50), p(50 + dx, 50 + dy)).expect("in range");
            for filter in Filter::ALL {
                let start = |first: i32| {
                    let columns = path.major + 1 - first;
                    let words = line_words(filter, &path, first, columns, 100).expect("fits");
                    let mut m = WalkModel::new(17);
                    let mut i = WalkInputs {
                        go: true,
                        whole: true,
                        ..WalkInputs::default()
                    };
                    i.write = Some((11, 100 << 12 | 100));
                    m.clock(&i);
                    for w in words.into_iter().enumerate().take(6) {
                        i.write = Some(w);
                        m.clock(&i);
                    }
                    i.write = None;
                    i.start = true;
                    m.clock(&i);
                    i.start = false;
                    m.clock(&i);
                    (m, i)
                };
                let (mut whole, i) = start(0);
                for first in 0..=path.major {
                    assert_eq!(whole.at, start(first).0.at, "{path:?} {filter:?} {first}");
                    whole.clock(&i);
                }
                assert!(!whole.active);
            }
        }
    }

    #[test]
    fn what_is_too_long_is_refused() {
        let p = |x, y| Pixel { x, y };
        let path = Path::new(p(0, 0), p(4095, 3)).expect("in range");
        let e = line_words(Filter::Cone, &path, 0, 9, 100).expect_err("too long");
        assert_eq!(e, "4096 columns; the core's lines have at most 4095");
    }
}
