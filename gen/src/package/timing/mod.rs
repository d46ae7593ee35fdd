//! The timing diagram of a core: the end of a triangle's words, start, first pixel, a consumer that pauses, done.
//!
//! Nothing in it is typed in. A small triangle is set up for the very core and frame, a host writes it as a host does
//! ([`Trace::record`]), and the levels are what the integer model shows. Column k is the clock before edge k: inputs as
//! that edge sees them, outputs as they stand before it.

mod svg;
mod wavedrom;

pub use svg::svg;
pub use wavedrom::wavedrom;

use crate::spans::sample;
use crate::stimulus::{
    build, single_line, Cone, Lobe, Material, Stimulus, StimulusError, StimulusOptions, Triangle,
};
use crate::vectors::Trace;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::{CoreInputs, CoreOutputs, Order};
use shadegate_reference::raster::{Point, Viewport, SUBPIXELS};

/// Register writes shown before the last one.
const WRITES_BEFORE: usize = 2;
/// Clocks shown after the run, the first of them that of `done`.
const CLOCKS_AFTER: usize = 2;

/// Clocks shown behind `start` and before the first pixel, where an engine sets the triangle up in between.
const AROUND: usize = 2;

/// One line of the diagram.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Row {
    /// The clock.
    Clock,
    /// A signal of one bit: its name and its level in every clock.
    Bit(&'static str, Vec<bool>),
    /// A wider signal: its name and what it shows in every clock, nothing where it has no meaning.
    Bus(&'static str, Vec<Option<String>>),
}

/// A timing diagram.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagram {
    /// What is shown.
    pub title: String,
    /// Columns.
    pub clocks: usize,
    /// Lines, top to bottom.
    pub rows: Vec<Row>,
}

/// A triangle in the top left corner that covers six pixels of a frame large enough.
fn triangle(order: Order) -> Triangle {
    let point = |x: i32, y: i32| Point {
        x: x * SUBPIXELS,
        y: y * SUBPIXELS,
    };
    let corners = [
        [200.0, 40.0, 20.0],
        [20.0, 180.0, 40.0],
        [40.0, 60.0, 220.0],
    ];
    let between =
        |a: usize, b: usize| std::array::from_fn(|i| (corners[a][i] + corners[b][i]) / 2.0);
    let mut knots = corners.to_vec();
    if order != Order::Linear {
        knots.extend([between(0, 1), between(0, 2), between(1, 2)]);
    }
    if let Order::Span(_) = order {
        let normals = [[0.3, 0.1, 1.0], [0.0, 0.2, 1.0], [0.1, 0.5, 1.0]];
        knots = sample(normals, corners, 1.0);
    }
    Triangle {
        position: [point(0, 0), point(4, 0), point(0, 3)],
        depth: [40_000.0, 30_000.0, 20_000.0],
        knots: cosines(order, knots),
        material: material(order),
        covering: None,
        relief: None,
        label: "timing diagram".to_owned(),
    }
}

/// What cores that shade per pixel draw it with: matt, so that no table is sent.
pub(super) fn material(order: Order) -> Option<Material> {
    match order {
        Order::Linear
        | Order::Quadratic
        | Order::QuadraticEngine
        | Order::Line(_)
        | Order::Span(_)
        | Order::Textured(_) => None,
        Order::QuadraticDots | Order::Duff | Order::Glint(_) | Order::Bump(_) => Some(Material {
            ambient: [20.0, 10.0, 5.0],
            diffuse: [200.0, 120.0, 60.0],
            specular: [0.0; 3],
            shininess: 1.0,
            lobe: Lobe::Power,
            cone: Some(Cone {
                hard: false,
                width: 0.5,
            }),
        }),
    }
}

/// Knots of such cores from colours: N·L from dark to light.
pub(super) fn cosines(order: Order, knots: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    match order {
        Order::Linear
        | Order::Quadratic
        | Order::QuadraticEngine
        | Order::Line(_)
        | Order::Span(_)
        | Order::Textured(_) => knots,
        // In the middle of the cone.
        Order::QuadraticDots | Order::Duff | Order::Glint(_) => {
            knots.iter().map(|k| [k[0] / 255.0, 0.0, 1.0]).collect()
        }
        // The light along the normal of a smooth surface.
        Order::Bump(_) => {
            let light = knots.iter().map(|k| [0.0, 0.0, k[0] / 255.0]);
            light.clone().chain(light).collect()
        }
    }
}

