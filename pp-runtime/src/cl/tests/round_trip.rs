//! Round trip: every kind of record is written as text and read back unchanged.

use crate::cl::record::*;
use crate::cl::record::{CatiaMatrix, GivenMeanings, parse, read_comment};
use crate::cl::vector::cross;
use crate::program::{Coolant, CutterSide, Dwell, Pressure, RotaryDirection, Rotation, Spindle, Units};
use proptest::prelude::*;

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        Just(-0.0),
        Just(1.0),
        -1e5..1e5_f64,
        -1.0..1.0_f64,
        (-100_000_000_i64..100_000_000).prop_map(|units| units as f64 / 1e4),
        -1e-9..1e-9_f64,
    ]
}

fn positive() -> impl Strategy<Value = f64> {
    (1_i64..1_000_000_000).prop_map(|units| units as f64 / 1e3)
}

fn triple() -> impl Strategy<Value = [f64; 3]> {
    [number(), number(), number()]
}

fn point() -> impl Strategy<Value = Point> {
    (triple(), prop::option::of(triple())).prop_map(|(tip, axis)| Point { tip, axis, at: Span::default() })
}

fn axis_frame() -> impl Strategy<Value = FrameRecord> {
    let base = FrameBase::Model;
    ([triple(), triple(), triple()], triple()).prop_map(move |(axes, origin)| FrameRecord {
        axes,
        origin,
        base,
        at: Span::default(),
    })
}

/// Frames that are stated in the workpiece frame; in MCSYS the third axis is that of a right-handed frame.
fn work_plane() -> impl Strategy<Value = FrameRecord> {
    let base = prop::sample::select(vec![FrameBase::Workpiece, FrameBase::WorkpieceOrView]);
    (axis_frame(), base).prop_map(|(frame, base)| {
        let [x, y, z] = frame.axes;
        let z = if base == FrameBase::Workpiece { cross(x, y) } else { z };
        FrameRecord { axes: [x, y, z], base, ..frame }
    })
}

fn feed_unit() -> impl Strategy<Value = FeedUnit> {
    prop::sample::select(vec![
        FeedUnit::PerMinute,
        FeedUnit::PerRevolution,
        FeedUnit::MillimetresPerMinute,
        FeedUnit::MillimetresPerRevolution,
        FeedUnit::InchesPerMinute,
        FeedUnit::InchesPerRevolution,
        FeedUnit::FeetPerMinute,
        FeedUnit::FeetPerRevolution,
    ])
}

/// Texts without characters at either end that the reader removes.
const TEXTS: [&str; 6] = ["A", "PART 12", "(LOOK, HERE)", "a/b,c.d", "50 % OFF", "T16 D8_R2"];

fn text() -> impl Strategy<Value = Text<'static>> {
    prop::sample::select(TEXTS.to_vec()).prop_map(|text| Text { bytes: text.as_bytes(), at: Span::default() })
}

fn numbers(texts: &'static [&'static str]) -> impl Strategy<Value = Numbers<'static>> {
    prop::sample::select(texts.to_vec()).prop_map(|text| Numbers { bytes: text.as_bytes(), at: Span::default() })
}

fn circle() -> impl Strategy<Value = CircleRecord> {
    let form = prop::sample::select(vec![CircleForm::Four, CircleForm::Six, CircleForm::Seven, CircleForm::Eleven]);
    let sense = prop::sample::select(vec![None, Some(Rotation::Clockwise), Some(Rotation::CounterClockwise)]);
    (triple(), triple(), positive(), (form, sense), 1..=1000_u32, prop::option::of(0.001..3e5_f64)).prop_map(
        |(centre, axis, radius, (form, sense), times, angle)| {
            let form = if angle.is_some() { CircleForm::Seven } else { form };
            let radius = (form != CircleForm::Six).then_some(radius);
            let times = if angle.is_some() || form == CircleForm::Four { 1 } else { times };
            let axis = if form == CircleForm::Four { [0.0; 3] } else { axis };
            CircleRecord {
                centre,
                axis,
                radius,
                eighth: (form == CircleForm::Eleven).then_some(0.06),
                form,
                sense: sense.filter(|_| form == CircleForm::Seven && angle.is_none()),
                times,
                angle_deg: angle,
                at: Span::default(),
            }
        },
    )
}

