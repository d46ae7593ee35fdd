//! The cores as one type: which datapath, which formats, how large a frame.
//!
//! rust-hdl formats are const generics, so a choice made at run time needs every combination compiled. There are two
//! word lengths per core, told apart by how far an accumulator can run in a frame (see [`longest_run`]).

use super::blake::BlakeCore;
use super::bump_newton::BumpNewtonCore;
use super::bump_reflection::BumpReflectionCore;
use super::chebyshev::ChebyshevCore;
use super::duff::DuffCore;
use super::gouraud::GouraudCore;
use super::kappa::KappaCore;
use super::model::{bus_bits, CoreInputs, CoreModel, CoreOutputs, Order};
use super::phong::power::{PLACE_FRACTION_BITS, PLACE_INTEGER_BITS, STEEPEST};
use super::phong::{inverse_root, unit_cosines};
use super::phong::{ERROR_LSB, LIGHT_FRACTION_BITS, LIGHT_INTEGER_BITS, STAGES};
use super::quadratic::QuadraticCore;
use super::quadratic_dots::QuadraticDotsCore;
use super::quadratic_engine::QuadraticEngineCore;
use super::slerp::SlerpCore;
use super::spherical::SphericalCore;
use super::spot::SpotCore;
use super::textured_affine::TexturedAffineCore;
use super::textured_perspective::TexturedPerspectiveCore;
use super::textured_quadratic::TexturedQuadraticCore;
use super::COLOUR_INTEGER_BITS;
use crate::bump::{self, Bend};
use crate::depth::pages::pages;
use crate::format::U;
use crate::light::{self, Glint, STEEPEST_HIGHLIGHT, STEEPEST_SPOT};
use crate::line::box_filter::BoxCore;
use crate::line::bresenham::BresenhamCore;
use crate::line::cone::ConeCore;
use crate::set_up;
use crate::simulate::{Clocked, Simulator};
use crate::texture::{self, Mapping, PERSPECTIVE_BITS, W_FRACTION_BITS};
use rust_hdl_core::prelude::*;

/// Quadratic core with Q11.20 colours, 32-bit bus, 2^17 frame addresses.
pub type QuadraticNarrow = QuadraticCore<32, 20, 32, 17>;
/// Quadratic core with Q11.24 colours, 36-bit bus, 2^21 frame addresses.
pub type QuadraticWide = QuadraticCore<36, 24, 36, 21>;
/// Quadratic core with a set-up engine, formats as [`QuadraticNarrow`].
pub type QuadraticEngineNarrow = QuadraticEngineCore<32, 20, 32, 17>;
/// Quadratic core with a set-up engine, formats as [`QuadraticWide`].
pub type QuadraticEngineWide = QuadraticEngineCore<36, 24, 36, 21>;
/// Gouraud core with Q11.12 colours, 32-bit bus, 2^17 frame addresses.
pub type GouraudNarrow = GouraudCore<24, 12, 32, 17>;
/// Gouraud core with Q11.14 colours, 32-bit bus, 2^21 frame addresses.
pub type GouraudWide = GouraudCore<26, 14, 32, 21>;
/// Quadratic-dots core with N·L in Q2.31 and the place in the lobe in Q10.34, 45-bit bus, 2^17 frame addresses.
pub type QuadraticDotsNarrow = QuadraticDotsCore<15, 45, 17>;
/// Quadratic-dots core with N·L in Q2.35 and the place in the lobe in Q10.38, 49-bit bus, 2^21 frame addresses.
pub type QuadraticDotsWide = QuadraticDotsCore<19, 49, 21>;
/// Duff core with N·L, N·H and |N|² in Q1.43, 45-bit bus, 2^17 frame addresses.
pub type DuffNarrow = DuffCore<15, 45, 17>;
/// Duff core with N·L, N·H and |N|² in Q1.47, 49-bit bus, 2^21 frame addresses.
pub type DuffWide = DuffCore<19, 49, 21>;
/// Textured core with affine addresses in Q9.22, Q11.20 colours, 32-bit bus, 2^17 frame addresses.
pub type TexturedAffineNarrow = TexturedAffineCore<32, 14, 32, 10, 17>;
/// Textured core with affine addresses in Q9.26, Q11.24 colours, 36-bit bus, 2^21 frame addresses.
pub type TexturedAffineWide = TexturedAffineCore<36, 18, 36, 14, 21>;
/// Textured core with quadratic addresses in Q9.30, Q11.20 colours, 40-bit bus, 2^17 frame addresses.
pub type TexturedQuadraticNarrow = TexturedQuadraticCore<32, 14, 40, 18, 17>;
/// Textured core with quadratic addresses in Q9.34, Q11.24 colours, 44-bit bus, 2^21 frame addresses.
pub type TexturedQuadraticWide = TexturedQuadraticCore<36, 18, 44, 22, 21>;
/// Textured core with perspective, u/z in Q10.37, 1/z in Q1.46, Q11.20 colours, 48-bit bus, 2^17 frame addresses.
pub type TexturedPerspectiveNarrow = TexturedPerspectiveCore<32, 14, 48, 17>;
/// Textured core with perspective, u/z in Q10.37, 1/z in Q1.46, Q11.24 colours, 48-bit bus, 2^21 frame addresses.
pub type TexturedPerspectiveWide = TexturedPerspectiveCore<36, 18, 48, 21>;

