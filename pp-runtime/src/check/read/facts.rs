//! Properties of the families of controls on which reader and comparison depend. Nothing else compares families.

use super::Family;
use super::block::{Action, CycleKind, CycleMove, settled};
use super::orders::Order;

/// Numbering of the registers that hold the length of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LengthRegisters {
    /// One table for all tools: H.
    Shared,
    /// Cutting edges of each tool, from 1: D.
    Edges,
    /// The tool's own row.
    Rows,
}

/// Length that the guards of a family read from the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum GuardSource {
    /// That of the tool in the spindle, whatever register is active: guarded is a register with the number of the tool.
    Spindle,
    /// Registers up to this number.
    Registers {
        /// Largest register.
        largest: u32,
    },
    /// The active cutting edge.
    Edge,
    /// The row of the tool.
    Row,
}

/// Words of smoothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SmoothingWords {
    /// The program states its tolerance.
    pub(crate) tolerance: bool,
    /// Level in the program: rough, medium, finish.
    pub(crate) levels: [Option<u8>; 3],
}

/// Names of settings and parameters on which cycles in steps depend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct StepStates {
    /// Distance above the last depth to which a peck returns at rapid.
    pub(crate) peck_gap: Option<&'static str>,
    /// Retract that breaks the chip.
    pub(crate) chip_break_gap: Option<&'static str>,
    /// Distance above the clearance level to which a peck retracts.
    pub(crate) peck_rise: Option<&'static str>,
}

/// Rule by which a control chooses between the two poses of a tilted plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PoseSelector {
    /// The nearest pose.
    Nearest,
    /// The sign of the rotary axis nearest the tool (SEQ).
    Sign,
    /// The lower or the higher value of the rotary axis nearest the tool (_DIR).
    Higher,
}

/// A state that a program before, a screen of the control or the operator may have left, and that must be ended before
/// a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LeftOver {
    /// Bit of [`settled`].
    pub(crate) bit: u32,
    /// What may be in force.
    pub(crate) what: &'static str,
    /// Code that ends it.
    pub(crate) code: &'static str,
    /// Function of the control without which it cannot be.
    pub(crate) of: FunctionOf,
}

