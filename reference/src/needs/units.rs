//! Which units of a core a frame needs, and why.

use super::Needs;

/// A unit of a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unit {
    /// What it does.
    pub name: &'static str,
    /// A core that draws the frame must have it.
    pub needed: bool,
    /// Why, or why not.
    pub because: String,
}

impl Needs {
    /// The way of shading that is enough for every triangle; `None` if there are none.
    #[must_use]
    pub fn shading(&self) -> Option<&'static str> {
        let o = &self.orders;
        let ways = [
            (o.per_pixel, "per pixel"),
            (o.products, "products"),
            (o.quadratic, "quadratic"),
            (o.linear, "linear"),
            (o.constant, "constant"),
        ];
        ways.into_iter().find(|w| w.0 > 0).map(|w| w.1)
    }

    /// The units; `error` is the one that [`Needs::of`] was asked with.
    #[must_use]
    pub fn units(&self, error: f64) -> Vec<Unit> {
        let unit = |name, needed, because: String| Unit {
            name,
            needed,
            because,
        };
        let (n, o) = (self, &self.orders);
        let ways = format!(
            "within {error} LSB one colour is enough for {}, linear for {}, quadratic for {}, products for {}, and {} want every \
         pixel",
            o.constant, o.linear, o.quadratic, o.products, o.per_pixel
        );
        let layers = match n.deepest {
            0 => "no pixel is covered".to_owned(),
            1 => "no pixel is covered twice".to_owned(),
            k => format!("up to {k} triangles lie over one another"),
        };
        let strength = n.perspective - 1.0;
        let lit = match (n.lights.point, n.lights.spot) {
            (0, 0) => format!("{} from infinitely far", n.lights.directional),
            (p, s) => format!("{p} points and {s} spots"),
        };
        vec![
            unit(
                "shading",
                n.triangles > 0,
                match n.shading() {
                    Some(way) => format!("{way}: {ways}"),
                    None => "nothing is shaded".to_owned(),
                },
            ),
            unit("depth test", n.deepest > 1, layers),
            unit(
                "highlight",
                !n.exponents.is_empty(),
                match n.exponents.as_slice() {
                    [] => "every material that is drawn is matt".to_owned(),
                    list => format!("exponents {}", numbers(list)),
                },
            ),
            unit(
                "light per pixel",
                n.lights.point + n.lights.spot > 0,
                format!("lights: {lit}"),
            ),
            unit(
                "texture",
                n.textures > 0,
                format!("{} of {} materials have one", n.textures, n.materials),
            ),
            unit(
                "perspective divider",
                n.textures > 0 && strength > 0.0,
                match (n.textures, strength > 0.0) {
                    (0, _) => "nothing is textured".to_owned(),
                    (_, false) => "there is no perspective".to_owned(),
                    _ => format!(
                        "weights within a triangle differ by up to {:.3} %",
                        100.0 * strength
                    ),
                },
            ),
            unit(
                "bump",
                n.bumps > 0,
                format!("{} of {} materials have a map", n.bumps, n.materials),
            ),
            unit(
                "lines",
                n.lines > 0,
                format!("{} edges are drawn as lines", n.lines),
            ),
        ]
    }
}

fn numbers(list: &[f64]) -> String {
    list.iter()
        .map(f64::to_string)
        .collect::<Vec<_>>()
        .join(", ")
}
