//! The walk of the compact unit: rows, both edges, pixels; and in which clock which register adds what.
//!
//! A triangle is walked as in [`crate::raster::shell`]: from the major edge towards the minor ones, mirrored if the major
//! edge is on the right. Edges are exact ([`crate::raster::edge_walk`]), but a row's step is one addition of a word
//! {columns, error step}, of which there are two per edge: without carry and with. Pixels beside the frame are walked and
//! not offered.
//!
//! Words (4 bits), bits high to low:
//!
//! | word | content |
//! |---|---|
//! | 0, 1 | major edge, step without and with carry: columns\[31:20\], error step\[19:0\] (with carry one column more) |
//! | 2, 3 | upper minor edge, likewise |
//! | 4, 5, 6 | lower minor edge, likewise, and its first column\[31:20\], error\[19:0\] |
//! | 7, 15 | major and upper minor edge: first column, error |
//! | 8 | has a lower minor edge\[23\], mirrored\[22\], one past its last row\[21:11\], of the upper one\[10:0\] |
//! | 9 | first row\[10:0\] |
//! | 11 | frame width\[11:0\], for all triangles |
//!
//! What happens, phase by phase (`word` is the channels' word):
//!
//! | phase | channels | edges |
//! |---|---|---|
//! | 1 | clear | clear both and the row |
//! | 2 | d_line += value | major += first, row += first |
//! | 3 | value += d_line, clear d_line | upper += first |
//! | 4, 5 | d_line += d_line, d_pixel += d_pixel | |
//! | 6, when the last span has ended | keep dd_pixel | |
//! | 0, a span is taken | value += d_line, d_line += dd_line | major += step, row += 1 |
//! | 8 | d_pixel += dd_pixel_line, with carry also d_line += dd_pixel_line | minor += step, or clear for the lower one |
//! | 9, carry or lower edge | value += d_pixel, d_pixel += dd_pixel | lower += first |

use super::word_memory::WordMemory;
use crate::format::{bit_cast_u, signed_cast_bits, unsigned_cast_integer, Q, U};
use crate::simulate::{Quiet, Register, Wire};
use rust_hdl_core::prelude::*;
use rust_hdl_widgets::dff_setup;