/// Function of the control to which a state belongs, by its name in `[control] functions`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FunctionOf {
    /// Every control has it.
    Every,
    /// Taken as installed, unless the list is given without it.
    Usual(&'static str),
    /// Taken as absent, unless the list has it: its codes raise an alarm where it is not installed.
    Listed(&'static str),
}

impl FunctionOf {
    /// Whether the control has it. `listed`: the list of the configuration, if it is given.
    pub(crate) fn is_in(self, listed: Option<&[String]>) -> bool {
        let has = |name: &str| listed.map(|names| names.iter().any(|one| one == name));
        match self {
            Self::Every => true,
            Self::Usual(name) => has(name).unwrap_or(true),
            Self::Listed(name) => has(name).unwrap_or(false),
        }
    }
}

const fn left(bit: u32, what: &'static str, code: &'static str, of: FunctionOf) -> LeftOver {
    LeftOver { bit, what, code, of }
}

const SIDE: LeftOver = left(settled::SIDE, "cutter compensation", "G40", FunctionOf::Every);
const LENGTH: LeftOver = left(settled::LENGTH, "length compensation", "G49", FunctionOf::Every);
const DISTANCES: LeftOver = left(settled::DISTANCES, "incremental words (G91)", "G90", FunctionOf::Every);
const WORKING_PLANE: LeftOver =
    left(settled::WORKING_PLANE, "another working plane (G18, G19)", "G17", FunctionOf::Every);
const FEED_MODE: LeftOver = left(settled::FEED_MODE, "another feed mode (G93, G95)", "G94", FunctionOf::Every);
const SCALING: LeftOver = left(settled::SCALING, "scaling", "G50", FunctionOf::Listed("scaling"));

/// What must be ended on each control.
const LINUXCNC_LEFT: &[LeftOver] = &[
    SIDE,
    DISTANCES,
    WORKING_PLANE,
    FEED_MODE,
    LENGTH,
    left(settled::DIAMETER, "X as a diameter (G7)", "G8", FunctionOf::Every),
    left(settled::CUTTING_SPEED, "S as a cutting speed (G96)", "G97", FunctionOf::Every),
];
const FANUC_LEFT: &[LeftOver] = &[
    SIDE,
    DISTANCES,
    WORKING_PLANE,
    FEED_MODE,
    LENGTH,
    SCALING,
    left(settled::PLANE, "a tilted plane", "G69", FunctionOf::Listed("planes")),
    left(settled::PLANE, "a rotation of the coordinates", "G69", FunctionOf::Listed("rotation")),
    left(settled::POLAR, "polar coordinates", "G15", FunctionOf::Listed("polar")),
    left(
        settled::SETTING_ERROR,
        "workpiece setting error compensation",
        "G54.4 P0",
        FunctionOf::Listed("setting_error"),
    ),
    left(settled::SMOOTHING, "smoothing", "G05.1 Q0", FunctionOf::Listed("smoothing")),
];
const HAAS_LEFT: &[LeftOver] = &[
    SIDE,
    DISTANCES,
    WORKING_PLANE,
    FEED_MODE,
    LENGTH,
    SCALING,
    left(settled::PLANE, "a tilted plane", "G269", FunctionOf::Listed("planes")),
    left(settled::ROTATION, "a rotation of the coordinates", "G69", FunctionOf::Listed("rotation")),
    left(settled::DYNAMIC_OFFSET, "the dynamic work offset", "G255", FunctionOf::Listed("dynamic_offset")),
    left(settled::SMOOTHING, "smoothing", "G187", FunctionOf::Listed("smoothing")),
];
const SIEMENS_LEFT: &[LeftOver] = &[
    SIDE,
    DISTANCES,
    WORKING_PLANE,
    FEED_MODE,
    left(settled::FEED_UNIT, "F in the basic unit of the control (G70, G71)", "G700 or G710", FunctionOf::Every),
    left(settled::PATH, "exact stop or smoothed corners", "G64", FunctionOf::Every),
    left(settled::TIP_CONTROL, "a transformation", "TRAFOOF", FunctionOf::Usual("tip_control")),
    left(settled::PLANE, "a tilted plane", "CYCLE800()", FunctionOf::Usual("planes")),
    left(settled::SHIFT, "a programmed shift, rotation, scale or mirror", "TRANS", FunctionOf::Every),
];
const HEIDENHAIN_LEFT: &[LeftOver] = &[
    left(settled::TIP_CONTROL, "tip control", "M129", FunctionOf::Usual("tip_control")),
    left(settled::PLANE, "a tilted plane", "PLANE RESET STAY", FunctionOf::Usual("planes")),
];

/// Form of the lines of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LineForm {
    /// Letters and numbers.
    Letters,
    /// Letters and numbers, keywords and calls.
    Keywords,
    /// Numbered lines, each a statement.
    Statements,
}

