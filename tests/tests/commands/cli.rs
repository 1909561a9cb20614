//! The binaries as a user runs them: exit status, files that are left, and messages.

use std::fs;
use std::io::{Read as _, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;
use tests::binaries::{binary, workspace};

const HEAD: &str = "PARTNO T\nUNITS/MM\nLOADTL/1\nSPINDL/RPM,1000,CLW\nFEDRAT/100\n";

/// Result of a run.
#[derive(Debug)]
struct Run {
    status: i32,
    output: Vec<u8>,
    errors: String,
}

/// A temporary folder for CL data and programs.
struct Shop(TempDir);

impl Shop {
    fn new() -> Self {
        Self(TempDir::new().expect("a temporary folder"))
    }

    /// A folder with `part.cls`.
    fn with(text: impl AsRef<[u8]>) -> Self {
        let shop = Self::new();
        shop.write("part.cls", text);
        shop
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.path().join(name), text).expect("a file can be written");
    }

    fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn first_line(&self, name: &str) -> String {
        String::from_utf8_lossy(&self.read(name)).lines().next().unwrap_or_default().to_owned()
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path()).expect("the folder can be read");
        let mut names: Vec<String> =
            entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn command(&self, machine: &str, arguments: &[&str]) -> Command {
        let mut command = binary(machine);
        command.current_dir(self.path()).args(arguments).stdin(Stdio::null());
        command
    }

    fn run_on(&self, machine: &str, arguments: &[&str]) -> Run {
        run(&mut self.command(machine, arguments))
    }

    fn run(&self, arguments: &[&str]) -> Run {
        self.run_on("spinner-u5-620", arguments)
    }

    /// Posts `part.cls` to `part.nc`.
    fn post(&self) -> Run {
        self.run(&["post", "part.cls", "-o", "part.nc"])
    }
}

fn run(command: &mut Command) -> Run {
    let output = command.output().expect("the binary runs");
    let errors = String::from_utf8(output.stderr).expect("messages are UTF-8");
    Run { status: output.status.code().expect("a status"), output: output.stdout, errors }
}

fn example(name: &str) -> String {
    workspace().join("examples/cl").join(name).display().to_string()
}

/// Posts bad CL data: status 1, the message, nothing under the final name, and the reason in the rejected program.
fn assert_rejected(text: impl AsRef<[u8]>, message: &str) {
    let shop = Shop::with(text);
    let run = shop.post();
    assert_eq!(run.status, 1, "{}", run.errors);
    let first = run.errors.lines().next().unwrap_or_default();
    assert_eq!(first, message);
    assert_eq!(shop.names(), ["part.cls", "part.nc.rejected"]);
    let reason = shop.first_line("part.nc.rejected");
    assert!(reason.starts_with("(REJECTED part.cls:"), "{reason}");
    let rejected = String::from_utf8(shop.read("part.nc.rejected")).expect("a program is ASCII");
    assert!(!rejected.lines().any(|line| ["M2", "M30"].contains(&line)), "a rejected program has an end code");
    assert!(run.errors.contains("part.nc was not written"), "{}", run.errors);
    assert!(!run.errors.lines().any(|line| line == "done"), "{}", run.errors);
}

/// Could not run: status 2, the message, and the folder as it was.
fn assert_not_run(shop: &Shop, arguments: &[&str], message: &str) {
    let before = shop.names();
    let run = shop.run(arguments);
    assert_eq!(run.status, 2, "{}", run.errors);
    assert!(run.errors.contains(message), "the message `{message}` is missing:\n{}", run.errors);
    assert_eq!(shop.names(), before);
    assert!(run.output.is_empty());
}

#[test]
fn each_machine_posts_a_sample_without_options() {
    for (machine, sample) in [
        ("spinner-u5-620", "convex.cls"),
        ("dmu-70e", "concave.aptsource"),
        ("lola-xoyzba", "concave.ncl"),
        ("multiprodesk", "spiral_groove.cls"),
    ] {
        let run = Shop::new().run_on(machine, &["post", &example(sample)]);
        assert_eq!(run.status, 0, "{machine}: {}", run.errors);
        assert!(run.output.ends_with(b"\nM2\n"), "{machine}");
        assert!(run.errors.contains("\nassumed: ") && run.errors.ends_with("\ndone\n"), "{machine}: {}", run.errors);
    }
}

