//! The main job: scene → set-up → stimulus → engine → frame → judgement.

pub mod bump_oracle;
mod frames;
mod lines;
mod report;
mod span_oracle;
pub mod texture_oracle;
mod write;

pub use report::{
    ClockReport, CosimReport, ErrorReport, FirstMismatch, FormatReport, HostReport, TimeReport,
};

use crate::compare::{compare, Rgb8Ref};
use crate::engine::{run, Engine, EngineError, Wave};
use frames::Frames;
use shadegate_gen::package::{package, rtl, Package, PackageError};
use shadegate_gen::scene::{
    self, drawable, fitting, line_order, order_for, order_of, suited, triangles_for, SetUp,
    Undrawable, Unsuited, CORES,
};
use shadegate_gen::spans::{self, Refused};
use shadegate_gen::stimulus::{build, build_lines, Line, StimulusError, StimulusOptions};
use shadegate_gen::vectors::Trace;
use shadegate_gen::write::WriteError;
use shadegate_hdl::shade::device::{Core, LoadWordsError, MAX_HEIGHT, MAX_WIDTH};
use shadegate_hdl::shade::model::Order;
use shadegate_reference::antialias::Antialias;
use shadegate_reference::line::LineFilter;
use shadegate_reference::raster::Viewport;
use shadegate_reference::scene::Draw;
use shadegate_reference::{
    render, skips, Method, Prepared, RenderOptions, Scene, SceneError, Skips,
};
use std::path::PathBuf;
use std::time::Instant;

/// What to run.
#[derive(Clone, Debug)]
pub struct CosimOptions {
    /// Shading method; it must have a core. Wireframes are drawn by the core of the scene's filter of lines instead.
    pub method: Method,
    /// Engine.
    pub engine: Engine,
    /// Frame size instead of the scene's.
    pub size: Option<(u32, u32)>,
    /// Waveform of a window of clocks.
    pub wave: Option<Wave>,
    /// Where frames, Verilog and reports go; nothing is written without it.
    pub output: Option<PathBuf>,
    /// What the host leaves out.
    pub stimulus: StimulusOptions,
    /// The command line, for reports.
    pub command: String,
}

