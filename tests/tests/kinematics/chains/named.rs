//! Chains that the 240 orders leave out: inclined and oblique rotaries, slanted linear axes, fewer rotaries, held axes,
//! dimensions that are angles.

use pp_runtime::machine;
use tests::conformance;

machine! {
    /// Nutating table: B at 45° in the YZ plane; the tool never goes below horizontal.
    struct NutatingTable;
    chain: C B | X Y Z;
    axes = { B: Rx(-45 deg) * Y };
    d = (0, 0, d);
    dims = { d: 150.0 };
}
conformance!(NutatingTable, nutating_table);

machine! {
    /// Nutating head: C carries a B at 45°.
    struct NutatingHead;
    chain: X Y | Z C B;
    axes = { B: Rx(45 deg) * Y };
    d = { C: (0, 0, 200), B: (0, 12.5, 180) };
}
conformance!(NutatingHead, nutating_head);

machine! {
    /// One rotary in the table, one nutating rotary in the head.
    struct NutatingMixed;
    chain: A Y | X Z B;
    axes = { B: Ry(30 deg) * Rx(-45 deg) * Y };
    d = { A: (0, 5, -60), B: (0, 0, 180.25) };
    signs = { A: -, B: - };
}
conformance!(NutatingMixed, nutating_mixed);

machine! {
    /// The angle of the inclined rotary is a dimension.
    struct SymbolicAngle;
    chain: C B | X Y Z;
    axes = { B: Rx(alpha) * Y };
    d = { C: (0, 0, d), B: (0, e, d - 10) };
    dims = { alpha: -45 deg, d: 150.0, e: -2.5 };
}
conformance!(SymbolicAngle, symbolic_angle);

machine! {
    /// Slant bed: Y is inclined.
    struct SlantedLinear;
    chain: C B | X Y Z;
    axes = { Y: (0, 1, -0.5) };
    d = (10, 20, -30);
    signs = { Y: - };
}
conformance!(SlantedLinear, slanted_linear);

machine! {
    /// Two rotaries in general directions, and a tool that is not along Z.
    struct ObliquePair;
    chain: C X | Y Z A;
    axes = { C: (3, -5, 8), A: (9, 4, -2), X: (10, 1, 0) };
    d = { C: (10, 20, 30), A: (0, 10, 30) };
    tool_axis = (0.6, 0, 0.8);
    signs = { A: - };
}
conformance!(ObliquePair, oblique_pair);

machine! {
    /// Two oblique rotaries in the table.
    struct ObliqueTable;
    chain: A B | X Y Z;
    axes = { A: (1, 2, 2), B: (2, -6, 3) };
    d = { A: (0, 0, 0), B: (1.5, -7, 60.5) };
}
conformance!(ObliqueTable, oblique_table);

machine! {
    /// Horizontal spindle along Y.
    struct HorizontalSpindle;
    chain: B A | X Y Z;
    tool_axis = (0, 1, 0);
    d = { B: (0, 0, 0), A: (0, 40, 0) };
}
conformance!(HorizontalSpindle, horizontal_spindle);

machine! {
    /// One rotary in the table, two axes with negative signs.
    struct OneRotary;
    chain: A Y | X Z;
    signs = { A: -, Y: - };
    d = (0, 7, 30);
}
conformance!(OneRotary, one_rotary);

machine! {
    /// One rotary in the head.
    struct OneRotaryInTheHead;
    chain: X Y | Z B;
    d = (0, 0, 120);
}
conformance!(OneRotaryInTheHead, one_rotary_in_the_head);

machine! {
    /// One rotary that is perpendicular to no other axis.
    struct OneObliqueRotary;
    chain: X A Y | Z;
    axes = { A: (2, 1, 2) };
    d = (1, 2, 3);
}
conformance!(OneObliqueRotary, one_oblique_rotary);

machine! {
    /// Three axes.
    struct NoRotary;
    chain: X Y | Z;
    signs = { X: - };
}
conformance!(NoRotary, no_rotary);

machine! {
    /// Table of two rotaries and a quill.
    struct HeldQuill;
    chain: C B | X Y Z W;
    d = (0, 7, 30);
    hold = { W: 25 };
}
conformance!(HeldQuill, held_quill);

machine! {
    /// Table of two rotaries and a head that is set by hand.
    struct HeldHead;
    chain: C B | X Y Z A;
    d = { C: (0, 0, 0), B: (0, 7, 30), A: (0, 0, 90) };
    hold = { A: 15 };
    signs = { A: - };
}
conformance!(HeldHead, held_head);

machine! {
    /// Two held axes, one of them between the rotaries.
    struct HeldBetween;
    chain: V C A B | X Y Z;
    d = { C: (0, 0, 0), A: (0, 7, 30), B: (0, 0, 90) };
    hold = { V: -12.5, A: 0 };
}
conformance!(HeldBetween, held_between);

machine! {
    /// All axes move the workpiece.
    struct AllInTheTable;
    chain: C B Z Y X |;
    d = (0, 0, 150);
}
conformance!(AllInTheTable, all_in_the_table);

machine! {
    /// All axes move the tool.
    struct AllInTheHead;
    chain: | X Y Z C B;
    d = (0, 0, 150);
}
conformance!(AllInTheHead, all_in_the_head);

machine! {
    /// A trunnion whose height each machine has of its own.
    struct RequiredHeight;
    chain: C B | X Y Z;
    d = { C: (0, 0, 0), B: (offset, 0, height) };
    dims = { height: required, offset: 0.5 };
}
conformance!(RequiredHeight, required_height, sample = { height: 62.5 });
