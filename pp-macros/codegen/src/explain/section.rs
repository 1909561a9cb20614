//! Sections: the same lines as text and as LaTeX.

use crate::formula::Formula;

/// Longest line of text.
pub(crate) const WIDTH: usize = 96;

/// One section in both forms.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Section {
    /// Lines of text.
    pub text: Vec<String>,
    /// Paragraphs of LaTeX.
    pub latex: Vec<String>,
}

/// One line of words and formulas.
#[derive(Debug, Clone, Default)]
pub(crate) struct Line {
    text: String,
    latex: String,
}

/// Starts a line.
pub(crate) fn line(words: &str) -> Line {
    Line::default().words(words)
}

impl Line {
    /// Appends words.
    pub(crate) fn words(mut self, words: &str) -> Self {
        self.text += words;
        self.latex += &escaped(words);
        self
    }

    /// Appends a formula.
    pub(crate) fn math(mut self, formula: &Formula) -> Self {
        self.text += &formula.text();
        self.latex += &format!("${}$", formula.latex());
        self
    }

    /// Appends another line.
    pub(crate) fn append(mut self, other: &Self) -> Self {
        self.text += &other.text;
        self.latex += &other.latex;
        self
    }

    /// Appends a piece that is given in both forms.
    pub(crate) fn both(mut self, text: &str, latex: &str) -> Self {
        self.text += text;
        self.latex += latex;
        self
    }

    /// Appends a vector.
    pub(crate) fn vector(self, parts: &[Formula]) -> Self {
        let [text, latex] = [Formula::text, Formula::latex].map(|spelled| {
            let parts: Vec<String> = parts.iter().map(spelled).collect();
            format!("({})", parts.join(", "))
        });
        self.both(&text, &format!("${latex}$"))
    }
}

impl Section {
    /// Adds a line; a long one is wrapped, its continuation indented.
    pub(crate) fn line(&mut self, line: Line) {
        self.text.extend(wrapped(&line.text, 4, false));
        self.latex.push(line.latex);
    }

    /// Adds a line of words.
    pub(crate) fn words(&mut self, words: &str) {
        self.line(line(words));
    }

    /// Adds an empty line of text.
    pub(crate) fn gap(&mut self) {
        if self.text.last().is_some_and(|last| !last.is_empty()) {
            self.text.push(String::new());
        }
    }

    /// Adds aligned columns; blank columns are left out.
    pub(crate) fn table(&mut self, rows: &[Vec<Line>]) {
        let columns = rows.iter().map(Vec::len).max().unwrap_or_default();
        let width = |column: usize| rows.iter().filter_map(|row| row.get(column)).map(|cell| length(&cell.text)).max();
        let used: Vec<usize> = (0..columns).filter(|column| width(*column).unwrap_or_default() > 0).collect();
        for row in rows {
            let cells = used.iter().filter_map(|column| row.get(*column).map(|cell| (*column, cell)));
            let cells = cells.map(|(column, cell)| padded(&cell.text, width(column).unwrap_or_default(), false));
            self.text.push(cells.collect::<Vec<_>>().join("  ").trim_end().to_string());
        }
        let rows: Vec<String> = rows
            .iter()
            .map(|row| {
                let cells = used.iter().filter_map(|column| row.get(*column));
                cells.map(|cell| cell.latex.as_str()).collect::<Vec<_>>().join(" & ")
            })
            .collect();
        let kinds = "l".repeat(used.len());
        self.latex.push(format!("\\begin{{tabular}}{{@{{}}{kinds}@{{}}}}\n{}\n\\end{{tabular}}", rows.join(" \\\\\n")));
    }

    /// Adds equations, their equals signs aligned.
    pub(crate) fn equations(&mut self, equations: &[(Formula, Formula)]) {
        let width = equations.iter().map(|(left, _)| length(&left.text())).max().unwrap_or_default();
        for (left, right) in equations {
            let text = format!("{} = {}", padded(&left.text(), width, false), right.text());
            self.text.extend(wrapped(&text, width + 3, true));
            self.latex.push(format!("$\\displaystyle {} = {}$", left.latex(), right.latex()));
        }
    }

    /// Adds a `verify` block in the language of the macro, as text only. Axes whose equations are left out are named in
    /// a comment.
    pub(crate) fn block(&mut self, source: &str, equations: &[(Formula, Formula)], left_out: &[String]) {
        self.text.push(format!("verify \"{source}\" {{"));
        for (left, right) in equations {
            let text = format!("    {} = {};", left.source(), right.source());
            self.text.extend(wrapped(&text, 8, true));
        }
        for axes in left_out {
            self.text.push(format!("    // {axes}: computed step by step, too long for one equation"));
        }
        self.text.push("}".into());
    }

