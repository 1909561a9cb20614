//! Faults that are planted in a right job, and found at their block: words, tools, fixtures, set-up, machine.
//!
//! The part is a block with two faces at 45 degrees, milled with the end of a mill. It is posted in positions of the
//! axes, as it is right or with a faulty configuration, and simulated with the right one; or its program or its shop is
//! changed.

use std::fs;
use std::path::PathBuf;

use serde_json::Value;
use tempfile::TempDir;
use tests::binaries::{binary, workspace};

/// Distances of the passes from the ridge, along a face.
const PASSES: [f64; 4] = [4.0, 11.0, 18.0, 25.0];

/// CL data: for each face a plunge in the middle of the first pass, four passes along Y, and a retract.
fn cl_data() -> String {
    let mut text =
        "UNITS/MM\nTLDATA/MILL,10.0,0.0\nLOADTL/1,LENGTH,120.0\nSPINDL/RPM,4000,CLW\nFEDRAT/MMPM,800\n".to_owned();
    for (name, side) in [("RIGHT", 1.0), ("LEFT", -1.0)] {
        let axis = std::f64::consts::FRAC_1_SQRT_2;
        let at = |along: f64, y: f64, above: f64| {
            let (x, z) = (side * axis * (along + above), axis * (above - along));
            format!("GOTO/{x:.4},{y:.4},{z:.4},{:.7},0,{axis:.7}\n", side * axis)
        };
        let [first, .., last] = PASSES;
        text += &format!("TOOL PATH/{name},TOOL,MILL\nRAPID\n{}RAPID\n{}", at(first, 0.0, 40.0), at(first, 0.0, 10.0));
        text += &at(first, 0.0, 0.0);
        for (index, along) in PASSES.into_iter().enumerate() {
            let [from, to] = if index % 2 == 0 { [-24.0, 24.0] } else { [24.0, -24.0] };
            text += &at(along, from, 0.0);
            text += &at(along, to, 0.0);
        }
        text += &format!("RAPID\n{}END-OF-PATH\n", at(last, -24.0, 40.0));
    }
    text + "FINI\n"
}

/// The design as an STL file: exact, since it has flat faces only.
fn design() -> String {
    let section = [[-20.0, -40.0], [20.0, -40.0], [20.0, -20.0], [0.0, 0.0], [-20.0, -20.0]];
    let at = |corner: usize, end: usize| {
        let [x, z] = section[corner % 5];
        format!("vertex {x} {} {z}\n", [-15, 15][end])
    };
    let mut text = "solid roof\n".to_owned();
    let mut facet = |[a, b, c]: [String; 3]| {
        text += &format!("facet normal 0 0 0\nouter loop\n{a}{c}{b}endloop\nendfacet\n");
    };
    for corner in 0..5 {
        facet([at(corner, 0), at(corner + 1, 0), at(corner + 1, 1)]);
        facet([at(corner, 0), at(corner + 1, 1), at(corner, 1)]);
    }
    for corner in 1..4 {
        facet([at(0, 0), at(corner + 1, 0), at(corner, 0)]);
        facet([at(0, 1), at(corner, 1), at(corner + 1, 1)]);
    }
    text + "endsolid roof\n"
}

/// A shop with the part, its design and a right configuration.
struct Shop {
    folder: TempDir,
    machine: &'static str,
    config: String,
}

/// A finding: kind, first and last line of the program, line of the CL data.
type Found = (String, u64, u64, Option<u64>);

