//! Writes the designs of the parts as STL files for `simulate`: `cargo run -p examples --bin generate_designs`.

use std::fs::File;
use std::path::Path;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("virtual");
    for (name, design) in examples::designs::designs() {
        design.write(&mut File::create(folder.join(name))?)?;
    }
    Ok(())
}
