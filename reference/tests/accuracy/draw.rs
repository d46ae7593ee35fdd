//! A method's own colours at the pixels of a triangle, in real numbers.

use crate::oracle::{self, Truth};
use crate::setting::Setting;
use shadegate_reference::raster::{Viewport, Walk};
use shadegate_reference::shade::dispatch::{dispatch, Visitor};
use shadegate_reference::shade::shader::{Run, Shader};
use shadegate_reference::{Method, Prepared};

/// The pixels of the only triangle and their colours, red, LSB.
struct Colours<'a>(&'a Prepared);

impl Visitor for Colours<'_> {
    type Out = Vec<(i32, i32, f64)>;

    fn visit<S: Shader>(self, shader: &S) -> Self::Out {
        let p = self.0;
        let setup = shader.triangle(p, 0);
        let viewport = Viewport {
            width: p.width,
            height: p.height,
        };
        let mut out = Vec::new();
        for walk in Walk::new(p.triangles[0].position, viewport).iter() {
            for span in walk.spans(p.width) {
                let mut run = shader.start(p, &setup, span);
                for x in span.start..span.end {
                    out.push((x, span.y, run.colour()[0]));
                    run.step();
                }
            }
        }
        out
    }
}

/// Every method that has a shader.
pub fn methods() -> Vec<Method> {
    let all = Method::ALL.iter().copied();
    all.filter(|m| *m != Method::Auto).collect()
}

/// The colours of one of them.
pub fn colours(p: &Prepared, method: Method) -> Vec<(i32, i32, f64)> {
    dispatch(p, method, Colours(p)).expect("a method with a shader")
}

/// Errors of many pixels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    pub max: f64,
    pub squares: f64,
    pub pixels: u64,
}

impl Errors {
    pub fn rms(&self) -> f64 {
        (self.squares / self.pixels.max(1) as f64).sqrt()
    }

    pub fn merge(&mut self, o: Self) {
        self.max = self.max.max(o.max);
        self.squares += o.squares;
        self.pixels += o.pixels;
    }
}

/// A setting made ready once for all methods.
pub struct Ready {
    pub setting: Setting,
    pub prepared: Prepared,
    blended: Vec<f64>,
    positions: Vec<f64>,
}

impl Ready {
    /// `None` when the triangle covers no pixel.
    pub fn new(setting: Setting) -> Option<Self> {
        let prepared = setting.prepare();
        let pixels = colours(&prepared, Method::Flat);
        let truth = |t| {
            pixels
                .iter()
                .map(|(x, y, _)| oracle::value(&setting, t, *x, *y))
                .collect()
        };
        let (blended, positions) = (truth(Truth::Blended), truth(Truth::Positions));
        (!pixels.is_empty()).then_some(Self {
            prepared,
            blended,
            positions,
            setting,
        })
    }

    /// The errors of a method against one of the truths.
    pub fn errors(&self, method: Method, truth: Truth) -> Errors {
        let truth = match truth {
            Truth::Blended => &self.blended,
            Truth::Positions => &self.positions,
        };
        let mut out = Errors::default();
        let got = colours(&self.prepared, method);
        assert_eq!(got.len(), truth.len());
        for ((x, y, c), t) in got.iter().zip(truth) {
            assert!(
                c.is_finite(),
                "{method} ({x}, {y}): {c}: {:?}",
                self.setting
            );
            let e = (c - t).abs();
            out.max = out.max.max(e);
            out.squares += e * e;
            out.pixels += 1;
        }
        out
    }
}
