//! Arguments of calls and parameters of cycles: each is executed, or must have the one value that is.

/// A call of Siemens, or a cycle of Heidenhain, with everything that may be between its brackets or in its lines.
#[derive(Debug)]
pub(in super::super) struct List {
    /// `CYCLE83`, or the number of a cycle.
    pub(crate) name: &'static str,
    pub(crate) number: u32,
    pub(crate) meaning: &'static str,
    /// In their order (Siemens), or by their number (Heidenhain).
    pub(crate) items: &'static [Item],
    pub(crate) source: &'static str,
}

/// An argument or a parameter.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Item {
    pub(crate) name: &'static str,
    /// Number of a Q parameter.
    pub(crate) number: u32,
    pub(crate) role: ArgumentRole,
}

/// Number of the list of the blank, which is read as a whole.
pub(in super::super) const WORKPIECE: u32 = 1;

/// Meaning of an argument or a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) enum ArgumentRole {
    /// It must be there and have this value.
    Must(f64),
    /// It may be missing, and must have this value otherwise.
    May(f64),
    /// It must be missing.
    Empty,
    /// Name of the swivel data.
    Name,
    /// A text that is displayed.
    Text,
    /// A number that is executed; it must be there.
    Needs(ArgumentSlot),
    /// A whole number that is executed; it must be there.
    Whole(ArgumentSlot),
    /// A number that is executed; it may be missing.
    Takes(ArgumentSlot),
}

/// Places of the numbers that are executed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum ArgumentSlot {
    Return,
    Surface,
    Clearance,
    Bottom,
    Depth,
    Dwell,
    Step,
    Gap,
    OtherGap,
    Breaks,
    Variant,
    Sense,
    Pitch,
    PitchUnit,
    Speed,
    SpeedOut,
    Feed,
    FeedOut,
    Mode,
    X0,
    Y0,
    Z0,
    A,
    B,
    C,
    X1,
    Y1,
    Z1,
    Direction,
    Tolerance,
    AxisTolerance,
    ShiftX,
    ShiftY,
    Quadrant,
    Angle,
    Row,
}

/// Number of slots.
pub(in super::super) const SLOTS: usize = ArgumentSlot::Row as usize + 1;

const fn q(number: u32, name: &'static str, role: ArgumentRole) -> Item {
    Item { name, number, role }
}

const fn arg(name: &'static str, role: ArgumentRole) -> Item {
    Item { name, number: 0, role }
}

const CYCLES: &str = "Siemens 840D Cycles PGZ, 2.1; 840D sl programming manual, cycles";
const ONE: &str = "SINUMERIK ONE programming manual 12/2019 (6FC5398-2EP40-0BA0), p. 1108";
const TNC: &str = "HEIDENHAIN TNC 640 and iTNC 530, user's manuals of cycle programming";

/// RTP, RFP, SDIS, DP, DPR.
const RTP: Item = arg("RTP", ArgumentRole::Needs(ArgumentSlot::Return));
const RFP: Item = arg("RFP", ArgumentRole::Needs(ArgumentSlot::Surface));
const SDIS: Item = arg("SDIS", ArgumentRole::Needs(ArgumentSlot::Clearance));
const DP: Item = arg("DP", ArgumentRole::Takes(ArgumentSlot::Bottom));
const DPR: Item = arg("DPR", ArgumentRole::Takes(ArgumentSlot::Depth));
const DTB: Item = arg("DTB", ArgumentRole::Takes(ArgumentSlot::Dwell));

