//! Control points of the Utah teapot (Newell 1975), z up, as in the widely distributed set of 32 patches over 306
//! vertices, reduced by its symmetries: the pot and the lid are surfaces of revolution of a profile, handle and spout
//! are mirrored in the plane y = 0.

/// Where a quarter circle of the data has its inner control points, as a fraction of the radius.
const ARC: f64 = 0.56;
/// The same for the ring of the lid's knob, which the data gives as 0.45 to a radius of 0.8.
const ARC_KNOB: f64 = 0.45 / 0.8;

/// A ring of a profile: radius, height, arc fraction.
pub type Ring = (f64, f64, f64);

/// Profiles from their inner or upper end, the outside on the left of the direction of travel (radius right, z up):
/// rim, upper body, lower body, bottom; lid knob, lid.
pub const PROFILES: [[Ring; 4]; 6] = [
    [
        (1.4, 2.4, ARC),
        (1.3375, 2.53125, ARC),
        (1.4375, 2.53125, ARC),
        (1.5, 2.4, ARC),
    ],
    [
        (1.5, 2.4, ARC),
        (1.75, 1.875, ARC),
        (2.0, 1.35, ARC),
        (2.0, 0.9, ARC),
    ],
    [
        (2.0, 0.9, ARC),
        (2.0, 0.45, ARC),
        (1.5, 0.225, ARC),
        (1.5, 0.15, ARC),
    ],
    [
        (1.5, 0.15, ARC),
        (1.5, 0.075, ARC),
        (1.425, 0.0, ARC),
        (0.0, 0.0, ARC),
    ],
    [
        (0.0, 3.15, ARC),
        (0.8, 3.15, ARC_KNOB),
        (0.0, 2.85, ARC),
        (0.2, 2.7, ARC),
    ],
    [
        (0.2, 2.7, ARC),
        (0.4, 2.55, ARC),
        (1.3, 2.55, ARC),
        (1.3, 2.4, ARC),
    ],
];

/// Rows of a tube along its length: first edge (x, z), last edge (x, z), half width in y. The half tube runs from the
/// first edge over −y to the last.
pub type TubeRow = (f64, f64, f64, f64, f64);

/// Upper handle, lower handle, lower spout, upper spout.
pub const TUBES: [[TubeRow; 4]; 4] = [
    [
        (-1.6, 2.025, -1.5, 2.25, 0.3),
        (-2.3, 2.025, -2.5, 2.25, 0.3),
        (-2.7, 2.025, -3.0, 2.25, 0.3),
        (-2.7, 1.8, -3.0, 1.8, 0.3),
    ],
    [
        (-2.7, 1.8, -3.0, 1.8, 0.3),
        (-2.7, 1.575, -3.0, 1.35, 0.3),
        (-2.5, 1.125, -2.65, 0.9375, 0.3),
        (-2.0, 0.9, -1.9, 0.6, 0.3),
    ],
    [
        (1.7, 1.425, 1.7, 0.6, 0.66),
        (2.6, 1.425, 3.1, 0.825, 0.66),
        (2.3, 2.1, 2.4, 2.025, 0.25),
        (2.7, 2.4, 3.3, 2.4, 0.25),
    ],
    [
        (2.7, 2.4, 3.3, 2.4, 0.25),
        (2.8, 2.475, 3.525, 2.49375, 0.25),
        (2.9, 2.475, 3.45, 2.5125, 0.15),
        (2.8, 2.4, 3.2, 2.4, 0.15),
    ],
];
