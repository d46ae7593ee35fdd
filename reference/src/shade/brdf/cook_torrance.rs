//! The specular term of Cook and Torrance (1982): a surface of small mirrors whose slopes are distributed as
//! Beckmann's, with the shadow that they cast on each other and Fresnel's reflectance.
//!
//! ```text
//! π·F·D·G/(4·N·V)            for light whose diffuse part is kd·N·L
//! D = exp(−tan²δ/m²)/(π·m²·cos⁴δ),  cos δ = N·H
//! G = min(1, 2(N·H)(N·V)/(V·H), 2(N·H)(N·L)/(V·H))
//! F = f₀ + (1 − f₀)(1 − V·H)⁵                                    (Schlick 1994 for Fresnel's equations)
//! ```
//!
//! The reflectance F·D·G/(4(N·L)(N·V)) is multiplied by N·L as any reflectance is, which cancels one cosine, and by π
//! because a diffuse reflectance kd/π is written as kd here. D is normalised, ∫ D·cos δ dω = 1, and with the 4 no more
//! than F of the light that arrives is reflected for any direction of the light (tested); the printed 1/π in place of
//! the 4 goes with a D of another scale. Nothing keeps diffuse + f₀ of a material below 1: that is its author's choice.
//!
//! Schlick's form is off Fresnel's equations by up to 0.06 for f₀ = 0.02, 0.036 for 0.04 and 0.09 for 0.2, near grazing
//! light. f₀ = 0 in all channels is no surface at all and reflects nothing.
//!
//! Guards: G/(N·V) is worked out with the quotient inside the minimum, which has a limit where N·V goes to 0. Normals
//! turned away from the viewer by interpolation are taken as edge-on, so there is no step at silhouettes. With
//! N·L ≤ 0 or N·H ≤ 0 the term is 0; it goes there without a step.

use glam::DVec3;
use std::f64::consts::PI;

/// The specular part for unit vectors; `h` is half-way between `l` and `v`, and `f0` the reflectance at normal
/// incidence, RGB.
#[must_use]
pub fn specular(f0: DVec3, roughness: f64, n: DVec3, l: DVec3, v: DVec3, h: DVec3) -> DVec3 {
    let (nl, nv, nh, vh) = (n.dot(l), n.dot(v).max(0.0), n.dot(h), v.dot(h));
    if nl <= 0.0 || nh <= 0.0 || vh <= 0.0 {
        return DVec3::ZERO;
    }
    // Where N·V = 0 two of the three are infinite.
    let shadowed = (1.0 / nv).min(2.0 * nh / vh).min(2.0 * nh * (nl / nv) / vh);
    fresnel(f0, vh) * (PI * beckmann(nh, roughness) * shadowed / 4.0)
}

/// Beckmann's distribution D of facets for the cosine `nh` > 0 between normal and facet.
#[must_use]
pub fn beckmann(nh: f64, roughness: f64) -> f64 {
    let (c2, m2) = (nh * nh, roughness * roughness);
    let exponent = (1.0 - c2).max(0.0) / (c2 * m2);
    // Beyond, the exponential is 0 and cos⁴ may be.
    if exponent > 700.0 {
        return 0.0;
    }
    (-exponent).exp() / (PI * m2 * c2 * c2)
}

