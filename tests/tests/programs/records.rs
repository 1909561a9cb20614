//! Records act in the order of the CL data: random jobs with records at every place, posted, checked, and read again by
//! a reader that knows nothing but words and their order.
//!
//! What the order must be is written here once more, from the rules of the book. `PP_RECORDS=N` sets the number of
//! jobs.

use std::io::Cursor;

use machines::SpinnerU5620;
use pp_runtime::check::check;
use pp_runtime::config::Config;
use pp_runtime::control::by_name;
use pp_runtime::post::{Job, post};
use tests::environment;
use tests::random::Random;

/// Random jobs of a test run.
const JOBS: u64 = 400;

const CONTROLS: [&str; 5] = ["fanuc", "haas", "siemens", "linuxcnc", "heidenhain"];

const CONFIG: &str =
    "mode = \"axes\"\ncl_units = \"mm\"\nretract.distance = 20\ncl.auxfun = [77]\ncl.insert = \"write\"
defaults = { speed = 2000, direction = \"CLW\" }
control.effects = { M77 = \"none\", M78 = \"none\", M68 = \"chuck\", M69 = \"door\", M71 = \"clamp\" }
[cl.words]
\"CHUCK/OPEN\" = { blocks = \"M68\", at = \"after_change\" }
\"DOOR/OPEN\" = { blocks = \"M69\", at = \"before_change\" }
\"VISE/OPEN\" = { blocks = \"M71\", at = \"at_approach\" }
\"LAMP/ON\" = { blocks = \"M78\", harmless = true }
";

/// When a record is written.
#[derive(Clone, Copy, PartialEq)]
enum When {
    /// Where it stands, after the tool change that is due.
    InOrder,
    BeforeChange,
    AtApproach,
}

/// Records, and the mark by which each is found in the program.
const RECORDS: [(&str, &str, When); 9] = [
    ("AUXFUN/77", "M77", When::InOrder),
    ("LAMP/ON", "M78", When::InOrder),
    ("CHUCK/OPEN", "M68", When::InOrder),
    ("DOOR/OPEN", "M69", When::BeforeChange),
    ("VISE/OPEN", "M71", When::AtApproach),
    ("STOP", "stop", When::InOrder),
    ("OPSTOP", "optional stop", When::InOrder),
    ("DELAY/2.5", "dwell", When::InOrder),
    ("PPRINT A TEXT", "text", When::InOrder),
];

/// CL data with records between its lines, and the order of what must be in the program.
fn job(random: &mut Random) -> (String, Vec<String>) {
    let mut data = vec!["UNITS/MM".to_owned(), "PARTNO RECORDS".to_owned()];
    let (mut due, mut tool): (Option<u32>, Option<u32>) = (None, None);
    let (mut order, mut waiting): (Vec<String>, Vec<&str>) = (Vec::new(), Vec::new());
    let mut place = 100;
    let record = |random: &mut Random,
                  data: &mut Vec<String>,
                  order: &mut Vec<String>,
                  waiting: &mut Vec<&str>,
                  due: &mut Option<u32>,
                  tool: &mut Option<u32>| {
        while random.chance(0.2) {
            let (text, mark, when) = RECORDS[random.below(RECORDS.len())];
            data.push(text.to_owned());
            match when {
                When::AtApproach => waiting.push(mark),
                When::BeforeChange => order.push(mark.to_owned()),
                When::InOrder => {
                    if let Some(number) = due.take() {
                        order.push(format!("T{number}"));
                        *tool = Some(number);
                    }
                    order.push(mark.to_owned());
                }
            }
        }
    };
    let operations = 1 + random.below(4);
    for operation in 0..operations {
        data.push(format!("TOOL PATH/OP{operation},TOOL,T"));
        let called = 1 + random.below(3) as u32;
        // The first operation has a tool.
        if operation == 0 || random.chance(0.7) {
            record(random, &mut data, &mut order, &mut waiting, &mut due, &mut tool);
            data.push(format!("LOADTL/{called}"));
            due = Some(called).filter(|called| tool != Some(*called));
        }
        let mut lines = vec!["SPINDL/RPM,1500,CLW".to_owned(), "COOLNT/ON".to_owned(), "FEDRAT/500,MMPM".to_owned()];
        for (z, rapid) in [(50, true), (-1, false), (-1, false), (-2, false), (50, true)] {
            if rapid {
                lines.push("RAPID".to_owned());
            }
            place += 1;
            lines.push(format!("GOTO/{place},7,{z},0,0,1"));
        }
        for line in lines {
            if !line.starts_with("GOTO") || data.last().is_none_or(|last| last != "RAPID") {
                record(random, &mut data, &mut order, &mut waiting, &mut due, &mut tool);
            }
            if line.starts_with("GOTO") {
                if let Some(number) = due.take() {
                    order.push(format!("T{number}"));
                    tool = Some(number);
                }
                order.extend(waiting.drain(..).map(str::to_owned));
                order.push(line[..line.find(',').expect("a comma")].replace("GOTO/", "X"));
            }
            data.push(line);
        }
    }
    record(random, &mut data, &mut order, &mut waiting, &mut due, &mut tool);
    if random.chance(0.3) {
        let called = 1 + random.below(3) as u32;
        data.push(format!("LOADTL/{called}"));
        due = Some(called).filter(|called| tool != Some(*called));
        record(random, &mut data, &mut order, &mut waiting, &mut due, &mut tool);
    }
    if !waiting.is_empty() || due.is_some() {
        order.extend(due.map(|number| format!("T{number}")));
        order.extend(waiting.iter().map(|mark| (*mark).to_owned()));
    }
    (data.join("\n") + "\n", order)
}

/// What a program has of it, in order.
fn order_of(program: &str) -> Vec<String> {
    let mut order: Vec<String> = Vec::new();
    let (mut called, mut is_guard) = (None, false);
    for line in program.lines() {
        let text = line.trim_start_matches(|letter: char| letter.is_ascii_digit()).trim_start();
        let is_comment = text.starts_with(['(', ';', '*']) || text.starts_with("MSG");
        if text.contains("A TEXT") {
            order.push("text".to_owned());
        }
        // A guard of Siemens stops and ends the program.
        is_guard = (is_guard || text.starts_with("IF ")) && text != "ENDIF";
        if is_comment || is_guard {
            continue;
        }
        let words: Vec<&str> = text.split(' ').collect();
        for (index, word) in words.iter().enumerate() {
            let number = |word: &str| word.parse::<u32>().ok();
            let mark = match *word {
                "M77" | "M78" | "M68" | "M69" | "M71" => Some((*word).to_owned()),
                "M0" | "M00" => Some("stop".to_owned()),
                "M1" | "M01" => Some("optional stop".to_owned()),
                "P2500" | "P2.5" | "F2.5" | "2.5" => Some("dwell".to_owned()),
                "M6" | "M06" => called.map(|number: u32| format!("T{number}")),
                "CALL" => words.get(index + 1).and_then(|next| number(next)).map(|number| format!("T{number}")),
                word if word.starts_with('T') => {
                    called = number(&word[1..]).or(called);
                    None
                }
                word if word.starts_with('X') => {
                    let place = word[1..].trim_start_matches('+').trim_end_matches('.').parse::<u32>().ok();
                    place.filter(|place| *place > 100).map(|place| format!("X{place}"))
                }
                _ => None,
            };
            order.extend(mark);
        }
    }
    // The tool comes back to where it was, and a tool may be called again where it is.
    let (mut seen, mut tool) = (Vec::new(), String::new());
    order.retain(|mark| match mark.as_bytes()[0] {
        b'X' => {
            let new = !seen.contains(mark);
            seen.push(mark.clone());
            new
        }
        b'T' => std::mem::replace(&mut tool, mark.clone()) != *mark,
        _ => true,
    });
    order
}

#[test]
fn records_at_every_place_act_in_their_order() {
    let jobs = environment::number("PP_RECORDS").unwrap_or(JOBS);
    let mut random = Random::new(57);
    let (mut posted, mut refused) = (0, std::collections::BTreeMap::<String, u64>::new());
    for number in 0..jobs {
        let (data, wanted) = job(&mut random);
        let control = by_name(CONTROLS[number as usize % 5]).expect("a control");
        let config = Config::read::<SpinnerU5620>(CONFIG, control).expect("keys of this machine");
        let mut program = Vec::new();
        let job = Job { cl_name: "records.cls", config: &config, control, units: None };
        let report = post::<SpinnerU5620>(&job, &mut Cursor::new(&data), &mut program).expect("memory can be written");
        if report.failed {
            let why = report.diagnostics.iter().find(|found| found.severity == pp_runtime::diag::Severity::Error);
            *refused.entry(why.map_or_else(String::new, |found| found.text.clone())).or_default() += 1;
            continue;
        }
        posted += 1;
        let policy = config.check_policy::<SpinnerU5620>(control, None).expect("it can be checked");
        let outcome = check::<SpinnerU5620>(&policy, Cursor::new(&data), &program[..]).expect("it can be read").outcome;
        let program = String::from_utf8(program).expect("ASCII");
        assert_eq!(outcome.findings.first().map(|found| &found.text), None, "job {number}\n{data}\n{program}");
        assert_eq!(order_of(&program), wanted, "job {number}\n{data}\n{program}");
    }
    println!("{posted} of {jobs} posted; refused: {refused:#?}");
    assert!(posted * 10 > jobs * 8, "{posted} of {jobs}: {refused:#?}");
}
