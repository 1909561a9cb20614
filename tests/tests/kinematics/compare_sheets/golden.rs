//! The sheets of the papers' machines as the binaries print them, and the files that they write.

use std::fs;
use std::path::PathBuf;

use tests::binaries::{binary, example_config, workspace};
use tests::by_name;
use tests::environment;

use super::printed::WIDTH;

/// Machines and the control of their example configuration.
const MACHINES: [(&str, &str); 4] =
    [("spinner-u5-620", "siemens"), ("dmu-70e", "heidenhain"), ("lola-xoyzba", "linuxcnc"), ("multiprodesk", "fanuc")];

/// Standard output and exit status of a sheet; of a refusal its message.
fn run(machine: &str, arguments: &[&str]) -> (String, i32) {
    let output =
        binary(machine).current_dir(workspace()).arg("kinematics").args(arguments).output().expect("the binary runs");
    let status = output.status.code().expect("an exit status");
    let text = if status == 0 { output.stdout } else { output.stderr };
    (String::from_utf8(text).expect("UTF-8"), status)
}

fn golden(machine: &str, control: &str) -> PathBuf {
    workspace().join(format!("tests/data/kinematics/{machine}.{control}.txt"))
}

#[test]
fn sheets_are_as_before() {
    let bless = environment::blesses();
    let mut differences = Vec::new();
    for (machine, set_up) in MACHINES {
        let set_up = example_config(machine, set_up);
        for control in by_name::controls_with_tip_control() {
            let (text, status) = run(machine, &[&format!("--{control}"), "--config", &set_up]);
            assert_eq!(status, if text.starts_with("error: ") { 2 } else { 0 }, "{machine} {control}: {text}");
            let path = golden(machine, control);
            if bless {
                fs::create_dir_all(path.parent().expect("a folder")).expect("the folder of the sheets");
                fs::write(&path, &text).expect("the golden sheet is written");
            }
            let before = fs::read_to_string(&path).unwrap_or_default();
            if before != text {
                let line = before.lines().zip(text.lines()).take_while(|(before, now)| before == now).count();
                let show = |text: &str| text.lines().nth(line).unwrap_or("nothing").to_owned();
                differences.push(format!(
                    "{}:{}: expected `{}`, found `{}`",
                    path.display(),
                    line + 1,
                    show(&before),
                    show(&text)
                ));
            }
        }
    }
    assert!(differences.is_empty(), "read the changes, then PP_BLESS=1:\n{}", differences.join("\n"));
}

#[test]
fn lines_fit_a_page() {
    for (machine, _) in MACHINES {
        for control in by_name::controls_with_tip_control() {
            let (text, status) = run(machine, &[&format!("--{control}")]);
            for line in text.lines().filter(|_| status == 0) {
                assert!(line.chars().count() <= WIDTH && line.trim_end() == line, "{machine} {control}: {line}");
            }
        }
    }
}

#[test]
fn a_sheet_that_was_filled_in_is_not_replaced() {
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let path = folder.path().join("sheet.txt");
    let name = path.to_string_lossy().into_owned();
    let (printed, status) = run("spinner-u5-620", &["--siemens"]);
    assert_eq!(status, 0);
    assert_eq!(run("spinner-u5-620", &["--siemens", "-o", &name]), (String::new(), 0));
    assert_eq!(fs::read_to_string(&path).expect("the sheet"), printed);
    fs::write(&path, "filled in").expect("a file");
    let (message, status) = run("spinner-u5-620", &["--siemens", "-o", &name]);
    assert_eq!(status, 2);
    assert!(message.contains("exists, and may hold values that were entered at the machine"), "{message}");
    assert_eq!(fs::read_to_string(&path).expect("the sheet"), "filled in");
    // A refusal leaves no file.
    let refused = folder.path().join("refused.txt");
    let (message, status) = run("multiprodesk", &["--siemens", "-o", &refused.to_string_lossy()]);
    assert_eq!(status, 2);
    assert!(message.contains("Y counts against ISO 841") && !refused.exists(), "{message}");
}
