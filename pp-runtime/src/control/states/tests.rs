//! Rows of the table, their reasons, and what the check asks for beside them.

use super::{ProgramUses, StateHandling, conditions, from_memory, of};
use crate::control::layout::FramesUsed;
use crate::control::options::ControlOptions;
use crate::control::{CONTROLS, ControlFunction, MillTurn, ToolSpindle};

/// Most rows of a control that are from memory.
const MOST_FROM_MEMORY: usize = 8;

#[test]
fn every_control_has_its_states_and_few_are_from_memory() {
    for control in CONTROLS {
        let name = control.spellings().name;
        assert!(of(name).len() > 10, "{name}");
        assert!(from_memory(name) <= MOST_FROM_MEMORY, "{name}: {}", from_memory(name));
    }
}

#[test]
fn a_row_of_a_later_way_has_the_reason_why_no_way_before_it_is_possible() {
    for control in CONTROLS {
        for row in of(control.spellings().name) {
            let first = matches!(row.by, StateHandling::InWord(_) | StateHandling::Set(_));
            assert_eq!(first, row.reason.is_empty(), "{}: {}", control.spellings().name, row.name);
        }
    }
}

#[test]
fn codes_that_the_table_sets_are_in_the_blocks_of_a_restart_point() {
    for control in CONTROLS {
        let codes = control.spellings();
        for row in of(codes.name) {
            let written = |code: &str| {
                let blocks = codes.safety.iter().copied().chain(codes.cancels.iter().map(|cancel| cancel.block));
                blocks.into_iter().any(|block| block == code || block.split(' ').any(|word| word == code))
            };
            match row.by {
                StateHandling::Set(code) if !code.contains([' ', ',']) => {
                    assert!(written(code), "{}: {code}", codes.name)
                }
                StateHandling::SetWhere(function, code) => {
                    let reset = codes.plane.as_ref().is_some_and(|plane| plane.reset.contains(&code));
                    let offset =
                        codes.tip.as_ref().and_then(|tip| tip.dynamic_offset).is_some_and(|[_, off]| off == code);
                    let cancel = codes.cancels.iter().any(|cancel| cancel.block == code && cancel.of == function);
                    assert!(reset || offset || cancel, "{}: {code}", codes.name);
                }
                _ => {}
            }
        }
    }
}

#[test]
fn what_no_word_code_or_guard_deals_with_is_a_condition() {
    let uses = |on: bool| ProgramUses {
        rotary: true,
        frames: FramesUsed { tip_control: true, planes: true, dynamic_offset: true },
        compensation: true,
        cycles: true,
        offset_guard: on,
        length_guard: on,
    };
    let options = |functions: &[ControlFunction]| ControlOptions {
        functions: Some(functions.to_vec()),
        ..ControlOptions::default()
    };
    for control in CONTROLS {
        let name = control.spellings().name;
        let stated = |functions: &[ControlFunction], guards: bool| {
            conditions(*control, &options(functions), &uses(guards)).join("\n")
        };
        let (bare, guarded) = (stated(&[], false), stated(&[], true));
        for row in of(name) {
            match row.by {
                StateHandling::Stated(condition) => assert!(guarded.contains(condition), "{name}: {condition}"),
                StateHandling::StatedUnless(_, condition) => {
                    let mill_turn = MillTurn {
                        radius: Some("CODE".to_owned()),
                        modes: Vec::new(),
                        spindle: ToolSpindle::Number(3),
                    };
                    let settled = |linear_rapids, mill_turn: Option<MillTurn>| {
                        let options = ControlOptions { linear_rapids, mill_turn, ..options(&[]) };
                        !conditions(*control, &options, &uses(true)).join("\n").contains(condition)
                    };
                    let all = [
                        settled(None, None),
                        settled(Some(true), None),
                        settled(Some(false), None),
                        settled(None, Some(mill_turn)),
                    ];
                    assert!(all.contains(&true) && all.contains(&false), "{name}: {condition}");
                }
                StateHandling::Compared(_, condition) => {
                    assert!(bare.contains(condition) && !guarded.contains(condition), "{name}: {condition}");
                }
                StateHandling::SetWhere(function, code) => {
                    // Frames that a program uses are ended whatever is listed.
                    let usual = control.spellings().cancels.iter().any(|cancel| cancel.of == function);
                    let used = !usual
                        && matches!(
                            function,
                            ControlFunction::TipControl | ControlFunction::Planes | ControlFunction::DynamicOffset
                        );
                    assert!(used || bare.contains(row.name), "{name}: {code}");
                    assert!(!stated(&[function], true).contains(row.name), "{name}: {code}");
                }
                StateHandling::InWord(_) | StateHandling::Set(_) | StateHandling::Noted(_) => {}
            }
        }
    }
}
