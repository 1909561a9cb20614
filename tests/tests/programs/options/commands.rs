//! Every option of every command has an effect: another status, output, message or file.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use tempfile::tempdir;
use tests::by_name::COMMANDS;

use super::{BLOCK, Keys, executed};

/// An option of a command, in a job that uses it.
struct Case {
    /// The command and what it needs beside the option; `{dir}` is a folder with the job.
    command: &'static str,
    option: &'static str,
    /// Settings of the job that are other ones: key and value, none for no such key.
    settings: &'static [(&'static str, &'static str)],
    /// Records at the end of the CL data.
    records: &'static str,
}

const fn case(command: &'static str, option: &'static str) -> Case {
    Case { command, option, settings: &[], records: "" }
}

impl Case {
    const fn settings(self, settings: &'static [(&'static str, &'static str)]) -> Self {
        Self { settings, ..self }
    }

    const fn records(self, records: &'static str) -> Self {
        Self { records, ..self }
    }
}

const POST: &str = "post {dir}/part.cls --config {dir}/set_up.toml --control siemens -o {dir}/out.nc";
const BLADES: &str = "post {dir}/part.cls --config {dir}/set_up.toml --control siemens -o {dir}/out.nc --ops 4..5";
const SIMULATE: &str = "simulate {dir}/part.cls --config {dir}/set_up.toml --control siemens --pitch 4";
const DESIGN: &str =
    "simulate {dir}/part.cls --config {dir}/set_up.toml --control siemens --pitch 4 --design {dir}/block.stl";
const EXPLAIN: &str = "explain";

