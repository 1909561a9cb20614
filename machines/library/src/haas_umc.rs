use pp_runtime::machine;

machine! {
    /// Haas UMC-500, UMC-750 and UMC-1000: a rotary table on a table that tilts about Y.
    ///
    /// The source has the travel of B, C without limits, and both directions of ISO 841. It does not state which slides
    /// carry the table: compare X, Y and Z with the jog sheet. The travel of older machines ends at B 110.
    ///
    /// Reference point: the centre of the table top at B 0. Measure `tilt_x` and `tilt_z`, from there to the centre
    /// line of B: the machine rotary zero point of the control minus the position of that centre
    /// (`NAME kinematics --haas` compares).
    ///
    /// Source: Autodesk, post for Haas Next Generation, `defineMachineModel`
    /// (cam.autodesk.com/hsmposts?p=haas_next_generation).
    pub struct HaasUmc;
    chain: C B | X Y Z;
    d = { C: (0, 0, 0), B: (tilt_x, 0, tilt_z) };
    dims = { tilt_x: required, tilt_z: required };
    limits = { B: -35..120, C: free };
}
