//! Inch programs on every control. The pitch that the control makes of the words of a thread, by a computation of this
//! test, is that of the CL data, or the thread is refused with settings that work; messages are in inches; arcs with
//! coarse words pass.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::Control;
use pp_runtime::post::Report;
use tests::by_name;
use tests::posting::{bare, findings, written};

/// Threads per inch of UNC, UNF, UNEF, UN and NPT.
const THREADS_PER_INCH: [f64; 36] = [
    2.25, 2.5, 2.75, 3.0, 3.25, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 11.5, 12.0, 13.0, 14.0, 16.0, 18.0,
    19.0, 20.0, 24.0, 26.0, 27.0, 28.0, 32.0, 36.0, 40.0, 44.0, 48.0, 56.0, 64.0, 72.0, 80.0,
];

/// Length of a thread from its clearance level to its bottom, in.
const LENGTH_IN: f64 = 0.9;

/// Most settings that one refusal after the other asks for.
const MOST_SETTINGS: usize = 4;

/// Spindle speeds, rev/min; one has a rounded S.
fn speeds() -> impl Iterator<Item = f64> {
    (1..=12).map(|hundreds| f64::from(hundreds) * 100.0).chain([333.3])
}

/// A thread at each speed.
fn cl(threads_per_inch: f64) -> String {
    let mut cl = String::from("UNITS/INCHES\nTOOL PATH/TAPS,TOOL,TAP\nLOADTL/1,LENGTH,4\n");
    for speed in speeds() {
        cl += &format!(
            "SPINDL/RPM,{speed},CLW\nRAPID\nGOTO/0,0,2,0,0,1\n\
             CYCLE/TAP,RAPTO,0.2,FEDTO,-0.7,RTRCTO,0.4,TPI,{threads_per_inch}\nGOTO/0,0,0\nCYCLE/OFF\nRAPID\nGOTO/0,0,2\n"
        );
    }
    cl + "FINI\n"
}