/// Properties of a family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Facts {
    /// Form of the lines.
    pub(crate) form: LineForm,
    /// Numbering of length registers.
    pub(crate) registers: LengthRegisters,
    /// Switching length compensation on or off may move the tool by its length.
    pub(crate) length_moves: bool,
    /// Length compensation is off in a block of machine coordinates.
    pub(crate) length_off_at_machine_coordinates: bool,
    /// A motion to the reference position cancels length compensation.
    pub(crate) reference_cancels_length: bool,
    /// Tool radii have registers of their own: D.
    pub(crate) radius_registers: bool,
    /// Cutter compensation takes the radius of the tool, to which the tool call adds DR.
    pub(crate) radius_delta: bool,
    /// Cutter compensation takes the radius of the active edge, which a guard compares.
    pub(crate) radius_guard: bool,
    /// Largest corner that is straight on for cutter compensation, and angle by which an arc after one may become
    /// longer in a program in millimetres and in one in inches, rad. Otherwise the program stops.
    pub(crate) straight_corners: Option<[f64; 3]>,
    /// Most blocks without a motion between two motions of a compensated contour.
    pub(crate) idle_in_contour: Option<u8>,
    /// A guard can compare the positions of rotary axes after a plane call.
    pub(crate) plane_guard: bool,
    /// The control has switched the spindle off after a thread that is in step with it.
    pub(crate) tap_stops_spindle: bool,
    /// A thread that is in step with the spindle takes F; otherwise a word of its own is the pitch.
    pub(crate) thread_takes_feed: bool,
    /// The control has switched the spindle off after a bore with the spindle stopped at an angle.
    pub(crate) bore_stops_spindle: bool,
    /// Whether centres of arcs are absolute is modal, and the end of a program leaves it as it is.
    pub(crate) modal_centres: bool,
    /// A length guard compares in mm, whatever the unit of the program.
    pub(crate) guard_in_mm: bool,
    /// F of an inch program counts tenths of an inch.
    pub(crate) feed_in_tenths_of_inch: bool,
    /// F counts the degrees of rotary axes as millimetres, and there is no inverse-time feed.
    pub(crate) feed_counts_degrees: bool,
    /// Largest F of inverse-time feed, in hundredths.
    pub(crate) largest_inverse_time_hundredths: Option<u32>,
    /// All axes of a rapid under tip control arrive together.
    pub(crate) rapids_interpolated: bool,
    /// Tip control slows down where an axis would exceed its speed.
    pub(crate) tip_control_holds_axis_speeds: bool,
    /// A tilted plane is switched off before the retract in machine coordinates, and that moves nothing.
    pub(crate) plane_off_before_retract: bool,
    /// The tool call selects the working plane.
    pub(crate) plane_by_tool_call: bool,
    /// The program selects how the tool axis moves between the ends of a block under tip control.
    pub(crate) tool_axis_interpolation: bool,
    /// The program selects whether tool axes count in the workpiece or in the machine.
    pub(crate) tool_axis_frame: bool,
    /// Work offsets are rows of a table; G54 is row 1.
    pub(crate) offset_rows: bool,
    /// Codes of length compensation, on or off, end tip control: they are of one group.
    pub(crate) length_ends_tip_control: bool,
    /// The form of tip control is P of its code: how the tool axis moves.
    pub(crate) tip_control_has_form: bool,
    /// Switching tip control on or off may cancel the work offset.
    pub(crate) tip_control_may_cancel_offset: bool,
    /// A number without a decimal point counts least increments, a time without one milliseconds.
    pub(crate) least_increments: bool,
    /// P of a dwell has no decimal point: it counts milliseconds.
    pub(crate) whole_milliseconds: bool,
    /// The unit of F without a decimal point depends on a setting.
    pub(crate) feed_needs_point: bool,
    /// A tool cannot be called in a block that moves.
    pub(crate) tool_call_alone: bool,
    /// Comments that begin with a word and a comma are orders.
    pub(crate) comments_give_orders: bool,
    /// A semicolon begins a comment; otherwise it ends the block.
    pub(crate) semicolon_comments: bool,
    /// Marks before and after a text that the control displays.
    pub(crate) message: Option<[&'static str; 2]>,
    /// Names of operations are written in the same form.
    pub(crate) names_are_messages: bool,
    /// Programs have a number, which begins them.
    pub(crate) program_numbers: bool,
    /// A motion code is executed in its own block, without axis words as well, and compensation is not switched on
    /// twice.
    pub(crate) motion_codes_execute: bool,
    /// A code of the feed mode clears F, the same mode as well.
    pub(crate) feed_mode_clears_feed: bool,
    /// A block number may have a decimal point.
    pub(crate) block_number_has_point: bool,
    /// `%` ends the program, as the end code does.
    pub(crate) mark_ends_program: bool,
    /// A block has at most one M code.
    pub(crate) one_m_code: bool,
    /// A block may have several codes of the coolant.
    pub(crate) several_coolant_codes: bool,
    /// Length register 0 is no length.
    pub(crate) register_0_is_off: bool,
    /// The words of a reference motion are those of the motion code, if the block has one.
    pub(crate) reference_beside_motion: bool,
    /// Tilted planes and tip control are options: a program that uses neither has no code that ends them.
    pub(crate) frames_are_options: bool,
    /// When codes of spindle and coolant act in a block that moves.
    pub(crate) functions: Order,
    /// Motion codes stay in force.
    pub(crate) motion_modal: bool,
    /// A setting decides whether the block that begins a canned cycle makes a hole without a word of its position.
    pub(crate) cycle_needs_position: bool,
    /// The block of a canned cycle may have a word of a rotary axis.
    pub(crate) cycle_takes_rotary: bool,
    /// Names of the settings on which cycles in steps depend.
    pub(crate) step_states: StepStates,
    /// Length that guards read.
    pub(crate) guard_source: GuardSource,
    /// The largest deviation of blended blocks is programmed (G64 P).
    pub(crate) path_tolerance: bool,
    /// Words of smoothing.
    pub(crate) smoothing: SmoothingWords,
    /// Rule for the pose of a tilted plane.
    pub(crate) pose: PoseSelector,
    /// The program selects whether rotary axes take the shorter way (M126, M127).
    pub(crate) rotary_path_selected: bool,
    /// A program defines the blank for the graphics (BLK FORM, WORKPIECE).
    pub(crate) blank: bool,
    /// States that may be left over.
    pub(crate) left_over: &'static [LeftOver],
    /// A guard can compare what lies over the work offset: shifts that last, rotation, scale, mirror.
    pub(crate) offset_guard: bool,
}

