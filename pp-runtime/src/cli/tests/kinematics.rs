//! `kinematics`: files, values of the set-up, and refusals.

use super::*;

crate::machine! {
    /// Both rotary axes in the table.
    struct Trunnion;
    chain: C A | X Y Z;
    d = { C: (0, 0, 0), A: (0, 0, centre_height) };
    dims = { centre_height: 60.5, slant: 30 deg };
    axes = { A: Rz(slant) * X };
    limits = { A: -120..30, X: -250..250 };
    speeds = { X: 12000, A: 1800 };
}

crate::machine! {
    /// Its quill takes the place of Z.
    struct Quill;
    chain: C B | X Y W;
    d = (0, 0, 50);
}

crate::machine! {
    /// Its tool is horizontal, and no axis moves along it.
    struct Oblique;
    chain: C B | X Y Z;
    tool_axis = (0.6, 0, 0.8);
    d = (0, 0, 50);
}

#[test]
fn a_header_is_printed_or_written_with_the_name_of_its_file_as_prefix() {
    let shop = Shop::new();
    let printed = run_on::<Trunnion>(&["kinematics", "--c"], b"", &never);
    assert_eq!((printed.status, printed.errors.as_str()), (Status::Done, ""));
    assert!(printed.output.contains("typedef struct {") && printed.output.contains("} trunnion_machine;"));
    let written = run_on::<Trunnion>(&["kinematics", "--c", "-o", &shop.arg("my-machine.h")], b"", &never);
    assert_eq!((written.status, written.output.as_str()), (Status::Done, ""));
    assert_eq!(
        shop.text("my-machine.h"),
        printed.output.replace("trunnion", "my_machine").replace("TRUNNION", "MY_MACHINE")
    );
    let refused = run_on::<Trunnion>(&["kinematics", "--c", "-o", &shop.arg("5axis.h")], b"", &never);
    assert_eq!(refused.status, Status::NotRun);
    assert!(refused.errors.contains("must begin with a letter"), "{}", refused.errors);
    let refused = run_with(&["kinematics", "--c"], b"", &never);
    assert!(refused.errors.contains("was not declared with `machine!`"), "{}", refused.errors);
}

#[test]
fn a_module_has_the_values_of_the_set_up_and_replaces_nothing() {
    let shop = Shop::new();
    shop.write(
        "set-up.toml",
        "units = \"mm\"\npart_origin = [10.0, 20.0, 30.0]\nmachine_zero = { X = -5.0, Y = 6.0, Z = -400.0 }\n\
         [dimensions]\ncentre_height = 61.25\n[speeds]\nA = 3600\n[tools.3]\nlength = 120.5\ndiameter = 10.0\n",
    );
    let folder = shop.arg("linuxcnc");
    let args = ["kinematics", "--linuxcnc", "-o", &folder, "--config", &shop.arg("set-up.toml")];
    let run = run_on::<Trunnion>(&args, b"", &never);
    assert_eq!(run.status, Status::Done, "{}", run.errors);
    let hal = shop.text("linuxcnc/trunnion.hal");
    for line in [
        "setp trunnion-kins.part-origin-y 20",
        "setp trunnion-kins.zero-z -400",
        "setp trunnion-kins.centre-height 61.25",
        "setp trunnion-kins.slant 30",
    ] {
        assert!(hal.lines().any(|known| known == line), "{line} in {hal}");
    }
    let ini = shop.text("linuxcnc/trunnion.ini");
    assert!(ini.contains("MIN_LIMIT = -120\nMAX_LIMIT = 30\n") && ini.contains("MAX_VELOCITY = 60\n"), "{ini}");
    assert_eq!(shop.text("linuxcnc/tool.tbl"), "T3 P3 Z120.5 D10\n");
    // A file that may hold measured values stays, and nothing else is written.
    shop.write("linuxcnc/trunnion.hal", "measured");
    fs::remove_file(shop.path("linuxcnc/trunnion.ini")).expect("it was written");
    let again = run_on::<Trunnion>(&args, b"", &never);
    assert_eq!(again.status, Status::NotRun);
    assert!(again.errors.contains("exists, and may hold values that were measured"), "{}", again.errors);
    assert_eq!(shop.text("linuxcnc/trunnion.hal"), "measured");
    assert!(!shop.path("linuxcnc/trunnion.ini").exists());
}

#[test]
fn what_the_control_cannot_express_is_refused_with_the_reason() {
    let shop = Shop::new();
    let refusal = |outcome: Outcome| {
        assert_eq!((outcome.status, outcome.output.as_str()), (Status::NotRun, ""));
        outcome.errors
    };
    let args = ["kinematics", "--linuxcnc", "-o", &shop.arg("out")];
    let quill = refusal(run_on::<Quill>(&args, b"", &never));
    assert!(quill.contains("Quill has no Z that is solved for"), "{quill}");
    let oblique = refusal(run_on::<Oblique>(&args, b"", &never));
    assert!(oblique.contains("Oblique has no axis X, Y or Z whose positive direction is that"), "{oblique}");
    assert!(!shop.path("out").exists());
    let none = refusal(run_on::<Trunnion>(&["kinematics"], b"", &never));
    assert!(none.contains("--c") && none.contains("--linuxcnc"), "{none}");
    let streamed = refusal(run_on::<Trunnion>(&["kinematics", "--linuxcnc", "-o", "-"], b"", &never));
    assert!(streamed.contains("give their folder"), "{streamed}");
}
