//! Travel of the linear axes, compared after rounding.
//!
//! Limits are machine coordinates: `M = machine_zero + q + g`, where `q` is the axis value and `g` the share of the
//! gauge length along the axis; in a further set-up `q` counts from the part zero of the first. Without `machine_zero`
//! only the span of `q + g` over the program is compared with the travel.

use nalgebra::Vector3;

use crate::diag::code::plan;
use crate::kinematics::math::{larger, smaller};
use crate::kinematics::{AnyMachine, AxisKind, Limits, Side};
use crate::motion::fault::Fault;
use crate::motion::policy::Policy;
use crate::motion::step::MAX_AXES;
use crate::program::Units;

use super::chain::rotaries;
use crate::set_up::along_axes;
use crate::tolerance::writer::{AXIS_VALUE_NOISE, NO_GAUGE_SHARE};

/// Travel of one solved linear axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LinearTravel {
    /// Position in the chain.
    pub(crate) index: usize,
    letter: char,
    /// Unit of the program, for messages.
    units: Units,
    limits: Option<Limits>,
    machine_zero_mm: Option<f64>,
    /// `g` for a gauge length of 1 mm.
    share: f64,
    /// Smallest and largest `q + g` so far, mm.
    pub(crate) span: Option<(f64, f64)>,
    /// The tool side has rotary axes: the tool length moves the axis by an amount that depends on their angles.
    has_rotary_head: bool,
    /// Some points could not be compared because the gauge length is unknown.
    pub(crate) unknown_length: bool,
}

/// The travel of all solved linear axes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TravelCheck {
    axes: Vec<LinearTravel>,
    /// The travel of at least one is declared.
    limited: bool,
    /// Gauge length of the tool, if known.
    gauge_length_mm: Option<f64>,
    /// Part zero of the first set-up, for which `machine_zero` is stated.
    first_origin: Vector3<f64>,
    /// Axis values of the part zero, from that of the first set-up.
    moved_mm: [f64; MAX_AXES],
}

impl TravelCheck {
    pub(crate) fn new(machine: &dyn AnyMachine, policy: Policy<'_>, units: Units) -> Self {
        let limits = policy.set_up.travel(machine.axes()).limits;
        let solved: Vec<usize> = (0..machine.axes().len())
            .filter(|&i| machine.axes()[i].kind == AxisKind::Linear && !machine.axes()[i].held)
            .collect();
        let shares = along_axes(machine, &machine.tool_axis());
        let has_rotary_head = rotaries(machine.axes(), Side::Tool).next().is_some();
        let axes: Vec<LinearTravel> = solved
            .iter()
            .map(|&index| LinearTravel {
                index,
                letter: machine.axes()[index].letter,
                units,
                limits: limits[index],
                machine_zero_mm: policy.set_up.machine_zero.get(&machine.axes()[index].letter).copied(),
                share: shares[index],
                span: None,
                has_rotary_head,
                unknown_length: false,
            })
            .collect();
        let first_origin = policy.set_up.part_origin.into();
        let limited = axes.iter().any(LinearTravel::limited);
        Self { axes, limited, gauge_length_mm: None, first_origin, moved_mm: [0.0; MAX_AXES] }
    }

    /// Sets the position of the part zero from the reference point of the table.
    pub(crate) fn set_part_origin(&mut self, machine: &dyn AnyMachine, origin: &Vector3<f64>) {
        self.moved_mm = along_axes(machine, &(origin - self.first_origin));
    }

    /// Whether the travel of all axes is known.
    pub(crate) fn is_known(&self) -> bool {
        self.axes.iter().all(|axis| axis.limits.is_some())
    }

    /// Gauge length of the tool, if known, mm.
    pub(crate) fn gauge_length_mm(&self) -> Option<f64> {
        self.gauge_length_mm
    }

    pub(crate) fn axes(&self) -> &[LinearTravel] {
        &self.axes
    }

    pub(crate) fn set_gauge_length(&mut self, length: Option<f64>) {
        self.gauge_length_mm = length;
    }

    /// Compares a point of the program with the limits; `values` are rounded axis values, mm.
    #[inline]
    pub(crate) fn check(&mut self, values: &[f64]) -> Result<(), Fault> {
        if self.limited { self.compare(values) } else { Ok(()) }
    }

    fn compare(&mut self, values: &[f64]) -> Result<(), Fault> {
        let length = self.gauge_length_mm;
        for axis in &mut self.axes {
            axis.check(values[axis.index] + self.moved_mm[axis.index], length)?;
        }
        Ok(())
    }

    /// Whether [`check`](Self::check) of this point would refuse it, or note something. Where it does neither at two
    /// points, it does neither at any whose values are between theirs.
    pub(crate) fn is_changed_by(&self, values: &[f64]) -> bool {
        self.axes.iter().filter(|axis| axis.limited()).any(|axis| {
            let mut after = *axis;
            let checked = after.check(values[axis.index] + self.moved_mm[axis.index], self.gauge_length_mm);
            checked.is_err() || after != *axis
        })
    }

