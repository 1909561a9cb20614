//! Modal words: left out while in force, written again after events that may change them.

use proptest::prelude::*;

use super::reader::{Motion, motions};
use super::*;

#[test]
fn a_block_in_which_nothing_changes_is_not_written() {
    let feed = FeedWord::InverseTime(Decimal { units: 5, decimals: 0 });
    for control in CONTROLS {
        let same = words([1, 2, 3, 4]);
        let blocks = [Step::Rapid { words: same }, Step::Feed { words: same, feed }, Step::Rapid { words: same }];
        assert_eq!(steps(*control, &layout(), &blocks).len(), 1);
    }
}

#[test]
fn everything_is_written_again_after_a_restart_a_stop_and_a_block_of_the_cl_data() {
    let feed = Step::Feed { words: words([0; 4]), feed: per_minute(100) };
    for between in
        [Step::Stop { optional: false }, Step::Raw { text: b"M64" }, Step::Restart { number: 7, changes_tool: false }]
    {
        for control in CONTROLS {
            let text = steps(*control, &layout(), &[feed, between, feed]);
            let (first, last) = (&text[0], &text[text.len() - 1]);
            for word in first.split(' ').filter(|word| word.starts_with(['X', 'Z', 'A', 'C', 'F', 'R'])) {
                assert!(last.contains(word), "{word} after {between:?}: {text:#?}");
            }
        }
    }
    assert_eq!(
        steps(&LinuxCnc, &layout(), &[feed, Step::Restart { number: 7, changes_tool: false }, feed]),
        ["G94 G1 X0 Z0 A0 C0 F100", "N7 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G55 G64 P0.01", "G1 X0 Z0 A0 C0 F100"]
    );
}

fn any_step() -> impl Strategy<Value = Step<'static>> {
    let few = || prop::array::uniform4(-2_i64..3);
    prop_oneof![
        6 => (few(), 1_i64..3).prop_map(|(to, feed)| Step::Feed { words: words(to), feed: per_minute(feed) }),
        3 => (few(), 1_i64..3).prop_map(|(to, feed)| Step::Feed {
            words: words(to),
            feed: FeedWord::InverseTime(Decimal { units: feed, decimals: 1 }),
        }),
        4 => (few(), 1_u16..16).prop_map(|(to, mask)| Step::Rapid { words: only(mask, to) }),
        1 => few().prop_map(|to| Step::Machine { words: only(0b0100, to) }),
        1 => Just(Step::Restart { number: 3, changes_tool: false }),
        1 => Just(Step::PerMinute),
        1 => Just(Step::Tool { number: 2, offset: 2, next: None, speed: None, radius_delta: None, change: true }),
        1 => Just(Step::Length { offset: 2 }),
        1 => Just(Step::Stop { optional: false }),
        1 => Just(Step::CoolantOff),
    ]
}

proptest! {
    /// Leaving out modal words changes no motion: with every word in every block the motions are the same.
    #[test]
    fn every_word_in_every_block_is_the_same_motion(blocks in prop::collection::vec(any_step(), 1..40)) {
        for control in CONTROLS {
            // The planner uses no inverse time on a control that has none.
            let no_inverse = control.spellings().inverse_time.is_none();
            let blocks: Vec<Step<'_>> = blocks.iter().filter(|step| {
                !(no_inverse && matches!(step, Step::PerMinute | Step::Feed { feed: FeedWord::InverseTime(_), .. }))
            }).copied().collect();
            let modal = steps(*control, &layout(), &blocks);
            let every_word = ControlOptions { every_word: true, ..ControlOptions::default() };
            let full = steps(*control, &layout_with(every_word), &blocks);
            prop_assert_eq!(motions(&modal), motions(&full), "{:#?}\n{:#?}", modal, full);
            prop_assert!(modal.iter().map(String::len).sum::<usize>() <= full.iter().map(String::len).sum::<usize>());
        }
    }

    /// All controls move the machine in the same way.
    #[test]
    fn every_control_writes_the_same_motions(blocks in prop::collection::vec(any_step(), 1..40)) {
        let blocks: Vec<Step<'_>> = blocks.into_iter().filter(|step| {
            !matches!(step, Step::Length { .. } | Step::PerMinute | Step::Feed { feed: FeedWord::InverseTime(_), .. })
        }).collect();
        let read = CONTROLS.iter().map(|control| motions(&steps(*control, &layout(), &blocks)));
        let read: Vec<Vec<Motion>> = read.collect();
        for other in &read[1..] {
            prop_assert_eq!(&read[0], other);
        }
    }
}

#[test]
fn f_is_written_again_where_tip_control_or_a_plane_has_begun() {
    let angles = [Decimal { units: 30, decimals: 0 }; 3];
    let plane = Step::Plane { angles, pose: Some(true) };
    let cut = |x| Step::Feed { words: only(0b1100, [0, 0, 0, x]), feed: per_minute(800) };
    for (tip_control, on, off) in
        [(true, Step::TipControl { on: true }, Step::TipControl { on: false }), (false, plane, Step::PlaneOff)]
    {
        let blocks = [
            Step::Restart { number: 1, changes_tool: false },
            Step::Length { offset: 6 },
            on,
            cut(1),
            cut(2),
            off,
            on,
            cut(3),
            cut(4),
        ];
        for control in CONTROLS.iter().filter(|control| control.spellings().tip.is_some()) {
            let lines = steps(
                *control,
                &Layout { frames: FramesUsed { tip_control, planes: !tip_control, dynamic_offset: false }, ..layout() },
                &blocks,
            );
            let with_f = lines.iter().filter(|line| line.contains("F800")).count();
            assert_eq!(with_f, 2, "{lines:#?}");
        }
    }
}
