//! Equation (12) of Maletić and Živanović 2023 as printed: a sine in place of a cosine.

use pp_runtime::machine;

machine! {
    pub struct Lola;
    chain: X | Y Z B A;
    verify "LOLA X'OYZBA, eq. (12) as printed" {
        X = x + gauge * sin(B) * sin(A);
    }
}

fn main() {}
