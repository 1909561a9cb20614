//! Keys whose effects meet in one block: each job is right, and an edit of that block is found.

use machines::{Dmu70e, SpinnerU5620};
use pp_runtime::config::starting_point;
use pp_runtime::control;
use pp_runtime::kinematics::Machine;
use tests::posting::{findings, posted};

/// A job for some controls, and an edit of its program.
struct Job {
    controls: &'static [&'static str],
    keys: &'static str,
    cl: &'static str,
    /// A part of a line, and what takes its place in the wrong program.
    edit: Option<[&'static str; 2]>,
}

impl Job {
    fn is_right<M: Machine + Default>(&self) {
        for name in self.controls {
            let control = control::by_name(name).expect("a control");
            let frame = if *name == "fanuc" { "tcp_frame = 'table_at_zero'\n" } else { "" };
            let text = format!("part_origin = [0.0, 0.0, 0.0]\nretract.distance = 80.0\n{frame}{}", self.keys);
            let config = starting_point(control)
                .read_over(&M::default(), &text)
                .unwrap_or_else(|faults| panic!("{text}: {faults:?}"));
            let cl = format!("UNITS/MM\nLOADTL/1\n{}FINI\n", self.cl);
            let program = posted::<M>(&config, control, &cl);
            let Some([from, to]) = self.edit else { continue };
            assert!(program.contains(from), "{name}: {program}");
            let wrong = program.replacen(from, to, 1);
            assert!(!findings::<M>(&config, control, &cl, &wrong).is_empty(), "{name}: {wrong}");
        }
    }
}

/// Under vectors the words do not show that the rotary axes rotate: the tool axes of the rapid do.
#[test]
fn a_link_at_feed_under_vectors() {
    let cl = "SPINDL/RPM,3000,CLW\nRAPID\nGOTO/10,0,22,0.4,0,0.9165151\nFEDRAT/MMPM,500\nGOTO/10,0,12,0.4,0,0.9165151\n\
        GOTO/10,10,12,0.35,0,0.9367497\nGOTO/10,20,10,0.4,0,0.9165151\nRAPID\nGOTO/10,20,12\nRAPID\n\
        GOTO/0,20,12,0.3,0,0.9539392\nGOTO/0,20,10,0.3,0,0.9539392\nGOTO/0,10,10,0.3,0.05,0.9526279\nRAPID\nGOTO/0,10,60\n";
    let keys = "rapid_feed = 4000.0\ntcp_words = 'vectors'\nmode = 'tcp'\ncontrol.linear_rapids = false\n";
    let job = |controls, edit| Job { controls, keys, cl, edit: Some(edit) };
    for job in [
        job(&["siemens"], ["G1 X0 A3", "G0 X0 A3"]),
        job(&["fanuc"], ["G1 X0. I", "G0 X0. I"]),
        job(&["heidenhain"], ["TZ+0.9539392 F4000", "TZ+0.9539392 FMAX"]),
    ] {
        job.is_right::<SpinnerU5620>();
        job.is_right::<Dmu70e>();
    }
}

/// The approach to a hole ends above it, and `rapid = "feed"` holds from there.
#[test]
fn holes_as_motions_after_an_approach_with_rapids_at_feed() {
    let cl = "SPINDL/RPM,3000,CLW\nRAPID\nGOTO/0,0,60,0,0,1\nCYCLE/DRILL,RAPTO,3,FEDTO,-5,MMPM,200,RTRCTO,5\nGOTO/5,9,20,0,0,1\n\
        GOTO/5,9,20,0,0.5,0.8660254\nCYCLE/OFF\nRAPID\nGOTO/0,10,60\n";
    for keys in ["mode = 'tcp'\n", "cycles.output = 'expanded'\n"] {
        let keys = &*format!("{keys}cl.dialect = 'nx'\nrapid = 'feed'\nrapid_feed = 4000.0\n").leak();
        let job =
            Job { controls: &["siemens", "fanuc", "heidenhain", "haas"], keys, cl, edit: Some(["F4000", "F4400"]) };
        job.is_right::<SpinnerU5620>();
        job.is_right::<Dmu70e>();
    }
}

/// With the rotary axes at zero a probe measures in a plane that is not tilted.
#[test]
fn a_probe_along_the_machine_axis_where_every_mode_is_a_plane() {
    let cl = "RAPID\nGOTO/0,0,60,0,0,1\nRAPID\nGOTO/0,0,5\nPROBE/BORE,20\nRAPID\nGOTO/0,0,60\n";
    for (name, block) in [
        ("siemens", "CYCLE977(1,,,1,20)"),
        ("fanuc", "G65 P9814 D20."),
        ("haas", "G65 P9814 D20."),
        ("heidenhain", "CYCL DEF 247"),
    ] {
        let keys = format!("mode = 'plane'\n[cycles.probe]\n\"PROBE/BORE,20\" = ['{block}']\n");
        let controls = &*vec![name].leak();
        Job { controls, keys: keys.leak(), cl, edit: None }.is_right::<SpinnerU5620>();
    }
}

/// `course.axis_tolerance` leads the tool axis to the pole, and the control chooses the rotation there: a linear axis
/// may have to move far.
#[test]
fn a_course_through_the_pole_with_the_speed_of_a_linear_axis() {
    let cl = "SPINDL/RPM,3000,CLW\nRAPID\nGOTO/-8,-3,51,-0.091953,-0.038877,0.995004\nFEDRAT/MMPM,1500\nGOTO/-3,-.4,12\n\
        GOTO/-1.5,-.2,12,-0.046034,-0.019463,0.998750\nGOTO/6,.8,12,0.182987,0.077365,0.980067\n";
    let keys = "course.axis_tolerance = 4.0\ntcp_words = 'vectors'\nspeeds.Y = 2000.0\n";
    let job = Job { controls: &["heidenhain", "fanuc"], keys, cl, edit: Some(["F1500", "F1600"]) };
    job.is_right::<SpinnerU5620>();
}

/// An operation that would go on from the last one, but for a rapid that may enter the clearance geometry, has an
/// approach: it ends where its first motion leads straight down.
#[test]
fn an_approach_in_place_of_a_rapid_that_may_enter_the_clearance_geometry() {
    let cl = "CLEARP/XYPLAN,60\nTOOL PATH/A,TOOL,T\nSPINDL/RPM,3000,CLW\nRAPID\n\
        GOTO/33.505961,13.571173,70,0.556670,0.321394,0.766044\nFEDRAT/MMPM,500\nGOTO/28.505961,22.231427,61.336562\n\
        TOOL PATH/B,TOOL,T\nRAPID\nGOTO/33.505961,13.571173,61.336562,0.556670,0.321394,0.766044\nFEDRAT/MMPM,500\n\
        GOTO/10.125804,0.072633,29.162696\n";
    Job { controls: &["fanuc"], keys: "", cl, edit: Some(["H1 Z70.", "H1 Z120."]) }.is_right::<Dmu70e>();
}
