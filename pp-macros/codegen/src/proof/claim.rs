//! Check of a single claim.

use crate::symbolic::{Interpreter, Poly};

/// The claim in words as an error, unless both sides are proven to be equal.
pub(crate) fn holds(reader: &Interpreter<'_>, left: &Poly, right: &Poly, claim: &str) -> Result<(), String> {
    if reader.equal(left, right) { Ok(()) } else { Err(claim.to_string()) }
}
