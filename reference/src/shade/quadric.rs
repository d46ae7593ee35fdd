//! I(u, v) = a·u² + b·v² + c·uv + d·u + e·v + f over the weights u = λ₁ and v = λ₂ of a triangle, and its forward
//! differences along a row. From six knots at vertices and mid-edges: a = 2(I₀ + I₁ − 2I₀₁), b = 2(I₀ + I₂ − 2I₀₂),
//! c = 4(I₀ + I₁₂ − I₀₁ − I₀₂), d = 4I₀₁ − 3I₀ − I₁, e = 4I₀₂ − 3I₀ − I₂, f = I₀: the ortho-normalised triangle of Hast
//! 2004 (eqs 3.159–3.175), 11 additions and 5 shifts.

/// The six coefficients.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quadric {
    /// Of u².
    pub a: f64,
    /// Of v².
    pub b: f64,
    /// Of uv.
    pub c: f64,
    /// Of u.
    pub d: f64,
    /// Of v.
    pub e: f64,
    /// At vertex 0.
    pub f: f64,
}

/// A value on a row, and its first and second difference.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forward {
    /// At the current pixel.
    pub r: f64,
    /// Change to the next one.
    pub dr: f64,
    /// Change of the change.
    pub d2r: f64,
}

impl Forward {
    /// Moves one pixel to the right: two additions.
    pub fn step(&mut self) {
        self.r += self.dr;
        self.dr += self.d2r;
    }
}

impl Quadric {
    /// Linear, from the values at vertices 0, 1 and 2.
    #[must_use]
    pub fn linear(k: [f64; 3]) -> Self {
        Self {
            d: k[1] - k[0],
            e: k[2] - k[0],
            f: k[0],
            ..Self::default()
        }
    }

    /// From the values at vertices 0, 1, 2 and mid-edges 01, 02, 12.
    #[must_use]
    pub fn quadratic([i0, i1, i2, i01, i02, i12]: [f64; 6]) -> Self {
        Self {
            a: 2.0 * (i0 + i1 - 2.0 * i01),
            b: 2.0 * (i0 + i2 - 2.0 * i02),
            c: 4.0 * (i0 + i12 - i01 - i02),
            d: 4.0 * i01 - 3.0 * i0 - i1,
            e: 4.0 * i02 - 3.0 * i0 - i2,
            f: i0,
        }
    }

    /// The value at weights u, v.
    #[must_use]
    #[inline]
    pub fn value(&self, u: f64, v: f64) -> f64 {
        (self.a * u + self.c * v + self.d) * u + (self.b * v + self.e) * v + self.f
    }

    /// Value and differences at weights u, v of a pixel whose right neighbour has u + `du`, v + `dv`.
    #[must_use]
    #[inline]
    pub fn start(&self, (u, v): (f64, f64), (du, dv): (f64, f64)) -> Forward {
        let half = (self.a * du + self.c * dv) * du + self.b * dv * dv;
        Forward {
            r: self.value(u, v),
            dr: (2.0 * self.a * u + self.c * v + self.d) * du
                + (2.0 * self.b * v + self.c * u + self.e) * dv
                + half,
            d2r: 2.0 * half,
        }
    }
}
