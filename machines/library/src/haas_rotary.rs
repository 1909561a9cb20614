use pp_runtime::machine;

machine! {
    /// A vertical mill of Haas with a rotary table along X: four axes.
    ///
    /// The source has A without limits and with the direction of ISO 841; it permits it to be reversed: compare it with
    /// the jog sheet, and write `-` if it is. The mill is taken as table X on saddle Y, head Z.
    ///
    /// Reference point: on the centre line of A. There is nothing to measure but the part origin.
    ///
    /// Source: Autodesk, post for Haas Next Generation, `defineMachine`
    /// (cam.autodesk.com/hsmposts?p=haas_next_generation).
    pub struct HaasRotary;
    chain: A X Y | Z;
    limits = { A: free };
}