#[test]
fn a_file_and_standard_output_get_the_same_bytes() {
    let shop = Shop::with(fs::read(example("two_tools.cls")).expect("a sample"));
    let (to_file, to_output) = (shop.post(), shop.run(&["post", "part.cls"]));
    assert_eq!((to_file.status, to_output.status), (0, 0));
    assert!(to_file.output.is_empty());
    assert_eq!(shop.read("part.nc"), to_output.output);
    assert_eq!(shop.names(), ["part.cls", "part.nc"]);
    let dash = shop.run(&["post", "part.cls", "-o", "-"]);
    assert_eq!(dash.output, to_output.output);
}

#[test]
fn standard_input_gives_the_program_of_the_file() {
    let shop = Shop::with(fs::read(example("two_tools.cls")).expect("a sample"));
    let file = fs::File::open(shop.path().join("part.cls")).expect("it was just written");
    let piped = run(shop.command("spinner-u5-620", &["post", "-"]).stdin(file));
    assert_eq!(piped.status, 0, "{}", piped.errors);
    let text = String::from_utf8(piped.output).expect("ASCII");
    let from_file = String::from_utf8(shop.run(&["post", "part.cls"]).output).expect("ASCII");
    assert_eq!(text.replace("(CL FILE standard input)", "(CL FILE part.cls)"), from_file);
}

#[test]
fn bad_cl_data_sets_an_earlier_program_aside_and_a_good_run_the_rejected_one() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    assert_eq!(shop.post().status, 0);
    assert_eq!(shop.names(), ["part.cls", "part.nc"]);
    shop.write("part.cls", format!("{HEAD}GOTO/1,2\n"));
    let run = shop.post();
    assert_eq!(run.status, 1);
    assert_eq!(shop.names(), ["part.cls", "part.nc.earlier", "part.nc.rejected"]);
    assert!(run.errors.contains("the earlier part.nc is in part.nc.earlier now"), "{}", run.errors);
    shop.write("part.cls", format!("{HEAD}GOTO/1,2,3\n"));
    assert_eq!(shop.post().status, 0);
    assert_eq!(shop.names(), ["part.cls", "part.nc", "part.nc.earlier"]);
}

#[test]
fn standard_output_ends_with_an_error_comment_and_no_end_code() {
    let run = Shop::with(format!("{HEAD}GOTO/1,2,3\nGOTO/4,5\n")).run(&["post", "part.cls"]);
    assert_eq!(run.status, 1);
    let text = String::from_utf8(run.output).expect("ASCII");
    let comments: Vec<&str> = text.lines().rev().take_while(|line| line.starts_with('(')).collect();
    assert!(comments.iter().any(|comment| comment.starts_with("(ERROR in part.cls line 7: ")), "{text}");
    assert!(comments.iter().any(|comment| comment.contains("do not run it")), "{text}");
    assert!(!text.lines().any(|line| line == "M2"), "{text}");
}

#[test]
fn files_that_cannot_be_read_or_written_are_status_2_and_leave_nothing() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    fs::create_dir(shop.path().join("folder")).expect("a folder");
    assert_not_run(&shop, &["post", "missing.cls", "-o", "part.nc"], "error: cannot read missing.cls: ");
    assert_not_run(&shop, &["post", "folder", "-o", "part.nc"], "error: cannot read folder: is a directory");
    assert_not_run(&shop, &["post", "part.cls", "-o", "folder"], "error: cannot write folder: is a directory");
    assert_not_run(&shop, &["post", "part.cls", "-o", "nowhere/part.nc"], "error: cannot write nowhere/part.nc: ");
    assert_not_run(&shop, &["post", "part.cls", "-o", "part.cls/part.nc"], "error: cannot write part.cls/part.nc: ");
    assert_not_run(&shop, &["post", "part.cls", "-o", "part.cls"], "would overwrite the CL data part.cls");
    assert_not_run(&shop, &["post", "part.cls", "--config", "missing.toml"], "error: cannot read missing.toml: ");
    assert_eq!(fs::read_dir(shop.path().join("folder")).expect("the folder").count(), 0);
}

#[cfg(unix)]
#[test]
fn a_folder_that_is_write_protected_is_status_2() {
    use std::os::unix::fs::PermissionsExt as _;
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    let folder = shop.path().join("folder");
    fs::create_dir(&folder).expect("a folder");
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o555)).expect("it is ours");
    // Write protection does not hold for the administrator.
    if fs::write(folder.join("probe"), "").is_err() {
        assert_not_run(&shop, &["post", "part.cls", "-o", "folder/part.nc"], "error: cannot write folder/part.nc: ");
    }
}