    /// The travel that each axis has needed so far.
    pub(crate) fn needed(&self) -> [Option<(f64, f64)>; MAX_AXES] {
        std::array::from_fn(|index| self.axes.iter().find(|axis| axis.index == index)?.span)
    }

    /// Takes back points that were compared, but are not in the program.
    pub(crate) fn take_back(&mut self, needed: &[Option<(f64, f64)>; MAX_AXES]) {
        for axis in &mut self.axes {
            axis.span = needed[axis.index];
        }
    }

    /// Whether the travel of at least one axis is declared.
    pub(crate) fn limited(&self) -> bool {
        self.limited
    }

    /// Compares a machine coordinate with the limits.
    pub(crate) fn check_machine(&self, index: usize, coordinate: f64) -> Result<(), Fault> {
        let Some(axis) = self.axes.iter().find(|axis| axis.index == index) else { return Ok(()) };
        match axis.limits {
            Some(limits) if !inside(limits, coordinate) => Err(plan::LIMITS.fault(format_args!(
                "{} would have to move to machine coordinate {}, its limits are {} to {}",
                axis.letter,
                axis.units.coordinate(coordinate),
                axis.units.coordinate(limits.lower).number(),
                axis.units.coordinate(limits.upper)
            ))
            .help("correct `[limits]`, or the position: `retract.position`, for the other axes of `home_on_indexing` `retract.xy`")),
            _ => Ok(()),
        }
    }

    /// Axis value at a machine coordinate, mm; `None` if the machine zero or the gauge length is unknown.
    pub(crate) fn value_at(&self, index: usize, coordinate: f64) -> Option<f64> {
        let axis = self.axes.iter().find(|axis| axis.index == index)?;
        Some(coordinate - axis.machine_zero_mm? - axis.gauge(self.gauge_length_mm)? - self.moved_mm[index])
    }
}

impl LinearTravel {
    /// Reason why the limits could not be compared; `None` if they were.
    pub(crate) fn unchecked_reason(&self) -> Option<&'static str> {
        if !self.limited() {
            Some("no travel declared")
        } else if !self.has_machine_zero() {
            Some("no machine_zero")
        } else if self.unknown_length {
            Some("gauge length unknown")
        } else {
            None
        }
    }

    /// Whether the travel is declared.
    pub(crate) fn limited(&self) -> bool {
        self.limits.is_some()
    }

    /// Whether machine coordinates are known, from `machine_zero`.
    pub(crate) fn has_machine_zero(&self) -> bool {
        self.machine_zero_mm.is_some()
    }

    pub(crate) fn letter(&self) -> char {
        self.letter
    }

    fn gauge(&self, length: Option<f64>) -> Option<f64> {
        if self.share.abs() < NO_GAUGE_SHARE && !self.has_rotary_head {
            Some(0.0)
        } else {
            length.map(|length| length * self.share)
        }
    }

    fn check(&mut self, value: f64, length: Option<f64>) -> Result<(), Fault> {
        let Some(limits) = self.limits else { return Ok(()) };
        let Some(gauge) = self.gauge(length) else {
            self.unknown_length = true;
            return Ok(());
        };
        let letter = self.letter;
        if let Some(zero) = self.machine_zero_mm {
            let coordinate = zero + value + gauge;
            if inside(limits, coordinate) {
                return Ok(());
            }
            return Err(plan::LIMITS
                .fault(format_args!(
                    "{letter} would have to move to {} (machine coordinate), its limits are {} to {}",
                    self.units.coordinate(coordinate),
                    self.units.coordinate(limits.lower).number(),
                    self.units.coordinate(limits.upper)
                ))
                .help("set the part up elsewhere (`part_origin`, `machine_zero`), or use another tool length"));
        }
        let here = value + gauge;
        let (lowest, highest) = self.span.map_or((here, here), |(low, high)| (smaller(here, low), larger(here, high)));
        self.span = Some((lowest, highest));
        let travel = limits.upper - limits.lower;
        if highest - lowest <= travel + AXIS_VALUE_NOISE {
            return Ok(());
        }
        Err(plan::LIMITS
            .fault(format_args!(
                "up to this point the program needs {} of {letter} travel, the machine has {}",
                self.units.coordinate(highest - lowest),
                self.units.coordinate(travel)
            ))
            .help("split the program, or set the part up nearer to the rotary centre lines"))
    }
}

fn inside(limits: Limits, coordinate: f64) -> bool {
    (limits.lower - AXIS_VALUE_NOISE..=limits.upper + AXIS_VALUE_NOISE).contains(&coordinate)
}
