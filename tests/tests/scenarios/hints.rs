//! The hints of messages, as the sources have them: literal texts, and templates of `format!`.
//!
//! A hint is what is given as remedy: the last argument of `cl_fault`, the argument of `.help(..)`, a field or a
//! variable `help`, and any argument that a function takes to such a place. Names in it are followed to their
//! constants, variables and functions.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use tests::binaries::workspace;

/// A hint of the source.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Hint {
    /// Its text; `{..}` is any text.
    pub(crate) template: String,
    /// File and line of the literal.
    pub(crate) place: String,
    /// It is a part of another hint.
    pub(crate) is_part: bool,
}

impl Hint {
    /// Whether a text is this hint, or has it as a part.
    pub(crate) fn is_of(&self, text: &str) -> bool {
        let pieces = pieces(&self.template);
        let (first, last) = (&*pieces[0], &*pieces[pieces.len() - 1]);
        if self.is_part {
            return find_in_order(text, &pieces).is_some();
        }
        let inner = text.strip_prefix(first).filter(|rest| pieces.len() > 1 || rest.is_empty());
        let Some(inner) = inner else { return false };
        pieces.len() == 1
            || inner
                .strip_suffix(last)
                .is_some_and(|inner| find_in_order(inner, &pieces[1..pieces.len() - 1]).is_some())
    }
}

/// The texts between the `{..}` of a template.
fn pieces(template: &str) -> Vec<String> {
    let (mut pieces, mut inside) = (vec![String::new()], false);
    let mut letters = template.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '{' | '}' if letters.peek() == Some(&letter) => {
                letters.next();
                pieces.last_mut().expect("one").push(letter);
            }
            '{' => {
                inside = true;
                pieces.push(String::new());
            }
            '}' => inside = false,
            _ if inside => {}
            _ => pieces.last_mut().expect("one").push(letter),
        }
    }
    pieces
}

fn find_in_order(text: &str, pieces: &[String]) -> Option<usize> {
    pieces.iter().try_fold(0, |from, piece| Some(from + text[from..].find(&**piece)? + piece.len()))
}

/// Names of the variables that a template shows: `{name}`.
fn shown_names(template: &str) -> impl Iterator<Item = &str> {
    let inside = template.split('{').skip(1).filter_map(|piece| Some(piece.split_once('}')?.0));
    inside.map(|name| name.split(':').next().unwrap_or(name)).filter(|name| !name.is_empty())
}

/// A function or closure with a name.
struct Function {
    file: PathBuf,
    name: String,
    /// Names of its parameters; of those that cannot be texts none.
    params: Vec<String>,
    /// Whether it returns a text, and nothing else.
    is_text: bool,
    /// Whether it is called as a method.
    has_self: bool,
    body: Vec<TokenTree>,
    /// Index of the function that it is in.
    inside: Option<usize>,
}

/// A constant.
struct Constant {
    file: PathBuf,
    name: String,
    value: Vec<TokenTree>,
}

/// The functions and constants of some folders.
#[derive(Default)]
struct Sources {
    functions: Vec<Function>,
    constants: Vec<Constant>,
}

/// The hints in the sources below a folder, without those of tests.
pub(crate) fn hints(folder: &Path) -> BTreeSet<Hint> {
    let mut sources = Sources::default();
    let mut files = Vec::new();
    list(folder, &mut files);
    for file in files {
        let text = fs::read_to_string(&file).expect("a source");
        let tokens = without_tests(text.parse().expect("Rust"));
        let name = String::new();
        let whole = Function {
            file,
            name,
            params: Vec::new(),
            is_text: false,
            has_self: false,
            body: tokens.clone(),
            inside: None,
        };
        sources.functions.push(whole);
        sources.read(&tokens, sources.functions.len() - 1);
    }
    let mut found =
        Found { sources: &sources, hints: BTreeSet::new(), takers: BTreeSet::new(), followed: BTreeSet::new() };
    for (index, function) in sources.functions.iter().enumerate() {
        let helps = function.params.iter().position(|param| param == "help");
        found.takers.extend(helps.map(|place| (index, place)));
    }
    loop {
        let before = (found.hints.len(), found.takers.len());
        for (index, function) in sources.functions.iter().enumerate() {
            found.look_through(&function.body, index);
        }
        if before == (found.hints.len(), found.takers.len()) {
            return found.hints;
        }
    }
}