#[test]
fn bad_arguments_are_status_2() {
    let shop = Shop::with(HEAD);
    assert_not_run(&shop, &["post", "part.cls", "--wat"], "unexpected argument '--wat'");
    assert_not_run(&shop, &["post"], "IN.cls");
    assert_not_run(&shop, &["post", "part.cls", "--control", "abacus"], "linuxcnc");
    assert_not_run(&shop, &["psot", "part.cls"], "post");
    assert_not_run(&shop, &[], "Usage:");
}

#[test]
fn help_and_version_are_status_0() {
    for arguments in
        [&["--help"] as &[&str], &["post", "--help"], &["--version"], &["config"], &["explain"], &["explain", "--cl"]]
    {
        let run = Shop::new().run(arguments);
        assert_eq!((run.status, run.errors.as_str()), (0, ""), "{arguments:?}");
        assert!(!run.output.is_empty(), "{arguments:?}");
    }
}

#[test]
fn the_printed_configuration_changes_no_program() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    shop.write("set_up.toml", shop.run(&["config"]).output);
    let (plain, configured) =
        (shop.run(&["post", "part.cls"]), shop.run(&["post", "part.cls", "--config", "set_up.toml"]));
    assert_eq!(configured.status, 0, "{}", configured.errors);
    assert_eq!(plain.output, configured.output);
}

#[test]
fn an_unknown_key_of_the_configuration_names_the_nearest() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    shop.write("set_up.toml", "units = \"mm\"\npart_orign = [0.0, 0.0, 0.0]\n");
    let arguments = ["post", "part.cls", "--config", "set_up.toml", "-o", "part.nc"];
    assert_not_run(&shop, &arguments, "set_up.toml:2:1: error: unknown key `part_orign`; did you mean `part_origin`?");
    shop.write("set_up.toml", "units = \"mm\"\npart_origin = [0.0, 0.0\n");
    assert_not_run(&shop, &arguments, "set_up.toml:2:");
    shop.write("set_up.toml", b"units = \"mm\" # \xfc\n");
    assert_not_run(&shop, &arguments, "error: cannot read set_up.toml: ");
}

#[test]
fn a_closed_pipe_is_status_2_without_a_message() {
    let shop = Shop::new();
    let mut command = shop.command("spinner-u5-620", &["post", &example("concave.ncl")]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the binary runs");
    drop(child.stdout.take());
    let mut errors = String::new();
    child.stderr.take().expect("a pipe").read_to_string(&mut errors).expect("messages are UTF-8");
    let status = child.wait().expect("it ends");
    assert_eq!((status.code(), errors.as_str()), (Some(2), ""));
}

#[test]
fn bad_cl_data_is_rejected_with_its_line_and_column() {
    assert_rejected("", "part.cls:1:1: error: the file is empty");
    assert_rejected("\n\n", "part.cls:1:1: error: the file contains no motion: no GOTO was found");
    assert_rejected(
        [0_u8, 1, 2, 255, 10, 0, 200],
        "part.cls:1:1: error: this is not a text file: it contains NUL bytes",
    );
    let line = |text: &str| format!("{HEAD}{text}\n");
    assert_rejected(line("GOTO/1,2,3,4,5"), "part.cls:6:6: error: GOTO needs 3 or 6 numbers, found 5");
    assert_rejected(line("GOTO/1,2,3,0,0,0"), "part.cls:6:6: error: the tool axis is 0, 0, 0 and has no direction");
    assert_rejected(line("GOTO/nan,2,3"), "part.cls:6:6: error: `nan` is not a number");
    assert_rejected(line("GOTO/1,inf,3"), "part.cls:6:8: error: `inf` is not a number");
    assert_rejected(line("GOTO/1,2,-Infinity"), "part.cls:6:10: error: `-Infinity` is not a number");
    assert_rejected(
        line("COPY/1\nGOTO/1,2,3"),
        "part.cls:6:1: error: COPY is refused: it changes the coordinates of all points after it",
    );
}

#[test]
fn a_line_of_ten_megabytes_is_rejected_and_not_repeated_in_full() {
    let mut text = HEAD.as_bytes().to_vec();
    text.extend(std::iter::repeat_n(b'A', 10_000_000));
    text.push(b'\n');
    let shop = Shop::with(text);
    let run = shop.post();
    assert_eq!(run.status, 1);
    assert!(run.errors.starts_with("part.cls:6:1: error: this statement is longer than "), "{:.200}", run.errors);
    assert!(run.errors.len() < 2000, "{} bytes of messages", run.errors.len());
}

#[test]
fn an_unreachable_axis_is_named_with_its_component() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3,0.12,0,0.99277389\n"));
    let run = shop.run_on("multiprodesk", &["post", "part.cls", "-o", "part.nc"]);
    assert_eq!(run.status, 1);
    let expected = "part.cls:6:1: error: MultiProDesk cannot tilt the tool towards X: i = 0.12";
    assert!(run.errors.starts_with(expected), "{}", run.errors);
}

