//! Base table of the controls that write ISO blocks (ISO 6983-1, and the codes beyond it that milling controls share).
//!
//! [`Spellings::ISO`] has no name, no tip control and no tilted plane. Every other entry is shared by at least two of
//! the controls; differences are in the file of the control, with their source. Entries that no two controls share
//! (name, title, line length, rotary note, where numbers are found) are empty here, and a test refuses a control that
//! leaves them empty.
//!
//! `/` before the block number marks a block that the operator may have skipped, as Autodesk's public posts for these
//! controls write it; LinuxCNC: `interp_read.cc`, block delete. Fanuc and Haas read `/` at the head of a block so, and
//! elsewhere in a block as a division (from memory).

use crate::motion::{CycleAbilities, Registers};
use crate::nc::{Formats, Numerals};
use crate::options::PathNorm;

use super::spellings::{
    ArcCentre, ArcCodes, CommentStyle, CycleCodes, CycleForm, HoleCycles, LengthCall, LengthCodes, LinearRapids,
    MachineRetract, Spellings, ThreadCodes, ascii_in_brackets,
};

impl Spellings {
    /// Codes that ISO controls share.
    pub const ISO: Self = Self {
        name: "",
        title: "",
        formats: Formats::DEFAULT,
        numerals: Numerals { point: false, plus: false },
        line_length: 0,
        numbers_every_line: false,
        offset_has_coordinates: true,
        // LinuxCNC, M codes; Fanuc B-63944EN/02 (2004), auxiliary function; Haas 96-8000 (1999), M codes.
        own_m: &[
            (19, "spindle to an angle"),
            (30, "end of program"),
            (98, "call of a subprogram"),
            (99, "end of a subprogram"),
        ],
        comment: CommentStyle { marks: ["(", ")"], length: 72, byte: ascii_in_brackets },
        operation: None,
        message: None,
        skips_guards: true,
        opening: &[],
        end: "M30",
        closing: &[],
        number_digits: 0,
        plain_name: false,
        units: ["G21", "G20"],
        safety: &["{units} G17 G40 G49 G80 G90 G94 {work_offset}"],
        cancels: &[],
        per_minute: "G94",
        per_revolution: "",
        offset_title: "",
        inverse_time: Some("G93"),
        largest_inverse_time: f64::INFINITY,
        linear_rapids: LinearRapids::No,
        times_faint_moves: false,
        tip_control_holds_axis_speeds: true,
        path_norm: PathNorm::G93Minutes,
        feed_per_inch: 1.0,
        rapid: "G0",
        rapid_end: "",
        feed: "G1",
        arcs: ArcCodes::ISO,
        cycles: Some(HoleCycles { abilities: CycleAbilities::CODES, form: CycleForm::Codes(CycleCodes::ISO) }),
        motion_modal: true,
        no_compensation: "",
        compensation: ["G41 D{radius}", "G42 D{radius}", "G40"],
        radius_data: ["D must hold the radius of the tool", "D must hold wear only"],
        straight_corners: None,
        machine: ["G53 G0", ""],
        retracts: &[MachineRetract::to_machine_coordinate("G53")],
        tool_change: &["T{tool} M6", "T{next}"],
        // From memory: usual on machines with this control.
        empty_spindle_note: "T0 puts the tool away and leaves the spindle empty, which no public manual of this control states",
        tool_name: None,
        tool_name_byte: |_| false,
        preselect: true,
        length: LengthCodes::ISO,
        speed: None,
        spindle: ["S{speed} M3", "S{speed} M4"],
        spindle_off: "M5",
        coolant_off: "M9",
        coolant: [Some(["M8", "M9"]), Some(["M7", "M9"]), None, None],
        stop: ["M0", "M1"],
        dwell: &["G4 P{seconds}"],
        longest_dwell: 99_999_000,
        smoothing: [&[], &[], &[]],
        smoothing_with_angle: [&[], &[], &[]],
        smoothing_off: &[],
        blending: &[],
        rotary_path: ["", ""],
        shortest_word: None,
        shortest_note: "",
        may_begin_in_tip_control: false,
        tip: None,
        plane: None,
        rotary_note: "",
        found_at: &[],
        examples: &[],
        unused_keys: &[],
    };
}

impl ArcCodes {
    /// G2 and G3 in all three planes, the centre as I J K from the start.
    pub const ISO: Self = Self {
        senses: ["G2", "G3"],
        planes: [Some("G19"), Some("G18"), Some("G17")],
        centre: ArcCentre::Offsets,
        radius: "R",
        // Smaller than the limit of the controls as delivered.
        radius_tolerance_mm: 0.002,
    };
}

impl CycleCodes {
    /// G81 to G89 with X Y Z R and F.
    pub const ISO: Self = Self {
        returns: ["G99", "G98"],
        drill: ["G81", "G82"],
        peck: "G83",
        chip_break: "G73",
        ream: ["G85", "G89"],
        thread: ThreadCodes::Cycle { codes: ["G84", "G74"], rigid: "" },
        fine_bore: "",
        bore_setting: "",
        bore_shift_by_axis: false,
        dwell: "P{seconds}",
        end: "G80",
    };
}

impl LengthCodes {
    /// G43 H in the block that moves Z, and G49 in the block that moves Z to its machine position, because both may
    /// move Z.
    pub const ISO: Self = Self {
        code: "G43 H{offset}",
        call: LengthCall::WithZ,
        off: "G49",
        cancelled_by_machine_coordinates: true,
        registers: Registers::Shared,
        address: "H",
    };
}
