//! Programs with variables, conditions, loops and subprograms do what their blocks written out do.

use super::*;

/// Actions, positions and F of the blocks that act.
fn acts(family: Family, text: &str) -> Vec<(Action, [f64; 3], Option<f64>)> {
    let blocks = read(family, text);
    for block in &blocks {
        assert_eq!(block.faults, [], "line {} of {text}", block.line);
    }
    let acting = blocks.iter().filter(|block| block.action != Action::Nothing);
    acting.map(|block| (block.action, xyz(block), block.state.feed)).collect()
}

fn same(family: Family, text: &str, written_out: &str) {
    let (found, expected) = (acts(family, text), acts(family, written_out));
    assert_eq!(found.len(), expected.len(), "{text}\n{found:?}\n{expected:?}");
    for (found, expected) in found.iter().zip(&expected) {
        assert!(
            found.0 == expected.0 && near(found.1, expected.1) && found.2 == expected.2,
            "{text}\n{found:?} {expected:?}"
        );
    }
}

const FANUC: &str = "G21 G17 G40 G49 G80 G90 G94 G54\n";

#[test]
fn values_of_fanuc_and_haas_are_executed() {
    for family in [Family::Fanuc, Family::Haas] {
        let same = |text: &str, written_out: &str| {
            let called = if text.contains("P1000") { "O1000\n#5=9.\nG1 X7. Y#5\nX8.\nM99\n" } else { "" };
            same(family, &format!("{FANUC}{text}M30\n{called}"), &format!("{FANUC}{written_out}M30\n"));
        };
        same("#1=5\n#2=[#1*2.+1.]\nG0 X#1 Y-#2 Z[#1-#2]\n", "G0 X5. Y-11. Z-6.\n");
        same(
            "#1=0\nWHILE [#1 LT 3] DO1\nG0 X#1 Y0. Z0.\n#1=#1+1\nEND1\nG0 X9.\n",
            "G0 X0. Y0. Z0.\nG0 X1. Y0. Z0.\nG0 X2. Y0. Z0.\nG0 X9.\n",
        );
        same("#1=1\nIF [#1 EQ 1] GOTO 20\nG0 X5. Y5. Z5.\nN20 G0 X1. Y2. Z3.\n", "G0 X1. Y2. Z3.\n");
        same(
            "#1=1\nN10 G0 X#1 Y0. Z0.\n#1=#1*2\nIF [#1 LT 8] GOTO 10\n",
            "G0 X1. Y0. Z0.\nG0 X2. Y0. Z0.\nG0 X4. Y0. Z0.\n",
        );
        same("#1=3\nIF [#1 GT 2] THEN #1=8\nG0 X#1 Y0. Z0.\n", "G0 X8. Y0. Z0.\n");
        same(
            "G0 X0. Y0. Z0.\nF50.\nM98 P1000 L2\nG0 X1.\n",
            "G0 X0. Y0. Z0.\nF50.\nG1 X7. Y9.\nX8.\nX7. Y9.\nX8.\nG0 X1.\n",
        );
        same("#5=2\nG0 X0. Y0. Z0.\nF50.\nG65 P1000 A3.\nG0 X#5\n", "G0 X0. Y0. Z0.\nF50.\nG1 X7. Y9.\nX8.\nG0 X2.\n");
    }
    let haas = format!("{FANUC}G0 X0. Y0. Z0.\nM97 P100\nM30\nN100 G0 X5.\nM99\n");
    assert_eq!(acts(Family::Haas, &haas).len(), 3);
}

#[test]
fn values_of_linuxcnc_are_executed() {
    let same = |text: &str, written_out: &str| {
        same(Family::LinuxCnc, &format!("{LINUXCNC}{text}M2\n"), &format!("{LINUXCNC}{written_out}M2\n"));
    };
    let circle = "#<radius>=10\n#<angle>=0\no1 while [#<angle> LE 90]\nG0 X[#<radius>*COS[#<angle>]] Y[#<radius>*SIN[#<angle>]] Z0\n\
                  #<angle>=[#<angle>+45]\no1 endwhile\n";
    same(circle, "G0 X10 Y0 Z0\nG0 X7.071067812 Y7.071067812 Z0\nG0 X0 Y10 Z0\n");
    same("o1 sub\nG0 X#1 Y#2 Z0\no1 endsub\no1 call [3] [4]\no1 call [5] [6]\n", "G0 X3 Y4 Z0\nG0 X5 Y6 Z0\n");
    same("#1=2\no5 if [#1 EQ 1]\nG0 X1 Y0 Z0\no5 else\nG0 X2 Y0 Z0\no5 endif\n", "G0 X2 Y0 Z0\n");
    same("#1=1\no5 if [#1 EQ 1]\nG0 X1 Y0 Z0\no5 else\nG0 X2 Y0 Z0\no5 endif\n", "G0 X1 Y0 Z0\n");
    same("#1=0\no9 do\nG0 X#1 Y0 Z0\n#1=[#1+1]\no9 while [#1 LT 2]\n", "G0 X0 Y0 Z0\nG0 X1 Y0 Z0\n");
    same("G0 X0 Y0 Z0\nG91\no7 repeat [3]\nG0 X2\no7 endrepeat\nG90\n", "G0 X0 Y0 Z0\nG91\nG0 X2\nG0 X2\nG0 X2\nG90\n");
}

