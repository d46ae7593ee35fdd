//! What a textured pixel should be: colour, address and texel in f64 from the knots of its triangle, the texels as the
//! bytes that the core was sent.
//!
//! A nearest texel jumps at its border. Where the true address lies so near to one that the core's, within its bound,
//! may lie beyond it, the texel there is right as well; such pixels are counted if only that one is.

use shadegate_gen::stimulus::{Covering, Triangle};
use shadegate_gen::vectors::Pixel;
use shadegate_hdl::shade::device::{NARROW_RUN, WIDE_RUN};
use shadegate_hdl::texture::{Mapping, Texturing};
use shadegate_reference::{shade, to_byte};

/// A judged pixel.
pub struct Judged {
    /// The colour that it should have: of the texels it may show, the nearest to what it has.
    pub colour: [f64; 3],
    /// That is not the texel of the true address.
    pub border: bool,
}

/// u and v in f64.
fn address(t: &Triangle, c: &Covering, mapping: Mapping, x: i32, y: i32) -> [f64; 2] {
    let three = |of: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let knots: [[f64; 3]; 3] = std::array::from_fn(|i| of(c.address[i]));
        shade::gouraud::value(&t.position, &knots, x, y)
    };
    let [u, v, w] = match mapping {
        Mapping::Affine => three(&|[u, v, _]| [u, v, 1.0]),
        Mapping::Perspective => three(&|[u, v, w]| [u * w, v * w, w]),
        Mapping::Quadratic => {
            let knots: [[f64; 3]; 6] =
                std::array::from_fn(|i| [c.address[i][0], c.address[i][1], 1.0]);
            let [u, v, _] = shade::quadratic::value(&t.position, &knots, x, y);
            [u, v, 1.0]
        }
    };
    [u / w, v / w]
}

/// The texel of a column and row that may lie beside the picture, LSB.
fn texel(c: &Covering, x: f64, y: f64) -> [f64; 3] {
    let fold = |x: f64, n: usize| x.rem_euclid(n as f64) as usize % n;
    let (x, y) = (fold(x, c.picture.width), fold(y, c.picture.height));
    c.picture.at(x, y).map(f64::from)
}

fn bilinear(c: &Covering, [u, v]: [f64; 2]) -> [f64; 3] {
    let (u, v) = (u - 0.5, v - 0.5);
    let (x, y) = (u.floor(), v.floor());
    let (f, g) = (u - x, v - y);
    let four =
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(i, j)| texel(c, x + i, y + j));
    std::array::from_fn(|k| {
        let row = |a: usize| four[a][k] * (1.0 - f) + four[a + 1][k] * f;
        row(0) * (1.0 - g) + row(2) * g
    })
}

/// The colour of a pixel of a textured triangle.
pub fn colour(t: &Triangle, texturing: Texturing, wide: bool, pixel: &Pixel) -> Judged {
    let (x, y) = (i32::from(pixel.x), i32::from(pixel.y));
    let shaded = if t.knots.len() == 3 {
        let knots: [[f64; 3]; 3] = std::array::from_fn(|i| t.knots[i]);
        shade::gouraud::value(&t.position, &knots, x, y)
    } else {
        let knots: [[f64; 3]; 6] = std::array::from_fn(|i| t.knots[i]);
        shade::quadratic::value(&t.position, &knots, x, y)
    };
    let Some(c) = &t.covering else {
        return Judged {
            colour: shaded,
            border: false,
        };
    };
    let times = |texel: [f64; 3]| std::array::from_fn(|k| shaded[k] * texel[k] / 255.0);
    let at = address(t, c, texturing.mapping, x, y);
    if !c.nearest {
        return Judged {
            colour: times(bilinear(c, at)),
            border: false,
        };
    }
    let run = if wide { WIDE_RUN } else { NARROW_RUN };
    let reach = at[0].abs().max(at[1].abs());
    let off = texturing.mapping.error(wide, run, reach);
    let sides = |v: f64| [v.floor(), (v - off).floor(), (v + off).floor()];
    let own = times(texel(c, at[0].floor(), at[1].floor()));
    let apart = |colour: [f64; 3]| {
        let all = colour.into_iter().zip(pixel.rgb);
        all.map(|(want, got)| to_byte(want).abs_diff(got)).max()
    };
    let mut best = Judged {
        colour: own,
        border: false,
    };
    if apart(own) <= Some(1) {
        return best;
    }
    for column in sides(at[0]) {
        for row in sides(at[1]) {
            let other = times(texel(c, column, row));
            if apart(other) < apart(best.colour) {
                best = Judged {
                    colour: other,
                    border: true,
                };
            }
        }
    }
    best
}
