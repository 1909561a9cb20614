//! Set-ups for the targets that post or check: every control and mode, for the Spinner U5-620.

use std::io::Cursor;
use std::sync::LazyLock;

use machines::SpinnerU5620;
use pp_runtime::check::check;
use pp_runtime::cl::{Frames, Insert};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, CONTROLS, Control};
use pp_runtime::post::{Job, post};
use pp_runtime::program::{Rotation, Units};

/// Units of CL data without a UNITS record.
pub const UNITS: Option<Units> = Some(Units::Millimetres);

/// A control, and its configuration.
pub struct SetUp {
    pub control: &'static dyn Control,
    pub config: Config,
}

/// Lines of the configuration file for each mode.
const MODES: [&str; 3] = ["", "mode = 'tcp'\ntcp_frame = 'table_at_zero'\n", "mode = 'plane'\n"];

/// In the order of [`CONTROLS`], modes innermost; `None` where a control has no such mode.
static SET_UPS: LazyLock<Vec<Option<SetUp>>> = LazyLock::new(|| {
    let pairs = CONTROLS.iter().flat_map(|&control| MODES.map(|mode| (control, mode)));
    pairs.map(|(control, mode)| set_up(control, mode)).collect()
});

fn set_up(control: &'static dyn Control, mode: &str) -> Option<SetUp> {
    let mut config = starting_point(control).read_over(&SpinnerU5620::default(), mode).ok()?;
    config.motion.defaults.speed_rev_per_min = Some(3000.0);
    config.motion.defaults.rotation = Some(Rotation::Clockwise);
    config.motion.defaults.tool = Some(1);
    config.motion.retract.distance_mm = Some(50.0);
    config.cl.insert = Insert::Comment;
    config.cl.frames = Some(Frames::Main);
    config.output_units = UNITS;
    config.control.tip_control = control.spellings().tip.is_none().then(|| ["M428".to_owned(), "M429".to_owned()]);
    config.unfit(&SpinnerU5620::default(), control).is_empty().then_some(SetUp { control, config })
}

/// Set-up that the first byte selects, and the other bytes.
#[must_use]
pub fn chosen(data: &[u8]) -> Option<(&'static SetUp, &[u8])> {
    let (choice, rest) = data.split_first()?;
    let place = usize::from(choice.wrapping_sub(b'A')) % SET_UPS.len();
    Some((SET_UPS[place].as_ref()?, rest))
}

/// Line between a configuration file and CL data.
const SEPARATOR: &str = "\n=====\n";

/// Posts CL data with any configuration: the first byte selects the control, then the configuration file comes, a line
/// `=====`, and the CL data. A program that is written must be one whose check ends; it need not pass, since a
/// configuration may contain lines that the check cannot know.
pub fn post_with_any_configuration(data: &[u8]) {
    let Some((choice, rest)) = data.split_first() else { return };
    let Ok(text) = std::str::from_utf8(rest) else { return };
    let (toml, cl) = text.split_once(SEPARATOR).unwrap_or((text, CL_DATA));
    let control = CONTROLS[usize::from(choice.wrapping_sub(b'A')) % CONTROLS.len()];
    let machine = SpinnerU5620::default();
    let Ok(config) = starting_point(control).read_over(&machine, toml) else { return };
    if !config.unfit(&machine, control).is_empty() {
        return;
    }
    let job = Job { cl_name: "fuzz.cls", config: &config, control, units: UNITS };
    let mut program = Vec::new();
    let Ok(report) = post::<SpinnerU5620>(&job, &mut Cursor::new(cl), &mut program) else { return };
    if report.failed {
        return;
    }
    if let Ok(policy) = config.check_policy::<SpinnerU5620>(control, UNITS) {
        let _ends = check::<SpinnerU5620>(&policy, Cursor::new(cl), &program[..]);
    }
}

/// CL data for a configuration that comes alone.
const CL_DATA: &str = include_str!("all.cls");
