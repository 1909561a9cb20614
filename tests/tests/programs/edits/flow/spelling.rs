//! Variables, conditions, loops and subprograms as each control writes them.

use tests::foreign::Control::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use tests::random::Random;

/// A number as a control reads it in an expression.
pub(super) fn number(control: Control, value: f64) -> String {
    match control {
        Fanuc | Haas if value.fract() == 0.0 => format!("{value:.0}."),
        Heidenhain => format!("{value:+}"),
        _ => format!("{value}"),
    }
}

pub(super) fn variable(control: Control, name: usize) -> String {
    match control {
        LinuxCnc if name.is_multiple_of(2) => format!("#<value_{name}>"),
        LinuxCnc | Fanuc | Haas => format!("#{}", 100 + name),
        Siemens => format!("R{}", 100 + name),
        Heidenhain if name.is_multiple_of(2) => format!("QL{}", 10 + name),
        Heidenhain => format!("Q{}", 10 + name),
    }
}

/// A line that sets a variable.
pub(super) fn set(control: Control, name: usize, value: f64) -> String {
    let (variable, number) = (variable(control, name), number(control, value));
    match control {
        Heidenhain if name.is_multiple_of(3) => format!("FN 0: {variable} = {number}"),
        Heidenhain => format!("{variable} = {number}"),
        _ => format!("{variable}={number}"),
    }
}

/// Adds one to a variable.
fn count(control: Control, name: usize) -> String {
    let variable = variable(control, name);
    match control {
        LinuxCnc => format!("{variable}=[{variable}+1]"),
        Heidenhain if name.is_multiple_of(3) => format!("FN 1: {variable} = +{variable} + +1"),
        Heidenhain => format!("{variable} = {variable} + 1"),
        _ => format!("{variable}={variable}+1"),
    }
}

/// Expressions and their values. AND, OR and XOR of whole numbers on Fanuc and Haas and FIX of a negative number on
/// LinuxCNC are left out: the check computes them otherwise than the manuals and LinuxCNC.
fn expressions(control: Control) -> &'static [(&'static str, f64)] {
    match control {
        LinuxCnc => &[
            ("2 + 3 * 4", 14.0),
            ("10 - 4 - 3", 3.0),
            ("24 / 4 / 2", 3.0),
            ("2 ** 3 * 2", 16.0),
            ("[1 + 2] * -3", -9.0),
            ("7 MOD 4", 3.0),
            ("[3 GT 2]", 1.0),
            ("[[1 EQ 2] OR [2 LT 3]]", 1.0),
            ("SIN[30] * 2", 1.0),
            ("COS[60] + TAN[45]", 1.5),
            ("ATAN[1]/[-1]", 135.0),
            ("ASIN[.5]", 30.0),
            ("FIX[2.8] + FUP[2.2]", 5.0),
            ("FUP[-2.2]", -2.0),
            ("-7 MOD 4", 1.0),
            ("ROUND[2.6] - ABS[-3]", 0.0),
        ],
        Fanuc | Haas => &[
            ("2 + 3 * 4", 14.0),
            ("10 - 4 - 3", 3.0),
            ("24 / 4 / 2", 3.0),
            ("[1 + 2] * 3", 9.0),
            ("7 MOD 4", 3.0),
            ("SIN[30] * 2", 1.0),
            ("COS[60.] + TAN[45.]", 1.5),
            ("ATAN[1]/[-1]", 135.0),
            ("FIX[2.8] + FUP[2.2]", 5.0),
            ("ROUND[2.6] - ABS[-3.]", 0.0),
        ],
        Siemens => &[
            ("2+3*4", 14.0),
            ("10-4-3", 3.0),
            ("24/4/2", 3.0),
            ("(1+2)*-3", -9.0),
            ("7 DIV 2", 3.0),
            ("7 MOD 4", 3.0),
            ("SIN(30)*2", 1.0),
            ("COS(60)+TAN(45)", 1.5),
            ("ATAN2(1,-1)", 135.0),
            ("POT(3)-SQRT(16)", 5.0),
            ("TRUNC(2.8)+ROUND(2.6)", 5.0),
            ("ABS(-3)", 3.0),
        ],
        Heidenhain => &[
            ("2 + 3 * 4", 14.0),
            ("10 - 4 - 3", 3.0),
            ("( 1 + 2 ) * 3", 9.0),
            ("SIN 30 * 2", 1.0),
            ("COS 60 + TAN 45", 1.5),
            ("2 ^ 3", 8.0),
            ("SQ 3 - SQRT 16", 5.0),
            ("INT 2.8", 2.0),
            ("ABS ( 1 - 4 )", 3.0),
        ],
    }
}

