//! Edits of posted programs, as an operator or an editor could make them, and the harm that each does.
//!
//! - [`rows`]: codes, words and lines of each control, those that are posted and many that are not.
//! - [`places`]: the state of the control at each line, so that edits meet every state and not the most frequent ones.
//! - [`posted`]: the programs, and their check.
//! - [`operations`]: insertions, deletions, exchanges and changes of numbers and codes.
//! - [`verdict()`]: the traces of the program before and after an edit, compared.
//!
//! Whether an edit is harmful is decided by the [foreign interpreter](crate::foreign), which shares no code with the
//! product; no table here is that of the product.

pub mod operations;
pub mod places;
pub mod posted;
pub mod rows;
pub mod verdict;

#[cfg(test)]
mod tests;

pub use operations::{Edit, edit, permutation};
pub use places::Subject;
pub use posted::{Case, Posted};
pub use verdict::{Allowed, Verdict, restarts_differ, verdict};

/// A message without its numbers, the same for all of a kind.
#[must_use]
pub fn without_numbers(text: &str) -> String {
    let mut kind = String::new();
    for letter in text.chars() {
        match letter {
            '0'..='9' if kind.ends_with('#') => {}
            '0'..='9' => kind.push('#'),
            '.' | '-' if kind.ends_with('#') => {}
            letter => kind.push(letter),
        }
    }
    kind
}
