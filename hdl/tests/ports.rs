//! Every description lists its ports completely; a block with a forgotten input would stand still in simulation.

use rust_hdl_core::prelude::*;
use shadegate_hdl::depth::frame_memory::{ColourMemory, FrameMemory};
use shadegate_hdl::depth::pages::Pages;
use shadegate_hdl::depth::z_buffer::ZBuffer;
use shadegate_hdl::interpolate::constant_1::Constant1;
use shadegate_hdl::interpolate::constant_2::Constant2;
use shadegate_hdl::interpolate::cubic_1::Cubic1;
use shadegate_hdl::interpolate::linear_1::Linear1;
use shadegate_hdl::interpolate::linear_2::Linear2;
use shadegate_hdl::interpolate::linear_span::LinearSpan;
use shadegate_hdl::interpolate::quadratic_1::Quadratic1;
use shadegate_hdl::interpolate::quadratic_2::Quadratic2;
use shadegate_hdl::interpolate::quadratic_span::QuadraticSpan;
use shadegate_hdl::light::highlight::Highlight;
use shadegate_hdl::light::kappa_colour::KappaColour;
use shadegate_hdl::light::skip::Skip;
use shadegate_hdl::light::spot::Spot;
use shadegate_hdl::light::spot_colour::SpotColour;
use shadegate_hdl::line::blend::Blend;
use shadegate_hdl::line::box_filter::BoxCore;
use shadegate_hdl::line::box_weight::BoxWeight;
use shadegate_hdl::line::bresenham::BresenhamCore;
use shadegate_hdl::line::cone::ConeCore;
use shadegate_hdl::line::cone_column::ConeColumns;
use shadegate_hdl::line::cone_stages::ConeStages;
use shadegate_hdl::line::cone_words::ConeWords;
use shadegate_hdl::line::cue::Cue;
use shadegate_hdl::line::place::LanePlace;
use shadegate_hdl::line::stream::LineStream;
use shadegate_hdl::line::walk::LineWalk;
use shadegate_hdl::line::weight_rom::WeightRom;
use shadegate_hdl::lit::angle::AngleFactor;
use shadegate_hdl::lit::channel::LitChannel;
use shadegate_hdl::lit::chebyshev::Chebyshev;
use shadegate_hdl::lit::clamp::ClampFactor;
use shadegate_hdl::lit::loader::TableLoader;
use shadegate_hdl::lit::place::PlaceStage;
use shadegate_hdl::lit::power::PowerTable as LitPower;
use shadegate_hdl::lit::stream::LitStream;
use shadegate_hdl::lit::swing::Swing;
use shadegate_hdl::lit::table_memory::TableMemory;
use shadegate_hdl::raster::edge_walk::EdgeWalk;
use shadegate_hdl::raster::shell::Shell;
use shadegate_hdl::raster::span_shell::SpanShell;
use shadegate_hdl::set_up::divider::Divider;
use shadegate_hdl::set_up::engine::SetUpEngine;
use shadegate_hdl::set_up::multiplier::Multiplier;
use shadegate_hdl::set_up::program_rom::ProgramRom;
use shadegate_hdl::shade::blake::BlakeCore;
use shadegate_hdl::shade::chebyshev::ChebyshevCore;
use shadegate_hdl::shade::device::{
    DuffNarrow, GouraudNarrow, KappaNarrow, QuadraticDotsNarrow, QuadraticEngineNarrow,
    QuadraticNarrow, SpotNarrow,
};
use shadegate_hdl::shade::phong::colour::PhongColour;
use shadegate_hdl::shade::phong::cosine::Cosine;
use shadegate_hdl::shade::phong::fragment_delay::FragmentDelay;
use shadegate_hdl::shade::phong::inverse_root::InverseRoot;
use shadegate_hdl::shade::phong::lobe_place::LobePlace;
use shadegate_hdl::shade::phong::power::Power;
use shadegate_hdl::shade::phong::power_table::PowerTable;
use shadegate_hdl::shade::phong::reflect::Reflect;
use shadegate_hdl::shade::phong::root_table::RootTable;
use shadegate_hdl::shade::phong::unit_cosines::UnitCosines;
use shadegate_hdl::shade::pixel_stream::PixelStream;
use shadegate_hdl::shade::saturate::Saturate;
use shadegate_hdl::shade::slerp::SlerpCore;
use shadegate_hdl::shade::span_core::Spherical6;
use shadegate_hdl::simulate::{check_ports, Quiet, Register, Wire};

