//! Lines of C, indented by their braces.

use super::PREFIX;
use crate::emit::body::Statement;
use crate::emit::inputs::{Input, InputSource};
use crate::model::Model;

/// Longest line of comments and signatures; formulas are not broken.
const WIDTH: usize = 100;

/// Text that is being written.
#[derive(Debug, Default)]
pub(super) struct Code {
    text: String,
    depth: usize,
}

impl Code {
    pub(super) fn text(self) -> String {
        self.text
    }

    /// One line; an empty one is not indented.
    pub(super) fn line(&mut self, line: impl AsRef<str>) {
        let line = line.as_ref();
        if !line.is_empty() {
            self.text.push_str(&"    ".repeat(self.depth));
            self.text.push_str(line);
        }
        self.text.push('\n');
    }

    /// `head { .. }`, or a block without a head
    pub(super) fn block(&mut self, head: impl AsRef<str>, body: impl FnOnce(&mut Self)) {
        self.line(format!("{} {{", head.as_ref()).trim_start());
        self.depth += 1;
        body(self);
        self.depth -= 1;
        self.line("}");
    }

    /// A comment, wrapped.
    pub(super) fn comment(&mut self, comment: &str) {
        let mut line = String::from("/*");
        for word in comment.split_whitespace() {
            if line.len() + 1 + word.len() > WIDTH {
                self.line(&line);
                line = String::from("  ");
            }
            line.push(' ');
            line.push_str(word);
        }
        self.line(line + " */");
    }

    /// A function with a comment before it.
    pub(super) fn function(&mut self, comment: &str, signature: impl AsRef<str>, body: impl FnOnce(&mut Self)) {
        self.line("");
        self.comment(comment);
        let signature = format!("static inline {}", signature.as_ref());
        match signature.split_once('(') {
            Some((head, parameters)) if signature.len() > WIDTH => {
                self.line(format!("{head}("));
                self.line(format!("    {parameters}"));
            }
            _ => self.line(signature),
        }
        self.block("", body);
    }

    /// Parameters that a machine may not need.
    pub(super) fn unused(&mut self, names: &[&str]) {
        let names: Vec<String> = names.iter().map(|name| format!("(void){name};")).collect();
        self.line(names.join(" "));
    }

    /// `const double name = value;`
    pub(super) fn constant(&mut self, name: &str, value: impl AsRef<str>) {
        self.line(format!("const double {name} = {};", value.as_ref()));
    }

    pub(super) fn statements(&mut self, statements: &[Statement]) {
        for (name, value) in statements {
            self.constant(name, value);
        }
    }

    /// Inputs of a function.
    pub(super) fn inputs(&mut self, model: &Model, inputs: &[Input<'_>]) {
        for input in inputs {
            match *input {
                Input::Value(name, source) => self.constant(name, value(model, source)),
                Input::Angle(names, source) => {
                    for (index, name) in names.into_iter().enumerate() {
                        let Some(name) = name else { continue };
                        let of = value(model, source);
                        match source {
                            InputSource::Turn(..) => self.constant(name, format!("{of}[{index}]")),
                            _ => self.constant(name, format!("{}({of})", named(["sin", "cos"][index]))),
                        }
                    }
                }
            }
        }
    }
}

fn value(model: &Model, source: InputSource<'_>) -> String {
    match source {
        InputSource::Component(array, index) | InputSource::Word(array, index) | InputSource::Turn(array, index) => {
            format!("{array}[{index}]")
        }
        InputSource::PartOrigin(index) => format!("m->part_origin[{index}]"),
        InputSource::GaugeLength => "m->gauge_length".into(),
        InputSource::Dimension(name) => format!("m->{}", model.c_field(name)),
    }
}

/// An expression as an operand: in brackets, unless it is a name, a number or a call.
pub(super) fn grouped(expression: &str) -> String {
    if expression.contains(' ') { format!("({expression})") } else { expression.to_owned() }
}

/// Sine and cosine of an angle, as a pair.
pub(super) fn turn_of(angle: &str) -> String {
    format!("{{{}({angle}), {}({angle})}}", named("sin"), named("cos"))
}

/// A name with the prefix of the machine.
pub(super) fn named(name: &str) -> String {
    format!("{PREFIX}_{name}")
}
