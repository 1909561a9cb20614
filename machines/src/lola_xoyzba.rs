use pp_runtime::machine;

machine! {
    /// LOLA X'OYZBA: both rotary axes in the head, their centre lines meeting at the gauge point.
    ///
    /// The papers' `L_t` is the gauge length of the tool (Maletić and Živanović 2023).
    pub struct LolaXoyzba;
    chain: X | Y Z B A;

    // `P` of the paper is the gauge point: (7) X = P_x, Y = P_y, Z = P_z - L_t. Equation (12) is printed with sin(A),
    // which contradicts (9).
    verify "Maletić and Živanović 2023, LOLA X'OYZBA, eqs. (8)-(14)" {
        i = sin(B) * cos(A);
        j = -sin(A);
        k = cos(B) * cos(A);
        x = X - gauge * sin(B) * cos(A);
        y = Y + gauge * sin(A);
        z = Z + gauge - gauge * cos(B) * cos(A);
        A = asin(-j);
        B = atan2(i, k);
        X = x + gauge * sin(B) * cos(A);
        Y = y - gauge * sin(A);
        Z = z + gauge * cos(B) * cos(A) - gauge;
    }
}