#[test]
fn a_subprogram_is_called_from_far_behind_its_definition() {
    let far = format!("({})\n", "A".repeat(50_000)).repeat(4);
    let text = |calls: &str| format!("{LINUXCNC}o1 sub\nG0 X#1 Y0 Z0\no1 endsub\n#5=1\n{far}{calls}M2\n");
    let twice = text(&format!("o1 call [3]\n{far}#5=2\n{far}o1 call [4]\n"));
    same(Family::LinuxCnc, &twice, &format!("{LINUXCNC}G0 X3 Y0 Z0\nG0 X4 Y0 Z0\nM2\n"));
}

#[test]
fn values_of_siemens_are_executed() {
    let same = |text: &str, written_out: &str| {
        same(Family::Siemens, &format!("{SIEMENS}{text}M30\n"), &format!("{SIEMENS}{written_out}M30\n"));
    };
    same("R1=5\nR2=R1*2+1\nG0 X=R1 Y=-R2 Z=(R1-R2)\n", "G0 X5 Y-11 Z-6\n");
    same("DEF REAL DEPTH=3\nG0 X0 Y0 Z=DEPTH-5\n", "G0 X0 Y0 Z-2\n");
    same("FOR R1=0 TO 2\nG0 X=R1 Y0 Z0\nENDFOR\n", "G0 X0 Y0 Z0\nG0 X1 Y0 Z0\nG0 X2 Y0 Z0\n");
    same("R1=1\nIF R1==1\nG0 X1 Y0 Z0\nELSE\nG0 X2 Y0 Z0\nENDIF\n", "G0 X1 Y0 Z0\n");
    same("R1=2\nIF R1==1 GOTOF A1\nG0 X1 Y0 Z0\nA1:\nG0 X=R1 Y0 Z0\n", "G0 X1 Y0 Z0\nG0 X2 Y0 Z0\n");
    same("R1=0\nREPEAT\nG0 X=R1 Y0 Z0\nR1=R1+1\nUNTIL R1==2\n", "G0 X0 Y0 Z0\nG0 X1 Y0 Z0\n");
    same("R1=0\nWHILE R1<2\nR1=R1+1\nG0 X=R1 Y0 Z0\nENDWHILE\n", "G0 X1 Y0 Z0\nG0 X2 Y0 Z0\n");
}

#[test]
fn values_of_heidenhain_are_executed() {
    let numbered = |text: &str| -> String {
        let lines = text.lines().enumerate().map(|(index, line)| format!("{} {line}\n", index + 2));
        lines.collect::<String>()
    };
    let same = |text: &str, written_out: &str| {
        same(Family::Heidenhain, &format!("{TNC}{}", numbered(text)), &format!("{TNC}{}", numbered(written_out)));
    };
    let at = "L X+0 Y+0 Z+9 R0 FMAX\n";
    same(&format!("{at}Q1 = +5\nQ2 = Q1 * 2\nL X+Q1 Y-Q2 R0 FMAX\nM30\n"), &format!("{at}L X+5 Y-10 R0 FMAX\nM30\n"));
    same(&format!("{at}FN 0: Q1 = +4\nFN 1: Q1 = +Q1 + +3\nL X+Q1 FMAX\nM30\n"), &format!("{at}L X+7 FMAX\nM30\n"));
    same(
        &format!("{at}Q1 = 0\nLBL 1\nL IX+2 FMAX\nQ1 = Q1 + 1\nFN 12: IF +Q1 LT +3 GOTO LBL 1\nM30\n"),
        &format!("{at}L IX+2 FMAX\nL IX+2 FMAX\nL IX+2 FMAX\nM30\n"),
    );
    same(
        &format!("{at}CALL LBL 5\nL Y+3 FMAX\nM30\nLBL 5\nL X+1 FMAX\nLBL 0\n"),
        &format!("{at}L X+1 FMAX\nL Y+3 FMAX\nM30\n"),
    );
    same(
        &format!("{at}LBL 7\nL IX+1 FMAX\nCALL LBL 7 REP 2\nM30\n"),
        &format!("{at}L IX+1 FMAX\nL IX+1 FMAX\nL IX+1 FMAX\nM30\n"),
    );
}

#[test]
fn what_does_not_follow_from_the_program_is_refused() {
    for text in [
        "G0 X#1",
        "#1=#5061\nG0 X#1",
        "GOTO 99",
        "WHILE [1 EQ 1] DO1\nEND1",
        "M98 P77",
        "END1",
        "M99",
        "#1=1/0\nG0 X#1",
        "G0 X[1 OR 6]",
        "G0 X[12 AND 10]",
        "G0 X[1 OR 0+1]",
        "G0 X[5 XOR 1]",
        "G0 X[FIX[-2.2]]",
        "G0 X[FUP[-2.2]]",
        "#1=-5\nG0 X[#1 MOD 3]",
    ] {
        assert!(!faults(Family::Fanuc, &format!("{FANUC}{text}\nM30\n")).is_empty(), "{text}");
    }
    assert!(!faults(Family::LinuxCnc, "#<_x>=5\n").is_empty() && faults(Family::LinuxCnc, "#<_depth>=5\n").is_empty());
    for text in ["G0 X=R1", "GOTOF NOWHERE", "WHILE TRUE", "R1=$AA_IW[X]\nG0 X=R1", "ELSE"] {
        assert!(!faults(Family::Siemens, &format!("{SIEMENS}{text}\nM30\n")).is_empty(), "{text}");
    }
}