#[test]
fn every_description_lists_its_ports() {
    check_ports(&Constant1::<11, 12>::default()).unwrap();
    check_ports(&Linear1::<11, 12>::default()).unwrap();
    check_ports(&Quadratic1::<11, 20>::default()).unwrap();
    check_ports(&Cubic1::<11, 20>::default()).unwrap();
    check_ports(&Constant2::<24, 11, 12>::default()).unwrap();
    check_ports(&Linear2::<24, 11, 12>::default()).unwrap();
    check_ports(&Quadratic2::<32, 11, 20>::default()).unwrap();
    check_ports(&EdgeWalk::default()).unwrap();
    check_ports(&Shell::<17>::default()).unwrap();
    check_ports(&FrameMemory::<6>::new(41)).unwrap();
    check_ports(&Pages::<6>::new(41)).unwrap();
    check_ports(&ZBuffer::<6>::new(41)).unwrap();
    check_ports(&Saturate::default()).unwrap();
    check_ports(&PixelStream::<6>::new(41)).unwrap();
    check_ports(&LinearSpan::<15, 16>::default()).unwrap();
    check_ports(&QuadraticSpan::<17, 14>::default()).unwrap();
    check_ports(&SpanShell::<17>::default()).unwrap();
    check_ports(&TableMemory::<6, 9>::default()).unwrap();
    check_ports(&TableLoader::default()).unwrap();
    check_ports(&PlaceStage::<17>::default()).unwrap();
    check_ports(&LitChannel::default()).unwrap();
    check_ports(&ClampFactor::default()).unwrap();
    check_ports(&LitPower::default()).unwrap();
    check_ports(&Swing::default()).unwrap();
    check_ports(&Chebyshev::default()).unwrap();
    check_ports(&AngleFactor::<6, 12, 24>::default()).unwrap();
    check_ports(&LitStream::<6>::new(41)).unwrap();
    check_ports(&SlerpCore::<17>::new(1200)).unwrap();
    check_ports(&ChebyshevCore::<17>::new(1200)).unwrap();
    check_ports(&Spherical6::<17>::new(1200)).unwrap();
    check_ports(&BlakeCore::<17>::new(1200)).unwrap();
    check_ports(&GouraudNarrow::new(1200)).unwrap();
    check_ports(&QuadraticNarrow::new(1200)).unwrap();
    check_ports(&PowerTable::default()).unwrap();
    check_ports(&Power::default()).unwrap();
    check_ports(&Reflect::default()).unwrap();
    check_ports(&PhongColour::default()).unwrap();
    check_ports(&FragmentDelay::<6>::default()).unwrap();
    check_ports(&RootTable::default()).unwrap();
    check_ports(&InverseRoot::default()).unwrap();
    check_ports(&Cosine::default()).unwrap();
    check_ports(&LobePlace::default()).unwrap();
    check_ports(&UnitCosines::default()).unwrap();
    check_ports(&Highlight::default()).unwrap();
    check_ports(&Spot::default()).unwrap();
    check_ports(&Skip::default()).unwrap();
    check_ports(&KappaColour::default()).unwrap();
    check_ports(&SpotColour::default()).unwrap();
    check_ports(&KappaNarrow::new(1200)).unwrap();
    check_ports(&SpotNarrow::new(1200)).unwrap();
    check_ports(&DuffNarrow::new(1200)).unwrap();
    check_ports(&QuadraticDotsNarrow::new(1200)).unwrap();
    check_ports(&QuadraticEngineNarrow::new(1200)).unwrap();
    check_ports(&SetUpEngine::<20, 32>::default()).unwrap();
    check_ports(&Multiplier::default()).unwrap();
    check_ports(&Divider::default()).unwrap();
    check_ports(&ProgramRom::default()).unwrap();
}

