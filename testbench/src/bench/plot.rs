//! Pictures of run time against error: for one scene at one size, a row of panels for each exponent, on the left the RMS
//! error and on the right the largest; both axes logarithmic, no error at all on the floor. Filled dots joined by steps
//! are the Pareto front, hollow ones are beaten by it.

use super::row::Row;
use super::BenchError;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Size of a panel, pixels.
const PANEL: (u32, u32) = (620, 400);
const FONT: &str = "sans-serif";
const LABEL: u32 = 12;
const ON_FRONT: RGBColor = RGBColor(176, 48, 32);
const BEATEN: RGBColor = RGBColor(110, 110, 110);

/// A kind of error as an axis.
struct Axis {
    name: &'static str,
    error: fn(&Row) -> f64,
    front: fn(&Row) -> bool,
    /// Where errors of zero are drawn; below every other error that can occur.
    floor: f64,
}

const AXES: [Axis; 2] = [
    Axis {
        name: "RMS error, LSB",
        error: |r| r.rms_lsb,
        front: |r| r.front_rms,
        floor: 1e-3,
    },
    Axis {
        name: "largest error, LSB",
        error: |r| f64::from(r.max_lsb),
        front: |r| r.front_max,
        floor: 0.5,
    },
];

/// A dot of a panel.
struct Dot<'a> {
    ms: f64,
    error: f64,
    front: bool,
    name: &'a str,
}

/// The picture of the rows of one scene at one size, as SVG.
///
/// # Errors
/// When the plotting library refuses.
pub fn svg(rows: &[&Row]) -> Result<String, BenchError> {
    let mut exponents: Vec<u32> = rows.iter().map(|r| r.exponent).collect();
    exponents.sort_unstable();
    exponents.dedup();
    let mut text = String::new();
    let size = (2 * PANEL.0, PANEL.1 * exponents.len().max(1) as u32);
    {
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        root.fill(&WHITE).map_err(fault)?;
        let panels = root.split_evenly((exponents.len().max(1), 2));
        for (k, area) in panels.iter().enumerate() {
            let Some(exponent) = exponents.get(k / 2) else {
                continue;
            };
            let rows: Vec<&Row> = rows
                .iter()
                .copied()
                .filter(|r| r.exponent == *exponent)
                .collect();
            panel(area, &rows, &AXES[k % 2]).map_err(fault)?;
        }
        root.present().map_err(fault)?;
    }
    Ok(text)
}

fn fault(e: impl std::fmt::Display) -> BenchError {
    BenchError::Plot(e.to_string())
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Fault<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

fn panel<'a>(area: &Area<'a>, rows: &[&Row], axis: &Axis) -> Result<(), Fault<'a>> {
    let dots: Vec<Dot<'_>> = rows
        .iter()
        .map(|r| Dot {
            ms: (r.ns_per_frame / 1e6).max(1e-6),
            error: (axis.error)(r).max(axis.floor),
            front: (axis.front)(r),
            name: r.method,
        })
        .collect();
    let (Some(first), Some(widest)) = (rows.first(), range(&dots, |d| d.ms)) else {
        return Ok(());
    };
    let highest = range(&dots, |d| d.error).map_or(1.0, |r| r.1);
    let title = format!(
        "{}, n = {}, {}x{}",
        first.scene, first.exponent, first.width, first.height
    );
    // Room for labels to the right of the last dot.
    let (x, y) = (
        (widest.0 / 1.3)..(widest.1 * (widest.1 / widest.0).powf(0.25) * 1.3),
        (axis.floor / 1.4)..(highest * 1.6),
    );
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .caption(title, (FONT, 16))
        .x_label_area_size(36)
        .y_label_area_size(56)
        .build_cartesian_2d(x.log_scale(), y.log_scale())?;
    chart
        .configure_mesh()
        .x_desc("ms per frame")
        .y_desc(axis.name)
        .light_line_style(TRANSPARENT)
        .bold_line_style(RGBColor(220, 220, 220))
        .x_label_formatter(&|v| number(*v))
        .y_label_formatter(&|v| {
            if *v <= axis.floor * 1.01 {
                "0".to_owned()
            } else {
                number(*v)
            }
        })
        .draw()?;
    let steps = steps(&dots);
    chart.draw_series(LineSeries::new(steps, ON_FRONT.stroke_width(2)))?;
    for d in &dots {
        let style = if d.front {
            ON_FRONT.filled()
        } else {
            BEATEN.stroke_width(1)
        };
        chart.draw_series([Circle::new((d.ms, d.error), 4, style)])?;
    }
    let places: Vec<(i32, i32)> = dots
        .iter()
        .map(|d| chart.backend_coord(&(d.ms, d.error)))
        .collect();
    for (i, (x, y)) in labels(&dots, &places) {
        let colour = if dots[i].front { ON_FRONT } else { BEATEN };
        let style = (FONT, LABEL)
            .into_font()
            .color(&colour)
            .pos(Pos::new(HPos::Left, VPos::Center));
        let (left, top) = area.get_pixel_range();
        area.draw_text(dots[i].name, &style, (x - left.start, y - top.start))?;
    }
    Ok(())
}

