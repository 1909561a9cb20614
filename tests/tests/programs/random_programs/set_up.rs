//! Random set-ups, as configuration files that a user could have written.

use std::collections::BTreeMap;

use pp_runtime::config::Mode;
use tests::random::Random;

use super::cl::{AxisRange, FRAMES, Frames, Needs, TOOLS};

/// Codes that machine builders add, for coolant and clamps, and those of AUXFUN and of the blocks of operations.
pub(crate) const BUILDER_CODES: [&str; 13] =
    ["M7", "M83", "M84", "M85", "M88", "M89", "M10", "M11", "M68", "M69", "M77", "M78", "M79"];

/// Properties of a machine on which a set-up depends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MachineKind {
    /// Name for `with_machine!`.
    pub(crate) name: &'static str,
    pub(crate) rotaries: &'static [char],
    /// Travel of these axes, degrees; wide enough for every tool axis of `axis_range`.
    pub(crate) travel: &'static [(char, i32, i32)],
    /// Rotary axes without limits.
    pub(crate) endless: &'static [char],
    pub(crate) axis_range: AxisRange,
    /// Whether a rotary axis rotates the part.
    pub(crate) table: bool,
    /// Whether a rotary axis rotates the tool.
    pub(crate) head: bool,
}

/// Kinds of machines.
pub(crate) const KINDS: &[MachineKind] = &[
    MachineKind {
        name: "spinner-u5-620",
        rotaries: &['C', 'B'],
        travel: &[('C', -200, 200), ('B', -100, 100)],
        endless: &['C'],
        axis_range: AxisRange::UpTo(90),
        table: true,
        head: false,
    },
    MachineKind {
        name: "dmu-70e",
        rotaries: &['C', 'B'],
        travel: &[('C', -190, 270), ('B', -180, 180)],
        endless: &['C'],
        axis_range: AxisRange::UpTo(85),
        table: true,
        head: false,
    },
    MachineKind {
        name: "lola-xoyzba",
        rotaries: &['A', 'B'],
        travel: &[('A', -100, 100), ('B', -110, 110)],
        endless: &['A', 'B'],
        axis_range: AxisRange::UpTo(80),
        table: false,
        head: true,
    },
    MachineKind {
        name: "multiprodesk",
        rotaries: &['A'],
        travel: &[('A', -100, 100)],
        endless: &['A'],
        axis_range: AxisRange::AboutX,
        table: true,
        head: false,
    },
    MachineKind {
        name: "head-table",
        rotaries: &['C', 'B'],
        travel: &[('C', -200, 200), ('B', -100, 100)],
        endless: &['C', 'B'],
        axis_range: AxisRange::UpTo(85),
        table: true,
        head: true,
    },
    MachineKind {
        name: "mill",
        rotaries: &[],
        travel: &[],
        endless: &[],
        axis_range: AxisRange::Vertical,
        table: false,
        head: false,
    },
];

/// Keys of a file by section; the empty name has the keys before the first section.
struct File<'r> {
    random: &'r mut Random,
    sections: BTreeMap<&'static str, Vec<String>>,
}

/// A random configuration file, and the properties on which the CL data depends.
/// `blocks` decides on the blocks of operations.
pub(crate) fn set_up(
    random: &mut Random,
    blocks: &mut Random,
    kind: &MachineKind,
    control: &str,
    mode: Mode,
) -> (String, Needs) {
    let mut file = File { random, sections: BTreeMap::new() };
    file.put("", "units = \"mm\"");
    file.tolerances_and_defaults();
    let insert = file.random.chance(0.3);
    if insert {
        file.put("cl", "insert = \"comment\"");
    }
    let nx = file.random.chance(0.6);
    if !nx {
        file.put("cl", "dialect = \"iso\"");
    }
    let given_offsets = file.part_and_tools(kind, control, mode);
    file.rapids_and_retracts(kind);
    let park = file.park(kind);
    file.course(kind);
    file.words(kind, control, given_offsets);
    file.tip_control(kind, control, mode);
    file.operations(kind, control, mode);
    file.retracts_and_stops(kind, control);
    let compensation = mode != Mode::Tcp && (mode == Mode::Plane || !kind.head) && file.random.chance(0.4);
    if compensation {
        let path = ["centre", "contour"][file.random.below(2)];
        file.put("compensation", format!("path = \"{path}\""));
    }
    let inches = file.random.chance(0.2);
    let still = mode == Mode::Plane;
    let registers = registers(control);
    let frames = if nx { file.frames(kind) } else { Frames::None };
    let code = file.maybe(0.2, "cl", "auxfun = [77]");
    file.operation_blocks(blocks);
    if control == "haas" && blocks.chance(0.3) {
        file.put("control", "plane_by = \"tilted_plane\"");
    }
    file.put("control", "effects = { M77 = \"none\", M78 = \"none\", M79 = \"none\" }");
    let centre = file.maybe(0.1, "", "cl_point = \"centre\"");
    let (axis_range, table) = (kind.axis_range, kind.table);
    let needs = Needs {
        axis_range,
        table,
        still,
        inches,
        compensation,
        nx,
        insert,
        park,
        registers,
        given_offsets,
        frames,
        code,
        centre,
    };
    (file.text(), needs)
}

