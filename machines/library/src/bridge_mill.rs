use pp_runtime::machine;

machine! {
    /// A bridge mill with a fork head and a quill along the tool: `5axiskins` of LinuxCNC.
    ///
    /// Chain: bridge in Y, carriage in X, ram in Z, then C, B and the quill W (`5axisgui.py`); travel from `5axis.ini`.
    /// B of the module is opposite to ISO 841, and a positive W moves the tool out of the head. W is held at 0: a
    /// program does not move it.
    ///
    /// Measure `pivot_length`, from the centre line of B to the gauge line with W at zero; the pin of this name is the
    /// sum of it and the tool length.
    ///
    /// Source: LinuxCNC, `src/emc/kinematics/5axiskins.c`, `configs/sim/axis/vismach/5axis/bridgemill/`.
    pub struct BridgeMill;
    chain: | Y X Z C B W;
    d = { C: (0, 0, pivot_length), B: (0, 0, pivot_length) };
    dims = { pivot_length: required };
    hold = { W: 0 };
    signs = { B: -, W: - };
    limits = { B: -120..120, C: -36000..36000, X: -500..500, Y: -500..500, Z: -500..100, W: -100..500 };

    // `s2r(r, C, 180 - B)` is (r sin B cos C, r sin B sin C, -r cos B).
    verify "LinuxCNC 5axiskins.c, fiveaxis_KinematicsForward" {
        i = -sin(B) * cos(C);
        j = -sin(B) * sin(C);
        k = cos(B);
        x = X + (pivot_length + gauge + W) * sin(B) * cos(C);
        y = Y + (pivot_length + gauge + W) * sin(B) * sin(C);
        z = Z + pivot_length + gauge - (pivot_length + gauge + W) * cos(B);
    }

    verify "LinuxCNC 5axiskins.c, fiveaxis_KinematicsInverse" {
        X = x - (pivot_length + gauge + W) * sin(B) * cos(C);
        Y = y - (pivot_length + gauge + W) * sin(B) * sin(C);
        Z = z - pivot_length - gauge + (pivot_length + gauge + W) * cos(B);
    }
}
