//! Machines whose kinematics in C are compared: those of the papers and of the library, and chains of every kind that
//! is accepted.

/// A test of each machine; `name: { declaration };` declares one.
macro_rules! agree {
    ($($name:ident: { $($declaration:tt)* };)*) => {
        $(
            mod $name {
                pp_runtime::machine! {
                    pub(super) struct Chain;
                    $($declaration)*
                }

                #[test]
                fn agrees() {
                    crate::c_header::agrees::<Chain>(stringify!($name).len() as u64);
                }
            }
        )*
    };
}

mod of_the_papers {
    #[test]
    fn agree() {
        crate::c_header::agrees::<machines::SpinnerU5620>(1);
        crate::c_header::agrees::<machines::Dmu70e>(2);
        crate::c_header::agrees::<machines::LolaXoyzba>(3);
        crate::c_header::agrees::<machines::MultiProDesk>(4);
    }
}

mod of_the_library {
    use machine_library as library;

    #[test]
    fn agree() {
        crate::c_header::agrees::<library::BridgeMill>(5);
        crate::c_header::agrees::<library::HaasRotary>(6);
        crate::c_header::agrees::<library::HaasTrunnion>(7);
        crate::c_header::agrees::<library::HaasUmc>(8);
        crate::c_header::agrees::<library::IntegrexI200>(9);
        crate::c_header::agrees::<library::Max5>(10);
        crate::c_header::agrees::<library::ObliqueYLathe>(11);
        crate::c_header::agrees::<library::PocketNcV2>(12);
        crate::c_header::agrees::<library::XyzabTdr>(13);
        crate::c_header::agrees::<library::XyzacTrt>(14);
        crate::c_header::agrees::<library::XyzacbTrsrn>(15);
        crate::c_header::agrees::<library::XyzbcTrt>(16);
    }
}

agree! {
    // Tables, heads and both, orthogonal.
    table_cb: { chain: C B | X Y Z; d = { C: (12, -7, 0), B: (0, 5, 150) }; };
    table_ca: { chain: C A | X Y Z; d = { C: (0, 0, 0), A: (0, 12.5, -60) }; limits = { A: -120..30 }; };
    table_ab: { chain: A B | X Y Z; d = (1, 2, 3); signs = { A: -, B: - }; };
    table_ba: { chain: B A | X Y Z; d = (1, 2, 3); signs = { Z: - }; };
    head_cb: { chain: X Y | Z C B; d = { C: (0, 0, 200), B: (3, 12.5, 180) }; };
    head_ca: { chain: | X Y Z C A; d = (0, 0, 150); signs = { C: - }; };
    head_ab: { chain: X | Y Z A B; d = { A: (0, 0, 180), B: (0, 0, 150) }; };
    head_and_table: { chain: C | X Y Z B; d = { C: (0, 0, 0), B: (8, 0, 140) }; };
    head_and_table_a: { chain: A Y | X Z B; d = { A: (0, 5, -60), B: (0, 0, 180) }; signs = { A: -, Y: - }; };
    all_in_the_table: { chain: C B Z Y X |; d = (0, 0, 150); };
    // Rotary axes between the linear ones.
    between_1: { chain: X A Y B | Z; d = { A: (7.5, -2.25, -120.75), B: (10.5, -7.5, 36.75) }; };
    between_2: { chain: Y B | X Z A; d = { B: (9, 7.5, 120.75), A: (-9, 3, -36.75) }; signs = { X: - }; };
    between_3: { chain: C X B | Y Z; d = { C: (1, 2, 0), B: (5, 6, 70) }; };
    // Inclined axes.
    nutating_table: { chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; d = (0, 0, d); dims = { d: 150.0 }; };
    nutating_head: { chain: X Y | Z C B; axes = { B: Rx(45 deg) * Y }; d = { C: (0, 0, 200), B: (0, 12.5, 180) }; };
    nutating_60: { chain: C A | X Y Z; axes = { A: Ry(60 deg) * X }; d = (0, 3, 80); };
    nutating_mixed: { chain: A Y | X Z B; axes = { B: Ry(30 deg) * Rx(-45 deg) * Y }; d = { A: (0, 5, -60), B: (0, 0, 180.25) }; };
    angle_dimension: {
        chain: C B | X Y Z; axes = { B: Rx(alpha) * Y };
        d = { C: (0, 0, d), B: (0, e, d - 10) }; dims = { alpha: -45 deg, d: 150.0, e: -2.5 };
    };
    oblique_table: { chain: A B | X Y Z; axes = { A: (1, 2, 2), B: (2, -6, 3) }; d = { A: (0, 0, 0), B: (1.5, -7, 60.5) }; };
    oblique_pair: {
        chain: C X | Y Z A; axes = { C: (3, -5, 8), A: (9, 4, -2), X: (10, 1, 0) };
        d = { C: (10, 20, 30), A: (0, 10, 30) }; tool_axis = (0.6, 0, 0.8);
    };
    slanted_y: { chain: C B | X Y Z; axes = { Y: (0, 1, -0.5) }; d = (10, 20, -30); signs = { Y: - }; };
    slanted_angle: { chain: A | X Y Z B; axes = { Y: Rx(slant) * Y }; d = { A: (0, 0, 20), B: (0, 0, 90) }; dims = { slant: 30 deg }; };
    // Other tool axes.
    horizontal: { chain: B A | X Y Z; tool_axis = (0, 1, 0); d = { B: (0, 0, 0), A: (0, 40, 0) }; };
    tool_along_x: { chain: C | X Y Z B; tool_axis = (1, 0, 0); d = { C: (0, 0, 0), B: (10, 0, 40) }; };
    // Fewer rotary axes.
    one_in_the_table: { chain: A Y | X Z; signs = { A: -, Y: - }; d = (0, 7, 30); };
    one_in_the_head: { chain: X Y | Z B; d = (0, 0, 120); };
    one_oblique: { chain: X A Y | Z; axes = { A: (2, 1, 2) }; d = (1, 2, 3); };
    one_slim: { chain: X Y | Z A; axes = { A: (0.000001, 0, 1) }; d = (1, 2, 3); };
    none: { chain: X Y | Z; signs = { X: - }; };
    // Held axes.
    quill: { chain: C B | X Y Z W; d = (0, 7, 30); hold = { W: 25 }; };
    set_by_hand: {
        chain: C B | X Y Z A; d = { C: (0, 0, 0), B: (0, 7, 30), A: (0, 0, 90) }; hold = { A: 15 }; signs = { A: - };
    };
    held_between: { chain: V C A B | X Y Z; d = { C: (0, 0, 0), A: (0, 7, 30), B: (0, 0, 90) }; hold = { V: -12.5, A: 0 }; };
    held_in_the_way: { chain: A | X Y Z C B; d = { A: (0, 0, 0), C: (0, 0, 200), B: (0, 10, 180) }; hold = { A: 0 }; };
    // Names that mean something in C.
    words_of_c: {
        chain: C B | X Y Z; d = { C: (int, linux, dim_int), B: (sin_b, m, count) }; axes = { C: Rx(switch) * Z };
        dims = { int: 1, linux: 2, m: 3, count: 4, dim_int: 5, sin_b: 6, switch: 7 deg };
    };
}
