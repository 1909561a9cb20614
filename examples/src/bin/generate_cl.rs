//! Writes the files of `examples/cl/` again: `cargo run -p examples --bin generate_cl`.

use std::path::Path;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cl");
    for (name, text) in examples::files() {
        std::fs::write(folder.join(name), text)?;
    }
    Ok(())
}
