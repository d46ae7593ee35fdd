//! Pictures in the texture memory: blocks of two by two texels, one in each of four banks.

use super::build::Triangle;
use shadegate_hdl::texture::{select, Texturing, MAX_SIDE};
use std::sync::Arc;

/// A picture as the texture memory holds it: rows from the bottom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns, a power of two up to [`MAX_SIDE`].
    pub width: usize,
    /// Rows, likewise.
    pub height: usize,
    /// Red, green, blue, row by row.
    pub texels: Vec<[u8; 3]>,
}

impl Picture {
    /// One white texel: what triangles without a texture are covered with.
    #[must_use]
    pub fn white() -> Self {
        Self {
            width: 1,
            height: 1,
            texels: vec![[255; 3]],
        }
    }

    /// Words that it takes in each of the four banks.
    #[must_use]
    pub fn bank_words(&self) -> usize {
        self.width.div_ceil(2) * self.height.div_ceil(2)
    }

    /// The texel at a column and row, repeated.
    #[must_use]
    pub fn at(&self, x: usize, y: usize) -> [u8; 3] {
        self.texels[(y % self.height) * self.width + x % self.width]
    }

    fn check(&self) -> Result<(), String> {
        let side = |n: usize| n.is_power_of_two() && n <= MAX_SIDE as usize;
        if side(self.width) && side(self.height) && self.texels.len() == self.width * self.height {
            return Ok(());
        }
        Err(format!(
            "a picture of {}x{} texels where the core takes sides of a power of two up to {MAX_SIDE}",
            self.width, self.height
        ))
    }

    /// Its size word: pairs of columns and of rows less one, and the logarithm of the first.
    pub(super) fn size_word(&self) -> u64 {
        let [columns, rows] = [self.width, self.height].map(|n| n.div_ceil(2) as u64);
        (columns - 1) | (rows - 1) << 9 | u64::from(columns.trailing_zeros()) << 18
    }
}

/// Pictures of a list of triangles and where they begin in the banks.
#[derive(Clone, Debug, Default)]
pub(super) struct Pictures(Vec<(Arc<Picture>, usize)>);

impl Pictures {
    /// The different pictures, in order of appearance.
    pub(super) fn new(triangles: &[Triangle]) -> Self {
        let white = Arc::new(Picture::white());
        let mut all = Self::default();
        let mut next = 0;
        for t in triangles {
            let picture = t.covering.as_ref().map_or(&white, |c| &c.picture);
            if all.place(picture).is_none() {
                all.0.push((picture.clone(), next));
                next += picture.bank_words();
            }
        }
        all
    }

    /// Texels that they take.
    fn texels(&self) -> usize {
        4 * self.0.iter().map(|(p, _)| p.bank_words()).sum::<usize>()
    }

    /// Where a picture begins in every bank.
    pub(super) fn place(&self, picture: &Arc<Picture>) -> Option<usize> {
        let same = |(p, _): &&(Arc<Picture>, usize)| Arc::ptr_eq(p, picture) || p == picture;
        self.0.iter().find(same).map(|(_, base)| *base)
    }

    /// Every texel, in order.
    pub(super) fn writes(&self, t: Texturing) -> Result<Vec<(u8, u64)>, String> {
        let (needed, there) = (self.texels(), t.texels());
        if needed > there {
            return Err(format!(
                "the pictures take {needed} texels and the texture memory has {there}"
            ));
        }
        let mut out = vec![(select::WRITE_PLACE, 0)];
        for (p, _) in &self.0 {
            p.check()?;
            let columns = p.width.div_ceil(2);
            for pair in 0..p.bank_words() {
                for bank in 0..4 {
                    let x = 2 * (pair % columns) + bank % 2;
                    let y = 2 * (pair / columns) + bank / 2;
                    let [r, g, b] = p.at(x, y).map(u64::from);
                    out.push((select::TEXEL, r << 16 | g << 8 | b));
                }
            }
        }
        Ok(out)
    }
}
