//! Work that need not be done. Every skip leaves the frame as it is or within a bound that it states, is counted, and
//! can be switched off to prove both.
//!
//! One condition goes with `back-face` and `back-edge`: they preserve the frame of *closed* objects only, because only
//! there does a nearer front face hide every back face.

use crate::method::UnknownName;

/// A triangle turned away from the camera.
pub const BACK_FACE: &str = "back-face";
/// A vertex that only back faces use, which are found in object space: not transformed.
pub const VERTEX: &str = "vertex";
/// An object whose bounding box lies outside the frustum.
pub const FRUSTUM: &str = "frustum";
/// A triangle beside the viewport.
pub const OUTSIDE: &str = "outside";
/// A triangle that covers no pixel centre of the viewport.
pub const UNCOVERED: &str = "uncovered";
/// A triangle drawn before farther objects that the scene names first, so that it hides them: the order alone is changed, and
/// what it saves is among the pixels under `hidden` and the triangles under `tiles`. Only objects between which there is a gap
/// in depth change places, and none while back faces are drawn.
pub const FRONT_TO_BACK: &str = "front-to-back";
/// A pixel behind what is already drawn: not shaded.
pub const HIDDEN: &str = "hidden";
/// A triangle of which nothing is nearer than the coarse depth of a band of rows: left out of that band.
pub const TILES: &str = "tiles";
/// The set-up of a span of one pixel, for the methods that follow great circles: its colour is that of the vectors blended
/// there. The same frame for methods whose spans end in blends; for those that slerp along edges, within the method's
/// bound, and nearer to the truth. Counted in spans.
pub const ONE_PIXEL: &str = "one-pixel";
/// A light whose cone misses a triangle: not looked at there. Counted once for every such light and triangle.
pub const SPOT: &str = "spot";
/// A triangle that one colour draws within the error wanted of `auto`.
pub const FLAT_ENOUGH: &str = "flat-enough";
/// A triangle that linear interpolation draws within the error wanted of `auto`.
pub const LINEAR_ENOUGH: &str = "linear-enough";
/// A triangle that quadratic interpolation of colours draws within the error wanted of `auto`.
pub const QUADRATIC_ENOUGH: &str = "quadratic-enough";
/// A triangle that quadratic interpolation of N·L and N·H draws within the error wanted of `auto`.
pub const PRODUCTS_ENOUGH: &str = "products-enough";
/// A triangle shaded per pixel by `auto` on which no highlight can be seen.
pub const SPECULAR: &str = "specular";
/// A triangle shaded per pixel by `auto` to which no light comes.
pub const DIFFUSE: &str = "diffuse";
/// The bounds of a triangle of a few pixels, which `auto` shades per pixel at once.
pub const BOUNDS: &str = "bounds";
/// A sub-frame of a frame in which nothing moves by as much as a pixel while the shutter is open: drawn once, still, with
/// everything less than a pixel from where it would be.
pub const BLUR: &str = "blur";
/// An edge of a wireframe of which no face shows its front.
pub const BACK_EDGE: &str = "back-edge";
/// With anti-aliasing: a triangle in a pixel that those before it cover wholly, not composited.
pub const MASKED: &str = "masked";
/// The texel of a hidden pixel: not looked up.
pub const TEXTURE: &str = "texture";
/// Texture addresses of a triangle that are affine where perspective would move them by less than half a texel; not
/// for the methods `exact` and `auto`.
pub const AFFINE: &str = "affine";
/// A span with one reciprocal for all its texture addresses, because depth hardly changes along it; off by less than
/// 1/256 texel, and not for the methods `exact` and `auto`.
pub const CONSTANT_DEPTH: &str = "constant-depth";
/// A triangle without area, in the mesh or after snapping. Always skipped: there is nothing to draw.
pub const DEGENERATE: &str = "degenerate";
/// A triangle of which the near plane, the far plane or the guard band leaves nothing. Always skipped as well.
pub const CLIPPED_AWAY: &str = "clipped-away";

const NAMES: [&str; 23] = [
    BACK_FACE,
    VERTEX,
    FRUSTUM,
    OUTSIDE,
    UNCOVERED,
    FRONT_TO_BACK,
    HIDDEN,
    TILES,
    ONE_PIXEL,
    SPOT,
    FLAT_ENOUGH,
    LINEAR_ENOUGH,
    QUADRATIC_ENOUGH,
    PRODUCTS_ENOUGH,
    SPECULAR,
    DIFFUSE,
    BOUNDS,
    BLUR,
    BACK_EDGE,
    MASKED,
    TEXTURE,
    AFFINE,
    CONSTANT_DEPTH,
];

/// Which skips are switched on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Skips {
    on: [bool; NAMES.len()],
}

impl Default for Skips {
    fn default() -> Self {
        Self::all()
    }
}

