//! From an address to the four banks: which texel of each, and the weights of the odd column and the odd row.
//!
//! A place lies between columns i = floor(u) and i + 1, modulo the width. Of two neighbours one is even, one odd: the odd
//! one is always number floor(i/2) of the odd columns, the even one number floor(i/2) of the even ones, or the next if i
//! is odd. The odd column weighs f = u − i, or 1 − f if it is the first of the two; so texels need not be swapped.
//! With f = 0 that is the nearest texel, covering u. Rows likewise. In a bank the texel is at
//! base + row·2^shift + column, columns and rows counted in pairs.
//!
//! The words of the texture are not double-buffered: the host writes them behind a fence.

use crate::format::{bit_cast_u, signed_cast_bits, Q, U};
use crate::simulate::{Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the address to the places in the banks; the weights come one later, with the texels.
pub const STAGES: usize = 2;

/// Latency: two clocks, and three to the weights.
#[derive(LogicBlock)]
pub struct TexelPlace {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Writes where the picture begins, whether the stages move or not.
    pub write_place: Signal<In, Bit>,
    /// Writes the sides of the picture, likewise.
    pub write_size: Signal<In, Bit>,
    /// Register bus.
    pub data: Signal<In, U<32>>,
    /// u, in units of 2^-12 texel.
    pub u: Signal<In, Q<21, 0>>,
    /// v likewise.
    pub v: Signal<In, Q<21, 0>>,
    /// Place in the bank of even columns and even rows.
    pub even_even: Signal<Out, U<14>>,
    /// Place in the bank of odd columns and even rows.
    pub odd_even: Signal<Out, U<14>>,
    /// Place in the bank of even columns and odd rows.
    pub even_odd: Signal<Out, U<14>>,
    /// Place in the bank of odd columns and odd rows.
    pub odd_odd: Signal<Out, U<14>>,
    /// Weight of the odd column.
    pub column_weight: Signal<Out, Q<1, 12>>,
    /// Weight of the odd row.
    pub row_weight: Signal<Out, Q<1, 12>>,
    /// Place of the picture in every bank.
    base: Register<U<14>>,
    /// The nearest texel is wanted.
    nearest: Register<Bit>,
    /// Pairs of columns less one.
    column_mask: Register<U<9>>,
    /// Pairs of rows less one.
    row_mask: Register<U<9>>,
    /// Pairs of columns are 2 to this.
    shift: Register<U<4>>,
    /// Number of the even column.
    even_column_1: Register<U<9>>,
    /// Number of the odd column.
    odd_column_1: Register<U<9>>,
    /// Number of the even row.
    even_row_1: Register<U<9>>,
    /// Number of the odd row.
    odd_row_1: Register<U<9>>,
    /// Weight of the odd column.
    column_weight_1: Register<U<13>>,
    /// Weight of the odd row.
    row_weight_1: Register<U<13>>,
    /// Place in the bank of even columns and even rows.
    even_even_2: Register<U<14>>,
    /// Place in the bank of odd columns and even rows.
    odd_even_2: Register<U<14>>,
    /// Place in the bank of even columns and odd rows.
    even_odd_2: Register<U<14>>,
    /// Place in the bank of odd columns and odd rows.
    odd_odd_2: Register<U<14>>,
    /// Weight of the odd column.
    column_weight_2: Register<U<13>>,
    /// Weight of the odd row.
    row_weight_2: Register<U<13>>,
    /// Weight of the odd column.
    column_weight_3: Register<U<13>>,
    /// Weight of the odd row.
    row_weight_3: Register<U<13>>,
    /// Pair of the first column.
    column_pair: Wire<U<9>>,
    /// Pair of the first row.
    row_pair: Wire<U<9>>,
    /// The first column is odd.
    column_odd: Wire<U<1>>,
    /// The first row is odd.
    row_odd: Wire<U<1>>,
    /// Pair of the even column.
    even_column: Wire<U<9>>,
    /// Pair of the even row.
    even_row: Wire<U<9>>,
    /// How far the place is from the first column.
    column_part: Wire<U<13>>,
    /// How far it is from the first row.
    row_part: Wire<U<13>>,
    /// Begin of the even row in a bank.
    even_line: Wire<U<14>>,
    /// Begin of the odd row in a bank.
    odd_line: Wire<U<14>>,
    /// Even column, wider.
    even_wide: Wire<U<14>>,
    /// Odd column, wider.
    odd_wide: Wire<U<14>>,
    /// Weight of the odd column with a sign.
    column_bits: Wire<U<14>>,
    /// Weight of the odd row with a sign.
    row_bits: Wire<U<14>>,
    /// No distance.
    nothing: Constant<U<13>>,
    /// A whole texel.
    whole: Constant<U<13>>,
}

impl Default for TexelPlace {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            write_place: Default::default(),
            write_size: Default::default(),
            data: Default::default(),
            u: Default::default(),
            v: Default::default(),
            even_even: Default::default(),
            odd_even: Default::default(),
            even_odd: Default::default(),
            odd_odd: Default::default(),
            column_weight: Default::default(),
            row_weight: Default::default(),
            base: Default::default(),
            nearest: Default::default(),
            column_mask: Default::default(),
            row_mask: Default::default(),
            shift: Default::default(),
            even_column_1: Default::default(),
            odd_column_1: Default::default(),
            even_row_1: Default::default(),
            odd_row_1: Default::default(),
            column_weight_1: Default::default(),
            row_weight_1: Default::default(),
            even_even_2: Default::default(),
            odd_even_2: Default::default(),
            even_odd_2: Default::default(),
            odd_odd_2: Default::default(),
            column_weight_2: Default::default(),
            row_weight_2: Default::default(),
            column_weight_3: Default::default(),
            row_weight_3: Default::default(),
            column_pair: Default::default(),
            row_pair: Default::default(),
            column_odd: Default::default(),
            row_odd: Default::default(),
            even_column: Default::default(),
            even_row: Default::default(),
            column_part: Default::default(),
            row_part: Default::default(),
            even_line: Default::default(),
            odd_line: Default::default(),
            even_wide: Default::default(),
            odd_wide: Default::default(),
            column_bits: Default::default(),
            row_bits: Default::default(),
            nothing: Constant::new(U::new(0)),
            whole: Constant::new(U::new(1 << 12)),
        }
    }
}

