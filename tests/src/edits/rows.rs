//! Codes, words and lines that an edit may bring into a program: those that are posted, and many that are not.
//!
//! A row is inserted as a line of its own, or word by word into a block; `\n` separates lines. The rows are those of
//! the programming manuals of the controls, not of the writer.

use crate::foreign::Control;

/// Rows for a control.
#[must_use]
pub fn rows(control: Control) -> Vec<&'static str> {
    match control {
        Control::LinuxCnc => [ISO, LINUXCNC].concat(),
        Control::Fanuc => [ISO, FANUC_AND_HAAS, FANUC].concat(),
        Control::Haas => [ISO, FANUC_AND_HAAS, HAAS].concat(),
        Control::Siemens => SIEMENS.to_vec(),
        Control::Heidenhain => HEIDENHAIN.to_vec(),
    }
}

/// Codes of one group: a code of a block may become another one of its group.
#[must_use]
pub fn groups(control: Control) -> &'static [&'static [&'static str]] {
    match control {
        Control::LinuxCnc | Control::Fanuc | Control::Haas => ISO_GROUPS,
        Control::Siemens => SIEMENS_GROUPS,
        Control::Heidenhain => HEIDENHAIN_GROUPS,
    }
}

#[rustfmt::skip]
const ISO_GROUPS: &[&[&str]] = &[
    &["G0", "G1", "G2", "G3", "G33.1", "G28", "G30"],
    &["G17", "G18", "G19"],
    &["G20", "G21"],
    &["G40", "G41", "G42", "G41 D5"],
    &["G43", "G44", "G49", "G43.4", "G43.5", "G234", "G43.1"],
    &["G53", "G54", "G55", "G56", "G57", "G58", "G59", "G154 P2", "G54.1 P2", "G52", "G92"],
    &["G61", "G64", "G61.1", "G187", "G05.1"],
    &["G68.2", "G53.1", "G69", "G268", "G253", "G269", "G254", "G255", "G68"],
    &["G73", "G74", "G76", "G80", "G81", "G82", "G83", "G84", "G85", "G86", "G89"],
    &["G90", "G91", "G91.1", "G90.1"],
    &["G93", "G94", "G95"],
    &["G98", "G99"],
    &["M0", "M1", "M2", "M30", "M99"],
    &["M3", "M4", "M5", "M13", "M19"],
    &["M7", "M8", "M9", "M88", "M89", "M50"],
    &["M428", "M429"],
    &["M10", "M11", "M68", "M69"],
    &["G4", "G9"],
];

#[rustfmt::skip]
const SIEMENS_GROUPS: &[&[&str]] = &[
    &["G0", "G1", "G2", "G3", "G33", "G74", "G75", "CIP"],
    &["G17", "G18", "G19"],
    &["G70", "G71", "G700", "G710"],
    &["G40", "G41", "G42"],
    &["SUPA", "G53", "G153", "G500"],
    &["G54", "G55", "G56", "G57", "G500", "G505", "G599"],
    &["G60", "G64", "G641", "G642", "G9"],
    &["G90", "G91"],
    &["G93", "G94", "G95", "G97"],
    &["TRAORI", "TRAFOOF", "TRANSMIT"],
    &["ORIAXES", "ORIVECT", "ORIEULER"],
    &["ORIMKS", "ORIWKS"],
    &["D0", "D1", "D2"],
    &["M0", "M1", "M2", "M30", "M17"],
    &["M3", "M4", "M5"],
    &["M7", "M8", "M9"],
    &["CYCLE800()", "CYCLE832()", "TRAFOOF", "MCALL"],
];

#[rustfmt::skip]
const HEIDENHAIN_GROUPS: &[&[&str]] = &[
    &["L", "LN", "C", "CC", "CP", "CR"],
    &["DR+", "DR-"],
    &["R0", "RL", "RR"],
    &["FMAX", "F100", "F AUTO"],
    &["M0", "M1", "M2", "M30"],
    &["M3", "M4", "M5", "M13"],
    &["M8", "M9", "M7"],
    &["M91", "M92", "M99", "M89"],
    &["M126", "M127", "M128", "M129", "M116"],
    &["SEQ+", "SEQ-", "SYM+"],
    &["TURN", "MOVE", "STAY"],
    &["TABLE", "COORD"],
    &["AXIS", "VECTOR"],
    &["TCP", "CONT"],
    &["200", "201", "203", "205", "207", "206", "209", "240"],
    &["RESET", "SPATIAL"],
];

