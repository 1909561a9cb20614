//! Settings that a control does not support.

use super::*;
use crate::config::sample::Sample;
use crate::config::{Config, starting_point};
use crate::options::{OperationChoice, OperationEntry, OperationSettings, PathNorm, Smoothing, TcpWords};
use crate::set_up::FurtherSetUp;

fn further(offset: &str) -> FurtherSetUp {
    FurtherSetUp { frames: vec![2], work_offset: Some(offset.to_owned()), ..FurtherSetUp::default() }
}

#[test]
fn settings_that_a_control_does_not_support_are_refused() {
    let faults = |control: &dyn Control, change: fn(&mut Config)| {
        let mut config = starting_point(control);
        change(&mut config);
        unfit(&Sample::default(), control, config.demands())
    };
    for control in CONTROLS {
        assert_eq!(faults(*control, |_| {}), Vec::<String>::new());
        assert_eq!(faults(*control, |config| config.set_up.work_offset = "G53".into()).len(), 1);
        assert_eq!(faults(*control, |config| config.set_up.set_ups = BTreeMap::from([(2, further("G999"))])).len(), 1);
        assert_eq!(faults(*control, |config| config.control.axes = BTreeMap::from([('C', "c?".to_owned())])).len(), 1);
        assert_eq!(faults(*control, |config| config.control.program.start = vec!["M".repeat(600)]).len(), 1);
    }
    let long_name: fn(&mut Config) = |config| config.control.axes = BTreeMap::from([('C', "C1".to_owned())]);
    assert_eq!(faults(&Fanuc, long_name).len(), 1);
    assert_eq!(faults(&Siemens, long_name).len(), 0);
    let number: fn(&mut Config) = |config| config.control.program_number = Some(12_345);
    assert_eq!([&Fanuc as &dyn Control, &Haas, &Siemens].map(|control| faults(control, number).len()), [1, 0, 0]);
    let gauge: fn(&mut Config) = |config| config.set_up.length_mode = crate::set_up::LengthMode::Gauge;
    let length = "Heidenhain TNC activates the tool length in every tool call: set `length_mode = \"tip\"`";
    assert_eq!(faults(&Heidenhain, gauge), [length]);
    assert_eq!(faults(&Fanuc, gauge), Vec::<String>::new());
}

/// One file for several controls: what each lacks is left out and named, and what it has stays.
#[test]
fn settings_that_a_program_does_without_are_left_out_where_the_control_lacks_them() {
    let mut all = Config::default();
    all.control.smoothing = Smoothing::Finish;
    all.control.smoothing_levels = Some([1, 5, 10]);
    all.control.smoothing_angle_rad = Some(0.001);
    all.control.program_number = Some(1234);
    all.control.file_header = true;
    all.control.program.line_numbers = BlockNumbers::Step(10);
    all.control.tool_names = true;
    all.control.swivel_data = Some("TABLE".to_owned());
    all.control.posture_word = false;
    all.control.path_norm = Some(PathNorm::G93Minutes);
    let functions = vec![ControlFunction::TipControl, ControlFunction::Planes, ControlFunction::DynamicOffset];
    all.control.functions = Some(functions);
    let entry = OperationEntry {
        of: OperationChoice::Number(2),
        settings: OperationSettings { smoothing: Some(Smoothing::Rough), ..OperationSettings::default() },
    };
    all.motion.operations.entries.push(entry);
    let left_out = |control: &dyn Control| {
        let on_control = all.for_control(control);
        assert_eq!(on_control.for_control(control), on_control, "nothing is left out twice");
        let title = control.spellings().title;
        assert!(on_control.left_out.iter().all(|sentence| sentence.contains(title)), "{:?}", on_control.left_out);
        let keys = [
            "has no smoothing levels",
            "smoothing_levels",
            "smoothing_angle",
            "program_number",
            "file_header",
            "line_numbers",
            "tool_names",
            "swivel_data",
            "path_norm",
            "posture_word",
            "`tip_control`",
            "`planes`",
            "`dynamic_offset`",
        ];
        let named = |key: &&&str| on_control.left_out.iter().any(|sentence| sentence.contains(**key));
        let named: Vec<&str> = keys.iter().filter(named).copied().collect();
        assert_eq!(named.len(), on_control.left_out.len(), "each has one sentence: {:?}", on_control.left_out);
        named.join(" ")
    };
    assert_eq!(
        left_out(&LinuxCnc),
        "has no smoothing levels smoothing_levels program_number file_header tool_names swivel_data posture_word `tip_control` `planes` \
         `dynamic_offset`"
    );
    assert_eq!(left_out(&Fanuc), "smoothing_angle file_header tool_names swivel_data `dynamic_offset`");
    assert_eq!(left_out(&Haas), "smoothing_levels smoothing_angle file_header tool_names swivel_data posture_word");
    assert_eq!(left_out(&Siemens), "smoothing_levels program_number posture_word `dynamic_offset`");
    assert_eq!(
        left_out(&Heidenhain),
        "smoothing_levels program_number file_header line_numbers swivel_data path_norm posture_word `dynamic_offset`"
    );
    let linuxcnc = all.for_control(&LinuxCnc);
    assert_eq!(linuxcnc.motion.operations.entries[0].settings, OperationSettings::default());
    assert_eq!(all.for_control(&Siemens).control.smoothing, Smoothing::Finish);
}

/// On Siemens the tool length would apply along another axis in another plane. In G43.5 I J K are the tool axis vector.
#[test]
fn no_arc_is_written_where_its_plane_or_its_centre_has_another_meaning() {
    let planes = |control: &dyn Control, mode, tcp_words| {
        let mut config = starting_point(control);
        config.motion.mode = mode;
        config.motion.tip.tcp_words = tcp_words;
        let abilities = abilities(control, config.demands());
        (abilities.arc_planes, abilities.vectors_take_arc_words)
    };
    let (all, only) = ([true; 3], [false, false, true]);
    assert_eq!(planes(&Siemens, Mode::Axes, TcpWords::Angles), (only, false));
    assert_eq!(planes(&Siemens, Mode::Tcp, TcpWords::Vectors), (only, false));
    assert_eq!(planes(&Fanuc, Mode::Tcp, TcpWords::Vectors), (all, true));
    assert_eq!(planes(&Heidenhain, Mode::Tcp, TcpWords::Vectors), (only, false));
}