/// Configuration with further keys, each with its section.
fn config(control: &dyn Control, keys: &[(String, String)]) -> Config {
    let mut text = String::from("mode = 'axes'\npart_origin = [0.0, 0.0, 60.0]\nlength_guard = false\n");
    for (section, key) in keys {
        text += &format!("{section}{key}\n");
    }
    starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// Number after an address.
fn number(word: &str) -> Option<f64> {
    let end = word.find(|c: char| !matches!(c, '0'..='9' | '.' | '-' | '+')).unwrap_or(word.len());
    word[..end].parse().ok()
}

/// Pitches of the threads of a program, in, as its control derives them from the words.
fn pitches(name: &str, program: &str) -> Vec<f64> {
    let lines = bare(program);
    let in_mm = lines.iter().any(|line| {
        let words = || line.split(' ');
        words().any(|word| matches!(word, "G21" | "G710")) || line.starts_with("BEGIN PGM") && line.ends_with("MM")
    });
    let unit = if in_mm { 1.0 / 25.4 } else { 1.0 };
    let word = |line: &str, letter: char| line.split(' ').find_map(|word| word.strip_prefix(letter).and_then(number));
    let (mut speed, mut per_revolution, mut found) = (0.0, false, Vec::new());
    for line in lines.iter().filter(|line| !line.starts_with(['(', ';'])) {
        speed = word(line, 'S').unwrap_or(speed);
        per_revolution = line.contains("G95") || per_revolution && !line.contains("G94");
        let pitch = match name {
            "linuxcnc" => line.contains("G33.1").then(|| word(line, 'K')).flatten(),
            "siemens" => line.split_once("CYCLE84(").map(|(_, call)| {
                let arguments: Vec<&str> = call.trim_end_matches(')').split(',').collect();
                assert_eq!(arguments.last(), Some(&if in_mm { "1" } else { "3" }), "{line}");
                number(arguments[8]).expect("a pitch")
            }),
            "heidenhain" => line.split_once("Q239=").and_then(|(_, pitch)| number(pitch)),
            _ if line.contains("G84") => {
                let feed = word(line, 'F').expect("F");
                Some(if per_revolution { feed } else { feed / speed })
            }
            _ => None,
        };
        found.extend(pitch.map(|pitch| pitch * unit));
    }
    found
}

/// Settings that a remedy names, each with its section; empty if there is no remedy.
fn remedies(help: &str) -> Vec<(String, String)> {
    let quoted = help.split('`').skip(1).step_by(2).filter(|text| text.contains(" = "));
    let section = |key: &str| match key {
        _ if key.starts_with("thread_feed") => "cycles.",
        _ if key.starts_with("output_units") => "",
        _ => "formats.",
    };
    quoted.map(|key| (section(key).to_owned(), key.to_owned())).collect()
}

/// What became of the threads of a size: right, or right with settings that the refusals name.
#[derive(Debug, Default)]
struct Tally {
    right: usize,
    with_settings: usize,
    /// Settings that were taken.
    taken: Vec<String>,
}

/// Posts threads after a number of refusals; where they are refused, takes each of the settings that the refusal names.
fn threads_are_right(name: &str, threads_per_inch: f64, keys: &[(String, String)], refusals: usize, tally: &mut Tally) {
    let control = by_name::control(name);
    let (config, cl) = (config(control, keys), cl(threads_per_inch));
    let (program, report) = written::<SpinnerU5620>(&config, control, &cl).unwrap_or_else(|error| panic!("{error:?}"));
    let at = || format!("{name}, {threads_per_inch} threads per inch, {keys:?}");
    if report.failed {
        assert!(refusals < MOST_SETTINGS, "{}: {:?}", at(), report.diagnostics);
        let refused = report.diagnostics.last().expect("a reason");
        assert!(
            refused.text.contains(" in, and that of its rounded words") || refused.text.contains(" mm, and that of"),
            "{refused:?}"
        );
        let settings = remedies(refused.help.as_deref().unwrap_or_default());
        assert!(!settings.is_empty(), "{}: {refused:?}", at());
        for setting in settings {
            tally.taken.push(setting.1.clone());
            let key = |text: &str| text.split(' ').next().unwrap_or_default().to_owned();
            let others = keys.iter().filter(|known| key(&known.1) != key(&setting.1)).cloned();
            let keys: Vec<_> = others.chain([setting.clone()]).collect();
            threads_are_right(name, threads_per_inch, &keys, refusals + 1, tally);
        }
        return;
    }
    let found = findings::<SpinnerU5620>(&config, control, &cl, &program);
    assert!(found.is_empty(), "{}: {found:?}\n{program}", at());
    let (expected, pitches) = (1.0 / threads_per_inch, pitches(name, &program));
    assert_eq!(pitches.len(), speeds().count(), "{}\n{program}", at());
    let errors = || pitches.iter().map(|pitch| (pitch - expected) * LENGTH_IN / expected);
    for error in errors() {
        assert!(error.abs() <= 0.01 * expected, "{}: {error} in too long\n{program}", at());
    }
    summary_states_the_error(&report, errors().fold(0.0, |most: f64, error| most.max(error.abs())));
    if refusals > 0 {
        tally.with_settings += 1;
    } else {
        tally.right += 1;
    }
}

/// The summary has the largest error over the length of a thread, where it is a tenth of a micrometre or more.
fn summary_states_the_error(report: &Report, error_in: f64) {
    let summary = report.summary().join("\n");
    let stated = summary.split_once("change its length by up to ").and_then(|(_, text)| {
        let value = number(text)?;
        Some(if text.contains(" mm") { value / 25.4 } else { value })
    });
    assert!((stated.unwrap_or(0.0) - error_in).abs() < 1.5e-5, "{error_in}: {summary}");
    assert!(stated.is_some() || error_in < 0.6e-5, "{error_in}: {summary}");
}

#[test]
fn the_usual_inch_threads_have_their_pitch_on_every_control() {
    for name in by_name::controls() {
        let mut tally = Tally::default();
        for threads_per_inch in THREADS_PER_INCH {
            threads_are_right(name, threads_per_inch, &[], 0, &mut tally);
        }
        eprintln!("{name}: {tally:?}");
        let refused = tally.with_settings > 0;
        assert_eq!(refused, name == "heidenhain", "{name}: {tally:?}");
    }
}

#[test]
fn a_thread_with_too_few_digits_is_refused_with_settings_that_work() {
    for (name, key) in [
        ("haas", "feed_inch = 2"),
        ("fanuc", "feed_inch = 3"),
        ("haas", "pitch_inch = 3"),
        ("linuxcnc", "pitch_inch = 4"),
        ("siemens", "pitch_inch = 3"),
    ] {
        let mut tally = Tally::default();
        let mut keys = vec![("formats.".to_owned(), key.to_owned())];
        if (name, key) == ("haas", "pitch_inch = 3") {
            keys.insert(0, ("cycles.".to_owned(), "thread_feed = \"revolution\"".to_owned()));
        }
        for threads_per_inch in THREADS_PER_INCH {
            threads_are_right(name, threads_per_inch, &keys, 0, &mut tally);
        }
        eprintln!("{name}, {key}: {tally:?}");
        assert!(tally.right > 0 && tally.with_settings > 0, "{name}, {key}: {tally:?}");
        let expected = if keys.len() == 1 && matches!(name, "haas" | "fanuc") { "thread_feed" } else { "output_units" };
        assert!(tally.taken.iter().any(|taken| taken.starts_with(expected)), "{name}, {key}: {tally:?}");
        let format = key.split(' ').next().unwrap_or_default();
        assert!(tally.taken.iter().any(|taken| taken.starts_with(format)), "{name}, {key}: {tally:?}");
    }
}

/// An inch part: a cut, an arc, deep holes, threads.
const PART: &str = "UNITS/INCHES
TOOL PATH/MILL,TOOL,EM
LOADTL/1,LENGTH,4
SPINDL/RPM,500,CLW
RAPID
GOTO/0.29527,0.1111,1,0,0,1
FEDRAT/15.62507,IPM
GOTO/0.29527,0.1111,-0.1234
CIRCLE/0.7071,0.1111,-0.1234,0,0,1,0.41183
GOTO/1.11893,0.1111,-0.1234
GOTO/1.23457,0.33333,-0.07407
RAPID
GOTO/1.23457,0.33333,1
CYCLE/DEEP,RAPTO,0.11811,FEDTO,-0.7,RTRCTO,0.29527,STEP,0.15748,IPM,7.87402
GOTO/0.41339,0.57087,0
GOTO/0.61024,0.57087,0
CYCLE/OFF
CYCLE/TAP,RAPTO,0.2,FEDTO,-0.7,RTRCTO,0.4,TPI,26
GOTO/0.41339,0.57087,0
CYCLE/OFF
RAPID
GOTO/0,0,2
FINI
";

/// Edits of the part, with configuration, that are refused or remarked on.
const FAULTS: [(&str, &str, &str); 12] = [
    ("FEDRAT/15.62507", "FEDRAT/0.0000123", ""),
    ("FEDRAT/15.62507", "FEDRAT/0.123457", "formats.feed_inch = 0\n"),
    ("FEDRAT/15.62507", "FEDRAT/15625.07", "formats.feed_whole = 4\n"),
    ("FEDRAT/15.62507,IPM", "FEDRAT/123.4567,IPR", ""),
    ("0,0,1,0.41183", "0,0,1,0.43183", ""),
    ("CIRCLE/0.7071,0.1111,-0.1234", "CIRCLE/0.7071,0.1111,-0.3234", ""),
    ("GOTO/1.11893,0.1111,-0.1234", "GOTO/1.12893,0.1111,-0.1234", ""),
    ("", "", "floor = -0.7\n"),
    ("", "", "limits = { X = [-1.27, 1.27] }\n"),
    ("", "", "limits = { X = [-1.27, 1.27] }\nmachine_zero = { X = 19.05 }\n"),
    ("STEP,0.15748", "STEP,0.0000123", ""),
    ("", "", "operations.1.largest_feed = 300.7\n"),
];

/// Whether a text has a number of more than nine significant digits, as binary arithmetic leaves them.
fn has_noise(text: &str) -> bool {
    text.split(|c: char| !c.is_ascii_digit() && c != '.').any(|number| {
        let digits = number.replace('.', "");
        digits.trim_start_matches('0').len() > 9
    })
}

/// A text without what is quoted in it.
fn without_quoted(text: &str) -> String {
    text.split('`').step_by(2).collect()
}

/// The text is in inches and has no noise.
fn is_in_inches(text: &str, at: &str) {
    assert!(!has_noise(text), "{at}: {text}");
    let millimetres = without_quoted(text).split([' ', ',', ';', ':']).any(|word| matches!(word, "mm" | "mm/min"));
    assert!(!millimetres, "{at}: {text}");
}

#[test]
fn messages_about_an_inch_file_are_in_inches_without_noise() {
    let mut refused = 0;
    for name in by_name::controls() {
        let control = by_name::control(name);
        for (before, after, keys) in FAULTS {
            let text = format!("mode = 'axes'\npart_origin = [0.0, 0.0, 60.0]\nlength_guard = false\n{keys}");
            let config = starting_point(control).read_over(&SpinnerU5620::default(), &text);
            let config = config.unwrap_or_else(|faults| panic!("{faults:?}"));
            let cl = PART.replace(before, after);
            let (_, report) =
                written::<SpinnerU5620>(&config, control, &cl).unwrap_or_else(|error| panic!("{error:?}"));
            assert!(report.failed || keys.is_empty() && name == "heidenhain", "{name}: {before} => {after}, {keys}");
            for found in &report.diagnostics {
                eprintln!("{name}: {}", found.text);
                is_in_inches(&found.text, name);
                assert!(!has_noise(found.help.as_deref().unwrap_or_default()), "{found:?}");
                refused += 1;
            }
        }
    }
    assert!(refused > 40, "{refused}");
}

#[test]
fn findings_about_an_inch_program_are_in_inches_without_noise() {
    let mut texts = 0;
    for name in by_name::controls() {
        let control = by_name::control(name);
        let keys = [("formats.".to_owned(), "pitch_inch = 6".to_owned())];
        let config = config(control, &keys);
        let program = tests::posting::posted::<SpinnerU5620>(&config, control, PART);
        // The digest of the kinematics has no lengths.
        let lines = program.lines().enumerate().filter(|(_, line)| !line.contains("KINEMATICS"));
        for (from, line) in lines.map(|(index, line)| (index, line.to_owned())) {
            // The last digit of each number, one at a time.
            let digits = line.char_indices().filter(|(at, c)| {
                c.is_ascii_digit() && !line[at + 1..].starts_with(|c: char| c.is_ascii_digit() || c == '.')
            });
            for (at, digit) in digits {
                let other = if digit == '9' { '1' } else { '9' };
                let edited = format!("{}{other}{}", &line[..at], &line[at + 1..]);
                let lines =
                    program.lines().enumerate().map(|(index, line)| if index == from { &*edited } else { line });
                let program: String = lines.flat_map(|line| [line, "\n"]).collect();
                for text in findings::<SpinnerU5620>(&config, control, PART, &program) {
                    is_in_inches(&text, &format!("{name}: {line} => {edited}"));
                    texts += 1;
                }
            }
        }
    }
    assert!(texts > 500, "{texts}");
}

/// Arcs with coarse words, of a circle on the grid and of one off it, flat and as helices: written so that the check
/// accepts them.
#[test]
fn arcs_with_two_decimals_of_an_inch_pass_their_check() {
    let mut arcs = 0;
    for name in by_name::controls() {
        let control = by_name::control(name);
        for (x, y, radius, rise) in [
            (0.5, 0.25, 0.75, 0.0),
            (0.7171, 0.1111, 0.5274, 0.0),
            (0.5, 0.25, 0.75, -0.05),
            (0.127, 0.33, 1.111, -0.0333),
        ] {
            let mut cl = format!(
                "UNITS/INCHES\nTOOL PATH/MILL,TOOL,EM\nLOADTL/1,LENGTH,4\nSPINDL/RPM,3000,CLW\nRAPID\n\
                 GOTO/{},{y},1,0,0,1\nFEDRAT/20,IPM\nGOTO/{},{y},-0.1\n",
                x + radius,
                x + radius
            );
            for (index, (i, j)) in [(0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, 0.0)].into_iter().enumerate() {
                let z = -0.1 + rise * (index + 1) as f64;
                let (to_x, to_y) = (x + radius * i, y + radius * j);
                cl += &format!("CIRCLE/{x},{y},{z},0,0,1,{radius}\nGOTO/{to_x:.5},{to_y:.5},{z:.5}\n");
            }
            cl += "RAPID\nGOTO/0,0,2\nFINI\n";
            for (tolerance, form) in [(0.01, "centre"), (0.3, "centre"), (0.3, "radius"), (1.0, "radius")] {
                let keys = [
                    ("formats.".to_owned(), "linear_inch = 2".to_owned()),
                    (String::new(), format!("tolerance = {tolerance}")),
                    ("arcs.".to_owned(), format!("form = '{form}'")),
                    ("cl.".to_owned(), "circle_sense = 'ccw'".to_owned()),
                ];
                let config = config(control, &keys);
                let program = tests::posting::posted::<SpinnerU5620>(&config, control, &cl);
                arcs += bare(&program)
                    .iter()
                    .filter(|line| {
                        line.split(' ').any(|word| matches!(word, "G2" | "G3" | "G02" | "G03" | "CC" | "CR"))
                    })
                    .count();
            }
        }
    }
    assert!(arcs > 50, "{arcs}");
}
