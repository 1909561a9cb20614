//! Length guards are whole, or refused.

use super::super::{Axes, Control, Effect, Options, State, run};
use super::{program, trace};

const GUARD: Effect = Effect::Guard { length: 9.5, tolerance: 0.01 };

/// Lines of the guard of a control that compares with 9.5 mm.
fn guard(control: Control) -> Vec<&'static str> {
    match control {
        Control::LinuxCnc => {
            vec![
                "o1 if [[ABS[#5403 - 9.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 9.5] GT 0.01]]",
                "(abort, no)",
                "o1 endif",
            ]
        }
        Control::Fanuc => vec!["IF [ABS[#10001+#11001-9.5] GT 0.01] THEN #3000=101 (NO)"],
        Control::Haas => vec!["IF [ABS[#2001 + #2201 - 9.5] GT 0.01] THEN #3000= 101 (NO)"],
        Control::Siemens => vec!["IF ABS($P_TOOLL[1]-9.5)>0.01", "MSG(\"no\")", "M0", "M30", "ENDIF"],
        Control::Heidenhain => vec![
            "FN 18: SYSREAD QL1 = ID50 NR1 IDX1",
            "FN 18: SYSREAD QL2 = ID50 NR4 IDX1",
            "FN 1: QL1 = +QL1 + +QL2",
            "FN 12: IF +QL1 LT +9.49 GOTO LBL \"OFF1\"",
            "FN 12: IF +QL1 LT +9.51 GOTO LBL \"FITS1\"",
            "LBL \"OFF1\"",
            "; no",
            "FN 14: ERROR = 100",
            "LBL \"FITS1\"",
        ],
    }
}

fn is_refused(control: Control, lines: &[&str]) -> bool {
    run(&program(control, &lines.join("\n")), &Options::of(control)).is_err()
}

/// Lines of a guard of B at 30 and C at -20.5 degrees.
fn plane_guard(control: Control) -> Vec<&'static str> {
    match control {
        Control::Siemens => vec![
            "IF ABS(SIN(($AA_IW[B]-30)/2))+ABS(SIN(($AA_IW[C]+20.5)/2))>0.0009",
            "MSG(\"no\")",
            "M0",
            "M30",
            "ENDIF",
        ],
        Control::Heidenhain => vec![
            "FN 20: WAIT FOR SYNC",
            "FN 18: SYSREAD QL1 = ID270 NR1 IDX5",
            "FN 18: SYSREAD QL2 = ID270 NR1 IDX6",
            "QL3 = ABS ( SIN ( ( QL1 - 30 ) / 2 ) ) + ABS ( SIN ( ( QL2 + 20.5 ) / 2 ) )",
            "FN 12: IF +QL3 LT +0.0009 GOTO LBL \"PLANE1\"",
            "; no",
            "FN 14: ERROR = 101",
            "LBL \"PLANE1\"",
        ],
        _ => Vec::new(),
    }
}

#[test]
fn a_guard_of_rotary_positions_is_whole_or_refused() {
    for control in [Control::Siemens, Control::Heidenhain] {
        let whole = plane_guard(control);
        let mut axes = Axes::default();
        axes.set('B', 30.0);
        axes.set('C', -20.5);
        let wanted = Effect::PlaneGuard { axes, largest: 0.0009 };
        let found = trace(control, &whole.join("\n"));
        assert!(found.blocks.iter().any(|block| block.effect == wanted), "{control:?}: {:?}", found.blocks);
        for left_out in 0..whole.len() {
            let mut lines = whole.clone();
            // One axis alone is a guard as well.
            if !lines.remove(left_out).contains("IDX6") {
                assert!(is_refused(control, &lines), "{control:?} without {:?}", whole[left_out]);
            }
        }
        for (from, to) in
            [("SIN", "COS"), ("/ 2", "/ 3"), ("/2", "/3"), ("QL2 +", "QL1 +"), ("ID270", "ID240"), ("[B]", "[X]")]
        {
            let text = whole.join("\n");
            let other = text.replacen(from, to, 1);
            assert!(other == text || is_refused(control, &other.lines().collect::<Vec<_>>()), "{control:?}: {other}");
        }
    }
}

#[test]
fn a_whole_guard_is_one_effect() {
    for control in Control::ALL {
        let found = trace(control, &guard(control).join("\n"));
        let guards = found.blocks.iter().filter(|block| block.effect == GUARD).count();
        assert_eq!(guards, 1, "{control:?}: {:?}", found.blocks);
    }
}

