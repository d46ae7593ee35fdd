//! The samples of a map in four banks of block RAM, by the parity of column and row.
//!
//! The four samples around a place are two columns and two rows next to each other, one of them even and one odd: each
//! bank gives one of them per clock, and no sample is stored twice. 64 by 64 samples of 36 bits are four memories of
//! 1024 words. Places are residues, so the map repeats without any logic. The left column of an odd pair is column u, in
//! the odd bank; its right neighbour is the even column after it, that of the next pair.

use crate::format::{bit_cast_u, U};
use crate::lit::table_memory::TableMemory;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// Clocks from the place to the samples.
pub const STAGES: usize = 2;

/// Latency: two clocks.
#[derive(LogicBlock)]
pub struct BumpBanks {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// The stages move; everything holds otherwise.
    pub go: Signal<In, Bit>,
    /// Column of the map, 12 fraction bits; the map repeats.
    pub u: Signal<In, U<18>>,
    /// Row, likewise.
    pub v: Signal<In, U<18>>,
    /// Writes a sample, whether the stages move or not.
    pub write: Signal<In, Bit>,
    /// Sample to write: row in bits 11 to 6, column in bits 5 to 0.
    pub write_address: Signal<In, U<12>>,
    /// The sample.
    pub write_data: Signal<In, U<36>>,
    /// Upper row, left column.
    pub upper_left: Signal<Out, U<36>>,
    /// Upper row, right column.
    pub upper_right: Signal<Out, U<36>>,
    /// Lower row, left column.
    pub lower_left: Signal<Out, U<36>>,
    /// Lower row, right column.
    pub lower_right: Signal<Out, U<36>>,
    /// Place between the columns, two clocks ago.
    pub part_u: Signal<Out, U<12>>,
    /// Place between the rows.
    pub part_v: Signal<Out, U<12>>,
    /// Address of the sample in an even row and column.
    address_00_1: Register<U<10>>,
    /// Address of the sample in an even row, odd column.
    address_01_1: Register<U<10>>,
    /// Address of the sample in an odd row, even column.
    address_10_1: Register<U<10>>,
    /// Address of the sample in an odd row and column.
    address_11_1: Register<U<10>>,
    /// The left column is odd.
    odd_u_1: Register<Bit>,
    /// The upper row is odd.
    odd_v_1: Register<Bit>,
    /// Place between the columns.
    part_u_1: Register<U<12>>,
    /// Place between the rows.
    part_v_1: Register<U<12>>,
    /// The left column is odd.
    odd_u_2: Register<Bit>,
    /// The upper row is odd.
    odd_v_2: Register<Bit>,
    /// Place between the columns.
    part_u_2: Register<U<12>>,
    /// Place between the rows.
    part_v_2: Register<U<12>>,
    /// Column on the left.
    column: Wire<U<6>>,
    /// Half of it: that of the odd column.
    odd_column: Wire<U<5>>,
    /// That of the even column.
    even_column: Wire<U<5>>,
    /// The left column is odd.
    is_odd_u: Wire<Bit>,
    /// Upper row.
    row: Wire<U<6>>,
    /// Half of it: that of the odd row.
    odd_row: Wire<U<5>>,
    /// That of the even row.
    even_row: Wire<U<5>>,
    /// The upper row is odd.
    is_odd_v: Wire<Bit>,
    /// Row part of an address in even rows.
    even_base: Wire<U<10>>,
    /// Row part of an address in odd rows.
    odd_base: Wire<U<10>>,
    /// Column part of an address in even columns.
    even_offset: Wire<U<10>>,
    /// Column part of an address in odd columns.
    odd_offset: Wire<U<10>>,
    /// Half of the column to write.
    write_column: Wire<U<5>>,
    /// Half of the row to write.
    write_row: Wire<U<5>>,
    /// Row part of the address to write.
    write_base: Wire<U<10>>,
    /// Column part of the address to write.
    write_offset: Wire<U<10>>,
    /// Address to write, within its bank.
    write_place: Wire<U<10>>,
    /// An odd row is written.
    write_odd_v: Wire<Bit>,
    /// An odd column is written.
    write_odd_u: Wire<Bit>,
    /// Even row, left column.
    even_left: Wire<U<36>>,
    /// Even row, right column.
    even_right: Wire<U<36>>,
    /// Odd row, left column.
    odd_left: Wire<U<36>>,
    /// Odd row, right column.
    odd_right: Wire<U<36>>,
    /// Samples in even rows and columns.
    bank_00: Quiet<TableMemory<10, 36>>,
    /// Samples in even rows, odd columns.
    bank_01: Quiet<TableMemory<10, 36>>,
    /// Samples in odd rows, even columns.
    bank_10: Quiet<TableMemory<10, 36>>,
    /// Samples in odd rows and columns.
    bank_11: Quiet<TableMemory<10, 36>>,
    /// One column or row.
    one: Constant<U<5>>,
}

