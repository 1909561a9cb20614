use pp_runtime::machine;

machine! {
    /// A mill with a head of C and B, B inclined by 45°: `xyzacb_trsrn` of LinuxCNC, with its table A at 0.
    ///
    /// Chain: the head moves in X, Y and Z (`xyzacb-trsrn-gui.py`); travel from `xyzacb-trsrn.ini`. `nut-angle` of the
    /// module is
    /// 45. A program does not move the table A.
    ///
    /// Measure at the head, from the gauge line with B and C at zero: `y_pivot` and `z_pivot` to the centre line of B,
    /// and `x_offset` and `y_offset` from there to the centre line of C; they are the pins of these names.
    ///
    /// Source: LinuxCNC, `src/hal/components/xyzacb_trsrn.comp`,
    /// `configs/sim/axis/vismach/5axis/table-rotary_spindle-rotary-nutating/`.
    pub struct XyzacbTrsrn;
    chain: | X Y Z C B;
    axes = { B: Rx(45 deg) * Y };
    d = { C: (x_offset, y_offset + y_pivot, 0), B: (0, y_pivot, z_pivot) };
    dims = { x_offset: required, y_offset: required, y_pivot: required, z_pivot: required };
    limits = { B: -185..185, C: -320..320, X: -5000..5000, Y: -5000..5000, Z: -5000..5000 };

    // Sw = 0 and Cw = 1; Sv = Cv = sqrt(2) / 2, so r = s = (1 + cos B) / 2 and t = (1 - cos B) / 2. The joints of the
    // source are those of the spindle nose: its Dray and Draz cancel with the constants of the same lines.
    verify "LinuxCNC xyzacb_trsrn.comp, TCP kinematics forward, nut-angle 45" {
        i = cos(C) * sin(B) * sqrt(2) / 2 - sin(C) * (1 - cos(B)) / 2;
        j = sin(C) * sin(B) * sqrt(2) / 2 + cos(C) * (1 - cos(B)) / 2;
        k = (1 + cos(B)) / 2;
        x = -(cos(C) * sin(B) * sqrt(2) / 2 - sin(C) * (1 - cos(B)) / 2) * (gauge + z_pivot)
            - cos(C) * x_offset + (cos(C) * sin(B) * sqrt(2) / 2 + sin(C) * (1 + cos(B)) / 2) * y_pivot
            + y_offset * sin(C) + x_offset + X;
        y = -cos(C) * y_offset - x_offset * sin(C) + Y
            - (sin(C) * sin(B) * sqrt(2) / 2 + cos(C) * (1 - cos(B)) / 2) * (gauge + z_pivot)
            + (sqrt(2) / 2 * sin(B) * sin(C) - cos(C) * (1 + cos(B)) / 2) * y_pivot + y_offset + y_pivot;
        z = Z - (1 + cos(B)) / 2 * (gauge + z_pivot) - (1 - cos(B)) / 2 * y_pivot + gauge + z_pivot;
    }

    verify "LinuxCNC xyzacb_trsrn.comp, TCP kinematics inverse, nut-angle 45" {
        X = (cos(C) * sin(B) * sqrt(2) / 2 - sin(C) * (1 - cos(B)) / 2) * (gauge + z_pivot) + cos(C) * x_offset
            - (cos(C) * sin(B) * sqrt(2) / 2 + sin(C) * (1 + cos(B)) / 2) * y_pivot - y_offset * sin(C) - x_offset + x;
        Y = cos(C) * y_offset + x_offset * sin(C) - (y_offset + y_pivot - y)
            + (sin(C) * sin(B) * sqrt(2) / 2 + cos(C) * (1 - cos(B)) / 2) * (gauge + z_pivot)
            - (sqrt(2) / 2 * sin(B) * sin(C) - cos(C) * (1 + cos(B)) / 2) * y_pivot;
        Z = (gauge + z_pivot) * (1 + cos(B)) / 2 + y_pivot * (1 - cos(B)) / 2 - (gauge + z_pivot - z);
    }
}
