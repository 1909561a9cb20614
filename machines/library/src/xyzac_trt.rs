use pp_runtime::machine;

machine! {
    /// A mill with a rotary table on a table that tilts about X: `xyzac-trt-kins` of LinuxCNC.
    ///
    /// Chain: `table-x`, `saddle-y` and `spindle-z` of `xyzac-trt.ini`; travel from the same file. A and C of the
    /// module are opposite to ISO 841 (`conventional-directions` = 0, its default).
    ///
    /// Reference point: the centre of the table top at A 0. Measure `y_offset` and `z_offset`, from there to the centre
    /// line of A; they are the pins of these names.
    ///
    /// Source: LinuxCNC, `src/emc/kinematics/trtfuncs.c`, `configs/sim/axis/vismach/5axis/table-rotary-tilting/`.
    pub struct XyzacTrt;
    chain: C A X Y | Z;
    d = { C: (0, 0, 0), A: (0, y_offset, z_offset) };
    dims = { y_offset: required, z_offset: required };
    signs = { C: -, A: - };
    limits = { A: -100..50, C: -36000..36000, X: -200..200, Y: -100..100, Z: -120..120 };

    // Tip and joints of the module count from the point `*-rot-point`, here the reference point; its joint Z is that of
    // the spindle nose, so that `tool-offset` cancels.
    verify "LinuxCNC trtfuncs.c, xyzacKinematicsForward, con = -1" {
        i = sin(C) * sin(A);
        j = cos(C) * sin(A);
        k = cos(A);
        x + part_x = cos(C) * (X + part_x) + sin(C) * cos(A) * (Y + part_y - y_offset)
            + sin(C) * sin(A) * (Z + part_z - z_offset) + sin(C) * y_offset;
        y + part_y = -sin(C) * (X + part_x) + cos(C) * cos(A) * (Y + part_y - y_offset)
            + cos(C) * sin(A) * (Z + part_z - z_offset) + cos(C) * y_offset;
        z + part_z = -sin(A) * (Y + part_y - y_offset) + cos(A) * (Z + part_z - z_offset) + z_offset;
    }

    verify "LinuxCNC trtfuncs.c, xyzacKinematicsInverse, con = -1" {
        X + part_x = cos(C) * (x + part_x) - sin(C) * (y + part_y);
        Y + part_y = sin(C) * cos(A) * (x + part_x) + cos(C) * cos(A) * (y + part_y) - sin(A) * (z + part_z)
            - cos(A) * y_offset + sin(A) * z_offset + y_offset;
        Z + part_z = sin(C) * sin(A) * (x + part_x) + cos(C) * sin(A) * (y + part_y) + cos(A) * (z + part_z)
            - sin(A) * y_offset - cos(A) * z_offset + z_offset;
    }
}
