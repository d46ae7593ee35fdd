//! Abbas 2003, ch. 7: the sphere of 690 triangles took 230 ms with Gouraud shading, 250 ms with quadratic interpolation
//! and 450 ms with Phong shading, which is 1 : 1.087 : 1.957. Our frames are 640 by 480; the thesis does not say its size.

use super::super::clock::{in_turns, median, Effort};
use super::super::scenes::Tessellation;
use super::super::sweep::{one_thread, pixel_by_pixel};
use super::super::BenchError;
use super::Claim;
use shadegate_reference::{render, with_threads, Method, Prepared, Skips};
use std::time::Instant;

const SOURCE: &str = "Abbas 2003, ch. 7";
/// Milliseconds in the thesis, by our names of the methods; ratios are to the first.
const PRINTED: [(&str, f64); 3] = [("gouraud", 230.0), ("quadratic", 250.0), ("phong", 450.0)];

/// The ratios of whole frames, pixel by pixel as the thesis draws them and as users get them; those of methods that the
/// catalogue does not hold are left out.
pub fn claims(effort: Effort) -> Result<Vec<Claim>, BenchError> {
    let known = PRINTED
        .iter()
        .filter_map(|(name, ms)| Some((name.parse::<Method>().ok()?, *ms)));
    let methods: Vec<(Method, f64)> = known.collect();
    let scene = Tessellation::of_690().scene(20)?;
    let prepare = || Prepared::new(&scene, Some((640, 480)), &Skips::all());
    let p = with_threads(one_thread().threads, prepare)?;
    let mut claims = Vec::new();
    for (how, options) in [
        ("pixel by pixel", pixel_by_pixel()),
        ("with vectors", one_thread()),
    ] {
        let frame = |job: usize| {
            let s = render(&p, methods[job].0, &options).1;
            (s.setup_ns + s.raster_ns) as f64
        };
        let begin = Instant::now();
        for job in 0..methods.len() {
            frame(job);
        }
        let rounds = effort.rounds(begin.elapsed());
        let times = in_turns(methods.len(), rounds, frame);
        for (job, (method, ms)) in methods.iter().enumerate().skip(1) {
            let (base, base_ms) = methods[0];
            let ours = median(times[job].iter().zip(&times[0]).map(|(t, g)| t / g));
            let what = format!("frame of 690 triangles: {method} to {base}, {how}");
            claims.push(Claim::ratio(SOURCE, what, ms / base_ms, ours, ""));
        }
    }
    Ok(claims)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadratic_is_compared_with_gouraud() {
        let claims = claims(Effort::QUICK).unwrap();
        assert_eq!(
            claims[0].what,
            "frame of 690 triangles: quadratic to gouraud, pixel by pixel"
        );
        assert!((claims[0].paper - 1.087).abs() < 5e-4);
        assert!(claims[0].ours > 0.1 && claims[0].ours < 10.0);
    }
}