fn cycle() -> impl Strategy<Value = CycleCall> {
    let kind = prop::sample::select(ClCycleKind::WORDS.map(|(_, kind)| kind).to_vec());
    let some = || prop::option::of(number());
    let back_to =
        prop_oneof![Just(None), Just(Some(Return::Auto)), number().prop_map(|level| Some(Return::Level(level)))];
    let levels = (some(), any::<bool>(), some(), some(), some(), some());
    let dwell = prop_oneof![number().prop_map(Dwell::Seconds), number().prop_map(Dwell::Revolutions)];
    let pitch =
        prop_oneof![number().prop_map(ThreadPitch::PerRevolution), number().prop_map(ThreadPitch::ThreadsPerInch)];
    let others = (prop::option::of(dwell), some(), some(), prop::option::of(pitch), some(), some());
    let feed = prop::option::of((positive(), feed_unit()));
    let numbers = (prop::collection::vec(number(), 0..=MOST_POSITIONAL), any::<bool>());
    (kind, levels, others, back_to, feed, numbers).prop_map(
        |(kind, levels, others, back_to, feed, (numbers, are_depths))| {
            let (depth, is_fedto, rapto, clear, step, first_step) = levels;
            let mut cycle =
                CycleCall { back_to, feed, rapto, clear, step, first_step, ..CycleCall::new(kind, Span::default()) };
            (cycle.dwell, cycle.back, cycle.orient_deg, cycle.pitch, cycle.diameter, cycle.tool_angle_deg) = others;
            *(if is_fedto { &mut cycle.fedto } else { &mut cycle.depth }) = depth;
            let are_depths = are_depths && kind == ClCycleKind::Thru && cycle.depth.is_some();
            *(if are_depths { &mut cycle.further_depths } else { &mut cycle.positionals }) = numbers.len() as u8;
            cycle.positional[..numbers.len()].copy_from_slice(&numbers);
            cycle
        },
    )
}

fn pressure() -> impl Strategy<Value = Pressure> {
    prop::sample::select(Pressure::WORDS.map(|(_, pressure)| pressure).to_vec())
}

fn subprogram_name() -> impl Strategy<Value = SubprogramName> {
    let words = ["A", "POCKET_1", "THIRTY-TWO_LETTERS_IN_THIS_NAME_"];
    let word = prop::sample::select(words.to_vec()).prop_map(|text| {
        let mut word = [b' '; 32];
        word[..text.len()].copy_from_slice(text.as_bytes());
        SubprogramName::Word(word)
    });
    prop_oneof![(0..1000_u32).prop_map(SubprogramName::Number), word]
}

/// Changes of a cycle: CYCLE/ON with at least one word, and no number without a word.
fn change() -> impl Strategy<Value = Record<'static>> {
    (cycle(), positive()).prop_map(|(mut words, rapto)| {
        (words.kind, words.positionals, words.positional) = (ClCycleKind::Drill, 0, [0.0; MOST_POSITIONAL]);
        words.further_depths = 0;
        words.rapto = Some(rapto);
        Record::Cycle(CycleRecord::Change(words))
    })
}

fn spindle() -> impl Strategy<Value = Spindle> {
    let rotation = prop::sample::select(vec![None, Some(Rotation::Clockwise), Some(Rotation::CounterClockwise)]);
    prop_oneof![
        Just(Spindle::Off),
        (prop::option::of(0.5..1e5_f64), rotation)
            .prop_map(|(speed, rotation)| Spindle::On { speed_rev_per_min: speed, rotation }),
    ]
}

fn tool() -> impl Strategy<Value = ToolCallRecord> {
    let numbers = (prop::array::uniform4(positive()), 0..=MOST_TOOL_NUMBERS);
    let words = (prop::option::of(positive()), prop::option::of(1..1000_u32), prop::option::of(0..9_u32));
    (1..100_000_u32, words, numbers).prop_map(|(number, (length, offset, magazine), (mut numbers, count))| {
        numbers[count..].fill(0.0);
        ToolCallRecord { length, offset, magazine, numbers, count, ..ToolCallRecord::new(number) }
    })
}

fn compensation() -> impl Strategy<Value = Record<'static>> {
    let plane = prop::option::of(prop::sample::select(AxisPlane::WORDS.map(|(_, plane)| plane).to_vec()));
    let side = prop::sample::select(vec![CutterSide::On, CutterSide::Left, CutterSide::Right]);
    (side, prop::option::of(0..1000_u32), plane)
        .prop_map(|(side, register, plane)| Record::Machine(MachineRecord::Compensation { side, register, plane }))
}

fn at() -> Span {
    Span::default()
}