/// The files of a folder without those of tests, or the file itself.
fn list(folder: &Path, into: &mut Vec<PathBuf>) {
    if !folder.is_dir() {
        into.push(folder.to_owned());
        return;
    }
    let mut entries: Vec<_> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    entries.sort();
    for path in entries {
        let is_test = path.file_stem().is_some_and(|name| name == "tests");
        if path.is_dir() && !is_test {
            list(&path, into);
        } else if path.extension().is_some_and(|end| end == "rs") && !is_test {
            into.push(path);
        }
    }
}

/// The tokens without modules of tests.
fn without_tests(tokens: TokenStream) -> Vec<TokenTree> {
    let mut kept: Vec<TokenTree> = Vec::new();
    let mut tokens = tokens.into_iter();
    while let Some(tree) = tokens.next() {
        let is_test =
            matches!(&tree, TokenTree::Group(group) if group.stream().to_string().replace(' ', "") == "cfg(test)");
        if is_test {
            let ends = |tree: &TokenTree| is_group(tree, Delimiter::Brace) || is_mark(Some(tree), ';');
            let _ = tokens.find(ends);
        } else {
            kept.push(tree);
        }
    }
    kept
}

fn is_group(tree: &TokenTree, delimiter: Delimiter) -> bool {
    matches!(tree, TokenTree::Group(group) if group.delimiter() == delimiter)
}

fn is_mark(tree: Option<&TokenTree>, mark: char) -> bool {
    matches!(tree, Some(TokenTree::Punct(found)) if found.as_char() == mark)
}

fn is_word(tree: Option<&TokenTree>, word: &str) -> bool {
    matches!(tree, Some(TokenTree::Ident(found)) if found == word)
}

fn word(tree: Option<&TokenTree>) -> Option<String> {
    match tree {
        Some(TokenTree::Ident(word)) => Some(word.to_string()),
        _ => None,
    }
}

fn inside(tree: &TokenTree) -> Vec<TokenTree> {
    match tree {
        TokenTree::Group(group) => group.stream().into_iter().collect(),
        _ => Vec::new(),
    }
}

/// Parts between commas; the commas in `<..>` do not count.
fn parts(tokens: &[TokenTree]) -> Vec<&[TokenTree]> {
    let (mut parts, mut start, mut angles) = (Vec::new(), 0, 0_usize);
    for (at, tree) in tokens.iter().enumerate() {
        let is_arrow = at > 0 && (is_mark(tokens.get(at - 1), '-') || is_mark(tokens.get(at - 1), '='));
        let opens = is_mark(tokens.get(at.wrapping_sub(1)), ':')
            || matches!(word(tokens.get(at.wrapping_sub(1))), Some(name) if name.starts_with(char::is_uppercase));
        if is_mark(Some(tree), '<') && opens {
            angles += 1;
        } else if is_mark(Some(tree), '>') && !is_arrow {
            angles = angles.saturating_sub(1);
        } else if is_mark(Some(tree), ',') && angles == 0 {
            parts.push(&tokens[start..at]);
            start = at + 1;
        }
    }
    if start < tokens.len() {
        parts.push(&tokens[start..]);
    }
    parts
}

/// Names of parameters: the word before the colon of each, or the word alone; none if its type is no text. `self` is
/// left out.
fn params(tokens: &[TokenTree]) -> Vec<String> {
    let name = |part: &&[TokenTree]| {
        let colon = part.iter().position(|tree| is_mark(Some(tree), ':')).unwrap_or(part.len());
        let name = part[..colon].iter().filter_map(|tree| word(Some(tree))).rfind(|word| word != "mut");
        let may_be_text = colon == part.len() || name.as_deref() == Some("self") || is_of_text(&part[colon..]);
        name.filter(|_| may_be_text).unwrap_or_default()
    };
    parts(tokens).iter().map(name).filter(|name| name != "self").collect()
}

