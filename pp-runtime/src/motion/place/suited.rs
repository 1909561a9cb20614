//! Whether a mode suits a machine, its control and a configuration.

use nalgebra::Vector3;

use crate::kinematics::{AnyMachine, Side, carried};
use crate::motion::policy::Policy;
use crate::options::{StretchMode, TcpFrame, TcpWords, ToolPosture};
use crate::set_up::LengthMode;

use super::chain::rotaries;
use super::frame::{TipAbility, TipStart};
use crate::tolerance::writer::COORDINATE_AXIS;

/// Modes other than axis positions that machine, control and configuration allow.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct UsableModes {
    /// Tip control.
    pub tip: bool,
    /// Tilted planes.
    pub plane: bool,
    /// Settings without which these two cannot be written; empty where none is missing.
    missing: [Option<String>; 2],
}

/// Reason why a mode cannot be used.
enum Unsuited {
    /// Machine or control do not have it.
    Absent(String),
    /// A setting is missing, or another one is needed.
    Setting(String),
}

impl Unsuited {
    fn text(self) -> String {
        match self {
            Self::Absent(text) | Self::Setting(text) => text,
        }
    }
}

impl UsableModes {
    /// The modes that mode `auto` chooses from.
    #[must_use]
    pub fn of(
        machine: &dyn AnyMachine,
        policy: Policy<'_>,
        control: &str,
        tip: Option<TipAbility>,
        has_planes: bool,
    ) -> Self {
        let rotates = rotaries(machine.axes(), Side::Workpiece).chain(rotaries(machine.axes(), Side::Tool)).next();
        let faults = |mode| ReasonSearch { machine, policy, control, mode, list: Vec::new() }.find(tip, has_planes);
        let [tip, plane] = [StretchMode::Tcp, StretchMode::Plane].map(faults);
        let absent = |fault: &Unsuited| matches!(fault, Unsuited::Absent(_));
        let usable = |faults: &[Unsuited]| rotates.is_some() && !faults.iter().any(absent);
        Self {
            tip: usable(&tip),
            plane: usable(&plane),
            missing: [tip, plane].map(|faults| faults.into_iter().next().map(Unsuited::text)),
        }
    }

    /// The setting without which a mode cannot be written.
    pub(crate) fn missing(&self, mode: StretchMode) -> Option<&str> {
        match mode {
            StretchMode::Axes => None,
            StretchMode::Tcp => self.missing[0].as_deref(),
            StretchMode::Plane => self.missing[1].as_deref(),
        }
    }
}

/// Reasons why a machine, its control and a configuration do not suit the configured mode, one sentence each. Mode
/// `auto` suits all of them, and so does a mode for some operations: what a stretch needs is known with the CL data.
#[must_use]
pub(crate) fn unsuited(
    machine: &dyn AnyMachine,
    policy: Policy<'_>,
    control: &str,
    tip: Option<TipAbility>,
    has_planes: bool,
) -> Vec<String> {
    let Some(mode) = policy.options.mode_of_all() else { return Vec::new() };
    let Ok(machine) = policy.set_up.machine_for(machine) else { return Vec::new() };
    let faults = ReasonSearch { machine: &*machine, policy, control, mode, list: Vec::new() };
    faults.find(tip, has_planes).into_iter().map(Unsuited::text).collect()
}

/// Search for the reasons why a mode cannot be used.
struct ReasonSearch<'a> {
    machine: &'a dyn AnyMachine,
    policy: Policy<'a>,
    control: &'a str,
    mode: StretchMode,
    list: Vec<Unsuited>,
}

