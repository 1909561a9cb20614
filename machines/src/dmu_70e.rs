use pp_runtime::machine;

machine! {
    /// Deckel Maho DMU 70e: a rotary table on a table that turns about an axis inclined by 45°.
    ///
    /// The tool tilts by up to 90° while B makes half a turn (My et al.).
    pub struct Dmu70e;
    chain: C B | X Y Z;
    axes = { B: Rx(-45 deg) * Y };
    d = (0, 0, d);
    dims = { d: 150.0 };
    limits = { B: 0..180, C: free };
}
