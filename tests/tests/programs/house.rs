//! What keeps the house small: fields of a struct, lines of a function, circles between the modules of a folder, public
//! names. What is larger is listed, with its size: the lists only shrink. No line of a comment is longer than one of
//! the code.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use tests::binaries::workspace;

use super::architecture::{modules, product_files};

/// Sources that are judged.
const SOURCES: &[&str] = &[
    "pp-macros/src",
    "pp-macros/codegen/src",
    "pp-runtime/src",
    "pp-runtime/conformance/src",
    "machines/src",
    "examples/src",
    "tests/src",
];

const MOST_FIELDS: usize = 20;
const MOST_LINES: usize = 80;

/// Folders with comments that are judged, in Rust and in TypeScript.
const COMMENTED: &[(&str, &str)] = &[
    ("examples", "rs"),
    ("machines", "rs"),
    ("pp-macros", "rs"),
    ("pp-runtime/conformance", "rs"),
    ("pp-runtime/src", "rs"),
    ("pp-runtime/template", "rs"),
    ("pp-runtime/page/src", "ts"),
    ("tests", "rs"),
];

const MOST_COLUMNS: usize = 120;

/// Public names of pp-runtime: those of its root and of its public modules.
const MOST_NAMES: usize = 150;

/// Public modules within these, with the number of their names.
const INNER_MODULES: &[(&str, usize)] = &[
    ("check/read", 14),
    ("cl/record", 5),
    ("control/template", 2),
    ("kinematics/math", 11),
    ("transformation/linuxcnc", 2),
];

/// Structs with more fields.
const LARGE_STRUCTS: &[(&str, usize)] = &[
    ("pp-runtime/src/check/policy.rs: LinkPolicy", 23),
    ("pp-runtime/src/check/policy.rs: ShopBlocks", 26),
    ("pp-runtime/src/check/read/facts.rs: Facts", 60),
    ("pp-runtime/src/check/read/state.rs: State", 34),
    ("pp-runtime/src/cli/args/mod.rs: SetUpArgs", 27),
    ("pp-runtime/src/control/dialects/spellings.rs: Spellings", 70),
    ("pp-runtime/src/control/encode/values.rs: Values", 23),
    ("pp-runtime/src/motion/place/mod.rs: Placer", 21),
    ("pp-runtime/src/motion/plan/abilities.rs: Abilities", 26),
    ("pp-runtime/src/post/survey.rs: Survey", 21),
    ("pp-runtime/src/view/head.rs: ViewHead", 21),
    ("tests/src/foreign/state.rs: State", 36),
];

/// Functions with more lines.
const LONG_FUNCTIONS: &[(&str, usize)] = &[
    ("pp-runtime/src/check/compare/obligations.rs: is_missing", 90),
    ("pp-runtime/src/check/read/compose.rs: ask", 93),
    ("pp-runtime/src/check/read/facts.rs: facts", 146),
    ("pp-runtime/src/check/read/flow/mod.rs: execute", 99),
    ("pp-runtime/src/check/read/language/texts.rs: text", 93),
    ("pp-runtime/src/check/read/machine/modes.rs: set", 106),
    ("pp-runtime/src/cl/meaning/arc.rs: normal_and_angle", 83),
    ("pp-runtime/src/cli/posting.rs: run", 94),
    ("pp-runtime/src/cli/simulate/mod.rs: run", 88),
    ("pp-runtime/src/cli/simulate/mod.rs: simulate", 104),
    ("pp-runtime/src/control/encode/mod.rs: encode", 84),
    ("pp-runtime/src/control/fit.rs: unsupported", 138),
    ("pp-runtime/src/control/lacking.rs: take_out_lacking", 81),
    ("pp-runtime/src/simulate/removal/stock.rs: cut", 94),
    ("pp-runtime/src/simulate/removal/sweep.rs: enter", 108),
    ("pp-runtime/src/transformation/linuxcnc/component.rs: component", 146),
    ("pp-runtime/src/transformation/sheet/siemens/traori.rs: transformation", 93),
    ("tests/src/edits/verdict/difference.rs: moved", 91),
    ("tests/src/edits/verdict/rearranged.rs: rearranged", 151),
    ("tests/src/foreign/machine/modes.rs: mode", 115),
    ("tests/src/foreign/mod.rs: line", 96),
];

