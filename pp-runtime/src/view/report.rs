//! The set-up sheet as HTML, as Markdown and as JSON, and sections of a document in HTML.

use std::io::{self, Write};

use super::ViewedProgram;
use super::html::{Escaped, begin};
use super::sheet::{DocumentSection, JobSheet, SectionBody};

/// Style of the sheet: black on white, one page for each set-up.
const STYLE: &str = "\
body{font:10pt/1.35 sans-serif;margin:12mm;color:#000;background:#fff}\
h1,h2{margin:.6em 0 .3em}h1{font-size:16pt}h2{font-size:12pt}\
table{border-collapse:collapse;margin:.4em 0}td,th{border:1px solid #888;padding:.15em .5em;text-align:left}\
figure{margin:.4em 0}figure svg{width:100%;max-width:1000px;height:auto;border:1px solid #888}\
figcaption{font-size:9pt}ul{margin:.2em 0;padding-left:1.3em}pre{font-size:8pt}\
@media print{body{margin:0}.page{break-before:page}table,figure{break-inside:avoid}}";

/// Form of a set-up sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ReportForm {
    /// With pictures.
    Html,
    /// Without pictures.
    Markdown,
    /// The numbers.
    Json,
}

impl ReportForm {
    /// Forms by the extension of a file.
    pub(crate) const EXTENSIONS: [(&'static str, Self); 3] =
        [("html", Self::Html), ("md", Self::Markdown), ("json", Self::Json)];
}

/// Writes the set-up sheet. `jog_sheet`: with the directions in which the axes must move.
///
/// # Errors
/// Errors of the output.
pub(crate) fn write_report(
    program: &ViewedProgram<'_>,
    form: ReportForm,
    jog_sheet: bool,
    out: &mut dyn Write,
) -> io::Result<()> {
    let sheet = JobSheet::of(program, jog_sheet);
    match form {
        ReportForm::Html => {
            begin(&sheet.title(), STYLE, None, out)?;
            html(&sheet.set_up_sheet(program, true)?, out)?;
            out.write_all(b"</body></html>\n")
        }
        ReportForm::Markdown => markdown(&sheet.set_up_sheet(program, false)?, out),
        ReportForm::Json => {
            serde_json::to_writer_pretty(&mut *out, &sheet)?;
            out.write_all(b"\n")
        }
    }
}

/// Writes sections in HTML; the title of the first is that of the document.
pub(crate) fn html(sections: &[DocumentSection], out: &mut dyn Write) -> io::Result<()> {
    for (index, section) in sections.iter().enumerate() {
        let heading = if index == 0 { "h1" } else { "h2" };
        let class = if section.page { " class=\"page\"" } else { "" };
        writeln!(out, "<section{class}><{heading}>{}</{heading}>", Escaped(&section.title))?;
        for body in &section.body {
            match body {
                SectionBody::Lines(lines) => {
                    out.write_all(b"<ul>\n")?;
                    lines.iter().try_for_each(|line| writeln!(out, "<li>{}</li>", Escaped(line)))?;
                    out.write_all(b"</ul>\n")?;
                }
                SectionBody::Table(columns, rows) => {
                    let cells = |tag: &str, cells: &mut dyn Iterator<Item = &str>| -> String {
                        cells.map(|cell| format!("<{tag}>{}</{tag}>", Escaped(cell))).collect()
                    };
                    writeln!(out, "<table>\n<tr>{}</tr>", cells("th", &mut columns.iter().copied()))?;
                    for row in rows {
                        writeln!(out, "<tr>{}</tr>", cells("td", &mut row.iter().map(String::as_str)))?;
                    }
                    out.write_all(b"</table>\n")?;
                }
                SectionBody::Picture(svg, text) => {
                    writeln!(out, "<figure>{svg}<figcaption>{}</figcaption></figure>", Escaped(text))?;
                }
                SectionBody::Aligned(lines) => writeln!(out, "<pre>{}</pre>", Escaped(lines.join("\n")))?,
            }
        }
        out.write_all(b"</section>\n")?;
    }
    Ok(())
}

/// Text with the characters that Markdown would read taken literally.
fn literal(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    for character in text.chars() {
        if r"\`*_[]<>|#&".contains(character) {
            written.push('\\');
        }
        // A line end would end a heading or a row.
        written.push(if character.is_control() { ' ' } else { character });
    }
    written
}

/// Literal text as an item of a list: it begins no list of its own.
fn literal_item(text: &str) -> String {
    let number = text.len() - text.trim_start_matches(|character: char| character.is_ascii_digit()).len();
    let (number, rest) = text.split_at(number);
    let begins_list = rest.starts_with(['+', '-', '~', '.', ')']);
    format!("{number}{}{}", if begins_list { "\\" } else { "" }, literal(rest))
}

fn markdown(sections: &[DocumentSection], out: &mut dyn Write) -> io::Result<()> {
    for (index, section) in sections.iter().enumerate() {
        writeln!(out, "{} {}\n", if index == 0 { "#" } else { "\n##" }, literal(&section.title))?;
        for (index, body) in section.body.iter().enumerate() {
            if index > 0 {
                out.write_all(b"\n")?;
            }
            match body {
                SectionBody::Lines(lines) => {
                    lines.iter().try_for_each(|line| writeln!(out, "- {}", literal_item(line)))?
                }
                SectionBody::Table(columns, rows) => {
                    writeln!(out, "| {} |\n|{}", columns.join(" | "), " --- |".repeat(columns.len()))?;
                    for row in rows {
                        let cells: Vec<String> = row.iter().map(|cell| literal(cell)).collect();
                        writeln!(out, "| {} |", cells.join(" | "))?;
                    }
                }
                SectionBody::Picture(..) => {}
                SectionBody::Aligned(lines) => lines.iter().try_for_each(|line| writeln!(out, "    {line}"))?,
            }
        }
    }
    Ok(())
}
