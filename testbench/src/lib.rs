//! Runs cores beside the reference renderer and says where their frames differ.

pub mod compare;