#[test]
fn a_table_that_tilts_to_one_side_passes_the_vertical_by_rotating_there() {
    // B is limited to -5°: motion by motion the table would have to be rewound repeatedly.
    let run = Shop::new().run_on("spinner-u5-620", &["post", &example("concave_4axis.cls")]);
    assert_eq!(run.status, 0, "{}", run.errors);
    assert!(run.errors.contains("rotary axes: 0 rewinds"), "{}", run.errors);
    assert!(run.errors.contains("motion by motion: "), "{}", run.errors);
    let run = Shop::new().run_on("dmu-70e", &["post", &example("concave_4axis.cls")]);
    assert_eq!(run.status, 0, "{}", run.errors);
    assert!(run.errors.contains("blocks inserted; while a rotary axis moves at feed, the tip"), "{}", run.errors);
}

#[test]
fn a_tolerance_that_is_not_positive_is_refused() {
    let shop = Shop::with(HEAD);
    for (flag, value) in [("--axis-tolerance-path", "0"), ("--axis-tolerance-path", "-1"), ("--tolerance", "0")] {
        let run = shop.run(&["post", "part.cls", &format!("{flag}={value}")]);
        assert_eq!(run.status, 2, "{flag} {value}");
        assert!(run.errors.contains("between 0.00"), "{}", run.errors);
    }
}

#[test]
fn every_line_of_json_is_an_object_with_location_and_severity() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\nCOPY/1\n"));
    let run = shop.run(&["post", "part.cls", "--message-format", "json", "-o", "part.nc"]);
    assert_eq!(run.status, 1);
    let parse =
        |line: &str| serde_json::from_str::<serde_json::Value>(line).unwrap_or_else(|error| panic!("{line}: {error}"));
    let objects: Vec<_> = run.errors.lines().map(parse).collect();
    assert!(objects.iter().all(|object| object["severity"].is_string() && object["text"].is_string()));
    let error = objects.iter().find(|object| object["severity"] == "error").expect("an error");
    assert_eq!((&error["file"], &error["line"], &error["column"]), (&"part.cls".into(), &7.into(), &1.into()));
    let good = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    let run = good.run(&["post", "part.cls", "--message-format", "json", "-o", "part.nc"]);
    assert_eq!(run.status, 0);
    assert!(run.errors.lines().map(parse).any(|object| object["text"] == "done"));
    let run = good.run(&["post", "missing.cls", "--message-format", "json"]);
    assert_eq!((run.status, parse(run.errors.trim_end())["severity"].clone()), (2, "error".into()));
}

#[test]
fn findings_as_json_name_the_lines_of_the_program_and_those_of_the_cl_data() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\nGOTO/5,2,3\nGOTO/5,9,3\nGOTO/5,9,1\n"));
    let run = shop.run(&["post", "part.cls", "-o", "part.nc"]);
    assert_eq!(run.status, 0, "{}", run.errors);
    let program = fs::read_to_string(shop.path().join("part.nc")).expect("the program");
    let lost = program.lines().position(|line| line == "Y9").expect("the third point");
    // Blocks in a row that match nothing are one finding; after Y9 no block comes back to the path.
    let wrong = program.replace("\nY9\n", "\nX50 Y9\nX60 Y90\n");
    fs::write(shop.path().join("part.nc"), wrong).expect("it can be written");
    let run = shop.run(&["check", "part.cls", "part.nc", "--message-format", "json"]);
    assert_eq!(run.status, 1, "{}", run.errors);
    let found: Vec<serde_json::Value> =
        run.errors.lines().map(|line| serde_json::from_str(line).expect("an object")).collect();
    let first = found.iter().find(|found| found["program"].is_object()).expect("a finding");
    let lines = &first["program"];
    assert_eq!(lines["file"], "part.nc");
    assert_eq!((lines["line"].as_u64(), lines["last_line"].as_u64()), (Some(lost as u64 + 1), Some(lost as u64 + 3)));
    assert_eq!(lines["block"], "X50 Y9");
    assert!(first["line"].as_u64().is_some() && first["severity"] == "error", "{first}");
}

