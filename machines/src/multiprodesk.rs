use pp_runtime::machine;

machine! {
    /// MultiProDesk A'Y'OXZ: a rotary table on a cross slide, four axes.
    ///
    /// Table and slide run with their words, against ISO 841 (Maletić and Živanović 2023).
    pub struct MultiProDesk;
    chain: A Y | X Z;
    signs = { A: -, Y: - };
    limits = { A: free };
}