/// Calls of Siemens.
pub(super) const SIEMENS: &[List] = &[
    List { name: "CYCLE81", number: 81, meaning: "drilling", items: &[RTP, RFP, SDIS, DP, DPR], source: CYCLES },
    List {
        name: "CYCLE82",
        number: 82,
        meaning: "drilling with dwell",
        items: &[RTP, RFP, SDIS, DP, DPR, DTB],
        source: CYCLES,
    },
    List {
        name: "CYCLE83",
        number: 83,
        meaning: "deep-hole drilling",
        items: &[
            RTP,
            RFP,
            SDIS,
            DP,
            DPR,
            arg("FDEP", ArgumentRole::Empty),
            arg("FDPR", ArgumentRole::Needs(ArgumentSlot::Step)),
            arg("DAM", ArgumentRole::May(0.0)),
            arg("DTB", ArgumentRole::May(0.0)),
            arg("DTS", ArgumentRole::May(0.0)),
            arg("FRF", ArgumentRole::Must(1.0)),
            arg("VARI", ArgumentRole::Whole(ArgumentSlot::Variant)),
            arg("_AXN", ArgumentRole::Empty),
            arg("_MDEP", ArgumentRole::Empty),
            arg("_VRT", ArgumentRole::Takes(ArgumentSlot::OtherGap)),
            arg("_DTD", ArgumentRole::Takes(ArgumentSlot::Dwell)),
            arg("_DIS1", ArgumentRole::Takes(ArgumentSlot::Gap)),
        ],
        source: CYCLES,
    },
    List {
        name: "CYCLE84",
        number: 84,
        meaning: "rigid tapping",
        items: &[
            RTP,
            RFP,
            SDIS,
            DP,
            DPR,
            DTB,
            arg("SDAC", ArgumentRole::Whole(ArgumentSlot::Sense)),
            arg("MPIT", ArgumentRole::Empty),
            arg("PIT", ArgumentRole::Needs(ArgumentSlot::Pitch)),
            arg("POSS", ArgumentRole::May(0.0)),
            arg("SST", ArgumentRole::Needs(ArgumentSlot::Speed)),
            arg("SST1", ArgumentRole::Needs(ArgumentSlot::SpeedOut)),
            arg("_AXN", ArgumentRole::Empty),
            arg("_PITA", ArgumentRole::Takes(ArgumentSlot::PitchUnit)),
        ],
        source: CYCLES,
    },
    List {
        name: "CYCLE85",
        number: 85,
        meaning: "reaming",
        items: &[
            RTP,
            RFP,
            SDIS,
            DP,
            DPR,
            DTB,
            arg("FFR", ArgumentRole::Needs(ArgumentSlot::Feed)),
            arg("RFF", ArgumentRole::Needs(ArgumentSlot::FeedOut)),
        ],
        source: CYCLES,
    },
    List {
        name: "CYCLE86",
        number: 86,
        meaning: "boring, spindle stopped at an angle",
        items: &[
            RTP,
            RFP,
            SDIS,
            DP,
            DPR,
            DTB,
            arg("SDIR", ArgumentRole::Whole(ArgumentSlot::Sense)),
            arg("RPA", ArgumentRole::Needs(ArgumentSlot::ShiftX)),
            arg("RPO", ArgumentRole::Needs(ArgumentSlot::ShiftY)),
            arg("RPAP", ArgumentRole::May(0.0)),
            arg("POSS", ArgumentRole::Needs(ArgumentSlot::Angle)),
        ],
        source: CYCLES,
    },
    List {
        name: "CYCLE800",
        number: 800,
        meaning: "tilted plane, off without arguments",
        items: &[
            arg("_FR", ArgumentRole::Must(0.0)),
            arg("_TC", ArgumentRole::Name),
            arg("_ST", ArgumentRole::Must(0.0)),
            arg("_MODE", ArgumentRole::Whole(ArgumentSlot::Mode)),
            arg("_X0", ArgumentRole::Needs(ArgumentSlot::X0)),
            arg("_Y0", ArgumentRole::Needs(ArgumentSlot::Y0)),
            arg("_Z0", ArgumentRole::Needs(ArgumentSlot::Z0)),
            arg("_A", ArgumentRole::Needs(ArgumentSlot::A)),
            arg("_B", ArgumentRole::Needs(ArgumentSlot::B)),
            arg("_C", ArgumentRole::Needs(ArgumentSlot::C)),
            arg("_X1", ArgumentRole::Needs(ArgumentSlot::X1)),
            arg("_Y1", ArgumentRole::Needs(ArgumentSlot::Y1)),
            arg("_Z1", ArgumentRole::Needs(ArgumentSlot::Z1)),
            arg("_DIR", ArgumentRole::Whole(ArgumentSlot::Direction)),
            arg("_FR_I", ArgumentRole::May(0.0)),
        ],
        source: "Siemens 840D sl programming manual, p. 334; 828D operating manual, 10.6",
    },
    List {
        name: "CYCLE832",
        number: 832,
        meaning: "smoothing, off without arguments",
        items: &[
            arg("S_TOL", ArgumentRole::Needs(ArgumentSlot::Tolerance)),
            arg("S_TOLM", ArgumentRole::Whole(ArgumentSlot::Mode)),
            arg("S_OTOL", ArgumentRole::Takes(ArgumentSlot::AxisTolerance)),
        ],
        source: ONE,
    },
    List {
        name: "WORKPIECE",
        number: WORKPIECE,
        meaning: "blank for the graphics: \"BOX\",112,ZA,ZI,-80,XA,YA,XI,YI or \"CYLINDER\",192,ZA,ZI,ZB,XA after three gaps",
        items: &[arg("blank", ArgumentRole::Text)],
        source: "public posts and programs of ShopMill and ShopTurn; no page of a manual was found",
    },
    List {
        name: "MSG",
        number: 0,
        meaning: "message, the program goes on",
        items: &[arg("text", ArgumentRole::Text)],
        source: "Siemens Fundamentals 05/2017 (A5E40869423), Supplementary commands",
    },
];

