//! Threads with F per revolution: their blocks on the controls whose cycle takes an F, and a check that finds another
//! feed mode.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::Control;
use tests::by_name;
use tests::posting::{findings, posted};

/// Two threads and a hole, a cut before and after them.
const CL: &str = "UNITS/MM
TOOL PATH/TAPS,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,500,CLW
RAPID
GOTO/0,0,30,0,0,1
FEDRAT/MMPM,300
GOTO/0,0,20
CYCLE/TAP,RAPTO,3,FEDTO,-8,RTRCTO,10,MMPR,1.25
GOTO/0,0,10
GOTO/10,0,10
CYCLE/OFF
CYCLE/DRILL,RAPTO,3,FEDTO,-8,RTRCTO,10,MMPM,200
GOTO/20,0,10
CYCLE/OFF
FEDRAT/MMPM,300
GOTO/20,0,25
RAPID
GOTO/20,0,60
FINI
";

fn config(control: &dyn Control, feed: &str, rigid: bool) -> Config {
    let text = format!("mode = 'axes'\n[cycles]\nthread_feed = '{feed}'\nrigid = {rigid}\n");
    starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

#[test]
fn f_of_a_thread_is_its_pitch_in_feed_per_revolution() {
    for (name, rigid) in [("fanuc", true), ("fanuc", false), ("haas", true)] {
        let control = by_name::control(name);
        let [per_minute, config] = ["minute", "revolution"].map(|feed| config(control, feed, rigid));
        let program = posted::<SpinnerU5620>(&config, control, CL);
        let lines: Vec<&str> = program.lines().collect();
        let thread =
            lines.iter().position(|line| line.starts_with("G95 G98 G84 ")).unwrap_or_else(|| panic!("{program}"));
        assert!(lines[thread].ends_with(" F1.25"), "{program}");
        assert_eq!(lines[thread + 1..thread + 3], ["X10.", "G94 G80"], "{program}");
        for (before, after) in [("G95 G98", "G94 G98"), ("G95 G98", "G98"), ("G94 G80", "G80"), ("F1.25", "F1.5")] {
            let edited = program.replace(before, after);
            assert_ne!(edited, program);
            assert!(
                !findings::<SpinnerU5620>(&config, control, CL, &edited).is_empty(),
                "{before} -> {after}\n{edited}"
            );
        }
        let plain = posted::<SpinnerU5620>(&per_minute, control, CL);
        assert!(!plain.contains("G95"), "{plain}");
        assert!(
            !findings::<SpinnerU5620>(&config, control, CL, &plain).is_empty()
                && !findings::<SpinnerU5620>(&per_minute, control, CL, &program).is_empty()
        );
    }
}

#[test]
fn controls_that_take_the_pitch_refuse_it() {
    for name in ["linuxcnc", "siemens", "heidenhain"] {
        let control = by_name::control(name);
        let config = config(control, "revolution", true);
        let unfit = config.unfit(&SpinnerU5620::default(), control).join("\n");
        assert!(unfit.contains("take their pitch in any case: leave `cycles.thread_feed` out"), "{unfit}");
    }
}
