//! 3+2 on Haas: the zero of the words follows the table (G254), or the control tilts a plane (G268).

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::Haas;
use pp_runtime::kinematics::Machine;
use tests::further::HeadTable;
use tests::posting::{bare, findings, posted};

/// Two faces, tilted by 30 degrees in two directions, the second with a hole.
const FACES: &str = "UNITS/MM
TOOL PATH/FACES,TOOL,D8
LOADTL/1,ADJUST,1
SPINDL/RPM,3000,CLW
RAPID
GOTO/40,0,69.2820323,0.5,0,0.8660254
FEDRAT/MMPM,500
GOTO/10,0,17.3205081
GOTO/10,8,17.3205081
CIRCLE/10,0,17.3205081,0.5,0,0.8660254,8
GOTO/10,-8,17.3205081
RAPID
GOTO/40,-8,69.2820323
END-OF-PATH
TOOL PATH/HOLE,TOOL,D8
RAPID
GOTO/0,40,69.2820323,0,0.5,0.8660254
CYCLE/DRILL,FEDTO,-5,MMPM,100,CLEAR,2
GOTO/0,10,17.3205081
CYCLE/OFF
RAPID
GOTO/0,40,69.2820323
END-OF-PATH
FINI
";

const TOOLS: &str = "retract.distance = 80\ntools = { 1 = { length = 120.0, diameter = 8.0 } }\n";

fn config<M: Machine>(keys: &str) -> Result<Config, String> {
    let text = format!("mode = \"plane\"\npart_origin = [0.0, 0.0, 100.0]\n{keys}{TOOLS}");
    let config = starting_point(&Haas).read_over(&M::default(), &text).map_err(|faults| format!("{faults:?}"))?;
    let unfit = config.unfit(&M::default(), &Haas);
    if unfit.is_empty() { Ok(config) } else { Err(unfit.join("\n")) }
}

fn program<M: Machine>(keys: &str) -> String {
    posted::<M>(&config::<M>(keys).expect("it suits"), &Haas, FACES)
}

/// Blocks with one of the two codes.
fn codes(program: &str) -> [usize; 2] {
    ["G254", "G268"].map(|code| bare(program).iter().filter(|block| block.starts_with(code)).count())
}

#[test]
fn the_zero_follows_the_table_where_control_and_machine_have_it() {
    for (keys, expected) in [
        ("", [2, 0]),
        ("control.functions = [\"planes\", \"dynamic_offset\"]\n", [2, 0]),
        ("control.functions = [\"dynamic_offset\"]\n", [2, 0]),
        ("control.functions = [\"planes\"]\n", [0, 2]),
        ("control.plane_by = \"dynamic_offset\"\n", [2, 0]),
        ("control.plane_by = \"tilted_plane\"\n", [0, 2]),
        ("tcp_confirmed = true\nrotary_offset.C = 12.5\n", [0, 2]),
    ] {
        let program = program::<SpinnerU5620>(keys);
        assert_eq!(codes(&program), expected, "{keys}\n{program}");
    }
    // The head of this machine rotates the tool, too.
    let program = program::<HeadTable>("");
    assert_eq!(codes(&program), [0, 2], "{program}");
}

#[test]
fn a_frame_that_the_control_cannot_have_is_refused() {
    for (keys, reason) in [
        ("control = { functions = [\"planes\"], plane_by = \"dynamic_offset\" }\n", "not among `control.functions`"),
        ("control = { functions = [\"tip_control\"] }\n", "has no tilted work plane"),
        (
            "tcp_confirmed = true\nrotary_offset.C = 12.5\ncontrol.plane_by = \"dynamic_offset\"\n",
            "`rotary_offset.C` is another value",
        ),
    ] {
        let refused = config::<SpinnerU5620>(keys).expect_err(keys);
        assert!(refused.contains(reason), "{keys}: {refused}");
    }
    let refused = config::<HeadTable>("control.plane_by = \"dynamic_offset\"\n").expect_err("a head");
    assert!(refused.contains("does not allow for a rotary axis in the head"), "{refused}");
}

#[test]
fn it_is_in_force_for_its_operation_alone() {
    let program = program::<SpinnerU5620>("");
    let blocks = bare(&program);
    let at = blocks.iter().position(|block| *block == "G254").expect("it is on");
    assert!(blocks[at - 1].starts_with("G00 B"), "{program}");
    assert!(blocks[at + 1].starts_with("G00 X") && !blocks[at + 1].contains('Z'), "{program}");
    assert!(blocks[at + 2].starts_with("G43 H1 Z"), "{program}");
    let end = at + blocks[at..].iter().position(|block| *block == "G255").expect("it is off");
    assert_eq!(blocks[end - 1], "G49 G53 G00 Z0.", "{program}");
    let config = config::<SpinnerU5620>("").expect("it suits");
    let (rotary, off) = (blocks[at - 1], blocks[end - 1]);
    let across = blocks[at + 1];
    let in_rotation = "a rotary axis moves while the dynamic work offset is active";
    for (was, is, text) in [
        // It begins before the rotation, after X and Y, or not at all.
        (format!("{rotary}\nG254\n"), format!("G254\n{rotary}\n"), in_rotation),
        (format!("G254\n{across}\n"), format!("{across}\nG254\n"), "no plane is active"),
        ("G254\n".to_owned(), String::new(), "no plane is active"),
        // It ends at the part, or before a motion in it.
        (format!("{off}\nG255\n"), format!("G255\n{off}\n"), "is switched off before the machine has retracted"),
        ("G254\n".to_owned(), "G254\nG255\nG254\n".to_owned(), "ends before a motion in it"),
        // An axis rotates while it is on.
        ("G254\n".to_owned(), "G254\nG00 C90.\n".to_owned(), in_rotation),
        ("G254\n".to_owned(), "G254\nG53 G00 C0.\n".to_owned(), in_rotation),
        (format!("{off}\nG255\n"), format!("{off}\nG53 G00 C0.\nG255\n"), in_rotation),
    ] {
        let edited = program.replacen(&was, &is, 1);
        assert_ne!(edited, program, "{was} is there");
        let found = findings::<SpinnerU5620>(&config, &Haas, FACES, &edited);
        assert!(found.iter().any(|found| found.contains(text)), "{was:?} as {is:?}: {found:?}\n{edited}");
    }
    let never_off = program.replace("G255\n", "");
    assert!(!findings::<SpinnerU5620>(&config, &Haas, FACES, &never_off).is_empty(), "{never_off}");
}

#[test]
fn it_is_not_in_force_in_a_tilted_plane() {
    let keys = "control.plane_by = \"tilted_plane\"\n";
    let (program, config) = (program::<SpinnerU5620>(keys), config::<SpinnerU5620>(keys).expect("it suits"));
    for (was, is) in [("G253\n", "G253\nG254\n"), ("G253\n", "G254\n")] {
        let edited = program.replacen(was, is, 1);
        let found = findings::<SpinnerU5620>(&config, &Haas, FACES, &edited);
        assert!(found.iter().any(|found| found.contains("in a tilted plane")), "{found:?}\n{edited}");
    }
}
