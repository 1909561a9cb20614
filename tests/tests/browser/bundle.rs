//! The bundle of the page that the postprocessor contains is the one that its sources make, byte by byte, and their own
//! tests pass.
//!
//! Without Node, or where npm cannot fetch the pinned libraries, the test skips; `PP_REQUIRE_NODE=1` requires it.

use std::path::Path;
use std::process::Command;
use std::{fs, io};

use tests::binaries::workspace;
use tests::environment;

/// What is made, not written.
const MADE: [&str; 2] = ["node_modules", "dist"];

/// Copies the sources of the page.
fn copy(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let (path, name) = (entry.path(), entry.file_name());
        if path.is_dir() {
            if !MADE.iter().any(|made| name == *made) {
                copy(&path, &to.join(name))?;
            }
        } else {
            fs::copy(&path, to.join(name))?;
        }
    }
    Ok(())
}

/// Runs npm; its output if it fails.
fn npm(folder: &Path, args: &[&str]) -> Result<(), String> {
    let output = Command::new("npm").current_dir(folder).args(args).output().map_err(|error| error.to_string())?;
    if output.status.success() {
        return Ok(());
    }
    Err([output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat())
}

#[test]
fn the_bundle_is_what_its_sources_make() {
    let page = workspace().join("pp-runtime/page");
    let folder = tempfile::tempdir().expect("a folder");
    copy(&page, folder.path()).expect("the sources can be copied");
    if let Err(reason) = npm(folder.path(), &["ci", "--no-audit", "--no-fund"]) {
        let required = environment::is_one("PP_REQUIRE_NODE");
        assert!(!required, "PP_REQUIRE_NODE=1, but npm cannot install the libraries of the page: {reason}");
        println!("skipped: npm cannot install the libraries of the page: {reason}");
        return;
    }
    for script in ["test", "build"] {
        npm(folder.path(), &["run", script]).unwrap_or_else(|output| panic!("npm run {script}: {output}"));
    }
    let committed = page.join("dist");
    let names = fs::read_dir(&committed).expect("a bundle").map(|entry| entry.expect("an entry").file_name());
    for name in names {
        let [committed, made] = [committed.join(&name), folder.path().join("dist").join(&name)];
        let same = fs::read(&committed).expect("a file") == fs::read(&made).unwrap_or_default();
        assert!(same, "{} is not what its sources make: run `npm ci && npm run build`", committed.display());
    }
}
