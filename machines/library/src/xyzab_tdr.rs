use pp_runtime::machine;

machine! {
    /// A mill with two rotary tables: A on B, `xyzab_tdr_kins` of LinuxCNC.
    ///
    /// Chain: the head moves in X, Y and Z (`xyzab-tdr-gui.py`); travel from `xyzab-tdr.ini`.
    ///
    /// Reference point: the centre of the face of A at B 0. Measure `x_offset` and `z_offset`, from the centre line of
    /// B to there; they are the pins of these names.
    ///
    /// Source: LinuxCNC, `src/hal/components/xyzab_tdr_kins.comp`, `configs/sim/axis/vismach/5axis/table-dual-rotary/`.
    pub struct XyzabTdr;
    chain: A B | X Y Z;
    d = { A: (0, 0, 0), B: (-x_offset, 0, -z_offset) };
    dims = { x_offset: required, z_offset: required };
    limits = { A: -3600..3600, B: -180..180, X: -200..200, Y: -200..200, Z: -300..300 };

    // Tip and joints of the module count from the point `*-rot-point` on the centre line of B: the reference point is
    // at (x_offset, 0, z_offset) from there.
    verify "LinuxCNC xyzab_tdr_kins.comp, TCP kinematics forward" {
        i = sin(B);
        j = -sin(A) * cos(B);
        k = cos(A) * cos(B);
        x + part_x + x_offset = cos(B) * (X + part_x + x_offset) + sin(B) * (Z + part_z + z_offset);
        y + part_y = sin(A) * sin(B) * (X + part_x + x_offset) + cos(A) * (Y + part_y)
            - cos(B) * sin(A) * (Z + part_z + z_offset) + sin(A) * z_offset;
        z + part_z + z_offset = -cos(A) * sin(B) * (X + part_x + x_offset) + sin(A) * (Y + part_y)
            + cos(A) * cos(B) * (Z + part_z + z_offset) - cos(A) * z_offset + z_offset;
    }

    // `x - dx` and `z - dz` of the source are the coordinates from the centre of the face of A.
    verify "LinuxCNC xyzab_tdr_kins.comp, TCP kinematics inverse" {
        X + part_x + x_offset = cos(B) * (x + part_x) + sin(A) * sin(B) * (y + part_y) - cos(A) * sin(B) * (z + part_z)
            + cos(B) * x_offset - sin(B) * z_offset;
        Y + part_y = cos(A) * (y + part_y) + sin(A) * (z + part_z);
        Z + part_z + z_offset = sin(B) * (x + part_x) - sin(A) * cos(B) * (y + part_y) + cos(A) * cos(B) * (z + part_z)
            + sin(B) * x_offset + cos(B) * z_offset;
    }
}