fn motions() -> BoxedStrategy<Record<'static>> {
    prop_oneof![
        point().prop_map(|value| Record::Motion(MotionRecord::Goto(value))),
        point().prop_map(|value| Record::Motion(MotionRecord::From(value))),
        point().prop_map(|value| Record::Motion(MotionRecord::Delta(value))),
        numbers(&["1,2,3/4,5,6", "1.,-2.5,0. / 4.,5.,6. / 7.,8.,9."])
            .prop_map(|value| Record::Motion(MotionRecord::Points(value))),
        number().prop_map(|distance| Record::Motion(MotionRecord::DeltaAlongAxis { distance, at: at() })),
        prop::option::of(point()).prop_map(|value| Record::Motion(MotionRecord::Home(value))),
        Just(Record::Machine(MachineRecord::Rapid)),
        circle().prop_map(|value| Record::Arc(ArcRecord::Circle(value))),
        Just(Record::Arc(ArcRecord::AutomaticPlane)),
        number().prop_map(|height| Record::Arc(ArcRecord::Slope { height, at: at() })),
        triple().prop_map(|vector| Record::Arc(ArcRecord::Direction { vector, at: at() })),
        (triple(), positive(), [triple(), triple()], any::<bool>()).prop_map(|(centre, radius, line, second)| {
            Record::Arc(ArcRecord::TangentArc(TangentArc { centre, radius, line, second, at: at() }))
        }),
        Just(Record::Nurbs(NurbsRecord::Begin)),
        numbers(&["1.", "0.5,0.75,1."]).prop_map(|value| Record::Nurbs(NurbsRecord::Knots(value))),
        triple().prop_map(|tip| Record::Nurbs(NurbsRecord::ControlPoint(Point { tip, axis: None, at: at() }))),
        change(),
        cycle().prop_map(|value| Record::Cycle(CycleRecord::Define(value))),
        prop::sample::select(vec![CycleState::Off, CycleState::On, CycleState::Initial, CycleState::Clear])
            .prop_map(|state| Record::Cycle(CycleRecord::Switch { state, at: at() })),
        Just(Record::Motion(MotionRecord::Retract)),
    ]
    .boxed()
}

fn coordinates() -> BoxedStrategy<Record<'static>> {
    prop_oneof![
        any::<bool>().prop_map(|mm| Record::Coordinates(CoordinateRecord::Units(if mm {
            Units::Millimetres
        } else {
            Units::Inches
        }))),
        any::<bool>().prop_map(|value| Record::Coordinates(CoordinateRecord::MultiAxis(value))),
        triple().prop_map(|axis| Record::Coordinates(CoordinateRecord::ToolAxis { axis, at: at() })),
        axis_frame().prop_map(|value| Record::Coordinates(CoordinateRecord::Frame(value))),
        work_plane().prop_map(|value| Record::Coordinates(CoordinateRecord::Frame(value))),
        axis_frame().prop_map(|value| Record::Coordinates(CoordinateRecord::Setup(value))),
        Just(Record::Coordinates(CoordinateRecord::World)),
        prop::option::of(triple()).prop_map(|value| Record::Coordinates(CoordinateRecord::Origin(value))),
        prop::option::of(triple()).prop_map(|by| Record::Coordinates(CoordinateRecord::Translation { by, at: at() })),
        prop::option::of(prop::array::uniform12(number()))
            .prop_map(|matrix| Record::Coordinates(CoordinateRecord::Transformation { matrix, at: at() })),
        (triple(), number()).prop_map(|(normal, distance)| Record::Coordinates(CoordinateRecord::ClearancePlane {
            normal,
            distance,
            at: at()
        })),
        prop::option::of(positive()).prop_map(|value| Record::Machine(MachineRecord::Tolerance { value, at: at() })),
    ]
    .boxed()
}

