//! The diagram as WaveDrom JSON.

use super::{Diagram, Row};
use serde_json::{json, Value};

/// Text of `doc/timing.json`.
#[must_use]
pub fn wavedrom(d: &Diagram) -> String {
    let signals: Vec<Value> = d.rows.iter().map(|r| row(r, d.clocks)).collect();
    let whole = json!({
        "signal": signals,
        "head": { "text": d.title, "tick": 0 },
        "config": { "hscale": 2 },
    });
    serde_json::to_string_pretty(&whole).unwrap_or_default() + "\n"
}

fn row(row: &Row, clocks: usize) -> Value {
    match row {
        Row::Clock => {
            let rest = ".".repeat(clocks.saturating_sub(1));
            json!({ "name": "clock", "wave": format!("p{rest}") })
        }
        Row::Bit(name, levels) => {
            let wave = runs(levels, |level| if *level { '1' } else { '0' });
            json!({ "name": name, "wave": wave })
        }
        Row::Bus(name, cells) => {
            let wave = runs(cells, |cell| if cell.is_some() { '=' } else { 'x' });
            let labels: Vec<&String> = wave
                .chars()
                .zip(cells)
                .filter(|(symbol, _)| *symbol == '=')
                .filter_map(|(_, cell)| cell.as_ref())
                .collect();
            json!({ "name": name, "wave": wave, "data": labels })
        }
    }
}

/// One symbol per clock, a dot where nothing changes.
fn runs<T: PartialEq>(values: &[T], symbol: impl Fn(&T) -> char) -> String {
    let first = values.first().map(&symbol);
    let pairs = values.windows(2).map(|w| match w {
        [a, b] if a == b => '.',
        [.., b] => symbol(b),
        [] => '.',
    });
    first.into_iter().chain(pairs).collect()
}