const Q200: Item = q(200, "set-up clearance", ArgumentRole::Needs(ArgumentSlot::Clearance));
const Q201: Item = q(201, "depth", ArgumentRole::Needs(ArgumentSlot::Depth));
const Q202: Item = q(202, "plunging depth", ArgumentRole::Needs(ArgumentSlot::Step));
const Q203: Item = q(203, "surface", ArgumentRole::Needs(ArgumentSlot::Surface));
const Q204: Item = q(204, "second set-up clearance", ArgumentRole::Needs(ArgumentSlot::Return));
const Q206: Item = q(206, "feed", ArgumentRole::Needs(ArgumentSlot::Feed));
const Q211: Item = q(211, "dwell at depth", ArgumentRole::Needs(ArgumentSlot::Dwell));
const Q210: Item = q(210, "dwell at top", ArgumentRole::Must(0.0));
const Q212: Item = q(212, "decrement", ArgumentRole::Must(0.0));
const Q205: Item = q(205, "least plunging depth", ArgumentRole::Must(0.0));

/// Cycles of Heidenhain. A parameter that is missing would keep the value of an earlier definition.
pub(super) const HEIDENHAIN: &[List] = &[
    List { name: "CYCL DEF 9.0", number: 90, meaning: "dwell, first line", items: &[], source: TNC },
    List { name: "CYCL DEF 9.1", number: 91, meaning: "dwell, s", items: &[], source: TNC },
    List { name: "CYCL DEF 32.0", number: 320, meaning: "smoothing, first line", items: &[], source: TNC },
    List {
        name: "CYCL DEF 32.1",
        number: 321,
        meaning: "smoothing: tolerance, off without T",
        items: &[],
        source: TNC,
    },
    List {
        name: "CYCL DEF 32.2",
        number: 322,
        meaning: "smoothing: mode, tolerance of the tool axis",
        items: &[],
        source: TNC,
    },
    List {
        name: "CYCL DEF 200",
        number: 2000,
        meaning: "drilling",
        items: &[Q200, Q201, Q206, Q202, Q210, Q203, Q204, Q211],
        source: TNC,
    },
    List {
        name: "CYCL DEF 201",
        number: 2010,
        meaning: "reaming",
        items: &[Q200, Q201, Q206, Q211, q(208, "feed out, 0 as Q206", ArgumentRole::Must(0.0)), Q203, Q204],
        source: TNC,
    },
    List {
        name: "CYCL DEF 202",
        number: 2020,
        meaning: "boring, spindle stopped at an angle",
        items: &[
            Q200,
            Q201,
            Q206,
            Q211,
            q(208, "feed out, rapid", ArgumentRole::Must(99_999.0)),
            Q203,
            Q204,
            q(214, "direction off the wall", ArgumentRole::Whole(ArgumentSlot::Quadrant)),
            q(336, "angle of the spindle", ArgumentRole::Needs(ArgumentSlot::Angle)),
        ],
        source: TNC,
    },
    List {
        name: "CYCL DEF 203",
        number: 2030,
        meaning: "universal drilling",
        items: &[
            Q200,
            Q201,
            Q206,
            Q202,
            Q210,
            Q203,
            Q204,
            Q212,
            q(213, "number of chip breaks", ArgumentRole::Whole(ArgumentSlot::Breaks)),
            Q205,
            Q211,
            q(208, "feed out, rapid", ArgumentRole::Must(99_999.0)),
            q(256, "retract that breaks the chip", ArgumentRole::Needs(ArgumentSlot::OtherGap)),
        ],
        source: TNC,
    },
    List {
        name: "CYCL DEF 205",
        number: 2050,
        meaning: "universal pecking",
        items: &[
            Q200,
            Q201,
            Q206,
            Q202,
            Q203,
            Q204,
            Q212,
            Q205,
            q(258, "upper advanced stop distance", ArgumentRole::Needs(ArgumentSlot::Gap)),
            q(259, "lower advanced stop distance, as Q258", ArgumentRole::Needs(ArgumentSlot::OtherGap)),
            q(257, "depth for chip breaking", ArgumentRole::Must(0.0)),
            q(256, "retract that breaks the chip", ArgumentRole::Must(0.2)),
            Q211,
            q(379, "starting point", ArgumentRole::Must(0.0)),
            q(253, "feed to the starting point", ArgumentRole::Must(99_999.0)),
        ],
        source: TNC,
    },
    List {
        name: "CYCL DEF 207",
        number: 2070,
        meaning: "rigid tapping",
        items: &[Q200, Q201, q(239, "pitch", ArgumentRole::Needs(ArgumentSlot::Pitch)), Q203, Q204],
        source: TNC,
    },
    List {
        name: "CYCL DEF 247",
        number: 2470,
        meaning: "work offset: row of the preset table",
        items: &[q(339, "row", ArgumentRole::Whole(ArgumentSlot::Row))],
        source: TNC,
    },
];
