//! What the generator knows about a machine, in words.

/// Derivation of a machine's kinematics as text; every line stands for itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Explanation {
    /// The chain as declared, with signs and directions.
    pub chain: &'static [&'static str],
    /// The solved formulas, in the order of evaluation: those of the code.
    pub formulas: &'static [&'static str],
    /// The branches in their order.
    pub branches: &'static [&'static str],
    /// Where the tool axis leaves a rotary free.
    pub singular_set: &'static [&'static str],
    /// Tool axes that can be reached.
    pub reachable: &'static [&'static str],
    /// Where the linear axes cannot move the tip in every direction.
    pub degenerate: &'static [&'static str],
    /// Operations of one call of the inverse kinematics, all branches.
    pub operations: &'static str,
    /// Claims proven when the machine was compiled.
    pub proofs: &'static [&'static str],
}
