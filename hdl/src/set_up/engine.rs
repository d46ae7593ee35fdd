//! The engine: fetches an instruction per clock, reads its operands, works on them, sends words to the core.
//!
//! ```text
//!  place ─► program ─► next_word ─► instruction ─┬► x, y ─► sum, difference, choice ─► registers, flags
//!                          │                     ├────────► multiplier, divider ─► x of later instructions
//!                          └► registers, triangles ► operands        └► word for the core
//! ```
//!
//! The host writes one half of the memory of triangles while the engine works on the other. The engine works on the next
//! triangle while the core draws; it stops, all stages together, only when it has a word that the core cannot take.

use super::divider::Divider;
use super::multiplier::Multiplier;
use super::program_rom::ProgramRom;
use super::{constant, WORD_FRACTION_BITS};
use crate::format::{bit_cast_u, signed_cast_align, signed_cast_bits, Q, U};
use crate::lit::table_memory::TableMemory;
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

/// `N`: fraction bits of a colour word; `B`: width of the register bus. A triangle takes as many clocks as the program has
/// instructions, and three.
#[derive(LogicBlock)]
pub struct SetUpEngine<const N: usize, const B: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Writes a word of the next triangle; ignored while `load_ready` is low.
    pub write: Signal<In, Bit>,
    /// Which word.
    pub slot: Signal<In, U<6>>,
    /// The word, signed.
    pub data: Signal<In, U<24>>,
    /// Writes a register of the frame; ignored while `load_ready` is low.
    pub frame_write: Signal<In, Bit>,
    /// 11 columns, 12 rows.
    pub frame_word: Signal<In, U<4>>,
    /// The words are complete; ignored while `load_ready` is low.
    pub start: Signal<In, Bit>,
    /// The core takes words.
    pub ready: Signal<In, Bit>,
    /// Words of a triangle may be written.
    pub load_ready: Signal<Out, Bit>,
    /// A word for the core; it stays until `ready`.
    pub core_write: Signal<Out, Bit>,
    /// Its select code.
    pub core_select: Signal<Out, U<8>>,
    /// Its data.
    pub core_data: Signal<Out, U<B>>,
    /// It is the last one.
    pub core_start: Signal<Out, Bit>,
    /// A triangle is waiting or being set up.
    pub busy: Signal<Out, Bit>,
    /// Triangles skipped since power-up: without area, or above or below the frame.
    pub skipped: Signal<Out, U<16>>,
    /// The half of the memory of triangles that the host writes.
    bank: Register<Bit>,
    /// That half holds a triangle.
    pending: Register<Bit>,
    /// The other half is being set up.
    running: Register<Bit>,
    /// Place in the program.
    place: Register<U<9>>,
    /// The program memory shows an instruction.
    fetched: Register<Bit>,
    /// The instruction in work.
    instruction: Register<U<63>>,
    /// Signs of results.
    flags: Register<U<16>>,
    /// Columns of the frame.
    columns: Register<U<12>>,
    /// Rows of the frame.
    rows: Register<U<12>>,
    /// Triangles skipped.
    skip_count: Register<U<16>>,
    /// Instructions.
    memory: Quiet<ProgramRom>,
    /// Words of two triangles.
    triangles: Quiet<TableMemory<7, 24>>,
    /// Results, for x.
    x_registers: Quiet<TableMemory<6, 64>>,
    /// The same results, for y.
    y_registers: Quiet<TableMemory<6, 64>>,
    /// Products.
    multiplier: Quiet<Multiplier>,
    /// Quotients.
    divider: Quiet<Divider>,
    /// The engine moves: its word, if any, is taken.
    go: Wire<Bit>,
    /// A triangle begins.
    starting: Wire<Bit>,
    /// A triangle ends.
    ending: Wire<Bit>,
    /// The host may write.
    accept: Wire<Bit>,
    /// The next instruction.
    next_word: Wire<U<63>>,
    /// Its register of x.
    next_x: Wire<U<6>>,
    /// Its register or slot of y.
    next_y: Wire<U<6>>,
    /// Where its y comes from.
    next_from: Wire<U<2>>,
    /// Which of three vertices.
    next_vertex: Wire<U<2>>,
    /// Vertex 0 is above vertex 1.
    above_01: Wire<Bit>,
    /// Vertex 0 is above vertex 2.
    above_02: Wire<Bit>,
    /// Vertex 1 is above vertex 2.
    above_12: Wire<Bit>,
    /// The top vertex.
    top: Wire<U<2>>,
    /// The bottom vertex.
    bottom: Wire<U<2>>,
    /// The middle vertex.
    middle: Wire<U<2>>,
    /// The vertex by the host's number.
    vertex: Wire<U<2>>,
    /// The slot of vertex 0.
    group: Wire<U<6>>,
    /// Address of the half in work.
    read_bank: Wire<U<7>>,
    /// Address of the half that the host writes.
    write_bank: Wire<U<7>>,
    /// Address of the slot in the half in work.
    read_slot: Wire<U<7>>,
    /// Where x comes from.
    x_from: Wire<U<2>>,
    /// x over 256.
    x_down: Wire<Bit>,
    /// Which constant.
    y_code: Wire<U<4>>,
    /// Where y comes from.
    y_from: Wire<U<2>>,
    /// How far y is moved up.
    y_shift: Wire<U<2>>,
    /// What is done with x and y.
    operation: Wire<U<2>>,
    /// Register of the result.
    to: Wire<U<6>>,
    /// The result is written.
    keep: Wire<Bit>,
    /// Which flag.
    flag: Wire<U<4>>,
    /// The flag is written.
    flag_write: Wire<Bit>,
    /// The result is cut to whole units.
    cut: Wire<Bit>,
    /// Multiplies.
    multiply: Wire<Bit>,
    /// Divides.
    divide: Wire<Bit>,
    /// Sends a word.
    send: Wire<Bit>,
    /// Layout of that word.
    layout: Wire<U<2>>,
    /// Units of depth words.
    depth: Wire<Bit>,
    /// Word of the triangle.
    raw: Wire<U<24>>,
    /// The same with its sign.
    raw_number: Wire<Q<23, 0>>,
    /// The same as wide as a register.
    raw_wide: Wire<Q<63, 0>>,
    /// Constant.
    chosen_constant: Wire<U<64>>,
    /// x before it is moved.
    x_plain: Wire<U<64>>,
    /// x with the binary point moved.
    x_point: Wire<Q<55, 8>>,
    /// x over 256.
    x_over: Wire<Q<63, 0>>,
    /// First operand.
    x: Wire<U<64>>,
    /// y before it is moved.
    y_plain: Wire<U<64>>,
    /// Second operand.
    y: Wire<U<64>>,
    /// What is added to, or subtracted from.
    left: Wire<U<64>>,
    /// The other one.
    right: Wire<U<64>>,
    /// The former, inverted for a difference.
    turned: Wire<U<64>>,
    /// The sum.
    added: Wire<U<64>>,
    /// The flag is set.
    flag_set: Wire<Bit>,
    /// Flags from this one on.
    flag_bits: Wire<U<16>>,
    /// The flag's bit.
    flag_mask: Wire<U<16>>,
    /// What comes out of the function.
    outcome: Wire<U<64>>,
    /// Bits of whole units.
    mask: Wire<U<64>>,
    /// The result.
    result: Wire<U<64>>,
    /// Its sign.
    negative: Wire<Bit>,
    /// The triangle is skipped.
    skipping: Wire<Bit>,
    /// Result as a colour word.
    colour_word: Wire<U<64>>,
    /// Result as a depth word.
    depth_word: Wire<U<64>>,
    /// x as a column.
    edge_high: Wire<U<12>>,
    /// y as an error term.
    edge_low: Wire<U<20>>,
    /// x above a count of rows.
    rows_high: Wire<U<21>>,
    /// y as a count of rows.
    rows_low: Wire<U<11>>,
    /// The word.
    sent: Wire<U<64>>,
    /// The lowest flag.
    one_bit: Constant<U<16>>,
    /// Places of a colour word below its unit.
    colour_places: Constant<U<5>>,
    /// Whole units of colour words.
    colour_mask: Constant<U<64>>,
    /// Whole units of depth words.
    depth_mask: Constant<U<64>>,
    /// Half a unit of a colour word.
    half_unit: Constant<U<64>>,
    /// Half a unit of a depth word.
    half_unit_depth: Constant<U<64>>,
    /// Half a level and half a unit.
    offset: Constant<U<64>>,
    /// Half a depth less its bias, and half a unit.
    offset_depth: Constant<U<64>>,
}

