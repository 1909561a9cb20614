//! The files of `examples/cl/` are those that the generator writes.

use std::path::Path;

#[test]
fn the_committed_files_are_those_that_the_generator_writes() {
    for (name, text) in examples::files() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cl").join(name);
        let committed = std::fs::read_to_string(&path).expect("every file is committed");
        // Compared line by line: a difference is short, and a checkout may change line ends.
        assert_eq!(committed.lines().count(), text.lines().count(), "{name}");
        for (place, (committed, written)) in committed.lines().zip(text.lines()).enumerate() {
            assert_eq!(committed, written, "{name}, line {}", place + 1);
        }
        assert!(text.len() < 150_000, "{name} is long: {} bytes", text.len());
    }
}

#[test]
fn the_table_names_every_file() {
    let table = include_str!("../cl/README.md");
    for (name, _) in examples::files() {
        assert!(table.contains(&format!("`{name}`")), "{name} is not in the table");
    }
}
