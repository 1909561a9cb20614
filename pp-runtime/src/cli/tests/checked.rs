//! Tests of the check that runs while a program is posted, and of `check`.

use super::*;
use crate::kinematics::machines::Cb;

/// CL data of a small part.
const PART: &str = "UNITS/MM\nTOOL PATH/FACE,TOOL,MILL\nLOADTL/1\nSPINDL/RPM,3000,CLW\nCOOLNT/ON\nFEDRAT/MMPM,500\n\
    RAPID\nGOTO/0,0,50,0,0,1\nRAPID\nGOTO/0,0,5\nGOTO/0,0,-1\nGOTO/40,0,-1\nGOTO/40,20,-1\nRAPID\nGOTO/40,20,50\nFINI\n";

/// Posts with the real function and changes the program while it is written.
fn tampered(
    from: &'static str,
    to: &'static str,
) -> impl Fn(&Job<'_>, &mut ClSource, &mut ProgramSink<'_>, Option<&mut dyn LineMap>) -> Result<Report, PostError> {
    move |job, source, sink, _| {
        let mut program = Vec::new();
        let report = crate::post::post::<Cb>(job, source, &mut program)?;
        let text = String::from_utf8(program).expect("ASCII").replace(from, to);
        sink.write_all(text.as_bytes()).map_err(PostError::Output)?;
        Ok(report)
    }
}

/// Posts a part without `--no-check`, to a file.
fn posted(shop: &Shop, post: PostFn<'_>) -> Outcome {
    shop.write("part.cls", PART);
    run_on::<Cb>(&["post", &shop.arg("part.cls"), "-o", &shop.arg("part.ngc")], b"", post)
}

#[test]
fn a_program_that_passes_its_check_is_reported_as_checked() {
    let shop = Shop::new();
    let outcome = posted(&shop, &tampered("", ""));
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert!(
        outcome.errors.contains("\nchecked: ") && outcome.errors.contains(" 0 points outside limits\n"),
        "{}",
        outcome.errors
    );
    assert!(shop.text("part.ngc").ends_with("M2\n"));
}

#[test]
fn a_program_that_does_not_pass_its_check_is_rejected() {
    for (from, to, what) in [
        ("X40", "X41", "matches no motion"),
        ("M3", "M4", "wrong direction"),
        ("F500", "F5000", "F is 5000"),
        ("M8\n", "", "coolant"),
        ("G53 G0 Z0\nG43", "G43", "without an approach before it"),
    ] {
        let shop = Shop::new();
        let outcome = posted(&shop, &tampered(from, to));
        assert_eq!(outcome.status, Status::Rejected, "{from} became {to}: {}", outcome.errors);
        assert!(outcome.errors.contains(what), "{from} became {to}: {}", outcome.errors);
        assert_eq!(shop.names(), ["part.cls", "part.ngc.rejected"]);
        let rejected = shop.text("part.ngc.rejected");
        assert!(
            rejected.starts_with("(REJECTED ") && rejected.ends_with("(the program ends here: do not run it)\n"),
            "{rejected}"
        );
        assert!(!rejected.contains("\nM2\n"), "{rejected}");
    }
}

#[test]
fn a_rejected_program_on_standard_output_has_no_end_code() {
    let outcome = run_on::<Cb>(&["post", "-"], PART.as_bytes(), &tampered("X40", "X41"));
    assert_eq!(outcome.status, Status::Rejected);
    assert!(outcome.output.ends_with("(the program ends here: do not run it)\n"), "{}", outcome.output);
    assert!(!outcome.output.contains("\nM2\n"));
}

#[test]
fn check_names_both_lines_and_has_its_status() {
    let shop = Shop::new();
    assert_eq!(posted(&shop, &tampered("", "")).status, Status::Done);
    let check = |extra: &[&str]| {
        let (input, program) = (shop.arg("part.cls"), shop.arg("part.ngc"));
        let mut args = vec!["check", &input, &program];
        args.extend(extra);
        run_on::<Cb>(&args, b"", &never)
    };
    assert_eq!(check(&[]).status, Status::Done);
    shop.write("part.ngc", &shop.text("part.ngc").replace("X40", "X41"));
    let outcome = check(&[]);
    assert_eq!(outcome.status, Status::Rejected);
    assert!(
        outcome.errors.contains("part.cls:12:1: error: ") && outcome.errors.contains(" of the program is `"),
        "{}",
        outcome.errors
    );
    assert!(outcome.errors.contains("GOTO/40,0,-1"), "{}", outcome.errors);
    let figures: serde_json::Value = serde_json::from_str(&check(&["--json"]).output).expect("an object");
    assert_eq!(figures["passed"], serde_json::Value::Bool(false));
    assert_eq!(
        run_with(&["check", &shop.arg("part.cls"), &shop.arg("nowhere.ngc")], b"", &never).status,
        Status::NotRun
    );
}