const CASES: &[Case] = &[
    case("post {dir}/part.cls --config {dir}/set_up.toml --control siemens", "-o {dir}/other.nc"),
    case(POST, "--map {dir}/map.json"),
    case(POST, "--view {dir}/page.html"),
    case(POST, "--no-check"),
    case(POST, "--simulate").settings(BLANK),
    case(POST, "--message-format json").settings(&[("cl_units", "")]),
    case("post {dir}/part.cls --config {dir}/set_up.toml -o {dir}/out.nc", "--control fanuc")
        .settings(&[("cycles.probe", "")]),
    case("post {dir}/part.cls --control siemens -o {dir}/out.nc", "--config {dir}/set_up.toml"),
    case(POST, "--units mm").settings(&[("cl_units", "")]),
    case(POST, "--output-units in"),
    case(POST, "--tolerance 0.002"),
    case(POST, "--axis-tolerance-path 0.02"),
    case(POST, "--allow-lintol").settings(&[("cl.allow_lintol", "")]),
    case(POST, "--dialect iso").records(
        "RAPID\nGOTO/0,0,60\nCYCLE/DRILL,FEDTO,-10,RAPTO,2,MMPM,100\nGOTO/0,0,0\nCYCLE/OFF\nRAPID\nGOTO/0,0,60\n",
    ),
    case(POST, "--columns 72")
        .records("PPRINT/COLUMNS                                                                 00010\n"),
    case(POST, "--inert SHOPWORD").settings(&[("cl.inert", "")]),
    case(POST, "--frames first").records("MSYS/0,0,0,1,0,0,0,1,0\nMSYS/10,0,0,1,0,0,0,1,0\nRAPID\nGOTO/0,0,60,0,0,1\n"),
    case(POST, "--circle-sense ccw"),
    case(POST, "--insert comment").settings(&[("cl.insert", "")]),
    case(POST, "--allow-insert").settings(&[("cl.insert", "")]),
    case(POST, "--from move"),
    case(POST, "--start-branch second").settings(BOTH_SIDES),
    case(POST, "--prefer B-").settings(BOTH_SIDES),
    case(POST, "--greedy"),
    case(POST, "--axis-tolerance 4"),
    case(POST, "--mode axes"),
    case(BLADES, "--lift 50"),
    case(POST, "--ops 3..4"),
    case(POST, "--from-op HOLES"),
    case(POST, "--line-numbers"),
    case(
        "check {dir}/part.cls {dir}/edited.nc --config {dir}/set_up.toml --control siemens",
        "--edits {dir}/edits.toml",
    ),
    case("check {dir}/part.cls {dir}/right.nc --config {dir}/set_up.toml --control siemens", "--json"),
    case("view {dir}/part.cls --config {dir}/set_up.toml --control siemens", "-o {dir}/page.html"),
    case("view {dir}/part.cls --config {dir}/set_up.toml --control siemens -o {dir}/page.html", "--svg {dir}/path.svg"),
    case("report {dir}/part.cls --config {dir}/set_up.toml --control siemens", "-o {dir}/sheet.md"),
    case("report {dir}/part.cls --config {dir}/set_up.toml --control siemens -o {dir}/sheet.md", "--jog"),
    case(SIMULATE, "--stock {dir}/block.stl"),
    case(SIMULATE, "--json").settings(BLANK),
    case(SIMULATE, "-o {dir}/page.html").settings(BLANK),
    case(SIMULATE, "--save-stock {dir}/machined.stl").settings(BLANK),
    case(SIMULATE, "--design {dir}/block.stl").settings(BLANK),
    case(SIMULATE, "--tool-table {dir}/tool.tbl").settings(BLANK),
    case("simulate {dir}/part.cls --config {dir}/set_up.toml --control siemens", "--pitch 6").settings(BLANK),
    case(DESIGN, "--gouge-tolerance 30").settings(BLANK),
    case(DESIGN, "--rest-tolerance 30").settings(BLANK),
    case(DESIGN, "--design-tolerance 2").settings(BLANK),
    case(DESIGN, "--fail-on gouge").settings(BLANK),
    case("config", "--schema"),
    case("config", "--control fanuc"),
    case(EXPLAIN, "--latex"),
    case(EXPLAIN, "--verify"),
    case(EXPLAIN, "--cl"),
    case("explain --control haas", "--codes"),
    case("explain --control haas", "--states"),
    case("explain --control fanuc --config {dir}/set_up.toml", "--proof-program"),
    case(EXPLAIN, "--drawing"),
    case("explain --codes", "--control haas"),
    case("explain --control siemens --proof-program", "--config {dir}/set_up.toml"),
    case("explain --control siemens --proof-program --config {dir}/set_up.toml", "--point 0,0,90"),
    case("explain --control siemens --proof-program --config {dir}/set_up.toml", "--tool 3"),
    case("kinematics", "--c"),
    case("kinematics -o {dir}/kins", "--linuxcnc"),
    case("kinematics", "--linuxcnc-own"),
    case("kinematics", "--siemens"),
    case("kinematics", "--fanuc"),
    case("kinematics", "--heidenhain"),
    case("kinematics", "--haas"),
    case("kinematics --fanuc", "-o {dir}/sheet.md"),
    case("kinematics --fanuc", "--config {dir}/set_up.toml").settings(&[("dimensions.d", "160.0")]),
    case("man", "-o {dir}/pages"),
];

const BLANK: &[(&str, &str)] = &[("stock.lower", "[-60.0, -60.0, -30.0]"), ("stock.upper", "[60.0, 60.0, 0.0]")];
const BOTH_SIDES: &[(&str, &str)] = &[("limits.B", "[-180.0, 180.0]")];

/// Options without an effect on what is written: number of threads, progress on a terminal, a browser, and the text of
/// the help; and the folder of a checkout, in a test of its own.
const NO_EFFECT: &[&str] = &["threads", "quiet", "open", "help", "pp-runtime"];

/// Options of commands that read CL data as `post` does: their effect is seen there.
const OF_JOB: &[&str] = &["check", "view", "report", "simulate", "explain-block"];

/// What a command has done: status, output, messages, files.
#[derive(PartialEq)]
struct Done(String, Vec<u8>, Vec<u8>, BTreeMap<String, Vec<u8>>);

/// The files below a folder.
fn files(folder: &Path, found: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        match path.is_dir() {
            true => files(&path, found),
            false => drop(found.insert(path.display().to_string(), fs::read(&path).expect("a file"))),
        }
    }
}