impl<const N: usize, const B: usize> Default for SetUpEngine<N, B> {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            write: Default::default(),
            slot: Default::default(),
            data: Default::default(),
            frame_write: Default::default(),
            frame_word: Default::default(),
            start: Default::default(),
            ready: Default::default(),
            load_ready: Default::default(),
            core_write: Default::default(),
            core_select: Default::default(),
            core_data: Default::default(),
            core_start: Default::default(),
            busy: Default::default(),
            skipped: Default::default(),
            bank: Default::default(),
            pending: Default::default(),
            running: Default::default(),
            place: Default::default(),
            fetched: Default::default(),
            instruction: Default::default(),
            flags: Default::default(),
            columns: Default::default(),
            rows: Default::default(),
            skip_count: Default::default(),
            memory: Default::default(),
            triangles: Default::default(),
            x_registers: Default::default(),
            y_registers: Default::default(),
            multiplier: Default::default(),
            divider: Default::default(),
            go: Default::default(),
            starting: Default::default(),
            ending: Default::default(),
            accept: Default::default(),
            next_word: Default::default(),
            next_x: Default::default(),
            next_y: Default::default(),
            next_from: Default::default(),
            next_vertex: Default::default(),
            above_01: Default::default(),
            above_02: Default::default(),
            above_12: Default::default(),
            top: Default::default(),
            bottom: Default::default(),
            middle: Default::default(),
            vertex: Default::default(),
            group: Default::default(),
            read_bank: Default::default(),
            write_bank: Default::default(),
            read_slot: Default::default(),
            x_from: Default::default(),
            x_down: Default::default(),
            y_code: Default::default(),
            y_from: Default::default(),
            y_shift: Default::default(),
            operation: Default::default(),
            to: Default::default(),
            keep: Default::default(),
            flag: Default::default(),
            flag_write: Default::default(),
            cut: Default::default(),
            multiply: Default::default(),
            divide: Default::default(),
            send: Default::default(),
            layout: Default::default(),
            depth: Default::default(),
            raw: Default::default(),
            raw_number: Default::default(),
            raw_wide: Default::default(),
            chosen_constant: Default::default(),
            x_plain: Default::default(),
            x_point: Default::default(),
            x_over: Default::default(),
            x: Default::default(),
            y_plain: Default::default(),
            y: Default::default(),
            left: Default::default(),
            right: Default::default(),
            turned: Default::default(),
            added: Default::default(),
            flag_set: Default::default(),
            flag_bits: Default::default(),
            flag_mask: Default::default(),
            outcome: Default::default(),
            mask: Default::default(),
            result: Default::default(),
            negative: Default::default(),
            skipping: Default::default(),
            colour_word: Default::default(),
            depth_word: Default::default(),
            edge_high: Default::default(),
            edge_low: Default::default(),
            rows_high: Default::default(),
            rows_low: Default::default(),
            sent: Default::default(),
            one_bit: Constant::new(U::new(1)),
            colour_places: Constant::new(U::new((WORD_FRACTION_BITS as usize - N) as u64)),
            colour_mask: Constant::new(U::new(!0 << (WORD_FRACTION_BITS as usize - N))),
            depth_mask: Constant::new(U::new(!0 << 16)),
            half_unit: Constant::new(U::new(constant(6, N as u32, [0; 2]) as u64)),
            half_unit_depth: Constant::new(U::new(constant(7, N as u32, [0; 2]) as u64)),
            offset: Constant::new(U::new(constant(8, N as u32, [0; 2]) as u64)),
            offset_depth: Constant::new(U::new(constant(9, N as u32, [0; 2]) as u64)),
        }
    }
}