/// Whether a type has texts.
fn is_of_text(tokens: &[TokenTree]) -> bool {
    let is = |tree: &TokenTree| {
        ["String", "str", "Display"].iter().any(|name| is_word(Some(tree), name)) || is_of_text(&inside(tree))
    };
    tokens.iter().any(is)
}

impl Sources {
    /// Finds the functions, closures and constants in some tokens of the function `within`.
    fn read(&mut self, tokens: &[TokenTree], within: usize) {
        let mut at = 0;
        while at < tokens.len() {
            let name = word(tokens.get(at + 1));
            if let (true, Some(name)) = (is_word(tokens.get(at), "fn"), &name) {
                let list = (at + 2..tokens.len()).find(|&at| is_group(&tokens[at], Delimiter::Parenthesis));
                let body = list.and_then(|list| {
                    let ends = |&at: &usize| is_group(&tokens[at], Delimiter::Brace) || is_mark(tokens.get(at), ';');
                    Some((list, (list + 1..tokens.len()).find(ends)?))
                });
                if let Some((list, body)) = body {
                    let list_of_params = inside(&tokens[list]);
                    let params = params(&list_of_params);
                    let has_self = list_of_params.iter().take(4).any(|tree| is_word(Some(tree), "self"));
                    let returned = &tokens[list + 1..body];
                    let fails = returned.iter().any(|tree| is_word(Some(tree), "Result"));
                    let is_text = is_of_text(returned) && !fails;
                    self.add(Function {
                        params,
                        is_text,
                        has_self,
                        ..self.function(name, inside(&tokens[body]), within)
                    });
                    at = body + 1;
                    continue;
                }
            }
            let equals = (at + 2..tokens.len().min(at + 60)).find(|&at| is_mark(tokens.get(at), '='));
            let is_const = is_word(tokens.get(at), "const") || is_word(tokens.get(at), "static");
            if let (true, Some(name), Some(equals)) = (is_const, &name, equals) {
                let end = (equals..tokens.len()).find(|&at| is_mark(tokens.get(at), ';')).unwrap_or(tokens.len());
                let (file, value) = (self.functions[within].file.clone(), tokens[equals + 1..end].to_vec());
                self.constants.push(Constant { file, name: name.clone(), value });
                at = end;
                continue;
            }
            // `let name = |params| body;`
            if let (true, Some(name), true, true) = (
                is_word(tokens.get(at), "let"),
                &name,
                is_mark(tokens.get(at + 2), '='),
                is_mark(tokens.get(at + 3), '|') || is_word(tokens.get(at + 3), "move"),
            ) {
                let open = at + 3 + usize::from(is_word(tokens.get(at + 3), "move"));
                let close = (open + 1..tokens.len()).find(|&at| is_mark(tokens.get(at), '|'));
                let end = (open..tokens.len()).find(|&at| is_mark(tokens.get(at), ';')).unwrap_or(tokens.len());
                if let Some(close) = close.filter(|close| *close < end) {
                    let params = params(&tokens[open + 1..close]);
                    let body = tokens[close + 1..end].to_vec();
                    self.add(Function { params, is_text: true, ..self.function(name, body, within) });
                    at = end;
                    continue;
                }
            }
            if matches!(tokens[at], TokenTree::Group(_)) {
                self.read(&inside(&tokens[at]), within);
            }
            at += 1;
        }
    }

    fn function(&self, name: &str, body: Vec<TokenTree>, within: usize) -> Function {
        let (file, name) = (self.functions[within].file.clone(), name.to_owned());
        Function { file, name, params: Vec::new(), is_text: false, has_self: false, body, inside: Some(within) }
    }

    fn add(&mut self, function: Function) {
        let body = function.body.clone();
        self.functions.push(function);
        self.read(&body, self.functions.len() - 1);
    }