#[rustfmt::skip]
const ISO: &[&str] = &[
    "G28", "G30", "G28 Z-200.", "G28 X0. Y0.", "G91 G28 Z0.", "G30 Z0.", "G28 B0.", "G28.1",
    "G52 X5.", "G52 X0. Y0. Z0.", "G92 X0.", "G92 Z10.", "G92.1", "G92.2",
    "G10 L2 P1 X5.", "G10 L20 P1 X0.", "G10 L10 P1 Z5.", "G10 L1 P1 Z5.", "G10 L11 P1 R5.",
    "G51 X0. Y0. Z0. P2.", "G50", "G51.1 X0.", "G50.1 X0.", "G16", "G15", "G68 X0. Y0. R30.", "G69",
    "M98 P1000", "M98 P9000", "M97 P100", "M99", "M99 P10", "G65 P9010", "G66 P9010", "G67",
    "GOTO 10", "GOTO10", "#101=5.", "#1=0", "#5221=5.", "#3000=1 (X)", "X#101", "X[1.+2.]",
    "IF [#1 EQ 1] GOTO 5", "WHILE [#1 LT 2] DO1", "END1",
    "G54", "G55", "G56", "G57", "G58", "G59", "G54.1 P1", "G54.1 P5", "G154 P3", "G53",
    "G20", "G21", "G70", "G71", "G90", "G91", "G90.1", "G91.1", "G93", "G94", "G95", "G96 S200", "G97",
    "G17", "G18", "G19", "G40", "G41", "G41 D5", "G42 D5", "G42", "G41.1 D5.",
    "G43", "G43 H1", "G43 H2", "G43 H5", "G43.1 Z5.", "G44 H1", "G49", "G43.2 H5",
    "G43.4 H1", "G43.5 H1", "G234 H1", "G254", "G255", "G253", "G269", "G68.2 X0. Y0. Z0. I0. J10. K0.", "G53.1",
    "G268 X0. Y0. Z0. I0. J10. K0. Q123",
    "G61", "G64", "G64 P0.5", "G64 P10.", "G64 P0.01", "G61.1", "G05.1 Q0", "G05.1 Q1", "G5 P10000", "G08 P1",
    "G187", "G187 P1", "G187 P3 E0.5", "G12.1", "G13.1", "G7.1 C10.", "G8", "G7", "G12 I5. F100.", "G150",
    "G73 Z-5. R2. Q1. F100.", "G81 X5. Y5. Z-5. R2. F100.", "G80", "G81", "G82", "G83", "G84", "G85", "G98", "G99",
    "M0", "M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8", "M9", "M3 S500", "M4 S4000", "M10", "M11", "M13", "M14",
    "M19", "M29", "M29 S500", "M30", "M48", "M49", "M50", "M51", "M60", "M83", "M84", "M88", "M89", "M100", "M135",
    "M428", "M429", "M68", "M69", "M77",
    "T1", "T2", "T9 M6", "T0 M6", "T1 M6", "T5",
    "S100", "S9000", "S0", "F10.", "F5000.", "F0.", "F100.", "D5", "D0", "H5", "H0", "H1", "P5", "P500", "Q1.", "R5.",
    "L2", "L0", "L3", "K3", "K0", "E1.", "N5", "N10 G0",
    "X500.", "Y-300.", "Z-40.", "Z200.", "A5.", "B5.", "C90.", "U1.", "V1.", "W1.", "I5.", "J5.", "K5.", "X5. Y5.",
    "R-8.", "X25. L0", "X25. L3", "X1. Y1. Z1. A1. B1. C1.",
    "G0", "G1", "G2", "G3", "G0 Z200.", "G1 Z-5. F100.", "G0 X5. Y5.", "G53 G0 Z0.", "G53 G0 X0. Y0.", "G53 G0 Z-100.",
    "G53 Z-100.", "G49 G53 G0 Z0.", "G4 P1", "G4 P1000", "G4 X1.", "G4", "G9", "G60 X5.", "G33.1 Z-5. K1.", "G33",
    "G38.2 Z-5. F10.", "G31 Z-5. F10.", "G76 P1", "G37", "G93 B5. F72.", "G94 F500.", "G91 X5.", "G90 X5.",
    "G91\nX5.\nG90", "G80 G40", "G17 G90", "G40 G49 G80",
    "%", "O0002", "O0002 (OTHER)", "/", "/M8", "/G0 Z100.", ";", ";G0 X5.", "(COMMENT)", "(MSG, HELLO)", "( T1 )",
    "(", ")", "[", "]", "M8 M9", "M9 M8", "M3 M5", "$5", "!", "&",
];