/// Modules of one folder that use each other in a circle.
const CIRCLES: &[&[&str]] = &[
    // The table of words names the functions that read them, and two of these ask it for words.
    &["cl::record::comment", "cl::record::vocabulary", "cl::record::words"],
    &["cli::posting", "cli::simulate", "cli::view"],
    // Methods that a machine has by default are functions over its trait.
    &["kinematics::any", "kinematics::machine", "kinematics::machines", "kinematics::motion", "kinematics::words"],
    &["syntax::chain", "syntax::parse"],
];

/// What is larger than it may be, as `file: name` with its size.
#[derive(Default)]
struct Large {
    file: String,
    structs: BTreeMap<String, usize>,
    functions: BTreeMap<String, usize>,
}

impl Large {
    fn function(&mut self, name: &syn::Ident, block: &impl Spanned, signature: &impl Spanned) {
        let lines = block.span().end().line + 1 - signature.span().start().line;
        if lines > MOST_LINES {
            self.functions.insert(format!("{}: {name}", self.file), lines);
        }
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("test")
            || matches!(&attribute.meta, syn::Meta::List(list) if list.path.is_ident("cfg") && list.tokens.to_string() == "test")
    })
}

impl<'ast> Visit<'ast> for Large {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_struct(&mut self, item: &'ast syn::ItemStruct) {
        if item.fields.len() > MOST_FIELDS {
            self.structs.insert(format!("{}: {}", self.file, item.ident), item.fields.len());
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        if !is_test(&item.attrs) {
            self.function(&item.sig.ident, &item.block, &item.sig);
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.function(&item.sig.ident, &item.block, &item.sig);
        visit::visit_impl_item_fn(self, item);
    }
}

fn shown(path: &Path) -> String {
    path.strip_prefix(workspace()).expect("a file of the project").display().to_string()
}

/// Compares what is larger than it may be with its list.
fn compare(found: &BTreeMap<String, usize>, listed: &[(&str, usize)]) {
    let mut faults = Vec::new();
    for (name, size) in found {
        match listed.iter().find(|(listed, _)| listed == name) {
            None => faults.push(format!("(\"{name}\", {size}),")),
            Some((_, most)) if size > most => faults.push(format!("{name}: {size}, and its list has {most}")),
            Some((_, most)) if size < most => faults.push(format!("{name}: {size}; lower its number {most}")),
            Some(_) => {}
        }
    }
    faults.extend(
        listed.iter().filter(|(name, _)| !found.contains_key(*name)).map(|(name, _)| format!("{name}: take it off")),
    );
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn structs_and_functions_have_one_idea() {
    let mut large = Large::default();
    for file in SOURCES.iter().flat_map(|folder| product_files(&workspace().join(folder))) {
        let text = fs::read_to_string(&file).expect("it can be read");
        large.file = shown(&file);
        large.visit_file(&syn::parse_file(&text).expect("Rust"));
    }
    compare(&large.structs, LARGE_STRUCTS);
    compare(&large.functions, LONG_FUNCTIONS);
}

/// Modules of one folder that use each other in a circle, with what each takes from another one.
fn circles(source: &Path) -> BTreeMap<Vec<String>, BTreeSet<String>> {
    let modules = modules(source);
    let folders: BTreeSet<&[String]> =
        modules.keys().filter_map(|place| place.split_last()).map(|(_, folder)| folder).collect();
    let mut circles = BTreeMap::new();
    for folder in folders {
        let child = |path: &[String]| path.strip_prefix(folder).and_then(|inside| inside.first()).cloned();
        let children: BTreeSet<String> = modules.keys().filter_map(|place| child(place)).collect();
        // Names that the folder takes from the modules in it.
        let mut taken: BTreeMap<&String, String> = BTreeMap::new();
        for path in modules.get(folder).into_iter().flatten().filter(|path| path.len() > folder.len() + 1) {
            if let Some(of) = child(path).filter(|of| children.contains(of)) {
                taken.insert(path.last().expect("a name"), of);
            }
        }
        let mut uses: BTreeMap<String, BTreeMap<String, BTreeSet<String>>> = BTreeMap::new();
        for (place, paths) in &modules {
            let Some(here) = child(place) else { continue };
            for path in paths {
                let Some(name) = child(path) else { continue };
                let used = if children.contains(&name) { Some(name) } else { taken.get(&name).cloned() };
                let Some(used) = used.filter(|used| *used != here) else { continue };
                let item = format!("{} takes {}", place.join("::"), path.join("::"));
                uses.entry(here.clone()).or_default().entry(used).or_default().insert(item);
            }
        }
        let reached = |from: &String| {
            let (mut reached, mut open) = (BTreeSet::new(), vec![from.clone()]);
            while let Some(name) = open.pop() {
                let next = uses.get(&name).into_iter().flat_map(BTreeMap::keys);
                open.extend(next.filter(|next| reached.insert((*next).clone())).cloned());
            }
            reached
        };
        let all: BTreeMap<&String, BTreeSet<String>> = children.iter().map(|name| (name, reached(name))).collect();
        for (name, reached) in &all {
            let circle: Vec<String> = children
                .iter()
                .filter(|other| reached.contains(*other) && all[other].contains(*name))
                .cloned()
                .collect();
            if circle.len() > 1 {
                let between = |name: &String| {
                    let used = uses[name].iter().filter(|(used, _)| circle.contains(used));
                    used.flat_map(|(_, items)| items.clone()).collect::<Vec<_>>()
                };
                let items = circle.iter().flat_map(between).collect();
                let names =
                    circle.iter().map(|name| [folder, std::slice::from_ref(name)].concat().join("::")).collect();
                circles.insert(names, items);
            }
        }
    }
    circles
}

#[test]
fn no_modules_of_a_folder_use_each_other_in_a_circle() {
    let mut found: BTreeMap<_, _> = SOURCES.iter().flat_map(|folder| circles(&workspace().join(folder))).collect();
    for circle in CIRCLES {
        let circle: Vec<String> = circle.iter().map(|name| (*name).to_owned()).collect();
        assert!(found.remove(&circle).is_some(), "no circle any more, take it off the list: {circle:?}");
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// Files of a folder and of those in it that have an extension.
fn files(folder: &Path, extension: &str, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() && !path.ends_with("target") {
            files(&path, extension, found);
        } else if path.extension().is_some_and(|known| known == extension) {
            found.push(path);
        }
    }
}

/// Lines that begin inside a literal, from 1: what looks like a comment there is text.
fn lines_in_literals(tokens: TokenStream, lines: &mut BTreeSet<usize>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => lines_in_literals(group.stream(), lines),
            TokenTree::Literal(literal) => {
                let span = literal.span();
                lines.extend(span.start().line + 1..=span.end().line);
            }
            TokenTree::Ident(_) | TokenTree::Punct(_) => {}
        }
    }
}

/// Numbers of the comment lines with too many columns. Tables and code in fences keep their lines.
fn long_comments(text: &str, literals: &BTreeSet<usize>) -> Vec<usize> {
    let mut found = Vec::new();
    let mut fenced = false;
    for (line, number) in text.lines().zip(1..) {
        let comment = ["///", "//!", "//", "/*", "* "].iter().find_map(|mark| line.trim_start().strip_prefix(mark));
        let Some(comment) = comment.map(str::trim_start).filter(|_| !literals.contains(&number)) else {
            fenced = false;
            continue;
        };
        let is_fence = comment.starts_with("```");
        fenced ^= is_fence;
        let is_kept = fenced || is_fence || comment.starts_with('|');
        if !is_kept && line.chars().count() > MOST_COLUMNS {
            found.push(number);
        }
    }
    found
}

#[test]
fn comments_have_at_most_120_columns() {
    let mut faults = Vec::new();
    for (folder, extension) in COMMENTED {
        let mut paths = Vec::new();
        files(&workspace().join(folder), extension, &mut paths);
        assert!(!paths.is_empty(), "{folder} has no file .{extension}");
        for path in paths {
            let text = fs::read_to_string(&path).expect("it can be read");
            let mut literals = BTreeSet::new();
            if *extension == "rs" {
                lines_in_literals(text.parse().expect("Rust"), &mut literals);
            }
            faults.extend(long_comments(&text, &literals).iter().map(|line| format!("{}:{line}", shown(&path))));
        }
    }
    faults.sort();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn long_lines_are_found_outside_tables_fences_and_literals() {
    let long = "x".repeat(MOST_COLUMNS);
    let text = format!("// {long}\n/// | {long} |\n//! ```\n//! {long}\n//! ```\n//! {long}\n// short\n// {long}\n");
    assert_eq!(long_comments(&text, &BTreeSet::from([8])), [1, 6]);
}

/// Public names of a module, without those that the documentation hides, and its public modules.
#[derive(Default)]
struct PublicNames {
    names: BTreeSet<String>,
    modules: Vec<String>,
}

fn is_hidden(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        matches!(&attribute.meta, syn::Meta::List(list) if list.path.is_ident("doc") && list.tokens.to_string() == "hidden")
    })
}

impl PublicNames {
    fn of_file(file: &Path) -> Self {
        let mut found = Self::default();
        let text = fs::read_to_string(file).expect("it can be read");
        found.items(syn::parse_file(&text).expect("Rust").items);
        found
    }