    /// Adds `name = matrix`, in one piece if it fits, else an equation for each entry.
    pub(crate) fn matrix(&mut self, name: &Formula, rows: &[Vec<Formula>], entry: &str) {
        let texts: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(Formula::text).collect()).collect();
        let columns = texts.first().map_or(0, Vec::len);
        let widths: Vec<usize> =
            (0..columns).map(|column| texts.iter().map(|row| length(&row[column])).max().unwrap_or_default()).collect();
        let head = format!("{} = ", name.text());
        if length(&head) + 4 + widths.iter().sum::<usize>() + 2 * columns > WIDTH {
            let entries = rows.iter().enumerate().take(3).flat_map(|(row, entries)| {
                entries.iter().enumerate().map(move |(column, formula)| {
                    (Formula::name(format!("{entry}{}{}", row + 1, column + 1)), formula.clone())
                })
            });
            self.equations(&entries.collect::<Vec<_>>());
            let last: Vec<Formula> = rows.iter().skip(3).flatten().cloned().collect();
            self.line(line("last row ").vector(&last));
            return;
        }
        for (index, row) in texts.iter().enumerate() {
            let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| padded(cell, *width, true)).collect();
            let margin = if index == 0 { head.clone() } else { " ".repeat(length(&head)) };
            self.text.push(format!("{margin}| {} |", cells.join("  ")));
        }
        let rows: Vec<String> =
            rows.iter().map(|row| row.iter().map(Formula::latex).collect::<Vec<_>>().join(" & ")).collect();
        let name = name.latex();
        self.latex
            .push(format!("$\\displaystyle {name} = \\begin{{bmatrix}}\n{}\n\\end{{bmatrix}}$", rows.join(" \\\\\n")));
    }
}

/// Number of characters, not bytes.
fn length(text: &str) -> usize {
    text.chars().count()
}

fn padded(text: &str, width: usize, right: bool) -> String {
    let blanks = " ".repeat(width.saturating_sub(length(text)));
    if right { blanks + text } else { text.to_string() + &blanks }
}

/// Lines of at most [`WIDTH`] columns. Words are broken at blanks, formulas before a sign or after a comma of the
/// outermost brackets.
fn wrapped(text: &str, indent: usize, formula: bool) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest: Vec<char> = text.chars().collect();
    while rest.len() > WIDTH {
        let Some(cut) = place_to_break(&rest, indent, formula) else { break };
        let (line, next) = rest.split_at(cut);
        lines.push(line.iter().collect::<String>().trim_end().to_string());
        let next: String = next.iter().collect();
        rest = " ".repeat(indent).chars().chain(next.trim_start().chars()).collect();
    }
    lines.push(rest.iter().collect());
    lines
}

fn place_to_break(text: &[char], indent: usize, formula: bool) -> Option<usize> {
    let mut depth = 0_usize;
    let mut best: Option<(usize, usize)> = None;
    for (index, character) in text.iter().enumerate().take(WIDTH) {
        match character {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        let next = |ahead: usize| text.get(index + ahead).copied();
        let sign = *character == ' ' && matches!(next(1), Some('+' | '-')) && next(2) == Some(' ');
        let comma = index > 0 && *character == ' ' && text[index - 1] == ',';
        let rank = match formula {
            false => 0,
            true if sign || comma => depth,
            true => 100 + depth,
        };
        let far = index > WIDTH / 3 && index > indent;
        if *character == ' ' && far && best.is_none_or(|(known, _)| rank <= known) {
            best = Some((rank, index));
        }
    }
    best.map(|(_, index)| index)
}

/// Words with the special characters of LaTeX escaped.
pub(crate) fn escaped(words: &str) -> String {
    let mut text = String::new();
    let mut before = ' ';
    for character in words.replace("<=", "≤").replace(">=", "≥").replace("!=", "≠").chars() {
        match character {
            // Equations (6)-(9).
            '-' if before == ')' => text += "--",
            // A minus sign, not a hyphen.
            '-' if !before.is_alphabetic() => text += "$-$",
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                text.push('\\');
                text.push(character);
            }
            '\\' => text += "\\textbackslash{}",
            '^' => text += "\\textasciicircum{}",
            '~' => text += "\\textasciitilde{}",
            '|' => text += "$\\mid$",
            '<' => text += "$<$",
            '>' => text += "$>$",
            '°' => text += "$^{\\circ}$",
            '√' => text += "$\\surd$",
            '·' => text += "$\\cdot$",
            '≥' => text += "$\\geq$",
            '≤' => text += "$\\leq$",
            '≠' => text += "$\\neq$",
            '²' => text += "$^{2}$",
            '"' => text += "''",
            other => text.push(other),
        }
        before = character;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_break_at_the_outermost_sign() {
        let term = "(aaaa bbbb + cccc dddd) eeee ffff";
        let text = format!("X = {term} - {term} + {term} - {term}");
        let lines = wrapped(&text, 4, true);
        assert_eq!(lines, [format!("X = {term} - {term}"), format!("    + {term} - {term}")]);
        assert!(lines.iter().all(|line| length(line) <= WIDTH));
        let joined = lines.iter().map(|line| line.trim()).collect::<Vec<_>>().join(" ");
        assert_eq!(joined, text);
    }

    #[test]
    fn special_characters_in_words_are_not_latex_commands() {
        assert_eq!(escaped("50% of $x_1 & {a}"), r"50\% of \$x\_1 \& \{a\}");
        assert_eq!(escaped(r"\input"), r"\textbackslash{}input");
        assert_eq!(escaped("left-hand (-X)"), "left-hand ($-$X)");
    }
}
