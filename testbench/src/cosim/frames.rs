//! Frames from pixel streams, and the arithmetic error of every pixel that a core hands over.

use super::span_oracle::SpanOracle;
use super::{bump_oracle, lines, texture_oracle, Prelude};
use shadegate_gen::stimulus::{Lobe, Triangle};
use shadegate_gen::vectors::Pixel;
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
    /// Pixels of a nearest texel that are right only for the texel next to the one of the method, from whose border the
    /// address is no farther than the core's may be off.
    pub border_pixels: u64,
}

/// The reflection model in f64: one light, from N·L, N·H and the cosine from the axis of a spot.
fn reflected(t: &Triangle, [light, half, axis]: [f64; 3]) -> [f64; 3] {
    let Some(m) = &t.material else {
        return [0.0; 3];
    };
    let (half, axis) = (half.min(1.0), axis.min(1.0));
    let power = match m.lobe {
        Lobe::Power if half > 0.0 => half.powf(m.shininess),
        Lobe::Kappa { degree, gamma } if half > gamma => {
            ((half - gamma) / (1.0 - gamma)).powi(i32::from(degree))
        }
        _ => 0.0,
    };
    let spot = match m.cone {
        None => 1.0,
        Some(c) if axis <= 1.0 - c.width => 0.0,
        Some(c) if c.hard => 1.0 - ((axis - 1.0) / c.width).powi(2),
        Some(c) => ((axis - (1.0 - c.width)) / c.width).powi(2),
    };
    std::array::from_fn(|c| {
        let lit = m.diffuse[c] * light.clamp(0.0, 1.0) + m.specular[c] * power;
        m.ambient[c] + spot * lit
    })
}

/// The frame of a core that has no software method of its own: each pixel that is seen, in f64 at its triangle.
pub fn method_frame(p: &Prelude) -> Vec<[u8; 3]> {
    let one = |pixel: &Pixel| {
        let t = &p.triangles[pixel.triangle];
        let (x, y) = (i32::from(pixel.x), i32::from(pixel.y));
        let knots: [[f64; 3]; 6] = std::array::from_fn(|i| t.knots[i]);
        let value = reflected(t, shade::quadratic::value(&t.position, &knots, x, y));
        (pixel.x, pixel.y, value.map(to_byte))
    };
    let pixels: Vec<_> = p.trace.pixels.iter().map(one).collect();
    frame(&p.prepared, &pixels)
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
            Order::QuadraticDots | Order::Glint(_) => {
                let knots: [[f64; 3]; 6] = std::array::from_fn(|i| t.knots[i]);
                let cosines = shade::quadratic::value(&t.position, &knots, x, y);
                reflected(t, cosines)
            }
            Order::Bump(bend) => {
                let [light, half] = bump_oracle::cosines(t, bend, x, y);
                reflected(t, [light, half, 0.0])
            }
            // Judged above.
            Order::Line(_) => continue,
            Order::Span(_) => spans.nearest(pixel),
            Order::Textured(texturing) => {
                let wide = p.trace.core.wide;
                let judged = texture_oracle::colour(t, texturing, wide, pixel);
                out.border_pixels += u64::from(judged.border);
                judged.colour
            }
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