fn states() -> BoxedStrategy<Record<'static>> {
    let kinds = [Coolant::On, Coolant::Flood, Coolant::Mist, Coolant::Through, Coolant::Air, Coolant::Off];
    let pressures = Pressure::WORDS.map(|(_, pressure)| Coolant::ThroughAt(pressure));
    let coolants = [&kinds[..], &pressures].concat();
    let plain = [
        Record::Program(ProgramRecord::EndOfPath),
        Record::Program(ProgramRecord::OptionalStop),
        Record::Program(ProgramRecord::Stop),
        Record::Program(ProgramRecord::BlockSkip { on: true }),
        Record::Program(ProgramRecord::BlockSkip { on: false }),
        Record::Program(ProgramRecord::End),
        Record::Program(ProgramRecord::Fini),
        Record::Program(ProgramRecord::Rewind),
        Record::Subprogram(SubprogramRecord::End),
        Record::Inert,
        Record::Machine(MachineRecord::RotaryDirection(RotaryDirection::Shortest)),
        Record::Machine(MachineRecord::RotaryDirection(RotaryDirection::Towards(Rotation::Clockwise))),
        Record::Machine(MachineRecord::RotaryDirection(RotaryDirection::Towards(Rotation::CounterClockwise))),
        Record::Machine(MachineRecord::Compensation { side: CutterSide::Off, register: None, plane: None }),
    ];
    prop_oneof![
        prop::sample::select(plain.to_vec()),
        text().prop_map(|value| Record::Program(ProgramRecord::PartName(value))),
        text().prop_map(|value| Record::Program(ProgramRecord::Message(value))),
        text().prop_map(|value| Record::Program(ProgramRecord::Insert(value))),
        text().prop_map(|value| Record::Program(ProgramRecord::ToolPath { name: value, tool: None })),
        Just(Record::Program(ProgramRecord::MachineName(Text { bytes: b"UNCX01", at: at() }))),
        tool().prop_map(|value| Record::Tool(ToolRecord::Call(value))),
        (0..1000_u32).prop_map(|value| Record::Tool(ToolRecord::Preselect(value))),
        (positive(), prop::option::of(positive())).prop_map(|(diameter, corner_radius)| Record::Tool(
            ToolRecord::Cutter(CutterRecord { diameter, corner_radius, kind: None })
        )),
        (positive(), prop::option::of(positive())).prop_map(|(diameter, corner_radius)| {
            let kind = Some(if corner_radius.is_some() { CutterKind::Mill } else { CutterKind::Drill });
            Record::Tool(ToolRecord::Cutter(CutterRecord { diameter, corner_radius, kind }))
        }),
        (positive(), prop::option::of(positive())).prop_map(|(diameter, corner_radius)| Record::Tool(
            ToolRecord::CutterOfLastTool(CutterRecord { diameter, corner_radius, kind: None })
        )),
        (0..1000_u32).prop_map(|register| Record::Tool(ToolRecord::LengthOffset { register, at: at() })),
        (1..1000_u32, 1..1000_u32)
            .prop_map(|(number, register)| Record::Tool(ToolRecord::OffsetOf { number, register })),
        (positive(), feed_unit()).prop_map(|(value, unit)| Record::Machine(MachineRecord::Feed(FeedRecord {
            value,
            unit,
            at: at(),
            unit_at: at()
        }))),
        any::<bool>().prop_map(|value| Record::Machine(MachineRecord::InverseTime(value))),
        spindle().prop_map(|value| Record::Machine(MachineRecord::Spindle(value))),
        prop::sample::select(coolants).prop_map(|value| Record::Machine(MachineRecord::Coolant(value))),
        compensation(),
        any::<bool>().prop_map(|of_centre| Record::Machine(MachineRecord::CompensatedPath { of_centre, at: at() })),
        (positive(), any::<bool>()).prop_map(|(value, turns)| Record::Machine(MachineRecord::Delay {
            dwell: if turns { Dwell::Revolutions(value) } else { Dwell::Seconds(value) },
            at: at(),
        })),
        (0..10_000_u32, any::<bool>()).prop_map(|(number, m)| Record::Program(ProgramRecord::Code {
            letter: if m { b'M' } else { b'G' },
            number,
            at: at()
        })),
        subprogram_name().prop_map(|name| Record::Subprogram(SubprogramRecord::Define(name))),
        subprogram_name().prop_map(|name| Record::Subprogram(SubprogramRecord::Call { name, at: at() })),
        (prop::sample::select(vec![Coolant::On, Coolant::Flood, Coolant::Mist]), pressure())
            .prop_map(|(kind, pressure)| Record::Machine(MachineRecord::CoolantAt { kind, pressure, at: at() })),
    ]
    .boxed()
}

fn read(text: &str) -> Record<'_> {
    if text.starts_with("$$") {
        read_comment(text.as_bytes(), &mut CatiaMatrix::default()).unwrap()
    } else {
        parse(text.as_bytes(), GivenMeanings::default()).unwrap_or_else(|fault| panic!("{text}: {}", fault.text))
    }
}

/// Debug text of a record without places: its content.
fn content(record: &Record<'_>) -> String {
    let mut text = format!("{record:?}");
    while let Some(start) = text.find("Span {") {
        let end = start + text[start..].find('}').map_or(0, |end| end + 1);
        text.replace_range(start..end, "_");
    }
    // The sign of zero is ignored.
    ["-0.0,", "-0.0]", "-0.0)", "-0.0 "].iter().fold(text, |text, zero| text.replace(zero, &zero[1..]))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn every_record_is_read_back_as_it_was(record in prop_oneof![motions(), coordinates(), states()]) {
        let text = record.to_string();
        prop_assert_eq!(content(&read(&text)), content(&record), "{}", text);
        // Blanks around slashes and commas and small letters change nothing but texts and names.
        let is_text = matches!(record, Record::Program(
            ProgramRecord::PartName(_) | ProgramRecord::Message(_) | ProgramRecord::Insert(_)
            | ProgramRecord::ToolPath { .. } | ProgramRecord::MachineName(_)
        ));
        let is_list = matches!(record, Record::Nurbs(NurbsRecord::Knots(_)) | Record::Motion(MotionRecord::Points(_)));
        if !is_text && !is_list {
            let wide = text.replace(',', " ,\t").replace('/', "  / ").to_ascii_lowercase();
            prop_assert_eq!(content(&read(&wide.replace("$$->", "$$-> "))), content(&record), "{}", wide);
        }
    }
}