const ISO: Facts = Facts {
    form: LineForm::Letters,
    registers: LengthRegisters::Shared,
    length_moves: true,
    length_off_at_machine_coordinates: true,
    // Fanuc B-63844EN, p. 204; Haas 96-8000, G28.
    reference_cancels_length: true,
    radius_registers: true,
    radius_delta: false,
    radius_guard: false,
    straight_corners: None,
    idle_in_contour: None,
    plane_guard: false,
    // Rigid tapping: Fanuc B-63944EN/02 (2004), Haas 96-8000 (from memory).
    tap_stops_spindle: true,
    thread_takes_feed: true,
    bore_stops_spindle: false,
    modal_centres: false,
    guard_in_mm: false,
    feed_in_tenths_of_inch: false,
    feed_counts_degrees: false,
    largest_inverse_time_hundredths: None,
    // Fanuc: parameter 1401#1; Haas: a setting.
    rapids_interpolated: false,
    tip_control_holds_axis_speeds: true,
    plane_off_before_retract: false,
    plane_by_tool_call: false,
    tool_axis_interpolation: false,
    tool_axis_frame: false,
    offset_rows: false,
    length_ends_tip_control: true,
    tip_control_has_form: false,
    tip_control_may_cancel_offset: false,
    least_increments: true,
    whole_milliseconds: false,
    feed_needs_point: false,
    tool_call_alone: false,
    comments_give_orders: false,
    semicolon_comments: false,
    message: None,
    names_are_messages: false,
    program_numbers: true,
    motion_codes_execute: false,
    feed_mode_clears_feed: false,
    block_number_has_point: false,
    mark_ends_program: false,
    one_m_code: false,
    several_coolant_codes: true,
    register_0_is_off: true,
    reference_beside_motion: true,
    frames_are_options: true,
    functions: Order::Either,
    motion_modal: true,
    cycle_needs_position: false,
    cycle_takes_rotary: true,
    step_states: StepStates { peck_gap: None, chip_break_gap: None, peck_rise: None },
    guard_source: GuardSource::Registers { largest: 999 },
    path_tolerance: false,
    smoothing: SmoothingWords { tolerance: false, levels: [None; 3] },
    pose: PoseSelector::Nearest,
    rotary_path_selected: false,
    blank: false,
    left_over: &[],
    offset_guard: false,
};

impl Facts {
    /// Whether the control has switched the spindle off after a block.
    pub(crate) fn stops_spindle(&self, action: &Action) -> bool {
        match action {
            Action::Cycle(CycleMove { kind: CycleKind::Tap(_), .. }) => self.tap_stops_spindle,
            Action::Cycle(CycleMove { kind: CycleKind::FineBore(_), .. }) => self.bore_stops_spindle,
            _ => false,
        }
    }
}