impl Shop {
    fn of(machine: &'static str, example: &str) -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        fs::write(folder.path().join("roof.cls"), cl_data()).expect("a file");
        fs::write(folder.path().join("roof.stl"), design()).expect("a file");
        let text = fs::read_to_string(workspace().join("examples/virtual").join(example)).expect("the configuration");
        // The machine of the example, with this part and a tool of its own.
        let kept = |line: &&str| {
            let replaced = ["stock =", "design =", "fixtures =", "1 = {", "2 = {", "part_origin", "mode ="];
            !replaced.iter().any(|key| line.starts_with(key))
        };
        let mut config: String = text.lines().filter(kept).map(|line| format!("{line}\n")).collect();
        config = config
            .replace("[tools]\n", &format!("[tools]\n{TOOL}\n"))
            .replace("[solids]\n", &format!("[solids]\n{PART}"));
        config =
            config.replace("units = \"mm\"\n", "units = \"mm\"\nmode = \"axes\"\npart_origin = [0.0, 0.0, 70.0]\n");
        Self { folder, machine, config }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The program that is posted with a configuration.
    fn posted(&self, config: &str) -> String {
        fs::write(self.path("post.toml"), config).expect("a file");
        let run = binary(self.machine)
            .arg("post")
            .arg(self.path("roof.cls"))
            .arg("--config")
            .arg(self.path("post.toml"))
            .arg("-o")
            .arg(self.path("roof.ngc"))
            .output()
            .expect("it runs");
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        fs::read_to_string(self.path("roof.ngc")).expect("the program")
    }

    /// What a simulation finds.
    fn simulated(&self, program: &str, config: &str, more: &[&str]) -> Vec<Found> {
        fs::write(self.path("roof.ngc"), program).expect("a file");
        fs::write(self.path("shop.toml"), config).expect("a file");
        let run = binary(self.machine)
            .arg("simulate")
            .arg(self.path("roof.cls"))
            .arg(self.path("roof.ngc"))
            .arg("--config")
            .arg(self.path("shop.toml"))
            .args(["--pitch", "1", "--json"])
            .args(more)
            .output()
            .expect("it runs");
        let json: Value =
            serde_json::from_slice(&run.stdout).unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&run.stderr)));
        let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
        let number = |value: &Value| value.as_u64().unwrap_or(0);
        let mut found: Vec<Found> = Vec::new();
        for one in list(&json["findings"]) {
            let kind = match one["bodies"].as_array() {
                Some(bodies) => format!("{} / {}", bodies[0].as_str().unwrap_or(""), bodies[1].as_str().unwrap_or("")),
                None => one["kind"].as_str().unwrap_or("").to_owned(),
            };
            found.push((kind, number(&one["line"]), number(&one["last_line"]), one["cl_line"].as_u64()));
        }
        for (kind, regions) in [("gouge", "gouges"), ("rest", "rests")] {
            for one in list(&json["design"][regions]) {
                found.push((kind.to_owned(), number(&one["line"]), number(&one["line"]), one["cl_line"].as_u64()));
            }
        }
        found
    }
}

/// The holder is 30 mm above the tip; the blank is at most 14.1 mm high over a face.
const TOOL: &str =
    "1 = { length = 120.0, flute_length = 20.0, shank_diameter = 9.0, holder = [28.0, 55.0, 50.0, 35.0] }";

