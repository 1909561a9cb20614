//! `view` and `report`: the data of the page compared with the check's reader, with the oracle's matrices and with the
//! CL data; text from outside, edited programs, sizes, and the set-up sheets.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use approx::abs_diff_eq;
use machine_library::XyzacTrt;
use pp_runtime::cli::{Status, Streams, run_with};
use pp_runtime::config::Config;
use pp_runtime::control::LinuxCnc;
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::nalgebra::{Matrix3, Vector3};
use serde_json::Value;
use tests::binaries::{SAMPLES, binary, example_config, golden_programs, workspace};
use tests::environment;
use tests::golden::Golden;
use tests::oracle::{Oracle, angle_between};
use tests::page::{Page, number};
use tests::with_machine;

/// Largest distance between two tips that are the same: steps of 1e-5 mm and 1e-5 degrees, 500 mm from a centre line.
const SAME_TIP_MM: f64 = 4e-4;

/// The same for tool axes, rad: in tilted planes the rotary axes are rounded to a thousandth of a degree.
const SAME_AXIS_RAD: f64 = 3e-5;

/// Largest distance of a posted tip from the point of its record, mm: rounded words.
const RECORD_MM: f64 = 2e-3;

/// Runs a command in the workspace; its output file is `folder/name`.
fn run(mut command: Command, args: &[&str], output: &Path) -> Output {
    command.current_dir(workspace()).args(args).arg("-o").arg(output);
    command.output().expect("the binary runs")
}

fn read(output: &Output, path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)))
}

/// The page that a command writes with status 0.
fn page(command: Command, args: &[&str]) -> Page {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("page.html");
    let output = run(command, args, &path);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    Page::decoded(&read(&output, &path))
}

fn sample((machine, control, part): (&str, &str, &str)) -> Page {
    let (cl, config) = (format!("examples/cl/{part}"), example_config(machine, control));
    page(binary(machine), &["view", &cl, "--control", control, "--config", &config])
}

fn inclined() -> Page {
    page(Command::new(env!("CARGO_BIN_EXE_inclined")), &["view", "examples/cl/convex.cls"])
}

/// The machine of the head leads the tool to tip and tool axis of every point.
fn assert_chain(name: &str, page: &Page) {
    for point in 0..page.points() {
        let ((tip, axis), line) = (page.multiplied(point), page.line(point));
        let (off_mm, off_rad) = ((tip - page.tip(point)).norm(), angle_between(&axis, &page.tool_axis(point)));
        assert!(off_mm < SAME_TIP_MM && off_rad < SAME_AXIS_RAD, "{name}, line {line}: {off_mm} mm, {off_rad} rad");
    }
}

/// Blocks that end the motion of a record end on its point; number of them.
fn assert_records(name: &str, page: &Page) -> usize {
    let recorded = (0..page.points()).filter_map(|point| Some((point, page.record_of(point)?)));
    let compared = recorded.map(|(point, record)| {
        let off_mm = (page.tip(point) - record).norm();
        assert!(off_mm < RECORD_MM, "{name}, CL line {}: {off_mm} mm off", page.at("cl_line", point));
    });
    compared.count()
}

#[test]
fn the_machine_of_the_page_leads_the_tool_to_the_points_of_the_cl_data() {
    let mut compared = 0;
    for given in SAMPLES {
        let page = sample(given);
        assert_chain(given.0, &page);
        compared += assert_records(given.0, &page);
    }
    let page = inclined();
    assert_chain("inclined", &page);
    compared += assert_records("inclined", &page);
    assert!(compared > 2500, "{compared}");
}

