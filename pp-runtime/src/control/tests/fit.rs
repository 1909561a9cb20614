//! Settings that a control does not support.

use super::*;
use crate::config::sample::Sample;
use crate::config::{Config, starting_point};
use crate::motion::{PathNorm, Smoothing, TcpWords};
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
    assert_eq!([&Fanuc as &dyn Control, &Haas, &Siemens].map(|control| faults(control, number).len()), [1, 0, 1]);
    let inverse: fn(&mut Config) = |config| config.control.path_norm = Some(PathNorm::G93Minutes);
    assert_eq!(faults(&Heidenhain, inverse).len(), 1);
    assert_eq!(faults(&Heidenhain, |config| config.control.program.line_numbers = Some(10)).len(), 1);
    assert_eq!(faults(&LinuxCnc, |config| config.control.smoothing = Smoothing::Rough).len(), 1);
    let gauge: fn(&mut Config) = |config| config.set_up.length_mode = crate::set_up::LengthMode::Gauge;
    let length = "Heidenhain TNC activates the tool length in every tool call: set `length_mode = \"tip\"`";
    assert_eq!(faults(&Heidenhain, gauge), [length]);
    assert_eq!(faults(&Fanuc, gauge), Vec::<String>::new());
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
