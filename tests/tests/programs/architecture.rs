//! Dependencies between modules as in ARCHITECTURE.md, read from the sources, and its code map.
//!
//! A module of the first level uses another one by a path that begins with `crate`, or with enough `super` to reach the
//! root of the crate. Tests inside the packages may use everything.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use tests::binaries::workspace;

/// Modules that each module of pp-runtime may use; the lower layers come first.
const RUNTIME: &[(&str, &[&str])] = &[
    ("tolerance", &[]),
    ("shortcut", &[]),
    ("kinematics", &[]),
    ("program", &["kinematics"]),
    ("diag", &["program"]),
    ("keys", &["diag", "kinematics", "program"]),
    ("nc", &["keys", "kinematics", "program"]),
    ("set_up", &["keys", "kinematics", "program"]),
    ("options", &["keys", "kinematics", "program", "set_up", "tolerance"]),
    ("cl", &["diag", "keys", "kinematics", "program", "set_up", "shortcut"]),
    ("motion", &["diag", "kinematics", "nc", "options", "program", "set_up", "shortcut", "tolerance"]),
    ("control", &["keys", "kinematics", "motion", "nc", "options", "program", "set_up", "tolerance"]),
    ("check", &["cl", "diag", "kinematics", "program", "set_up", "shortcut", "tolerance"]),
    (
        "config",
        &["check", "cl", "control", "diag", "keys", "kinematics", "motion", "nc", "options", "program", "set_up"],
    ),
    (
        "post",
        &[
            "check",
            "cl",
            "config",
            "control",
            "diag",
            "kinematics",
            "motion",
            "nc",
            "options",
            "program",
            "set_up",
            "tolerance",
        ],
    ),
    ("inside", &["config", "control", "motion", "shortcut"]),
    ("transformation", &["config", "kinematics"]),
    ("view", &["check", "cl", "kinematics", "post", "program", "set_up"]),
    ("simulate", &["check", "kinematics", "set_up", "view"]),
    (
        "cli",
        &[
            "check",
            "cl",
            "config",
            "control",
            "diag",
            "kinematics",
            "motion",
            "options",
            "post",
            "program",
            "set_up",
            "simulate",
            "transformation",
            "view",
        ],
    ),
];

/// The same for the engine.
const ENGINE: &[(&str, &[&str])] = &[
    ("symbolic", &[]),
    ("model", &["symbolic"]),
    ("report", &[]),
    ("suggest", &[]),
    ("syntax", &["model", "report", "suggest"]),
    ("solve", &["model", "symbolic"]),
    ("check", &["model", "report", "solve", "suggest", "symbolic", "syntax"]),
    ("proof", &["model", "solve", "symbolic"]),
    ("formula", &["model", "solve", "symbolic"]),
    ("verify", &["check", "formula", "model", "report", "solve", "suggest", "symbolic", "syntax"]),
    ("explain", &["formula", "model", "solve", "symbolic", "verify"]),
    ("emit", &["check", "explain", "formula", "model", "solve", "symbolic"]),
];

/// Modules used by each module of the first level, with a module in it that does.
type Uses = BTreeMap<String, BTreeMap<String, String>>;

/// A path as far as it has been read, from the root of the crate.
#[derive(Clone)]
struct PathSoFar<'p> {
    /// The module that has the path.
    place: &'p [String],
    names: Option<Vec<String>>,
}