impl Case {
    fn run(&self, keys: &Keys, folder: &Path, with: bool) -> Done {
        let folder = folder.join("job");
        fs::create_dir(&folder).expect("a folder");
        let mut job = keys.job("siemens", &[]).expect("a job");
        for (key, value) in self.settings {
            match value.is_empty() {
                true => drop(job.settings.remove(*key)),
                false => drop(job.settings.insert((*key).to_owned(), (*value).to_owned())),
            }
        }
        let cl = job.cl.replace("TOOL PATH/FACE", "FROM/0,0,80,0,0,1\nTOOL PATH/FACE");
        let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("it can be written");
        write("part.cls", &cl.replace("FINI\n", &format!("{}FINI\n", self.records)));
        write("set_up.toml", &job.toml());
        write("block.stl", BLOCK);
        write("tool.tbl", "T3 P3 Z119.0 D6.0 ;BALL\n");
        let here = folder.to_str().expect("text");
        if self.command.starts_with("check") {
            let words = |text: &str| text.split(' ').map(|word| word.replace("{dir}", here)).collect::<Vec<_>>();
            executed(&words("post {dir}/part.cls --config {dir}/set_up.toml --control siemens -o {dir}/right.nc"));
            let right = fs::read_to_string(folder.join("right.nc")).expect("it is posted");
            let line = 1 + right.lines().position(|line| line.contains("F812.35")).expect("a feed");
            write("edited.nc", &right.replacen("F812.35", "F512.35", 1));
            let edit = "old = \"F812.35\", new = \"F512.35\", reason = \"chatter\"";
            write("edits.toml", &format!("check.edits = [{{ line = {line}, {edit} }}]\n"));
        }
        let option = if with { self.option } else { "" };
        let words = self.command.split(' ').chain(option.split(' ')).filter(|word| !word.is_empty());
        let (status, output, errors) = executed(&words.map(|word| word.replace("{dir}", here)).collect::<Vec<_>>());
        let mut found = BTreeMap::new();
        files(&folder, &mut found);
        fs::remove_dir_all(&folder).expect("it was made");
        Done(format!("{status:?}"), output, errors, found)
    }
}

#[test]
fn every_option_has_an_effect() {
    let (keys, folder) = (Keys::new(), tempdir().expect("a folder"));
    let idle: Vec<String> = CASES
        .iter()
        .filter_map(|case| {
            let [without, with] = [false, true].map(|with| case.run(&keys, folder.path(), with));
            let refused = with.0 != "Done" && without.0 == "Done" && !case.option.starts_with("--fail-on");
            let why = || String::from_utf8_lossy(&with.2).lines().next().unwrap_or_default().to_owned();
            let meant = case.option.starts_with("--dialect");
            (with == without || refused && !meant).then(|| format!("{} {}: {}", case.command, case.option, why()))
        })
        .collect();
    assert!(idle.is_empty(), "{idle:#?}");
}

#[test]
fn every_option_is_in_the_list() {
    let help = |command: &str| String::from_utf8(executed(&[command, "--help"]).1).expect("text");
    let options = |command: &str| -> BTreeSet<String> {
        let text = help(command);
        let names = text
            .lines()
            .filter_map(|line| line.trim_start().split("--").nth(1).filter(|_| line.trim_start().starts_with('-')));
        names.map(|rest| rest.split([' ', '\n']).next().unwrap_or_default().to_owned()).collect()
    };
    let of_job = options("explain-block");
    for command in COMMANDS {
        for option in options(command) {
            let written = if option == "output" { "-o".to_owned() } else { format!("--{option}") };
            let of = |case: &&Case| case.option.split(' ').next() == Some(written.as_str());
            let own = CASES.iter().filter(of).any(|case| case.command.split(' ').next() == Some(command));
            let of_post = OF_JOB.contains(&command) && of_job.contains(&option)
                || command == "post" && options("simulate").contains(&option);
            let elsewhere = of_post && CASES.iter().any(|case| of(&case));
            assert!(own || elsewhere || NO_EFFECT.contains(&option.as_str()), "`{command} --{option}` has no case");
        }
    }
}