impl Logic for TexelPlace {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name texel_place");
        comment!("title Places of four neighbouring texels in four banks, and their weights.");
        comment!("equation place = base + row 2^shift + column, in pairs; odd weight = odd first ? 1 - f : f");
        comment!("source Zed3D 1996, bilinear; four banks by the parities of column and row.");
        comment!("latency Two clocks to the places, three to the weights.");
        dff_setup!(
            self,
            clock,
            base,
            nearest,
            column_mask,
            row_mask,
            shift,
            even_column_1,
            odd_column_1,
            even_row_1,
            odd_row_1,
            column_weight_1,
            row_weight_1,
            even_even_2,
            odd_even_2,
            even_odd_2,
            odd_odd_2,
            column_weight_2,
            row_weight_2,
            column_weight_3,
            row_weight_3
        );
        if self.write_place.val() {
            self.base.d.next = self.data.val().get_bits::<14>(0);
            self.nearest.d.next = self.data.val().get_bit(14);
        }
        if self.write_size.val() {
            self.column_mask.d.next = self.data.val().get_bits::<9>(0);
            self.row_mask.d.next = self.data.val().get_bits::<9>(9);
            self.shift.d.next = self.data.val().get_bits::<4>(18);
        }

        self.column_pair.next = self.u.val().get_bits::<9>(13);
        self.row_pair.next = self.v.val().get_bits::<9>(13);
        self.column_odd.next = self.u.val().get_bits::<1>(12);
        self.row_odd.next = self.v.val().get_bits::<1>(12);
        self.even_column.next = self.column_pair.val() + bit_cast_u::<9, 1>(self.column_odd.val());
        self.even_row.next = self.row_pair.val() + bit_cast_u::<9, 1>(self.row_odd.val());
        self.column_part.next = bit_cast_u::<13, 12>(self.u.val().get_bits::<12>(0));
        self.row_part.next = bit_cast_u::<13, 12>(self.v.val().get_bits::<12>(0));
        if self.nearest.q.val() {
            self.column_part.next = self.nothing.val();
            self.row_part.next = self.nothing.val();
        }

        self.even_line.next = self.base.q.val()
            + (bit_cast_u::<14, 9>(self.even_row_1.q.val()) << self.shift.q.val());
        self.odd_line.next =
            self.base.q.val() + (bit_cast_u::<14, 9>(self.odd_row_1.q.val()) << self.shift.q.val());
        self.even_wide.next = bit_cast_u::<14, 9>(self.even_column_1.q.val());
        self.odd_wide.next = bit_cast_u::<14, 9>(self.odd_column_1.q.val());

        if self.go.val() {
            self.even_column_1.d.next = self.even_column.val() & self.column_mask.q.val();
            self.odd_column_1.d.next = self.column_pair.val() & self.column_mask.q.val();
            self.even_row_1.d.next = self.even_row.val() & self.row_mask.q.val();
            self.odd_row_1.d.next = self.row_pair.val() & self.row_mask.q.val();
            self.column_weight_1.d.next = self.column_part.val();
            self.row_weight_1.d.next = self.row_part.val();
            if self.column_odd.val().any() {
                self.column_weight_1.d.next = self.whole.val() - self.column_part.val();
            }
            if self.row_odd.val().any() {
                self.row_weight_1.d.next = self.whole.val() - self.row_part.val();
            }
            self.even_even_2.d.next = self.even_line.val() + self.even_wide.val();
            self.odd_even_2.d.next = self.even_line.val() + self.odd_wide.val();
            self.even_odd_2.d.next = self.odd_line.val() + self.even_wide.val();
            self.odd_odd_2.d.next = self.odd_line.val() + self.odd_wide.val();
            self.column_weight_2.d.next = self.column_weight_1.q.val();
            self.row_weight_2.d.next = self.row_weight_1.q.val();
            self.column_weight_3.d.next = self.column_weight_2.q.val();
            self.row_weight_3.d.next = self.row_weight_2.q.val();
        }
        self.even_even.next = self.even_even_2.q.val();
        self.odd_even.next = self.odd_even_2.q.val();
        self.even_odd.next = self.even_odd_2.q.val();
        self.odd_odd.next = self.odd_odd_2.q.val();
        self.column_bits.next = bit_cast_u::<14, 13>(self.column_weight_3.q.val());
        self.row_bits.next = bit_cast_u::<14, 13>(self.row_weight_3.q.val());
        self.column_weight.next = signed_cast_bits::<1, 12, 14>(self.column_bits.val());
        self.row_weight.next = signed_cast_bits::<1, 12, 14>(self.row_bits.val());
    }
}

crate::clocked!(TexelPlace;
    inputs go, write_place, write_size, data, u, v;
    outputs even_even, odd_even, even_odd, odd_odd, column_weight, row_weight);
