//! Any bytes are read as CL data, with every option that changes the meaning of records.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pp_runtime::set_up::ClPoint;
use pp_runtime::cl::{ClReader, Dialect, FeedLabel, Frames, Insert, ReadingOptions};
use pp_runtime::program::{Event, Units};

/// Options that the first two bytes select.
fn options(choice: [u8; 2]) -> ReadingOptions {
    let bit = |index: usize| choice[index / 8] & (1 << (index % 8)) != 0;
    let dialects =
        [None, Some(Dialect::Nx), Some(Dialect::SolidWorks), Some(Dialect::Creo), Some(Dialect::Catia), Some(Dialect::Iso)];
    ReadingOptions {
        units: bit(0).then_some(Units::Millimetres),
        dialect: dialects[usize::from(choice[1] >> 5) % dialects.len()],
        columns: bit(1).then_some(72),
        inert: if bit(2) { vec!["BREAK".to_owned()] } else { Vec::new() },
        frames: [Frames::Refuse, Frames::Main][usize::from(choice[0] >> 3) % 2],
        insert: if bit(6) { Insert::Comment } else { Insert::Write },
        insert_stop: bit(7),
        feed_label: if bit(8) { FeedLabel::FileUnits } else { FeedLabel::Refuse },
        from_move: bit(9),
        cl_point: if bit(10) { ClPoint::Centre } else { ClPoint::Tip },
        auxfun: vec![1, 10],
        prefun: vec![4, 64],
        ..ReadingOptions::default()
    }
}

fuzz_target!(|data: &[u8]| {
    let Some((choice, text)) = data.split_first_chunk::<2>() else { return };
    let mut reader = ClReader::new(text, options(*choice));
    while let Some((place, event)) = reader.next_event().expect("memory is readable") {
        assert!(place.line >= 1 && place.column >= 1);
        if let Event::Move(motion) = event {
            assert!(motion.pose.tip.iter().all(|value| value.is_finite()));
            assert!((motion.pose.axis.norm() - 1.0).abs() < 1e-9);
        }
        if let Event::Arc(arc) = event {
            assert!(arc.angle_rad.is_finite() && arc.angle_rad > 0.0);
        }
    }
    for found in reader.diagnostics() {
        assert!(found.location.line >= 1 && found.location.column >= 1 && found.length >= 1);
    }
});
