//! The explanations that the machines print: compared word for word, and compiled where LaTeX is installed.
//!
//! `PP_BLESS=1 cargo test --workspace --test commands explain::` rewrites the texts; read every changed line against
//! the papers before it is committed.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use tests::binaries::{binary, workspace};
use tests::environment;

const MACHINES: &[&str] = &["dmu-70e", "lola-xoyzba", "multiprodesk", "spinner-u5-620"];

fn explained(machine: &str, options: &[&str]) -> String {
    let output = binary(machine).arg("explain").args(options).output().expect("the binary runs");
    assert!(output.status.success(), "{machine}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("an explanation is UTF-8")
}

fn golden(machine: &str, extension: &str) -> PathBuf {
    workspace().join("tests/data/explain").join(machine).with_extension(extension)
}

/// First line in which the golden text and the printed one differ.
fn difference(path: &Path, now: &str) -> Option<String> {
    let golden = fs::read_to_string(path).unwrap_or_default();
    if golden == now {
        return None;
    }
    let line = golden.lines().zip(now.lines()).take_while(|(golden, now)| golden == now).count();
    let show = |text: &str| text.lines().nth(line).unwrap_or("nothing").to_owned();
    Some(format!("{}:{}: expected `{}`, found `{}`", path.display(), line + 1, show(&golden), show(now)))
}

#[test]
fn every_machine_is_explained_as_before() {
    let bless = environment::blesses();
    let mut differences = Vec::new();
    for machine in MACHINES {
        for (extension, options) in [("txt", &[] as &[&str]), ("tex", &["--latex"])] {
            let (path, now) = (golden(machine, extension), explained(machine, options));
            if bless {
                fs::create_dir_all(path.parent().expect("a folder")).expect("the folder of the texts");
                fs::write(&path, &now).expect("the golden text is written");
            }
            differences.extend(difference(&path, &now));
        }
    }
    assert!(differences.is_empty(), "read the changes, then PP_BLESS=1:\n{}", differences.join("\n"));
}

#[test]
fn lines_fit_a_narrow_page() {
    for machine in MACHINES {
        for line in explained(machine, &[]).lines() {
            assert!(line.chars().count() <= 100, "{machine}: {line}");
        }
    }
}

/// The equations of the papers: My et al. (3) to (9), Maletić and Živanović (8) to (14) and (12) to (18).
#[test]
fn the_equations_of_the_papers_are_printed() {
    for (machine, formulas) in [
        (
            "spinner-u5-620",
            &[
                "X = (x cos C + y sin C) cos B - (z - d) sin B",
                "Y = -x sin C + y cos C",
                "Z = (x cos C + y sin C) sin B + (z - d) cos B + d",
                "C = atan2(j, i)",
            ] as &[&str],
        ),
        (
            "lola-xoyzba",
            &[
                "i = sin B cos A",
                "j = -sin A",
                "B = atan2(i, k)",
                "X = x + gauge sin B cos A",
                "Y = y - gauge sin A",
                "Z = z - gauge + gauge cos A cos B",
            ],
        ),
        ("dmu-70e", &["k = (1 + cos B)/2", "r = √(k (1 - k))", "B = atan2(2 r, 2 k - 1)"]),
        ("multiprodesk", &["i = 0", "j = sin A", "k = cos A", "A = atan2(j, k)"]),
    ] {
        let text = explained(machine, &[]);
        for formula in formulas {
            assert!(text.lines().any(|line| line.trim() == *formula), "{machine}: {formula}\n{text}");
        }
    }
}

#[test]
fn the_codes_of_each_control_are_explained_with_their_source() {
    for (control, rows) in [
        ("linuxcnc", &["G33.1 ", "(abort,"][..]),
        ("fanuc", &["G43.4 ", "M29 "]),
        ("haas", &["G187 ", "G268 "]),
        ("siemens", &["TRAORI ", "CYCLE83: "]),
        ("heidenhain", &["PLANE SPATIAL ", "CYCL DEF 205: "]),
    ] {
        let text = explained("spinner-u5-620", &["--codes", "--control", control]);
        assert!(text.starts_with("spelling "), "{control}: {text}");
        for row in rows {
            assert!(text.lines().any(|line| line.starts_with(row)), "{control}: {row}\n{text}");
        }
        let source = text.find("source").expect("a column");
        let table = text.lines().take_while(|line| !line.is_empty());
        assert!(table.filter(|line| line.is_ascii()).all(|line| line.len() > source), "{control}: {text}");
    }
}

#[test]
fn latex_compiles_where_it_is_installed() {
    let installed = Command::new("pdflatex").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !installed.is_ok_and(|status| status.success()) {
        return;
    }
    let folder = env::temp_dir().join(format!("explain-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    for machine in MACHINES {
        let file = folder.join(machine).with_extension("tex");
        fs::write(&file, explained(machine, &["--latex"])).expect("the document is written");
        let output = Command::new("pdflatex")
            .current_dir(&folder)
            .args(["-interaction=nonstopmode", "-halt-on-error"])
            .arg(&file)
            .output()
            .expect("pdflatex runs");
        let log = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{machine}:\n{log}");
        assert!(!log.contains("Overfull"), "{machine}:\n{log}");
    }
    fs::remove_dir_all(&folder).expect("the folder is removed");
}
