//! The table `[operations]`.

use crate::options::{OperationChoice, OperationSettings, OperationTable, Singular, Smoothing};

use super::*;

#[test]
fn settings_of_operations_are_read_by_number_name_and_pattern() {
    let config = read(
        "units = 'in'\n[operations.12]\nmode = 'plane'\nsingular = 'shortest'\n[operations.'Finish Blade']\ntolerance = \
         0.001\n[operations.'*.rough?']\nsmoothing = 'none'\nlargest_feed = 100\n",
    );
    let OperationTable { entries } = config.motion.operations;
    let [number, name, pattern] = &entries[..] else { panic!("{entries:?}") };
    assert_eq!(number.of, OperationChoice::Number(12));
    let none = OperationSettings::default();
    let (mode, singular) = (Some(Mode::Plane), Some(Singular::Shortest));
    assert_eq!(number.settings, OperationSettings { mode, singular, ..none.clone() });
    assert_eq!(name.of, OperationChoice::Name("Finish Blade".to_owned()));
    assert!(close(name.settings.tolerance_mm.expect("a tolerance"), 0.0254));
    assert_eq!(pattern.of, OperationChoice::Pattern("*.rough?".to_owned()));
    let (smoothing, largest_feed_mm_per_min) = (Some(Smoothing::None), Some(2540.0));
    assert_eq!(pattern.settings, OperationSettings { smoothing, largest_feed_mm_per_min, ..none });
}

#[test]
fn faults_of_settings_of_operations_are_at_their_places() {
    let text = "[operations.0]\nmode = 'tcp'\n[operations.07]\nmode = 'tcp'\n[operations.'']\nmode = 'tcp'\n\
                [operations.ROUGH]\nmode = 'tilted'\n[operations.rough]\nmode = 'tcp'\n[operations.'F*']\nmod = 'tcp'\n\
                tolerance = 3\nlargest_feed = 0\n";
    let forms = "[operations.3], [operations.\"FINISH BLADE\"] or [operations.\"FINISH*\"]";
    assert_eq!(
        faults(text),
        [
            format!("1:13: operations are counted from 1, without leading zeros | {forms}"),
            format!("3:13: operations are counted from 1, without leading zeros | {forms}"),
            format!("5:13: an operation needs a number, a name or a pattern | {forms}"),
            "8:8: \"tilted\" is not a permitted value | write one of \"auto\", \"axes\", \"tcp\", \"plane\"".to_owned(),
            "9:13: [operations.\"rough\"] and [operations.\"ROUGH\"] are for the same operations: letter case is ignored | \
             leave one of them out"
                .to_owned(),
            "12:1: unknown key `operations.F*.mod`; did you mean `mode`?".to_owned(),
            "13:13: a tolerance of 0.0001 to 1 mm is needed here".to_owned(),
            "14:16: a number above zero is needed here".to_owned(),
        ]
    );
}