/// A line that sets a variable, and the word that has the value by it.
pub(super) fn word(control: Control, word: (&str, f64), name: usize, random: &mut Random) -> (String, String) {
    let (letters, value) = word;
    let variable = variable(control, name);
    let form = random.below(4);
    let known = expressions(control);
    let (expression, known) = known[random.below(known.len())];
    let held = [value, -value, value / 2.0, value - known][form];
    let set = set(control, name, held);
    let word = match (control, form) {
        (LinuxCnc | Fanuc | Haas, 0) => format!("{letters}{variable}"),
        (LinuxCnc | Fanuc | Haas, 1) => format!("{letters}-{variable}"),
        (LinuxCnc | Fanuc | Haas, 2) => format!("{letters}[2*{variable}]"),
        (LinuxCnc | Fanuc | Haas, _) => format!("{letters}[{variable} + [{expression}]]"),
        (Siemens, 0) => format!("{letters}={variable}"),
        (Siemens, 1) => format!("{letters}=-{variable}"),
        (Siemens, 2) => format!("{letters}={variable}*2"),
        (Siemens, _) => format!("{letters}={variable}+({expression})"),
        (Heidenhain, 0) => format!("{letters}+{variable}"),
        (Heidenhain, 1) => format!("{letters}-{variable}"),
        (Heidenhain, form) => {
            let more = if form == 2 { " * 2".to_owned() } else { format!(" + ( {expression} )") };
            let [one, other] = [format!("{set}\n{variable} = {variable}{more}"), format!("{letters}+{variable}")];
            return (one, other);
        }
    };
    (set, word)
}

/// A block that would do harm.
pub(super) fn dead(control: Control) -> &'static str {
    match control {
        LinuxCnc | Siemens => "G0 Z-50",
        Fanuc | Haas => "G00 Z-50.",
        Heidenhain => "L Z-50 R0 FMAX",
    }
}

/// Lines in a loop that runs some times.
pub(super) fn looped(
    control: Control,
    lines: &[String],
    times: usize,
    name: usize,
    random: &mut Random,
) -> Vec<String> {
    let (counter, label) = (variable(control, name), 1000 + name);
    let step = count(control, name);
    let [zero, one] = [0.0, 1.0].map(|value| set(control, name, value));
    let (before, after): (Vec<String>, Vec<String>) = match (control, random.below(4)) {
        (LinuxCnc, 0 | 1) => (vec![format!("o{label} repeat [{times}]")], vec![format!("o{label} endrepeat")]),
        (LinuxCnc, 2) => {
            (vec![zero, format!("o{label} while [{counter} LT {times}]")], vec![step, format!("o{label} endwhile")])
        }
        (LinuxCnc, _) => {
            (vec![zero, format!("o{label} do")], vec![step, format!("o{label} while [{counter} LT {times}]")])
        }
        (Fanuc | Haas, 0 | 1) => {
            (vec![zero, format!("WHILE [{counter} LT {times}] DO1")], vec![step, "END1".to_owned()])
        }
        (Fanuc | Haas, _) => {
            (vec![zero, format!("N{label}")], vec![step, format!("IF [{counter} LT {times}] GOTO {label}")])
        }
        (Siemens, 0) => (vec![zero, format!("WHILE {counter}<{times}")], vec![step, "ENDWHILE".to_owned()]),
        (Siemens, 1) => (vec![format!("FOR {counter}=1 TO {times}")], vec!["ENDFOR".to_owned()]),
        (Siemens, 2) => (vec![zero, "REPEAT".to_owned()], vec![step, format!("UNTIL {counter}>={times}")]),
        (Siemens, _) => {
            (vec![one, format!("BACK_{label}:")], vec![step, format!("IF {counter}<={times} GOTOB BACK_{label}")])
        }
        (Heidenhain, 0 | 1) if times > 1 => {
            (vec![format!("LBL {label}")], vec![format!("CALL LBL {label} REP {}", times - 1)])
        }
        (Heidenhain, _) => (
            vec![zero, format!("LBL {label}")],
            vec![step, format!("FN 12: IF +{counter} LT +{times} GOTO LBL {label}")],
        ),
    };
    [&before, lines, &after].concat()
}

/// Lines that are executed where the condition holds, and a block that would do harm where it does not.
pub(super) fn conditional(
    control: Control,
    lines: &[String],
    holds: bool,
    name: usize,
    random: &mut Random,
) -> Vec<String> {
    let (variable, label) = (variable(control, name), 1000 + name);
    let set = set(control, name, if holds { 1.0 } else { 2.0 });
    let otherwise = random.chance(0.5) && holds;
    let dead = dead(control).to_owned();
    let (before, after): (Vec<String>, Vec<String>) = match control {
        LinuxCnc if otherwise => (
            vec![set, format!("o{label} if [[{variable} + 1] EQ 2]")],
            vec![format!("o{label} else"), dead, format!("o{label} endif")],
        ),
        LinuxCnc => (vec![set, format!("o{label} if [{variable} LT 1.5]")], vec![format!("o{label} endif")]),
        Fanuc | Haas if otherwise => {
            (vec![set, format!("IF [{variable} EQ 1] GOTO {label}"), dead, format!("N{label}")], Vec::new())
        }
        Fanuc | Haas => (vec![set, format!("IF [{variable} GT 1.5] GOTO {label}")], vec![format!("N{label}")]),
        Siemens if otherwise => {
            (vec![set, format!("IF ({variable}+1)==2")], vec!["ELSE".to_owned(), dead, "ENDIF".to_owned()])
        }
        Siemens => (vec![set, format!("IF {variable}<1.5")], vec!["ENDIF".to_owned()]),
        Heidenhain if otherwise => (
            vec![set, format!("FN 9: IF +{variable} EQU +1 GOTO LBL {label}"), dead, format!("LBL {label}")],
            Vec::new(),
        ),
        Heidenhain => {
            (vec![set, format!("FN 11: IF +{variable} GT +1.5 GOTO LBL {label}")], vec![format!("LBL {label}")])
        }
    };
    [&before, lines, &after].concat()
}

