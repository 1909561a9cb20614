//! The chapters of the book that have Rust: their listings are documentation tests.

#[doc = include_str!("../../docs/src/embed.md")]
pub struct Embed;
