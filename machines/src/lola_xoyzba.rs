use pp_runtime::machine;

machine! {
    /// LOLA X'OYZBA: both rotary axes in the head, their centre lines meeting at the gauge point.
    ///
    /// The papers' `L_t` is the gauge length of the tool (Maletić and Živanović 2023).
    pub struct LolaXoyzba;
    chain: X | Y Z B A;
}