impl PathSoFar<'_> {
    /// The path with another name at its end; `None` above the root.
    fn with(&self, name: &str) -> Option<Self> {
        let mut names = match (&self.names, name) {
            (Some(names), _) => names.clone(),
            (None, "crate" | "pp_runtime" | "pp_codegen") => Vec::new(),
            (None, _) => self.place.to_vec(),
        };
        match name {
            "self" => {}
            "super" => drop(names.pop()?),
            "crate" | "pp_runtime" | "pp_codegen" if self.names.is_none() => {}
            _ => names.push(name.to_owned()),
        }
        Some(Self { names: Some(names), ..*self })
    }

    /// Reads the rest of the path, which may be several in braces; adds them, and returns the tokens after it.
    fn read<'t>(&self, tokens: &'t [TokenTree], found: &mut Vec<Vec<String>>) -> &'t [TokenTree] {
        match tokens {
            [TokenTree::Ident(name), rest @ ..] => {
                let Some(path) = self.with(&name.to_string()) else { return rest };
                if is_path_separator(rest, 0) {
                    return path.read(&rest[2..], found);
                }
                found.extend(path.names);
                rest
            }
            [TokenTree::Group(group), rest @ ..] if group.delimiter() == Delimiter::Brace => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                for part in inner.split(|tree| matches!(tree, TokenTree::Punct(mark) if mark.as_char() == ',')) {
                    self.read(part, found);
                }
                rest
            }
            // Everything of a module, or arguments of a type.
            _ => {
                found.extend(self.names.clone());
                tokens
            }
        }
    }
}

/// Adds the paths of `tokens`, each as its names from the root of the crate; `place`: the module that has them. What is
/// not found from the root is taken as a path in that module.
fn paths(tokens: TokenStream, place: &[String], found: &mut Vec<Vec<String>>) {
    let tokens: Vec<TokenTree> = without_tests(tokens);
    let mut rest = &tokens[..];
    while let Some((first, after)) = rest.split_first() {
        let before = tokens.len() - rest.len();
        rest = match first {
            TokenTree::Group(group) => {
                // A `mod name { .. }` in the file is one level deeper.
                let inner = match &tokens[..before] {
                    [.., TokenTree::Ident(word), TokenTree::Ident(name)] if word == "mod" => {
                        [place, &[name.to_string()]].concat()
                    }
                    _ => place.to_vec(),
                };
                paths(group.stream(), &inner, found);
                after
            }
            TokenTree::Ident(_) if is_path_separator(after, 0) => PathSoFar { place, names: None }.read(rest, found),
            _ => after,
        };
    }
}

fn is_path_separator(tokens: &[TokenTree], at: usize) -> bool {
    let colon = |at: usize| matches!(tokens.get(at), Some(TokenTree::Punct(mark)) if mark.as_char() == ':');
    colon(at) && colon(at + 1)
}

/// The tokens without items that are compiled for tests only.
fn without_tests(tokens: TokenStream) -> Vec<TokenTree> {
    let mut kept: Vec<TokenTree> = Vec::new();
    let mut tokens = tokens.into_iter().peekable();
    while let Some(tree) = tokens.next() {
        let test = matches!(&tree, TokenTree::Group(group)
            if group.delimiter() == Delimiter::Bracket && group.stream().to_string().replace(' ', "") == "cfg(test)");
        if !test {
            kept.push(tree);
            continue;
        }
        // The item ends with its braces or with a semicolon.
        for tree in tokens.by_ref() {
            let ends = match &tree {
                TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                TokenTree::Punct(mark) => mark.as_char() == ';',
                _ => false,
            };
            if ends {
                break;
            }
        }
    }
    kept
}

/// The files of a folder that are not tests.
fn sources(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the folder exists") {
        let path = entry.expect("it can be listed").path();
        let name = path.file_stem().and_then(|name| name.to_str()).expect("a name in ASCII").to_owned();
        let test = name == "tests" || name.ends_with("_tests");
        if path.is_dir() && !test {
            sources(&path, into);
        } else if path.extension().is_some_and(|end| end == "rs") && !test {
            into.push(path);
        }
    }
}

/// Modules that are compiled for tests only, `#[cfg(test)] mod name;`: their files without extension.
fn test_modules(files: &[PathBuf]) -> BTreeSet<PathBuf> {
    let mut modules = BTreeSet::new();
    for file in files {
        let folder = match file.file_stem().and_then(|stem| stem.to_str()) {
            Some("mod" | "lib") => file.with_file_name(""),
            _ => file.with_extension(""),
        };
        let text = fs::read_to_string(file).expect("it can be read");
        let lines: Vec<&str> = text.lines().map(str::trim).collect();
        for pair in lines.windows(2).filter(|pair| pair[0] == "#[cfg(test)]") {
            if let Some(name) = pair[1].rsplit("mod ").next().and_then(|name| name.strip_suffix(';')) {
                modules.insert(folder.join(name));
            }
        }
    }
    modules
}

