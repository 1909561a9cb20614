use pp_runtime::machine;

machine! {
    /// Spinner U5-620: a rotary table on a tilting table.
    ///
    /// `d` is the height of both centre lines above the table's reference point (My et al.).
    pub struct SpinnerU5620;
    chain: C B | X Y Z;
    d = (0, 0, d);
    dims = { d: 150.0 };
    limits = { B: -5..110, C: free };
}
