use pp_runtime::machine;

machine! {
    /// A mill with a tilting head B and a rotary table C: `maxkins` of LinuxCNC.
    ///
    /// Chain: C on the table X on the saddle Y, the head in Z (`max5gui.py`); travel from `max5_base.inc`. B of the
    /// module is opposite to ISO 841 (`conventional-directions` = 0, its default).
    ///
    /// Measure `pivot_length`, from the centre line of B to the gauge line; the pin of this name is the sum of it and
    /// the tool length. The reference point of the table is on the centre line of C.
    ///
    /// Source: LinuxCNC, `src/emc/kinematics/maxkins.c`, `configs/sim/axis/vismach/5axis/max5/`.
    pub struct Max5;
    chain: C X Y | Z B;
    d = { C: (0, 0, 0), B: (0, 0, pivot_length) };
    dims = { pivot_length: required };
    signs = { B: - };
    limits = { B: -90..90, C: -3600..3600, X: -100..200, Y: -60..60, Z: -149..1 };

    // The forward kinematics of the module add the offset of the head after the rotation of C: they contradict the
    // inverse where neither B nor C is zero, and only the inverse moves the machine.
    verify "LinuxCNC maxkins.c, kinematicsInverse, con = -1, U V W = 0" {
        X + part_x = cos(C) * (x + part_x) + sin(C) * (y + part_y) - (pivot_length + gauge) * sin(B);
        Y + part_y = -sin(C) * (x + part_x) + cos(C) * (y + part_y);
        Z = z + (pivot_length + gauge) * cos(B) - pivot_length - gauge;
    }
}
