//! Tests of the foreign interpreter by small programs.

mod careless;
mod controls;
mod flow;
mod guards;
mod linuxcnc;
mod modes;

use super::{Control, Executed, Options, State, Trace, run};

/// First blocks of a program, up to a tool with its length and a spindle that runs.
fn start(control: Control) -> &'static str {
    match control {
        Control::LinuxCnc => "G21 G17 G40 G49 G80 G90 G91.1 G94 G54\nT1 M6\nG43 H1\nS100 M3\n",
        Control::Fanuc => "%\nO0001 (PART)\nG21 G17 G40 G49 G80 G90 G94 G54\nT1 M6\nS100 M3\nG43 H1\n",
        Control::Haas => "%\nO00001 (PART)\nG21 G17 G40 G49 G80 G90 G94 G54\nT1 M06\nS100 M03\nG43 H1\n",
        Control::Siemens => "G710 G17 G40 G64 G90 G94 G54\nT1\nM6\nD1\nS100 M3\n",
        Control::Heidenhain => {
            "BEGIN PGM PART MM\nCYCL DEF 247 DATUM SETTING ~\n  Q339=+1 ;DATUM NUMBER\nTOOL CALL 1 Z S100\nM3\n"
        }
    }
}

/// A whole program: the first blocks, some more, the end.
fn program(control: Control, blocks: &str) -> String {
    let end = match control {
        Control::LinuxCnc => "M2\n",
        Control::Fanuc | Control::Haas => "M30\n%\n",
        Control::Siemens => "M30\n",
        Control::Heidenhain => "M30\nEND PGM PART MM\n",
    };
    let lines =
        format!("{}{}{end}", start(control), if blocks.is_empty() { String::new() } else { format!("{blocks}\n") });
    if control != Control::Heidenhain {
        return lines;
    }
    let mut number = 0;
    let mut numbered = String::new();
    for line in lines.lines() {
        // A line that continues another has no number.
        if line.starts_with(' ') {
            numbered += &format!("{line}\n");
        } else {
            numbered += &format!("{number} {line}\n");
            number += 1;
        }
    }
    numbered
}

fn trace(control: Control, blocks: &str) -> Trace {
    let read = run(&program(control, blocks), &Options::of(control));
    read.unwrap_or_else(|refused| panic!("{control:?} {blocks:?}: {refused}"))
}

/// Blocks that move something.
fn motions(control: Control, blocks: &str) -> Vec<Executed> {
    trace(control, blocks).motions().cloned().collect()
}

/// State before the end of the program.
fn state_after(control: Control, blocks: &str) -> State {
    let blocks = trace(control, blocks).blocks;
    blocks[blocks.len() - 2].state
}

/// Why a program is refused.
fn refusal(control: Control, blocks: &str) -> String {
    match run(&program(control, blocks), &Options::of(control)) {
        Ok(_) => panic!("{control:?} {blocks:?} is accepted"),
        Err(refused) => refused.why,
    }
}
