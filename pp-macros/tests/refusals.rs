//! A handful of refusals through the real compiler: what it underlines on a stable toolchain.
//!
//! `TRYBUILD=overwrite cargo test -p pp-macros --test refusals` writes the expected messages anew; read them before they
//! are committed. The engine's own tests cover every message.

#[test]
fn mistakes_are_underlined_where_they_stand() {
    trybuild::TestCases::new().compile_fail("tests/refused/*.rs");
}
