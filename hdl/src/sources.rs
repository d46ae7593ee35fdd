//! The text of each description, for the back end: it carries the doc comments of ports, registers and wires into the
//! Verilog, so that they are written once.

/// Source text by the description's `name` remark.
pub const SOURCES: &[(&str, &str)] = &[
    ("colour_delay", include_str!("texture/colour_delay.rs")),
    ("division", include_str!("texture/division.rs")),
    ("modulate", include_str!("texture/modulate.rs")),
    ("reciprocal", include_str!("texture/reciprocal.rs")),
    (
        "reciprocal_table",
        include_str!("texture/reciprocal_table.rs"),
    ),
    ("shift", include_str!("texture/shift.rs")),
    ("texel_blend", include_str!("texture/blend.rs")),
    ("texel_place", include_str!("texture/place.rs")),
    (
        "textured_affine_core",
        include_str!("shade/textured_affine.rs"),
    ),
    (
        "textured_perspective_core",
        include_str!("shade/textured_perspective.rs"),
    ),
    (
        "textured_quadratic_core",
        include_str!("shade/textured_quadratic.rs"),
    ),
    ("texture_unit", include_str!("texture/unit.rs")),
    ("blend", include_str!("line/blend.rs")),
    ("box_core", include_str!("line/box_filter.rs")),
    ("box_weight", include_str!("line/box_weight.rs")),
    ("bresenham_core", include_str!("line/bresenham.rs")),
    ("cone_columns", include_str!("line/cone_column.rs")),
    ("cone_core", include_str!("line/cone.rs")),
    ("cone_stages", include_str!("line/cone_stages.rs")),
    ("cone_words", include_str!("line/cone_words.rs")),
    ("angle_factor", include_str!("lit/angle.rs")),
    ("blake_core", include_str!("shade/blake.rs")),
    ("bump_cosines", include_str!("bump/cosines.rs")),
    ("bump_map", include_str!("bump/map.rs")),
    ("bump_newton_core", include_str!("shade/bump_newton.rs")),
    ("bump_newton_light", include_str!("bump/newton_light.rs")),
    ("bump_places", include_str!("bump/places.rs")),
    (
        "bump_reflection_core",
        include_str!("shade/bump_reflection.rs"),
    ),
    (
        "bump_reflection_light",
        include_str!("bump/reflection_light.rs"),
    ),
    ("bump_vectors", include_str!("bump/vectors.rs")),
    ("fragment_pair", include_str!("bump/fragment_pair.rs")),
    ("vector_delay", include_str!("bump/vector_delay.rs")),
    ("bump_banks", include_str!("bump/banks.rs")),
    ("bump_blend", include_str!("bump/blend.rs")),
    ("bump_dot", include_str!("bump/dot.rs")),
    ("bump_fetch", include_str!("bump/fetch.rs")),
    ("bump_newton", include_str!("bump/newton.rs")),
    (
        "bump_reciprocal_table",
        include_str!("bump/reciprocal_table.rs"),
    ),
    ("bump_reflection", include_str!("bump/reflection.rs")),
    ("chebyshev", include_str!("lit/chebyshev.rs")),
    ("chebyshev_core", include_str!("shade/chebyshev.rs")),
    ("compact_channel", include_str!("compact/channel.rs")),
    ("compact_clamp", include_str!("compact/clamp.rs")),
    ("compact_unit", include_str!("compact/unit.rs")),
    ("compact_walk", include_str!("compact/walk.rs")),
    ("clamp_factor", include_str!("lit/clamp.rs")),
    ("constant_1", include_str!("interpolate/constant_1.rs")),
    ("constant_2", include_str!("interpolate/constant_2.rs")),
    ("cubic_1", include_str!("interpolate/cubic_1.rs")),
    ("edge_walk", include_str!("raster/edge_walk.rs")),
    ("frame_pages", include_str!("depth/pages.rs")),
    ("gouraud_core", include_str!("shade/gouraud.rs")),
    ("lane_place", include_str!("line/place.rs")),
    ("line_cue", include_str!("line/cue.rs")),
    ("line_stream", include_str!("line/stream.rs")),
    ("load_lanes", include_str!("shade/load_lanes.rs")),
    ("line_walk", include_str!("line/walk.rs")),
    ("linear_1", include_str!("interpolate/linear_1.rs")),
    ("linear_2", include_str!("interpolate/linear_2.rs")),
    ("cosine", include_str!("shade/phong/cosine.rs")),
    ("duff_core", include_str!("shade/duff.rs")),
    ("inverse_root", include_str!("shade/phong/inverse_root.rs")),
    ("lobe_place", include_str!("shade/phong/lobe_place.rs")),
    ("root_table", include_str!("shade/phong/root_table.rs")),
    ("unit_cosines", include_str!("shade/phong/unit_cosines.rs")),
    (
        "fragment_delay",
        include_str!("shade/phong/fragment_delay.rs"),
    ),
    ("phong_colour", include_str!("shade/phong/colour.rs")),
    ("power", include_str!("shade/phong/power.rs")),
    ("power_table", include_str!("shade/phong/power_table.rs")),
    (
        "quadratic_dots_core",
        include_str!("shade/quadratic_dots.rs"),
    ),
    ("reflect", include_str!("shade/phong/reflect.rs")),
    ("highlight", include_str!("light/highlight.rs")),
    ("kappa_colour", include_str!("light/kappa_colour.rs")),
    ("skip", include_str!("light/skip.rs")),
    ("spot", include_str!("light/spot.rs")),
    ("spot_colour", include_str!("light/spot_colour.rs")),
    ("quadratic_dots_kappa_core", include_str!("shade/kappa.rs")),
    ("quadratic_dots_spot_core", include_str!("shade/spot.rs")),
    ("linear_span", include_str!("interpolate/linear_span.rs")),
    ("lit_channel", include_str!("lit/channel.rs")),
    ("lit_stream", include_str!("lit/stream.rs")),
    ("pixel_stream", include_str!("shade/pixel_stream.rs")),
    ("place_stage", include_str!("lit/place.rs")),
    ("lit_power", include_str!("lit/power.rs")),
    ("quadratic_1", include_str!("interpolate/quadratic_1.rs")),
    ("quadratic_2", include_str!("interpolate/quadratic_2.rs")),
    ("quadratic_core", include_str!("shade/quadratic.rs")),
    (
        "quadratic_engine_core",
        include_str!("shade/quadratic_engine.rs"),
    ),
    ("set_up_divider", include_str!("set_up/divider.rs")),
    ("set_up_engine", include_str!("set_up/engine.rs")),
    ("set_up_multiplier", include_str!("set_up/multiplier.rs")),
    ("set_up_program", include_str!("set_up/program_rom.rs")),
    (
        "quadratic_span",
        include_str!("interpolate/quadratic_span.rs"),
    ),
    ("raster_shell", include_str!("raster/shell.rs")),
    ("saturate", include_str!("shade/saturate.rs")),
    ("slerp_core", include_str!("shade/slerp.rs")),
    ("span_shell", include_str!("raster/span_shell.rs")),
    ("spherical_core", include_str!("shade/spherical.rs")),
    ("swing", include_str!("lit/swing.rs")),
    ("table_loader", include_str!("lit/loader.rs")),
    ("z_buffer", include_str!("depth/z_buffer.rs")),
];