impl ReasonSearch<'_> {
    fn absent(&mut self, text: &str, instead: &str) {
        self.list.push(Unsuited::Absent(format!("mode {}: {text}; {instead}", self.mode.name())));
    }

    fn setting(&mut self, text: &str, instead: &str) {
        self.list.push(Unsuited::Setting(format!("mode {}: {text}; {instead}", self.mode.name())));
    }

    fn find(mut self, tip: Option<TipAbility>, has_planes: bool) -> Vec<Unsuited> {
        if self.mode == StretchMode::Axes {
            return self.list;
        }
        let configured = tip.is_some_and(|tip| tip.start == TipStart::Configured);
        self.machine(self.mode == StretchMode::Tcp && configured);
        match (self.mode, tip) {
            (StretchMode::Axes, _) => {}
            (StretchMode::Tcp, Some(tip)) => self.tip_control(tip),
            (StretchMode::Tcp, None) => {
                let text = format!("{} has no tip control (TCP) by default", self.control);
                let instead =
                    "give the codes that switch it on and off, `[control] tip_control = [on, off]`, or use mode axes";
                self.absent(&text, instead);
            }
            (StretchMode::Plane, _) if !has_planes => {
                let text = format!("{} has no tilted work plane, or not among its `functions`", self.control);
                self.absent(&text, "mode axes works on any control, mode tcp on most");
            }
            (StretchMode::Plane, _) if !tool_along_z(self.machine) => {
                self.absent("the tool axis of this machine is not parallel to Z", "use mode axes");
            }
            (StretchMode::Plane, _) => {}
        }
        self.list
    }

    /// What tip control and planes both need. `kinematics_of_its_own`: the control has kinematics of this machine, not
    /// those of a kind of machine.
    fn machine(&mut self, kinematics_of_its_own: bool) {
        if self.policy.set_up.length_mode == LengthMode::Gauge {
            self.absent("the control needs an active tool length offset", "leave `length_mode` at \"tip\"");
        }
        if !kinematics_of_its_own && let Some([rotary, linear]) = carried(self.machine.axes()) {
            let (rotary, linear) = (rotary.letter, linear.letter);
            let text = format!(
                "{rotary} carries {linear}, which rotates with it: the control assumes X, Y and Z next to the bed"
            );
            self.absent(&text, "use mode axes");
        }
        let inclined = ['X', 'Y', 'Z'].into_iter().find(|letter| !is_own_direction(self.machine, *letter));
        match inclined {
            Some(letter) if !kinematics_of_its_own => {
                let text = format!(
                    "{letter} of this machine is not parallel to the {letter} direction, as the control assumes"
                );
                self.absent(&text, "use mode axes");
            }
            Some(letter) if !self.policy.options.tip.tcp_confirmed => {
                let text = format!("the kinematics of the control may not include that {letter} is inclined");
                self.setting(&text, CONFIRM);
            }
            _ => {}
        }
        let offset = self.policy.set_up.rotary_offset.iter().find(|(_, offset)| offset.abs() > 0.0);
        if let Some((letter, _)) = offset.filter(|_| !self.policy.options.tip.tcp_confirmed) {
            let text = format!(
                "on some controls the coordinate system of tip control and planes rotates with the value of {letter} in the work \
                 offset; the words are computed for one that does not"
            );
            let instead = "use `part_rotation` instead of `rotary_offset`, or set `tcp_confirmed = true` if the coordinate system of \
                           this control does not rotate with the work offset";
            self.setting(&text, instead);
        }
    }

    fn tip_control(&mut self, ability: TipAbility) {
        let (machine, control, tip) = (self.machine, self.control, &self.policy.options.tip);
        let table = rotaries(machine.axes(), Side::Workpiece).next().is_some();
        let head = rotaries(machine.axes(), Side::Tool).next().is_some();
        if ability.frame_is_parameter && table && tip.tcp_frame.is_none() {
            let text = "parameter 19696#5 of the machine selects the frame of the tip coordinates while the table rotates: 0 is \
                        that of the table at G43.4, 1 one that does not rotate (A-79348E, p. 19)";
            let instead = "read the parameter and give `tcp_frame`: \"table_at_start\" for 0, \"not_turning\" for 1; \
                           \"table_at_zero\" for a control that is proven to keep the frame of the table at zero with 0";
            self.setting(text, instead);
        }
        if !ability.frame_is_parameter && tip.tcp_frame.is_some_and(|frame| frame != TcpFrame::TableAtZero) {
            let text = format!("{control} has its tip coordinates in the frame of the table at zero");
            self.setting(&text, "leave `tcp_frame` out");
        }
        if tip.tool_posture == ToolPosture::Plane && !ability.rotates_axis_in_plane {
            let text = format!("{control} interpolates the rotary axes linearly");
            self.setting(&text, "leave `tool_posture` at \"axes\"");
        }
        if tip.tcp_words == TcpWords::Vectors && !ability.takes_vectors {
            let text = format!("{control} does not accept the tool axis as a vector");
            self.setting(&text, "leave `tcp_words` at \"angles\"");
        }
        if tip.tcp_words == TcpWords::Vectors && tip.tcp_frame == Some(TcpFrame::NotTurning) {
            let text = "a tool axis as a vector has no meaning in a frame that does not rotate with the table";
            self.setting(text, "leave `tcp_words` at \"angles\"");
        }
        // Without a rotary table no frame rotates.
        if tip.tcp_frame == Some(TcpFrame::NotTurning) && table && (head || tip.tool_posture == ToolPosture::Plane) {
            let text = "in a frame that does not rotate, the path is certified only for rotary axes of the table that are \
                        interpolated linearly";
            self.setting(text, "use mode axes");
        }
        let held = machine.axes().iter().any(|axis| axis.held);
        if !tip.tcp_confirmed && (held || carried(machine.axes()).is_some()) {
            let text = "the kinematics of the control may not include a held axis, or a linear axis that is not between \
                        table and head";
            self.setting(text, CONFIRM);
        }
    }
}

/// What to do where the kinematics in the control are those of the machine builder.
const CONFIRM: &str = "set `tcp_confirmed = true` if the control knows this axis, or use mode axes";

/// Whether the axis of a letter is parallel to that direction of the machine frame; its word may run backwards.
fn is_own_direction(machine: &dyn AnyMachine, letter: char) -> bool {
    let index = machine.axes().iter().position(|axis| axis.letter == letter && !axis.held);
    let own = match letter {
        'X' => Vector3::x(),
        'Y' => Vector3::y(),
        _ => Vector3::z(),
    };
    index.is_some_and(|index| (machine.joint(index).direction.into_inner() - own).norm() < COORDINATE_AXIS)
}

fn tool_along_z(machine: &dyn AnyMachine) -> bool {
    (machine.tool_axis().into_inner() - Vector3::z()).norm() < COORDINATE_AXIS
}
