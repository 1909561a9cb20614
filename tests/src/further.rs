//! Machines of kinds that the source papers do not have.

use pp_runtime::machine;

machine! {
    /// A and C in the table.
    pub struct Trunnion;
    chain: C A | X Y Z;
    d = { C: (0, 0, 0), A: (0, 12.5, -60) };
    limits = { A: -120..30 };
}

machine! {
    /// B in the head, C in the table.
    pub struct HeadTable;
    chain: C | X Y Z B;
    d = { C: (0, 0, 0), B: (8, 0, 140) };
}

machine! {
    /// A nutating head with an inclined slide, a held quill and a held rotary axis of the table.
    pub struct Inclined;
    chain: A X | Y V W C B;
    axes = { V: Rx(30 deg) * Z, B: Rx(45 deg) * Y };
    d = { C: (0, 0, 210), B: (0, 25, 180), A: (10, -20, -30) };
    hold = { W: 25, A: 15 };
    limits = { B: -10..190 };
    speeds = { X: 12000, Y: 12000, V: 8000, C: 3600, B: 3600 };
}

machine! {
    /// A head that nutates about an axis inclined by 45°.
    pub struct NutatingHead;
    chain: X | Y Z C B;
    axes = { B: Rx(45 deg) * Y };
    d = { C: (0, 0, 210), B: (0, 25, 180) };
}

machine! {
    /// Three axes.
    pub struct Mill;
    chain: X Y | Z;
}
