//! What a frame needs of whoever draws it: how far coordinates, depths and colours range and how fast they change, how
//! long triangles are walked, how many lie over one another, which lights, exponents and maps are there, and which way of
//! shading is enough for how many triangles.
//!
//! One pass over the prepared triangles, after culling and clipping, so that nothing that is not drawn is asked for. All
//! figures but [`Needs::orders`] are exact for the frame; those are proved bounds ([`crate::shade::bound`]). The needs of
//! several frames are joined by [`Needs::join`], which keeps the wider of each.

mod attributes;
mod coverage;
mod range;
mod units;

pub use range::Range;
pub use units::Unit;

use crate::geometry::Prepared;
use crate::scene::LightKind;
use crate::shade::auto::{Auto, Choice, ARITHMETIC};
use crate::shade::bound::Tables;
use crate::skips::Skips;
use fearless_simd::Level;

/// Triangles by the cheapest way of shading that is enough, in number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Orders {
    /// One colour.
    pub constant: u64,
    /// Linear between three colours.
    pub linear: u64,
    /// Quadratic through six colours.
    pub quadratic: u64,
    /// Quadratic products N·L and N·H, the power per pixel.
    pub products: u64,
    /// Vectors or the definition per pixel: whoever has no such way must subdivide.
    pub per_pixel: u64,
}

/// Lights by kind, in number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lights {
    /// From infinitely far.
    pub directional: usize,
    /// From a point.
    pub point: usize,
    /// From a point along an axis.
    pub spot: usize,
}

/// What a frame, or a set of frames, needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Needs {
    /// Columns of the largest frame.
    pub width: u32,
    /// Rows of the largest frame.
    pub height: u32,
    /// Triangles drawn, of all frames.
    pub triangles: u64,
    /// Of these, such as cover no pixel centre.
    pub empty: u64,
    /// Pixels covered, counted once for each triangle.
    pub pixels: u64,
    /// Most triangles over one pixel of one frame: with 1 no depth test is needed.
    pub deepest: u32,
    /// Columns of the longest span in the frame.
    pub longest_span: u32,
    /// Rows of the tallest triangle.
    pub most_rows: u32,
    /// Most additions behind a value: rows, carries of the major edge and columns, up to the farthest pixel of a span,
    /// also beside the frame, where walks may begin.
    pub longest_run: u32,
    /// Columns of corners, in pixels.
    pub columns: Range,
    /// Rows of corners, in pixels.
    pub rows: Range,
    /// Depth of corners, 0 to 1.
    pub depth: Range,
    /// Largest change of depth from pixel to pixel, in x or in y; of triangles that cover pixels.
    pub depth_slope: f64,
    /// Colours at corners, LSB, of all channels.
    pub colour: Range,
    /// Largest change of a linear colour from pixel to pixel, LSB, in x or in y; of triangles that cover pixels.
    pub colour_slope: f64,
    /// Largest angle between the normals at the ends of an edge, degrees.
    pub curvature: f64,
    /// Largest ratio of the weights of perspective within a triangle; 1: none.
    pub perspective: f64,
    /// Exponents of the highlights of the materials that are drawn, ascending, each once.
    pub exponents: Vec<f64>,
    /// Materials that are drawn.
    pub materials: usize,
    /// Of these, with a texture.
    pub textures: usize,
    /// Of these, with a bump map.
    pub bumps: usize,
    /// Lights of the scene.
    pub lights: Lights,
    /// Edges drawn as lines.
    pub lines: u64,
    /// Which way is enough.
    pub orders: Orders,
}

impl Needs {
    /// The needs of a frame; `error` is what shading may be off, in LSB beside the rounding of the byte.
    #[must_use]
    pub fn of(p: &Prepared, error: f64) -> Self {
        let mut n = Self {
            width: p.width,
            height: p.height,
            triangles: p.triangles.len() as u64,
            empty: 0,
            pixels: 0,
            deepest: 0,
            longest_span: 0,
            most_rows: 0,
            longest_run: 0,
            columns: Range::NONE,
            rows: Range::NONE,
            depth: Range::NONE,
            depth_slope: 0.0,
            colour: Range::NONE,
            colour_slope: 0.0,
            curvature: 0.0,
            perspective: 1.0,
            exponents: vec![],
            materials: 0,
            textures: 0,
            bumps: 0,
            lights: lights(p),
            lines: p.wires.edges.len() as u64,
            orders: orders(p, error),
        };
        let covering = n.walk(p);
        n.measure(p, &covering);
        n.survey(p);
        n
    }

    /// The needs of this and of another frame together.
    #[must_use]
    pub fn join(mut self, other: &Self) -> Self {
        self.width = self.width.max(other.width);
        self.height = self.height.max(other.height);
        self.triangles += other.triangles;
        self.empty += other.empty;
        self.pixels += other.pixels;
        self.deepest = self.deepest.max(other.deepest);
        self.longest_span = self.longest_span.max(other.longest_span);
        self.most_rows = self.most_rows.max(other.most_rows);
        self.longest_run = self.longest_run.max(other.longest_run);
        self.columns = self.columns.join(other.columns);
        self.rows = self.rows.join(other.rows);
        self.depth = self.depth.join(other.depth);
        self.depth_slope = self.depth_slope.max(other.depth_slope);
        self.colour = self.colour.join(other.colour);
        self.colour_slope = self.colour_slope.max(other.colour_slope);
        self.curvature = self.curvature.max(other.curvature);
        self.perspective = self.perspective.max(other.perspective);
        self.exponents.extend(&other.exponents);
        ascending(&mut self.exponents);
        self.materials = self.materials.max(other.materials);
        self.textures = self.textures.max(other.textures);
        self.bumps = self.bumps.max(other.bumps);
        self.lights.directional = self.lights.directional.max(other.lights.directional);
        self.lights.point = self.lights.point.max(other.lights.point);
        self.lights.spot = self.lights.spot.max(other.lights.spot);
        self.lines += other.lines;
        self.orders.constant += other.orders.constant;
        self.orders.linear += other.orders.linear;
        self.orders.quadratic += other.orders.quadratic;
        self.orders.products += other.orders.products;
        self.orders.per_pixel += other.orders.per_pixel;
        self
    }
}

fn ascending(list: &mut Vec<f64>) {
    list.sort_by(f64::total_cmp);
    list.dedup();
}

fn lights(p: &Prepared) -> Lights {
    let mut out = Lights::default();
    for light in p.surroundings.all_lights() {
        match light.kind {
            LightKind::Directional { .. } => out.directional += 1,
            LightKind::Point { .. } => out.point += 1,
            LightKind::Spot { .. } => out.spot += 1,
        }
    }
    out
}

fn orders(p: &Prepared, error: f64) -> Orders {
    // Small triangles are asked as well: a core has no way of its own for them.
    let skips = Skips::all().but(crate::skips::BOUNDS);
    let auto = Auto::new(p, error, &skips, Level::new());
    let tables = Tables::new(p);
    let mut out = Orders::default();
    for (i, t) in p.triangles.iter().enumerate() {
        // The renderer takes vectors before products, because they cost it less; they cost hardware more.
        let products = || tables.bounds(p, t).dots + ARITHMETIC <= error;
        *match auto.choice(i) {
            Choice::Constant => &mut out.constant,
            Choice::Linear => &mut out.linear,
            Choice::Quadratic => &mut out.quadratic,
            Choice::Dots => &mut out.products,
            Choice::Phong | Choice::Exact if products() => &mut out.products,
            Choice::Phong | Choice::Exact => &mut out.per_pixel,
        } += 1;
    }
    out
}