/// The source text of the description called `name`.
#[must_use]
pub fn source(name: &str) -> Option<&'static str> {
    // Memories are named after their sizes.
    let of_pixels = ["frame_memory", "colour_memory", "page_memory", "texel_bank"];
    if of_pixels.iter().any(|m| name.starts_with(m)) {
        return Some(include_str!("depth/frame_memory.rs"));
    }
    if name.starts_with("word_memory") {
        return Some(include_str!("compact/word_memory.rs"));
    }
    if name.starts_with("weight_rom") {
        return Some(include_str!("line/weight_rom.rs"));
    }
    if name.starts_with("table_memory") {
        return Some(include_str!("lit/table_memory.rs"));
    }
    SOURCES
        .iter()
        .find(|(n, _)| *n == name)
        .map(|(_, text)| *text)
}

#[cfg(test)]
mod tests {
    use super::SOURCES;

    /// rust-hdl drops the guard of a `match` arm without a trace, so no description may have one.
    #[test]
    fn no_arm_has_a_guard() {
        let guarded = |line: &str| {
            let arm = line.split("//").next().and_then(|l| l.split_once("=>"));
            arm.is_some_and(|(pattern, _)| pattern.contains(" if "))
        };
        assert!(guarded("State::Idle if self.go.val() => {"));
        for (name, text) in SOURCES {
            let described = text.split("/// Integer model").next().unwrap_or_default();
            let line = described.lines().find(|l| guarded(l));
            assert_eq!(line, None, "{name}");
        }
    }
}