#[rustfmt::skip]
const LINUXCNC: &[&str] = &[
    "o100 call", "o<sub> call", "o100 sub", "o100 endsub", "o5 if [1]", "o5 endif", "o5 while [1]", "o100 return",
    "#<_x>=5", "#5403=10", "#5220=2", "M61 Q5", "M66 P0 L3", "M62 P1", "M63 P1", "M64 P0", "M65 P0", "M67 E0 Q1",
    "M70", "M71", "M72", "M73", "M52 P1", "M53 P1", "G5.1 X1 Y1 I1 J1", "G5 I1 J1 P1 Q1 X5 Y5", "G5.2 X1 Y1 L2 P1", "G10 L2 P0 X5",
    "G59.1", "G59.3", "G92.3", "(abort, STOP)", "(debug, #5403)", "(print, x)", "(probeopen x)", "(py, x)",
    "; REMARK", "M110", "G64 P0.05 Q0.05", "G96 D500 S200", "X+5", "X 5", "x5", "G 0", "@5 ^90", "G28.1", "G30.1",
    "G73 X1 Y1 Z-5 R2 Q1", "G86 X1 Y1 Z-5 R2 P1", "G89 X1 Y1 Z-5 R2 P1", "G84 X1 Y1 Z-5 R2", "G52 Y5", "M19 R90 Q5",
    "G49 G53 G0 Z0", "M428 M429", "G43 H1 Z5", "G43 H3", "M198", "M2 M30",
];

#[rustfmt::skip]
const FANUC_AND_HAAS: &[&str] = &[
    "#10001=5.", "#2001=5.", "#5201=5.", "G10 L50", "G11", "G10 L12 P1 R5.", "G10 G90 L2 P1 X0.", "G22", "G23", "G27 X0.",
    "G29 X0.", "G30.1", "G36", "G72.1 P1", "G107", "G110", "G111", "G143", "G151", "G184 Z-5. R2. F100.", "G266 X5. F100.",
    "M16", "M18", "M21", "M31", "M33", "M36", "M41", "M73", "M74", "M75", "M95", "M96 P1 Q1", "M109", "M17", "M198 P1",
    "IF [#1 EQ #0] THEN #2=1", "IF [ABS[#10001+#11001-99.] GT 99] THEN #3000=101 (X)", "M8;M9", "G0 Z100.;", "X5;X6", "X5.;Y6.",
    ";X500.", ";M30", ";M5", "X1000", "Z-5", "Z5000", "F100", "X1.5E3", "X.5", "X-.5", "G00", "G01", "M03 S100", "M05", "M08",
    "M09", "G04 P2.", "G04 P2000", "N1", "N2 M30", "N9999", "<NAME>", "M98 <SUB>", "POPEN", "DPRNT[X]",
];

#[rustfmt::skip]
const FANUC: &[&str] = &[
    "G05 P10000", "G05 P0", "G43.4 H1 P1", "G43.4 H5 P0", "G54.2 P1", "G54.2 P0", "G54.4 P1", "G61.2 P1", "G63", "G62", "G68.3",
    "G68.4 X0. Y0. Z0. I0. J10. K0.", "G69.1", "G53.2", "G53.6 R5.", "G40.1", "G41.2 D1", "G41.3 D1", "G42.2 D1", "G02.4 X1. Y1. Z1.",
    "G06.2", "G07.1 C10.", "G50.2", "G51.2 P1 Q1", "G74 X0. Y0. Z-5. R2. F100.", "G76 X0. Y0. Z-5. R2. Q1. F100.", "G87 X1.",
    "G91.1", "G92.1 X0.", "G93 F10.", "G05.1 Q2", "G05.1 Q3", "G08 P0", "G49.1", "G112", "G113", "M198 P2", "G10.6 X1.", "G31.8",
    "G100", "M5 M9", "G90 G91", "G91 G90", "G17 G18", "G0 G1", "G1 G0", "G54 G55", "G55 G54",
];

