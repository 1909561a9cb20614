//! Tables of the controls, and the list of controls.

use super::*;
use crate::control::template::{self, Field};

#[test]
fn every_control_states_what_no_two_of_them_share() {
    for control in CONTROLS {
        let Spellings { name, title, line_length, rotary_note, found_at, .. } = control.spellings();
        assert!(!name.is_empty() && !title.is_empty() && *line_length > 0 && !rotary_note.is_empty(), "{name}");
        assert!(!found_at.is_empty(), "{name}");
        let others = CONTROLS.iter().filter(|other| other.spellings().name.eq_ignore_ascii_case(name));
        assert_eq!(others.count(), 1, "{name} is the name of one control");
    }
}

#[test]
fn every_table_holds_fields_that_exist() {
    let more = [Field::Seconds, Field::Milliseconds, Field::Angle, Field::SmoothingLevel, Field::RotaryPath];
    let all = [template::OF_TOOL, &more].concat();
    for control in CONTROLS {
        let codes = control.spellings();
        let blocks = [codes.opening, codes.closing, codes.safety, codes.tool_change, codes.dwell, codes.smoothing_off];
        let single = [codes.length.code, codes.speed.unwrap_or_default(), codes.spindle[0], codes.spindle[1]];
        for block in blocks.into_iter().chain(codes.smoothing).chain([codes.blending]).flatten().copied().chain(single)
        {
            assert_eq!(template::check(block, &all), Ok(()), "{} {block}", codes.name);
        }
        if let Some(HoleCycles { form: CycleForm::Definitions(cycle), .. }) = &codes.cycles {
            let blocks = [cycle.drill, cycle.peck, cycle.chip_break, cycle.ream, cycle.fine_bore, cycle.thread];
            let plain = cycle.plain_drill.into_iter().flatten();
            for block in blocks.into_iter().flatten().chain(plain) {
                assert_eq!(template::check(block, template::OF_CYCLE), Ok(()), "{} {block}", codes.name);
            }
        }
        let number = if codes.numbers_every_line { 8 } else { 0 };
        assert!(codes.comment.length + codes.comment.marks.concat().len() + number <= codes.line_length);
        assert!(control.work_offset("G54").is_some(), "the default");
    }
}

#[test]
fn a_control_is_found_by_its_name_and_only_by_that() {
    assert_eq!(by_name("linuxcnc").map(|control| control.spellings().title), Some("LinuxCNC"));
    for control in CONTROLS {
        let name = control.spellings().name;
        assert_eq!(by_name(&name.to_uppercase()).map(|found| found.spellings().name), Some(name));
    }
    assert!(by_name("linux").is_none());
    assert!(by_name("").is_none());
}

#[test]
fn work_offsets_are_those_that_the_control_has() {
    let spelled = |control: &dyn Control, word: &str| control.work_offset(word).unwrap_or_default();
    assert_eq!(spelled(&LinuxCnc, "G59.3"), "G59.3");
    assert_eq!(["G54.1 P300", "G54.1 P301", "G59.1"].map(|word| spelled(&Fanuc, word)), ["G54.1 P300", "", ""]);
    assert_eq!(["G154 P99", "G154 P0", "G54.1 P1"].map(|word| spelled(&Haas, word)), ["G154 P99", "", ""]);
    assert_eq!(["G505", "G58", "G0505"].map(|word| spelled(&Siemens, word)), ["G505", "", ""]);
    assert_eq!(["G59", "12", "012"].map(|word| spelled(&Heidenhain, word)), ["6", "12", ""]);
}