const PART: &str = "stock = { box = [[-20.0, -15.0, -40.0], [20.0, 15.0, 0.0]] }
design = \"roof.stl\"
\
    fixtures = [{ name = \"riser\", box = [[-22.0, -17.0, 0.0], [22.0, 17.0, 30.0]] }, \
    { name = \"stop\", box = [[10.0, 40.0, 30.0], [45.0, 60.0, 100.0]] }]
";

/// The line of a program that a pattern is in, from 1: the `nth` of them.
fn line_of(program: &str, pattern: &str, nth: usize) -> usize {
    let lines = program.lines().enumerate().filter(|(_, line)| line.contains(pattern));
    let mut lines = lines.map(|(index, _)| index + 1);
    lines.nth(nth).unwrap_or_else(|| panic!("{pattern} {nth}: {program}"))
}

/// A program with a line changed.
fn with_line(program: &str, line: usize, change: impl Fn(&str) -> String) -> String {
    program
        .lines()
        .enumerate()
        .map(|(index, text)| if index + 1 == line { change(text) } else { format!("{text}\n") })
        .collect()
}

fn is_found(found: &[Found], kinds: &[&str], lines: Option<[usize; 2]>, about: &str) {
    let fits = |(kind, first, last, cl_line): &Found| {
        let here = lines.is_none_or(|[from, to]| *first <= to as u64 && *last >= from as u64);
        kinds.iter().any(|wanted| kind.contains(wanted)) && here && cl_line.is_some()
    };
    assert!(found.iter().any(fits), "{about}: wanted {kinds:?} at {lines:?}, found {found:?}");
}

/// Lines of the program in which the mill cuts.
fn cuts(program: &str) -> [usize; 2] {
    [line_of(program, "G1 ", 0), line_of(program, "M2", 0)]
}

#[test]
fn the_right_job_has_no_finding_on_a_table_and_on_a_head() {
    for (machine, example) in [("spinner-u5-620", "spinner-convex.toml"), ("lola-xoyzba", "lola-convex.toml")] {
        let shop = Shop::of(machine, example);
        let program = shop.posted(&shop.config);
        assert_eq!(shop.simulated(&program, &shop.config, &[]), Vec::<Found>::new(), "{machine}");
    }
}

#[test]
fn a_program_that_was_posted_with_a_faulty_configuration_gouges() {
    let table = Shop::of("spinner-u5-620", "spinner-convex.toml");
    let head = Shop::of("lola-xoyzba", "lola-convex.toml");
    for (shop, name, from, to) in [
        (&table, "the centre of B 0.1 mm too high", "[retract]\n", "[dimensions]\nd = 150.1\n[retract]\n"),
        (&table, "C off by half a degree", "[retract]\n", "rotary_offset = { C = 0.5 }\n[retract]\n"),
        (&table, "the part 0.5 mm higher", "70.0]", "70.5]"),
        (&table, "the part 1 mm aside", "[0.0, 0.0, 70.0]", "[1.0, 0.0, 70.0]"),
        (&table, "the part rotated by 0.3 degrees", "[retract]\n", "part_rotation = [0.3, 0.0, 0.0]\n[retract]\n"),
        (&head, "the tool 0.5 mm too short", "length = 120.0", "length = 119.5"),
        (&head, "A off by 0.2 degrees", "[retract]\n", "rotary_offset = { A = 0.2 }\n[retract]\n"),
    ] {
        let faulty = shop.config.replacen(from, to, 1);
        assert_ne!(faulty, shop.config, "{name}");
        if name.contains("too short") {
            // The length of the CL data is that of the configuration.
            let text = cl_data().replace("LENGTH,120.0", "LENGTH,119.5");
            fs::write(shop.path("roof.cls"), text).expect("a file");
        }
        let program = shop.posted(&faulty);
        fs::write(shop.path("roof.cls"), cl_data()).expect("a file");
        let found = shop.simulated(&program, &shop.config, &[]);
        is_found(&found, &["gouge", "rest"], Some(cuts(&program)), name);
    }
}

#[test]
fn a_program_that_was_edited_is_found_at_its_line() {
    let shop = Shop::of("spinner-u5-620", "spinner-convex.toml");
    let program = shop.posted(&shop.config);
    let check = |name: &str, edited: &str, kinds: &[&str], lines: [usize; 2]| {
        let found = shop.simulated(edited, &shop.config, &[]);
        is_found(&found, kinds, Some(lines), name);
    };
    let plunge = line_of(&program, "G1 ", 0);
    // The last rapid before the plunge, 10 mm above the face; the end of the mill is 1 mm above the stock.
    let rapid = plunge - 1;
    let lower = with_line(&program, rapid, |line| {
        let height: f64 = line.trim_start_matches('Z').parse().expect("a line with Z alone");
        format!("Z{:.3}\n", height - 2.0)
    });
    check("a rapid 2 mm too low", &lower, &["rapid_through_stock"], [rapid, rapid]);
    let fast = with_line(&program, plunge, |line| format!("{}\n", line.replace("G1 ", "G0 ")));
    check("a cut at rapid", &fast, &["rapid_through_stock"], [plunge, plunge + 8]);
    let still = with_line(&program, line_of(&program, "M3", 0), |line| format!("{}\n", line.replace("M3", "M5")));
    check("the spindle off", &still, &["spindle_off"], [plunge, plunge + 1]);
    // A pass that ends 0.3 mm too deep.
    let pass = plunge + 3;
    let deep = with_line(&program, pass, |line| format!("{line} Z{:.3}\n", height_at(&program, pass) - 0.3));
    check("a pass too deep", &deep, &["gouge"], [pass, pass + 1]);
    let digit = with_line(&program, pass, |line| format!("{line} Z{:.3}\n", height_at(&program, pass) - 10.0));
    // Z stays until the next Z.
    check("a wrong digit of Z", &digit, &["gouge", "holder"], [pass, pass + 4]);
    let aside = with_line(&program, rapid - 1, |line| format!("{line} X{:.3}\n", value_at(&program, rapid, 'X') + 8.0));
    check("an approach 8 mm aside", &aside, &["rapid_through_stock"], [rapid - 1, rapid + 1]);
    // The second face: the retract before B and C rotate is lost, and with it the next one.
    let rotate = line_of(&program, if program.contains("C-180") { "C-180" } else { "C180" }, 0);
    let first = (0..rotate)
        .rev()
        .find(|line| program.lines().nth(*line).is_some_and(|text| text.contains("G53 G0 Z")))
        .expect("a retract");
    let mut lost = program.clone();
    for line in (first + 1 - 8..rotate).rev() {
        if program.lines().nth(line - 1).is_some_and(|text| text.contains("G53 G0 Z") || text.starts_with("Z")) {
            lost = with_line(&lost, line, |_| "\n".to_owned());
        }
    }
    check("lost retracts", &lost, &["rapid_through_stock", "holder", "shank", "/"], [first - 8, rotate + 4]);
    // What is not cut has no block: it is found where it is left.
    let tilt = line_of(&program, "B45", 0);
    for (name, edited) in [
        ("a pass left out", with_line(&program, pass, |_| "\n".to_owned())),
        ("B out of its place", with_line(&program, tilt, |line| format!("{}\n", line.replace("B45", "B-5")))),
        ("the second face not rotated to", with_line(&program, rotate, |_| "\n".to_owned())),
    ] {
        let found = shop.simulated(&edited, &shop.config, &[]);
        assert!(found.iter().any(|(kind, ..)| kind == "rest"), "{name}: {found:?}");
    }
}

/// The value of a word in force at a line.
fn value_at(program: &str, line: usize, letter: char) -> f64 {
    let words = program.lines().take(line).flat_map(str::split_whitespace);
    let values = words.filter_map(|word| word.strip_prefix(letter)?.parse().ok());
    values.last().expect("a word")
}

fn height_at(program: &str, line: usize) -> f64 {
    value_at(program, line, 'Z')
}

#[test]
fn a_shop_that_differs_from_the_job_is_found() {
    let shop = Shop::of("spinner-u5-620", "spinner-convex.toml");
    let program = shop.posted(&shop.config);
    let all = Some(cuts(&program));
    let clamp = |corners: &str| PART.replace("}]", &format!("}}, {{ name = \"clamp\", box = {corners} }}]"));
    for (name, from, to, kinds) in [
        // It passes the stop at 2 mm.
        ("a holder 5 mm too wide", "holder = [28.0, 55.0", "holder = [33.0, 55.0", &["stop / holder"][..]),
        (
            "cutting edges that are too short",
            "flute_length = 20.0, shank_diameter = 9.0",
            "flute_length = 2.0, shank_diameter = 10.0",
            &["shank"],
        ),
        ("a blank that is 3 mm higher", "[20.0, 15.0, 0.0]]", "[20.0, 15.0, 3.0]]", &["rapid_through_stock"]),
        ("a riser that is too high", "[22.0, 17.0, 30.0]", "[22.0, 17.0, 60.0]", &["riser / cutter", "riser / shank"]),
        ("a clamp beside the part", PART, &clamp("[[10.0, 18.0, 30.0], [22.0, 26.0, 62.0]]"), &["clamp / cutter"]),
        ("a clamp under the holder", PART, &clamp("[[20.0, -40.0, 30.0], [60.0, -26.0, 130.0]]"), &["clamp / holder"]),
        ("a bearing that is in the way", "[[-90.0, 245.0, -420.0]", "[[-90.0, 225.0, -420.0]", &["right bearing"]),
        ("a head that is too low and wide", "[[-95.0, -90.0, 140.0]", "[[-95.0, -190.0, 5.0]", &["head"]),
    ] {
        let config = shop.config.replacen(from, to, 1);
        assert_ne!(config, shop.config, "{name}");
        let lines =
            if name.contains("bearing") || name.contains("head") { Some([1, program.lines().count()]) } else { all };
        is_found(&shop.simulated(&program, &config, &[]), kinds, lines, name);
    }
    // Lengths of two tools swapped in the tool table.
    let table = shop.path("tool.tbl");
    fs::write(&table, "T1 P1 Z100.0 D10.0\nT2 P2 Z120.0 D8.0\n").expect("a file");
    let found = shop.simulated(&program, &shop.config, &["--tool-table", table.to_str().expect("a path")]);
    is_found(&found, &["holder"], all, "a length swapped in the tool table");
}
