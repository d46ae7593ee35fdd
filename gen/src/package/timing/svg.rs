//! The diagram as a picture: lines and text only, readable on light and dark ground.

use super::{Diagram, Row};
use std::fmt::Write;

/// Width of the names, of a clock, of the slope of an edge; height of a line and of a level.
const NAMES: usize = 88;
const CLOCK: usize = 72;
const SLOPE: usize = 4;
const LINE: usize = 28;
const LEVEL: usize = 16;
/// Height of title and clock numbers.
const HEAD: usize = 44;

/// Text of `doc/timing.svg`.
#[must_use]
pub fn svg(d: &Diagram) -> String {
    let width = NAMES + d.clocks * CLOCK + 8;
    let height = HEAD + d.rows.len() * LINE + 8;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"monospace\" font-size=\"11\">\n\
         <title>{title}</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n\
         <text x=\"8\" y=\"16\" font-weight=\"bold\">{title}</text>\n",
        title = d.title
    );
    for clock in 0..d.clocks {
        let x = left(clock);
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "<line x1=\"{x}\" y1=\"{HEAD}\" x2=\"{x}\" y2=\"{}\" stroke=\"#ddd\"/>\n\
             <text x=\"{}\" y=\"34\" fill=\"#666\" text-anchor=\"middle\">{clock}</text>",
            height - 8,
            x + CLOCK / 2
        );
    }
    for (i, row) in d.rows.iter().enumerate() {
        let top = HEAD + i * LINE + 6;
        let name = match row {
            Row::Clock => "clock",
            Row::Bit(name, _) | Row::Bus(name, _) => name,
        };
        let _ = writeln!(out, "<text x=\"8\" y=\"{}\">{name}</text>", top + 12);
        match row {
            Row::Clock => clock_line(&mut out, d.clocks, top),
            Row::Bit(_, levels) => bit_line(&mut out, levels, top),
            Row::Bus(_, cells) => bus_line(&mut out, cells, top),
        }
    }
    out.push_str("</svg>\n");
    out
}

/// Left end of a clock.
fn left(clock: usize) -> usize {
    NAMES + clock * CLOCK
}

fn level(top: usize, high: bool) -> usize {
    if high {
        top
    } else {
        top + LEVEL
    }
}

fn polyline(out: &mut String, points: &[(usize, usize)], fill: &str) {
    let list: Vec<String> = points.iter().map(|(x, y)| format!("{x},{y}")).collect();
    let _ = writeln!(
        out,
        "<polyline points=\"{}\" fill=\"{fill}\" stroke=\"#000\"/>",
        list.join(" ")
    );
}

/// High in the first half of a clock; the edge that ends a clock rises at its right end.
fn clock_line(out: &mut String, clocks: usize, top: usize) {
    let mut points = vec![];
    for clock in 0..clocks {
        let (x, half) = (left(clock), left(clock) + CLOCK / 2);
        for (x, high) in [(x, false), (x, true), (half, true), (half, false)] {
            points.push((x, level(top, high)));
        }
    }
    points.push((left(clocks), level(top, false)));
    points.push((left(clocks), level(top, true)));
    polyline(out, &points, "none");
}

fn bit_line(out: &mut String, levels: &[bool], top: usize) {
    let mut points = vec![];
    for (clock, high) in levels.iter().enumerate() {
        points.push((left(clock) + SLOPE, level(top, *high)));
        points.push((left(clock + 1), level(top, *high)));
    }
    polyline(out, &points, "none");
}

fn bus_line(out: &mut String, cells: &[Option<String>], top: usize) {
    let mut clock = 0;
    while clock < cells.len() {
        let same = cells[clock..]
            .iter()
            .take_while(|c| **c == cells[clock])
            .count();
        let (a, b) = (left(clock), left(clock + same));
        let middle = top + LEVEL / 2;
        match &cells[clock] {
            Some(label) => {
                let hexagon = [
                    (a, middle),
                    (a + SLOPE, top),
                    (b - SLOPE, top),
                    (b, middle),
                    (b - SLOPE, top + LEVEL),
                    (a + SLOPE, top + LEVEL),
                    (a, middle),
                ];
                polyline(out, &hexagon, "#eef3fa");
                let _ = writeln!(
                    out,
                    "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
                    (a + b) / 2,
                    top + 12
                );
            }
            None => polyline(out, &[(a, middle), (b, middle)], "none"),
        }
        clock += same;
    }
}
