use pp_runtime::machine;

machine! {
    /// Mazak INTEGREX i-200: a turning centre with a milling head, main spindle as C.
    ///
    /// The source has the travel of B and Y, and C without limits. At B 0 the tool is along Z and faces the main
    /// spindle, at B 90 it is along X: that follows from the travel of B, which is symmetrical about 90. C is taken as
    /// in ISO 841. The source does not state the order of the slides of the head. That X is vertical is from general
    /// knowledge. X words are those of the milling mode, radii, not diameters.
    ///
    /// Reference point: the centre of the face of the main spindle. Measure `head_x` and `head_z`, from the gauge line
    /// of the milling spindle at B 0 to the centre line of B.
    ///
    /// Source: Autodesk, post for Mazak Integrex i, `defineMachine` and `onOpen`
    /// (cam.autodesk.com/hsmposts?p=mazak_integrex_i).
    pub struct IntegrexI200;
    chain: C | Z X Y B;
    d = { C: (0, 0, 0), B: (head_x, 0, head_z) };
    dims = { head_x: required, head_z: required };
    limits = { B: -30..210, C: free, Y: -130..130 };
    up = X;
}