/// Why a co-simulation could not be done.
#[derive(Debug, thiserror::Error)]
pub enum CosimError {
    /// The scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The scene has something that no core draws.
    #[error(transparent)]
    Undrawable(#[from] Undrawable),
    /// The scene has lights or materials that this core does not draw.
    #[error(transparent)]
    Unsuited(#[from] Unsuited),
    /// The scene has something that this span core does not draw.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// The method has no core.
    #[error("method '{0}' has no core; methods with a core: {cores}", cores = methods_with_core())]
    NoCore(Method),
    /// The core has no set-up engine.
    #[error("core '{0}' has no set-up engine; expected a method that has one: quadratic")]
    NoEngine(&'static str),
    /// Edges and faces.
    #[error("object[{wireframe}] of the scene is a wireframe and object[{shaded}] is shaded, and no core draws both; expected the same draw for every object")]
    Mixture {
        /// The first wireframe.
        wireframe: usize,
        /// The first other object.
        shaded: usize,
    },
    /// Anti-aliasing.
    #[error(
        "the scene asks for antialias = '{0}', which no core draws; expected antialias = 'none'"
    )]
    Antialias(Antialias),
    /// The frame exceeds the core's coordinates.
    #[error(
        "frame {width}x{height} exceeds the core's coordinate range: at most {MAX_WIDTH} columns and \
         {MAX_HEIGHT} rows"
    )]
    TooLarge {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// The core has no such load port.
    #[error(transparent)]
    LoadWords(#[from] LoadWordsError),
    /// A triangle or line exceeds the core's formats.
    #[error(transparent)]
    Stimulus(#[from] StimulusError),
    /// The Verilog cannot be emitted: a defect.
    #[error(transparent)]
    Package(#[from] PackageError),
    /// The engine.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// A file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// Frames that cannot be compared or saved.
    #[error(transparent)]
    Compare(#[from] crate::compare::CompareError),
    /// A temporary directory.
    #[error("temporary directory: {0}")]
    Scratch(std::io::Error),
}

fn methods_with_core() -> String {
    CORES.map(|(_, _, method)| method.name()).join(", ")
}

/// The core for a method and frame.
///
/// # Errors
/// Methods without a core, frames beyond the coordinate range.
pub fn core_for(method: Method, width: u32, height: u32) -> Result<Core, CosimError> {
    let order = order_of(method).ok_or(CosimError::NoCore(method))?;
    Core::for_frame(order, width, height).ok_or(CosimError::TooLarge { width, height })
}

/// The core of a method for what a scene has, and a frame.
///
/// # Errors
/// Methods without a core, textures that no core draws, frames beyond the coordinate range.
pub fn scene_core_for(
    scene: &Scene,
    method: Method,
    width: u32,
    height: u32,
) -> Result<Core, CosimError> {
    let order = order_for(scene, method)?.ok_or(CosimError::NoCore(method))?;
    Core::for_frame(order, width, height).ok_or(CosimError::TooLarge { width, height })
}

/// The core that draws the same with another set-up.
///
/// # Errors
/// Cores without a set-up engine.
pub fn with_set_up(core: Core, set_up: SetUp) -> Result<Core, CosimError> {
    let order = set_up
        .of(core.order)
        .ok_or(CosimError::NoEngine(core.name()))?;
    Ok(Core { order, ..core })
}

/// The core for a filter of lines and a frame.
///
/// # Errors
/// Frames beyond the coordinate range.
pub fn line_core_for(filter: LineFilter, width: u32, height: u32) -> Result<Core, CosimError> {
    Core::for_frame(line_order(filter), width, height).ok_or(CosimError::TooLarge { width, height })
}

/// Whether a scene is drawn by a line core: all its objects are wireframes.
///
/// # Errors
/// Scenes of wireframes and shaded objects.
pub fn is_wireframe(scene: &Scene) -> Result<bool, CosimError> {
    let of = |wire: bool| {
        scene
            .objects
            .iter()
            .position(|o| (o.draw == Draw::Wireframe) == wire)
    };
    match (of(true), of(false)) {
        (Some(wireframe), Some(shaded)) => Err(CosimError::Mixture { wireframe, shaded }),
        (wireframe, _) => Ok(wireframe.is_some()),
    }
}

/// Everything that is known before an engine runs.
pub struct Prelude {
    /// The prepared scene.
    pub prepared: Prepared,
    /// The recorded run of the integer model.
    pub trace: Trace,
    /// Emitted files.
    pub package: Package,
    /// Triangles that are sent to the core, and what is left out.
    pub host: HostReport,
    /// Triangles as the core sees them.
    pub triangles: Vec<shadegate_gen::stimulus::Triangle>,
    /// Lines as a line core sees them.
    pub lines: Vec<Line>,
    setup_ns: u64,
    emit_ns: u64,
}

/// Sets a scene up for a core: knots, words, expected outputs, Verilog.
///
/// # Errors
/// See [`CosimError`].
pub fn prelude(
    scene: &Scene,
    method: Method,
    size: Option<(u32, u32)>,
    stimulus: &StimulusOptions,
) -> Result<Prelude, CosimError> {
    prelude_by(scene, method, SetUp::Host, size, stimulus)
}

/// [`prelude`] with the host or an engine to set triangles up.
///
/// # Errors
/// See [`CosimError`].
pub fn prelude_by(
    scene: &Scene,
    method: Method,
    set_up: SetUp,
    size: Option<(u32, u32)>,
    stimulus: &StimulusOptions,
) -> Result<Prelude, CosimError> {
    let begin = Instant::now();
    let (width, height) = size.unwrap_or((scene.image.width, scene.image.height));
    let wires = is_wireframe(scene)?;
    let core = if wires {
        line_core_for(scene.render.line, width, height)?
    } else {
        scene_core_for(scene, method, width, height)?
    };
    let core = with_set_up(core, set_up)?;
    let core = core.with_load_words(stimulus.load_words.unwrap_or(core.load_words))?;
    refuse(scene)?;
    drawable(scene, core.order)?;
    suited(scene, core.order)?;
    let prepared = Prepared::new(scene, Some((width, height)), &Skips::all())?;
    spans::drawable(scene, &prepared, core.order)?;
    fitting(scene, &prepared, core.order)?;
    let viewport = Viewport { width, height };
    let (mut triangles, mut lines) = (vec![], vec![]);
    let stimulus = match core.order {
        Order::Line(filter) => {
            lines = scene::lines(&prepared);
            build_lines(filter, &lines, viewport, prepared.background, stimulus)?
        }
        _ => {
            triangles = triangles_for(&prepared, method, core.order);
            stimulus.depth.apply(&prepared, &mut triangles);
            build(&core, &triangles, viewport, stimulus)?
        }
    };
    let setup_ns = begin.elapsed().as_nanos() as u64;
    let trace = Trace::record(core, &stimulus, |_| true);
    let begin = Instant::now();
    let package = package(&rtl(&core)?, &trace, (width, height), None)?;
    let emit_ns = begin.elapsed().as_nanos() as u64;
    let host = HostReport::new(&stimulus, &trace);
    Ok(Prelude {
        prepared,
        trace,
        package,
        host,
        triangles,
        lines,
        setup_ns,
        emit_ns,
    })
}

/// How the frame of the method is rendered: a core follows the mapping of a texture everywhere.
fn method_options(core: &Core) -> RenderOptions {
    let mut options = RenderOptions::default();
    if matches!(core.order, Order::Textured(_)) {
        options.skips = options.skips.but(skips::AFFINE).but(skips::CONSTANT_DEPTH);
    }
    options
}

/// Refuses scenes with anything that software alone draws.
fn refuse(scene: &Scene) -> Result<(), CosimError> {
    match scene.render.antialias {
        Antialias::None => Ok(()),
        a => Err(CosimError::Antialias(a)),
    }
}

/// Runs a co-simulation and writes its results.
///
/// # Errors
/// See [`CosimError`]. A mismatch is not an error: it is in the report.
pub fn cosim(scene: &Scene, o: &CosimOptions) -> Result<CosimReport, CosimError> {
    cosim_by(scene, o, SetUp::Host)
}

/// [`cosim`] with the host or an engine to set triangles up.
///
/// # Errors
/// See [`CosimError`].
pub fn cosim_by(scene: &Scene, o: &CosimOptions, set_up: SetUp) -> Result<CosimReport, CosimError> {
    let p = prelude_by(scene, o.method, set_up, o.size, &o.stimulus)?;
    let scratch = tempfile::tempdir().map_err(CosimError::Scratch)?;
    let result = run(
        o.engine,
        &p.trace,
        &p.package.files,
        scratch.path(),
        o.wave.as_ref(),
    )?;
    let begin = Instant::now();
    let expected: Vec<_> = p.trace.pixels.iter().map(|x| (x.x, x.y, x.rgb)).collect();
    let method_frame = match p.trace.core.order {
        Order::Glint(_) => frames::method_frame(&p),
        _ => {
            let (frame, _) = render(&p.prepared, o.method, &method_options(&p.trace.core));
            frame.pixels
        }
    };
    let (exact_frame, _) = render(&p.prepared, Method::Exact, &RenderOptions::default());
    let frames = Frames::new(
        &p.prepared,
        &expected,
        &result.pixels,
        &method_frame,
        &exact_frame.pixels,
    );
    let view = |pixels| Rgb8Ref::new(p.prepared.width, p.prepared.height, pixels);
    let simulated = view(&frames.simulated)?;
    let against_expected = compare(view(&frames.expected)?, simulated)?;
    let against_method = compare(view(&frames.method)?, simulated)?;
    let against_exact = compare(view(&frames.exact)?, simulated)?;
    let fragments = frames::fragment_error(&p);
    let compare_ns = begin.elapsed().as_nanos() as u64;
    let report = CosimReport::new(report::Inputs {
        prelude: &p,
        options: o,
        scene_name: &scene.name,
        run: &result,
        against_expected: &against_expected,
        against_method: &against_method,
        against_exact: &against_exact,
        fragments,
        compare_ns,
    });
    if let Some(directory) = &o.output {
        write::write(directory, &p, &frames, &report)?;
    }
    Ok(report)
}