    fn items(&mut self, items: Vec<syn::Item>) {
        for item in items {
            let (visibility, attributes, name) = match &item {
                syn::Item::Const(item) => (&item.vis, &item.attrs, item.ident.to_string()),
                syn::Item::Enum(item) => (&item.vis, &item.attrs, item.ident.to_string()),
                syn::Item::Fn(item) => (&item.vis, &item.attrs, item.sig.ident.to_string()),
                syn::Item::Mod(item) => (&item.vis, &item.attrs, item.ident.to_string()),
                syn::Item::Static(item) => (&item.vis, &item.attrs, item.ident.to_string()),
                syn::Item::Struct(item) => (&item.vis, &item.attrs, item.ident.to_string()),
                syn::Item::Trait(item) => (&item.vis, &item.attrs, item.ident.to_string()),
                syn::Item::Type(item) => (&item.vis, &item.attrs, item.ident.to_string()),
                syn::Item::Union(item) => (&item.vis, &item.attrs, item.ident.to_string()),
                syn::Item::Use(item) => (&item.vis, &item.attrs, String::new()),
                syn::Item::Macro(item) => {
                    // A call that declares items, as `options!` does, has them as they are without it.
                    if item.ident.is_none() {
                        let declared = syn::parse2::<DeclaredNames>(item.mac.tokens.clone());
                        self.names.extend(declared.map(|declared| declared.0).unwrap_or_default());
                    }
                    continue;
                }
                _ => continue,
            };
            if !matches!(visibility, syn::Visibility::Public(_)) || is_hidden(attributes) {
                continue;
            }
            match &item {
                syn::Item::Mod(_) => self.modules.push(name),
                syn::Item::Use(item) => self.uses(&item.tree),
                _ => drop(self.names.insert(name)),
            }
        }
    }