#[rustfmt::skip]
const HAAS: &[&str] = &[
    "G12 I5. F100. Z-1.", "G13 I5. F100. Z-1.", "G47 P1 X0. Y0.", "G35", "G70 I5. J0. L3", "G71 I5. J0. L3 K90.", "G72 I5. J0. L3",
    "G77", "G93 F10.", "G100 X0.", "G101 X0.", "G102", "G103 P1", "G103", "G110", "G129", "G136", "G141 X1. Y1. Z1. I0. J0. K1. D1",
    "G153 X1. Y1. Z-5. R2. F100.", "G155", "G161", "G174", "G187 P2 E0.01", "G187 P3", "G188", "G253.", "G254 X0.", "G268",
    "G269 G80", "M12", "M15", "M22", "M23", "M24", "M34", "M35", "M39", "M46 Q1", "M59 P1100", "M63 P1", "M69", "M76", "M78", "M79",
    "M80", "M82", "M83 P1", "M86", "M87", "M90", "M104", "M130 (X)", "M138", "M139", "M199", "G234", "G234 H5", "G141", "H5 Z10.",
    "T1 M06 M03 S500", "G90 G91", "G17 G18", "G55 G54",
];

#[rustfmt::skip]
const SIEMENS: &[&str] = &[
    "G74 X1=0", "G75 FP=1 Z1=0", "G75 Z1=0", "TRANS X5", "TRANS", "ATRANS Z1", "ROT Z30", "ROT", "AROT Z30", "ROTS X10", "MIRROR X0",
    "MIRROR", "AMIRROR X0", "SCALE X2", "ASCALE X2", "G58 X5", "G59 X5", "G500", "G53", "G153", "SUPA", "SUPA G0 Z-100",
    "SUPA G0 X0 Y0 D0", "SUPA G0 Z0 D0", "SUPA G0 Z0", "D0", "D1", "D2", "D=1", "G54", "G55", "G505", "G506", "G40", "G41", "G42", "G17",
    "G18", "G19", "G70", "G71", "G700", "G710", "G90", "G91", "G93", "G94", "G95", "G96 S200", "G97", "G961", "G60", "G64",
    "G641 ADIS=0.5", "G641", "G642", "G645", "G9", "G601", "G603", "FFWON", "FFWOF", "SOFT", "BRISK", "COMPCAD", "COMPON", "COMPOF",
    "CYCLE832()", "CYCLE832(10,1,1)", "CYCLE832(0.01,3,1)", "CYCLE832(0,0,1)", "TRAORI", "TRAORI(1)", "TRAORI(2)", "TRAFOOF", "TRAFOOF()", "TRANSMIT",
    "TRACYL(40)", "CYCLE800()", "CYCLE800(0,\"\",0,57,0,0,0,10,0,0,0,0,0,1,0)", "CYCLE800(1,\"\",0,57,0,0,0,0,0,0,0,0,0,1,0)",
    "CYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,-1,0)", "CYCLE800(4,\"\",0,57,5,0,0,0,0,0,0,0,0,0,0)",
    "ORIAXES", "ORIVECT", "ORIWKS", "ORIMKS", "ORIWKS ORIVECT", "ORIMKS ORIAXES", "ORIEULER", "ORIRPY", "ORICONCW", "ORICURVE", "ORIRESET(0,0)",
    "OTOL=1", "CTOL=0.5", "ATOL=1", "R1=5", "R1=R1+1", "X=R1", "X=5+5", "X=(5)", "DEF REAL A5", "GOTOF ENDE", "GOTOB START", "GOTO 5", "GOTOS", "ENDE:",
    "REPEAT ENDE", "REPEATB ENDE P=3", "IF R1==0", "ENDIF", "ELSE", "WHILE R1<5", "FOR R1=0 TO 5", "LOOP", "CASE R1 OF 1 GOTOF X",
    "CALL \"X\"", "L100", "L100 P3", "SUB1", "EXTCALL(\"X\")", "EXECSTRING(\"X5\")", "PCALL X", "PROC X", "MCALL",
    "MCALL CYCLE81(50,0,2,-5)", "CYCLE81(50,0,2,-5)", "CYCLE82(50,0,2,-5,0,1)", "HOLES1(0,0,0,0,5,3)", "HOLES2(0,0,5,0,0,3)",
    "POCKET3(50,0,2,-5)", "CYCLE61(50,0,2,-5)", "CYCLE76", "CYCLE78", "CYCLE86(50,0,2,-5,0,1,3,1,1,1,0)", "CYCLE99", "MCALL CYCLE85(50,0,2,-5,,1,50,50)",
    "M0", "M00", "M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8", "M9", "M10", "M11", "M17", "M19", "M30", "M40", "M41", "M70", "M77",
    "M68", "M69", "M83", "M84", "M88", "M89", "M3=5", "M1=3", "M2=3", "RET", "STOPRE", "G4 F1", "G4 S5", "G4 F100", "G4",
    "S100", "S1=500", "S2=500", "S0", "F10", "F5000", "F0", "F100", "F=50", "FB=10", "F[X]=5", "FL[X]=50", "FGROUP(X,Y,Z)", "FGROUP(X)", "FGREF[A]=10", "FNORM", "FLIN",
    "OVR=50", "OVRRAP=50", "VELOLIM[X]=50", "ACC[X]=50",
    "T1", "T2", "T5", "T0", "T=\"MILL\"", "T9", "T1=5", "DL=1", "X500", "Y-300", "Z-40", "Z200", "A5", "B5", "C90", "U5", "V5", "W5", "A=DC(10)", "B=DC(10)", "C=ACP(10)",
    "C=ACN(10)", "X=IC(5)", "X=AC(5)", "Z=IC(-1)", "Z=AC(100)", "A3=0 B3=0 C3=1", "A3=0.1", "A2=0 B2=0 C2=5", "LEAD=5", "TILT=5", "TURN=2", "CR=5", "AR=90",
    "AP=45 RP=10", "I5", "J5", "K5", "I=AC(5)", "I1=5", "SPOS=0", "SPOS[2]=90", "SPCON", "SETMS(2)", "POS[X]=5", "POSA[X]=5", "X5 Y5", "X1 Y1 Z1 A1 B1 C1",
    "G0", "G1", "G2", "G3", "G0 Z200", "G1 Z-5 F100", "G0 X5 Y5", "CIP X1 Y1 I1=1 J1=1", "CT X5", "G33 K1", "G331 Z-5 K1", "G332 Z5 K1", "G63 Z-5 F100", "ASPLINE", "BSPLINE", "POLY",
    "G91\nX5\nG90", "G93 B5 F72", "G94 F500", "G90 X5", "G91 X5", "RTLIOF", "RTLION",
    "WAITM(1,1,2)", "INIT(2,\"X\")", "START(2)", "MSG(\"HELLO\")", "MSG()", "; REMARK", ";", "/M8", "/1 M8", "/", "/G0 Z100", "N5", "N10 G0", ":5", "%", "%_N_X_MPF", "[", "(", "$5", "!", "@5",
    "G25 X0", "G26 X0", "G25 S100", "WALIMON", "WALIMOF", "DIAMON", "DIAMOF", "NORM", "KONT", "OFFN=1", "CUT2D", "CUT3DC", "TOFFL=1", "TOFFR=1", "TOFF[Z]=1", "TOFFON(3)", "TCARR=1", "TCOABS", "PAROT", "TOFRAME", "TOROT",
    "G110 X0", "G111 X0", "$P_UIFR[1]=CTRANS(X,1)", "$P_PFRAME=CTRANS(X,1)", "$TC_DP3[1,1]=50", "$A_OUT[1]=1", "$AC_OVR=50", "WHEN TRUE DO M8", "ID=1 WHENEVER TRUE DO $AC_OVR=0",
    "SPLINEPATH(1)", "COUPON(X,Y)", "TRAILON(X,Y)", "TANGON(C,0)", "PTP", "CP", "G290", "G291", "SBLOF", "DISPLOF", "ADIS=1", "ADISPOS=5", "CHF=2", "CHR=2", "RND=2", "RNDM=2", "FRC=50",
    "M8 M9", "M9 M8", "M3 M5", "G17 G18", "G90 G91", "G0 G1", "X5 X6", "H5", "H1=5", "P3", "Q1", "E5", "L5",
];