/// Lines over which the control jumps.
pub(super) fn jumped(control: Control, lines: &[String], name: usize) -> Vec<String> {
    let label = 1000 + name;
    let (before, after) = match control {
        LinuxCnc => (format!("o{label} if [0]"), format!("o{label} endif")),
        Fanuc | Haas => (format!("GOTO {label}"), format!("N{label}")),
        Siemens => (format!("GOTOF OVER_{label}"), format!("OVER_{label}:")),
        Heidenhain => (format!("FN 9: IF +0 EQU +0 GOTO LBL {label}"), format!("LBL {label}")),
    };
    [&[before], lines, &[after]].concat()
}

/// Call of a subprogram, and the subprogram; with an argument that its lines know as [`argument`].
pub(super) fn called(
    control: Control,
    lines: &[String],
    times: usize,
    name: usize,
    argument: Option<f64>,
) -> (Vec<String>, Vec<String>) {
    let label = 1000 + name;
    let with = argument.map(|value| number(control, value));
    let one = |text: String| vec![text];
    // The check reads no motion of axis words alone after the end code.
    let with_code = |line: &String| match line.starts_with(|first: char| "XYZABC".contains(first)) {
        true if matches!(control, Fanuc | Haas) && name.is_multiple_of(2) => format!("G90 {line}"),
        _ => line.clone(),
    };
    let lines: Vec<String> = lines.iter().map(with_code).collect();
    let (call, before, after): (Vec<String>, Vec<String>, &str) = match control {
        LinuxCnc => {
            let call = format!("o{label} call {}", with.map_or(String::new(), |value| format!("[{value}]")));
            (vec![call.trim_end().to_owned(); times], one(format!("o{label} sub")), "endsub")
        }
        Fanuc | Haas => {
            let runs = if times > 1 { format!(" L{times}") } else { String::new() };
            let call = match with {
                Some(value) => format!("G65 P{label}{runs} A{value}"),
                None => format!("M98 P{label}{runs}"),
            };
            (one(call), one(format!("O{label}")), "M99")
        }
        Siemens => {
            // A name, or a number after L; the mark of the file may come before.
            let title = if name.is_multiple_of(2) {
                format!("SIDE{}", ["A", "B", "C", "D"][name / 2 % 4])
            } else {
                format!("L{label}")
            };
            let call = with.map_or(title.clone(), |value| format!("{title}({value})"));
            let parameter = if argument.is_some() { "(REAL VALUE)" } else { "" };
            let mark = format!("%_N_{title}_SPF");
            let before = match (name % 4 > 1, argument) {
                (true, None) => one(mark),
                (true, Some(_)) => vec![mark, format!("PROC {title}{parameter}")],
                (false, _) => one(format!("PROC {title}{parameter}")),
            };
            (vec![call; times], before, "RET")
        }
        Heidenhain => {
            let set = with.map(|value| format!("Q1 = {value}"));
            let call = vec![format!("CALL LBL {label}"); times];
            (set.into_iter().chain(call).collect(), one(format!("LBL {label}")), "LBL 0")
        }
    };
    let end = if control == LinuxCnc { format!("o{label} {after}") } else { after.to_owned() };
    (call, [before, lines, vec![end]].concat())
}

/// The word that has the value of the argument.
pub(super) fn argument(control: Control, letters: &str) -> String {
    match control {
        LinuxCnc | Fanuc | Haas => format!("{letters}#1"),
        Siemens => format!("{letters}=VALUE"),
        Heidenhain => format!("{letters}+Q1"),
    }
}

/// Lines that move an axis by a distance.
pub(super) fn by_distance(control: Control, axis: char, distance: f64, rest: (&str, &str)) -> Vec<String> {
    let number = number(control, distance);
    match control {
        Heidenhain => vec![format!("{}I{axis}{number}{}", rest.0, rest.1)],
        Siemens => vec![format!("{}{axis}=IC({number}){}", rest.0, rest.1)],
        _ => vec!["G91".to_owned(), format!("{}{axis}{number}{}", rest.0, rest.1), "G90".to_owned()],
    }
}