#[test]
fn every_description_of_lines_lists_its_ports() {
    check_ports(&LineWalk::<17>::default()).unwrap();
    check_ports(&LanePlace::<17>::default()).unwrap();
    check_ports(&Cue::default()).unwrap();
    check_ports(&BoxWeight::default()).unwrap();
    check_ports(&WeightRom::<5>::default()).unwrap();
    check_ports(&ConeWords::<9, 22>::default()).unwrap();
    check_ports(&ConeStages::default()).unwrap();
    check_ports(&ConeColumns::<17, 5, 26>::default()).unwrap();
    check_ports(&Blend::default()).unwrap();
    check_ports(&ColourMemory::<6>::new(41)).unwrap();
    check_ports(&LineStream::<6>::new(41)).unwrap();
    check_ports(&BresenhamCore::<6>::default()).unwrap();
    check_ports(&BoxCore::<6>::new(41)).unwrap();
    check_ports(&ConeCore::<6>::new(41)).unwrap();
}

#[derive(LogicBlock, Default)]
struct Both {
    pub a: Signal<In, Bit>,
    pub b: Signal<In, Bit>,
    pub both: Signal<Out, Bit>,
}

impl Logic for Both {
    #[hdl_gen]
    fn update(&mut self) {
        self.both.next = self.a.val() && self.b.val();
    }
}

shadegate_hdl::ports!(Both; inputs a; outputs both);

#[test]
fn a_forgotten_input_is_found() {
    let message = check_ports(&Both::default()).unwrap_err();
    assert!(message.contains("found [\"a\", \"b\"]"), "{message}");
}

/// Scopes and atoms as a back end meets them.
#[derive(Default)]
struct Outline(Vec<String>);

impl Probe for Outline {
    fn visit_start_scope(&mut self, name: &str, node: &dyn Block) {
        self.0.push(format!("{name} {:?}", node.hdl()));
    }

    fn visit_atom(&mut self, name: &str, a: &dyn Atom) {
        let connected = a.connected();
        self.0
            .push(format!("{name} {} {:?} {connected}", a.bits(), a.kind()));
    }

    fn visit_end_scope(&mut self, name: &str, _node: &dyn Block) {
        self.0.push(format!("end {name}"));
    }
}

fn outline(block: &dyn Block) -> Vec<String> {
    let mut o = Outline::default();
    block.accept("x", &mut o);
    o.0
}

#[test]
fn a_quiet_block_looks_like_its_inner_block() {
    let mut plain = EdgeWalk::default();
    let mut quiet = Quiet::from(EdgeWalk::default());
    plain.connect_all();
    quiet.connect_all();
    assert_eq!(outline(&plain), outline(&quiet));
}

#[test]
fn a_register_looks_like_a_flip_flop_of_rust_hdl() {
    let mut theirs = rust_hdl_widgets::prelude::DFF::<Bits<7>>::default();
    let mut ours = Register::<Bits<7>>::default();
    theirs.connect_all();
    ours.connect_all();
    assert_eq!(outline(&theirs), outline(&ours));
}

#[test]
fn a_wire_looks_like_a_local_signal_of_rust_hdl() {
    let mut theirs = Signal::<Local, Bits<7>>::default();
    let mut ours = Wire::<Bits<7>>::default();
    theirs.connect();
    ours.connect();
    assert_eq!(outline(&theirs), outline(&ours));
}