macro_rules! walk {
    (
        inputs { $($(#[$id:meta])* $input:ident: $it:ty,)* }
        outputs { $($(#[$od:meta])* $output:ident: $ot:ty,)* }
        inner { $($(#[$nd:meta])* $inner:ident: $nt:ty,)* }
        constants { $($(#[$cd:meta])* $constant:ident: $ct:ty = $value:expr,)* }
    ) => {
        /// Latency: seven clocks from `start` to the first span; then one pixel per clock.
        #[derive(LogicBlock)]
        pub struct CompactWalk {
            /// Clock.
            pub clock: Signal<In, Clock>,
            $($(#[$id])* pub $input: Signal<In, $it>,)*
            $($(#[$od])* pub $output: Signal<Out, $ot>,)*
            $($(#[$nd])* $inner: $nt,)*
            $($(#[$cd])* $constant: Constant<$ct>,)*
        }

        impl Default for CompactWalk {
            fn default() -> Self {
                Self {
                    clock: Default::default(),
                    $($input: Default::default(),)*
                    $($output: Default::default(),)*
                    $($inner: Default::default(),)*
                    $($constant: Constant::new($value),)*
                }
            }
        }

        crate::clocked!(CompactWalk; inputs $($input),*; outputs $($output),*);
    };
}

walk! {
    inputs {
        /// A word of any kind is written, which holds the line registers.
        write: Bit,
        /// It is one of the walk.
        write_walk: Bit,
        /// Which one.
        word: U<4>,
        /// Register bus.
        data: U<32>,
        /// The words are complete; ignored while `load_ready` is low.
        start: Bit,
        /// The pixel is taken.
        go: Bit,
    }
    outputs {
        /// Words may be written.
        load_ready: Bit,
        /// Word of the channels to read or write.
        address: U<4>,
        /// Clears the channels' line registers.
        clear: Bit,
        /// Clears the channels' differences along the line step alone.
        clear_line: Bit,
        /// Channels add to their value.
        add_value: Bit,
        /// Channels add to their difference along the line step.
        add_line: Bit,
        /// Channels add to their difference along the pixel step.
        add_pixel: Bit,
        /// The value takes the difference along the pixel step.
        pixel_step: Bit,
        /// Channels keep the second difference along the span.
        keep_bend: Bit,
        /// A span moves to the pixel registers.
        take: Bit,
        /// The pixel registers move on.
        run: Bit,
        /// The pixel registers stand on a pixel of the frame.
        fragment: Bit,
        /// Its column.
        x: U<11>,
        /// Its row.
        y: U<11>,
        /// A triangle is waiting or being walked.
        busy: Bit,
    }
    inner {
        /// The words hold a complete triangle.
        pending: Register<Bit>,
        /// Half of the memories that holds the words of this triangle.
        bank: Register<Bit>,
        /// Columns of the frame.
        frame_width: Register<U<12>>,
        /// Next triangle, one past the last row of the upper minor edge.
        word_turn: Register<U<11>>,
        /// Next triangle, one past the last row of all.
        word_end: Register<U<11>>,
        /// Next triangle, it has a lower minor edge.
        word_lower: Register<Bit>,
        /// Next triangle, columns are complemented.
        word_mirrored: Register<Bit>,
        /// Next triangle, first row.
        word_row: Register<U<11>>,
        /// What the line registers do; 0: they stand on a span.
        phase: Register<U<4>>,
        /// There is a span to stand on.
        line_active: Register<Bit>,
        /// One past the last row of this minor edge.
        turn_row: Register<U<11>>,
        /// One past the last row of the triangle.
        end_row: Register<U<11>>,
        /// The triangle has a lower minor edge.
        has_lower: Register<Bit>,
        /// The lower minor edge is walked.
        on_lower: Register<Bit>,
        /// The lower minor edge begins.
        switching: Register<Bit>,
        /// The major edge carried.
        carried: Register<Bit>,
        /// Row of the next span.
        line_row: Register<U<11>>,
        /// Columns of the triangle are complemented.
        line_mirrored: Register<Bit>,
        /// Column of the major edge.
        major_column: Register<Q<11, 0>>,
        /// Its error term: the step carries when it is not negative.
        major_error: Register<Q<19, 0>>,
        /// Column of the minor edge.
        minor_column: Register<Q<11, 0>>,
        /// Its error term.
        minor_error: Register<Q<19, 0>>,
        /// The pixel registers stand on a pixel.
        running: Register<Bit>,
        /// Walk column of the pixel.
        column: Register<Q<11, 0>>,
        /// One past the last walk column of the span.
        span_end: Register<Q<11, 0>>,
        /// Row of the pixel.
        pixel_row: Register<U<11>>,
        /// Columns of the span are complemented.
        pixel_mirrored: Register<Bit>,
        /// A write is accepted.
        accept: Wire<Bit>,
        /// Waiting half of the memories as a word number.
        waiting: Wire<U<4>>,
        /// This half as a word number.
        current: Wire<U<4>>,
        /// Bits of a word number inside a half.
        low_bits: Wire<U<3>>,
        /// The same, as a word number.
        low_word: Wire<U<4>>,
        /// Channel word to read.
        channel_word: Wire<U<4>>,
        /// Edge word to read.
        edge_word: Wire<U<4>>,
        /// Upper part of an edge word.
        edge_columns: Wire<Q<11, 0>>,
        /// Bits of it.
        column_bits: Wire<U<12>>,
        /// Lower part of an edge word.
        edge_step: Wire<Q<19, 0>>,
        /// Bits of it.
        step_bits: Wire<U<20>>,
        /// The major edge and the row are cleared.
        clear_edges: Wire<Bit>,
        /// The major edge adds the word.
        add_major: Wire<Bit>,
        /// The minor edge adds the word.
        add_minor: Wire<Bit>,
        /// The minor edge is cleared.
        clear_minor: Wire<Bit>,
        /// The next span has pixels.
        has_pixels: Wire<Bit>,
        /// Walk column of the next pixel.
        next_column: Wire<Q<11, 0>>,
        /// This is the last pixel of the span.
        span_done: Wire<Bit>,
        /// The pixel registers can take a span.
        pixel_free: Wire<Bit>,
        /// The line registers stand on a span and may move.
        stands: Wire<Bit>,
        /// A span moves to the pixel registers.
        taking: Wire<Bit>,
        /// The line registers move on.
        advance: Wire<Bit>,
        /// What the row takes.
        row_add: Wire<U<11>>,
        /// The row takes it.
        add_row: Wire<Bit>,
        /// The row after this one.
        next_row: Wire<U<11>>,
        /// The row is the last of its minor edge.
        last_row: Wire<Bit>,
        /// The triangle goes on below this row.
        goes_on: Wire<Bit>,
        /// The line registers step.
        stepping: Wire<Bit>,
        /// A triangle begins.
        begins: Wire<Bit>,
        /// The pixel registers move on.
        running_now: Wire<Bit>,
        /// Column on the screen.
        screen_column: Wire<Q<11, 0>>,
        /// The same, as bits.
        screen_bits: Wire<U<12>>,
        /// Words of the edges.
        edges: Quiet<WordMemory<32>>,
    }
    constants {
        /// The other half.
        half: U<4> = U::new(8),
        /// One row.
        one_row: U<11> = U::new(1),
        /// No row.
        no_row: U<11> = U::new(0),
        /// One phase.
        one_phase: U<4> = U::new(1),
        /// One column.
        one: Q<11, 0> = Q::from_code(1),
        /// No column.
        no_column: Q<11, 0> = Q::from_code(0),
        /// No error.
        no_error: Q<19, 0> = Q::from_code(0),
    }
}

impl Logic for CompactWalk {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name compact_walk");
        comment!(
            "title Rows, edges and pixels of the compact unit, and the order of its additions."
        );
        comment!("equation span of row r = columns major(r) .. minor(r) - 1; column += columns, error += error step per row");
        comment!("source Abbas 2003, section 2.2 and appendix; the edge walk is exact.");
        comment!("latency Seven clocks from start to the first span; then one pixel per clock in spans of three and more.");
        dff_setup!(
            self,
            clock,
            pending,
            bank,
            frame_width,
            word_turn,
            word_end,
            word_lower,
            word_mirrored,
            word_row,
            phase,
            line_active,
            turn_row,
            end_row,
            has_lower,
            on_lower,
            switching,
            carried,
            line_row,
            line_mirrored,
            major_column,
            major_error,
            minor_column,
            minor_error,
            running,
            column,
            span_end,
            pixel_row,
            pixel_mirrored
        );

        // Writes go to the waiting half.
        self.accept.next = self.write_walk.val() && !self.pending.q.val();
        if self.accept.val() {
            if self.word.val() == 8u64.into() {
                self.word_turn.d.next = self.data.val().get_bits::<11>(0);
                self.word_end.d.next = self.data.val().get_bits::<11>(11);
                self.word_mirrored.d.next = self.data.val().get_bit(22);
                self.word_lower.d.next = self.data.val().get_bit(23);
            }
            if self.word.val() == 9u64.into() {
                self.word_row.d.next = self.data.val().get_bits::<11>(0);
            }
            if self.word.val() == 11u64.into() {
                self.frame_width.d.next = self.data.val().get_bits::<12>(0);
            }
        }
        self.low_bits.next = self.word.val().get_bits::<3>(0);
        self.low_word.next = bit_cast_u::<4, 3>(self.low_bits.val());
        self.waiting.next = self.half.val();
        self.current.next = 0u64.into();
        if self.bank.q.val() {
            self.waiting.next = 0u64.into();
            self.current.next = self.half.val();
        }

        // The pixel registers.
        self.next_column.next = self.column.q.val() + self.one.val();
        self.span_done.next = self.next_column.val() == self.span_end.q.val();
        self.pixel_free.next = !self.running.q.val() || (self.go.val() && self.span_done.val());
        self.running_now.next = self.running.q.val() && self.go.val();

        // Whether the line registers move.
        self.has_pixels.next = self.minor_column.q.val() > self.major_column.q.val();
        self.stands.next =
            self.line_active.q.val() && !self.phase.q.val().any() && !self.write.val();
        self.taking.next = self.stands.val() && self.has_pixels.val() && self.pixel_free.val();
        self.advance.next = self.stands.val() && (self.pixel_free.val() || !self.has_pixels.val());
        self.row_add.next = self.one_row.val();
        if self.phase.q.val() == 2u64.into() {
            self.row_add.next = self.word_row.q.val();
        }
        self.next_row.next = self.line_row.q.val() + self.row_add.val();
        self.last_row.next = self.next_row.val() == self.turn_row.q.val();
        self.goes_on.next =
            !self.last_row.val() || (!self.on_lower.q.val() && self.has_lower.q.val());
        self.stepping.next = self.advance.val() && self.goes_on.val();
        self.begins.next = self.pending.q.val()
            && !self.line_active.q.val()
            && !self.phase.q.val().any()
            && !self.write.val();

        // What is added in this phase.
        self.clear.next = false;
        self.clear_line.next = false;
        self.add_value.next = self.stepping.val();
        self.add_line.next = self.stepping.val();
        self.add_pixel.next = false;
        self.pixel_step.next = false;
        self.keep_bend.next = false;
        self.clear_edges.next = false;
        self.clear_minor.next = false;
        self.add_major.next = self.stepping.val();
        self.add_row.next = self.stepping.val();
        self.add_minor.next = false;
        self.channel_word.next = 4u64.into();
        self.edge_word.next = 0u64.into();
        if !self.major_error.q.val().get_bit(19) {
            self.edge_word.next = 1u64.into();
        }
        if !self.write.val() {
            if self.phase.q.val() == 1u64.into() {
                self.clear.next = true;
                self.clear_edges.next = true;
                self.clear_minor.next = true;
            }
            if self.phase.q.val() == 2u64.into() {
                self.add_line.next = true;
                self.add_major.next = true;
                self.add_row.next = true;
            }
            if self.phase.q.val() == 3u64.into() {
                self.add_value.next = true;
                self.clear_line.next = true;
                self.add_minor.next = true;
            }
            if self.phase.q.val() == 4u64.into() {
                self.add_line.next = true;
            }
            if self.phase.q.val() == 5u64.into() {
                self.add_pixel.next = true;
            }
            if self.phase.q.val() == 6u64.into() {
                self.keep_bend.next = self.pixel_free.val();
            }
            if self.phase.q.val() == 8u64.into() {
                self.add_line.next = self.carried.q.val();
                self.add_pixel.next = true;
                self.add_minor.next = !self.switching.q.val();
                self.clear_minor.next = self.switching.q.val();
            }
            if self.phase.q.val() == 9u64.into() {
                self.add_value.next = self.carried.q.val();
                self.add_pixel.next = self.carried.q.val();
                self.pixel_step.next = true;
                self.add_minor.next = self.switching.q.val();
            }
        }
        // Which words that takes.
        if self.phase.q.val() == 2u64.into() {
            self.channel_word.next = 0u64.into();
            self.edge_word.next = 7u64.into();
        }
        if self.phase.q.val() == 3u64.into() {
            self.edge_word.next = 15u64.into();
        }
        if self.phase.q.val() == 4u64.into() {
            self.channel_word.next = 1u64.into();
        }
        if self.phase.q.val() == 5u64.into() {
            self.channel_word.next = 2u64.into();
        }
        if self.phase.q.val() == 6u64.into() {
            self.channel_word.next = 3u64.into();
        }
        if self.phase.q.val() == 8u64.into() {
            self.channel_word.next = 5u64.into();
            self.edge_word.next = 2u64.into();
            if self.on_lower.q.val() {
                self.edge_word.next = 4u64.into();
            }
            if !self.minor_error.q.val().get_bit(19) {
                self.edge_word.next = 3u64.into();
                if self.on_lower.q.val() {
                    self.edge_word.next = 5u64.into();
                }
            }
        }
        if self.phase.q.val() == 9u64.into() {
            self.channel_word.next = 3u64.into();
            self.edge_word.next = 6u64.into();
        }

        // The memories.
        self.address.next = self.current.val() | self.channel_word.val();
        self.edges.address.next = self.current.val() | self.edge_word.val();
        if (self.phase.q.val() == 2u64.into()) || (self.phase.q.val() == 3u64.into()) {
            self.edges.address.next = self.edge_word.val();
        }
        if self.write.val() {
            self.address.next = self.waiting.val() | self.low_word.val();
            self.edges.address.next = self.waiting.val() | self.low_word.val();
            if self.low_bits.val() == 7u64.into() {
                self.edges.address.next = self.word.val();
            }
        }
        self.edges.clock.next = self.clock.val();
        self.edges.write.next =
            self.accept.val() && (!self.word.val().get_bit(3) || (self.word.val() == 15u64.into()));
        self.edges.write_data.next = self.data.val();
        self.column_bits.next = self.edges.read_data.val().get_bits::<12>(20);
        self.step_bits.next = self.edges.read_data.val().get_bits::<20>(0);
        self.edge_columns.next = signed_cast_bits::<11, 0, 12>(self.column_bits.val());
        self.edge_step.next = signed_cast_bits::<19, 0, 20>(self.step_bits.val());

        // The edges.
        if self.clear_edges.val() {
            self.major_column.d.next = self.no_column.val();
            self.major_error.d.next = self.no_error.val();
        } else if self.add_major.val() {
            self.major_column.d.next = self.major_column.q.val() + self.edge_columns.val();
            self.major_error.d.next = self.major_error.q.val() + self.edge_step.val();
        }
        if self.clear_minor.val() {
            self.minor_column.d.next = self.no_column.val();
            self.minor_error.d.next = self.no_error.val();
        } else if self.add_minor.val() {
            self.minor_column.d.next = self.minor_column.q.val() + self.edge_columns.val();
            self.minor_error.d.next = self.minor_error.q.val() + self.edge_step.val();
        }

        // Rows.
        if self.clear_edges.val() {
            self.line_row.d.next = self.no_row.val();
        } else if self.add_row.val() {
            self.line_row.d.next = self.next_row.val();
        }
        if self.begins.val() {
            self.bank.d.next = !self.bank.q.val();
            self.turn_row.d.next = self.word_turn.q.val();
            self.end_row.d.next = self.word_end.q.val();
            self.has_lower.d.next = self.word_lower.q.val();
            self.on_lower.d.next = false;
        } else if self.stepping.val() {
            if self.last_row.val() {
                self.turn_row.d.next = self.end_row.q.val();
            }
            self.switching.d.next = self.last_row.val();
            self.carried.d.next = !self.major_error.q.val().get_bit(19);
        }
        if self.add_minor.val() && self.switching.q.val() && self.pixel_step.val() {
            self.on_lower.d.next = true;
        }

        // The order of it all.
        if self.begins.val() {
            self.phase.d.next = 1u64.into();
        } else if self.stepping.val() {
            self.phase.d.next = 8u64.into();
        } else if !self.write.val() {
            if self.phase.q.val() == 6u64.into() {
                if self.pixel_free.val() {
                    self.phase.d.next = 0u64.into();
                    self.line_active.d.next = true;
                    self.line_mirrored.d.next = self.word_mirrored.q.val();
                    self.pending.d.next = false;
                }
            } else if self.phase.q.val() == 8u64.into() {
                self.phase.d.next = 0u64.into();
                if self.carried.q.val() || self.switching.q.val() {
                    self.phase.d.next = 9u64.into();
                }
            } else if self.phase.q.val() == 9u64.into() {
                self.phase.d.next = 0u64.into();
            } else if self.phase.q.val().any() {
                self.phase.d.next = self.phase.q.val() + self.one_phase.val();
            }
        }
        if self.advance.val() && !self.goes_on.val() {
            self.line_active.d.next = false;
        }
        if self.start.val() && !self.pending.q.val() {
            self.pending.d.next = true;
        }

        if self.taking.val() {
            self.running.d.next = true;
            self.column.d.next = self.major_column.q.val();
            self.span_end.d.next = self.minor_column.q.val();
            self.pixel_row.d.next = self.line_row.q.val();
            self.pixel_mirrored.d.next = self.line_mirrored.q.val();
        } else if self.running_now.val() {
            self.running.d.next = !self.span_done.val();
            self.column.d.next = self.next_column.val();
        }

        self.screen_column.next = self.column.q.val();
        if self.pixel_mirrored.q.val() {
            self.screen_column.next = !self.column.q.val();
        }
        self.screen_bits.next = unsigned_cast_integer::<12, 11, 0>(self.screen_column.val());
        self.fragment.next =
            self.running.q.val() && (self.screen_bits.val() < self.frame_width.q.val());
        self.x.next = unsigned_cast_integer::<11, 11, 0>(self.screen_column.val());
        self.y.next = self.pixel_row.q.val();
        self.take.next = self.taking.val();
        self.run.next = self.running_now.val();
        self.load_ready.next = !self.pending.q.val();
        self.busy.next = self.pending.q.val()
            || self.line_active.q.val()
            || self.phase.q.val().any()
            || self.running.q.val();
    }
}
