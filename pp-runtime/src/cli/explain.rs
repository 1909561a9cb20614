//! `explain`: the derivation of a machine's kinematics as text or as a LaTeX document.

use std::io::{self, Write};

use crate::kinematics::AnyMachine;

/// Writes the derivation of the kinematics as text.
pub(crate) fn text(machine: &dyn AnyMachine, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{}: derivation of the kinematics; formulas in millimetres and radians", machine.name())?;
    for (title, section) in machine.explanation().sections() {
        if section.text.is_empty() {
            continue;
        }
        writeln!(out, "\n{title}")?;
        for line in section.text {
            if line.is_empty() {
                writeln!(out)?;
            } else {
                writeln!(out, "    {line}")?;
            }
        }
    }
    Ok(())
}

/// Writes the formulas as `verify` blocks, to be compared with a publication or pasted into the declaration.
pub(crate) fn verify(machine: &dyn AnyMachine, out: &mut dyn Write) -> io::Result<()> {
    machine.explanation().verify.text.iter().try_for_each(|line| writeln!(out, "{line}"))
}

/// Preamble of the document. Formulas are set as paragraphs, so that TeX breaks long ones at an operator.
const PREAMBLE: &str = r"\documentclass[a4paper,11pt]{article}
\usepackage[T1]{fontenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage[utf8]{inputenc}
\usepackage[margin=22mm]{geometry}
\usepackage{amsmath}
\usepackage{amssymb}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\setcounter{MaxMatrixCols}{12}
\binoppenalty=100
\relpenalty=500
\raggedright
\raggedbottom
";

/// Writes the derivation as a complete LaTeX document.
pub(crate) fn latex(machine: &dyn AnyMachine, out: &mut dyn Write) -> io::Result<()> {
    let name = machine.name().replace('_', r"\_");
    writeln!(out, "{PREAMBLE}\\begin{{document}}\n")?;
    writeln!(out, "{{\\Large {name}: derivation of the kinematics}}\n")?;
    writeln!(out, "Formulas in millimetres and radians.")?;
    for (title, section) in machine.explanation().sections() {
        if section.latex.is_empty() {
            continue;
        }
        writeln!(out, "\n\\section*{{{title}}}")?;
        for paragraph in section.latex {
            writeln!(out, "\n{paragraph}")?;
        }
    }
    writeln!(out, "\n\\end{{document}}")
}