/// Values of the page at the end of each line are those of the check's reader; number of lines.
fn agrees<M: Machine>(golden: &Golden) -> usize {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| -> PathBuf {
        let path = folder.path().join(name);
        fs::write(&path, text).expect("it can be written");
        path
    };
    let [cl, program, config] = [("part.cls", &golden.cl), ("part.nc", &golden.program), ("part.toml", &golden.keys)]
        .map(|(name, text)| write(name, text));
    let mut args: Vec<String> =
        ["view", "--control", golden.control.spellings().name, "--mode", golden.mode.name()].map(str::to_owned).into();
    args.extend(["--config".to_owned(), config.display().to_string()]);
    args.extend(golden.last_operation().into_iter().flat_map(|last| ["--ops".to_owned(), format!("1..{last}")]));
    args.extend([&cl, &program].map(|path| path.display().to_string()));
    let page = page(binary(&golden.machine), &args.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(page.program, golden.program);
    assert_chain(&golden.name, &page);
    let ends: BTreeMap<u64, usize> = (0..page.points()).map(|point| (page.line(point), point)).collect();
    let mut compared = 0;
    golden.observed::<M>(&golden.program, |executed| {
        let legs = executed.legs();
        let Some(values) = legs.last().and_then(|leg| leg.axis_values(1.0)) else { return };
        let line = executed.block.line;
        let Some(point) = ends.get(&line) else { return };
        for ((shown, value), axis) in page.axes(*point).iter().zip(values).zip(M::AXES) {
            let value = if axis.kind == AxisKind::Rotary { value.to_degrees() } else { value };
            let same = abs_diff_eq!(*shown, value, epsilon = 1e-4);
            assert!(same, "{}, line {line}, {}: {shown} for {value}", golden.name, axis.letter);
        }
        compared += 1;
    });
    compared
}

#[test]
fn axis_values_of_the_page_are_those_of_the_checks_reader_in_every_mode_of_every_control() {
    let (mut programs, mut compared) = (0, 0);
    for path in golden_programs() {
        let golden = &Golden::read(&path);
        let count = with_machine!(&*golden.machine, agrees(golden));
        assert!(count > 5, "{}: {count} blocks", golden.name);
        (programs, compared) = (programs + 1, compared + count);
    }
    assert!(programs >= 110 && compared > 7_000, "{programs} programs, {compared} blocks");
}

#[test]
fn text_from_outside_is_text_in_the_page() {
    let evil = "</script><img src=x onerror=alert(1)>";
    let folder = tempfile::tempdir().expect("a folder");
    let [cl, config, html, sheet] = ["a.cls", "a.toml", "a.html", "b.html"].map(|name| folder.path().join(name));
    let record = format!(
        "PARTNO {evil}\nUNITS/MM\nTOOL PATH/{evil},TOOL,A\nPPRINT {evil}\nLOADTL/1,LENGTH,100\nSPINDL/RPM,1000,CLW\n\
         FEDRAT/100\nGOTO/0,0,0,0,0,1\nGOTO/10,0,0\nEND-OF-PATH\n"
    );
    fs::write(&cl, record).expect("it can be written");
    fs::write(&config, format!("[tools]\n1 = {{ name = \"{evil}\" }}\n")).expect("it can be written");
    let [cl, config] = [&cl, &config].map(|path| path.display().to_string());
    for (command, path) in [("view", &html), ("report", &sheet)] {
        let output = run(binary("dmu-70e"), &[command, &cl, "--config", &config], path);
        let text = read(&output, path);
        let without_script = text.rsplit_once("<script>").map_or(&*text, |(before, _)| before);
        assert!(!without_script.contains("<img") && text.contains("&lt;img src=x onerror=alert(1)&gt;"), "{command}");
    }
    let [markdown, json] = ["b.md", "b.json"].map(|name| {
        let path = folder.path().join(name);
        read(&run(binary("dmu-70e"), &["report", &cl, "--config", &config], &path), &path)
    });
    let literal = evil.replace('<', "\\<").replace('>', "\\>");
    assert!(markdown.contains(&literal) && !markdown.replace("\\<", "").contains('<'), "{markdown}");
    let sheet: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(sheet["tools"][0]["name"], evil);
    let text = fs::read_to_string(&html).expect("the page");
    // Five elements and the style: the text has opened and closed none.
    assert_eq!(text.matches("<script").count(), 5);
    assert_eq!(text.matches("</script").count(), 5);
    let page = Page::decoded(&text);
    assert_eq!(page.head["tools"][0]["name"], evil);
    assert!(
        page.head["operations"][0]["name"].as_str().is_some_and(|name| name.contains(evil)),
        "{}",
        page.head["operations"]
    );
}

#[test]
fn an_edited_program_shows_its_edits_and_its_findings() {
    let folder = tempfile::tempdir().expect("a folder");
    let [program, html] = ["part.ngc", "page.html"].map(|name| folder.path().join(name));
    let (cl, config) = ("examples/cl/convex.cls", example_config("lola-xoyzba", "linuxcnc"));
    let set_up = [cl, "--config", &config];
    assert!(run(binary("lola-xoyzba"), &[&["post"], &set_up[..]].concat(), &program).status.success());
    let posted = fs::read_to_string(&program).expect("a program");
    // The sign of one word, in the middle of a cut.
    let (line, wrong) = posted
        .lines()
        .enumerate()
        .skip(200)
        .find_map(|(index, line)| line.contains(" B-").then(|| (index as u64 + 1, line.replace(" B-", " B"))))
        .expect("a negative B");
    let edited: String = posted
        .lines()
        .enumerate()
        .map(|(index, text)| if index as u64 + 1 == line { format!("{wrong}\n") } else { format!("{text}\n") })
        .collect();
    fs::write(&program, &edited).expect("it can be written");
    let given = program.display().to_string();
    let output = run(binary("lola-xoyzba"), &["view", cl, &given, "--config", &config], &html);
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    let page = Page::decoded(&read(&output, &html));
    assert_eq!(page.program, edited);
    let found = page.head["findings"].as_array().expect("a list");
    let found =
        found.iter().find(|found| found["line"] == line).unwrap_or_else(|| panic!("{:?}", page.head["findings"]));
    let point = found["point"].as_u64().expect("a point") as usize;
    assert_eq!(page.line(point), line);
    let before = (0..point).rfind(|before| page.line(*before) < line).expect("a point before");
    assert!(page.at("axis.B", point) > 0.0 && page.at("axis.B", before) < 0.0, "{}", page.at("axis.B", point));
    // Lines that were not edited keep their reasons; the edited one has none.
    for point in 0..page.points() {
        assert_eq!(page.reason(point).is_none(), page.line(point) == line, "point {point}");
    }
}

/// Largest page of 100 000 blocks, bytes.
const LARGEST_PAGE: u64 = 10_000_000;

#[test]
fn a_page_of_100_000_blocks_is_below_10_mb() {
    let folder = tempfile::tempdir().expect("a folder");
    let [cl, html] = ["blade.cls", "page.html"].map(|name| folder.path().join(name));
    let mut text =
        "TOOL PATH/BLADE,TOOL,BALL_6\nTLDATA/MILL,6.0000,3.0000,75.0000,0.0000,0.0000\nMSYS/0,0,0,1,0,0,0,1,0\n\
         LOAD/TOOL,1\nSPINDL/RPM,12000,CLW\nFEDRAT/MMPM,1800\n"
            .to_owned();
    for point in 0..100_000 {
        let turn = 0.004 * f64::from(point);
        let (swing, tilt) = (2.4 * (0.21 * turn).sin(), 0.55 + 0.25 * (0.37 * turn).sin());
        let [x, y, z] = [48.0 * turn.cos(), 36.0 * (1.3 * turn).sin(), 20.0 + 9.0 * (0.7 * turn).sin()];
        let [i, j, k] = [tilt.sin() * swing.cos(), tilt.sin() * swing.sin(), tilt.cos()];
        writeln!(text, "GOTO/{x:.4},{y:.4},{z:.4},{i:.7},{j:.7},{k:.7}").expect("memory");
    }
    text += "END-OF-PATH\n";
    fs::write(&cl, text).expect("it can be written");
    let output = run(binary("spinner-u5-620"), &["view", &cl.display().to_string(), "--units", "mm"], &html);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let bytes = fs::metadata(&html).expect("a page").len();
    assert!(bytes < LARGEST_PAGE, "{bytes} bytes");
    assert!(Page::decoded(&read(&output, &html)).points() > 100_000);
}

/// Set-up sheets that are kept: machine, control, CL file, configuration.
const SHEETS: [(&str, &str, &str, &str); 2] = [
    ("dmu-70e", "heidenhain", "examples/cl/two_tools.cls", "examples/config/dmu-70e-heidenhain.toml"),
    ("spinner-u5-620", "fanuc", "tests/data/mixed/mixed.cls", "tests/data/mixed/mixed.toml"),
];

#[test]
fn set_up_sheets_are_those_that_were_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut differ = Vec::new();
    for (machine, control, cl, config) in SHEETS {
        for form in ["html", "md", "json"] {
            let name = format!("{machine}.{control}.{form}");
            let sheet = folder.path().join(&name);
            let output =
                run(binary(machine), &["report", cl, "--control", control, "--config", config, "--jog"], &sheet);
            assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
            let (kept, sheet) = (workspace().join("tests/data/sheets").join(&name), read(&output, &sheet));
            if environment::blesses() {
                fs::write(&kept, sheet).expect("it can be written");
            } else if fs::read_to_string(&kept).ok().as_ref() != Some(&sheet) {
                differ.push(name);
            }
        }
    }
    assert!(differ.is_empty(), "{differ:?} differ: PP_BLESS=1 rewrites them; read them before they are committed");
}

