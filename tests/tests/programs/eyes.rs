//! The check does not share the planner's eyes: a program that a planner with another retract geometry, or another
//! rotation of the part, would have written is found.
//!
//! Such a program is posted with a configuration that differs in that one value, and checked with the right one.

use std::io::Cursor;

use machines::SpinnerU5620;
use pp_runtime::check::check;
use pp_runtime::config::{Config, Mode, starting_point};
use pp_runtime::control::{CONTROLS, Control};
use pp_runtime::diag::Severity;
use pp_runtime::kinematics::Machine;
use pp_runtime::post;
use tests::further::HeadTable;

/// A program and the reader of its check.
struct Set {
    control: &'static dyn Control,
    mode: Mode,
    cl: String,
}

/// Rotation by 10° about X, then 15° about Y, then 20° about Z.
const MATRIX_XYZ: &str = "[[0.907673371190369, -0.294591055321609, 0.298906609756981], [0.330366089549352, 0.940788145499406, -0.075999422127131], [-0.258819045102521, 0.167731259496521, 0.951251242564198]]";

/// The same in the order Z, Y, X.
const MATRIX_ZYX: &str = "[[0.907673371190369, -0.330366089549352, 0.258819045102521], [0.379057122345321, 0.910045011297241, -0.167731259496521], [-0.180124260529211, 0.250352400205939, 0.951251242564198]]";

/// The inverse rotation.
const MATRIX_TRANSPOSED: &str = "[[0.907673371190369, 0.330366089549352, -0.258819045102521], [-0.294591055321609, 0.940788145499406, 0.167731259496521], [0.298906609756981, -0.075999422127131, 0.951251242564198]]";

/// Two operations, the second with an inclined tool axis, both inside of the clearance geometry.
fn inclined(axis: [f64; 3]) -> String {
    let [i, j, k] = axis;
    format!(
        "UNITS/MM\nTOOL PATH/A,TOOL,T1\nLOADTL/1,LENGTH,100.0\nSPINDL/RPM,2000,CLW\nRAPID\n\
         GOTO/5.0,8.0,12.0,0.0,0.0,1.0\nFEDRAT/MMPM,300.0\nGOTO/5.0,8.0,2.0\nGOTO/25.0,8.0,2.0\nGOTO/25.0,18.0,2.0\n\
         END-OF-PATH\nTOOL PATH/B,TOOL,T1\nLOADTL/1,LENGTH,100.0\nSPINDL/RPM,2000,CLW\nRAPID\n\
         GOTO/-6.0,4.0,9.0,{i},{j},{k}\nFEDRAT/MMPM,300.0\nGOTO/-8.0,4.0,3.0\nGOTO/-8.0,-9.0,3.0\n\
         END-OF-PATH\nFINI\n"
    )
}

impl Set {
    fn config<M: Machine>(&self, text: &str) -> Config {
        let config = starting_point(self.control).read_over(&M::default(), text);
        let mut config = config.unwrap_or_else(|faults| panic!("{text}: {faults:?}"));
        config.motion.mode = self.mode;
        config.given.insert("part_origin");
        config
    }

    fn posted<M: Machine>(&self, text: &str) -> String {
        let config = self.config::<M>(text);
        let job = post::Job { cl_name: "part.cls", config: &config, control: self.control, units: None };
        let mut program = Vec::new();
        let report = post::post::<M>(&job, &mut Cursor::new(&self.cl), &mut program).expect("it can be written");
        let error = report.diagnostics.iter().find(|found| found.severity == Severity::Error);
        assert!(!report.failed, "{text}: {error:?}");
        String::from_utf8(program).expect("ASCII")
    }

    fn findings<M: Machine>(&self, program: &str, text: &str) -> Vec<String> {
        let policy = self.config::<M>(text).check_policy::<M>(self.control, None).expect("it can be checked");
        let checked = check::<M>(&policy, Cursor::new(&self.cl), program.as_bytes()).expect("it can be read");
        assert_eq!(checked.fault, None);
        checked.outcome.findings.into_iter().map(|finding| finding.text).collect()
    }

    /// Whether the right program has no finding, and the planner's other eyes are found.
    fn assert_seen<M: Machine>(&self, right: &str, wrong: &str) {
        let name = format!("{} {}", self.control.spellings().name, self.mode.name());
        let found = self.findings::<M>(&self.posted::<M>(right), right);
        assert!(found.is_empty(), "{name}, {right}: {found:?}");
        let program = self.posted::<M>(wrong);
        assert_ne!(program, self.posted::<M>(right), "{name}: {wrong} changes nothing");
        assert!(!self.findings::<M>(&program, right).is_empty(), "{name}: {wrong} is not found");
    }
}

