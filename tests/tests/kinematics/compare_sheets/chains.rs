//! Machines of each family.

use pp_runtime::machine;
pub(crate) use tests::further::NutatingHead;

machine! {
    /// A rotary table on a tilting table, centre lines apart.
    pub struct TableCb;
    chain: C B | X Y Z;
    d = { C: (0.5, -7, 0), B: (0, 5, d) };
    dims = { d: 150.0 };
}

machine! {
    /// The same about X; the tables run against ISO 841.
    pub struct TableCaReversed;
    chain: C A X | Y Z;
    d = { C: (1, 2, 3), A: (0, 12.5, -60) };
    signs = { C: -, A: - };
}

machine! {
    /// Three axes move the table.
    pub struct TableAb;
    chain: A B Y X | Z;
    d = { A: (12, 0, 30), B: (4, 5, 6) };
    signs = { B: - };
}

machine! {
    /// An inclined tilting table.
    pub struct NutatingTable;
    chain: C B | X Y Z;
    axes = { B: Rx(-45 deg) * Y };
    d = { C: (1, 2, 3), B: (0, 0, d) };
    dims = { d: 150.0 };
}

machine! {
    /// A tilting table about an axis between X and Z.
    pub struct TableInZx;
    chain: C A | X Y Z;
    axes = { A: Ry(60 deg) * X };
    d = { C: (1, 2, 3), A: (0, 3, 80) };
}

machine! {
    /// A fork head about an axis between X and Y.
    pub struct HeadInXy;
    chain: | X Y Z C B;
    axes = { B: Rz(20 deg) * Y };
    d = { C: (0, 0, 210), B: (3, 25, 180) };
}

machine! {
    /// A fork head.
    pub struct HeadCa;
    chain: X | Y Z C A;
    d = { C: (0, 3, 210), A: (0, -2.5, 180) };
}

machine! {
    /// A fork head whose axes run against ISO 841.
    pub struct HeadAbReversed;
    chain: | X Y Z A B;
    d = { A: (4, 0, 210), B: (0, 0, 150) };
    signs = { A: -, B: - };
}

machine! {
    /// B in the head, C in the table.
    pub struct HeadTable;
    chain: C | X Y Z B;
    d = { C: (3, 4, 0), B: (8, 0, 140) };
}

machine! {
    /// A in the head, B in the table, against ISO 841 and inclined.
    pub struct HeadTableInclined;
    chain: B X | Y Z A;
    axes = { B: Rx(30 deg) * Y };
    d = { A: (0, 7, 140), B: (3, 4, -50) };
    signs = { B: - };
}

machine! {
    /// A horizontal spindle along Y.
    pub struct Horizontal;
    chain: B A | X Y Z;
    tool_axis = (0, 1, 0);
    d = { B: (0, 0, 0), A: (0, 40, 0) };
}

machine! {
    /// One rotary axis in the table.
    pub struct SingleTable;
    chain: A Y | X Z;
    d = (0, 7, 30);
}

machine! {
    /// One rotary axis in the head.
    pub struct SingleHead;
    chain: X Y | Z B;
    d = (2, 0, 120);
}

machine! {
    /// A quill that the transformation does not know.
    pub struct Quill;
    chain: C B | X Y Z W;
    d = (0, 7, 30);
    hold = { W: 0 };
}