/// Whether the control has registers for lengths and radii.
fn registers(control: &str) -> bool {
    matches!(control, "linuxcnc" | "fanuc" | "haas")
}

impl File<'_> {
    fn put(&mut self, section: &'static str, line: impl Into<String>) {
        self.sections.entry(section).or_default().push(line.into());
    }

    /// Writes a line with some probability.
    fn maybe(&mut self, probability: f64, section: &'static str, line: impl Into<String>) -> bool {
        let chosen = self.random.chance(probability);
        if chosen {
            self.put(section, line);
        }
        chosen
    }

    fn one_of(&mut self, probability: f64, section: &'static str, key: &str, values: &[&str]) {
        let value = values[self.random.below(values.len())];
        self.maybe(probability, section, format!("{key} = {value}"));
    }

    fn between(&mut self, lower: f64, upper: f64) -> f64 {
        let value = self.random.between(lower, upper);
        if self.random.chance(0.5) { value.round() } else { (value * 1e4).round() / 1e4 }
    }

    fn text(self) -> String {
        let section = |(name, lines): (&str, Vec<String>)| {
            let head = if name.is_empty() { String::new() } else { format!("[{name}]\n") };
            format!("{head}{}\n\n", lines.join("\n"))
        };
        self.sections.into_iter().map(section).collect()
    }

    /// Tolerances, arcs, cycles and defaults.
    fn tolerances_and_defaults(&mut self) {
        self.one_of(0.4, "", "tolerance", &["0.02", "0.005", "0.05", "0.003"]);
        self.one_of(0.2, "", "axis_tolerance_path", &["0.05", "0.5", "0.02"]);
        self.one_of(0.15, "", "output_units", &["\"mm\"", "\"in\""]);
        self.one_of(0.3, "arcs", "output", &["\"native\"", "\"lines\""]);
        self.one_of(0.3, "arcs", "form", &["\"centre\"", "\"radius\""]);
        self.one_of(0.1, "arcs", "largest_radius", &["20.0", "200.0"]);
        self.one_of(0.3, "cycles", "output", &["\"native\"", "\"expanded\""]);
        self.one_of(0.3, "cycles", "rigid", &["true", "false"]);
        self.one_of(0.1, "cl", "allow_lintol", &["true"]);
        self.put("defaults", "speed = 2000");
        self.put("defaults", "direction = \"CLW\"");
        self.one_of(0.2, "defaults", "peck_gap", &["0.2", "1.0"]);
        self.one_of(0.2, "defaults", "coolant", &["\"mist\"", "\"flood\""]);
    }

    /// Frames after the first.
    fn frames(&mut self, kind: &MachineKind) -> Frames {
        let frames = match self.random.below(5) {
            0 => Frames::Main,
            1 => Frames::SetUps,
            _ => return Frames::None,
        };
        if frames == Frames::Main {
            self.put("cl", "frames = \"main\"");
            return frames;
        }
        for (number, section) in (2..=FRAMES).zip(["set_ups.2", "set_ups.3"]) {
            self.put(section, format!("frames = [{number}]\nwork_offset = \"G{}\"", 56 + number));
            let [x, y, z] = [self.between(-40.0, 40.0), self.between(-40.0, 40.0), self.between(-20.0, 60.0)];
            self.maybe(0.7, section, format!("part_origin = [{x:?}, {y:?}, {z:?}]"));
            let rotation = ["[0.0, 0.0, 0.0]", "[0.0, 0.0, 90.0]", "[0.0, 0.0, -30.0]"][self.random.below(3)];
            let turns = if kind.axis_range == AxisRange::AboutX { 0.0 } else { 0.5 };
            self.maybe(turns, section, format!("part_rotation = {rotation}"));
        }
        frames
    }

    /// Part and tools. Returns a bit for each tool whose length register is in the configuration.
    fn part_and_tools(&mut self, kind: &MachineKind, control: &str, mode: Mode) -> u32 {
        if self.random.chance(0.7) {
            let [x, y, z] = [self.between(-60.0, 60.0), self.between(-60.0, 60.0), self.between(-40.0, 120.0)];
            self.put("", format!("part_origin = [{x:?}, {y:?}, {z:?}]"));
        }
        let tilts_freely = kind.axis_range != AxisRange::Vertical && kind.axis_range != AxisRange::AboutX;
        self.maybe(if tilts_freely { 0.1 } else { 0.0 }, "", "part_rotation = [0.0, 0.0, 30.0]");
        self.one_of(0.1, "", "program_zero", &["\"table\"", "\"part\""]);
        self.one_of(0.1, "", "length_mode", &["\"gauge\"", "\"tip\""]);
        let offsets = ["\"G54\"", "\"G55\"", "\"G57\""];
        self.one_of(0.4, "", "work_offset", &offsets);
        let mut given_offsets = 0;
        for tool in 1..=TOOLS {
            let length = self.between(60.0, 160.0);
            let registers = if registers(control) { [", offset = 7", ", radius_offset = 9"] } else { [""; 2] };
            let more = ["", ", coolant = \"mist\"", registers[0], registers[1]][self.random.below(4)];
            given_offsets |= u32::from(more.starts_with(", offset")) << tool;
            self.put("tools", format!("{tool} = {{ length = {length:?}{more} }}"));
        }
        if mode == Mode::Axes && self.random.chance(0.1) && !kind.rotaries.is_empty() {
            let letter = kind.rotaries[self.random.below(kind.rotaries.len())];
            self.put("rotary_offset", format!("{letter} = 12.5"));
        }
        if self.random.chance(0.3) {
            self.put("machine_zero", "X = 0.0\nY = 0.0\nZ = -700.0");
            self.put("limits", "X = [-900.0, 900.0]\nY = [-900.0, 900.0]\nZ = [-1500.0, 900.0]");
        }
        given_offsets
    }

    /// Blocks of the shop at the start and the end of operations.
    fn operation_blocks(&mut self, random: &mut Random) {
        let keys = self.sections.get("").into_iter().flatten();
        if keys.clone().any(|line| line.starts_with("transition")) {
            return;
        }
        let at_end = if random.chance(0.3) { "M78" } else { "M79" };
        for (key, code) in [("operation_start", "M78"), ("operation_end", at_end)] {
            if random.chance(0.15) {
                self.put("program", format!("{key} = [\"{code}\"]"));
            }
        }
    }

    /// Rapids, retracts and transitions.
    fn rapids_and_retracts(&mut self, kind: &MachineKind) {
        let rapid = self.random.below(6);
        match rapid {
            0 => self.put("", "rapid = \"split\""),
            1 => self.put("", "rapid = \"feed\"\nrapid_feed = 8000.0"),
            2 => self.put("", "rapid_feed = 5000.0"),
            _ => {}
        }
        self.one_of(0.2, "", "links", &["\"safe\"", "\"follow\""]);
        self.one_of(0.2, "control", "linear_rapids", &["true", "false"]);
        self.one_of(0.15, "", "transition", &["\"direct\""]);
        self.one_of(0.15, "", "stop_retract", &["false"]);
        self.one_of(0.3, "", "spindle_dwell", &["1.0", "2.5"]);
        self.one_of(0.1, "", "index_angle", &["0.0", "10.0", "45.0", "360.0"]);
        self.one_of(0.2, "", "reorient_speed", &["720.0", "3600.0"]);
        if kind.head || self.random.chance(0.7) {
            let distance = self.between(20.0, 120.0);
            self.put("retract", format!("distance = {distance:?}"));
        } else if self.random.chance(0.6) {
            let geometries = [
                "{ plane = 200.0 }",
                "{ box = [[-200, -200, -200], [200, 200, 200]] }",
                "{ cylinder = { radius = 220, lower = -200, upper = 200 } }",
            ];
            let geometry = geometries[self.random.below(3)];
            self.put("retract", format!("clearance = {geometry}"));
        }
        self.one_of(0.2, "retract", "position", &["-5.0", "0.0"]);
        self.one_of(0.2, "retract", "rewind", &["\"follow\"", "\"leave\""]);
        self.one_of(0.1, "retract", "rewind_dry", &["true"]);
        if self.random.chance(0.5) {
            let distance = self.between(5.0, 80.0);
            self.put("approach", format!("distance = {distance:?}"));
        }
        let inverse_time =
            ["5000.0\nlargest_inverse_time = 777.7777", "30000.0", "900.0\nlargest_inverse_time = 9999.99"];
        self.one_of(0.3, "feed", "largest", &inverse_time);
        self.one_of(0.1, "feed", "keep_speeds", &["false"]);
        self.one_of(0.2, "feed", "shortest_block", &["0.01", "0.1"]);
    }

    /// Parking positions; returns whether there is one.
    fn park(&mut self, kind: &MachineKind) -> bool {
        let mut park = self.maybe(0.2, "park", "Y = 200.0");
        for letter in kind.rotaries {
            park |= self.maybe(0.2, "park", format!("{letter} = 0.0"));
        }
        park
    }

    /// Branches, turns, clamps.
    fn course(&mut self, kind: &MachineKind) {
        if kind.rotaries.is_empty() {
            return;
        }
        self.one_of(0.2, "course", "start_branch", &["\"first\"", "\"second\""]);
        self.one_of(0.2, "course", "greedy", &["true"]);
        self.one_of(0.1, "course", "axis_tolerance", &["0.05", "0.5"]);
        let letter = kind.rotaries[self.random.below(kind.rotaries.len())];
        let side = ["+", "-"][self.random.below(2)];
        self.maybe(0.2, "course", format!("prefer = \"{letter}{side}\""));
        for &(letter, lower, upper) in kind.travel {
            if self.random.chance(0.3) {
                self.put("limits", format!("{letter} = [{lower}, {upper}]"));
            } else if kind.endless.contains(&letter) {
                self.one_of(0.25, "wrap", &letter.to_string(), &["\"0..360\"", "\"+-180\"", "\"sign\"", "\"none\""]);
            }
        }
        for (index, letter) in kind.rotaries.iter().enumerate() {
            let codes = ["{ on = \"M10\", off = \"M11\" }", "{ on = \"M68\", off = \"M69\" }"][index];
            self.maybe(0.15, "clamp", format!("{letter} = {codes}"));
            self.maybe(0.3, "speeds", format!("{letter} = 3600.0"));
        }
        self.maybe(0.3, "speeds", "X = 10000.0\nY = 900.0\nZ = 8000.0");
    }

    /// Formats of words, and codes of the control.
    fn words(&mut self, kind: &MachineKind, control: &str, given_offsets: u32) {
        self.one_of(0.2, "formats", "linear_mm", &["2", "4", "5"]);
        self.one_of(0.1, "formats", "linear_inch", &["3", "5"]);
        self.one_of(0.2, "formats", "rotary", &["3", "5", "2"]);
        self.one_of(0.2, "formats", "feed", &["1", "2", "4"]);
        self.one_of(0.1, "formats", "speed", &["1"]);
        if control != "heidenhain" {
            self.one_of(0.3, "program", "line_numbers", &["1", "5", "10"]);
        }
        self.one_of(0.1, "program", "times", &["true"]);
        self.one_of(0.15, "control", "every_word", &["true"]);
        self.one_of(0.1, "control", "preselect", &["true", "false"]);
        self.one_of(0.1, "control", "point", &["true", "false"]);
        // LinuxCNC compares no other register than that of the tool.
        let guard = if control == "linuxcnc" && given_offsets != 0 { "false" } else { "true" };
        self.one_of(0.2, "", "length_guard", &[guard, "false"]);
        // Codes that machine builders add.
        // M89 is a code of Heidenhain itself.
        let off = if control == "heidenhain" { "M85" } else { "M89" };
        let codes = format!("mist = [\"M7\", \"M9\"], through = [\"M88\", \"{off}\"], air = [\"M83\", \"M84\"]");
        self.put("control", format!("coolant = {{ {codes} }}"));
        let norms: &[&str] = match control {
            "heidenhain" => &["\"xyz\"", "\"xyz+deg\""],
            _ => &["\"xyz\"", "\"xyz+deg\"", "\"g93_min\""],
        };
        if !kind.rotaries.is_empty() {
            self.one_of(0.2, "control", "path_norm", norms);
        }
        let smoothings: &[&str] = if control == "linuxcnc" { &["\"none\""] } else { &["\"finish\"", "\"rough\""] };
        self.one_of(0.2, "control", "smoothing", smoothings);
    }

    /// Settings of single operations, from random numbers of their own.
    fn operations(&mut self, kind: &MachineKind, control: &str, mode: Mode) {
        let mut random = Random::new(!self.random.clone().bits());
        if !random.chance(0.3) {
            return;
        }
        let mut modes = vec!["\"auto\"", "\"axes\""];
        modes.extend((!kind.rotaries.is_empty()).then_some("\"tcp\""));
        modes.extend((!kind.rotaries.is_empty() && control != "linuxcnc").then_some("\"plane\""));
        let smoothing: &[&str] = match control {
            "linuxcnc" => &["\"none\""],
            _ => &["\"none\"", "\"rough\"", "\"medium\"", "\"finish\""],
        };
        let keys: [(&str, &[&str]); 5] = [
            ("mode", &modes),
            ("smoothing", smoothing),
            ("singular", &["\"zero\"", "\"previous\""]),
            ("tolerance", &["0.003", "0.03", "0.2"]),
            ("largest_feed", &["150.0", "333.3", "900.0"]),
        ];
        // Two patterns for the same operation could contradict each other.
        for section in ["operations.1", "operations.\"op_*\""] {
            for (key, values) in keys {
                let value = values[random.below(values.len())];
                if random.chance(0.35) {
                    self.put(section, format!("{key} = {value}"));
                }
            }
        }
        let has_mode = |lines: &Vec<String>| lines.iter().any(|line| line.starts_with("mode"));
        if mode == Mode::Axes && self.sections.values().any(has_mode) {
            self.put("", "tcp_confirmed = true");
            if control == "fanuc" && kind.table {
                self.put("", "tcp_frame = \"table_at_zero\"");
            }
            if control == "linuxcnc" {
                self.put("control", "tip_control = [\"M428\", \"M429\"]");
            }
        }
    }

    /// Machine retracts, stops, block numbers and texts of each control, from random numbers of their own.
    fn retracts_and_stops(&mut self, kind: &MachineKind, control: &str) {
        let mut random = Random::new(self.random.clone().bits().rotate_left(20));
        let methods: &[&str] = match control {
            "siemens" => &["\"SUPA\""],
            "heidenhain" => &["\"M91\""],
            // The foreign interpreter refuses every motion to a reference position.
            _ => &["\"G53\""],
        };
        let texts: &[&str] =
            if matches!(control, "linuxcnc" | "siemens") { &["\"display\""] } else { &["\"comment\""] };
        let threads: &[&str] = if matches!(control, "fanuc" | "haas") { &["\"revolution\""] } else { &["\"minute\""] };
        let homes: &[&str] = if kind.rotaries.is_empty() { &["false"] } else { &["true", "true\nxy = { Y = -50.0 }"] };
        let keys: [(f64, &str, &str, &[&str]); 6] = [
            (0.5, "retract", "method", methods),
            (0.2, "retract", "home_on_indexing", homes),
            (0.3, "", "optional_stops", &["\"tool_changes\"", "\"operations\""]),
            (0.3, "program", "messages", texts),
            (0.2, "program", "header", &["\"short\""]),
            (0.4, "cycles", "thread_feed", threads),
        ];
        for (chance, section, key, values) in keys {
            let value = values[random.below(values.len())];
            if random.chance(chance) {
                self.put(section, format!("{key} = {value}"));
            }
        }
        let numbered = |lines: &Vec<String>| lines.iter().any(|line| line.starts_with("line_numbers"));
        if control != "heidenhain" && random.chance(0.2) && !self.sections.get("program").is_some_and(numbered) {
            let blocks = ["tool_changes", "none"][random.below(2)];
            self.put("program", format!("line_numbers = \"{blocks}\""));
        }
    }

    /// Keys for tip control and tilted planes.
    fn tip_control(&mut self, kind: &MachineKind, control: &str, mode: Mode) {
        if mode == Mode::Axes {
            return;
        }
        self.put("", "tcp_confirmed = true");
        if mode == Mode::Auto {
            self.one_of(0.3, "", "auto_planes", &["1", "2", "20"]);
        }
        if mode == Mode::Plane {
            return;
        }
        if control == "linuxcnc" && (mode == Mode::Tcp || self.random.chance(0.5)) {
            self.put("control", "tip_control = [\"M428\", \"M429\"]");
        }
        let frames = ["\"table_at_zero\"", "\"table_at_start\"", "\"not_turning\""];
        if control == "fanuc" && kind.table {
            let frame = frames[self.random.below(3)];
            self.put("", format!("tcp_frame = {frame}"));
        }
        if matches!(control, "fanuc" | "siemens" | "heidenhain") && self.random.chance(0.25) {
            self.put("", "tcp_words = \"vectors\"\ntool_posture = \"plane\"");
        } else if matches!(control, "siemens" | "heidenhain") {
            self.one_of(0.15, "", "tool_posture", &["\"plane\""]);
        }
    }
}
