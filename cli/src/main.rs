//! The shadegate program.
fn main() {}