    fn uses(&mut self, tree: &syn::UseTree) {
        match tree {
            syn::UseTree::Path(path) => self.uses(&path.tree),
            syn::UseTree::Name(name) => drop(self.names.insert(name.ident.to_string())),
            syn::UseTree::Rename(rename) => drop(self.names.insert(rename.rename.to_string())),
            syn::UseTree::Group(group) => group.items.iter().for_each(|tree| self.uses(tree)),
            syn::UseTree::Glob(_) => panic!("a public name is written out"),
        }
    }
}

/// Names after `pub struct` and `pub enum` in the tokens of a macro call, not in its groups.
struct DeclaredNames(Vec<String>);

impl syn::parse::Parse for DeclaredNames {
    fn parse(input: syn::parse::ParseStream<'_>) -> syn::Result<Self> {
        let words: Vec<String> = input.parse::<TokenStream>()?.into_iter().map(|tree| tree.to_string()).collect();
        let declares = |words: &&[String]| words[0] == "pub" && matches!(&*words[1], "struct" | "enum");
        Ok(Self(words.windows(3).filter(declares).map(|words| words[2].clone()).collect()))
    }
}

#[test]
fn the_public_face_is_small() {
    let source = workspace().join("pp-runtime/src");
    let file_of = |path: &str| {
        let files = [source.join(format!("{path}.rs")), source.join(path).join("mod.rs")];
        files.into_iter().find(|file| file.exists()).expect("the file of the module")
    };
    let root = PublicNames::of_file(&source.join("lib.rs"));
    let mut names: BTreeSet<String> = root.names;
    let mut inner = BTreeMap::new();
    for module in root.modules {
        let mut open = vec![module];
        while let Some(path) = open.pop() {
            let found = PublicNames::of_file(&file_of(&path));
            open.extend(found.modules.iter().map(|name| format!("{path}/{name}")));
            match path.contains('/') {
                true => drop(inner.insert(path, found.names.len())),
                false => names.extend(found.names.iter().map(|name| format!("{path}::{name}"))),
            }
        }
    }
    assert!(names.len() <= MOST_NAMES, "{} public names: {names:#?}", names.len());
    compare(&inner, INNER_MODULES);
}