#[test]
fn line_ends_do_not_change_the_program() {
    let lines = fs::read_to_string(example("two_tools.cls")).expect("a sample");
    let program = |text: &[u8]| {
        let shop = Shop::with(text);
        let run = shop.post();
        assert_eq!(run.status, 0, "{}", run.errors);
        shop.read("part.nc")
    };
    let expected = program(lines.as_bytes());
    assert_eq!(program(lines.replace('\n', "\r\n").as_bytes()), expected, "CRLF");
    assert_eq!(program(lines.replace('\n', "\r").as_bytes()), expected, "CR");
    assert_eq!(program(lines.trim_end().as_bytes()), expected, "no last line end");
    assert_eq!(program(format!("\u{feff}{lines}").as_bytes()), expected, "byte order mark");
    assert_eq!(
        program(lines.to_lowercase().replace("two_tools", "TWO_TOOLS").as_bytes()).len(),
        expected.len(),
        "lower case"
    );
}

#[test]
fn text_in_any_encoding_is_written_in_ascii() {
    let latin =
        |text: &str| text.chars().map(|letter| u8::try_from(u32::from(letter)).expect("Latin-1")).collect::<Vec<u8>>();
    let umlauts = "FR\u{c4}SEN GRO\u{df} \u{e9}t\u{e9} 45\u{b0}";
    for (text, written) in [
        (latin(umlauts), "(FRAESEN GROSS ETE 45 DEG)"),
        (umlauts.as_bytes().to_vec(), "(FRAESEN GROSS ETE 45 DEG)"),
        ("\u{424}\u{440}\u{435}\u{437}\u{430}".as_bytes().to_vec(), "(FREZA)"),
    ] {
        let text = [HEAD.as_bytes(), b"PPRINT ", &text, b"\n$$ ", &text, b"\nGOTO/1,2,3\n"].concat();
        let shop = Shop::with(text);
        assert_eq!(shop.post().status, 0);
        let program = String::from_utf8(shop.read("part.nc")).expect("UTF-8");
        assert!(program.is_ascii() && program.to_uppercase().contains(written), "{program}");
    }
}

#[test]
fn numbers_are_read_in_every_form_of_apt() {
    let shop = Shop::with(format!("{HEAD}GOTO/.5,1.,-0.0\nGOTO/1.E-3,1D2,-2.5d+1\nGOTO/+1.5,-.25,100\n"));
    let run = shop.post();
    assert_eq!(run.status, 0, "{}", run.errors);
    let program = String::from_utf8(shop.read("part.nc")).expect("ASCII");
    let expected = "\nX0.5 Y1\nZ50\nG1 Z0 F100\nX0.001 Y100 Z-25\nX1.5 Y-0.25 Z100\n";
    assert!(program.contains(expected), "{program}");
}

#[cfg(unix)]
#[test]
fn a_named_pipe_is_read_like_a_file() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    let expected = String::from_utf8(shop.run(&["post", "part.cls"]).output).expect("ASCII");
    let made = Command::new("mkfifo").arg(shop.path().join("pipe.cls")).status().expect("mkfifo runs");
    assert!(made.success());
    let path = shop.path().join("pipe.cls");
    let writer = std::thread::spawn(move || {
        let mut pipe = fs::OpenOptions::new().write(true).open(path).expect("a reader opens the pipe");
        pipe.write_all(format!("{HEAD}GOTO/1,2,3\n").as_bytes()).expect("the pipe can be written");
    });
    let run = shop.run(&["post", "pipe.cls", "-o", "part.nc"]);
    writer.join().expect("the writer ends");
    assert_eq!(run.status, 0, "{}", run.errors);
    let text = String::from_utf8(shop.read("part.nc")).expect("ASCII");
    assert_eq!(text.replace("(CL FILE pipe.cls)", "(CL FILE part.cls)"), expected);
    assert_eq!(shop.names(), ["part.cls", "part.nc", "pipe.cls"]);
}

