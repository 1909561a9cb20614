//! CL data of the benchmarks.

use std::fmt::Write as _;

const HEAD: &str = "TOOL PATH/PART,TOOL,BALL_6\nTLDATA/MILL,6.0000,3.0000,75.0000,0.0000,0.0000\n\
                    MSYS/0,0,0,1,0,0,0,1,0\nLOAD/TOOL,1\nSPINDL/RPM,12000,CLW\nFEDRAT/MMPM,1800\n";

/// Point of a blade: tip and tool axis. Every coordinate changes from each point to the next.
fn blade_point(index: usize) -> String {
    let turn = index as f64 * 0.004;
    let (swing, tilt) = (2.4 * (turn * 0.21).sin(), 0.55 + 0.25 * (turn * 0.37).sin());
    let (x, y, z) = (48.0 * turn.cos(), 36.0 * (turn * 1.3).sin(), 20.0 + 9.0 * (turn * 0.7).sin());
    let (i, j, k) = (tilt.sin() * swing.cos(), tilt.sin() * swing.sin(), tilt.cos());
    format!("GOTO/{x:.4},{y:.4},{z:.4},{i:.7},{j:.7},{k:.7}\n")
}

/// One operation with simultaneous motion of five axes.
pub(crate) fn blade(points: usize) -> String {
    HEAD.to_owned() + &(0..points).map(blade_point).collect::<String>() + "END-OF-PATH\n"
}

/// The same points in operations of 100.
pub(crate) fn short_operations(points: usize) -> String {
    let mut text = String::new();
    for first in (0..points).step_by(100) {
        text += HEAD;
        text += "RAPID\n";
        text.extend((first..points.min(first + 100)).map(blade_point));
        text += "END-OF-PATH\n";
    }
    text
}

/// One operation with a vertical tool axis.
pub(crate) fn plane(points: usize) -> String {
    let mut text = HEAD.to_owned();
    for index in 0..points {
        let turn = index as f64 * 0.004;
        let (x, y, z) = (48.0 * turn.cos(), 36.0 * (turn * 1.3).sin(), 20.0 + 9.0 * (turn * 0.7).sin());
        writeln!(text, "GOTO/{x:.4},{y:.4},{z:.4}").expect("memory takes everything");
    }
    text + "END-OF-PATH\n"
}

/// Half circles in rows, each a record of its own with the point at its end.
pub(crate) fn arcs(count: usize) -> String {
    let mut text = HEAD.to_owned() + "GOTO/100,100,20,0,0,1\n";
    for arc in 0..count {
        let (row, radius) = (100.0 + (arc / 50) as f64 * 0.25, 10.0 + (arc % 7) as f64 * 0.25);
        let (start, end) = if arc % 2 == 0 { (100.0, 100.0 + 2.0 * radius) } else { (100.0 + 2.0 * radius, 100.0) };
        writeln!(
            text,
            "GOTO/{start:.4},{row:.4},20.0000\nCIRCLE/{:.4},{row:.4},20.0000,0.0,0.0,1.0,{radius:.4}\n\
             GOTO/{end:.4},{row:.4},20.0000",
            0.5 * (start + end),
        )
        .expect("memory takes everything");
    }
    text + "END-OF-PATH\n"
}

/// Drilled holes in rows.
pub(crate) fn holes(count: usize) -> String {
    let mut text = HEAD.to_owned() + "RAPID\nGOTO/0,0,60,0,0,1\nCYCLE/DRILL,FEDTO,-10,RAPTO,2,MMPM,200\n";
    for hole in 0..count {
        writeln!(text, "GOTO/{:.3},{:.3},20.000", (hole % 50) as f64 * 1.25, (hole / 50) as f64 * 0.25)
            .expect("memory takes everything");
    }
    text + "CYCLE/OFF\nEND-OF-PATH\n"
}