#[rustfmt::skip]
const HEIDENHAIN: &[&str] = &[
    "L X+500 R0 FMAX", "L X+5 Y+5", "L Y-300 F100", "L IX+5 FMAX", "L IZ-5 F100", "L B+5 F500", "L A+5 F500", "L C+90 R0 FMAX", "L IC+90 FMAX", "L X+0 Y+0 B+5 F500",
    "L Z+0 R0 FMAX M91", "L Z-100 R0 FMAX M91", "L Z+0 R0 FMAX M92", "L IZ+0 R0 FMAX M91", "L X+5 R0 FMAX M91", "L X+0 Y+0 R0 FMAX M91", "L Z+100 R0 FMAX", "L Z+200 FMAX", "L Z-5 F100",
    "L M3", "L M5", "L M8", "L M140 MB MAX", "L M140 MB50 FMAX", "L", "L FMAX", "L F100", "L R0", "L RL", "LP PR+5 PA+45", "LN X+0 Y+0 Z+5 NX+0 NY+0 NZ+1 TX+0 TY+0 TZ+1 F100",
    "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+5", "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 #5", "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X", "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1",
    "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30", "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 2", "CYCL DEF 26.0 AXIS-SPEC. SCALING\nCYCL DEF 26.1 X1.5",
    "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 5", "CYCL DEF 13.0 ORIENTATION\nCYCL DEF 13.1 ANGLE 0", "CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 OTHER",
    "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+10 B+0 C+0", "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1",
    "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T5", "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1", "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.01\nCYCL DEF 32.2 HSC-MODE:1 TA5",
    "CYCL DEF 247 DATUM SETTING ~\n  Q339=+5 ;DATUM NUMBER", "CYCL DEF 247 DATUM SETTING ~\n  Q339=+1 ;DATUM NUMBER",
    "CYCL DEF 200 DRILLING ~\n  Q200=+2 ;A ~\n  Q201=-20 ;B ~\n  Q206=+100 ;C ~\n  Q202=+20 ;D ~\n  Q210=+0 ;E ~\n  Q203=+0 ;F ~\n  Q204=+50 ;G ~\n  Q211=+0 ;H",
    "CYCL DEF 220 POLAR PATTERN ~\n  Q216=+0 ;A", "CYCL DEF 18.0 THREAD CUTTING\nCYCL DEF 18.1 DEPTH -5", "CYCL DEF 239 ASCERTAIN LOAD", "CYCL DEF 14.0 CONTOUR",
    "CYCL CALL", "CYCL CALL M3", "CYCL CALL FMAX", "CYCL CALL POS X+5 Y+5 Z+0 FMAX", "CYCL CALL PAT FMAX", "CALL LBL 1", "CALL LBL 1 REP3", "CALL LBL \"FITS1\"", "LBL 1", "LBL 0", "LBL \"A\"",
    "CALL PGM OTHER", "CALL PGM TNC:\\X.H", "SEL PGM \"X\"", "SEL CYCLE \"X\"", "CALL SELECTED PGM",
    "FN 0: Q201 = -50", "FN 0: Q203 = +5", "FN 0: Q200 = +1", "FN 0: Q206 = +999", "FN 0: Q202 = +1", "FN 0: Q1 = +5", "FN 0: QL1 = +5", "FN 1: Q203 = +1 + +1", "FN 2: Q201 = +1 - +5", "FN 3: Q1 = +1 * +5",
    "FN 9: IF +0 EQU +0 GOTO LBL 1", "FN 9: IF +0 EQU +0 GOTO LBL \"FITS1\"", "FN 12: IF +0 LT +1 GOTO LBL 1", "FN 14: ERROR = 100", "FN 16: F-PRINT X", "FN 17: SYSWRITE ID50 NR1 IDX1 = +5", "FN 17: SYSWRITE ID 210 NR1 = +1", "FN 18: SYSREAD Q201 = ID50 NR1 IDX1", "FN 18: SYSREAD Q1 = ID50 NR1",
    "FN 19: PLC = +1", "FN 20: WAIT FOR SYNC", "FN 38: SEND /\"X\"", "Q201 = -50", "Q1 = 5", "QL1 = 5", "QS1 = \"X\"", "X+Q1",
    "PLANE RESET STAY", "PLANE RESET TURN FMAX", "PLANE RESET TURN MB50 FMAX", "PLANE RESET TURN MB MAX FMAX", "PLANE RESET MOVE DIST50 FMAX", "PLANE RESET MOVE FMAX", "PLANE RESET",
    "PLANE SPATIAL SPA+10 SPB+0 SPC+0 STAY", "PLANE SPATIAL SPA+10 SPB+0 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT", "PLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN MB MAX FMAX SEQ- COORD ROT", "PLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT",
    "PLANE SPATIAL SPA+0 SPB+0 SPC+0 MOVE DIST50 FMAX", "PLANE AXIAL B+10 TURN FMAX", "PLANE RELATIV SPB+10 TURN FMAX", "PLANE VECTOR BX+1 BY+0 BZ+0 NX+0 NY+0 NZ+1 STAY", "PLANE EULER EULPR+0 EULNU+10 EULROT+0 STAY", "PLANE PROJECTED PROPR+0 PROMIN+10 ROT+0 STAY",
    "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS", "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR", "FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS", "FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS", "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CENTER-CENTER",
    "FUNCTION RESET TCPM", "FUNCTION MODE TURN", "FUNCTION MODE MILL", "FUNCTION S-PULSE RESET", "FUNCTION FEED DWELL D-TIME0.5 F-TIME5", "FUNCTION PROG PATH IS OFF", "FUNCTION CORRDATA RESET", "FUNCTION DCM OFF", "FUNCTION PARAXMODE X Y W",
    "TRANS DATUM AXIS X+5", "TRANS DATUM TABLE TABLINE5", "TRANS DATUM RESET", "TRANS MIRROR AXIS X", "TRANS MIRROR RESET", "TRANS ROTATION ROT+30", "TRANS ROTATION RESET", "TRANS SCALE SCL1.5", "TRANS SCALE RESET", "PRESET SELECT #5", "FUNCTION PARAXCOMP DISPLAY W",
    "M0", "M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8", "M9", "M13", "M14", "M19", "M30", "M83", "M84", "M88", "M89", "M90", "M91", "M92", "M94", "M97", "M98", "M99", "M101", "M102", "M103 F50", "M107", "M108", "M109", "M110", "M111", "M112", "M114", "M115", "M116", "M117",
    "M118 X1", "M120 LA5", "M124 T0.1", "M126", "M127", "M128", "M128 F1000", "M129", "M130", "M134", "M135", "M136", "M137", "M138 A", "M140 MB MAX", "M141", "M142", "M143", "M144", "M145", "M148", "M149", "M200", "M10", "M11", "M68", "M69", "M77",
    "S500", "F100", "F5000", "F AUTO", "FMAX", "F0", "FZ0.1", "FU0.2", "T1",
    "TOOL CALL 1 Z S1000", "TOOL CALL 2 Z S1000", "TOOL CALL 2 Y S1000", "TOOL CALL S500", "TOOL CALL 1 Z S1000 DL+1", "TOOL CALL 1 Z S1000 DR+1", "TOOL CALL DL+1", "TOOL CALL 1.1 Z S1000", "TOOL CALL \"MILL\" Z S1000", "TOOL CALL F500", "TOOL CALL", "TOOL CALL 0 Z", "TOOL CALL Z",
    "TOOL DEF 2", "TOOL DEF 1", "TOOL DEF 1 L+50 R+5", "TOOL DEF \"MILL\"",
    "CC X+5 Y+5", "CC", "CC IX+5 IY+5", "CC X+5", "C X+5 Y+5 DR+ R0 F100", "CR X+5 Y+5 R+10 DR+", "CT X+5 Y+5", "CP IPA+90 DR+", "CTP PA+90", "RND R2", "CHF 2", "APPR LT X+5 Y+5 LEN5 RL F100", "DEP LT LEN5", "FPOL X+0 Y+0", "FL X+5",
    "END PGM NONAME MM", "BEGIN PGM X MM", "BEGIN PGM X INCH", "STOP", "STOP M8", "; REMARK", "* - TITLE", "/M8", "/L Z+100 R0 FMAX", "BLK FORM 0.1 Z X+0 Y+0 Z-10", "POLARKIN AXES X Y C MODE:KEEP", "SEL TABLE \"X\"", "PATTERN DEF POS1 (X+0 Y+0 Z+0)", "TOUCH-PROBE", "TCH PROBE 0.0 REF. PLANE Q5 X-", "MONITORING HEATMAP STOP FOR", "SECTION MONITORING STOP", "SPLINE", "FUNCTION STROBE",
    "R0", "RL", "RR", "X+500", "Z-40", "Z+200", "IX+5", "IZ-5", "Y-300", "A+5", "B+5", "C+90", "IC+10", "U+5", "V+5", "W+5", "PA+45", "IPA+45", "PR+5", "DR+", "DR-", "TX+0", "TX+0 TY+0 TZ+1", "NX+0 NY+0 NZ+1", "SEQ+", "SEQ-", "COORD ROT", "SYM+", "MB50", "DIST50", "STAY", "M8 M9", "M3 M5", "M91 M99", "X+5 X+6", "FMAX F100", "%", ":", "[", "(", "$5",
];