impl Skips {
    /// The names that can be switched off.
    pub const NAMES: &'static [&'static str] = &NAMES;

    /// What a skip leaves out, in one line; empty for names that cannot be switched.
    #[must_use]
    pub fn about(name: &str) -> &'static str {
        match name {
            BACK_FACE => "a triangle turned away from the camera",
            VERTEX => "a vertex that only back faces use, which are found in object space: not transformed",
            FRUSTUM => "an object whose bounding box lies outside the frustum",
            OUTSIDE => "a triangle beside the viewport",
            UNCOVERED => "a triangle that covers no pixel centre of the viewport",
            FRONT_TO_BACK => "a triangle drawn before farther objects that the scene names first",
            HIDDEN => "a pixel behind what is already drawn: not shaded",
            TILES => "a triangle of which nothing is nearer than the coarse depth of a band of rows: left out of that band",
            ONE_PIXEL => "the set-up of a span of one pixel, for methods along great circles",
            SPOT => "a light whose cone misses a triangle: not looked at there",
            FLAT_ENOUGH => "a triangle that one colour draws within the error wanted of `auto`",
            LINEAR_ENOUGH => "a triangle that linear interpolation draws within the error wanted of `auto`",
            QUADRATIC_ENOUGH => "a triangle that quadratic interpolation of colours draws within the error wanted of `auto`",
            PRODUCTS_ENOUGH => "a triangle that quadratic interpolation of N·L and N·H draws within the error wanted of `auto`",
            SPECULAR => "a triangle shaded per pixel by `auto` on which no highlight can be seen",
            DIFFUSE => "a triangle shaded per pixel by `auto` to which no light comes",
            BOUNDS => "the bounds of a triangle of a few pixels, which `auto` shades per pixel at once",
            BLUR => "a sub-frame of a frame in which nothing moves by as much as a pixel: drawn once",
            BACK_EDGE => "an edge of a wireframe of which no face shows its front",
            MASKED => "with anti-aliasing: a triangle in a pixel that those before it cover wholly, not composited",
            TEXTURE => "the texel of a hidden pixel: not looked up",
            AFFINE => "texture addresses of a triangle that are affine, proved to be off by less than half a texel",
            CONSTANT_DEPTH => "a span with one reciprocal for all its texture addresses, off by less than 1/256 texel",
            _ => "",
        }
    }

    /// Everything that can be skipped is skipped.
    #[must_use]
    pub fn all() -> Self {
        Self {
            on: [true; NAMES.len()],
        }
    }

    /// Nothing is skipped.
    #[must_use]
    pub fn none() -> Self {
        Self {
            on: [false; NAMES.len()],
        }
    }

    /// Everything but a comma-separated list of names; `all` stands for every name, an empty list for none.
    ///
    /// # Errors
    /// An unknown name, with the nearest known one.
    pub fn without(list: &str) -> Result<Self, UnknownName> {
        let mut skips = Self::all();
        for name in list.split(',').map(str::trim).filter(|n| !n.is_empty()) {
            if name == "all" {
                skips = Self::none();
                continue;
            }
            let i = NAMES
                .iter()
                .position(|n| *n == name)
                .ok_or_else(|| UnknownName::new("skip", name, &NAMES))?;
            skips.on[i] = false;
        }
        Ok(skips)
    }

    /// The same, but the skip of this name off; names that cannot be switched change nothing.
    #[must_use]
    pub fn but(mut self, name: &str) -> Self {
        if let Some(i) = NAMES.iter().position(|n| *n == name) {
            self.on[i] = false;
        }
        self
    }

    /// Whether the skip of this name is on; false for names that cannot be switched.
    #[must_use]
    pub fn is_on(&self, name: &str) -> bool {
        NAMES
            .iter()
            .position(|n| *n == name)
            .is_some_and(|i| self.on[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_switches_off_what_it_names() {
        let s = Skips::without("back-face, hidden").unwrap();
        assert!(!s.is_on(BACK_FACE) && !s.is_on(HIDDEN));
        assert!(s.is_on(FRUSTUM) && s.is_on(OUTSIDE) && s.is_on(UNCOVERED));
        assert_eq!(Skips::without("").unwrap(), Skips::all());
        assert_eq!(Skips::without("all").unwrap(), Skips::none());
        assert_eq!(Skips::all().but(HIDDEN), Skips::without("hidden").unwrap());
        assert_eq!(Skips::all().but(DEGENERATE), Skips::all());
    }

    #[test]
    fn every_skip_is_explained() {
        for name in Skips::NAMES {
            assert!(!Skips::about(name).is_empty(), "{name}");
        }
    }

    #[test]
    fn an_unknown_skip_is_answered_with_the_nearest() {
        assert_eq!(
            Skips::without("back-face,frustrum")
                .unwrap_err()
                .to_string(),
            format!(
                "unknown skip 'frustrum'; the nearest is 'frustum' of {}",
                NAMES.join(", ")
            )
        );
    }
}