#[test]
fn options_set_how_the_cl_data_is_read() {
    let shop = Shop::with(format!("{HEAD}AICC/ON\nINSERT/STOCK X1\nGOTO/1,2,3\nCIRCLE/0,2,3,0,0,1\nGOTO/0,3,3\n"));
    let all =
        ["--inert", "AICC", "--insert", "comment", "--tolerance", "0.1", "--circle-sense", "ccw", "--dialect", "iso"];
    let run = shop.run(&[&["post", "part.cls", "-o", "part.nc"], &all[..]].concat());
    assert_eq!(run.status, 0, "{}", run.errors);
    let program = String::from_utf8(shop.read("part.nc")).expect("ASCII");
    for line in
        ["(words ignored as inert: AICC)", "(STOCK X1)", "(CL data of ISO 4343, as given)", "(1 arc, sense as given)"]
    {
        assert!(program.contains(line), "{line} is missing in\n{program}");
    }
    let run = shop.run(&["post", "part.cls", "--inert", "LOOP"]);
    assert_eq!(run.status, 2);
    assert!(run.errors.contains("LOOP cannot be inert: it may repeat motion"), "{}", run.errors);
    assert_eq!(shop.run(&["post", "part.cls", "--tolerance", "0"]).status, 2);
    assert_eq!(shop.run(&["post", "part.cls", "--insert", "comment", "--allow-insert"]).status, 2);
}

#[test]
fn every_word_is_listed() {
    let shop = Shop::with("");
    let run = shop.run(&["explain", "--cl"]);
    let text = String::from_utf8(run.output).expect("ASCII");
    for line in ["    GOTO/x,y,z[,i,j,k]; /x,y,z / x,y,z ..", "    PAINT", "    LOOP        it may repeat motion"] {
        assert!(text.lines().any(|found| found == line), "{line} is missing in\n{text}");
    }
}

/// Text of comments without block numbers and comment marks, in the characters that every control has.
fn comment_text(lines: &[&str]) -> String {
    let text = |line: &&str| {
        let line = line.trim_start_matches(|letter: char| letter.is_ascii_digit()).trim_start();
        line.trim_start_matches(['(', ';']).trim_end_matches(')').trim().to_owned()
    };
    lines.iter().map(text).collect::<Vec<String>>().join(" ").to_lowercase().replace(':', ",")
}

#[test]
fn each_reason_that_a_set_up_file_does_not_fit_is_an_error_of_its_own() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    shop.write(
        "shop.toml",
        "part_origin = [0, 0, 0]\ncontrol.tool_names = true\ntools.1.name = \"A B\"\ntools.2.name = \"C D\"\n",
    );
    let run = shop.run(&["post", "part.cls", "--control", "heidenhain", "--config", "shop.toml"]);
    let reasons = [("A B", 1), ("C D", 2)];
    let expected = reasons.map(|(name, number)| {
        format!("error: Heidenhain TNC permits no tool name `{name}`: correct `[tools.{number}] name`\n")
    });
    assert_eq!((run.status, run.errors), (2, expected.concat()));
}

#[test]
fn a_set_up_file_that_names_its_control_is_posted_for_it_and_for_no_other() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    shop.write("shop.toml", "part_origin = [0, 0, 0]\ncontrol.name = \"haas\"\n");
    for config in [&["--config", "shop.toml"][..], &["--config=shop.toml"]] {
        let run = shop.run(&[&["post", "part.cls"], config].concat());
        assert_eq!(run.status, 0, "{}", run.errors);
        assert!(run.errors.contains("control Haas") && run.output.starts_with(b"%\nO00001"), "{}", run.errors);
        let run = shop.run(&[&["post", "part.cls", "--control", "fanuc"], config].concat());
        assert_eq!(run.status, 2);
        assert!(run.errors.contains("is for `haas`, and the program for `fanuc`"), "{}", run.errors);
    }
    shop.write("shop.toml", "control.name = \"hass\"\n");
    let run = shop.run(&["post", "part.cls", "--config", "shop.toml"]);
    assert!(run.status == 2 && run.errors.contains("is for `hass`"), "{}", run.errors);
}