/// Quadratic-dots-kappa core with the formats of [`QuadraticDotsNarrow`].
pub type KappaNarrow = KappaCore<15, 45, 17>;
/// Quadratic-dots-kappa core with the formats of [`QuadraticDotsWide`].
pub type KappaWide = KappaCore<19, 49, 21>;
/// Quadratic-dots-spot core with the formats of [`QuadraticDotsNarrow`], the place in the cone as that in the lobe.
pub type SpotNarrow = SpotCore<15, 45, 17>;
/// Quadratic-dots-spot core with the formats of [`QuadraticDotsWide`], the place in the cone as that in the lobe.
pub type SpotWide = SpotCore<19, 49, 21>;

/// Bump core with vectors in Q1.35, addresses in Q9.22, 37-bit bus, 2^17 frame addresses.
pub type BumpNewtonNarrow = BumpNewtonCore<19, 37, 10, 17>;
/// Bump core with vectors in Q1.39, addresses in Q9.26, 41-bit bus, 2^21 frame addresses.
pub type BumpNewtonWide = BumpNewtonCore<23, 41, 14, 21>;
/// Bump core with the formats of [`BumpNewtonNarrow`].
pub type BumpReflectionNarrow = BumpReflectionCore<19, 37, 10, 17>;
/// Bump core with the formats of [`BumpNewtonWide`].
pub type BumpReflectionWide = BumpReflectionCore<23, 41, 14, 21>;

/// Longest run of the narrow formats.
pub const NARROW_RUN: u32 = 1023;
/// Longest run of the wide formats.
pub const WIDE_RUN: u32 = 4095;
/// Widest frame: with a few columns of guard band on either side a walk column fits 12 signed bits.
pub const MAX_WIDTH: u32 = 2040;
/// Highest frame: with a guard band of half a frame on each side an edge spans at most 2048 rows.
pub const MAX_HEIGHT: u32 = 1024;

/// Most additions between the first span start of a triangle and one of its pixels in a frame: every row, a carry in
/// every row, and every column from the far edge of the guard band (half a frame, or what 12-bit columns leave of it)
/// to the opposite border. `None` when that does not fit 32 bits.
#[must_use]
pub fn longest_run(width: u32, height: u32) -> Option<u32> {
    let beside = (width / 2).min((1 << 11) - 2 - width.min((1 << 11) - 2));
    width
        .checked_add(beside)?
        .checked_add(height.checked_mul(2)?)
}