impl Default for BumpBanks {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            go: Default::default(),
            u: Default::default(),
            v: Default::default(),
            write: Default::default(),
            write_address: Default::default(),
            write_data: Default::default(),
            upper_left: Default::default(),
            upper_right: Default::default(),
            lower_left: Default::default(),
            lower_right: Default::default(),
            part_u: Default::default(),
            part_v: Default::default(),
            address_00_1: Default::default(),
            address_01_1: Default::default(),
            address_10_1: Default::default(),
            address_11_1: Default::default(),
            odd_u_1: Default::default(),
            odd_v_1: Default::default(),
            part_u_1: Default::default(),
            part_v_1: Default::default(),
            odd_u_2: Default::default(),
            odd_v_2: Default::default(),
            part_u_2: Default::default(),
            part_v_2: Default::default(),
            column: Default::default(),
            odd_column: Default::default(),
            even_column: Default::default(),
            is_odd_u: Default::default(),
            row: Default::default(),
            odd_row: Default::default(),
            even_row: Default::default(),
            is_odd_v: Default::default(),
            even_base: Default::default(),
            odd_base: Default::default(),
            even_offset: Default::default(),
            odd_offset: Default::default(),
            write_column: Default::default(),
            write_row: Default::default(),
            write_base: Default::default(),
            write_offset: Default::default(),
            write_place: Default::default(),
            write_odd_v: Default::default(),
            write_odd_u: Default::default(),
            even_left: Default::default(),
            even_right: Default::default(),
            odd_left: Default::default(),
            odd_right: Default::default(),
            bank_00: Default::default(),
            bank_01: Default::default(),
            bank_10: Default::default(),
            bank_11: Default::default(),
            one: Constant::new(U::new(1)),
        }
    }
}

impl Logic for BumpBanks {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name bump_banks");
        comment!("title Four samples around a place of a map of 64 by 64, from four banks.");
        comment!("equation bank (v mod 2, u mod 2), address 32 (v div 2) + u div 2");
        comment!(
            "source One sample per bank and clock: two neighbours are never both even or both odd."
        );
        comment!("latency Two clocks from place to samples; four samples per clock.");
        dff_setup!(
            self,
            clock,
            address_00_1,
            address_01_1,
            address_10_1,
            address_11_1,
            odd_u_1,
            odd_v_1,
            part_u_1,
            part_v_1,
            odd_u_2,
            odd_v_2,
            part_u_2,
            part_v_2
        );
        // Where the samples are.
        self.column.next = self.u.val().get_bits::<6>(12);
        self.is_odd_u.next = self.column.val().get_bit(0);
        self.odd_column.next = self.column.val().get_bits::<5>(1);
        self.even_column.next = self.odd_column.val();
        if self.is_odd_u.val() {
            self.even_column.next = self.odd_column.val() + self.one.val();
        }
        self.row.next = self.v.val().get_bits::<6>(12);
        self.is_odd_v.next = self.row.val().get_bit(0);
        self.odd_row.next = self.row.val().get_bits::<5>(1);
        self.even_row.next = self.odd_row.val();
        if self.is_odd_v.val() {
            self.even_row.next = self.odd_row.val() + self.one.val();
        }
        self.even_base.next = bit_cast_u::<10, 5>(self.even_row.val()) << 5u64;
        self.odd_base.next = bit_cast_u::<10, 5>(self.odd_row.val()) << 5u64;
        self.even_offset.next = bit_cast_u::<10, 5>(self.even_column.val());
        self.odd_offset.next = bit_cast_u::<10, 5>(self.odd_column.val());
        // Where one is written.
        self.write_odd_u.next = self.write_address.val().get_bit(0);
        self.write_odd_v.next = self.write_address.val().get_bit(6);
        self.write_column.next = self.write_address.val().get_bits::<5>(1);
        self.write_row.next = self.write_address.val().get_bits::<5>(7);
        self.write_base.next = bit_cast_u::<10, 5>(self.write_row.val()) << 5u64;
        self.write_offset.next = bit_cast_u::<10, 5>(self.write_column.val());
        self.write_place.next = self.write_base.val() | self.write_offset.val();

