//! Variables, conditions, loops, jumps and subprograms of the five controls.

use super::super::Control::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use super::super::{Options, Refused, run};
use super::program;

fn options(control: Control) -> Options {
    Options { untidy: true, ..Options::of(control) }
}

/// X of each motion.
fn read(control: Control, text: &str) -> Result<Vec<f64>, Refused> {
    let trace = run(text, &options(control))?;
    Ok(trace.motions().filter_map(|block| block.state.position.get('X')).collect())
}

/// Motions of some blocks, with a subprogram after the end code.
fn with_subprogram(control: Control, blocks: &str, subprogram: &str) -> Vec<f64> {
    let text = program(control, blocks);
    let place = match control {
        Fanuc | Haas => text.rfind('%').expect("the end mark"),
        _ => text.len(),
    };
    let text = format!("{}{subprogram}\n{}", &text[..place], &text[place..]);
    read(control, &text).unwrap_or_else(|refused| panic!("{control:?} {text}: {refused}"))
}

fn reads(control: Control, blocks: &str, expected: &[f64]) {
    match read(control, &program(control, blocks)) {
        Ok(found) => {
            let same = found.len() == expected.len()
                && found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-6);
            assert!(same, "{control:?} {blocks:?}: {found:?}");
        }
        Err(refused) => panic!("{control:?} {blocks:?}: {refused}"),
    }
}

fn is_refused(control: Control, blocks: &str) {
    let found = read(control, &program(control, blocks));
    assert!(found.is_err(), "{control:?} {blocks:?} is {found:?}");
}

#[test]
fn words_hold_expressions() {
    reads(LinuxCnc, "#1=2\n#<far>=[#1*3]\nG0 X[#<far>+.5]\nX-#1\nX[SQRT[16]]\nX[2**3]", &[6.5, -2.0, 4.0, 8.0]);
    reads(Fanuc, "#100=2.\n#101=#100*3.\nG0 X[#101+.5]\nX-#100\nX-[#100+1.]", &[6.5, -2.0, -3.0]);
    reads(Haas, "#100=2.\nG00 X#100\nX[ROUND[2.4] + FUP[.1] + FIX[1.9] + 7 MOD 4]", &[2.0, 7.0]);
    reads(Siemens, "DEF REAL FAR=6, NEAR\nR1=2 R2=R1*3\nG0 X=R2+0.5\nX=-R1\nX=IC(R1)\nX=FAR", &[6.5, -2.0, 0.0, 6.0]);
    reads(
        Heidenhain,
        "Q1 = +2\nFN 3: Q2 = +Q1 * +3\nL X+Q2 R0 FMAX\nL X-Q1 R0 FMAX\nQL3 = (Q1 + 1) * 2\nL X+QL3 R0 FMAX",
        &[6.0, -2.0, 6.0],
    );
}

#[test]
fn operators_bind_as_on_the_control() {
    reads(
        LinuxCnc,
        "G0 X[2+3*4]\nX[-7 MOD 4]\nX[FIX[-2.2]]\nX[1 EQ 1 AND 2 GT 1]\nX[ATAN[1]/[1]]",
        &[14.0, 1.0, -3.0, 1.0, 45.0],
    );
    reads(Fanuc, "G0 X[2+3*4]\nX[12 AND 10]\nX[1 OR 2]\nX[SIN[30]*2]", &[14.0, 8.0, 3.0, 1.0]);
    reads(Siemens, "G0 X=2+3*4\nX=7 DIV 2\nX=7 MOD 4\nX=SQRT(POT(3)+16)\nX=(1+2)*3", &[14.0, 3.0, 3.0, 5.0, 9.0]);
    reads(Heidenhain, "Q1 = 2 + 3 * 4\nL X+Q1 R0 FMAX\nQ1 = SQRT 16 + 2 ^ 3\nL X+Q1 R0 FMAX", &[14.0, 12.0]);
}

#[test]
fn conditions_choose() {
    reads(LinuxCnc, "#1=5\no1 if [#1 LT 3]\nG0 X1\no1 elseif [#1 LT 9]\nG0 X2\no1 else\nG0 X3\no1 endif", &[2.0]);
    reads(
        Fanuc,
        "#1=5.\nIF [#1 EQ 5] THEN #2=7.\nIF [#1 NE 5] THEN #2=8.\nG0 X#2\nIF [#1 GT 3] GOTO 10\nX1.\nN10 X2.",
        &[7.0, 2.0],
    );
    reads(Haas, "#101=5.\nIF [#101 EQ 5] GOTO 10\nG00 X1.\nN10\nG00 X2.", &[2.0]);
    reads(
        Siemens,
        "R1=5\nIF R1<3\nG0 X1\nELSE\nIF (R1==5) AND (R1>2)\nG0 X2\nENDIF\nENDIF\nIF R1>2 GOTOF OVER\nX3\nOVER:\nX4",
        &[2.0, 4.0],
    );
    reads(
        Heidenhain,
        "Q1 = +5\nFN 9: IF +Q1 EQU +5 GOTO LBL 7\nL X+1 R0 FMAX\nLBL 7\nFN 12: IF +Q1 LT +3 GOTO LBL 8\nL X+2 R0 FMAX\nLBL 8",
        &[2.0],
    );
}