#[test]
fn a_guard_that_lacks_a_line_is_refused() {
    for control in Control::ALL {
        let whole = guard(control);
        for left_out in (0..whole.len()).filter(|_| whole.len() > 1) {
            let mut lines = whole.clone();
            lines.remove(left_out);
            // A message, or the end of the program, is a block of its own.
            assert!(is_refused(control, &lines), "{control:?} without {:?}", whole[left_out]);
        }
    }
}

#[test]
fn a_guard_that_compares_something_else_is_refused() {
    for (control, from, to) in [
        (Control::LinuxCnc, "25.4] - 9.5", "25.4] - 9.4"),
        (Control::LinuxCnc, "#5403 - ", "#5402 - "),
        (Control::Fanuc, "#11001", "#11002"),
        (Control::Fanuc, "#3000", "#3001"),
        (Control::Haas, "#2201", "#2202"),
        (Control::Siemens, "$P_TOOLL[1]", "$P_TOOLL[2]"),
        (Control::Siemens, "M30", "M8"),
        (Control::Heidenhain, "NR4 IDX1", "NR4 IDX2"),
        (Control::Heidenhain, "FITS1", "FITS2"),
        (Control::Heidenhain, "LT +9.51", "LT +9.48"),
    ] {
        let text = guard(control).join("\n");
        let other = text.replacen(from, to, 1);
        assert_ne!(other, text);
        assert!(is_refused(control, &other.lines().collect::<Vec<_>>()), "{control:?}: {other}");
    }
    assert!(is_refused(Control::LinuxCnc, &["(abort, no)"]), "a stop outside a guard");
}

#[test]
fn a_guard_of_linuxcnc_needs_the_length_that_it_reads() {
    let text = guard(Control::LinuxCnc).join("\n");
    let before = program(Control::LinuxCnc, "").replace("G43 H1", &format!("{text}\nG43 H1"));
    assert!(run(&before, &Options::of(Control::LinuxCnc)).is_err());
}

/// Lines of the guard of what lies over the work offset.
fn offset_guard(control: Control) -> Vec<&'static str> {
    match control {
        Control::LinuxCnc => {
            vec!["o1 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]", "(abort, no)", "o1 endif"]
        }
        Control::Siemens => vec![
            "IF (ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])+ABS($P_ACTFRAME[X,SC]-1)+\
             ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>0.0001) OR $P_ACTFRAME[X,MI] OR $P_ACTFRAME[Y,MI] OR \
             $P_ACTFRAME[Z,MI]",
            "MSG(\"no\")",
            "M0",
            "M30",
            "ENDIF",
        ],
        Control::Heidenhain => vec![
            "FN 18: SYSREAD QL1 = ID210 NR1",
            "FN 9: IF +QL1 EQU +0 GOTO LBL \"OFFSET1\"",
            "; no",
            "FN 14: ERROR = 102",
            "LBL \"OFFSET1\"",
        ],
        Control::Fanuc | Control::Haas => Vec::new(),
    }
}

#[test]
fn a_guard_of_the_work_offset_stops_where_a_rotation_lies_over_it_and_is_whole() {
    for control in Control::ALL {
        let whole = offset_guard(control);
        if whole.is_empty() {
            continue;
        }
        let text = program(control, &whole.join("\n"));
        assert!(run(&text, &Options::of(control)).is_ok(), "{text}");
        let rotated = State { rotated_offset: true, ..State::default() };
        assert!(run(&text, &Options { before: rotated, ..Options::of(control) }).is_err(), "{text}");
        for left_out in 0..whole.len() {
            let mut lines = whole.clone();
            lines.remove(left_out);
            assert!(is_refused(control, &lines), "{control:?} without {:?}", whole[left_out]);
        }
    }
    for (control, from, to) in [
        (Control::LinuxCnc, "#5220", "#5221"),
        (Control::LinuxCnc, "OR", "AND"),
        (Control::Siemens, "[Y,RT]", "[X,RT]"),
        (Control::Siemens, " OR $P_ACTFRAME[Y,MI]", ""),
        (Control::Siemens, ">0.0001", ">1"),
        (Control::Heidenhain, "NR1", "NR2"),
        (Control::Heidenhain, "EQU +0", "EQU +1"),
    ] {
        let text = offset_guard(control).join("\n");
        let other = text.replacen(from, to, 1);
        assert_ne!(other, text);
        assert!(is_refused(control, &other.lines().collect::<Vec<_>>()), "{control:?}: {other}");
    }
}
