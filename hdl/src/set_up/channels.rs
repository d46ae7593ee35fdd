//! The channels' part of the program: from knots to the words of a quadric, and of the plane of depths.
//!
//! Formats: knots and coefficients have 10 fraction bits (depths 6: they count as sixteenths), `ratio` and `fall` 23,
//! `inverse` 43, `square` 47; slopes per n have 52 and words 36.

use super::instruction::{Constant, Exponent, Function};
use super::program::{Writer, SLOT_COLOUR, SLOT_DEPTH, Y};
use super::schedule::{Value, X};

/// What all channels of a triangle share.
pub(super) struct Lattice {
    /// H, the height of the major edge, sub-pixels.
    pub height: Value,
    /// Its error step.
    pub up: Value,
    /// Step of n to the next pixel: 256·H.
    pub height_pixels: Value,
    /// Step of n to the next span start, backwards: 256·up.
    pub up_pixels: Value,
    /// n of the first span start.
    pub start: Value,
    /// The same over 256.
    pub start_whole: Value,
    /// What that leaves.
    pub start_rest: Value,
    /// ρ, height of the upper part over H.
    pub ratio: Value,
    /// τ of the first row.
    pub fall: Value,
    /// 1/H.
    pub inverse: Value,
    /// σ².
    pub square: Value,
    /// Mantissa of 1/area.
    pub scale: Value,
}

/// Sum of y at a place and half a unit, the sum of the two words of n0·slope, cut and sent.
fn value(w: &mut Writer, l: &Lattice, slope: Value, base: Value, select: u8, depth: bool) {
    let p = w.multiply(l.start_whole, Y::Of(slope), 4, 24, Exponent::None);
    let part = w.sum(p, Y::Of(base));
    let p = w.multiply(l.start_rest, Y::Of(slope), 4, 32, Exponent::None);
    w.word(p, Y::Of(part), Function::Sum, select, depth);
}