#[test]
fn loops_run() {
    let three = [1.0, 2.0, 3.0];
    reads(LinuxCnc, "#1=1\no1 while [#1 LE 3]\nG0 X#1\n#1=[#1+1]\no1 endwhile", &three);
    reads(LinuxCnc, "#1=1\no1 do\nG0 X#1\n#1=[#1+1]\no1 while [#1 LE 3]", &three);
    reads(
        LinuxCnc,
        "#1=0\no1 repeat [9]\n#1=[#1+1]\no2 if [#1 GT 3]\no1 break\no2 endif\nG0 X#1\no1 endrepeat",
        &three,
    );
    for control in [Fanuc, Haas] {
        reads(control, "#1=1\nWHILE [#1 LE 3] DO1\nG0 X#1\n#1=#1+1\nEND1", &three);
        reads(control, "#1=1\nN5\nG0 X#1\n#1=#1+1\nIF [#1 LE 3] GOTO 5", &three);
    }
    reads(Siemens, "R1=1\nWHILE R1<=3\nG0 X=R1\nR1=R1+1\nENDWHILE", &three);
    reads(Siemens, "FOR R1=1 TO 3\nG0 X=R1\nENDFOR", &three);
    reads(Siemens, "R1=1\nREPEAT\nG0 X=R1\nR1=R1+1\nUNTIL R1>3", &three);
    reads(Siemens, "R1=1\nLOOP\nG0 X=R1\nR1=R1+1\nIF R1>3 GOTOF OUT\nENDLOOP\nOUT:", &three);
    reads(Heidenhain, "Q1 = +0\nLBL 1\nQ1 = Q1 + 1\nL X+Q1 R0 FMAX\nCALL LBL 1 REP 2", &three);
}

#[test]
fn subprograms_are_called() {
    reads(LinuxCnc, "o5 sub\nG0 X#1\n#<here>=#2\nX#<here>\no5 endsub\no5 call [3] [4]", &[3.0, 4.0]);
    assert_eq!(with_subprogram(Fanuc, "G0 X1.\nM98 P1000 L2\nX3.", "O1000\nX2.\nM99"), [1.0, 2.0, 2.0, 3.0]);
    assert_eq!(with_subprogram(Fanuc, "G0 X1.\nM98 P21000", "O1000\nX2.\nM99"), [1.0, 2.0, 2.0]);
    assert_eq!(with_subprogram(Haas, "G00 X1.\nG65 P1000 A5. X7.", "O1000\nX#1\nX#24\nM99"), [1.0, 5.0, 7.0]);
    assert_eq!(with_subprogram(Haas, "G00 X1.\nM97 P100 L2", "N100\nX2.\nM99"), [1.0, 2.0, 2.0]);
    let proc = "%_N_SIDE_SPF\n;$PATH=/_N_SPF_DIR\nPROC SIDE(REAL FAR)\nG0 X=FAR\nRET";
    assert_eq!(with_subprogram(Siemens, "G0 X1\nSIDE(4)\nX2", proc), [1.0, 4.0, 2.0]);
    reads(Heidenhain, "L X+1 R0 FMAX\nCALL LBL 9\nL X+2 R0 FMAX\nM30\nLBL 9\nL X+5 R0 FMAX\nLBL 0", &[1.0, 5.0, 2.0]);
}

#[test]
fn what_is_unknown_is_refused() {
    for (control, block) in [
        (LinuxCnc, "G0 X#1"),
        (LinuxCnc, "G0 X#5420"),
        (LinuxCnc, "o1 if [#5421 GT 3]\nG0 X1\no1 endif"),
        (LinuxCnc, "o7 call"),
        (Fanuc, "G0 X#100"),
        (Fanuc, "IF [#5021 GT 3.] GOTO 5\nN5"),
        (Fanuc, "M98 P7000"),
        (Haas, "G65 P9000 A1."),
        (Siemens, "G0 X=R1"),
        (Siemens, "IF $AA_IW[X]>3\nG0 X1\nENDIF"),
        (Siemens, "OTHER(3)"),
        (Heidenhain, "L X+Q1 R0 FMAX"),
        (Heidenhain, "CALL LBL 5"),
    ] {
        is_refused(control, block);
    }
}

#[test]
fn a_loop_without_an_end_is_refused() {
    is_refused(LinuxCnc, "o1 while [1 EQ 1]\nG0 X1\no1 endwhile");
    is_refused(Fanuc, "N1 G0 X1.\nGOTO 1");
    is_refused(Siemens, "LOOP\nG0 X1\nENDLOOP");
    is_refused(Heidenhain, "LBL 1\nFN 9: IF +1 EQU +1 GOTO LBL 1");
}

#[test]
fn a_measured_value_is_unknown_until_it_is_set() {
    reads(LinuxCnc, "#1=#5421\n#1=3\nG0 X#1", &[3.0]);
    is_refused(LinuxCnc, "#1=3\n#1=#5421\nG0 X#1");
    reads(Siemens, "R1=$AA_IW[X]\nR1=3\nG0 X=R1", &[3.0]);
}
