//! Lines that only another control reads: a configuration that serves several controls has the blocks of one shop
//! floor.

use super::dialects::Spellings;

/// Statements of Heidenhain with these words. A block of several lines is one too.
const HEIDENHAIN: [&str; 11] = [
    "CALL LBL",
    "CALL PGM",
    "CYCL CALL",
    "CYCL DEF",
    "FN ",
    "FUNCTION ",
    "PLANE ",
    "SEL ",
    "TCH PROBE",
    "TOOL CALL",
    "TOOL DEF",
];

/// Names and title of the controls that read a line, where it has a form that no other control of these has.
fn readers(line: &str) -> Option<(&'static [&'static str], &'static str)> {
    let line = line.trim_start().trim_start_matches('/').trim_start();
    let name = line.split(|byte: char| !byte.is_ascii_alphanumeric() && byte != '_').next().unwrap_or_default();
    let calls =
        name.len() > 1 && line[name.len()..].starts_with('(') && name.starts_with(|of: char| of.is_alphabetic());
    let words = |code: &str| line.split_whitespace().next() == Some(code);
    if line.strip_prefix(['o', 'O']).is_some_and(|rest| rest.starts_with('<')) {
        Some((&["linuxcnc"], "LinuxCNC"))
    } else if HEIDENHAIN.iter().any(|statement| line.starts_with(statement)) || line.contains('\n') {
        Some((&["heidenhain"], "Heidenhain"))
    } else if ["G65", "G66"].into_iter().any(words) {
        Some((&["fanuc", "haas"], "Fanuc and Haas"))
    } else if calls && !["IF", "THEN"].contains(&name) {
        Some((&["siemens"], "Siemens"))
    } else {
        None
    }
}

/// Why a control cannot read a block of the configuration: it is one of another control.
pub(crate) fn of_another_control(codes: &Spellings, block: &str) -> Option<String> {
    let readers = readers_elsewhere(codes.name, block)?;
    let (title, block) = (codes.title, block.replace('\n', " "));
    Some(format!("`{block}` is a line of {readers}, and {title} cannot read it: give the block of this control"))
}

/// Title of the controls that read a line, if this control is none of them. Controls in Rust have lines of their own.
fn readers_elsewhere(control: &str, line: &str) -> Option<&'static str> {
    const NAMES: [&str; 5] = ["linuxcnc", "fanuc", "haas", "siemens", "heidenhain"];
    let (names, title) = readers(line).filter(|_| NAMES.contains(&control))?;
    (!names.contains(&control)).then_some(title)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_another_control_has_its_readers() {
        for (line, title, names) in [
            ("o<toolmeasure> call [1]", "LinuxCNC", &["linuxcnc"][..]),
            ("CALL PGM TNC:\\WARMUP.H", "Heidenhain", &["heidenhain"]),
            ("TCH PROBE 33.0 MEASURE TOOL", "Heidenhain", &["heidenhain"]),
            ("O9001 ~\n  Q340=+1", "Heidenhain", &["heidenhain"]),
            ("/ G65 P9023 A12. T{tool}", "Fanuc and Haas", &["fanuc", "haas"]),
            ("MEASURE_TOOL({tool})", "Siemens", &["siemens"]),
        ] {
            for control in ["linuxcnc", "fanuc", "haas", "siemens", "heidenhain"] {
                let expected = (!names.contains(&control)).then_some(title);
                assert_eq!(readers_elsewhere(control, line), expected, "{line} {control}");
            }
            assert_eq!(readers_elsewhere("house", line), None);
        }
    }

    #[test]
    fn lines_that_several_controls_read_are_none_of_another() {
        for line in
            ["M31", "G53 G0 Z0", "G0 A0. C0.", "(TEXT)", "M8 (COOLANT)", "M98 P9000", "L1", "O1234 (NAME)", "T1 M6"]
        {
            assert_eq!(readers(line), None, "{line}");
        }
    }
}