impl<const N: usize, const B: usize> Logic for SetUpEngine<N, B> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name set_up_engine");
        comment!("title Set-up engine: a triangle's corners and knots to the register words of the core.");
        comment!("equation f = f0 + (d + a n) n + e m + b m^2 + c n m on the lattice of pixel centres; words are its differences");
        comment!("source Differences after Hast 2004, equations 3.213 to 3.233, on lattice steps; the machine is ours.");
        comment!("latency As many clocks as the program has instructions, and three.");
        dff_setup!(
            self,
            clock,
            bank,
            pending,
            running,
            place,
            fetched,
            instruction,
            flags,
            columns,
            rows,
            skip_count
        );
        // Fetch: the next instruction asks the memories for its operands.
        self.next_word.next = self.memory.word.val();
        self.next_x.next = self.next_word.val().get_bits::<6>(0);
        self.next_y.next = self.next_word.val().get_bits::<6>(6);
        self.next_from.next = self.next_word.val().get_bits::<2>(15);
        self.next_vertex.next = self.next_word.val().get_bits::<2>(6);
        self.above_01.next = self.flags.q.val().get_bit(0);
        self.above_02.next = self.flags.q.val().get_bit(1);
        self.above_12.next = self.flags.q.val().get_bit(2);
        self.top.next = 2u64.into();
        self.bottom.next = 2u64.into();
        if self.above_01.val() {
            if self.above_02.val() {
                self.top.next = 0u64.into();
            }
            if !self.above_12.val() {
                self.bottom.next = 1u64.into();
            }
        } else {
            if self.above_12.val() {
                self.top.next = 1u64.into();
            }
            if !self.above_02.val() {
                self.bottom.next = 0u64.into();
            }
        }
        self.middle.next = !(self.top.val() + self.bottom.val());
        self.vertex.next = self.next_vertex.val();
        if self.next_from.val() == 2u64.into() {
            if self.next_vertex.val() == 0u64.into() {
                self.vertex.next = self.top.val();
            }
            if self.next_vertex.val() == 1u64.into() {
                self.vertex.next = self.middle.val();
            }
            if self.next_vertex.val() == 2u64.into() {
                self.vertex.next = self.bottom.val();
            }
        }
        self.group.next = (self.next_y.val() >> 2u64) << 2u64;
        self.read_bank.next = 64u64.into();
        self.write_bank.next = 0u64.into();
        if self.bank.q.val() {
            self.read_bank.next = 0u64.into();
            self.write_bank.next = 64u64.into();
        }
        self.read_slot.next = bit_cast_u::<7, 6>(self.group.val())
            | bit_cast_u::<7, 2>(self.vertex.val())
            | self.read_bank.val();

        // The instruction in work.
        self.x_from.next = self.instruction.q.val().get_bits::<2>(12);
        self.x_down.next = self.instruction.q.val().get_bit(14);
        self.y_code.next = self.instruction.q.val().get_bits::<4>(6);
        self.y_from.next = self.instruction.q.val().get_bits::<2>(15);
        self.y_shift.next = self.instruction.q.val().get_bits::<2>(17);
        self.operation.next = self.instruction.q.val().get_bits::<2>(19);
        self.to.next = self.instruction.q.val().get_bits::<6>(21);
        self.keep.next = self.instruction.q.val().get_bit(27);
        self.flag.next = self.instruction.q.val().get_bits::<4>(28);
        self.flag_write.next = self.instruction.q.val().get_bit(32);
        self.cut.next = self.instruction.q.val().get_bit(33);
        self.multiply.next = self.instruction.q.val().get_bit(34);
        self.divide.next = self.instruction.q.val().get_bit(46);
        self.send.next = self.instruction.q.val().get_bit(49);
        self.layout.next = self.instruction.q.val().get_bits::<2>(58);
        self.depth.next = self.instruction.q.val().get_bit(62);
        self.go.next = !self.send.val() || self.ready.val();

        // Operands.
        self.raw.next = self.triangles.read_data.val();
        self.raw_number.next = signed_cast_bits::<23, 0, 24>(self.raw.val());
        self.raw_wide.next = signed_cast_align::<63, 0, 23, 0>(self.raw_number.val());
        self.chosen_constant.next = 0u64.into();
        if self.y_code.val() == 1u64.into() {
            self.chosen_constant.next = 1u64.into();
        }
        if self.y_code.val() == 2u64.into() {
            self.chosen_constant.next = 127u64.into();
        }
        if self.y_code.val() == 3u64.into() {
            self.chosen_constant.next = 128u64.into();
        }
        if self.y_code.val() == 4u64.into() {
            self.chosen_constant.next = 2048u64.into();
        }
        if self.y_code.val() == 5u64.into() {
            self.chosen_constant.next = 16777216u64.into();
        }
        if self.y_code.val() == 6u64.into() {
            self.chosen_constant.next = self.half_unit.val();
        }
        if self.y_code.val() == 7u64.into() {
            self.chosen_constant.next = self.half_unit_depth.val();
        }
        if self.y_code.val() == 8u64.into() {
            self.chosen_constant.next = self.offset.val();
        }
        if self.y_code.val() == 9u64.into() {
            self.chosen_constant.next = self.offset_depth.val();
        }
        if self.y_code.val() == 10u64.into() {
            self.chosen_constant.next = bit_cast_u::<64, 12>(self.columns.q.val());
        }
        if self.y_code.val() == 11u64.into() {
            self.chosen_constant.next = bit_cast_u::<64, 12>(self.rows.q.val());
        }
        self.x_plain.next = self.x_registers.read_data.val();
        if self.x_from.val() == 1u64.into() {
            self.x_plain.next = self.multiplier.product.val();
        }
        if self.x_from.val() == 2u64.into() {
            self.x_plain.next = bit_cast_u::<64, 44>(self.divider.quotient.val());
        }
        if self.x_from.val() == 3u64.into() {
            self.x_plain.next = bit_cast_u::<64, 34>(self.divider.remainder.val());
        }
        self.x_point.next = signed_cast_bits::<55, 8, 64>(self.x_plain.val());
        self.x_over.next = signed_cast_align::<63, 0, 55, 8>(self.x_point.val());
        self.x.next = self.x_plain.val();
        if self.x_down.val() {
            self.x.next = self.x_over.val().get_bits::<64>(0);
        }
        self.y_plain.next = self.raw_wide.val().get_bits::<64>(0);
        if self.y_from.val() == 0u64.into() {
            self.y_plain.next = self.y_registers.read_data.val();
        }
        if self.y_from.val() == 3u64.into() {
            self.y_plain.next = self.chosen_constant.val();
        }
        self.y.next = self.y_plain.val();
        if self.y_shift.val() == 1u64.into() {
            self.y.next = self.y_plain.val() << 1u64;
        }
        if self.y_shift.val() == 2u64.into() {
            self.y.next = self.y_plain.val() << 8u64;
        }
        if self.y_shift.val() == 3u64.into() {
            self.y.next = self.y_plain.val() << 26u64;
        }

        // Sum, difference (not (not a + b)), choice.
        self.left.next = self.x.val();
        self.right.next = self.y.val();
        if self.operation.val() == 2u64.into() {
            self.left.next = self.y.val();
            self.right.next = self.x.val();
        }
        self.turned.next = !self.left.val();
        if self.operation.val() == 0u64.into() {
            self.turned.next = self.left.val();
        }
        self.added.next = self.turned.val() + self.right.val();
        self.flag_bits.next = self.flags.q.val() >> self.flag.val();
        self.flag_set.next = self.flag_bits.val().get_bit(0);
        self.flag_mask.next = self.one_bit.val() << self.flag.val();
        self.outcome.next = !self.added.val();
        if self.operation.val() == 0u64.into() {
            self.outcome.next = self.added.val();
        }
        if self.operation.val() == 3u64.into() {
            self.outcome.next = self.y.val();
            if self.flag_set.val() {
                self.outcome.next = self.x.val();
            }
        }
        self.mask.next = self.colour_mask.val();
        if self.depth.val() {
            self.mask.next = self.depth_mask.val();
        }
        self.result.next = self.outcome.val();
        if self.cut.val() {
            self.result.next = self.outcome.val() & self.mask.val();
        }
        self.negative.next = self.result.val().get_bit(63);
        self.skipping.next = self.instruction.q.val().get_bit(61) && self.flag_set.val();
        self.ending.next = self.instruction.q.val().get_bit(60) || self.skipping.val();

        // The word for the core.
        self.colour_word.next = self.result.val() >> self.colour_places.val();
        self.depth_word.next = self.result.val() >> 16u64;
        self.edge_high.next = self.x.val().get_bits::<12>(0);
        self.edge_low.next = self.y.val().get_bits::<20>(0);
        self.rows_high.next = self.x.val().get_bits::<21>(0);
        self.rows_low.next = self.y.val().get_bits::<11>(0);
        self.sent.next = self.colour_word.val();
        if self.depth.val() {
            self.sent.next = self.depth_word.val();
        }
        if self.layout.val() == 1u64.into() {
            self.sent.next = (bit_cast_u::<64, 12>(self.edge_high.val()) << 20u64)
                | bit_cast_u::<64, 20>(self.edge_low.val());
        }
        if self.layout.val() == 2u64.into() {
            self.sent.next = (bit_cast_u::<64, 21>(self.rows_high.val()) << 11u64)
                | bit_cast_u::<64, 11>(self.rows_low.val());
        }
        self.core_write.next = self.send.val();
        self.core_select.next = self.instruction.q.val().get_bits::<8>(50);
        self.core_data.next = bit_cast_u::<B, 64>(self.sent.val());
        self.core_start.next = self.instruction.q.val().get_bit(60);

        // Units.
        self.memory.clock.next = self.clock.val();
        self.memory.read.next = self.go.val();
        self.memory.place.next = self.place.q.val();
        self.x_registers.clock.next = self.clock.val();
        self.x_registers.read.next = self.go.val();
        self.x_registers.read_address.next = self.next_x.val();
        self.x_registers.write.next = self.go.val() && self.keep.val();
        self.x_registers.write_address.next = self.to.val();
        self.x_registers.write_data.next = self.result.val();
        self.y_registers.clock.next = self.clock.val();
        self.y_registers.read.next = self.go.val();
        self.y_registers.read_address.next = self.next_y.val();
        self.y_registers.write.next = self.go.val() && self.keep.val();
        self.y_registers.write_address.next = self.to.val();
        self.y_registers.write_data.next = self.result.val();
        self.multiplier.clock.next = self.clock.val();
        self.multiplier.go.next = self.go.val();
        self.multiplier.start.next = self.multiply.val();
        self.multiplier.x.next = self.x.val();
        self.multiplier.y.next = self.y.val();
        self.multiplier.limbs.next = self.instruction.q.val().get_bits::<2>(35);
        self.multiplier.places.next = self.instruction.q.val().get_bits::<7>(37);
        self.multiplier.kind.next = self.instruction.q.val().get_bits::<2>(44);
        self.multiplier.exponent.next = self.divider.exponent.val();
        self.divider.clock.next = self.clock.val();
        self.divider.go.next = self.go.val();
        self.divider.start.next = self.divide.val();
        self.divider.kind.next = self.instruction.q.val().get_bits::<2>(47);
        self.divider.x.next = self.x.val();
        self.divider.y.next = self.y.val();

        // The host's side.
        self.accept.next = !self.pending.q.val();
        self.starting.next = self.pending.q.val() && !self.running.q.val();
        self.triangles.clock.next = self.clock.val();
        self.triangles.read.next = self.go.val();
        self.triangles.read_address.next = self.read_slot.val();
        self.triangles.write.next = self.write.val() && self.accept.val();
        self.triangles.write_address.next =
            bit_cast_u::<7, 6>(self.slot.val()) | self.write_bank.val();
        self.triangles.write_data.next = self.data.val();
        if self.frame_write.val() && self.accept.val() {
            if self.frame_word.val() == 11u64.into() {
                self.columns.d.next = self.data.val().get_bits::<12>(0);
            }
            if self.frame_word.val() == 12u64.into() {
                self.rows.d.next = self.data.val().get_bits::<12>(0);
            }
        }
        if self.go.val() {
            self.place.d.next = self.place.q.val() + 1u64.into();
            self.fetched.d.next = self.running.q.val() && !self.ending.val();
            self.instruction.d.next = 0u64.into();
            if self.fetched.q.val() && !self.ending.val() {
                self.instruction.d.next = self.next_word.val();
            }
            if self.flag_write.val() {
                self.flags.d.next = self.flags.q.val() & !self.flag_mask.val();
                if self.negative.val() {
                    self.flags.d.next = self.flags.q.val() | self.flag_mask.val();
                }
            }
            if self.skipping.val() {
                self.skip_count.d.next = self.skip_count.q.val() + 1u64.into();
            }
            if self.ending.val() {
                self.running.d.next = false;
            }
        }
        if self.start.val() {
            self.pending.d.next = true;
        }
        if self.starting.val() {
            self.pending.d.next = false;
            self.running.d.next = true;
            self.place.d.next = 0u64.into();
            self.bank.d.next = !self.bank.q.val();
        }
        self.load_ready.next = self.accept.val();
        self.busy.next = self.pending.q.val() || self.running.q.val();
        self.skipped.next = self.skip_count.q.val();
    }
}

crate::clocked!(SetUpEngine<N, B>, const N: usize, const B: usize;
    inputs write, slot, data, frame_write, frame_word, start, ready;
    outputs load_ready, core_write, core_select, core_data, core_start, busy, skipped);