        self.bank_00.clock.next = self.clock.val();
        self.bank_00.read.next = self.go.val();
        self.bank_00.read_address.next = self.address_00_1.q.val();
        self.bank_00.write.next =
            self.write.val() && !self.write_odd_v.val() && !self.write_odd_u.val();
        self.bank_00.write_address.next = self.write_place.val();
        self.bank_00.write_data.next = self.write_data.val();

        self.bank_01.clock.next = self.clock.val();
        self.bank_01.read.next = self.go.val();
        self.bank_01.read_address.next = self.address_01_1.q.val();
        self.bank_01.write.next =
            self.write.val() && !self.write_odd_v.val() && self.write_odd_u.val();
        self.bank_01.write_address.next = self.write_place.val();
        self.bank_01.write_data.next = self.write_data.val();

        self.bank_10.clock.next = self.clock.val();
        self.bank_10.read.next = self.go.val();
        self.bank_10.read_address.next = self.address_10_1.q.val();
        self.bank_10.write.next =
            self.write.val() && self.write_odd_v.val() && !self.write_odd_u.val();
        self.bank_10.write_address.next = self.write_place.val();
        self.bank_10.write_data.next = self.write_data.val();

        self.bank_11.clock.next = self.clock.val();
        self.bank_11.read.next = self.go.val();
        self.bank_11.read_address.next = self.address_11_1.q.val();
        self.bank_11.write.next =
            self.write.val() && self.write_odd_v.val() && self.write_odd_u.val();
        self.bank_11.write_address.next = self.write_place.val();
        self.bank_11.write_data.next = self.write_data.val();

        // Left and right, then upper and lower.
        self.even_left.next = self.bank_00.read_data.val();
        self.even_right.next = self.bank_01.read_data.val();
        self.odd_left.next = self.bank_10.read_data.val();
        self.odd_right.next = self.bank_11.read_data.val();
        if self.odd_u_2.q.val() {
            self.even_left.next = self.bank_01.read_data.val();
            self.even_right.next = self.bank_00.read_data.val();
            self.odd_left.next = self.bank_11.read_data.val();
            self.odd_right.next = self.bank_10.read_data.val();
        }
        self.upper_left.next = self.even_left.val();
        self.upper_right.next = self.even_right.val();
        self.lower_left.next = self.odd_left.val();
        self.lower_right.next = self.odd_right.val();
        if self.odd_v_2.q.val() {
            self.upper_left.next = self.odd_left.val();
            self.upper_right.next = self.odd_right.val();
            self.lower_left.next = self.even_left.val();
            self.lower_right.next = self.even_right.val();
        }
        if self.go.val() {
            self.address_00_1.d.next = self.even_base.val() | self.even_offset.val();
            self.address_01_1.d.next = self.even_base.val() | self.odd_offset.val();
            self.address_10_1.d.next = self.odd_base.val() | self.even_offset.val();
            self.address_11_1.d.next = self.odd_base.val() | self.odd_offset.val();
            self.odd_u_1.d.next = self.is_odd_u.val();
            self.odd_v_1.d.next = self.is_odd_v.val();
            self.part_u_1.d.next = self.u.val().get_bits::<12>(0);
            self.part_v_1.d.next = self.v.val().get_bits::<12>(0);
            self.odd_u_2.d.next = self.odd_u_1.q.val();
            self.odd_v_2.d.next = self.odd_v_1.q.val();
            self.part_u_2.d.next = self.part_u_1.q.val();
            self.part_v_2.d.next = self.part_v_1.q.val();
        }
        self.part_u.next = self.part_u_2.q.val();
        self.part_v.next = self.part_v_2.q.val();
    }
}

crate::clocked!(BumpBanks;
    inputs go, u, v, write, write_address, write_data;
    outputs upper_left, upper_right, lower_left, lower_right, part_u, part_v);