/// Why a core has no load port of so many words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadWordsError {
    /// No core has one.
    Count(usize),
    /// This core takes one word per clock.
    Core(&'static str),
}

impl std::fmt::Display for LoadWordsError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Count(words) => write!(
                f,
                "a load port of {words} register words per clock does not exist; expected 1, 2 or 4"
            ),
            Self::Core(name) => write!(
                f,
                "core '{name}' takes one register word per clock; expected 1 load word"
            ),
        }
    }
}

impl std::error::Error for LoadWordsError {}

/// Hands a function a design with the core's load port.
macro_rules! laned {
    ($core:expr, $f:expr, $type:ty) => {{
        let mut design = <$type>::new($core.pixels);
        design.lanes.widen($core.load_words);
        $f.visit(design)
    }};
}
pub(super) use laned;

/// A core, chosen at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Core {
    /// Interpolant per colour channel.
    pub order: Order,
    /// Wide formats.
    pub wide: bool,
    /// Words of the depth memory: pixels of the frame.
    pub pixels: usize,
    /// Register words per clock: 1, 2 or 4. Line cores have 1.
    pub load_words: usize,
}

impl Core {
    /// The core for a frame, with the narrowest formats whose rounding stays within a quarter of an LSB and the usual
    /// load port; `None` when the frame exceeds the coordinate range.
    #[must_use]
    pub fn for_frame(order: Order, width: u32, height: u32) -> Option<Self> {
        let run = longest_run(width, height)?;
        let fits =
            width <= MAX_WIDTH && height <= MAX_HEIGHT && run <= WIDE_RUN && width * height >= 2;
        fits.then(|| Self {
            order,
            wide: run > NARROW_RUN,
            pixels: (width * height) as usize,
            load_words: Self::usual_load_words(order),
        })
    }

    /// Register words per clock that a core may take.
    pub const LOAD_WORDS: [usize; 3] = [1, 2, 4];

    /// Register words per clock that a core takes unless it is told otherwise: span cores two, for with one the words of
    /// a span of the usual triangle take longer than its pixels, the others one.
    #[must_use]
    pub fn usual_load_words(order: Order) -> usize {
        match order {
            Order::Span(_) => 2,
            _ => 1,
        }
    }

    /// The same core with a load port of `words` register words per clock.
    ///
    /// # Errors
    /// Other numbers than 1, 2 and 4; more than 1 for cores that have one lane.
    pub fn with_load_words(self, words: usize) -> Result<Self, LoadWordsError> {
        let lanes = match self.order {
            Order::Linear | Order::Quadratic | Order::QuadraticDots | Order::Duff => true,
            Order::Span(_) => true,
            Order::Line(_) | Order::QuadraticEngine | Order::Glint(_) => false,
            Order::Textured(_) | Order::Bump(_) => false,
        };
        if !Self::LOAD_WORDS.contains(&words) {
            return Err(LoadWordsError::Count(words));
        }
        if words > 1 && !lanes {
            return Err(LoadWordsError::Core(self.name()));
        }
        Ok(Self {
            load_words: words,
            ..self
        })
    }

