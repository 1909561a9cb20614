//! Exact algebra: numbers, polynomials, matrices, and the expression graph that becomes code.
//!
//! Two representations. [`Poly`] in the normal form of a [`Ring`] *proves*: if the difference of two expressions has
//! remainder zero, they are equal wherever the relations hold and no divisor is zero. A remainder that is not zero does
//! not refute by itself: with `r² = x²` the remainder of `r - x` is not zero, though the root is `x` for every positive
//! `x`. Without roots and without fixed angles it does refute: circles and unit vectors make a ring without divisors of
//! zero.
//!
//! [`Graph`] *computes*: its nodes are printed as Rust one to one, and [`Interpreter`] reads the same nodes back into
//! polynomials, so the formulas that are proven are the ones that run. [`Term`] writes them as formulas. No code is
//! printed from a normal form: `k² → 1 - i² - j²` would lose half the digits near the pole.
//!
//! Knows nothing of machines.
//!
//! # Rules
//!
//! All rewrite rules with their conditions. `tests/rules` has for each a comparison on random values and a case in
//! which it must not apply.
//!
//! | rule | rewrites | only if | where |
//! |---|---|---|---|
//! | `circle` | `cos² → 1 - sin²` | both are of one angle | [`Ring::sin_cos`] |
//! | `unit-vector` | `k² → 1 - i² - j²` | the three are of one unit vector | [`Ring::unit_vector`] |
//! | `root` | `r² → radicand` | `r` was made for this radicand; the sign of `r` is never used | [`Ring::root`] |
//! | `one-root` | two roots of one radicand → one symbol | the radicand is a constant: its root has one value | [`Ring::root`] |
//! | `clear` | `Σ p_m v^m = 0 → Σ p_m d^(n-m) = 0` for `v d = 1` | `d` does not vanish identically | [`Ring::is_zero`] |
//! | `claimed-root` | `√a → value` | `value² = a` exactly, and the caller guarantees `value >= 0` | [`Interpreter::claim`] |
//! | `square-out-of-root` | `√(a² b) → a √b` | the number is rational, not negative, and its square-free part is found | [`Surd::sqrt`] |
//! | `product-of-roots` | `√n √m → g √(n m / g²)`, `g = gcd(n, m)` | `n` and `m` are square-free | [`Surd`] |
//! | `conjugate` | `1/(a + c √b) → (a - c √b)/(a² - b c²)` | the number is not zero | [`Surd::inverse`] |
//! | `exact-sine` | sine and cosine → surds | the angle is a whole multiple of 15° | [`exact_sin_cos`] |
//! | `quarter-turn` | `sin(q 90° ± a)` → `± sin a` or `± cos a` | both are the same exact number of degrees | [`sin_cos_of_degrees`] |
//! | `angle-sum` | `sin(a+b) → sin a cos b + cos a sin b`, and the cosine | each pair is of one angle | [`angle_sum`] |
//! | `fold-numbers` | an operation on numbers → its exact result | no divisor is 0 and no radicand negative | [`Graph`] |
//! | `neutral` | `a + 0`, `a - 0`, `1 a → a`; `0 a`, `0 / b → 0` | the constant is exactly 0 or 1, and `b` not the constant 0 | [`Graph`] |
//! | `cancel` | `a - a → 0` | both are the same node | [`Graph::sub`] |
//! | `signs-outwards` | `(-a) b → -(a b)`, `a + (-b) → a - b`, `-(a - b) → b - a` and the like | the sign is that of a node or a number, never guessed | [`Graph::neg`] |
//! | `merge-factors` | `p (q a) → (p q) a` | `p` and `q` are numbers | [`Graph::mul`] |

mod angle;
mod graph;
mod interpret;
mod matrix;
mod operations;
mod poly;
mod ring;
mod sign;
mod surd;
mod term;

pub use angle::{angle_sum, sin_cos_of_degrees};
pub use graph::{Graph, Id, Node, NodeVector};
pub use interpret::Interpreter;
pub use matrix::{Matrix, PolyVector, rotation, translation};
pub(crate) use operations::Operations;
pub use poly::{Poly, Symbol};
pub use ring::Ring;
pub use sign::{Sign, hidden_zeros_of, sign_of, zeros_of};
pub use surd::{Surd, exact_sin_cos};
pub use term::{GraphBuilder, SineCosine, Term, TermVector};
