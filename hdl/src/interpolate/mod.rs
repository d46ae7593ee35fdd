//! Interpolants by forward differences: polynomials evaluated on a pixel grid with additions only.
//!
//! | module | function | accumulators | words |
//! |---|---|---|---|
//! | [`constant_1`] | c along a span | 0 | 1 |
//! | [`linear_1`] | c + d·k along a span | 1 | 2 |
//! | [`quadratic_1`] | c + d·k + dd·k(k−1)/2 along a span | 2 | 3 |
//! | [`cubic_1`] | the same + ddd·k(k−1)(k−2)/6 along a span | 3 | 4 |
//! | [`constant_2`] | c over a triangle | 0 | 1 |
//! | [`linear_2`] | a plane over a triangle | 2 | 4 |
//! | [`quadratic_2`] | a quadric over a triangle | 6 | 10 |
//! | [`linear_span`] | c + d·k along spans set up one by one | 1 | 2 |
//! | [`quadratic_span`] | c + d·k + dd·k(k−1)/2 along spans set up one by one | 2 | 3 |
//!
//! The two-variate modules walk lattice steps: from one span start to the next by the *line step* s = (a, 1) or, when
//! the edge walk carries, by s' = (a + 1, 1); along a span by the *pixel step* p = (1, 0). A polynomial's differences
//! along fixed lattice steps are again polynomials of one degree less, so every sample is exact at a pixel centre.
//!
//! Words are signed and of any width up to 64 bits; [`run`] says how far each may run.

pub mod constant_1;
pub mod constant_2;
pub mod cubic_1;
pub mod linear_1;
pub mod linear_2;
pub mod linear_span;
pub mod quadratic_1;
pub mod quadratic_2;
pub mod quadratic_span;
pub mod run;