#[test]
fn an_m_function_of_the_control_itself_is_no_code_of_the_shop() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    for (control, keys, code) in [
        ("siemens", "clamp = { C = { on = \"M18\", off = \"M19\" } }\n", "M19"),
        ("haas", "clamp = { C = { on = \"M30\", off = \"M31\" } }\n", "M30"),
        ("heidenhain", "control.coolant = { air = [\"M25\", \"M05\"] }\n", "M05"),
        ("linuxcnc", "control.tip_control = [\"M428\", \"M2\"]\n", "M2"),
    ] {
        shop.write("shop.toml", keys);
        let run = shop.run(&["post", "part.cls", "--control", control, "--config", "shop.toml"]);
        assert_eq!(run.status, 2, "{control}: {}", run.errors);
        assert!(run.errors.contains(&format!("`{code}` of `")) && run.errors.contains("itself"), "{}", run.errors);
    }
}

#[test]
fn a_line_that_ends_the_program_has_no_declared_effect() {
    let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\n"));
    for keys in [
        "control.effects = { \"M30\" = \"none\" }\nprogram.start = [\"M30\"]\n",
        "cycles.measure_tool = [\"G65 P9023 T{tool}\", \"M30\"]\ntools.1.measured = true\n",
        "cycles.check_tool = [\"M02\"]\ntools.1.checked = true\n",
    ] {
        shop.write("shop.toml", keys);
        let run = shop.run(&["post", "part.cls", "--control", "fanuc", "--config", "shop.toml"]);
        assert!(run.status == 2 && run.errors.contains("ends the program"), "{keys}: {}", run.errors);
    }
}

#[test]
fn a_program_ends_with_the_result_of_its_check() {
    for (control, end) in [("linuxcnc", 1), ("fanuc", 2), ("siemens", 1), ("heidenhain", 2), ("haas", 2)] {
        let shop = Shop::with(format!("{HEAD}GOTO/1,2,3\nGOTO/40,2,3,0.6,0,0.8\n"));
        shop.write("shop.toml", "part_origin = [0.0, 0.0, 0.0]\n[program]\nchecked = true\ntimes = true\n");
        let with = ["part.cls", "--control", control, "--mode", "axes", "--config", "shop.toml"];
        let plain = shop.run(&["post", "part.cls", "--control", control, "--mode", "axes"]);
        assert!(!String::from_utf8_lossy(&plain.output).to_lowercase().contains("um of"), "{control}");
        for (option, words) in [(&[][..], "checked"), (&["--no-check"][..], "not checked")] {
            let run = shop.run(&[&["post", "-o", "part.nc"], &with[..], option].concat());
            assert_eq!(run.status, 0, "{control}: {}", run.errors);
            let verdict = run.errors.lines().find(|line| line.starts_with(words)).expect("a result of the check");
            let program = String::from_utf8(shop.read("part.nc")).expect("ASCII");
            let lines: Vec<&str> = program.lines().collect();
            let comments = lines.len() - end;
            let first = (0..comments).rposition(|line| comment_text(&lines[line..=line]).starts_with(words));
            let first = first.unwrap_or_else(|| panic!("{control}: {words} is not at the end of\n{program}"));
            let verdict = verdict.replace('µ', "u").replace('°', " deg");
            assert_eq!(comment_text(&lines[first..comments]), comment_text(&[&verdict]), "{control}");
            let is_short = |line: &&str| line.len() < 160 || line.starts_with("IF ");
            assert!(program.is_ascii() && lines.iter().all(is_short), "{control}");
            let run = shop.run(&[&["check", "part.cls", "part.nc"], &with[1..]].concat());
            assert_eq!(run.status, 0, "{control}: {}", run.errors);
        }
    }
}

/// A file of as many straight cuts.
fn long_cut(points: u32) -> String {
    let points: String = (0..points).map(|point| format!("GOTO/{},{},0\n", point % 100, point % 7)).collect();
    format!("{HEAD}{points}")
}

/// Runs a command of the shell, with the binary as `$0`.
#[cfg(unix)]
fn shell(shop: &Shop, text: &str) -> Run {
    let binary = binary("spinner-u5-620").get_program().to_owned();
    let mut command = Command::new("sh");
    command.current_dir(shop.path()).args(["-c", text]).arg(binary).stdin(Stdio::null());
    run(&mut command)
}

