use pp_runtime::machine;

machine! {
    /// Pocket NC V2: a rotary table B on a tilting table A.
    ///
    /// A and B of its kinematics are opposite to ISO 841. Travel is that of `versions/v2revP/PocketNC.ini`, which is in
    /// inches. The source does not state which slides carry the table: compare X, Y and Z with the jog sheet. That the
    /// spindle is horizontal and Y is up is from general knowledge.
    ///
    /// Reference point: where the centre lines of A and B meet, as in the source; a distance between them is not in the
    /// model.
    ///
    /// Source: github.com/PocketNC/Settings, `features/five_axis_kinematics/pocketnckins.c`.
    pub struct PocketNcV2;
    chain: B A | X Y Z;
    signs = { B: -, A: - };
    limits = { A: -25..135, B: -9999..99999, X: -50.8..64.77, Y: -60.96..66.04, Z: -87.63..2.54 };
    up = Y;

    // Tip and joints of the source count from the point where A and B meet; its joint Z is that of the spindle nose.
    verify "PocketNC pocketnckins.c, kinematicsForwardFromState" {
        i = -sin(B) * cos(A);
        j = sin(A);
        k = cos(B) * cos(A);
        x + part_x = (X + part_x) * cos(B) + (Y + part_y) * sin(B) * sin(A) - (Z + part_z) * sin(B) * cos(A);
        y + part_y = (Y + part_y) * cos(A) + (Z + part_z) * sin(A);
        z + part_z = (X + part_x) * sin(B) - (Y + part_y) * cos(B) * sin(A) + (Z + part_z) * cos(B) * cos(A);
    }

    verify "PocketNC pocketnckins.c, kinematicsInverseFromState" {
        X + part_x = (x + part_x) * cos(B) + (z + part_z) * sin(B);
        Y + part_y = (x + part_x) * sin(B) * sin(A) + (y + part_y) * cos(A) - (z + part_z) * cos(B) * sin(A);
        Z + part_z = -(x + part_x) * sin(B) * cos(A) + (y + part_y) * sin(A) + (z + part_z) * cos(B) * cos(A);
    }
}