#[test]
fn a_sheet_has_a_page_for_each_set_up_with_its_own_tools_and_operations() {
    let sheet = fs::read_to_string(workspace().join("tests/data/sheets/spinner-u5-620.fanuc.html")).expect("a sheet");
    let pages: Vec<&str> = sheet.split("<section class=\"page\">").collect();
    // Two set-ups, and the jog sheet.
    assert_eq!(pages.len(), 3);
    assert!(pages[0].contains("Set-up 1") && pages[1].contains("Set-up 2") && pages[2].contains("Jog sheet"));
    let json = fs::read_to_string(workspace().join("tests/data/sheets/spinner-u5-620.fanuc.json")).expect("a sheet");
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let set_ups = json["set_ups"].as_array().expect("a list");
    assert_ne!(set_ups[0]["work_offset"], set_ups[1]["work_offset"]);
    for (set_up, page) in set_ups.iter().zip(&pages) {
        for operation in set_up["operations"].as_array().expect("a list") {
            let name = operation["name"].as_str().expect("a name");
            assert!(page.contains(&format!("<td>{name}</td>")), "{name}");
        }
    }
}

/// CL data of a short part in a folder of its own.
fn shop() -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let cl = folder.path().join("part.cls");
    fs::copy(workspace().join("examples/cl/two_tools.cls"), &cl).expect("a copy");
    let cl = cl.display().to_string();
    (folder, cl)
}

