use pp_runtime::machine;

machine! {
    /// MultiProDesk A'Y'OXZ: a rotary table on a cross slide, four axes.
    ///
    /// Positive words move table and slide in the positive direction, opposite to ISO 841 (Maletić and Živanović 2023).
    pub struct MultiProDesk;
    chain: A Y | X Z;
    signs = { A: -, Y: - };
    limits = { A: free };

    // (15) to (17) are printed with open constants a_i, b_i, c_i, and (15) without X, on which x depends. Here the
    // centre line of A is at (y_a, z_a) = (-part_y, -part_z) in workpiece coordinates. (18) is A; the inverse of (15)
    // to (17) follows it.
    verify "Maletić and Živanović 2023, MultiProDesk A'Y'OXZ, eqs. (12)-(18)" {
        i = 0;
        j = sin(A);
        k = cos(A);
        x = X;
        y = sin(A) * (Z + part_z) - cos(A) * (Y - part_y) - part_y;
        z = sin(A) * (Y - part_y) + cos(A) * (Z + part_z) - part_z;
        A = atan2(j, k);
        X = x;
        Y = sin(A) * (z + part_z) - cos(A) * (y + part_y) + part_y;
        Z = cos(A) * (z + part_z) + sin(A) * (y + part_y) - part_z;
    }
}
