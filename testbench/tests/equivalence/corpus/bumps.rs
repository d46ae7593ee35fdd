//! Units of highlights, spots and bumps.

use crate::harness::case::Case;
use crate::harness::code::drive;
use shadegate_hdl::bump::dot::BumpDot;
use shadegate_hdl::bump::fetch::BumpFetch;
use shadegate_hdl::bump::newton::BumpNewton;
use shadegate_hdl::bump::reflection::BumpReflection;
use shadegate_hdl::light::highlight::Highlight;
use shadegate_hdl::light::skip::Skip;
use shadegate_hdl::light::spot::Spot;

drive!(Highlight, clock; go, degree, place, off);
drive!(Spot, clock; go, hard, place, off);
drive!(Skip, clock; write, data, load, take);
drive!(BumpFetch, clock; go, u, v, write, write_address, write_data);
drive!(BumpNewton, clock; go, slope_u, slope_v);
drive!(BumpReflection, clock; go, slope_u, slope_v);
drive!(BumpDot, clock; go, slope_u, slope_v, across, along, light_u, light_v, light_n);

pub fn cases() -> Vec<Case> {
    vec![
        Case::named("highlight_unit", Highlight::default()),
        Case::named("spot_unit", Spot::default()),
        Case::named("skip_unit", Skip::default()),
        Case::named("bump_fetch_unit", BumpFetch::default()),
        Case::named("bump_newton_unit", BumpNewton::default()),
        Case::named("bump_reflection_unit", BumpReflection::default()),
        Case::named("bump_dot_unit", BumpDot::default()),
    ]
}
