//! Integer model of the span cores, clock by clock.

use super::model::{CoreInputs, CoreOutputs};
use super::pace::Pace;
use super::span_core::SpanKind;
use crate::interpolate::linear_span::LinearSpanModel;
use crate::interpolate::quadratic_span::QuadraticSpanModel;
use crate::lit::angle::AngleFactorModel;
use crate::lit::chebyshev::ChebyshevModel;
use crate::lit::clamp::ClampFactorModel;
use crate::lit::loader::{self, TableLoaderModel};
use crate::lit::power::PowerTableModel;
use crate::lit::stream_model::{Fragment, LitStreamInputs, LitStreamModel};
use crate::lit::swing::SwingModel;
use crate::lit::table_memory::TableMemoryModel;
use crate::raster::span_shell_model::{SpanShellInputs, SpanShellModel};

/// What the factors of a core see in one clock.
struct Terms {
    go: bool,
    take: bool,
    run: bool,
    /// Register writes to diffuse term and highlight.
    writes: [Option<(usize, u64)>; 2],
    shift: u64,
    material: u64,
    /// Address and word for the highlight table.
    highlight: Option<(u64, u64)>,
    /// Address and word for the cosine table.
    cosine: Option<(u64, u64)>,
}

/// How the factors are found.
#[derive(Clone, Debug)]
enum Factors {
    Slerp([SwingModel; 2], ClampFactorModel, PowerTableModel),
    Chebyshev([ChebyshevModel; 2], ClampFactorModel, PowerTableModel),
    Spherical([AngleFactorModel; 2], [TableMemoryModel; 2], u64),
    Blake([QuadraticSpanModel; 2], [ClampFactorModel; 2]),
}

impl Factors {
    fn new(kind: SpanKind) -> Self {
        match kind {
            SpanKind::Slerp => {
                Self::Slerp(Default::default(), Default::default(), Default::default())
            }
            SpanKind::Chebyshev => {
                Self::Chebyshev(Default::default(), Default::default(), Default::default())
            }
            SpanKind::Spherical(k) | SpanKind::SphericalPower(k) => Self::Spherical(
                [AngleFactorModel::new(k); 2],
                [TableMemoryModel::new(k, k), TableMemoryModel::new(k + 2, k)],
                0,
            ),
            SpanKind::Blake | SpanKind::BlakeRefit | SpanKind::BlakeTrapezium => {
                Self::Blake(Default::default(), Default::default())
            }
        }
    }

    /// Diffuse factor and highlight of the third stage.
    fn values(&self) -> [u64; 2] {
        match self {
            Self::Slerp(_, d, s) | Self::Chebyshev(_, d, s) => [d.factor(), s.factor()],
            Self::Spherical(terms, ..) => [0, 1].map(|i| terms[i].factor()),
            Self::Blake(_, clamps) => [0, 1].map(|i| clamps[i].factor()),
        }
    }

    fn clock(&mut self, i: &Terms) {
        let at = [i.shift, i.material];
        match self {
            Self::Slerp(cosines, clamp, power) => {
                clamp.clock(i.go, cosines[0].value >> 26);
                power.clock(i.go, cosines[1].value, at, i.highlight);
                for (c, write) in cosines.iter_mut().zip(i.writes) {
                    c.clock(write, i.take, i.run);
                }
            }
            Self::Chebyshev(cosines, clamp, power) => {
                clamp.clock(i.go, cosines[0].value >> 26);
                power.clock(i.go, cosines[1].value, at, i.highlight);
                for (c, write) in cosines.iter_mut().zip(i.writes) {
                    c.clock(write, i.take, i.run);
                }
            }
            Self::Spherical(terms, tables, material) => {
                let words = [0, 1].map(|t| tables[t].read_data);
                let addresses = [terms[0].address(), terms[1].address() << 2 | *material];
                tables[0].clock(i.go.then_some(addresses[0]), i.cosine);
                tables[1].clock(i.go.then_some(addresses[1]), i.highlight);
                for ((t, write), word) in terms.iter_mut().zip(i.writes).zip(words) {
                    t.clock(i.go, write, [i.take, i.run], word);
                }
                if i.go {
                    *material = i.material;
                }
            }
            Self::Blake(terms, clamps) => {
                for ((t, clamp), write) in terms.iter_mut().zip(clamps).zip(i.writes) {
                    clamp.clock(i.go, t.value() >> 14);
                    t.clock(32, write, i.take, i.run);
                }
            }
        }
    }
}

/// State of a span core.
#[derive(Clone, Debug)]
pub struct SpanModel {
    shell: SpanShellModel,
    loader: TableLoaderModel,
    depth: LinearSpanModel,
    factors: Factors,
    stream: LitStreamModel,
}

impl SpanModel {
    /// A core at power-up; frame addresses have `address_bits`, the depth memory `pixels` words.
    #[must_use]
    pub fn new(kind: SpanKind, address_bits: usize, pixels: usize) -> Self {
        Self {
            shell: SpanShellModel::new(address_bits),
            loader: TableLoaderModel::default(),
            depth: LinearSpanModel::default(),
            factors: Factors::new(kind),
            stream: LitStreamModel::new(pixels),
        }
    }

    /// The outputs of the current state.
    #[must_use]
    pub fn outputs(&self) -> CoreOutputs {
        CoreOutputs {
            load_ready: self.shell.open(self.stream.clearing()),
            ..self.stream.outputs(self.shell.busy())
        }
    }

    /// Ordinal of the span that the offered pixel belongs to.
    #[must_use]
    pub fn ordinal(&self) -> u64 {
        self.stream.ordinal()
    }

    fn shell_inputs(&self, i: &CoreInputs, write: Option<(usize, u64)>) -> SpanShellInputs {
        SpanShellInputs {
            write,
            start: i.start,
            hold: self.stream.clearing(),
            go: self.stream.go(i.ready),
        }
    }

    /// What a clock with these inputs is spent on.
    #[must_use]
    pub fn pace(&self, i: &CoreInputs) -> Pace {
        self.shell.pace(&self.shell_inputs(i, None))
    }

    /// One clock edge.
    pub fn clock(&mut self, i: &CoreInputs) {
        let accept = self.shell.open(self.stream.clearing());
        let to = |target: usize| {
            let word = i.word_for(target).filter(|_| accept);
            word.map(|(word, data)| (word, data & 0xffff_ffff))
        };
        let write = |bit: usize| to(1 + bit);
        let frame = to(0);
        let si = self.shell_inputs(i, frame);
        let (take, run) = self.shell.controls(&si);
        let p = self.shell.pixel;
        self.stream.clock(&LitStreamInputs {
            clear: i.clear,
            ready: i.ready,
            walking: self.shell.busy(),
            fragment: Fragment {
                held: self.shell.running,
                ordinal: self.shell.ordinal,
                x: p.x,
                y: p.y,
                address: p.address,
                depth: self.depth.value() >> 16,
            },
            material: p.material,
            factors: self.factors.values(),
            colour: frame
                .filter(|(word, _)| *word == loader::COLOUR)
                .map(|(_, data)| data),
        });
        self.factors.clock(&Terms {
            go: si.go,
            take,
            run,
            writes: [write(0), write(1)],
            shift: p.shift,
            material: p.material,
            highlight: self.loader.table(frame, loader::HIGHLIGHT),
            cosine: self.loader.table(frame, loader::COSINE),
        });
        self.depth.clock(32, write(3), take, run);
        self.loader.clock(frame);
        self.shell.clock(&si);
    }
}
