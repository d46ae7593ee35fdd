//! The text of each description, for the back end: it carries the doc comments of ports, registers and wires into the
//! Verilog, so that they are written once.

/// Source text by the description's `name` remark.
pub const SOURCES: &[(&str, &str)] = &[
    ("constant_1", include_str!("interpolate/constant_1.rs")),
    ("constant_2", include_str!("interpolate/constant_2.rs")),
    ("edge_walk", include_str!("raster/edge_walk.rs")),
    ("gouraud_core", include_str!("shade/gouraud.rs")),
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
    ("pixel_stream", include_str!("shade/pixel_stream.rs")),
    ("quadratic_1", include_str!("interpolate/quadratic_1.rs")),
    ("quadratic_2", include_str!("interpolate/quadratic_2.rs")),
    ("quadratic_core", include_str!("shade/quadratic.rs")),
    ("raster_shell", include_str!("raster/shell.rs")),
    ("saturate", include_str!("shade/saturate.rs")),
    ("z_buffer", include_str!("depth/z_buffer.rs")),
];

/// The source text of the description called `name`.
#[must_use]
pub fn source(name: &str) -> Option<&'static str> {
    // A frame memory is named after its size.
    if name.starts_with("frame_memory") {
        return Some(include_str!("depth/frame_memory.rs"));
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
