//! Units of the line cores, and interpolants with the widest words.

use crate::harness::case::Case;
use crate::harness::code::drive;
use shadegate_hdl::interpolate::cubic_1::Cubic1;
use shadegate_hdl::interpolate::linear_2::Linear2;
use shadegate_hdl::interpolate::quadratic_1::Quadratic1;
use shadegate_hdl::line::blend::Blend;
use shadegate_hdl::line::box_weight::BoxWeight;
use shadegate_hdl::line::cone_column::ConeColumns;
use shadegate_hdl::line::cone_stages::ConeStages;
use shadegate_hdl::line::place::LanePlace;
use shadegate_hdl::line::walk::LineWalk;

drive!(Cubic1<11, 52>, clock; load, run, start, step, bend, twist);
drive!(Cubic1<5, 7>, clock; load, run, start, step, bend, twist);
drive!(Quadratic1<11, 52>, clock; load, run, start, step, bend);
drive!(Linear2<64, 11, 52>, clock; write, word, data, load, step, carry, take, run);
drive!(LineWalk<6>, clock; write, word, data, start, hold, go, whole);
drive!(LanePlace<6>; lane, below, major, minor, address, steep, falling, frame_width, frame_height);
drive!(BoxWeight, clock; write, word, data, load, advance, rises, upper);
drive!(ConeStages, clock; write, word, data, load, run, turn, rises, lane);
drive!(ConeColumns<6, 4, 27>, clock; write, word, data, start, ready);
drive!(Blend, clock; go, old, target, weight);

pub fn cases() -> Vec<Case> {
    vec![
        Case::named("cubic_wide", Cubic1::<11, 52>::default()),
        Case::named("cubic_narrow", Cubic1::<5, 7>::default()),
        Case::named("quadratic_wide", Quadratic1::<11, 52>::default()),
        Case::named("plane_wide", Linear2::<64, 11, 52>::default()),
        Case::named("line_walk_small", LineWalk::<6>::default()),
        Case::named("lane_place_small", LanePlace::<6>::default()),
        Case::named("box_weight_unit", BoxWeight::default()),
        Case::named("cone_stages_unit", ConeStages::default()),
        Case::named("cone_columns_small", ConeColumns::<6, 4, 27>::default()),
        Case::named("blend_unit", Blend::default()),
    ]
}
