//! Frames from pixel streams, and the arithmetic error of every pixel that a core hands over.

use super::span_oracle::SpanOracle;
use super::{lines, Prelude};
use shadegate_gen::stimulus::Triangle;
use shadegate_hdl::shade::model::Order;
use shadegate_reference::{shade, to_byte, Prepared};

/// The four frames of a co-simulation, row by row.
pub struct Frames {
    /// The integer model's.
    pub expected: Vec<[u8; 3]>,
    /// The engine's.
    pub simulated: Vec<[u8; 3]>,
    /// The same method in f64.
    pub method: Vec<[u8; 3]>,
    /// The truth.
    pub exact: Vec<[u8; 3]>,
}

/// Pixels over the background, later ones over earlier ones. Pixels outside the frame cannot be placed and are left
/// out; an engine that makes some differs from the model in that clock anyway.
fn frame(p: &Prepared, pixels: &[(u16, u16, [u8; 3])]) -> Vec<[u8; 3]> {
    let mut out = vec![p.background; p.width as usize * p.height as usize];
    for (x, y, rgb) in pixels {
        let inside = u32::from(*x) < p.width && u32::from(*y) < p.height;
        if let Some(to) = out
            .get_mut(usize::from(*y) * p.width as usize + usize::from(*x))
            .filter(|_| inside)
        {
            *to = *rgb;
        }
    }
    out
}

impl Frames {
    /// Draws both streams.
    pub fn new(
        p: &Prepared,
        expected: &[(u16, u16, [u8; 3])],
        simulated: &[(u16, u16, [u8; 3])],
        method: &[[u8; 3]],
        exact: &[[u8; 3]],
    ) -> Self {
        Self {
            expected: frame(p, expected),
            simulated: frame(p, simulated),
            method: method.to_vec(),
            exact: exact.to_vec(),
        }
    }
}

/// Error of the core's pixels against the method in f64, each at its own triangle, so that visibility plays no part.
#[derive(Clone, Copy, Debug, Default)]
pub struct FragmentError {
    /// Largest difference of a channel, LSB.
    pub max_lsb: u8,
    /// Root mean square over all channels, LSB.
    pub rms_lsb: f64,
}

/// The reflection model in f64: one light, from N·L and N·H.
fn reflected(t: &Triangle, [light, half, _]: [f64; 3]) -> [f64; 3] {
    let Some(m) = &t.material else {
        return [0.0; 3];
    };
    let power = match half {
        h if h > 0.0 => h.min(1.0).powf(m.shininess),
        _ => 0.0,
    };
    std::array::from_fn(|c| {
        m.ambient[c] + m.diffuse[c] * light.clamp(0.0, 1.0) + m.specular[c] * power
    })
}

/// Compares every pixel handed over (also those that nearer ones replace later) with the f64 oracle.
pub fn fragment_error(p: &Prelude) -> FragmentError {
    if matches!(p.trace.core.order, Order::Line(_)) {
        return lines::fragment_error(p);
    }
    let mut out = FragmentError::default();
    let mut sum = 0.0;
    let spans = SpanOracle::new(p);
    for pixel in &p.trace.pixels {
        let t = &p.triangles[pixel.triangle];
        let (x, y) = (i32::from(pixel.x), i32::from(pixel.y));
        let value = match p.trace.core.order {
            Order::Linear => {
                let knots: [[f64; 3]; 3] = std::array::from_fn(|i| t.knots[i]);
                shade::gouraud::value(&t.position, &knots, x, y)
            }
            Order::Quadratic | Order::QuadraticEngine => {
                let knots: [[f64; 3]; 6] = std::array::from_fn(|i| t.knots[i]);
                shade::quadratic::value(&t.position, &knots, x, y)
            }
            Order::Duff => {
                let knots: [[f64; 3]; 6] = std::array::from_fn(|i| t.knots[i]);
                let [light, half, square] = shade::quadratic::value(&t.position, &knots, x, y);
                let root = square.sqrt();
                reflected(t, [light / root, half / root, 0.0])
            }
            Order::QuadraticDots => {
                let knots: [[f64; 3]; 6] = std::array::from_fn(|i| t.knots[i]);
                let cosines = shade::quadratic::value(&t.position, &knots, x, y);
                reflected(t, cosines)
            }
            // Judged above.
            Order::Line(_) => continue,
            Order::Span(_) => spans.nearest(pixel),
        };
        for (want, got) in value.into_iter().zip(pixel.rgb) {
            let d = to_byte(want).abs_diff(got);
            out.max_lsb = out.max_lsb.max(d);
            sum += f64::from(d).powi(2);
        }
    }
    let n = p.trace.pixels.len() * 3;
    out.rms_lsb = if n == 0 { 0.0 } else { (sum / n as f64).sqrt() };
    out
}
