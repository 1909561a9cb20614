//! The part of the page that is readable and printable without a script: summary, operations, tools, extremes, checks.

use std::fmt::Display;
use std::io::{self, Write};

use super::ViewedProgram;
use super::head::Head;
use super::html::Escaped;

/// Writes the summary of a program.
pub(crate) fn write(program: &ViewedProgram<'_>, head: &Head<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "<h1>{}</h1>", Escaped(&program.titles.program))?;
    let lines = program.summary().into_iter();
    list(lines, out)?;
    let _ = head;
    Ok(())
}

fn list(lines: impl Iterator<Item = impl Display>, out: &mut dyn Write) -> io::Result<()> {
    out.write_all(b"<ul>\n")?;
    for line in lines {
        writeln!(out, "<li>{}</li>", Escaped(line))?;
    }
    out.write_all(b"</ul>\n")
}
