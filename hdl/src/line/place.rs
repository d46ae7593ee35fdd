//! Where a lane of a column lies: its screen coordinates, its frame address, and whether it is in the frame.
//!
//! Lane 0 is the column's own pixel (X, Y), then come (X, Y + 1), (X, Y − 1) and (X, Y ± 2), Y along the walk's minor axis.
//! What lies outside the frame has no address and is not drawn.

use crate::format::{unsigned_cast_integer, Q, U};
use crate::simulate::Wire;
use rust_hdl_core::prelude::*;

/// Combinational. `A` is the width of a frame address.
#[derive(LogicBlock)]
pub struct LanePlace<const A: usize> {
    /// Lane, from 0.
    pub lane: Signal<In, U<2>>,
    /// Lane 3 lies on the side of Y - 1.
    pub below: Signal<In, Bit>,
    /// Major coordinate of the column.
    pub major: Signal<In, Q<11, 0>>,
    /// Minor coordinate of lane 0.
    pub minor: Signal<In, Q<11, 0>>,
    /// Frame address of lane 0.
    pub address: Signal<In, U<A>>,
    /// The major axis is the screen's y axis.
    pub steep: Signal<In, Bit>,
    /// The minor coordinate falls along the walk.
    pub falling: Signal<In, Bit>,
    /// Columns of the frame.
    pub frame_width: Signal<In, Q<11, 0>>,
    /// Rows of the frame.
    pub frame_height: Signal<In, Q<11, 0>>,
    /// Column on the screen.
    pub x: Signal<Out, U<11>>,
    /// Row on the screen.
    pub y: Signal<Out, U<11>>,
    /// Frame address of the pixel, row · width + column.
    pub place: Signal<Out, U<A>>,
    /// The pixel lies in the frame.
    pub in_frame: Signal<Out, Bit>,
    /// Distance from lane 0.
    offset: Wire<Q<11, 0>>,
    /// The pixel lies before lane 0 on the screen.
    backward: Wire<Bit>,
    /// Frame width as an address step.
    row: Wire<U<A>>,
    /// Two rows.
    two_rows: Wire<U<A>>,
    /// Distance from lane 0 as an address step.
    step: Wire<U<A>>,
    /// Minor coordinate of the pixel.
    across: Wire<Q<11, 0>>,
    /// Column on the screen.
    column: Wire<Q<11, 0>>,
    /// Row on the screen.
    line: Wire<Q<11, 0>>,
    /// Nowhere.
    zero: Constant<Q<11, 0>>,
    /// The next pixel.
    one: Constant<Q<11, 0>>,
    /// The next but one.
    two: Constant<Q<11, 0>>,
    /// The next address.
    one_word: Constant<U<A>>,
    /// The next but one.
    two_words: Constant<U<A>>,
}

impl<const A: usize> Default for LanePlace<A> {
    fn default() -> Self {
        Self {
            lane: Default::default(),
            below: Default::default(),
            major: Default::default(),
            minor: Default::default(),
            address: Default::default(),
            steep: Default::default(),
            falling: Default::default(),
            frame_width: Default::default(),
            frame_height: Default::default(),
            x: Default::default(),
            y: Default::default(),
            place: Default::default(),
            in_frame: Default::default(),
            offset: Default::default(),
            backward: Default::default(),
            row: Default::default(),
            two_rows: Default::default(),
            step: Default::default(),
            across: Default::default(),
            column: Default::default(),
            line: Default::default(),
            zero: Constant::new(Q::from_code(0)),
            one: Constant::new(Q::from_code(1)),
            two: Constant::new(Q::from_code(2)),
            one_word: Constant::new(U::new(1)),
            two_words: Constant::new(U::new(2)),
        }
    }
}

// "Not left of the border" is a comparator and an inverter.
#[allow(clippy::nonminimal_bool)]
impl<const A: usize> Logic for LanePlace<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("name lane_place");
        comment!("title The place of one pixel of a line's column on the screen and in the frame memory.");
        comment!("equation minor = Y + o, o = 0, +1, -1, +-2 for lanes 0 to 3; (x, y) = steep ? (minor, major) : (major, minor)");
        comment!("source Octants by exchange of axes and mirroring, which Abbas 2003, chapter 3, leaves to the reader.");
        comment!("latency Combinational.");
        self.row.next = unsigned_cast_integer::<A, 11, 0>(self.frame_width.val());
        self.two_rows.next = self.row.val() + self.row.val();
        self.offset.next = self.zero.val();
        self.step.next = 0u64.into();
        self.backward.next = self.falling.val();
        if self.lane.val() == 1u64.into() {
            self.offset.next = self.one.val();
        } else if self.lane.val() == 2u64.into() {
            self.offset.next = self.one.val();
            self.backward.next = !self.falling.val();
        } else if self.lane.val() == 3u64.into() {
            self.offset.next = self.two.val();
            self.backward.next = self.falling.val() ^ self.below.val();
        }
        if self.lane.val() == 3u64.into() {
            self.step.next = self.two_rows.val();
            if self.steep.val() {
                self.step.next = self.two_words.val();
            }
        } else if self.lane.val().any() {
            self.step.next = self.row.val();
            if self.steep.val() {
                self.step.next = self.one_word.val();
            }
        }
        if self.backward.val() {
            self.across.next = self.minor.val() - self.offset.val();
            self.place.next = self.address.val() - self.step.val();
        } else {
            self.across.next = self.minor.val() + self.offset.val();
            self.place.next = self.address.val() + self.step.val();
        }
        self.column.next = self.major.val();
        self.line.next = self.across.val();
        if self.steep.val() {
            self.column.next = self.across.val();
            self.line.next = self.major.val();
        }
        self.x.next = unsigned_cast_integer::<11, 11, 0>(self.column.val());
        self.y.next = unsigned_cast_integer::<11, 11, 0>(self.line.val());
        self.in_frame.next = !(self.column.val() < self.zero.val())
            && !(self.line.val() < self.zero.val())
            && (self.column.val() < self.frame_width.val())
            && (self.line.val() < self.frame_height.val());
    }
}

crate::ports!(LanePlace<A>, const A: usize;
    inputs lane, below, major, minor, address, steep, falling, frame_width, frame_height;
    outputs x, y, place, in_frame);

/// A pixel's place, as [`LanePlace`] gives it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Placed {
    /// Column.
    pub x: u64,
    /// Row.
    pub y: u64,
    /// Frame address.
    pub address: u64,
    /// In the frame.
    pub inside: bool,
}

/// Integer model of [`LanePlace`] for addresses of `address_bits`.
#[must_use]
pub fn place_model(
    at: &super::walk_model::WalkPosition,
    lane: u64,
    below: bool,
    frame: [i64; 2],
    address_bits: usize,
) -> Placed {
    use crate::format::{mask, wrap};
    let (distance, before) = match lane {
        0 => (0, at.falling),
        1 => (1, at.falling),
        2 => (1, !at.falling),
        _ => (2, at.falling ^ below),
    };
    let offset = if before { -distance } else { distance };
    let across = wrap(at.minor + offset, 12);
    let step = offset.wrapping_mul(if at.steep { 1 } else { frame[0] });
    let (x, y) = if at.steep {
        (across, at.major)
    } else {
        (at.major, across)
    };
    Placed {
        x: x as u64 & mask(11),
        y: y as u64 & mask(11),
        address: at.address.wrapping_add(step as u64) & mask(address_bits),
        inside: (0..frame[0]).contains(&x) && (0..frame[1]).contains(&y),
    }
}
