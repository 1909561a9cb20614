//! The derivation of a machine's kinematics as a page of text.

use std::io::{self, Write};

use crate::kinematics::{Explanation, Machine};

/// Writes what is known about the kinematics of `M`.
pub(super) fn explain<M: Machine>(out: &mut dyn Write) -> io::Result<()> {
    let Explanation { chain, formulas, branches, singular_set, reachable, degenerate, operations, proofs } =
        M::EXPLANATION;
    writeln!(out, "{}: derivation of the kinematics; formulas in millimetres and radians", M::NAME)?;
    for (title, lines) in [
        ("Chain", chain),
        ("Formulas, in the order of evaluation", formulas),
        ("Branches, in their order", branches),
        ("Where a rotary axis is free", singular_set),
        ("Tool axes within reach", reachable),
        ("Where the linear axes cannot move the tip in every direction", degenerate),
        ("Operations of one inverse", &[*operations].as_slice()),
        ("Proven when this machine was compiled", proofs),
    ] {
        let lines: Vec<&str> = lines.iter().copied().filter(|line| !line.is_empty()).collect();
        if lines.is_empty() {
            continue;
        }
        writeln!(out, "\n{title}")?;
        for line in lines {
            writeln!(out, "    {line}")?;
        }
    }
    Ok(())
}
