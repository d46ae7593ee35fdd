//! The arithmetic error of every pixel that a line core hands over: against the renderer's f64 weight and colour, blended
//! over what the core itself had at that place before, so that earlier errors play no part.

use super::frames::FragmentError;
use super::Prelude;
use shadegate_reference::line::blend::blend;
use shadegate_reference::line::wireframe::table;
use std::collections::HashMap;

/// Compares every pixel with the f64 oracle. A pixel that the renderer does not draw counts as one of weight 0.
pub fn fragment_error(p: &Prelude) -> FragmentError {
    let (width, height) = (p.prepared.width as usize, p.prepared.height as usize);
    let mut frame = vec![p.prepared.background; width * height];
    let table = table();
    let mut out = FragmentError::default();
    let mut sum = 0.0;
    // The pixels of the line at hand: level and colour.
    let mut line: Option<usize> = None;
    let mut drawn = HashMap::new();
    for pixel in &p.trace.pixels {
        if line != Some(pixel.triangle) {
            line = Some(pixel.triangle);
            drawn.clear();
            let s = &p.lines[pixel.triangle].stroke;
            s.pixels(p.prepared.wires.filter, &table, |x, at, level| {
                drawn.insert((at.x, at.y), (level, s.colour_at(x)));
            });
        }
        let place = (i32::from(pixel.x), i32::from(pixel.y));
        let (level, colour) = drawn.get(&place).copied().unwrap_or((0, [0; 3]));
        let at = &mut frame[usize::from(pixel.y) * width + usize::from(pixel.x)];
        let want = blend(*at, colour, level, table.full());
        *at = pixel.rgb;
        for (want, got) in want.into_iter().zip(pixel.rgb) {
            let d = want.abs_diff(got);
            out.max_lsb = out.max_lsb.max(d);
            sum += f64::from(d).powi(2);
        }
    }
    let n = p.trace.pixels.len() * 3;
    out.rms_lsb = if n == 0 { 0.0 } else { (sum / n as f64).sqrt() };
    out
}
