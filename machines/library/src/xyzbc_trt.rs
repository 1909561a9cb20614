use pp_runtime::machine;

machine! {
    /// A mill with a rotary table on a table that tilts about Y: `xyzbc-trt-kins` of LinuxCNC.
    ///
    /// Chain: `table-x`, `saddle-y` and `spindle-z` of `xyzbc-trt.ini`; travel from the same file, of B that of its
    /// joint. B and C of the module are opposite to ISO 841 (`conventional-directions` = 0, its default).
    ///
    /// Reference point: the centre of the table top at B 0. Measure `x_offset` and `z_offset`, from there to the centre
    /// line of B; they are the pins of these names.
    ///
    /// Source: LinuxCNC, `src/emc/kinematics/trtfuncs.c`, `configs/sim/axis/vismach/5axis/table-rotary-tilting/`.
    pub struct XyzbcTrt;
    chain: C B X Y | Z;
    d = { C: (0, 0, 0), B: (x_offset, 0, z_offset) };
    dims = { x_offset: required, z_offset: required };
    signs = { C: -, B: - };
    limits = { B: -100..50, C: -36000..36000, X: -200..200, Y: -100..100, Z: -120..120 };

    // Tip and joints of the module count from the point `*-rot-point`, here the reference point; its joint Z is that of
    // the spindle nose, so that `tool-offset` cancels.
    verify "LinuxCNC trtfuncs.c, xyzbcKinematicsForward, con = -1" {
        i = -cos(C) * sin(B);
        j = sin(C) * sin(B);
        k = cos(B);
        x + part_x = cos(C) * cos(B) * (X + part_x - x_offset) + sin(C) * (Y + part_y)
            - cos(C) * sin(B) * (Z + part_z - z_offset) + cos(C) * x_offset;
        y + part_y = -sin(C) * cos(B) * (X + part_x - x_offset) + cos(C) * (Y + part_y)
            + sin(C) * sin(B) * (Z + part_z - z_offset) - sin(C) * x_offset;
        z + part_z = sin(B) * (X + part_x - x_offset) + cos(B) * (Z + part_z - z_offset) + z_offset;
    }
}
