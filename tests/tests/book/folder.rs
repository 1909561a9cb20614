//! The folder of a reader: files that a chapter shows, and its commands.

use std::collections::BTreeSet;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::{env, fs};

use tempfile::TempDir;
use tests::binaries::workspace;
use tests::environment;

use crate::chapter::{Listing, Part};
use crate::machines;

/// A temporary folder with the samples of the project.
pub(crate) struct Folder {
    root: TempDir,
    /// Exit status of the last command.
    status: u8,
    /// Files that the chapter has written and no command has named.
    unread: BTreeSet<String>,
    /// Outputs that differ from those shown: lines of the chapter, and the text.
    outputs: Vec<(Range<usize>, String)>,
}

/// Returns to the workspace, so that the last folder can be removed.
pub(crate) fn leave() {
    env::set_current_dir(workspace()).expect("the workspace");
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder of the samples") {
        let path = entry.expect("an entry").path();
        if path.is_file() {
            fs::copy(&path, to.join(path.file_name().expect("a name"))).expect("a file can be copied");
        }
    }
}

/// Words of a command; quotation marks hold a word together.
fn words(command: &str) -> Vec<String> {
    let mut words = Vec::new();
    let (mut word, mut quote) = (None::<String>, None);
    for letter in command.chars() {
        match quote {
            Some(mark) if letter == mark => quote = None,
            None if ['"', '\''].contains(&letter) => {
                quote = Some(letter);
                word.get_or_insert_default();
            }
            None if letter == ' ' => words.extend(word.take()),
            _ => word.get_or_insert_default().push(letter),
        }
    }
    words.extend(word);
    words
}

/// `s/OLD/NEW/` without patterns: the first OLD of each line.
fn substitute(script: &str, text: &str) -> Result<String, String> {
    let ["s", old, new, ""] = script.split('/').collect::<Vec<_>>()[..] else {
        return Err(format!("`{script}` is not s/OLD/NEW/"));
    };
    Ok(text.lines().map(|line| format!("{}\n", line.replacen(old, new, 1))).collect())
}

impl Folder {
    pub(crate) fn new() -> Self {
        let root = tempfile::tempdir().expect("a temporary folder");
        for samples in ["examples/cl", "examples/config", "examples/virtual"] {
            copy(&workspace().join(samples), &root.path().join(samples));
        }
        Self { root, status: 0, unread: BTreeSet::new(), outputs: Vec::new() }
    }

    /// Makes it the current folder of the process.
    pub(crate) fn enter(&self) {
        env::set_current_dir(self.root.path()).expect("the folder is there");
    }

    /// Files that no command has named.
    pub(crate) fn unread(&self) -> impl Iterator<Item = &String> {
        self.unread.iter()
    }

    /// Outputs that differ from those shown, from the first to the last.
    pub(crate) fn outputs(self) -> Vec<(Range<usize>, String)> {
        self.outputs
    }

    fn path(&self, name: &str) -> PathBuf {
        self.root.path().join(name)
    }

    /// Compares a listing with the file that it shows, or writes the file.
    pub(crate) fn file(&mut self, name: &str, listing: &Listing) -> Result<(), String> {
        let known = [self.path(name), workspace().join(name)].into_iter().find(|path| path.is_file());
        if let Some(path) = known {
            let text = fs::read_to_string(path).map_err(|error| format!("{name}: {error}"))?;
            return self.compare(name, listing.range(), &listing.text(), text);
        }
        if listing.lines.iter().any(|line| line == "...") {
            return Err(format!("{name} is not there"));
        }
        let path = self.path(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, listing.text()).expect("a file can be written");
        self.unread.insert(name.to_owned());
        Ok(())
    }

    /// Compares a picture of a chapter with the one that its commands have written, or keeps that one.
    pub(crate) fn picture(&self, kept: &Path) -> Result<(), String> {
        let name = kept.file_name().and_then(|name| name.to_str()).expect("a name");
        let written = fs::read(self.path(name)).map_err(|_| format!("no command writes the picture {name}"))?;
        if environment::blesses() {
            fs::write(kept, written).expect("a picture can be written");
            return Ok(());
        }
        let same = fs::read(kept).is_ok_and(|picture| picture == written);
        if same { Ok(()) } else { Err(format!("{name} is not what its command writes")) }
    }

