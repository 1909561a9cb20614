//! Types for the derivation of a machine's kinematics, and for its kinematics in C. `machine!` writes both into the
//! generated code as constants; the commands `explain` and `kinematics` print them.

/// Kinematics of a machine as C99.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CSource {
    /// Names of the dimensions in the structure, in the order of [`Machine::DIMENSIONS`](super::Machine::DIMENSIONS):
    /// their own, unless C or a compiler gives that name another meaning.
    pub fields: &'static [&'static str],
    /// Structure and functions. `@` is the place of a prefix for all names.
    pub text: &'static str,
}

impl CSource {
    /// No kinematics in C, for a machine written by hand.
    pub const EMPTY: Self = Self { fields: &[], text: "" };
}

/// One section of an [`Explanation`], as text and as LaTeX.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Section {
    /// Lines of at most 96 columns, except where a single name or number is longer.
    pub text: &'static [&'static str],
    /// Paragraphs; they need the packages `amsmath` and `amssymb`.
    pub latex: &'static [&'static str],
}

impl Section {
    /// An empty section.
    pub const EMPTY: Self = Self { text: &[], latex: &[] };
}

/// Derivation of a machine's kinematics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Explanation {
    /// The chain as declared: directions, centre lines, signs, tool axis.
    pub chain: Section,
    /// Where dimensions, part origin and tool length come from: declaration, configuration, kinematics for a control.
    pub parameters: Section,
    /// The elementary matrices of the joints, and their product.
    pub matrices: Section,
    /// The pose as a function of the axis values.
    pub forward: Section,
    /// The axis values as functions of the pose, branch by branch.
    pub formulas: Section,
    /// The branches in their order.
    pub branches: Section,
    /// Tool axes at which a rotary axis is free.
    pub singular_set: Section,
    /// Tool axes that can be reached.
    pub reachable: Section,
    /// Tool axes at which the linear axes cannot move the tip in every direction.
    pub degenerate: Section,
    /// Claims proven when the machine was compiled.
    pub proofs: Section,
    /// Operations of one call of the inverse kinematics, all branches.
    pub operations: Section,
    /// Check list for the machine: visible direction of motion of each axis.
    pub jog_sheet: Section,
    /// The formulas as `verify` blocks in the language of [`machine!`](crate::machine): a declaration with them
    /// compiles. Not among the [`sections`](Self::sections).
    pub verify: Section,
}

impl Explanation {
    /// Empty sections, for a machine written by hand.
    pub const EMPTY: Self = Self {
        chain: Section::EMPTY,
        parameters: Section::EMPTY,
        matrices: Section::EMPTY,
        forward: Section::EMPTY,
        formulas: Section::EMPTY,
        branches: Section::EMPTY,
        singular_set: Section::EMPTY,
        reachable: Section::EMPTY,
        degenerate: Section::EMPTY,
        proofs: Section::EMPTY,
        operations: Section::EMPTY,
        jog_sheet: Section::EMPTY,
        verify: Section::EMPTY,
    };

    /// All sections with their titles, in the order of reading.
    #[must_use]
    pub const fn sections(&self) -> [(&'static str, &Section); 12] {
        [
            ("Chain", &self.chain),
            ("Where the parameters come from", &self.parameters),
            ("Elementary matrices and their product", &self.matrices),
            ("Forward kinematics", &self.forward),
            ("Inverse kinematics", &self.formulas),
            ("Branches, in their order", &self.branches),
            ("Where a rotary axis is free", &self.singular_set),
            ("Tool axes within reach", &self.reachable),
            (
                "Singular positions of the linear axes (the tool tip cannot be moved in every direction)",
                &self.degenerate,
            ),
            ("Proven when this machine was compiled", &self.proofs),
            ("Operations of one inverse", &self.operations),
            ("Jog sheet", &self.jog_sheet),
        ]
    }
}
