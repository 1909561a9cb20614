//! The `machine!` macro; the engine behind it is the ordinary library `pp_codegen`.
