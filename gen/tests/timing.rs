//! The timing diagram is true: what it shows is what the rust-hdl description does, and JSON and SVG show the same.

use serde_json::Value;
use shadegate_gen::package::timing::{diagram, svg, wavedrom, Diagram, Row};
use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs, Order};

const CASES: [(Order, u32, u32); 5] = [
    (Order::Linear, 320, 240),
    (Order::Quadratic, 64, 48),
    (Order::Quadratic, 640, 480),
    (Order::Linear, 2, 1),
    (Order::Quadratic, 1, 2),
];

fn made(case: (Order, u32, u32)) -> (Core, Diagram) {
    let (order, width, height) = case;
    let core = Core::for_frame(order, width, height).expect("in range");
    (core, diagram(&core, (width, height)).expect("drawn"))
}

/// The lines of a WaveDrom text, every clock spelt out: `0` and `1`, `x` or a label.
fn expanded(text: &str) -> Vec<(String, Vec<String>)> {
    let whole: Value = serde_json::from_str(text).expect("JSON");
    let signals = whole["signal"].as_array().expect("signals");
    let one = |s: &Value| {
        let mut labels = s["data"].as_array().into_iter().flatten();
        let mut now = String::new();
        let wave = s["wave"].as_str().expect("wave").chars().map(|symbol| {
            match symbol {
                '.' => {}
                '=' => {
                    now = labels
                        .next()
                        .and_then(Value::as_str)
                        .expect("label")
                        .to_owned()
                }
                other => now = other.to_string(),
            }
            now.clone()
        });
        let wave: Vec<String> = wave.collect();
        assert!(labels.next().is_none(), "a label too many");
        (s["name"].as_str().expect("name").to_owned(), wave)
    };
    signals.iter().map(one).collect()
}

#[test]
fn the_description_does_what_the_diagram_shows() {
    for case in CASES {
        let (core, d) = made(case);
        let rows = expanded(&wavedrom(&d));
        let row = |name: &str| &rows.iter().find(|r| r.0 == name).expect(name).1;
        let bit = |name: &str, clock: usize| row(name)[clock] == "1";
        // The words before those that are shown: whatever the host wrote, replayed from the set-up of the package.
        let mut simulator = CoreSimulator::new(core).expect("checks");
        let inputs =
            shadegate_gen::package::timing::inputs(&core, (case.1, case.2)).expect("drawn");
        let hidden = inputs.len() - d.clocks;
        let mut outputs = CoreOutputs::default();
        for (i, sent) in inputs.iter().enumerate() {
            if let Some(clock) = i.checked_sub(hidden) {
                let word = |name: &str| u64::from_str_radix(&row(name)[clock], 16).ok();
                let shown = CoreInputs {
                    write: bit("write", clock),
                    select: word("select").unwrap_or(0) as u8,
                    data: word("data").unwrap_or(0),
                    start: bit("start", clock),
                    clear: false,
                    ready: bit("ready", clock),
                    ..CoreInputs::default()
                };
                assert_eq!(shown, *sent, "{case:?} clock {clock}");
                for (name, level) in [
                    ("load_ready", outputs.load_ready),
                    ("busy", outputs.busy),
                    ("valid", outputs.valid),
                    ("done", outputs.done),
                ] {
                    assert_eq!(bit(name, clock), level, "{case:?} {name} clock {clock}");
                }
                let [r, g, b] = outputs.rgb;
                for (name, value) in [
                    ("x, y", format!("{}, {}", outputs.x, outputs.y)),
                    ("colour", format!("{r:02x}{g:02x}{b:02x}")),
                    ("depth", format!("{:04x}", outputs.depth)),
                ] {
                    let want = if outputs.valid { &value } else { "x" };
                    assert_eq!(row(name)[clock], want, "{case:?} {name} clock {clock}");
                }
            }
            simulator.clock(sent);
            outputs = simulator.outputs();
        }
    }
}

#[test]
fn it_shows_what_it_is_for() {
    for case in CASES {
        let (_, d) = made(case);
        let rows = expanded(&wavedrom(&d));
        let row = |name: &str| &rows.iter().find(|r| r.0 == name).expect(name).1;
        let count = |name: &str, level: &str| row(name).iter().filter(|v| *v == level).count();
        assert_eq!(count("start", "1"), 1);
        assert_eq!(count("done", "1"), 1);
        assert_eq!(count("ready", "0"), 1, "one clock of back pressure");
        assert!(count("valid", "1") >= 2);
        let start = row("start").iter().position(|v| v == "1").expect("start");
        let first = row("valid").iter().position(|v| v == "1").expect("pixel");
        assert_eq!(first - start, 6, "the manifest's latency");
        let pause = row("ready").iter().position(|v| v == "0").expect("pause");
        assert_eq!(row("valid")[pause], "1");
        assert_eq!(
            row("x, y")[pause],
            row("x, y")[pause + 1],
            "the pixel stays"
        );
    }
}

#[test]
fn the_picture_shows_the_same_levels() {
    for case in CASES {
        let (_, d) = made(case);
        let text = svg(&d);
        assert!(text.is_ascii() && text.starts_with("<svg ") && text.ends_with("</svg>\n"));
        for (index, row) in d.rows.iter().enumerate() {
            let name = match row {
                Row::Clock => "clock",
                Row::Bit(name, _) | Row::Bus(name, _) => name,
            };
            let rest = text.split(&format!(">{name}</text>\n")).nth(1).expect(name);
            match row {
                Row::Clock => {}
                Row::Bit(_, levels) => {
                    let points = rest
                        .split("points=\"")
                        .nth(1)
                        .and_then(|p| p.split('"').next());
                    let heights: Vec<usize> = (points.expect("a line").split(' '))
                        .filter_map(|p| p.split(',').nth(1)?.parse().ok())
                        .collect();
                    let low = heights.iter().max().expect("points");
                    // A line that never changes is high or low by its height alone.
                    let bottom = 44 + index * 28 + 6 + 16;
                    assert!(*low <= bottom);
                    let drawn: Vec<bool> = heights.chunks(2).map(|c| c[0] != bottom).collect();
                    assert_eq!(&drawn, levels, "{case:?} {name}");
                }
                Row::Bus(_, cells) => {
                    let own = rest.split("<text x=\"8\"").next().expect("own part");
                    let mut want: Vec<&String> = cells.iter().flatten().collect();
                    want.dedup();
                    let shown: Vec<&str> = (own.split("text-anchor=\"middle\">").skip(1))
                        .filter_map(|t| t.split('<').next())
                        .collect();
                    assert_eq!(shown, want, "{case:?} {name}");
                }
            }
        }
    }
}