/// The run that is shown: the consumer pauses for the clock in which the second pixel (or the only one) is offered.
fn run(core: Core, stimulus: &Stimulus) -> Trace {
    let free = Trace::record(core, stimulus, |_| true);
    // A pixel that one edge shows waits for the next one.
    let pause = free
        .pixels
        .get(1)
        .or(free.pixels.first())
        .map(|p| p.clock as u64 + 1);
    Trace::record(core, stimulus, |clock| Some(clock) != pause)
}

/// What the core is sent from power-on to the end of the diagram, clock by clock.
///
/// # Errors
/// When the triangle cannot be set up, which no valid frame causes.
pub fn inputs(core: &Core, size: (u32, u32)) -> Result<Vec<CoreInputs>, StimulusError> {
    let (width, height) = size;
    let viewport = Viewport { width, height };
    let stimulus = match core.order {
        Order::Line(filter) => single_line(filter, viewport, 6)?,
        _ => {
            let triangles = [triangle(core.order)];
            build(core, &triangles, viewport, &StimulusOptions::default())?
        }
    };
    // One lane shows it all; the others stay idle.
    let one = Core {
        load_words: 1,
        ..*core
    };
    let trace = run(one, &stimulus);
    let idle = CoreInputs {
        ready: true,
        ..CoreInputs::default()
    };
    let sent = trace.clocks.iter().map(|c| c.inputs);
    Ok(sent.chain([idle; CLOCKS_AFTER]).collect())
}

/// The diagram of a core in a frame.
///
/// # Errors
/// As [`inputs`].
pub fn diagram(core: &Core, size: (u32, u32)) -> Result<Diagram, StimulusError> {
    let inputs = inputs(core, size)?;
    let mut model = core.model();
    let mut clocks: Vec<(CoreInputs, CoreOutputs)> = vec![];
    for i in &inputs {
        clocks.push((*i, model.outputs()));
        model.clock(i);
    }
    let start = inputs.iter().position(|i| i.start).unwrap_or(0);
    clocks.drain(..start.saturating_sub(WRITES_BEFORE));
    let mut title = format!("{}_core: last words, start, pixels, done", core.module());
    if core.order == Order::QuadraticEngine {
        let shown = clocks.iter().position(|c| c.1.valid).unwrap_or(0);
        let left_out = (WRITES_BEFORE + 1 + AROUND)..shown.saturating_sub(AROUND);
        title += &format!(" ({} clocks of set-up left out)", left_out.len());
        clocks.drain(left_out.start.min(left_out.end)..left_out.end);
    }
    Ok(Diagram {
        title,
        clocks: clocks.len(),
        rows: rows(core, &clocks),
    })
}

fn rows(core: &Core, clocks: &[(CoreInputs, CoreOutputs)]) -> Vec<Row> {
    let input =
        |name, f: fn(&CoreInputs) -> bool| Row::Bit(name, clocks.iter().map(|c| f(&c.0)).collect());
    let output = |name, f: fn(&CoreOutputs) -> bool| {
        Row::Bit(name, clocks.iter().map(|c| f(&c.1)).collect())
    };
    let written = |name, f: &dyn Fn(&CoreInputs) -> String| {
        let cell = |c: &(CoreInputs, CoreOutputs)| c.0.write.then(|| f(&c.0));
        Row::Bus(name, clocks.iter().map(cell).collect())
    };
    let offered = |name, f: &dyn Fn(&CoreOutputs) -> String| {
        let cell = |c: &(CoreInputs, CoreOutputs)| c.1.valid.then(|| f(&c.1));
        Row::Bus(name, clocks.iter().map(cell).collect())
    };
    let digits = core.bus_bits().div_ceil(4);
    vec![
        Row::Clock,
        input("write", |i| i.write),
        written("select", &|i| format!("{:02x}", i.select)),
        written("data", &|i| format!("{:0digits$x}", i.data)),
        input("start", |i| i.start),
        output("load_ready", |o| o.load_ready),
        output("busy", |o| o.busy),
        output("valid", |o| o.valid),
        input("ready", |i| i.ready),
        offered("x, y", &|o| format!("{}, {}", o.x, o.y)),
        offered("colour", &|o| {
            let [r, g, b] = o.rgb;
            format!("{r:02x}{g:02x}{b:02x}")
        }),
        offered("depth", &|o| format!("{:04x}", o.depth)),
        output("done", |o| o.done),
    ]
}
