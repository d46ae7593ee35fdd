//! One line of the result: a method, drawing one scene at one size.

use crate::compare::Comparison;
use serde::{Serialize, Serializer};
use std::fmt::Write;

/// What one method costs and how far it is from `exact`, for one scene, exponent and size. Times are medians over
/// `rounds` rounds, on one thread, of `render` alone: the transform and the culling before it are the same for all.
///
/// A frame is drawn in two ways: as users get it, several pixels at a time where the method can (`ns_per_frame`), and
/// pixel by pixel, as the papers have it. The latter keeps set-up and drawing apart and walks all methods alike, so costs
/// per triangle and per pixel come from it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Name of the scene.
    pub scene: &'static str,
    /// Name of the method.
    pub method: &'static str,
    /// Exponent of the highlight.
    pub exponent: u32,
    /// Triangles of the scene.
    pub triangles: u64,
    /// Of these, drawn.
    pub drawn: u64,
    /// Columns of the frame.
    pub width: u32,
    /// Rows of the frame.
    pub height: u32,
    /// Pixels covered by triangles, counted once for each triangle that covers them.
    pub pixels: u64,
    /// Set-up and drawing of a frame, as users get it.
    #[serde(serialize_with = "thousandth")]
    pub ns_per_frame: f64,
    /// The same pixel by pixel.
    #[serde(serialize_with = "thousandth")]
    pub ns_per_frame_scalar: f64,
    /// Set-up alone, for all triangles of a frame, pixel by pixel.
    #[serde(serialize_with = "thousandth")]
    pub ns_setup: f64,
    /// Colour alone, pixel by pixel: drawing, less the drawing of the same frame by the empty rasteriser, per pixel; 0
    /// for `flat`, which is the empty rasteriser. Noise may make it negative for methods that cost next to nothing.
    #[serde(serialize_with = "thousandth")]
    pub ns_per_pixel: f64,
    /// Set-up per triangle drawn.
    #[serde(serialize_with = "thousandth")]
    pub ns_per_triangle: f64,
    /// Rounds of which the times are medians.
    pub rounds: usize,
    /// Largest difference of a channel from `exact`.
    pub max_lsb: u8,
    /// Root mean square difference from `exact`, over all channels of all pixels of the frame.
    pub rms_lsb: f64,
    /// Peak signal-to-noise ratio; null for equal frames.
    pub psnr_db: Option<f64>,
    /// Mean of the FLIP error map.
    pub flip_mean: f64,
    /// No other method of this scene, exponent and size is both faster and nearer in RMS (see [`super::front`]).
    pub front_rms: bool,
    /// The same with the largest difference.
    pub front_max: bool,
}

fn thousandth<S: Serializer>(v: &f64, s: S) -> Result<S::Ok, S::Error> {
    s.serialize_f64((v * 1e3).round() / 1e3)
}

impl Row {
    /// Takes over how far the frame is from the truth.
    pub(super) fn set_error(&mut self, c: &Comparison) {
        self.max_lsb = c.max_lsb;
        self.rms_lsb = c.rms_lsb;
        self.psnr_db = Some(c.psnr_db).filter(|p| p.is_finite());
        self.flip_mean = c.flip_mean;
    }

    /// Whether two rows stand for two methods at one task, so that one may beat the other.
    #[must_use]
    pub fn same_task(&self, o: &Self) -> bool {
        (self.scene, self.exponent, self.width, self.height)
            == (o.scene, o.exponent, o.width, o.height)
    }
}

/// Rows as comma-separated values, with the keys of the JSON as headings. Equal frames have an empty PSNR.
#[must_use]
pub fn csv(rows: &[Row]) -> String {
    let mut out = String::from(
        "scene,method,exponent,triangles,drawn,width,height,pixels,ns_per_frame,ns_per_frame_scalar,ns_setup,ns_per_pixel,\
         ns_per_triangle,rounds,max_lsb,rms_lsb,psnr_db,flip_mean,front_rms,front_max\n",
    );
    for r in rows {
        let psnr = r.psnr_db.map_or(String::new(), |p| format!("{p:.4}"));
        // Writing to a string cannot fail. No name holds a comma or a quotation mark.
        let _ = writeln!(
            out,
            "{},{},{},{},{},{},{},{},{:.0},{:.0},{:.0},{:.3},{:.3},{},{},{:.6},{psnr},{:.8},{},{}",
            r.scene,
            r.method,
            r.exponent,
            r.triangles,
            r.drawn,
            r.width,
            r.height,
            r.pixels,
            r.ns_per_frame,
            r.ns_per_frame_scalar,
            r.ns_setup,
            r.ns_per_pixel,
            r.ns_per_triangle,
            r.rounds,
            r.max_lsb,
            r.rms_lsb,
            r.flip_mean,
            r.front_rms,
            r.front_max,
        );
    }
    out
}

/// A row for tests: only what decides and what is printed.
#[cfg(test)]
pub(super) fn sample(method: &'static str, ns: f64, max_lsb: u8, rms_lsb: f64) -> Row {
    Row {
        scene: "sphere-690",
        method,
        exponent: 20,
        triangles: 690,
        drawn: 345,
        width: 320,
        height: 240,
        pixels: 41_000,
        ns_per_frame: ns,
        ns_per_frame_scalar: 2.0 * ns,
        ns_setup: ns / 4.0,
        ns_per_pixel: ns / 41_000.0,
        ns_per_triangle: ns / 4.0 / 345.0,
        rounds: 5,
        max_lsb,
        rms_lsb,
        psnr_db: (rms_lsb > 0.0).then(|| 20.0 * (255.0 / rms_lsb).log10()),
        flip_mean: 0.0,
        front_rms: true,
        front_max: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_are_the_keys_of_the_json_in_order() {
        let row = sample("gouraud", 1e6, 3, 0.5);
        let json = serde_json::to_string(&row).unwrap();
        let text = csv(&[row]);
        let mut lines = text.lines();
        let headings: Vec<&str> = lines.next().unwrap().split(',').collect();
        let mut rest = json.as_str();
        for h in &headings {
            let at = rest.find(&format!("\"{h}\":")).expect(h);
            rest = &rest[at + 1..];
        }
        assert_eq!(json.matches("\":").count(), headings.len());
        assert_eq!(lines.next().unwrap().split(',').count(), headings.len());
    }

    #[test]
    fn equal_frames_leave_the_psnr_empty() {
        let text = csv(&[sample("exact", 2e6, 0, 0.0)]);
        assert!(
            text.contains(",0,0.000000,,0.00000000,true,false\n"),
            "{text}"
        );
    }
}
