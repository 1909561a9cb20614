//! Any bytes are read as CL data, with every option that changes the meaning of records.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pp_runtime::set_up::ClPoint;
use pp_runtime::cl::record::ClCycleKind;
use pp_runtime::cl::{ClReader, CycleArg, Dialect, FeedLabel, Frames, Insert, ReadingOptions, Sense, ToolArg};
use pp_runtime::program::{Event, ToolMotion, Units};

/// No dialect, and every dialect.
fn dialects() -> impl Iterator<Item = Option<Dialect>> {
    std::iter::once(None).chain(Dialect::NAMES.into_iter().map(|(_, dialect)| Some(dialect)))
}

/// Options that the first two bytes select.
fn options(choice: [u8; 2]) -> ReadingOptions {
    let bit = |index: usize| choice[index / 8] & (1 << (index % 8)) != 0;
    ReadingOptions {
        units: bit(0).then_some(Units::Millimetres),
        dialect: dialects().nth(usize::from(choice[1] >> 4) % dialects().count()).flatten(),
        columns: bit(1).then_some(72),
        inert: if bit(2) { vec!["BREAK".to_owned()] } else { Vec::new() },
        frames: [Frames::Refuse, Frames::Main][usize::from(choice[0] >> 3) % 2],
        insert: if bit(6) { Insert::Comment } else { Insert::Write },
        insert_stop: bit(7),
        feed_label: if bit(8) { FeedLabel::FileUnits } else { FeedLabel::Refuse },
        from_move: bit(9),
        cl_point: if bit(10) { ClPoint::Centre } else { ClPoint::Tip },
        trans_adds: bit(11),
        circle_sense: [None, None, Some(Sense::Clockwise), Some(Sense::CounterClockwise)][usize::from(choice[0] >> 4) % 4],
        tool_args: if bit(3) { vec![ToolArg::Ignored, ToolArg::Length, ToolArg::Offset] } else { Vec::new() },
        cycle_args: if bit(5) { cycle_args() } else { Vec::new() },
        default_feed_mm_per_min: bit(9).then_some(500.0),
        auxfun: vec![1, 10],
        prefun: vec![4, 64],
        ..ReadingOptions::default()
    }
}

/// Meaning of two and three numbers without a word.
fn cycle_args() -> Vec<(ClCycleKind, Vec<CycleArg>)> {
    vec![
        (ClCycleKind::Tap, vec![CycleArg::Depth, CycleArg::Pitch]),
        (ClCycleKind::Drill, vec![CycleArg::Depth, CycleArg::Clearance, CycleArg::Dwell]),
        (ClCycleKind::Deep, vec![CycleArg::Depth, CycleArg::Step, CycleArg::Return]),
    ]
}

fuzz_target!(|data: &[u8]| {
    let Some((choice, text)) = data.split_first_chunk::<2>() else { return };
    let mut reader = ClReader::new(text, options(*choice));
    while let Some((place, event)) = reader.next_event().expect("memory is readable") {
        assert!(place.line >= 1 && place.column >= 1);
        if let Event::Motion(ToolMotion::Move(motion)) = event {
            assert!(motion.pose.tip.iter().all(|value| value.is_finite()));
            assert!((motion.pose.axis.norm() - 1.0).abs() < 1e-9);
        }
        if let Event::Motion(ToolMotion::Arc(arc)) = event {
            assert!(arc.angle_rad.is_finite() && arc.angle_rad > 0.0);
        }
    }
    for found in reader.diagnostics() {
        assert!(found.location.line >= 1 && found.location.column >= 1 && found.length >= 1);
    }
});