/// The files of a crate that are not tests.
pub(crate) fn product_files(source: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    sources(source, &mut files);
    let tests = test_modules(&files);
    files.retain(|file| !file.with_extension("").ancestors().any(|module| tests.contains(module)));
    files
}

/// The modules of a crate that are not tests, each with its paths from the root; the root has no name.
pub(crate) fn modules(source: &Path) -> BTreeMap<Vec<String>, Vec<Vec<String>>> {
    let module = |file: &PathBuf| {
        let inside = file.strip_prefix(source).expect("a file of the folder").with_extension("");
        let place = inside.iter().map(|part| part.to_string_lossy().into_owned());
        let place: Vec<String> = place.filter(|part| part != "mod" && part != "lib").collect();
        let text = fs::read_to_string(file).expect("it can be read");
        let mut found = Vec::new();
        paths(text.parse().expect("Rust"), &place, &mut found);
        (place, found)
    };
    product_files(source).iter().map(module).collect()
}

fn uses(source: &Path, names: &BTreeSet<String>) -> Uses {
    let mut uses = Uses::new();
    for (place, paths) in modules(source) {
        let Some(here) = place.first() else { continue };
        let used = uses.entry(here.clone()).or_default();
        let others = paths.into_iter().filter_map(|path| path.into_iter().next());
        for name in others.filter(|name| names.contains(name) && name != here) {
            used.entry(name).or_insert_with(|| place.join("::"));
        }
    }
    uses
}

/// Compares the imports with the table, in both directions: a permission that is not used is a fault too.
fn compare(package: &str, table: &[(&str, &[&str])]) {
    let source = workspace().join(package).join("src");
    let modules: BTreeSet<String> = table.iter().map(|(name, _)| (*name).to_owned()).collect();
    let found = uses(&source, &modules);
    let listed: BTreeSet<&str> = found.keys().map(String::as_str).collect();
    assert_eq!(listed, table.iter().map(|(name, _)| *name).collect(), "{package}: modules of the first level");
    let mut faults = Vec::new();
    for (name, allowed) in table {
        let used = &found[*name];
        for (other, module) in used.iter().filter(|(other, _)| !allowed.contains(&other.as_str())) {
            faults.push(format!("{name} may not use {other}: {module}"));
        }
        for other in allowed.iter().filter(|other| !used.contains_key(**other)) {
            faults.push(format!("{name} does not use {other}: the table allows too much"));
        }
    }
    assert_eq!(faults, Vec::<String>::new());
    for (index, (name, allowed)) in table.iter().enumerate() {
        let earlier = |other: &&str| table[..index].iter().any(|(name, _)| name == other);
        assert!(allowed.iter().all(earlier), "{name}: uses only modules above it in the table");
    }
}

#[test]
fn modules_of_the_runtime_use_what_architecture_allows() {
    compare("pp-runtime", RUNTIME);
}

#[test]
fn modules_of_the_engine_use_what_architecture_allows() {
    compare("pp-macros/codegen", ENGINE);
}