/// Names of the files in a folder.
fn files(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

fn dmu(args: &[&str]) -> Output {
    binary("dmu-70e").args(args).output().expect("it runs")
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn a_page_has_the_name_of_its_cl_data_unless_it_is_given_another() {
    let (folder, cl) = shop();
    let own = folder.path().join("part.html");
    fs::write(&own, "<!doctype html><p>notes</p>").expect("it can be written");
    let refused = dmu(&["view", &cl]);
    assert!(refused.status.code() == Some(2) && errors(&refused).contains("is not a page of this program"));
    assert_eq!(fs::read_to_string(&own).expect("it is there"), "<!doctype html><p>notes</p>");
    fs::remove_file(&own).expect("it is there");
    // The second time its own page is replaced.
    assert!((0..2).all(|_| dmu(&["view", &cl]).status.success()));
    assert_eq!(files(folder.path()), ["part.cls", "part.html"]);
    let svg = folder.path().join("part.svg").display().to_string();
    fs::remove_file(folder.path().join("part.html")).expect("it is there");
    assert!(dmu(&["view", &cl, "--svg", &svg]).status.success());
    assert_eq!(files(folder.path()), ["part.cls", "part.svg"]);
    let picture = fs::read_to_string(&svg).expect("a picture");
    // Three views and an axis below the other; feed and rapid are lines.
    assert!(picture.starts_with("<svg") && picture.matches("<polyline").count() > 20, "{picture}");
    let output = dmu(&["view", &cl, "-o", "-"]);
    assert!(output.status.success() && Page::decoded(&String::from_utf8_lossy(&output.stdout)).points() > 20);
}

#[test]
fn inputs_are_not_overwritten_and_a_sheet_needs_a_known_ending() {
    let (folder, cl) = shop();
    let program = folder.path().join("part.nc").display().to_string();
    assert!(dmu(&["post", &cl, "-o", &program]).status.success());
    for (args, words) in [
        (vec!["view", &cl, &program, "-o", &program], "would overwrite the program"),
        (vec!["view", &cl, "-o", &cl], "would overwrite the CL data"),
        (vec!["post", &cl, "-o", &program, "--view", &program], "would overwrite the program"),
        (vec!["view", "-"], "give `-o OUT.html`"),
        (vec!["view", &cl, "-o", "-", "--open"], "--open needs a file"),
        (vec!["report", &cl, "-o", "sheet.txt"], ".html, .md or .json"),
    ] {
        let output = dmu(&args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(errors(&output).contains(words), "{args:?}: {}", errors(&output));
    }
    assert_eq!(files(folder.path()), ["part.cls", "part.nc"]);
}

#[test]
fn a_program_is_the_same_with_a_page_and_a_rejected_one_has_a_page() {
    let (folder, cl) = shop();
    let [with, without, html] =
        ["with.nc", "without.nc", "page.html"].map(|name| folder.path().join(name).display().to_string());
    assert!(dmu(&["post", &cl, "-o", &without]).status.success());
    assert!(dmu(&["post", &cl, "-o", &with, "--view", &html]).status.success());
    let program = fs::read_to_string(&with).expect("a program");
    assert_eq!(program, fs::read_to_string(&without).expect("a program"));
    let page = Page::decoded(&fs::read_to_string(&html).expect("a page"));
    assert_eq!((page.program, page.head["program"].as_str()), (program, Some("with.nc")));
    // A word that is not understood, after the first cuts.
    let text =
        fs::read_to_string(&cl).expect("CL data").replace("TOOL PATH/TILTED_SLOT", "NOWORD/1\nTOOL PATH/TILTED_SLOT");
    fs::write(&cl, text).expect("it can be written");
    let output = dmu(&["post", &cl, "-o", &with, "--view", &html]);
    assert_eq!(output.status.code(), Some(1), "{}", errors(&output));
    assert_eq!(files(folder.path()), ["page.html", "part.cls", "with.nc.earlier", "with.nc.rejected", "without.nc"]);
    let page = Page::decoded(&fs::read_to_string(&html).expect("a page"));
    assert!(page.points() > 5 && page.head["summary"][0].as_str().is_some_and(|line| line.starts_with("rejected: ")));
}

#[cfg(unix)]
#[test]
fn a_page_replaces_the_target_of_a_link() {
    let (folder, cl) = shop();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("shown.html"), "yesterday").expect("it can be written");
    std::os::unix::fs::symlink(path("shown.html"), path("page.html")).expect("links work here");
    let [program, page] = ["out.nc", "page.html"].map(|name| path(name).display().to_string());
    assert!(dmu(&["post", &cl, "-o", &program, "--view", &page]).status.success());
    assert!(fs::symlink_metadata(&page).expect("the link is there").is_symlink());
    assert!(fs::read_to_string(path("shown.html")).expect("a page").starts_with("<!doctype html>"));
}

#[test]
fn the_machine_is_followed_through_its_retracts() {
    for given in SAMPLES {
        let page = sample(given);
        let placement = |point: usize| page.at("placement", point) as usize;
        let begins = (0..page.points()).filter(|point| page.kind(*point) == "start");
        let expected = (0..page.points()).filter(|point| *point == 0 || placement(*point) != placement(point - 1));
        // A path begins with the program and with each tool: nothing between is a gap.
        assert_eq!(begins.collect::<Vec<_>>(), expected.collect::<Vec<_>>(), "{}", given.0);
        let joints = page.head["machine"]["joints"].as_array().expect("joints");
        let z = joints.iter().position(|joint| joint["letter"] == "Z").expect("an axis Z");
        let mut retracts = 0;
        for point in 1..page.points() {
            let text = page.program.lines().nth(page.line(point) as usize - 1).unwrap_or_default();
            let machine = ["G53 ", "SUPA ", "M91"].iter().any(|word| text.contains(word));
            if machine && text.contains('Z') {
                let zero = number(&page.head["placements"][placement(point)]["zero"][z]);
                let coordinate = page.axes(point)[z] + zero;
                assert!(abs_diff_eq!(coordinate, 0.0, epsilon = 1e-4), "{}, {text}: Z is at {coordinate}", given.0);
                retracts += 1;
            }
        }
        assert!(retracts > 0, "{}", given.0);
    }
}

#[test]
fn motions_to_machine_positions_are_listed_where_the_machine_zero_is_unknown() {
    let page = inclined();
    let listed: Vec<u64> = page.head["path"]["undrawn"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|line| line.as_u64().expect("a line"))
        .collect();
    let blocks = page.program.lines().zip(1..).filter(|(text, _)| !text.starts_with('('));
    let expected = blocks.filter(|(text, _)| text.contains("G53 ")).map(|(_, line)| line);
    assert_eq!(listed, expected.collect::<Vec<u64>>());
    assert!(!listed.is_empty());
    assert!((0..page.points()).all(|point| !listed.contains(&page.line(point))));
}

/// Axis values of a program for LinuxCNC, followed word by word: mm and degrees, in the order of the chain; `None`:
/// unknown.
struct Followed {
    oracle: Oracle,
    letters: Vec<char>,
    values: Vec<Option<f64>>,
    /// Lowest and highest of all values since every axis was known.
    extremes: Vec<(f64, f64)>,
}

impl Followed {
    fn new<M: Machine>(oracle: Oracle) -> Self {
        let letters: Vec<char> = M::AXES.iter().map(|axis| axis.letter).collect();
        let (values, extremes) = (vec![None; letters.len()], vec![(f64::INFINITY, f64::NEG_INFINITY); letters.len()]);
        Self { oracle, letters, values, extremes }
    }

    fn tip(&self, values: &[f64]) -> Vector3<f64> {
        let linear = |letter: &char| "XYZ".contains(*letter);
        let si: Vec<f64> = values
            .iter()
            .zip(&self.letters)
            .map(|(value, letter)| if linear(letter) { *value } else { value.to_radians() })
            .collect();
        self.oracle.forward(&si).tip.coords
    }

    /// Values that put the tip at a point, with the rotary axes of `values`.
    fn with_tip(&self, point: &Vector3<f64>, values: &[f64]) -> Vec<f64> {
        let mut solved = values.to_vec();
        let linear: Vec<usize> = (0..solved.len()).filter(|index| "XYZ".contains(self.letters[*index])).collect();
        linear.iter().for_each(|&index| solved[index] = 0.0);
        let zero = self.tip(&solved);
        let columns: Vec<Vector3<f64>> = linear
            .iter()
            .map(|&index| {
                let mut moved = solved.clone();
                moved[index] = 1.0;
                self.tip(&moved) - zero
            })
            .collect();
        let change = Matrix3::from_columns(&columns).try_inverse().expect("three directions") * (point - zero);
        linear.iter().zip(change.iter()).for_each(|(&index, value)| solved[index] = *value);
        solved
    }

    /// To words; under tip control X, Y and Z are those of the tip on the workpiece, and all words change evenly.
    fn go(&mut self, words: &BTreeMap<char, f64>, tip_control: bool) {
        let known = |values: &[Option<f64>]| values.iter().copied().collect::<Option<Vec<f64>>>();
        let from = known(&self.values);
        let word = |letter: &char| words.get(letter).copied();
        let written: Vec<Option<f64>> =
            self.letters.iter().zip(&self.values).map(|(letter, value)| word(letter).or(*value)).collect();
        match (from, tip_control) {
            (Some(from), true) => {
                let start = self.tip(&from);
                let end = Vector3::from(['X', 'Y', 'Z'].map(|letter| word(&letter)))
                    .zip_map(&start, |word, value| word.unwrap_or(value));
                let to = known(&written).expect("all are known");
                for sample in 0..=16 {
                    let share = f64::from(sample) / 16.0;
                    let rotary: Vec<f64> = from.iter().zip(&to).map(|(from, to)| from + (to - from) * share).collect();
                    let values = self.with_tip(&start.lerp(&end, share), &rotary);
                    self.values = values.iter().copied().map(Some).collect();
                    self.note();
                }
            }
            (_, false) => self.values = written,
            (None, true) => panic!("tip control is switched on at an unknown position"),
        }
        self.note();
    }

    fn note(&mut self) {
        if self.values.iter().all(Option::is_some) {
            for (value, (low, high)) in self.values.iter().flatten().zip(&mut self.extremes) {
                (*low, *high) = (low.min(*value), high.max(*value));
            }
        }
    }
}

#[test]
fn extremes_of_a_sheet_under_tip_control_of_linuxcnc_are_those_of_the_axes() {
    const GAUGE_MM: f64 = 120.0;
    const ZERO_MM: [f64; 3] = [3.25, -4.5, -190.0];
    let keys = "units = 'mm'\npart_origin = [0, 0, 20]\nmode = 'tcp'\n\
                machine_zero = { X = 3.25, Y = -4.5, Z = -190.0 }\n[retract]\nposition = 119.0\n\
                [dimensions]\ny_offset = 0.5\nz_offset = 25.5\n[control]\ntip_control = ['M428', 'M429']\n";
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    fs::write(path("keys.toml"), keys).expect("it can be written");
    let cl = workspace().join("examples/cl/concave.aptsource").display().to_string();
    let mut files = ["post", "report"].into_iter().zip(["part.nc", "sheet.json"]).map(|(command, name)| {
        let args = ["xyzac-trt", command, &cl, "--config", &path("keys.toml"), "-o", &path(name)].map(Into::into);
        let (mut output, mut errors) = (Vec::new(), Vec::new());
        let streams = Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
        assert_eq!(run_with::<XyzacTrt>(&args, streams), Status::Done, "{}", String::from_utf8_lossy(&errors));
        fs::read_to_string(path(name)).expect("a file")
    });
    let (program, sheet) = (files.next().expect("a program"), files.next().expect("a sheet"));

    let mut machine =
        Config::read::<XyzacTrt>(keys, &LinuxCnc).expect("keys").set_up.machine::<XyzacTrt>().expect("valid");
    machine.set_up([0.0, 0.0, 20.0].into(), GAUGE_MM);
    let mut followed = Followed::new::<XyzacTrt>(Oracle::of(&machine));
    let (mut tip_control, mut switched) = (false, 0);
    for line in program.lines().filter(|line| !line.starts_with(['(', '%'])) {
        let words: Vec<(char, f64)> = line
            .split_whitespace()
            .filter_map(|word| Some((word.chars().next()?, word.get(1..)?.parse().ok()?)))
            .collect();
        let code = |code: (char, f64)| words.contains(&code);
        let mut axes: BTreeMap<char, f64> =
            words.iter().copied().filter(|(letter, _)| followed.letters.contains(letter)).collect();
        if code(('G', 53.0)) {
            for ((letter, zero), gauge) in ['X', 'Y', 'Z'].iter().zip(ZERO_MM).zip([0.0, 0.0, GAUGE_MM]) {
                axes.entry(*letter).and_modify(|word| *word -= zero + gauge);
            }
        }
        if code(('M', 428.0)) || code(('M', 429.0)) {
            tip_control = code(('M', 428.0));
            switched += u32::from(tip_control);
        } else if !axes.is_empty() {
            followed.go(&axes, tip_control);
        }
    }
    assert!(switched > 5, "{switched}");

    let sheet: Value = serde_json::from_str(&sheet).expect("JSON");
    let rows = sheet["set_ups"][0]["axes"].as_array().expect("rows");
    assert_eq!(rows.len(), followed.letters.len());
    for row in rows {
        let letter = row["letter"].as_str().and_then(|text| text.chars().next()).expect("a letter");
        let index = followed.letters.iter().position(|here| *here == letter).expect("an axis");
        let added = "XYZ".find(letter).map_or(0.0, |axis| ZERO_MM[axis] + [0.0, 0.0, GAUGE_MM][axis]);
        let (low, high) = followed.extremes[index];
        let [lowest, highest] = ["lowest", "highest"].map(|key| number(&row[key]) - added);
        let same = abs_diff_eq!([lowest, highest][..], [low, high][..], epsilon = 0.02);
        assert!(same, "{letter}: {row} for {low} to {high}");
        assert!(row.get("outside_limits").is_none(), "{row}");
    }
}