/// Schlick's form of Fresnel's reflectance, RGB, for the cosine `vh` of the angle of incidence, 0..=1.
#[must_use]
pub fn fresnel(f0: DVec3, vh: f64) -> DVec3 {
    f0 + (DVec3::ONE - f0) * (1.0 - vh.min(1.0)).powi(5)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn direction(cosine: f64, azimuth: f64) -> DVec3 {
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        DVec3::new(sine * azimuth.cos(), sine * azimuth.sin(), cosine)
    }

    /// The integral of f over the hemisphere, by the midpoint rule in the angle, times its cosine.
    fn over_hemisphere(f: impl Fn(DVec3) -> f64) -> f64 {
        let (rings, sectors) = (1200, 96);
        let mut sum = 0.0;
        for i in 0..rings {
            let angle = (f64::from(i) + 0.5) / f64::from(rings) * PI / 2.0;
            for j in 0..sectors {
                let azimuth = (f64::from(j) + 0.5) / f64::from(sectors) * 2.0 * PI;
                sum += f(direction(angle.cos(), azimuth)) * angle.sin();
            }
        }
        sum * (PI / 2.0 / f64::from(rings)) * (2.0 * PI / f64::from(sectors))
    }

    #[test]
    fn facets_cover_the_surface() {
        for m in [0.05, 0.3, 1.0] {
            let area = over_hemisphere(|h| beckmann(h.z, m) * h.z);
            assert!((area - 1.0).abs() < 1e-4, "{m}: {area}");
        }
    }

    /// With facets that reflect everything: the light of any direction that leaves in all directions together. The
    /// term divided by π is the reflectance times N·L, so its integral over L is the albedo by reciprocity.
    #[test]
    fn no_more_light_leaves_than_arrives() {
        for m in [0.1, 0.3, 0.6, 1.0] {
            for cosine in [1.0, 0.7, 0.3, 0.05] {
                let v = direction(cosine, 0.0);
                let albedo = over_hemisphere(|l| {
                    let h = (l + v).normalize();
                    specular(DVec3::ONE, m, DVec3::Z, l, v, h).x / PI
                });
                assert!(albedo <= 1.001, "{m} {cosine}: {albedo}");
                assert!(
                    albedo > 0.6 || m > 0.3 || cosine < 0.1,
                    "{m} {cosine}: {albedo}"
                );
            }
        }
    }

    #[test]
    fn straight_on_by_hand() {
        let z = DVec3::Z;
        let c = specular(DVec3::new(0.04, 0.5, 1.0), 0.5, z, z, z, z);
        assert!((c - DVec3::new(0.04, 0.5, 1.0)).length() < 1e-15);
    }

    /// Exact Fresnel reflectance of a dielectric, unpolarised, against Schlick's form.
    #[test]
    fn schlick_is_close_to_fresnel() {
        for (f0, want) in [(0.02f64, 0.060), (0.04, 0.036), (0.08, 0.034), (0.2, 0.092)] {
            let mut worst = 0.0f64;
            let index = (1.0 + f0.sqrt()) / (1.0 - f0.sqrt());
            for i in 0..=1000 {
                let c = f64::from(i) / 1000.0;
                let g = (index * index + c * c - 1.0).sqrt();
                let (s, d) = (g + c, g - c);
                let p = (c * s - 1.0) / (c * d + 1.0);
                let exact = 0.5 * (d / s).powi(2) * (1.0 + p * p);
                worst = worst.max((exact - fresnel(DVec3::splat(f0), c).x).abs());
            }
            println!("Schlick against Fresnel, f0 = {f0}: {worst:.4}");
            assert!((worst - want).abs() < 1e-3, "{f0}: {worst}");
        }
    }

    #[test]
    fn the_limits_at_grazing_angles_are_met_without_a_step() {
        let f0 = DVec3::splat(0.04);
        let at = |n: DVec3, l: DVec3, v: DVec3| specular(f0, 0.4, n, l, v, (l + v).normalize()).x;
        let (n, l) = (DVec3::Z, direction(0.4, 0.0));
        let edge_on = at(n, l, direction(0.0, PI));
        assert!(edge_on > 0.0 && edge_on.is_finite());
        assert!((at(n, l, direction(1e-9, PI)) - edge_on).abs() < 1e-6 * edge_on);
        let turned = DVec3::new(-1.0, 0.0, -1e-9).normalize();
        assert!((at(n, l, turned) - edge_on).abs() < 1e-6 * edge_on);
        assert_eq!(at(n, direction(0.0, 0.0), DVec3::Z), 0.0);
        assert!(at(n, direction(1e-9, 0.0), direction(0.5, PI)) < 1e-6);
    }
}