    /// Name of the core in the catalogue.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self.order {
            Order::Linear => "gouraud",
            Order::Quadratic => "quadratic",
            Order::QuadraticEngine => "quadratic-engine",
            Order::QuadraticDots => "quadratic-dots",
            Order::Line(filter) => filter.core_name(),
            Order::Span(kind) => kind.name(),
            Order::Duff => "duff",
            Order::Textured(t) => t.name(),
            Order::Glint(glint) => glint.name(),
            Order::Bump(bend) => bend.name(),
        }
    }

    /// The name as a Verilog identifier: that of the top module without `_core`.
    #[must_use]
    pub fn module(&self) -> String {
        self.name().replace('-', "_")
    }

    /// What the interpolants hold beside depth: names, integer bits, fraction bits.
    #[must_use]
    pub fn formats(&self) -> Vec<(&'static str, usize, usize)> {
        let n = self.fraction_bits();
        match self.order {
            Order::Linear
            | Order::Quadratic
            | Order::QuadraticEngine
            | Order::Line(_)
            | Order::Span(_) => {
                vec![("colour", COLOUR_INTEGER_BITS, n)]
            }
            Order::QuadraticDots => vec![
                ("light", LIGHT_INTEGER_BITS, LIGHT_FRACTION_BITS + n),
                ("lobe", PLACE_INTEGER_BITS, PLACE_FRACTION_BITS + n),
            ],
            Order::Textured(t) => {
                let (int, frac) = t.mapping.format(self.wide);
                let mut all = vec![("colour", COLOUR_INTEGER_BITS, n), ("address", int, frac)];
                if t.mapping == Mapping::Perspective {
                    let int = PERSPECTIVE_BITS - W_FRACTION_BITS - 1;
                    all.push(("inverse_depth", int, W_FRACTION_BITS));
                }
                all
            }
            Order::Glint(glint) => {
                let place = (PLACE_INTEGER_BITS, PLACE_FRACTION_BITS + n);
                let mut all = vec![
                    ("light", LIGHT_INTEGER_BITS, LIGHT_FRACTION_BITS + n),
                    ("lobe", place.0, place.1),
                ];
                if glint == Glint::Spot {
                    all.push(("cone", place.0, place.1));
                }
                all
            }
            Order::Bump(_) => {
                let fraction = bump::VECTOR_FRACTION_BITS + n;
                let address = bump::address_fraction_bits(self.wide);
                vec![
                    ("vector", bump::VECTOR_INTEGER_BITS, fraction),
                    ("address", bump::ADDRESS_INTEGER_BITS, address),
                ]
            }
            Order::Duff => vec![(
                "dot",
                unit_cosines::INTEGER_BITS,
                unit_cosines::FRACTION_BITS + n,
            )],
        }
    }

    /// Fraction bits of an interpolant below the units of what follows it: of a colour word below one LSB.
    #[must_use]
    pub fn fraction_bits(&self) -> usize {
        match (self.order, self.wide) {
            (Order::Quadratic | Order::QuadraticEngine | Order::Textured(_), false) => 20,
            (Order::Quadratic | Order::QuadraticEngine | Order::Textured(_), true) => 24,
            (Order::Linear, false) => 12,
            (Order::Linear, true) => 14,
            (Order::QuadraticDots | Order::Duff | Order::Glint(_), false) => 15,
            (Order::QuadraticDots | Order::Duff | Order::Glint(_), true) => 19,
            (Order::Bump(_), false) => 19,
            (Order::Bump(_), true) => 23,
            (Order::Line(_), _) => crate::line::cue::FRACTION_BITS,
            (Order::Span(_), _) => crate::lit::channel::COLOUR_FRACTION_BITS,
        }
    }

    /// Clocks from the edge that takes `start` to the edge at which the first pixel can be taken, in an idle core.
    #[must_use]
    pub fn latency(&self) -> u32 {
        6 + match self.order {
            Order::Linear | Order::Quadratic => 0,
            Order::QuadraticEngine => set_up::clocks(),
            Order::QuadraticDots => STAGES as u32,
            Order::Glint(_) => light::STAGES as u32,
            Order::Bump(bend) => (bend.stages() + STAGES) as u32,
            Order::Duff => (unit_cosines::STAGES + STAGES) as u32,
            Order::Textured(t) => (t.mapping.stages() + texture::STAGES) as u32,
            Order::Line(filter) => return filter.latency(),
            // One register level less before the pixel registers and five stages behind.
            Order::Span(_) => 4,
        }
    }

    /// Bits of the depth memory and its pages (with the texture memory of a textured core), or of the frame memory of a
    /// line core.
    #[must_use]
    pub fn memory_bits(&self) -> u64 {
        let pixels = self.pixels as u64;
        let texels = match self.order {
            Order::Line(filter) => return pixels * filter.memory_bits(),
            Order::Textured(t) => t.memory_bits(),
            Order::Bump(_) => (bump::MAP_SIZE * bump::MAP_SIZE * 36) as u64,
            _ => 0,
        };
        16 * pixels + 18 * pages(self.pixels) as u64 + texels
    }

    /// Width of the register bus.
    #[must_use]
    pub fn bus_bits(&self) -> usize {
        bus_bits(self.order, self.fraction_bits())
    }

    /// Width of a frame address.
    #[must_use]
    pub fn address_bits(&self) -> usize {
        if self.wide {
            21
        } else {
            17
        }
    }

    /// Largest arithmetic error of a colour before the final rounding, in LSB, for runs of up to `run` additions
    /// (lines + carries + pixels): words are rounded to nearest, sums are exact. Cores that shade per pixel: for colours
    /// of the diffuse reflection and the highlight of at most 255 LSB.
    #[must_use]
    pub fn error_bound(&self, run: u32) -> f64 {
        let n = f64::from(run);
        let words = match self.order {
            Order::Linear | Order::Line(_) | Order::Span(_) => 1.0 + n,
            Order::Quadratic
            | Order::QuadraticEngine
            | Order::QuadraticDots
            | Order::Duff
            | Order::Textured(_)
            | Order::Bump(_)
            | Order::Glint(_) => 1.0 + n * (n + 1.0) / 2.0,
        };
        let unit = words / 2f64.powi(self.fraction_bits() as i32 + 1);
        match self.order {
            Order::Linear | Order::Quadratic => unit,
            Order::QuadraticEngine => unit + set_up::error_bound(run),
            Order::Line(filter) => filter.error_bound(run),
            Order::Textured(t) => t.error_bound(self.wide, run, unit),
            Order::Span(kind) => kind.error_bound(run),
            Order::QuadraticDots => {
                let light = 2f64.powi(-(LIGHT_FRACTION_BITS as i32));
                let lobe = STEEPEST * 2f64.powi(-(PLACE_FRACTION_BITS as i32));
                255.0 * unit * (light + lobe) + ERROR_LSB
            }
            // Exponents up to 24, gradients up to 1 that change evenly between the samples.
            Order::Bump(bend) => {
                255.0 * bend.cosine_error(unit) * (1.0 + bump::STATED_EXPONENT) + ERROR_LSB
            }
            Order::Glint(glint) => {
                let light = 2f64.powi(-(LIGHT_FRACTION_BITS as i32));
                let place = 2f64.powi(-(PLACE_FRACTION_BITS as i32));
                let (steep, rest) = match glint {
                    Glint::Kappa => (STEEPEST_HIGHLIGHT, light::KAPPA_ERROR_LSB),
                    Glint::Spot => (
                        STEEPEST_HIGHLIGHT + 2.0 * STEEPEST_SPOT,
                        light::SPOT_ERROR_LSB,
                    ),
                };
                255.0 * unit * (light + steep * place) + rest
            }
            // |N|² of at least 1/4 and exponents up to 144, whose lobe has the scale 2³.
            Order::Duff => {
                let step = 2f64.powi(-(unit_cosines::FRACTION_BITS as i32));
                let linear = (1.0 + n) / 2f64.powi(self.fraction_bits() as i32 + 1);
                let cosine = step * (2.0 * unit + 2.0 * linear + 4.0) + inverse_root::ERROR / 2.0;
                let cut = 2f64.powi(-(LIGHT_FRACTION_BITS as i32 + 1))
                    + STEEPEST * 2f64.powi(-(PLACE_FRACTION_BITS as i32 + 1));
                255.0 * (cosine * (1.0 + 8.0 * STEEPEST) + cut) + ERROR_LSB
            }
        }
    }

    /// Integer model of the core.
    #[must_use]
    pub fn model(&self) -> CoreModel {
        CoreModel::new(
            self.order,
            self.fraction_bits(),
            self.address_bits(),
            self.pixels,
        )
    }

    /// Calls `f` with the description.
    pub fn with_design<R>(&self, f: impl DesignVisitor<R>) -> R {
        match (self.order, self.wide) {
            (Order::Quadratic, false) => laned!(self, f, QuadraticNarrow),
            (Order::Quadratic, true) => laned!(self, f, QuadraticWide),
            (Order::Linear, false) => laned!(self, f, GouraudNarrow),
            (Order::Linear, true) => laned!(self, f, GouraudWide),
            (Order::QuadraticDots, false) => laned!(self, f, QuadraticDotsNarrow),
            (Order::QuadraticDots, true) => laned!(self, f, QuadraticDotsWide),
            (Order::Duff, false) => laned!(self, f, DuffNarrow),
            (Order::Duff, true) => laned!(self, f, DuffWide),
            (Order::QuadraticEngine, false) => f.visit(QuadraticEngineNarrow::new(self.pixels)),
            (Order::QuadraticEngine, true) => f.visit(QuadraticEngineWide::new(self.pixels)),
            (Order::Textured(t), wide) => {
                let (pixels, texels) = (self.pixels, t.texels());
                match (t.mapping, wide) {
                    (Mapping::Affine, false) => f.visit(TexturedAffineNarrow::new(pixels, texels)),
                    (Mapping::Affine, true) => f.visit(TexturedAffineWide::new(pixels, texels)),
                    (Mapping::Quadratic, false) => {
                        f.visit(TexturedQuadraticNarrow::new(pixels, texels))
                    }
                    (Mapping::Quadratic, true) => {
                        f.visit(TexturedQuadraticWide::new(pixels, texels))
                    }
                    (Mapping::Perspective, false) => {
                        f.visit(TexturedPerspectiveNarrow::new(pixels, texels))
                    }
                    (Mapping::Perspective, true) => {
                        f.visit(TexturedPerspectiveWide::new(pixels, texels))
                    }
                }
            }
            (Order::Glint(Glint::Kappa), false) => f.visit(KappaNarrow::new(self.pixels)),
            (Order::Glint(Glint::Kappa), true) => f.visit(KappaWide::new(self.pixels)),
            (Order::Glint(Glint::Spot), false) => f.visit(SpotNarrow::new(self.pixels)),
            (Order::Glint(Glint::Spot), true) => f.visit(SpotWide::new(self.pixels)),
            (Order::Bump(Bend::Newton), false) => f.visit(BumpNewtonNarrow::new(self.pixels)),
            (Order::Bump(Bend::Newton), true) => f.visit(BumpNewtonWide::new(self.pixels)),
            (Order::Bump(Bend::Reflection), false) => {
                f.visit(BumpReflectionNarrow::new(self.pixels))
            }
            (Order::Bump(Bend::Reflection), true) => f.visit(BumpReflectionWide::new(self.pixels)),
            (Order::Line(filter), false) => filter.with_design::<17, R>(self.pixels, f),
            (Order::Line(filter), true) => filter.with_design::<21, R>(self.pixels, f),
            (Order::Span(kind), false) => kind.with_design::<17, R>(self, f),
            (Order::Span(kind), true) => kind.with_design::<21, R>(self, f),
        }
    }
}

