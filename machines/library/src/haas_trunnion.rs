use pp_runtime::machine;

machine! {
    /// A vertical mill of Haas with a trunnion of A and C on its table.
    ///
    /// The source has the travel of A, C without limits, and both directions of ISO 841; it permits either to be
    /// reversed: compare them with the jog sheet, and write `-` for one that is. The mill is taken as table X on saddle
    /// Y, head Z.
    ///
    /// Reference point: the centre of the table top at A 0. Measure `tilt_y` and `tilt_z`, from there to the centre
    /// line of A.
    ///
    /// Source: Autodesk, post for Haas Next Generation, `defineMachine`
    /// (cam.autodesk.com/hsmposts?p=haas_next_generation).
    pub struct HaasTrunnion;
    chain: C A X Y | Z;
    d = { C: (0, 0, 0), A: (0, tilt_y, tilt_z) };
    dims = { tilt_y: required, tilt_z: required };
    limits = { A: -120..30, C: free };
}