impl Family {
    /// The properties of the family.
    pub(crate) const fn facts(self) -> Facts {
        match self {
            // M7, M8 and M9 are one group: interp_array.cc, _ems. G43 H0 is the length of the tool in the spindle, or
            // of tool 0: G-code documentation, G43. G0 and G28 in one block both use axis words: interp_check.cc. N is
            // any number: interp_read.cc, read_n_number. Motion codes, feed modes, compensation: interp_convert.cc.
            Self::LinuxCnc => Facts {
                // interp_convert.cc, convert_straight_comp2 and convert_arc_comp2: TOLERANCE_CONCAVE_CORNER.
                // interp_queue.cc: an arc that is longer than it was; 0.0254 and 0.001 are measured.
                straight_corners: Some([0.05, 0.0254, 0.001]),
                // interp_cycles.cc, convert_cycle.
                cycle_takes_rotary: false,
                several_coolant_codes: false,
                register_0_is_off: false,
                reference_beside_motion: false,
                length_moves: false,
                length_off_at_machine_coordinates: false,
                reference_cancels_length: false,
                tap_stops_spindle: false,
                thread_takes_feed: false,
                // LinuxCNC, interp_convert.cc, convert_stop: M2 does not reset G90.1.
                modal_centres: true,
                guard_in_mm: true,
                rapids_interpolated: true,
                tip_control_holds_axis_speeds: false,
                length_ends_tip_control: false,
                least_increments: false,
                tool_call_alone: true,
                comments_give_orders: true,
                message: Some(["(MSG,", ")"]),
                semicolon_comments: true,
                program_numbers: false,
                motion_codes_execute: true,
                feed_mode_clears_feed: true,
                block_number_has_point: true,
                mark_ends_program: true,
                functions: Order::Before,
                guard_source: GuardSource::Spindle,
                path_tolerance: true,
                left_over: LINUXCNC_LEFT,
                offset_guard: true,
                ..ISO
            },
            // P of a dwell has no decimal point: B-63944EN/02 (2004), dwell. Up to three M codes only with parameter
            // 3404#7: auxiliary functions.
            Self::Fanuc => Facts {
                tool_axis_interpolation: true,
                tip_control_has_form: true,
                whole_milliseconds: true,
                one_m_code: true,
                // Operator's manual of the 16i, B-63664EN/02, p. 170.
                idle_in_contour: Some(1),
                // From memory.
                step_states: StepStates { peck_gap: Some("5115"), chip_break_gap: Some("5114"), peck_rise: None },
                left_over: FANUC_LEFT,
                ..ISO
            },
            // One M code in a block (from memory). 96-8000: #2000+H, #2200+H, H1 to 200; G187 P1 rough to P3 finish.
            Self::Haas => Facts {
                one_m_code: true,
                // As Fanuc, from memory.
                idle_in_contour: Some(1),
                feed_needs_point: true,
                // Setting 28, canned cycle without X and Y: mill manual NGC (2017), settings.
                cycle_needs_position: true,
                // Settings 22 and 52: mill operator's manual, and 96-8000 (June 1999), p. 192.
                step_states: StepStates {
                    peck_gap: Some("setting 22"),
                    chip_break_gap: Some("setting 22"),
                    peck_rise: Some("setting 52"),
                },
                // Autodesk's public posts for Haas: 9999.99.
                largest_inverse_time_hundredths: Some(999_999),
                guard_source: GuardSource::Registers { largest: 200 },
                smoothing: SmoothingWords { tolerance: true, levels: [Some(1), Some(2), Some(3)] },
                left_over: HAAS_LEFT,
                ..ISO
            },
            // Rapids: programming manual of the Sinumerik One, RTLIOF.
            Self::Siemens => Facts {
                form: LineForm::Keywords,
                registers: LengthRegisters::Edges,
                length_moves: false,
                radius_registers: false,
                radius_guard: true,
                // MD20250 as delivered, from memory.
                idle_in_contour: Some(3),
                plane_guard: true,
                message: Some(["MSG(\"", "\")"]),
                names_are_messages: true,
                tap_stops_spindle: false,
                thread_takes_feed: false,
                bore_stops_spindle: true,
                rapids_interpolated: true,
                tool_axis_interpolation: true,
                tool_axis_frame: true,
                length_ends_tip_control: false,
                tip_control_may_cancel_offset: true,
                least_increments: false,
                semicolon_comments: true,
                program_numbers: false,
                frames_are_options: false,
                guard_source: GuardSource::Edge,
                // CYCLE832: 1 finish, 2 medium, 3 rough; _DIR of CYCLE800.
                smoothing: SmoothingWords { tolerance: true, levels: [Some(3), Some(2), Some(1)] },
                pose: PoseSelector::Higher,
                blank: true,
                left_over: SIEMENS_LEFT,
                offset_guard: true,
                ..ISO
            },
            Self::Heidenhain => Facts {
                thread_takes_feed: false,
                form: LineForm::Statements,
                registers: LengthRegisters::Rows,
                length_moves: false,
                length_off_at_machine_coordinates: false,
                radius_registers: false,
                radius_delta: true,
                plane_guard: true,
                guard_in_mm: true,
                feed_in_tenths_of_inch: true,
                feed_counts_degrees: true,
                rapids_interpolated: true,
                plane_off_before_retract: true,
                plane_by_tool_call: true,
                tool_axis_interpolation: true,
                offset_rows: true,
                length_ends_tip_control: false,
                least_increments: false,
                semicolon_comments: true,
                program_numbers: false,
                frames_are_options: false,
                functions: Order::Before,
                motion_modal: false,
                guard_source: GuardSource::Row,
                // HSC-MODE:1 rough, 0 finish.
                smoothing: SmoothingWords { tolerance: true, levels: [Some(1), Some(1), Some(0)] },
                pose: PoseSelector::Sign,
                rotary_path_selected: true,
                blank: true,
                left_over: HEIDENHAIN_LEFT,
                offset_guard: true,
                ..ISO
            },
        }
    }
}
