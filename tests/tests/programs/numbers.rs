//! Block numbers, the header and the comments of operations, as the configuration selects them.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use tests::posting::{self, bare};

/// Three operations, the second with the tool of the first.
const CL: &str = "UNITS/MM
TOOL PATH/FACE,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
RAPID
GOTO/0,0,30,0.5,0,0.8660254
FEDRAT/MMPM,300
GOTO/0,0,20
RAPID
GOTO/0,0,60
TOOL PATH/WALL,TOOL,T
RAPID
GOTO/0,0,30,0,0,1
GOTO/0,0,20
GOTO/0,0,60
TOOL PATH/SLOT,TOOL,U
LOADTL/2,LENGTH,110
SPINDL/RPM,1000,CLW
RAPID
GOTO/0,0,30,0,0,1
GOTO/0,0,20
GOTO/0,0,60
FINI
";

fn config(control: &dyn Control, keys: &str) -> Config {
    let text = format!("mode = 'axes'\npart_origin = [0.0, 0.0, 0.0]\n[program]\n{keys}\n");
    starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// The program, which passes its check.
fn posted(control: &'static dyn Control, keys: &str) -> String {
    posting::posted::<SpinnerU5620>(&config(control, keys), control, CL)
}

/// Controls whose blocks may do without a number.
fn with_n() -> impl Iterator<Item = &'static dyn Control> {
    control::CONTROLS.iter().copied().filter(|control| !control.spellings().numbers_every_line)
}

/// Numbers in the order of their blocks.
fn numbers(program: &str) -> Vec<&str> {
    let words = program.lines().filter_map(|line| line.split(' ').next());
    words.filter(|word| word.starts_with('N') && word[1..].bytes().all(|byte| byte.is_ascii_digit())).collect()
}

#[test]
fn blocks_have_numbers_where_the_configuration_asks_for_them() {
    for control in with_n() {
        let plain = posted(control, "");
        assert_eq!(numbers(&plain), ["N1", "N2", "N3"], "{plain}");
        assert_eq!(posted(control, "line_numbers = 'restarts'"), plain);
        let changes = posted(control, "line_numbers = 'tool_changes'");
        assert_eq!(numbers(&changes), ["N1", "N2"], "{changes}");
        assert_eq!(changes.replace("N1 ", "").replace("N2 ", ""), posted(control, "line_numbers = 'none'"));
        assert_eq!(numbers(&posted(control, "line_numbers = 'none'")), [""; 0]);
        let every = posted(control, "line_numbers = 10");
        let blocks = every
            .lines()
            .filter(|line| !line.starts_with(['(', ';', '%', 'O', 'M', 'o', 'I', 'E']) || line.starts_with("M9"));
        for (index, block) in blocks.enumerate() {
            assert!(block.starts_with(&format!("N{} ", 10 * (index + 1))), "{block}\n{every}");
        }
    }
    let heidenhain = control::by_name("heidenhain").expect("a control");
    for keys in ["line_numbers = 'none'", "line_numbers = 'tool_changes'", "line_numbers = 10"] {
        let program = posted(heidenhain, keys);
        assert!(program.contains("Heidenhain TNC numbers every line"), "{program}");
    }
}

#[test]
fn a_number_of_another_kind_is_refused() {
    let control = control::by_name("fanuc").expect("a control");
    for keys in ["line_numbers = 'all'", "line_numbers = 0", "line_numbers = true", "header = 'long'"] {
        let text = format!("[program]\n{keys}\n");
        assert!(starting_point(control).read_over(&SpinnerU5620::default(), &text).is_err(), "{keys}");
    }
}

#[test]
fn a_short_header_has_the_set_up_and_the_tools() {
    for control in control::CONTROLS {
        let [full, short] = ["header = 'full'", "header = 'short'"].map(|keys| posted(*control, keys));
        assert_eq!(full, posted(*control, ""));
        let [full, short] = [bare(&full), bare(&short)];
        assert!(short.len() + 10 < full.len(), "{short:?}");
        let text = short.join("\n").to_uppercase();
        for wanted in ["SPINNERU5620", "WORK OFFSET", "T1 L100", "T2 L110", "DO NOT TOUCH OFF AGAIN", "MUST BE ZERO"] {
            assert!(text.contains(wanted), "{wanted}\n{text}");
        }
        for other in ["AXIS C", "KINEMATICS", "ASSUMED", "TOLERANCE"] {
            assert!(!text.contains(other), "{other}\n{text}");
        }
        // Nothing else differs.
        let left: Vec<&&str> = full.iter().filter(|line| !short.contains(line)).collect();
        assert!(left.iter().all(|line| line.starts_with(['(', ';'])), "{left:?}");
        let blocks = |lines: Vec<&str>| -> Vec<String> {
            lines.into_iter().filter(|line| !line.starts_with(['(', ';'])).map(str::to_owned).collect()
        };
        assert_eq!(blocks(full), blocks(short));
    }
}

#[test]
fn the_name_of_an_operation_comes_before_its_blocks_and_after_those_of_the_last() {
    for control in control::CONTROLS {
        let program = posted(*control, "");
        let lines: Vec<&str> = program.lines().collect();
        let named = |name: &str| {
            let of_operation = |line: &&str| {
                line.contains(name) && (line.contains("OPERATION ") || line.contains("MSG(") || line.contains("* - "))
            };
            lines.iter().position(of_operation).expect("a name")
        };
        let places = ["FACE", "WALL", "SLOT"].map(named);
        assert!(places.is_sorted(), "{program}");
        for at in places {
            let coolant_off = control.spellings().coolant_off;
            let next =
                lines[at + 1..].iter().position(|line| line.ends_with(coolant_off)).expect("M9 after safety lines");
            // Only the safety lines with their guard and the machine retract are between.
            assert!(next <= 14, "{next}\n{program}");
            let moves = |line: &&&str| line.contains('X') && !line.contains(['(', ';']);
            assert!(!lines[at + 1..at + 1 + next].iter().any(|line| moves(&line)), "{program}");
        }
    }
}