/// A function over any core's description.
pub trait DesignVisitor<R> {
    /// Uses the description.
    fn visit<B: Clocked + CorePorts + 'static>(self, design: B) -> R;
}

/// The ports that all cores share.
pub trait CorePorts {
    /// Presents inputs.
    fn set(&mut self, i: &CoreInputs);
    /// Reads outputs.
    fn get(&self) -> CoreOutputs;
}

macro_rules! core_ports {
    ($type:ident, $($n:ident),+ $(; $lanes:ident)?) => {
        impl<$(const $n: usize),+> CorePorts for $type<$($n),+> {
            fn set(&mut self, i: &CoreInputs) {
                $(self.$lanes.set(&i.more);)?
                self.write.next = i.write;
                self.select.next = U::new(u64::from(i.select));
                self.data.next = U::new(i.data);
                self.start.next = i.start;
                self.clear.next = i.clear;
                self.ready.next = i.ready;
            }

            fn get(&self) -> CoreOutputs {
                let byte = |v: U<8>| v.get() as u8;
                CoreOutputs {
                    load_ready: self.load_ready.val(),
                    valid: self.valid.val(),
                    x: self.x.val().get() as u16,
                    y: self.y.val().get() as u16,
                    rgb: [
                        byte(self.red.val()),
                        byte(self.green.val()),
                        byte(self.blue.val()),
                    ],
                    depth: self.depth.val().get() as u16,
                    busy: self.busy.val(),
                    done: self.done.val(),
                }
            }
        }
    };
}
core_ports!(QuadraticCore, D, N, B, A; lanes);
core_ports!(QuadraticEngineCore, D, N, B, A);
core_ports!(GouraudCore, D, N, B, A; lanes);
core_ports!(QuadraticDotsCore, N, B, A; lanes);
core_ports!(DuffCore, N, B, A; lanes);
core_ports!(TexturedAffineCore, D, N, B, K, A);
core_ports!(TexturedQuadraticCore, D, N, B, K, A);
core_ports!(TexturedPerspectiveCore, D, N, B, A);
core_ports!(KappaCore, N, B, A);
core_ports!(BumpNewtonCore, N, B, K, A);
core_ports!(BumpReflectionCore, N, B, K, A);
core_ports!(SpotCore, N, B, A);
core_ports!(SlerpCore, A; lanes);
core_ports!(ChebyshevCore, A; lanes);
core_ports!(BlakeCore, A; lanes);
core_ports!(SphericalCore, A, K, M, P, H; lanes);
core_ports!(BresenhamCore, A);
core_ports!(BoxCore, A);
core_ports!(ConeCore, A);

