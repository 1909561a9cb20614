use pp_runtime::machine;

machine! {
    /// Deckel Maho DMU 70e: a rotary table on a table that rotates about an axis inclined by 45°.
    ///
    /// The tool tilts by up to 90° while B rotates by 180° (My et al.). The 150 mm of `d` are assumed: the paper
    /// gives no value.
    pub struct Dmu70e;
    chain: C B | X Y Z;
    axes = { B: Rx(-45 deg) * Y };
    d = (0, 0, d);
    dims = { d: 150.0 };
    limits = { B: 0..180, C: free };

    // (6) and (7) are printed for any alpha, but for the B axis of the paper, (0, cos(alpha), sin(alpha)), they are
    // correct at 45° only. For any alpha, with the axis `Rx(alpha) * Y`, these follow:
    //     B = acos((k - sin(alpha)^2) / cos(alpha)^2)
    //     C = atan2(j * cos(alpha) * sin(B) - i * sin(alpha) * cos(alpha) * (1 - cos(B)),
    //               i * cos(alpha) * sin(B) + j * sin(alpha) * cos(alpha) * (1 - cos(B)))
    // Signs of (7), (9) and (13), and (11) as a whole, are restored: copies of the paper have lost them.
    verify "My et al., Deckel Maho DMU 70e, tool axis and eqs. (6)-(9), (11)-(13)" {
        where alpha = -45 deg;
        i = sin(B) * cos(C) / sqrt(2) + sin(C) * (1 - cos(B)) / 2;
        j = sin(B) * sin(C) / sqrt(2) - cos(C) * (1 - cos(B)) / 2;
        k = (1 + cos(B)) / 2;
        B = acos((k - cos(alpha)^2) / sin(alpha)^2);
        C = atan2(
            -(j * sin(alpha) * sin(B) + i * sin(alpha) * cos(alpha) * (1 - cos(B))),
            -i * sin(alpha) * sin(B) + j * sin(alpha) * cos(alpha) * (1 - cos(B))
        );
        B = acos(2 * k - 1);
        C = atan2(
            (1 - k) * i + sqrt(2 * (k - k^2)) * j,
            sqrt(2 * (k - k^2)) * i - (1 - k) * j
        );
        X = sqrt(2) / 2 * (d * sin(B) + x * sin(B) * sin(C) - y * sin(B) * cos(C) - z * sin(B))
            + x * cos(B) * cos(C) + y * cos(B) * sin(C);
        Y = sqrt(2) / 2 * (y * sin(B) * sin(C) + x * sin(B) * cos(C))
            + (-x * cos(B) * sin(C) + y * cos(B) * cos(C) + z * cos(B) - d * cos(B) - x * sin(C) + y * cos(C) - z + d) / 2;
        Z = sqrt(2) / 2 * (y * sin(B) * sin(C) + x * sin(B) * cos(C))
            + (-x * cos(B) * sin(C) + y * cos(B) * cos(C) + z * cos(B) - d * cos(B) + x * sin(C) - y * cos(C) + z + d) / 2;
    }
}
