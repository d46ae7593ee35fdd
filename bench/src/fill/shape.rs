//! The triangles of the fill comparison: right triangles with two sides of `size` pixels, side by side until they fill
//! a square frame, in several layers, each nearer than the one before. Every renderer gets these and no others.

/// Width and height of the frame.
pub const SIDE: u32 = 1040;
/// Width and height of what the triangles fill; they reach less than a pixel beyond it.
const FILLED: u32 = 1024;
/// Sizes of triangles, pixels, and how many layers of them make a frame that takes long enough to time.
pub const SIZES: [(u32, u32); 5] = [(4, 1), (16, 8), (64, 16), (256, 32), (1024, 32)];

/// A vertex on the screen: pixels, x to the right, y down; depth from 0 = far to 1 = near; colour 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// Column, a multiple of 1/256.
    pub x: f32,
    /// Row, a multiple of 1/256.
    pub y: f32,
    /// Reversed depth.
    pub depth: f32,
    /// Red, green, blue.
    pub colour: [f32; 3],
}

/// Three corners, which turn counter-clockwise as seen on the screen.
pub type Triangle = [Corner; 3];

/// How far triangle `i` of a row or column lies off the pixel grid: an odd number of 32nds in `y` (`unit` 1) and of
/// 16ths in `x` (`unit` 2). No edge then meets a pixel centre, and no rule for ties can make renderers differ.
fn off(i: u32, unit: f32) -> f32 {
    (2 * (i * 5 % 7) + 1) as f32 * unit / 32.0
}

/// All triangles of a frame, from back to front.
pub fn triangles(size: u32, layers: u32) -> Vec<Triangle> {
    let mut all = Vec::new();
    let per_side = FILLED / size;
    for layer in 0..layers {
        let depth = (layer + 1) as f32 / (layers + 1) as f32;
        for row in 0..per_side {
            for column in 0..per_side {
                let (x, y) = (
                    (column * size) as f32 + off(column + layer, 2.0),
                    (row * size) as f32 + off(row + layer, 1.0),
                );
                let s = size as f32;
                let corner = |dx: f32, dy: f32, colour| Corner {
                    x: x + dx,
                    y: y + dy,
                    depth,
                    colour,
                };
                all.push([
                    corner(0.0, 0.0, [0.9, 0.2, 0.1]),
                    corner(0.0, s, [0.1, 0.8, 0.3]),
                    corner(s, s, [0.2, 0.3, 0.7]),
                ]);
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_stay_in_the_frame_and_turn_one_way() {
        for (size, layers) in SIZES {
            let all = triangles(size, layers);
            assert_eq!(all.len() as u32, layers * (FILLED / size).pow(2));
            for [a, b, c] in all {
                let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                assert_eq!(area, -((size * size) as f32));
                for p in [a, b, c] {
                    assert!(p.x >= 0.0 && p.x <= SIDE as f32 && p.y >= 0.0 && p.y <= SIDE as f32);
                    assert!(p.depth > 0.0 && p.depth < 1.0 && (p.x * 256.0).fract() == 0.0);
                }
            }
        }
    }
}