/// Calls a function for every control and mode in which the part can be posted.
fn everywhere(cl: &str, test: impl Fn(&Set)) {
    let mut sets = 0;
    for control in CONTROLS.iter().copied() {
        for mode in [Mode::Axes, Mode::Tcp, Mode::Plane] {
            if control.spellings().plane.is_none() && mode == Mode::Plane {
                continue;
            }
            test(&Set { control, mode, cl: cl.to_owned() });
            sets += 1;
        }
    }
    assert_eq!(sets, 14);
}

fn keys(set: &Set, keys: &str) -> String {
    let frame = if set.control.spellings().name == "fanuc" { "tcp_frame = \"table_at_zero\"\n" } else { "" };
    let codes = match set.control.spellings().name {
        "linuxcnc" => "[control]\ntip_control = [\"M428\", \"M429\"]\n",
        _ => "",
    };
    format!("units = \"mm\"\ntcp_confirmed = true\n{frame}{keys}\n{codes}")
}

#[test]
fn another_retract_geometry_is_found() {
    let clearance = |geometry: &str| format!("[retract]\nclearance = {geometry}\n");
    let pairs = [
        ("{ plane = 40.0 }", "{ plane = 39.5 }"),
        ("{ plane = 40.0 }", "{ plane = 40.5 }"),
        (
            "{ cylinder = { radius = 60, lower = -30, upper = 50 } }",
            "{ cylinder = { radius = 57, lower = -30, upper = 50 } }",
        ),
        (
            "{ cylinder = { radius = 60, lower = -30, upper = 50 } }",
            "{ cylinder = { radius = 60, lower = -30, upper = 49.5 } }",
        ),
        // Without its cap.
        (
            "{ cylinder = { radius = 60, lower = -30, upper = 50 } }",
            "{ cylinder = { radius = 60, lower = -3000, upper = 3000 } }",
        ),
        ("{ box = [[-50, -50, -30], [50, 50, 40]] }", "{ box = [[-50, -50, -30], [49.5, 50, 39.5]] }"),
    ];
    everywhere(&inclined([0.866_025_403_784, 0.0, 0.5]), |set| {
        for (right, wrong) in pairs {
            let [right, wrong] = [right, wrong].map(|geometry| keys(set, &format!("\n{}", clearance(geometry))));
            set.assert_seen::<SpinnerU5620>(&right, &wrong);
        }
        for (right, wrong) in [("distance = 40.0", "distance = 39.5"), ("distance = 40.0", "distance = 43.0")] {
            let [right, wrong] = [right, wrong].map(|key| keys(set, &format!("\n[retract]\n{key}\n")));
            set.assert_seen::<SpinnerU5620>(&right, &wrong);
            set.assert_seen::<HeadTable>(&right, &wrong);
        }
    });
}

#[test]
fn another_rotation_of_the_part_is_found() {
    let retract = "\n[retract]\ndistance = 40.0\n";
    let rotations = [
        // About each axis: the other way round, and by little.
        ("[0.0, 0.0, 30.0]", "[0.0, 0.0, -30.0]"),
        ("[0.0, 0.0, 30.0]", "[0.0, 0.0, 30.01]"),
        ("[10.0, 0.0, 0.0]", "[-10.0, 0.0, 0.0]"),
        ("[0.0, 10.0, 0.0]", "[0.0, 10.01, 0.0]"),
        // About Z, Y and X instead of X, Y and Z; the transposed matrix.
        (MATRIX_XYZ, MATRIX_ZYX),
        (MATRIX_XYZ, MATRIX_TRANSPOSED),
        ("[10.0, 15.0, 20.0]", MATRIX_ZYX),
    ];
    everywhere(&inclined([0.5, 0.0, 0.866_025_403_784]), |set| {
        for (right, wrong) in rotations {
            let [right, wrong] =
                [right, wrong].map(|rotation| keys(set, &format!("part_rotation = {rotation}{retract}")));
            set.assert_seen::<SpinnerU5620>(&right, &wrong);
        }
    });
}

#[test]
fn the_order_of_rotations_is_that_of_the_documentation() {
    let right = format!("part_rotation = {MATRIX_XYZ}\n[retract]\ndistance = 40.0\n");
    let angles = "part_rotation = [10.0, 15.0, 20.0]\n[retract]\ndistance = 40.0\n";
    everywhere(&inclined([0.5, 0.0, 0.866_025_403_784]), |set| {
        let [right, angles] = [&*right, angles].map(|text| keys(set, text));
        let program = set.posted::<SpinnerU5620>(&angles);
        let found = set.findings::<SpinnerU5620>(&program, &right);
        assert!(found.is_empty(), "{}: {found:?}", set.control.spellings().name);
    });
}