/// The ten words of a colour channel, 0 red, 1 green, 2 blue.
pub(super) fn colour(w: &mut Writer, l: &Lattice, channel: u8) {
    let (vertex, middle) = (SLOT_COLOUR + 8 * channel, SLOT_COLOUR + 8 * channel + 4);
    let select = |word: u8| 16 << channel | word;
    let none = Exponent::None;
    let half = Y::Is(Constant::HalfUnit);
    // Coefficients over the weights of the middle and the bottom vertex: a/2, b/2, c/4, d, e.
    let top = w.sum(X::Zero, Y::Sorted(vertex));
    let sum = w.sum(X::Of(top), Y::Sorted(vertex + 1));
    let a = w.difference(X::Of(sum), Y::SortedDouble(middle + 2));
    let sum = w.sum(X::Of(top), Y::Sorted(vertex + 2));
    let b = w.difference(X::Of(sum), Y::SortedDouble(middle + 1));
    let sum = w.sum(X::Of(top), Y::Sorted(middle));
    let sum = w.difference(X::Of(sum), Y::Sorted(middle + 2));
    let c = w.difference(X::Of(sum), Y::Sorted(middle + 1));
    let rise = w.reversed(X::Of(top), Y::Sorted(vertex + 1));
    let d = w.difference(X::Of(rise), Y::Double(a));
    let rise = w.reversed(X::Of(top), Y::Sorted(vertex + 2));
    let e = w.difference(X::Of(rise), Y::Double(b));
    // Over λ and τ: A/2, −C/4, D.
    let p = w.multiply(l.ratio, Y::Of(b), 2, 71, none);
    let bent = w.difference(p, Y::Double(c));
    let cross = w.sum(X::Of(bent), Y::Of(c));
    let p = w.multiply(l.ratio, Y::Of(bent), 2, 71, none);
    let square = w.sum(p, Y::Of(a));
    let p = w.multiply(l.ratio, Y::Of(e), 2, 71, none);
    let across = w.reversed(p, Y::Of(d));
    // At the first row: slope along λ, slope along τ, value.
    let p = w.multiply(l.fall, Y::Of(cross), 2, 69, none);
    let across = w.reversed(p, Y::Of(across));
    let p = w.multiply(l.fall, Y::Of(b), 2, 70, none);
    let chord = w.sum(p, Y::Of(e));
    let along = w.reversed(X::Of(e), Y::Double(chord));
    let p = w.multiply(l.fall, Y::Of(chord), 2, 45, none);
    let base = w.sum(p, Y::SortedHigh(vertex));
    let base = w.sum(X::Of(base), Y::Is(Constant::Offset));
    // Per row.
    let down = w.product(along, Y::Of(l.inverse), 3, 41, none);
    let down_square = w.product(b, Y::Of(l.square), 3, 52, none);
    // Per n, and per n and row.
    let bend = w.product(l.scale, Y::Of(square), 2, 71, none);
    let bend = w.product(l.scale, Y::Of(bend), 2, 72, none);
    let slope = w.product(l.scale, Y::Of(across), 2, 29, Exponent::Once);
    let twist = w.product(l.scale, Y::Of(cross), 2, 70, none);
    let twist = w.product(twist, Y::Of(l.inverse), 3, 24, Exponent::Once);
    // The quadric's part of the slopes: at the start, and what a pixel and a line add.
    let at_start = w.product(bend, Y::Of(l.start), 2, 4, Exponent::Twice);
    let per_pixel = w.product(bend, Y::Of(l.height_pixels), 2, 4, Exponent::Twice);
    let per_line = w.product(bend, Y::Of(l.up_pixels), 2, 4, Exponent::Twice);
    let chord = w.sum(X::Of(slope), Y::Of(at_start));
    let tangent = w.sum(X::Of(chord), Y::Of(at_start));
    let pixel = w.sum(X::Of(tangent), Y::Of(per_pixel));
    let line = w.difference(X::Of(tangent), Y::Of(per_line));
    let line = w.difference(X::Of(line), Y::Of(twist));
    let mixed = w.sum(X::Of(twist), Y::Double(per_line));
    let lines = w.sum(X::Of(per_line), Y::Of(twist));
    // Words.
    value(w, l, chord, base, select(0), false);
    let p = w.multiply(l.height, Y::Of(pixel), 4, 24, none);
    let d_pixel = w.word(p, half, Function::Sum, select(1), false);
    let rest = w.sum(X::Of(down), Y::Of(down_square));
    let rest = w.sum(X::Of(rest), half);
    let p = w.multiply(l.up, Y::Of(line), 4, 24, none);
    let rest = w.reversed(p, Y::Of(rest));
    let p = w.multiply(l.start_whole, Y::Of(twist), 4, 24, none);
    let rest = w.reversed(p, Y::Of(rest));
    let p = w.multiply(l.start_rest, Y::Of(twist), 4, 32, none);
    let d_line = w.word(p, Y::Of(rest), Function::Reversed, select(2), false);
    let p = w.multiply(l.height, Y::Double(per_pixel), 4, 24, none);
    let dd_pixel = w.word(p, half, Function::Sum, select(4), false);
    let p = w.multiply(l.height, Y::Of(mixed), 4, 24, none);
    let dd_mixed = w.word(p, half, Function::Reversed, select(5), false);
    let rest = w.sum(X::Of(down_square), Y::Of(down_square));
    let rest = w.sum(X::Of(rest), half);
    let p = w.multiply(l.up, Y::Double(lines), 4, 24, none);
    let dd_line = w.word(p, Y::Of(rest), Function::Sum, select(7), false);
    // The carrying step is line plus pixel; sums of words keep all paths on one quadric.
    let sum = w.sum(X::Of(d_line), Y::Of(d_pixel));
    let add = |x: Value, y: Value, word: u8, w: &mut Writer| {
        w.word(X::Of(x), Y::Of(y), Function::Sum, select(word), false)
    };
    add(sum, dd_mixed, 3, w);
    let dd_pixel_carry = add(dd_mixed, dd_pixel, 6, w);
    let dd_line_carry = add(dd_line, dd_mixed, 8, w);
    add(dd_line_carry, dd_pixel_carry, 9, w);
}

/// The four words of depth.
pub(super) fn depth(w: &mut Writer, l: &Lattice) {
    let none = Exponent::None;
    let half = Y::Is(Constant::HalfUnitDepth);
    let top = w.sum(X::Zero, Y::Sorted(SLOT_DEPTH));
    let d = w.reversed(X::Of(top), Y::Sorted(SLOT_DEPTH + 1));
    let e = w.reversed(X::Of(top), Y::Sorted(SLOT_DEPTH + 2));
    let p = w.multiply(l.ratio, Y::Of(e), 2, 71, none);
    let across = w.reversed(p, Y::Of(d));
    let p = w.multiply(l.fall, Y::Of(e), 2, 45, none);
    let base = w.sum(p, Y::SortedHigh(SLOT_DEPTH));
    let base = w.sum(X::Of(base), Y::Is(Constant::OffsetDepth));
    let p = w.multiply(e, Y::Of(l.inverse), 3, 41, none);
    let down = w.sum(p, half);
    let slope = w.product(l.scale, Y::Of(across), 2, 29, Exponent::Once);
    value(w, l, slope, base, 0x80, true);
    let p = w.multiply(l.height, Y::Of(slope), 4, 24, none);
    let d_pixel = w.word(p, half, Function::Sum, 0x81, true);
    let p = w.multiply(l.up, Y::Of(slope), 4, 24, none);
    let d_line = w.word(p, Y::Of(down), Function::Reversed, 0x82, true);
    w.word(X::Of(d_line), Y::Of(d_pixel), Function::Sum, 0x83, true);
}