/// Least and greatest of the dots.
fn range(dots: &[Dot<'_>], f: impl Fn(&Dot<'_>) -> f64) -> Option<(f64, f64)> {
    let values = || dots.iter().map(&f);
    let least = values().reduce(f64::min)?;
    Some((least, values().fold(least, f64::max)))
}

/// The front as steps: between two of its dots nothing better is to be had than the faster one.
fn steps(dots: &[Dot<'_>]) -> Vec<(f64, f64)> {
    let mut on: Vec<&Dot<'_>> = dots.iter().filter(|d| d.front).collect();
    on.sort_by(|a, b| a.ms.total_cmp(&b.ms));
    let mut line: Vec<(f64, f64)> = Vec::new();
    for d in on {
        if let Some(last) = line.last() {
            line.push((d.ms, last.1));
        }
        line.push((d.ms, d.error));
    }
    line
}

/// Where names fit beside their dots without covering one another or a dot: pixels of the left end, by dot. Names of
/// the front are placed first; those that find no room are left out, and stand in the table.
fn labels(dots: &[Dot<'_>], places: &[(i32, i32)]) -> Vec<(usize, (i32, i32))> {
    let mut order: Vec<usize> = (0..dots.len()).collect();
    order.sort_by_key(|i| !dots[*i].front);
    let mut taken: Vec<[i32; 4]> = places
        .iter()
        .map(|(x, y)| [x - 4, y - 4, x + 4, y + 4])
        .collect();
    let mut out = Vec::new();
    for i in order {
        let width = dots[i].name.len() as i32 * 6 + 2;
        let (x, y) = places[i];
        let tries = [
            (x + 5, y - 10),
            (x + 7, y),
            (x + 5, y + 10),
            (x - 7 - width, y),
            (x - 5 - width, y - 10),
            (x - 5 - width, y + 10),
            (x + 7, y - 18),
            (x + 7, y + 18),
        ];
        let spot = tries.into_iter().find(|(x, y)| {
            let b = [*x, *y - 5, *x + width, *y + 5];
            !taken
                .iter()
                .any(|t| b[0] < t[2] && t[0] < b[2] && b[1] < t[3] && t[1] < b[3])
        });
        if let Some((x, y)) = spot {
            taken.push([x, y - 5, x + width, y + 5]);
            out.push((i, (x, y)));
        }
    }
    out
}

/// A number without needless zeros.
fn number(v: f64) -> String {
    let text = format!("{v:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::super::row::sample;
    use super::*;

    #[test]
    fn every_front_method_is_named_and_the_front_is_drawn_filled() {
        let mut rows = [
            sample("flat", 1e6, 90, 12.0),
            sample("gouraud", 1.2e6, 30, 3.0),
            sample("slow", 9e6, 40, 4.0),
            sample("exact", 7e6, 0, 0.0),
        ];
        rows[2].front_rms = false;
        for r in &mut rows {
            r.front_max = r.front_rms;
        }
        let text = svg(&rows.iter().collect::<Vec<_>>()).unwrap();
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"));
        for name in ["flat", "gouraud", "exact", "slow"] {
            // Once in each of the two panels.
            assert_eq!(
                text.matches(&format!("\n{name}\n")).count(),
                2,
                "{name}\n{text}"
            );
        }
        let filled = text.matches("<circle").count() - text.matches("fill=\"none\"").count();
        assert!(
            text.matches("<circle").count() == 8 && filled >= 6,
            "{text}"
        );
        assert!(text.contains("sphere-690, n = 20, 320x240"));
        assert!(!text.contains("NaN") && !text.contains("inf"));
    }

    #[test]
    fn equal_times_and_nothing_at_all_are_drawn_too() {
        let rows = [sample("a", 1e6, 0, 0.0), sample("b", 1e6, 0, 0.0)];
        assert!(svg(&rows.iter().collect::<Vec<_>>()).is_ok());
        assert!(svg(&[]).is_ok());
    }

    #[test]
    fn labels_do_not_cover_one_another() {
        let dots: Vec<Dot<'_>> = (0..30)
            .map(|i| Dot {
                ms: 1.0,
                error: 1.0,
                front: i % 7 == 0,
                name: "quadratic",
            })
            .collect();
        let places: Vec<(i32, i32)> = (0..30).map(|i| (100 + i * 3, 100 + i % 4 * 9)).collect();
        let placed = labels(&dots, &places);
        assert!(placed.len() >= 5 && placed.len() < 30);
        for (k, (_, a)) in placed.iter().enumerate() {
            for (_, b) in &placed[..k] {
                assert!((a.0 - b.0).abs() >= 56 || (a.1 - b.1).abs() >= 10);
            }
        }
        assert!(dots[placed[0].0].front);
    }
}
