//! What the pixels of a span core must be: the software method in f64, every span from its own first pixel.
//!
//! A table has steps. Where the exact angle lies within the rounding of a phase from the next word of the table, that
//! word is as good: the phase after k pixels is within (1 + k)·2^−15 of a word, so the method is also evaluated with its
//! phases moved by 1/16 word either way, and the nearest of the values counts.

use super::Prelude;
use shadegate_gen::scene::method_of;
use shadegate_gen::spans::{Curves, Surface};
use shadegate_gen::vectors::Pixel;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use shadegate_reference::raster::{Span, Viewport, Walk};
use shadegate_reference::shade::circular::Ends;
use shadegate_reference::shade::curve::Rom;
use shadegate_reference::shade::dispatch::{dispatch, Visitor};
use shadegate_reference::shade::ends::slerped::arcs;
use shadegate_reference::shade::ends::Slerped;
use shadegate_reference::shade::shader::{Run, Shader};
use shadegate_reference::shade::sweep::Sweep;
use shadegate_reference::Prepared;
use std::collections::HashMap;

/// What a phase may be off by, in words of its table.
const SLACK: f64 = 1.0 / 16.0;

/// Possible colours of every pixel, by triangle, row and column.
pub struct SpanOracle(HashMap<(usize, u16, u16), Vec<[f64; 3]>>);

impl SpanOracle {
    /// For the triangles of a run; empty where the core is no span core.
    pub fn new(p: &Prelude) -> Self {
        let mut out = HashMap::new();
        let Order::Span(kind) = p.trace.core.order else {
            return Self(out);
        };
        let bits = match kind {
            SpanKind::Spherical(bits) | SpanKind::SphericalPower(bits) => Some(bits),
            _ => None,
        };
        if let Some(bits) = bits {
            tables(p, kind, bits, &mut out);
        } else {
            let all = All(&p.prepared, &mut out);
            // Only `auto` has no shader, and it has no core.
            let _ = dispatch(&p.prepared, method_of(p.trace.core.order), all);
        }
        Self(out)
    }

    /// Per channel the possible value that is nearest to the pixel's.
    pub fn nearest(&self, pixel: &Pixel) -> [f64; 3] {
        let at = (pixel.triangle, pixel.y, pixel.x);
        let values = self.0.get(&at).map_or(&[][..], Vec::as_slice);
        [0, 1, 2].map(|c| {
            let got = f64::from(pixel.rgb[c]);
            let distance = |v: f64| (v.clamp(0.0, 255.0) - got).abs();
            values
                .iter()
                .map(|v| v[c])
                .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
                .unwrap_or(f64::NAN)
        })
    }
}

fn spans(p: &Prepared, index: usize) -> Vec<Span> {
    let (width, height) = (p.width, p.height);
    let walk = Walk::new(p.triangles[index].position, Viewport { width, height });
    walk.map_or(vec![], |w| w.spans(width).collect())
}

struct All<'a>(
    &'a Prepared,
    &'a mut HashMap<(usize, u16, u16), Vec<[f64; 3]>>,
);

impl Visitor for All<'_> {
    type Out = ();

    fn visit<S: Shader>(self, shader: &S) {
        let Self(p, out) = self;
        for index in 0..p.triangles.len() {
            let setup = shader.triangle(p, index);
            for span in spans(p, index) {
                let mut run = shader.start(p, &setup, span);
                for x in span.start..span.end {
                    out.insert((index, span.y as u16, x as u16), vec![run.colour()]);
                    run.step();
                }
            }
        }
    }
}

/// The words that a table may give at pixel `k`, as fractions.
fn words(s: Option<&Sweep>, m: f64, (curve, rom): (&Curves, &Rom), k: f64) -> Vec<f64> {
    let Some(s) = s else { return vec![0.0] };
    let p = s.phase();
    let angle = (p.phase + k * p.step) * curve.scale;
    let slack = SLACK * curve.scale / curve.density();
    let amplitude = p.amplitude.powf(m);
    let mut out: Vec<f64> = [0.0, -slack, slack]
        .map(|d| amplitude * rom.value(angle + d))
        .to_vec();
    out.dedup();
    out
}

fn tables(
    p: &Prelude,
    kind: SpanKind,
    bits: usize,
    out: &mut HashMap<(usize, u16, u16), Vec<[f64; 3]>>,
) {
    let diffuse = Curves::diffuse(bits);
    let cosine = diffuse.rom();
    for (index, t) in p.triangles.iter().enumerate() {
        let Ok(s) = Surface::new(t) else { continue };
        let (c, edges) = (&s.corners, arcs(&s.corners.normal));
        let highlight = Curves::highlight(kind, c.shininess);
        let power = highlight.rom();
        for span in spans(&p.prepared, index) {
            let sweeps = Slerped.sweeps(&s.triangle, c, &edges, span);
            let light = sweeps.first();
            for x in span.start..span.end {
                let k = f64::from(x - span.start);
                let d = words(light.map(|l| &l.0), 1.0, (&diffuse, &cosine), k);
                let half = light.and_then(|l| l.1.as_ref());
                let h = words(half, c.shininess, (&highlight, &power), k);
                let mut values = vec![];
                for d in &d {
                    for h in &h {
                        let sum = c.terms.iter().fold(c.ambient, |sum, t| {
                            sum + t.diffuse[0] * *d + t.specular[0] * *h
                        });
                        values.push(sum.to_array());
                    }
                }
                out.insert((index, span.y as u16, x as u16), values);
            }
        }
    }
}
