use pp_runtime::machine;

machine! {
    /// Spinner U5-620: a rotary table on a tilting table.
    ///
    /// `d` is the height of both centre lines above the table's reference point (My et al.). Its 150 mm are assumed:
    /// the paper gives no value.
    pub struct SpinnerU5620;
    chain: C B | X Y Z;
    d = (0, 0, d);
    dims = { d: 150.0 };
    limits = { B: -5..110, C: free };

    // The first sign of (4) is restored: copies of the paper have lost it.
    verify "My et al., Spinner U5-620, tool axis and eqs. (1)-(5)" {
        i = sin(B) * cos(C);
        j = sin(B) * sin(C);
        k = cos(B);
        C = atan2(j, i);
        B = acos(k);
        X = x * cos(B) * cos(C) + y * cos(B) * sin(C) - z * sin(B) + d * sin(B);
        Y = -x * sin(C) + y * cos(C);
        Z = x * sin(B) * cos(C) + y * sin(B) * sin(C) + z * cos(B) - d * cos(B) + d;
    }
}
