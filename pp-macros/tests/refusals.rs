//! A few refusals through the real compiler: the words it underlines on a stable toolchain.
//!
//! `TRYBUILD=overwrite cargo test -p pp-macros --test refusals` writes the expected messages anew; read them before
//! they are committed. The engine's own tests cover every message.

#[test]
fn mistakes_are_underlined_at_their_words() {
    trybuild::TestCases::new().compile_fail("tests/refused/*.rs");
}