    /// Runs the commands of a listing.
    pub(crate) fn run(&mut self, listing: &Listing) -> Result<(), String> {
        let mut faults = Vec::new();
        let is_command = |line: &String| line.starts_with("$ ");
        let mut at = 0;
        if !listing.lines.first().is_some_and(is_command) {
            return Err("the first line is no command".into());
        }
        while at < listing.lines.len() {
            let mut command = listing.lines[at][2..].to_owned();
            while let Some(start) = command.strip_suffix('\\') {
                at += 1;
                command = format!("{start}{}", listing.lines.get(at).map_or("", |line| line.trim_start()));
            }
            let first = at + 1;
            let shown = listing.lines[first..].iter().take_while(|line| !is_command(line)).count();
            at = first + shown;
            let asks_for_status = listing.lines.get(at).is_some_and(|next| next == "$ echo $?");
            let range = listing.line + first..listing.line + at;
            let text: String = listing.lines[first..at].iter().map(|line| format!("{line}\n")).collect();
            let result = self.command(&command).and_then(|output| self.compare(&command, range, &text, output));
            faults.extend(result.err());
            if self.status != 0 && !asks_for_status {
                faults.push(format!("`{command}` ends with status {}, and no `echo $?` shows it", self.status));
            }
        }
        if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
    }

    fn compare(&mut self, name: &str, range: Range<usize>, shown: &str, real: String) -> Result<(), String> {
        if Part::of(shown).is_in(&real) {
            return Ok(());
        }
        let fault = format!("{name}\n--- shown\n{shown}--- real\n{real}---");
        self.outputs.push((range, real));
        Err(fault)
    }

    /// Runs a command: what it prints.
    fn command(&mut self, command: &str) -> Result<String, String> {
        let mut words = words(command);
        for word in &words {
            self.unread.remove(word);
        }
        let target = match words.iter().position(|word| word == ">") {
            Some(at) => words.drain(at..).nth(1),
            None => None,
        };
        // From a clone of the project, `cargo run` comes before the machine.
        if words.starts_with(&["cargo".to_owned(), "run".to_owned()]) {
            let machine = words.iter().position(|word| word == "--bin").ok_or("a machine is missing")? + 1;
            let options = words.iter().position(|word| word == "--").unwrap_or(words.len() - 1);
            words.drain(machine + 1..=options);
            words.drain(..machine);
        }
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let status = std::mem::take(&mut self.status);
        let mut to_file = Vec::new();
        let output = match words[..] {
            ["echo", "$?"] => format!("{status}\n"),
            ["cat", file] => self.read(file)?,
            ["sed", script, file] => substitute(script, &self.read(file)?)?,
            ["generate_designs"] => self.write_designs(),
            [machine, ref arguments @ ..] if machines::is_one(machine) => {
                let (status, messages) = match target {
                    Some(_) => machines::run_to(machine, arguments, &mut to_file),
                    None => machines::run(machine, arguments),
                };
                self.status = status as u8;
                messages
            }
            _ => return Err(format!("`{}` is no command", words.first().unwrap_or(&""))),
        };
        let Some(file) = target else { return Ok(output) };
        // Messages of a machine are shown all the same.
        let (written, shown) = match words[0] {
            "cat" | "sed" | "echo" => (output.into_bytes(), String::new()),
            _ => (to_file, output),
        };
        fs::write(self.path(&file), written).expect("a file can be written");
        Ok(shown)
    }

    fn read(&self, file: &str) -> Result<String, String> {
        fs::read_to_string(self.path(file)).map_err(|error| format!("{file}: {error}"))
    }

    /// What `generate_designs` does in the workspace.
    fn write_designs(&self) -> String {
        for (name, design) in examples::designs::designs() {
            let mut file = fs::File::create(self.path("examples/virtual").join(name)).expect("a file");
            design.write(&mut file).expect("a file can be written");
        }
        String::new()
    }
}