/// The modules in the first column of a table of the code map, and those of the first level among them.
fn mapped(title: &str) -> (Vec<String>, Vec<String>) {
    let text = fs::read_to_string(workspace().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let rows = text.lines().skip_while(|line| *line != format!("| {title} | |")).skip(2);
    let first_cells = rows.map_while(|line| line.strip_prefix('|')?.split('|').next());
    let all: Vec<String> = first_cells.flat_map(|cell| cell.split('`').skip(1).step_by(2)).map(str::to_owned).collect();
    let first_level = all.iter().filter(|name| !name.contains('/')).cloned().collect();
    (all, first_level)
}

#[test]
fn the_code_map_has_every_module_and_no_other() {
    for (title, package, table) in
        [("module of the engine", "pp-macros/codegen", ENGINE), ("module of the runtime", "pp-runtime", RUNTIME)]
    {
        let (all, first_level) = mapped(title);
        assert_eq!(
            first_level,
            table.iter().map(|(name, _)| *name).collect::<Vec<_>>(),
            "{title}: in the order of the layers"
        );
        let source = workspace().join(package).join("src");
        for name in all {
            let is_there = source.join(&name).is_dir() || source.join(&name).with_extension("rs").is_file();
            assert!(is_there, "{title}: there is no {name}");
        }
    }
}

/// Stages in the order in which data passes them, of a record and of a declaration.
const STAGES: [&[&str]; 2] = [
    &["cl", "motion", "control", "nc"],
    &["pp-macros", "lib.rs", "syntax", "check", "solve", "proof", "verify", "explain", "emit"],
];

#[test]
fn the_functions_of_the_walks_exist_and_no_walk_returns_to_an_earlier_stage() {
    let text = fs::read_to_string(workspace().join("ARCHITECTURE.md")).expect("the document");
    let (_, walks) = text.split_once("\n## Walks\n").expect("the walks");
    let walks: Vec<&str> = walks.split("\n### ").skip(1).collect();
    assert_eq!(walks.len(), 5);
    for walk in walks {
        let (title, steps) = walk.split_once('\n').expect("a title");
        let of_engine = title.contains("machine!");
        let stages = STAGES[usize::from(of_engine)];
        let source = if of_engine { "pp-macros/codegen/src" } else { "pp-runtime/src" };
        let mut before = 0;
        let named = |line: &str| {
            let (number, rest) = line.split_once(". `")?;
            number.parse::<u32>().ok()?;
            let (file, rest) = rest.split_once("`: `")?;
            let (function, _) = rest.split_once('`')?;
            Some((file.to_owned(), function.to_owned()))
        };
        let steps: Vec<(String, String)> = steps.lines().filter_map(named).collect();
        assert!(steps.len() >= 10, "{title}: {} steps", steps.len());
        for (file, function) in steps {
            let path = if file.starts_with("pp-macros") { file.clone() } else { format!("{source}/{file}") };
            let code = fs::read_to_string(workspace().join(&path)).unwrap_or_else(|error| panic!("{path}: {error}"));
            let name = function.rsplit("::").next().expect("a name");
            let (open, generic) = (format!("fn {name}("), format!("fn {name}<"));
            assert!(code.contains(&open) || code.contains(&generic), "{title}: {path} has no function {name}");
            let stage = file.split('/').next().expect("a folder");
            let place = stages.iter().position(|other| *other == stage).expect("a stage");
            assert!(place >= before, "{title}: {file} returns to an earlier stage");
            before = place;
        }
    }
}

#[test]
fn every_spelling_of_a_path_is_found() {
    let modules: BTreeSet<String> = ["cl", "motion", "nc"].map(str::to_owned).into();
    let seen = |text: &str, depth: usize| {
        let (place, mut found) = (["outer", "inner"].map(str::to_owned), Vec::new());
        paths(text.parse().expect("Rust"), &place[..depth], &mut found);
        let found: BTreeSet<&String> = found.iter().filter_map(|path| path.first()).collect();
        found.into_iter().filter(|name| modules.contains(*name)).cloned().collect::<Vec<_>>().join(" ")
    };
    assert_eq!(seen("use crate::motion::Step;", 1), "motion");
    assert_eq!(seen("use crate::{cl::Reader, nc};", 2), "cl nc");
    assert_eq!(seen("fn f() { crate::nc::write(super::super::motion::MAX) }", 2), "motion nc");
    assert_eq!(seen("fn f() { pp_runtime::cl::Reader::new() }", 2), "cl");
    assert_eq!(seen("use super::motion::Step;", 1), "motion");
    assert_eq!(seen("use super::motion::Step;", 2), "", "a submodule with the same name");
    assert_eq!(seen("mod inner { use super::super::cl::Reader; }", 1), "cl");
    assert_eq!(seen("use super::{super::cl::Reader, other::Thing};", 2), "cl");
    assert_eq!(
        seen("#[cfg(test)] mod tests { use crate::cl; } #[cfg(test)] use crate::nc; use crate::motion;", 1),
        "motion"
    );
}