/// A core's description under simulation.
pub struct CoreSimulator(Box<dyn Engine>);

trait Engine {
    fn clock(&mut self, i: &CoreInputs);
    fn outputs(&self) -> CoreOutputs;
    fn design(&self) -> &dyn Block;
}

impl<B: Clocked + CorePorts> Engine for Simulator<B> {
    fn clock(&mut self, i: &CoreInputs) {
        self.design.set(i);
        Simulator::clock(self);
    }

    fn outputs(&self) -> CoreOutputs {
        self.design.get()
    }

    fn design(&self) -> &dyn Block {
        self.design.as_ref()
    }
}

struct Build;

impl DesignVisitor<Result<CoreSimulator, String>> for Build {
    fn visit<B: Clocked + CorePorts + 'static>(self, design: B) -> Result<CoreSimulator, String> {
        Ok(CoreSimulator(Box::new(Simulator::new(design)?)))
    }
}

impl CoreSimulator {
    /// Connects and checks the core's description.
    ///
    /// # Errors
    /// What rust-hdl's checks find.
    pub fn new(core: Core) -> Result<Self, String> {
        core.with_design(Build)
    }

    /// One clock with these inputs.
    #[inline]
    pub fn clock(&mut self, i: &CoreInputs) {
        self.0.clock(i);
    }

    /// The outputs after the last clock. (They depend on state alone.)
    #[must_use]
    pub fn outputs(&self) -> CoreOutputs {
        self.0.outputs()
    }

    /// The description, for probes.
    #[must_use]
    pub fn design(&self) -> &dyn Block {
        self.0.design()
    }
}
