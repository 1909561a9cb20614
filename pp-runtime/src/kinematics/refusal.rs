//! Reasons why a machine or a pose is refused.

use core::fmt;

/// A dimension or set-up value with which the machine's formulas do not hold.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Invalid {
    /// A dimension that the declaration requires, because each machine has its own, has no value.
    Required {
        /// Name of the field, and of the key in `[dimensions]`.
        name: &'static str,
    },
    /// A dimension or set-up value is NaN or infinite.
    NotFinite {
        /// Name of the field.
        name: &'static str,
    },
    /// An expression that the proofs divide by is zero.
    Zero {
        /// The expression in the names of the declaration.
        expression: &'static str,
        /// Meaning for the machine.
        meaning: &'static str,
    },
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Required { name } => {
                write!(f, "`{name}` has no value: it is a dimension that each machine has of its own")
            }
            Self::NotFinite { name } => write!(f, "`{name}` is not a finite number"),
            Self::Zero { expression, meaning } => write!(f, "`{expression}` is zero: {meaning}"),
        }
    }
}

impl core::error::Error for Invalid {}

/// Angles between the tool axis and the first rotary axis, rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// The required angle.
    pub angle: f64,
    /// The smallest angle within reach.
    pub smallest: f64,
    /// The largest angle within reach.
    pub largest: f64,
}

impl Cone {
    /// The cone for the required angle; `between`: angle between the rotaries; `tool`: angle between the last rotary
    /// and the tool.
    #[must_use]
    pub fn new(angle: f64, between: f64, tool: f64) -> Self {
        use core::f64::consts::PI;
        Self { angle, smallest: (between - tool).abs(), largest: PI - (PI - between - tool).abs() }
    }

    /// The cone, if the required angle is outside by about the tolerance or more.
    #[must_use]
    pub fn outside(self) -> Option<Self> {
        // Half the tolerance: the angles here carry more rounding than the solver's own test.
        let slack = 0.5 * super::REACH_TOLERANCE;
        let inside = self.angle >= self.smallest - slack && self.angle <= self.largest + slack;
        if inside { None } else { Some(self) }
    }
}

/// Reason why no axis values give the required tool axis.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Unreachable {
    /// The required axis is not a unit vector of finite numbers.
    NotFinite,
    /// The machine has no solved rotary axis and its tool axis is another one.
    Fixed {
        /// The machine's name.
        machine: &'static str,
        /// The required axis.
        wanted: [f64; 3],
        /// The tool axis of the machine.
        tool_axis: [f64; 3],
    },
    /// The angle between the required axis and the first rotary direction is out of reach.
    Cone {
        /// The machine's name.
        machine: &'static str,
        /// The first solved rotary axis from the workpiece.
        rotary: char,
        /// Its direction.
        direction: [f64; 3],
        /// The required axis.
        wanted: [f64; 3],
        /// The angle between both, and the angles within reach.
        cone: Cone,
    },
    /// At the held values the second rotary is parallel to the tool or to the first rotary.
    Held {
        /// The machine's name.
        machine: &'static str,
        /// The rotary that cannot tilt the tool.
        rotary: char,
        /// The held axes and angles that it depends on.
        held: &'static str,
    },
    /// The linear axes cannot move the tip in every direction at this tool axis.
    LinearAxes {
        /// The machine's name.
        machine: &'static str,
        /// The linear axes, in chain order.
        axes: &'static str,
    },
}

impl fmt::Display for Unreachable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite => f.write_str("the tool axis is not a unit vector of finite numbers"),
            Self::Fixed { machine, wanted: [i, j, k], tool_axis: [a, b, c] } => write!(
                f,
                "{machine} has no rotary axis to tilt the tool: its axis is ({a:.4}, {b:.4}, {c:.4}), \
                 wanted ({i:.7}, {j:.7}, {k:.7})"
            ),
            Self::Cone { machine, rotary, direction, wanted, cone: Cone { angle, smallest, largest } } => {
                // The tool is always perpendicular to a coordinate direction: name that direction.
                let square =
                    (largest - smallest).abs() < 1e-9 && (smallest - core::f64::consts::FRAC_PI_2).abs() < 1e-9;
                let towards = direction.iter().position(|component| (component.abs() - 1.0).abs() < 1e-9);
                if let (true, Some(index)) = (square, towards) {
                    let (letter, name) = [('X', 'i'), ('Y', 'j'), ('Z', 'k')][index];
                    // Seven digits, as in CL data.
                    let component = (wanted[index] * 1e7 + 0.5_f64.copysign(wanted[index])) as i64 as f64 / 1e7;
                    return write!(f, "{machine} cannot tilt the tool towards {letter}: {name} = {component}");
                }
                write!(
                    f,
                    "{machine} cannot bring the tool to {:.4}° from the axis of {rotary}: it reaches {:.4}° to {:.4}°",
                    angle.to_degrees(),
                    smallest.to_degrees(),
                    largest.to_degrees()
                )
            }
            Self::Held { machine, rotary, held } => {
                write!(f, "{machine} cannot tilt the tool with {rotary} at the present values of {held}")
            }
            Self::LinearAxes { machine, axes } => {
                write!(
                    f,
                    "at this tool axis the linear axes {axes} of {machine} cannot move the tip in every direction"
                )
            }
        }
    }
}

impl core::error::Error for Unreachable {}
