//! `new`: a folder with the postprocessor of another machine, made of the template, which `cargo generate` reads
//! too.

use std::fs;
use std::path::{Path, PathBuf};

use super::args::{MessageFormat, NewArgs};
use super::messages::MessageWriter;
use super::outcome::{Failure, Status, Streams};

/// Files of the template, as `cargo generate` reads them too.
const FILES: [(&str, &str); 8] = [
    ("Cargo.toml", include_str!("../../template/Cargo.toml.liquid")),
    ("README.md", include_str!("../../template/README.md")),
    ("machine.toml", include_str!("../../template/machine.toml")),
    ("release.sh", include_str!("../../template/release.sh")),
    ("src/main.rs", include_str!("../../template/src/main.rs")),
    ("cl/first.cls", include_str!("../../template/cl/first.cls")),
    (".gitignore", include_str!("../../template/.gitignore")),
    (".github/workflows/test.yml", include_str!("../../template/.github/workflows/test.yml")),
];

/// Names that cargo or rustc refuse for a package with a binary, and those of the packages that it depends on.
const TAKEN: [&str; 13] = [
    "alloc",
    "build",
    "core",
    "crate",
    "deps",
    "examples",
    "incremental",
    "pp-conformance",
    "pp-runtime",
    "proc-macro",
    "self",
    "std",
    "test",
];

/// Makes the folder, or nothing.
pub(crate) fn run(args: &NewArgs, streams: &mut Streams<'_>) -> Result<Status, Failure> {
    let name = package_name(&args.folder)?;
    let sources = match &args.pp_runtime {
        Some(folder) => Some(checkout(folder).ok_or_else(|| {
            let folder = folder.display();
            Failure::Argument(format!("{folder} is not the folder `pp-runtime` of a checkout: it has no `conformance`"))
        })?),
        // This binary may have been built from a checkout.
        None => checkout(Path::new(env!("CARGO_MANIFEST_DIR"))),
    };
    let fields = Fields::new(&name, sources.as_deref());
    if let Some(parent) = args.folder.parent() {
        fs::create_dir_all(parent).map_err(|error| Failure::unwritable(parent, error))?;
    }
    // Refuses a folder that is there.
    fs::create_dir(&args.folder).map_err(|error| Failure::unwritable(&args.folder, error))?;
    if let Err(failure) = write(&args.folder, &fields) {
        // Nothing else can be in it. If it cannot be removed, its name is in the message all the same.
        let _ = fs::remove_dir_all(&args.folder);
        return Err(failure);
    }
    let mut messages = MessageWriter::new(streams.errors, MessageFormat::Human);
    messages
        .note(&format!("{} is the postprocessor `{name}`; its README.md has the next steps", args.folder.display()));
    messages.note("these two commands post its sample and test its kinematics:");
    let folder = quoted(&args.folder);
    let commands =
        [format!("cd {folder} && cargo run -- post cl/first.cls --config machine.toml"), "cargo test".to_owned()];
    super::outcome::print(streams, |out| commands.iter().try_for_each(|command| writeln!(out, "{command}")))
}

fn write(folder: &Path, fields: &Fields) -> Result<(), Failure> {
    for (file, text) in FILES {
        let path = folder.join(file);
        let failed = |error| Failure::unwritable(&path, error);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(failed)?;
        }
        fs::write(&path, fields.fill(text)).map_err(failed)?;
    }
    Ok(())
}

/// The folder as an argument of a shell.
fn quoted(folder: &Path) -> String {
    let text = folder.display().to_string();
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/\\:._-".contains(&byte);
    if text.bytes().all(plain) { text } else { format!("\"{text}\"") }
}

/// Name of the package: that of the folder, in lower case.
fn package_name(folder: &Path) -> Result<String, Failure> {
    let name = folder.file_name().unwrap_or_default().to_string_lossy().to_lowercase().replace([' ', '_'], "-");
    let begins = name.bytes().next().is_some_and(|byte| byte.is_ascii_lowercase());
    let good = name.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-');
    if !begins || !good {
        return Err(Failure::Argument(format!(
            "{} gives the package no name: a name has letters, digits and `-`, and begins with a letter",
            folder.display()
        )));
    }
    if TAKEN.contains(&name.as_str()) {
        return Err(Failure::Argument(format!("`{name}` is no name for a package of yours: give the folder another")));
    }
    Ok(name)
}

/// The folder of pp-runtime in a checkout, which has the tests of machines beside it; a package of a registry has not.
fn checkout(folder: &Path) -> Option<PathBuf> {
    let folder = fs::canonicalize(folder).ok()?;
    folder.join("conformance/Cargo.toml").is_file().then_some(folder)
}

/// Fields of the template and their values.
struct Fields([(&'static str, String); 4]);

impl Fields {
    /// `sources`: folder of pp-runtime; without it the version of this one, from the registry.
    fn new(name: &str, sources: Option<&Path>) -> Self {
        let words = name.split('-').filter(|word| !word.is_empty());
        let type_name = words.map(|word| word[..1].to_uppercase() + &word[1..]).collect();
        let dependency = |folder: Option<PathBuf>| match folder {
            Some(folder) => format!("{{ path = {:?} }}", folder.display().to_string()),
            None => format!("{:?}", env!("CARGO_PKG_VERSION")),
        };
        Self([
            ("{{project-name}}", name.to_owned()),
            ("{{crate_name | upper_camel_case}}", type_name),
            ("{{pp_runtime}}", dependency(sources.map(Path::to_path_buf))),
            ("{{pp_conformance}}", dependency(sources.map(|folder| folder.join("conformance")))),
        ])
    }

    fn fill(&self, text: &str) -> String {
        self.0.iter().fold(text.to_owned(), |text, (field, value)| text.replace(field, value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_of_the_template_is_filled() {
        for sources in [None, Some(Path::new("/src/pp-runtime"))] {
            let fields = Fields::new("umc-750-a", sources);
            for (file, text) in FILES {
                let filled = fields.fill(text);
                assert!(!filled.contains("{{") && !filled.contains("}}"), "{file}:\n{filled}");
            }
            let [manifest, main] = [0, 4].map(|index| fields.fill(FILES[index].1));
            assert!(main.contains("pub struct Umc750A;"), "{main}");
            let manifest: toml::Table = manifest.parse().expect("TOML");
            let dependency = &manifest["dependencies"]["pp-runtime"];
            match sources {
                None => assert_eq!(dependency.as_str(), Some(env!("CARGO_PKG_VERSION"))),
                Some(_) => assert_eq!(dependency["path"].as_str(), Some("/src/pp-runtime")),
            }
        }
    }

    #[test]
    fn a_folder_whose_name_is_no_package_is_refused() {
        for (folder, name) in [("UMC 750", "umc-750"), ("/shops/a/my_mill", "my-mill"), ("../x5", "x5")] {
            assert_eq!(package_name(Path::new(folder)).ok().as_deref(), Some(name));
        }
        for folder in ["5axis", "", "/", "..", "fräse", "a.b", "-a", "test", "pp-runtime", "PP_RUNTIME"] {
            assert!(package_name(Path::new(folder)).is_err(), "{folder}");
        }
    }
}