#[cfg(unix)]
#[test]
fn a_closed_standard_stream_is_an_error() {
    let shop = Shop::with(long_cut(10));
    let closed = shell(&shop, r#"exec "$0" post part.cls -o - >&-"#);
    assert_eq!(closed.status, 2, "{}", closed.errors);
    assert!(closed.errors.ends_with("error: cannot write standard output: it is closed\n"), "{}", closed.errors);
    let closed = shell(&shop, r#"exec "$0" config >&-"#);
    assert_eq!(closed.status, 2, "{}", closed.errors);
    let closed = shell(&shop, r#"exec "$0" post - -o part.nc <&-"#);
    assert_eq!((closed.status, shop.names().len()), (2, 1), "{}", closed.errors);
    assert!(closed.errors.ends_with("error: cannot read standard input: it is closed\n"), "{}", closed.errors);
    // Where nothing is written there, it may be closed; and a device that discards everything is no closed stream.
    assert_eq!(shell(&shop, r#"exec "$0" post part.cls -o part.nc >&-"#).status, 0);
    assert_eq!(shell(&shop, r#"exec "$0" post part.cls -o - 1<>/dev/null"#).status, 0);
}

#[cfg(unix)]
#[test]
fn a_file_that_becomes_larger_than_allowed_is_an_error_with_its_name() {
    let shop = Shop::with(long_cut(1500));
    for (arguments, file) in [("-o part.nc", "part.nc"), ("-o - >part.txt", "standard output")] {
        let run = shell(&shop, &format!(r#"ulimit -f 20; exec "$0" post part.cls {arguments}"#));
        assert_eq!(run.status, 2, "{}", run.errors);
        assert!(run.errors.contains(&format!("error: cannot write {file}: File too large")), "{}", run.errors);
        let _ = fs::remove_file(shop.path().join("part.txt"));
        assert_eq!(shop.names(), ["part.cls"]);
    }
    // The map is larger than its program.
    let run = shell(&shop, r#"ulimit -f 200; exec "$0" post part.cls -o part.nc --map part.json"#);
    assert!(run.status == 2 && run.errors.contains("cannot write part.json: File too large"), "{}", run.errors);
    assert_eq!(shop.names(), ["part.cls"]);
}

/// Starts a post whose map goes to a pipe that nobody reads, so that it waits with its program incomplete, and sends it
/// a signal. Returns the signal that ended it, and the files that are left.
#[cfg(unix)]
fn interrupted(signal: &str, prefix: &str) -> (Option<i32>, Vec<String>) {
    use std::os::unix::process::ExitStatusExt as _;
    let shop = Shop::with(long_cut(1500));
    shop.write("part.nc", "yesterday");
    let fifo = shop.path().join("map");
    assert!(Command::new("mkfifo").arg(&fifo).status().expect("mkfifo runs").success());
    let binary = binary("spinner-u5-620").get_program().to_owned();
    // A shell that runs the tests in the background leaves them SIGINT ignored, and so their children.
    let mut command = Command::new("env");
    let text = format!(r#"{prefix} exec "$0" post part.cls -o part.nc --map map"#);
    command.current_dir(shop.path()).args(["--default-signal=INT,TERM,HUP", "sh", "-c", &text]).arg(binary);
    let mut child = command.stdin(Stdio::null()).stderr(Stdio::null()).spawn().expect("it starts");
    let reader = fs::File::open(&fifo).expect("the pipe is opened");
    let begun = || shop.names().iter().any(|name| name.ends_with(".tmp"));
    while !begun() {
        assert_eq!(child.try_wait().expect("a state"), None, "it waits for the pipe");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let send = |signal: &str| {
        let kill = Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status();
        assert!(kill.expect("kill runs").success());
    };
    send(signal);
    if !prefix.is_empty() {
        // Ignored: it ends as usual once the pipe is closed.
        std::thread::sleep(std::time::Duration::from_millis(200));
        drop(reader);
        let status = child.wait().expect("it ends");
        return (status.signal(), shop.names());
    }
    let started = std::time::Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().expect("a state") {
            break status;
        }
        if started.elapsed().as_secs() > 60 {
            child.kill().expect("it is ended");
            panic!("the signal {signal} did not end it");
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    };
    drop(reader);
    (status.signal(), shop.names())
}

#[cfg(unix)]
#[test]
fn a_signal_leaves_no_temporary_file() {
    for (signal, number) in [("INT", 2), ("TERM", 15), ("HUP", 1)] {
        let (ended_by, names) = interrupted(signal, "");
        assert_eq!(ended_by, Some(number), "{signal}");
        assert_eq!(names, ["map", "part.cls", "part.nc"], "{signal}");
    }
    let (ended_by, names) = interrupted("HUP", "trap '' HUP;");
    assert_eq!((ended_by, names.len()), (None, 3), "an ignored signal stays ignored: {names:?}");
}