    /// The functions that enclose one, from the inside.
    fn around(&self, function: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(function), |&index| self.functions[index].inside)
    }

    /// The functions of a name: those in the functions around, else those of the file, else all.
    fn named(&self, name: &str, is_method: bool, from: usize) -> Vec<usize> {
        let is = |function: &Function| function.name == name && function.has_self == is_method;
        let all: Vec<usize> = (0..self.functions.len()).filter(|&index| is(&self.functions[index])).collect();
        for around in self.around(from) {
            let near: Vec<usize> =
                all.iter().copied().filter(|&index| self.functions[index].inside == Some(around)).collect();
            if !near.is_empty() {
                return near;
            }
        }
        let file = &self.functions[from].file;
        let of_file: Vec<usize> = all.iter().copied().filter(|&index| &self.functions[index].file == file).collect();
        if of_file.is_empty() { all } else { of_file }
    }
}

/// What has been found so far.
struct Found<'s> {
    sources: &'s Sources,
    hints: BTreeSet<Hint>,
    /// Functions that take a hint as an argument, and the index of the argument.
    takers: BTreeSet<(usize, usize)>,
    /// Names that have been followed, with the function in which they are, and whether for a part.
    followed: BTreeSet<(String, usize, bool)>,
}

impl Found<'_> {
    /// Takes the hints in some tokens of a function.
    fn look_through(&mut self, tokens: &[TokenTree], of: usize) {
        for (at, tree) in tokens.iter().enumerate() {
            let before = |steps: usize| at.checked_sub(steps).and_then(|at| tokens.get(at));
            if is_group(tree, Delimiter::Parenthesis)
                && let Some(name) = word(before(1))
            {
                let args = inside(tree);
                let args = parts(&args);
                let is_method = is_mark(before(2), '.');
                if name == "cl_fault" {
                    args.last().into_iter().for_each(|help| self.take(help, of, 0));
                } else if name == "help" && is_method {
                    args.iter().for_each(|help| self.take(help, of, 0));
                } else if !is_word(before(2), "fn") && name != "new" {
                    let takes_as_many = |index: &usize| self.sources.functions[*index].params.len() == args.len();
                    let called: Vec<usize> =
                        self.sources.named(&name, is_method, of).into_iter().filter(takes_as_many).collect();
                    for index in called {
                        for (place, arg) in args.iter().enumerate() {
                            if self.takers.contains(&(index, place)) {
                                self.take(arg, of, 0);
                            }
                        }
                    }
                }
            }
            if is_word(Some(tree), "help") {
                let is_variable = is_word(before(1), "let");
                if is_variable && is_mark(tokens.get(at + 1), '=') {
                    let end = (at..tokens.len()).find(|&at| is_mark(tokens.get(at), ';')).unwrap_or(tokens.len());
                    self.take(&tokens[at + 2..end], of, 0);
                } else if is_mark(tokens.get(at + 1), ':') && !is_mark(tokens.get(at + 2), ':') && !is_variable {
                    let rest = &tokens[at + 2..];
                    // Not that of a parameter: there a type follows.
                    let is_type = is_mark(rest.first(), '&')
                        || ["impl", "String", "Option"].iter().any(|word| is_word(rest.first(), word));
                    parts(rest).first().filter(|_| !is_type).into_iter().for_each(|help| self.take(help, of, 0));
                }
            }
            // `let (text, help) = ..`
            if is_word(Some(tree), "let")
                && let Some(pattern) = tokens.get(at + 1).filter(|tree| is_group(tree, Delimiter::Parenthesis))
                && is_mark(tokens.get(at + 2), '=')
            {
                let names = params(&inside(pattern));
                let end = (at..tokens.len()).find(|&at| is_mark(tokens.get(at), ';')).unwrap_or(tokens.len());
                if let Some(place) = names.iter().position(|name| name == "help") {
                    self.take_of_tuples(&tokens[at + 3..end], (place, names.len()), of, 0);
                }
            }
            // A field without its value: `Diagnostic { text, help }`.
            if is_group(tree, Delimiter::Brace) {
                let inner = inside(tree);
                let short = parts(&inner).into_iter().filter(|part| part.len() == 1 && is_word(part.first(), "help"));
                short.for_each(|help| self.take(help, of, 0));
            }
            if matches!(tree, TokenTree::Group(_)) {
                self.look_through(&inside(tree), of);
            }
        }
    }

    /// Takes one element of each tuple of a length.
    fn take_of_tuples(&mut self, tokens: &[TokenTree], (place, length): (usize, usize), of: usize, depth: usize) {
        for (at, tree) in tokens.iter().enumerate() {
            let inner = inside(tree);
            let elements = parts(&inner);
            let is_call = at > 0
                && (word(tokens.get(at - 1)).is_some_and(|word| !KEYWORDS.contains(&&*word))
                    || is_mark(tokens.get(at - 1), '!'));
            let is_pattern = is_mark(tokens.get(at + 1), '=') && is_mark(tokens.get(at + 2), '>');
            if is_group(tree, Delimiter::Parenthesis) && elements.len() == length && !is_call && !is_pattern {
                self.take(elements[place], of, depth);
            } else {
                self.take_of_tuples(&inner, (place, length), of, depth);
            }
        }
    }

    /// Takes the texts of a hint.
    fn take(&mut self, tokens: &[TokenTree], of: usize, depth: usize) {
        self.take_texts(tokens, of, depth, false);
    }

    fn take_texts(&mut self, tokens: &[TokenTree], of: usize, depth: usize, is_part: bool) {
        if depth > 8 {
            return;
        }
        let mut at = 0;
        while at < tokens.len() {
            let tree = &tokens[at];
            let next = tokens.get(at + 1);
            let is_pattern = is_mark(next, '=') && is_mark(tokens.get(at + 2), '>') || is_mark(next, '|');
            match tree {
                TokenTree::Literal(literal) if !is_pattern => {
                    if let Some(text) = text_of(&literal.to_string()) {
                        // The braces of a text that is no template.
                        let text = text.replace('{', "{{").replace('}', "}}");
                        let line = literal.span().start().line;
                        self.add(&text, line, of, depth, is_part);
                    }
                }
                TokenTree::Ident(name) if FORMATS.iter().any(|format| name == format) && is_mark(next, '!') => {
                    // What is shown in the text is no hint.
                    let args = tokens.get(at + 2).map(inside).unwrap_or_default();
                    let template = args.iter().find_map(|tree| match tree {
                        TokenTree::Literal(literal) => Some((text_of(&literal.to_string())?, literal)),
                        _ => None,
                    });
                    if let Some((text, literal)) = template {
                        self.add(&text, literal.span().start().line, of, depth, is_part);
                    }
                    at += 2;
                }
                // Its arguments are looked through where it is called.
                TokenTree::Ident(name) if self.takes_hint(&name.to_string(), tokens, at, of) => at += 1,
                // An attribute.
                TokenTree::Punct(mark) if mark.as_char() == '#' => at += 1,
                TokenTree::Ident(name) => self.follow(&name.to_string(), tokens, at, of, depth, is_part),
                TokenTree::Group(_) => self.take_texts(&inside(tree), of, depth, is_part),
                _ => {}
            }
            at += 1;
        }
    }

    /// Whether a name in some tokens is that of a function that is called and takes a hint.
    fn takes_hint(&self, name: &str, tokens: &[TokenTree], at: usize, of: usize) -> bool {
        let before = |steps: usize| at.checked_sub(steps).and_then(|at| tokens.get(at));
        if !tokens.get(at + 1).is_some_and(|tree| is_group(tree, Delimiter::Parenthesis)) {
            return false;
        }
        let functions = self.sources.named(name, is_mark(before(1), '.'), of);
        name == "cl_fault" || functions.iter().any(|index| self.takers.iter().any(|(taker, _)| taker == index))
    }

    fn add(&mut self, text: &str, line: usize, of: usize, depth: usize, is_part: bool) {
        // Words and single values are shown in hints, and are none.
        if text.split_whitespace().count() < 2 {
            return;
        }
        let file = self.sources.functions[of].file.clone();
        let file = file.strip_prefix(workspace()).unwrap_or(&file);
        let place = format!("{}:{line}", file.display());
        let hint = Hint { template: text.to_owned(), place, is_part };
        if !self.hints.contains(&Hint { is_part: false, ..hint.clone() }) {
            self.hints.insert(hint);
        }
        for name in shown_names(text) {
            self.follow(name, &[], 0, of, depth, true);
        }
    }

    /// Follows a name to its constant, its variable, its function, or the parameter whose arguments are hints.
    fn follow(&mut self, name: &str, tokens: &[TokenTree], at: usize, of: usize, depth: usize, is_part: bool) {
        let sources = self.sources;
        let is_field = is_mark(at.checked_sub(1).and_then(|at| tokens.get(at)), '.');
        if !self.followed.insert((name.to_owned(), of, is_part)) {
            return;
        }
        if tokens.get(at + 1).is_some_and(|tree| is_group(tree, Delimiter::Parenthesis)) {
            let functions = sources.named(name, is_field, of);
            if functions.len() == 1 && sources.functions[functions[0]].is_text {
                self.take_texts(&sources.functions[functions[0]].body, functions[0], depth + 1, is_part);
            }
            return;
        }
        let is_asked = is_mark(tokens.get(at + 1), '.')
            && word(tokens.get(at + 2)).is_none_or(|method| !AS_TEXT.contains(&&*method));
        if is_field || is_asked || is_mark(tokens.get(at + 1), ':') {
            return;
        }
        if name.chars().all(|letter| letter.is_ascii_uppercase() || letter == '_' || letter.is_ascii_digit()) {
            let named = || sources.constants.iter().filter(|constant| constant.name == name);
            let of_file = named().find(|constant| constant.file == sources.functions[of].file);
            let known = of_file.or_else(|| named().next());
            let value = known.map(|constant| constant.value.clone());
            value.into_iter().for_each(|value| self.take_texts(&value, of, depth + 1, is_part));
            return;
        }
        for around in sources.around(of).collect::<Vec<_>>() {
            let function = &sources.functions[around];
            if !is_part && let Some(place) = function.params.iter().position(|param| param == name) {
                self.takers.insert((around, place));
                return;
            }
            if self.take_variable(name, &function.body, around, depth, is_part) {
                return;
            }
        }
    }

    /// Takes the texts of a variable; returns whether there is one of that name.
    fn take_variable(&mut self, name: &str, tokens: &[TokenTree], of: usize, depth: usize, is_part: bool) -> bool {
        for (at, tree) in tokens.iter().enumerate() {
            if is_word(Some(tree), "let") {
                let end = (at..tokens.len()).find(|&at| is_mark(tokens.get(at), ';')).unwrap_or(tokens.len());
                let equals = (at..end).find(|&at| is_mark(tokens.get(at), '='));
                let Some(equals) = equals else { continue };
                let pattern = &tokens[at + 1..equals];
                if pattern.iter().filter_map(|tree| word(Some(tree))).find(|word| word != "mut").as_deref()
                    == Some(name)
                {
                    self.take_texts(&tokens[equals + 1..end], of, depth + 1, is_part);
                    return true;
                }
                if let [group] = pattern {
                    let names = params(&inside(group));
                    if let Some(place) = names.iter().position(|known| known == name) {
                        self.take_of_tuples(&tokens[equals + 1..end], (place, names.len()), of, depth + 1);
                        return true;
                    }
                }
            }
            if matches!(tree, TokenTree::Group(_)) && self.take_variable(name, &inside(tree), of, depth, is_part) {
                return true;
            }
        }
        false
    }
}

/// Words of the language after which a parenthesis is no call.
const KEYWORDS: [&str; 6] = ["return", "else", "in", "match", "if", "let"];

/// Macros whose text is a template.
const FORMATS: [&str; 3] = ["format", "format_args", "write"];

/// Methods that return the text itself.
const AS_TEXT: [&str; 6] = ["into", "to_owned", "to_string", "clone", "as_str", "as_deref"];

/// The text of a literal, if it is one.
fn text_of(literal: &str) -> Option<String> {
    let inner = literal.strip_prefix('"')?.strip_suffix('"')?;
    let (mut text, mut letters) = (String::new(), inner.chars().peekable());
    while let Some(letter) = letters.next() {
        match (letter, letters.peek()) {
            ('\\', Some('\n')) => while letters.next_if(|letter| letter.is_whitespace()).is_some() {},
            ('\\', Some('n')) => {
                letters.next();
                text.push('\n');
            }
            ('\\', _) => text.extend(letters.next()),
            _ => text.push(letter),
        }
    }
    Some(text)
}
