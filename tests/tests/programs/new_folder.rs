//! The command `new`: what it writes and refuses. `.ci/packages` builds, tests and runs what it writes, from the
//! packages alone.

use std::fs;
use std::path::Path;

use machines::SpinnerU5620;
use pp_runtime::cli::{self, Status, Streams};

/// Runs `new`; status, standard output and messages.
fn new(args: &[&str]) -> (Status, String, String) {
    let args: Vec<_> = ["spinner", "new"].iter().chain(args).map(Into::into).collect();
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
    let status = cli::run_with::<SpinnerU5620>(&args, streams);
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (status, text(output), text(errors))
}

#[test]
fn a_folder_is_made_once_and_never_written_into() {
    let here = tempfile::tempdir().expect("a folder");
    let folder = here.path().join("shop").join("Mill 5");
    let folder = folder.to_str().expect("a path in UTF-8");
    let (status, commands, messages) = new(&[folder]);
    assert_eq!(status, Status::Done, "{messages}");
    let run = format!("cd \"{folder}\" && cargo run -- post cl/first.cls --config machine.toml");
    assert_eq!(commands.lines().collect::<Vec<_>>(), [run.as_str(), "cargo test"]);
    let manifest: toml::Table = read(folder, "Cargo.toml").parse().expect("TOML");
    assert_eq!(manifest["package"]["name"].as_str(), Some("mill-5"));
    // From this checkout, where the tests of machines are too.
    for (table, package) in [("dependencies", "pp-runtime"), ("dev-dependencies", "pp-conformance")] {
        let path = manifest[table][package]["path"].as_str().expect("a path");
        assert!(Path::new(path).join("Cargo.toml").is_file(), "{path}");
    }
    for file in [
        ".gitignore",
        ".github/workflows/test.yml",
        "README.md",
        "cl/first.cls",
        "machine.toml",
        "release.sh",
        "src/main.rs",
    ] {
        assert!(Path::new(folder).join(file).is_file(), "{file}");
    }
    fs::write(Path::new(folder).join("machine.toml"), "measured").expect("a file");
    let (status, _, messages) = new(&[folder]);
    assert_eq!((status, read(folder, "machine.toml").as_str()), (Status::NotRun, "measured"));
    assert!(messages.contains("Mill 5"), "{messages}");
}

#[test]
fn nothing_is_made_of_a_name_or_a_checkout_that_is_none() {
    let here = tempfile::tempdir().expect("a folder");
    let folder = |name: &str| here.path().join(name).to_str().expect("a path in UTF-8").to_owned();
    for (args, text) in [
        (vec![folder("5axis")], "begins with a letter"),
        (vec![folder("test")], "no name for a package of yours"),
        (vec![folder("mill"), "--pp-runtime".to_owned(), folder("elsewhere")], "is not the folder `pp-runtime`"),
    ] {
        let (status, commands, messages) = new(&args.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!((status, commands.as_str()), (Status::NotRun, ""));
        assert!(messages.contains(text), "{messages}");
    }
    assert_eq!(fs::read_dir(here.path()).expect("a folder").count(), 0);
}

/// The release profile of the template is that of the workspace, for the packages of every platform.
#[test]
fn a_new_folder_is_built_as_the_workspace_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let profile = |file: &str| {
        let text = fs::read_to_string(root.join(file)).expect("a file of the workspace");
        let text = text.replace("{{pp_runtime}}", "\"0\"").replace("{{pp_conformance}}", "\"0\"");
        let manifest: toml::Table = text.parse().expect("TOML");
        let mut release = manifest["profile"]["release"].clone();
        release["package"].as_table_mut().expect("packages").remove("rustix");
        release
    };
    assert_eq!(profile("pp-runtime/template/Cargo.toml.liquid"), profile("Cargo.toml"));
}

fn read(folder: &str, file: &str) -> String {
    fs::read_to_string(Path::new(folder).join(file)).expect("a file of the folder")
}
