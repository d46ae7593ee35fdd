//! The multiplier.

use super::instruction::Exponent;

/// Integer model of the multiplier.
#[derive(Clone, Copy, Debug, Default)]
pub struct MultiplierModel {
    x: i64,
    y: i64,
    limbs_left: u8,
    first: bool,
    places: u8,
    product_1: Option<(i64, bool, bool, u8)>,
    total: i64,
    low: u64,
    total_done: Option<u8>,
    window: [u16; 5],
    fine: Option<u8>,
    /// The last product.
    pub product: i64,
}

impl MultiplierModel {
    /// One clock: x, y, limbs of y, places, exponent.
    pub fn clock(&mut self, start: Option<(i64, i64, u8, u8, Exponent)>, exponent: u8) {
        if let Some(fine) = self.fine {
            let whole = self.window.iter().rev().fold(0u128, |v, p| v << 16 | u128::from(*p));
            self.product = (whole >> fine) as i64;
        }
        self.fine = self.total_done.map(|places| {
            let whole = i128::from(self.total) << 64 | i128::from(self.low) << 16;
            let coarse = whole >> (places & 0x70);
            for (k, piece) in self.window.iter_mut().enumerate() {
                *piece = (coarse >> (16 * k)) as u16;
            }
            places & 15
        });
        self.total_done = None;
        if let Some((product, first, last, places)) = self.product_1 {
            self.low = if first {
                0
            } else {
                self.low >> 16 | (self.total as u64 & 0xffff) << 32
            };
            self.total = product + if first { 0 } else { self.total >> 16 };
            self.total_done = last.then_some(places);
        }
        self.product_1 = None;
        if self.limbs_left > 0 {
            let last = self.limbs_left == 1;
            let limb = self.y & 0xffff;
            let limb = if last { limb as i16 as i64 } else { limb };
            self.product_1 = Some((self.x * limb, self.first, last, self.places));
            self.y >>= 16;
            self.first = false;
            self.limbs_left -= 1;
        }
        if let Some((x, y, limbs, places, e)) = start {
            let more = match e {
                Exponent::None => 0,
                Exponent::Once => exponent,
                Exponent::Twice => 2 * exponent,
            };
            self.x = x << 39 >> 39;
            self.y = y;
            self.limbs_left = limbs;
            self.first = true;
            self.places = (places + more) & 127;
        }
    }
}
