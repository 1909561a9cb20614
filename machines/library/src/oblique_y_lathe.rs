use pp_runtime::machine;

machine! {
    /// A lathe with driven tools and a slide Y that is carried by X and not perpendicular to it, main spindle as C.
    ///
    /// Source: Heidenhain MANUALplus 620, Technical Manual 1/2012, section 7.12, p. 1441, variant 1 of "Y axis as
    /// oblique axis" (easymanua.ls/heidenhain/manualplus-620/manual/506189?p=1441). The words are positions of the
    /// slides: the transformation of the control, which makes a perpendicular axis of them, must be off. The tool is
    /// along X; X words are radii. The travel belongs to the individual machine.
    ///
    /// Reference point: the centre of the face of the spindle. Measure `slant`, by which the slide Y is inclined
    /// against the perpendicular of X, positive from Y to -X: the angle w of the source minus 90°.
    pub struct ObliqueYLathe;
    chain: C | Z X Y;
    axes = { Y: Rz(slant) * Y };
    tool_axis = (1, 0, 0);
    dims = { slant: required deg };
    limits = { C: free };
}
