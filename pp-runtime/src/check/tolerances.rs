//! The tolerances of the check. What a row is: [`crate::tolerance`]. Allowances for the words of a program are computed
//! from their units, by `Rounding` in [`rules`](super::rules).

use std::f64::consts::{PI, SQRT_2};

crate::tolerance::tolerances! {
    // Tool axes and directions.

    /// Largest angle between tool axes that are the same.
    SAME_AXIS: f64 = 1e-6, "rad", "CL data has seven digits", equals SAME_AXIS;

    /// Largest distance of equal points, and of equal tool axes.
    SAME_POSE: f64 = 1e-9, "mm, 1", "the same record, rotated and moved: rounding of arithmetic", equals SAME_POSE;

    /// Largest angle between a motion along the tool axis and that axis, and between the tool axes of its ends.
    ALONG_TOOL_AXIS: f64 = 1e-3, "rad", "three decimals of CL data in a motion of a millimetre",
        equals ALONG_TOOL_AXIS;

    /// Smallest cosine between the tool axis and the normal of a clearance plane to which that axis leads.
    LEADS_TO_PLANE: f64 = 1e-3, "1", "a retract that is a thousand times as long as the height would leave any machine",
        equals LEADS_TO_PLANE;

    /// Smallest cosine between tool axis and retract axis that are parallel.
    RETRACT_ALONG_TOOL: f64 = 1.0 - 1e-12, "1", "directions of a declaration: rounding of arithmetic",
        equals RETRACT_ALONG_TOOL;

    /// Largest cosine between linear axes that are perpendicular.
    PERPENDICULAR_AXES: f64 = 1e-12, "1", "directions of a declaration: rounding of arithmetic",
        equals PERPENDICULAR_AXES;

    /// Largest cosine between directions of linear axes, rotary ones where they are, that are perpendicular.
    PERPENDICULAR_THERE: f64 = 1e-9, "1", "rounding of the arithmetic of angles", equals ORTHOGONAL_MAP;

    /// Largest difference between the shares of two linear axes in the tool axis that are equal.
    EQUAL_TOOL_SHARE: f64 = 1e-9, "1", "directions of a declaration: rounding of arithmetic", equals EQUAL_TOOL_SHARE;

    /// Length below which a step has no direction.
    NO_DIRECTION: f64 = 1e-9, "mm", "a millionth of the last digit of CL data", equals NO_DIRECTION;

    /// Error of a tool axis of the CL data; near the pole axes are put there.
    AXIS_NOISE: f64 = 2e-6, "rad", "seven digits, of two axes",
        alone "the planner has the axis of the CL data, not one of words";

    /// Largest angle between the tool axis of the CL data and one that is held.
    HELD_AXIS: f64 = 1e-5, "rad", "digits of CL data, of which some systems write five", equals HELD_AXIS;

    /// Largest angle between the tool axis and the normal of its plane where words have many decimals.
    ALONG_PLANE_NORMAL: f64 = 5e-4, "rad", "0.03°: another plane is farther off",
        alone "the planner computes the plane from the tool axis";

    /// Largest error of the length of a tool axis with rounded components.
    UNIT_VECTOR: f64 = 5e-3, "1", "components with two decimals", alone "the planner writes seven decimals";

    /// Largest difference of two directions in the plane, off the wall of a bore.
    SAME_BORE_DIRECTION: f64 = 1e-6, "1", "both are along an axis: 0 or 1", alone "the planner writes 0 or 1";

    // The poles.

    /// Angle to a pole below which the rotary axes rotate far for a small rotation of the tool.
    UNEVEN_NEAR_POLE: f64 = 0.035, "rad", "there the first axis rotates more than 28 times as far as the tool",
        equals UNEVEN_NEAR_POLE;

    /// Distance from a pole below which the control may leave the first rotary axis where it is and take the other
    /// branch.
    CONTROL_CHOOSES_NEAR_POLE: f64 = 3e-4, "rad",
        "there that axis rotates the tool by less than a three-thousandth of its own angle",
        equals CONTROL_CHOOSES_NEAR_POLE;

    /// Angle to a pole below which the angle of the first rotary axis is noise.
    POLE_ANGLE_NOISE: f64 = 1e-8, "rad",
        "it is known to 1e-14 rad over this; tool vectors of a program are at the pole, or ten times as far from it",
        alone "the planner has the rotation at the pole from its course";

    // Rotary positions.

    /// Largest difference of two positions of the rotary axes that the control may have found, and are one.
    SAME_POSITION: f64 = 1e-3, "rad", "they are followed in steps from rounded words; others are far from them",
        covers SAME_PLANE_POSE;

    /// Largest difference of rotary words that move no axis out of a tilted plane.
    SAME_ROTARY_WORD: f64 = 1e-9, "rad", "the same word, converted to rad", alone "the planner has whole units";

    /// Largest difference from half a revolution, or from none, of a rotation whose sense the control chooses.
    ROLLOVER_NOISE: f64 = 1e-9, "rad", "words converted to rad, whole revolutions apart",
        alone "the planner has whole units";

    /// Half the largest difference between a rotary position and that with which a guard compares it.
    ROUNDED_GUARD_POSITION: f64 = 1e-6, "rad", "rounding of the numbers of a guard",
        alone "the planner writes the words of the axes";

    /// Rotation of the tool axis with a rotary axis from which on the tool axis fixes its position, for a guard.
    LEAST_GUARDED_RATE: f64 = 0.03, "rad per rad",
        "above that of the planner, which has the angles before they are rounded", covers LEAST_GUARDED_RATE;

    /// Largest sum of |sin(d/2)| over the differences d of all axes that a guard of rotary positions allows.
    GUARDED_SINES: f64 = 0.0009, "1", "0.1 degrees for one axis alone; another solution is farther away",
        equals GUARDED_SINES;

    // Axis values.

    /// Noise of an axis value, also of a rotary one in rad, that must not put a value on a limit outside it.
    AXIS_VALUE_NOISE: f64 = 1e-6, "mm",
        "a thousand times what it is a kilometre from the zero; a value on a limit is inside", equals AXIS_VALUE_NOISE;

    /// Largest difference of axis values that are the same.
    SAME_AXIS_VALUE: f64 = 1e-9, "mm, rad", "rounding of arithmetic", equals SAME_AXIS_VALUE;

    /// Largest difference of words of a linear axis that are the same.
    SAME_LINEAR_WORD: f64 = 1e-9, "mm", "the same number, converted to mm", alone "the planner has whole units";

    /// Largest difference of words of a linear axis in two blocks that program the same coordinate of the tip again.
    SAME_COORDINATE: f64 = 1e-12, "mm", "the same number, converted to mm", alone "the planner has whole units";

    /// Largest error of a tip by the arithmetic.
    TIP_NOISE: f64 = 1e-6, "mm", "a thousand times what it is a kilometre from the zero",
        alone "the planner allows for it in AXIS_VALUE_NOISE";

    // Points and levels.

    /// Largest distance of two points of CL data that are one.
    SAME_POINT: f64 = 0.005, "mm", "points are rounded to three decimals of a millimetre or four of an inch",
        equals SAME_POINT;

    /// Largest distance of a point that lies on a line.
    ON_LINE: f64 = 1e-3, "mm", "the last digit of CL data", equals ON_LINE;

    /// Largest height of a motion that lies in the plane of cutter compensation; half a unit of coarser words.
    IN_CUTTER_PLANE: f64 = 2e-3, "mm",
        "in a tilted plane both ends of CL data with three decimals are up to 0.87 µm off", equals IN_CUTTER_PLANE;

    /// Length that is none: what is left of a side of a contour, or what an arc or a lead-in has more than the tool
    /// needs.
    SPENT_SIDE: f64 = 1e-9, "mm", "rounding of arithmetic", alone "the planner refuses less than LEAST_OFFSET, which is more";

    /// Excess of a cosine over 1 where two circles touch.
    TOUCHING: f64 = 1e-12, "1", "rounding of arithmetic", alone "the planner refuses what does not meet";

    /// Change of direction that is no corner for an offset.
    STRAIGHT_ON: f64 = 1e-6, "rad", "it trims a radius of a metre by half a micrometre", equals STRAIGHT_ON;

    /// Length above which a retract leads out.
    LEADS_OUT: f64 = 1e-3, "mm", "the last digit of CL data", equals LEADS_OUT;

    /// Largest distance between equal levels of a hole.
    SAME_LEVEL: f64 = 1e-9, "mm", "sums of steps: rounding of arithmetic", equals SAME_LEVEL;

    /// Smallest thickness of a blank that is written.
    THINNEST_BLANK: f64 = 0.1, "mm", "a control draws no flat blank", equals THINNEST_BLANK;

    // Rounding of words.

    /// Largest difference between a number of the program that is a position or a size of the job, and that of the job.
    ROUNDED_WORD: f64 = 0.6, "units", "half a unit, and room for the conversion",
        alone "the planner rounds to the nearest";

    /// Largest rounding of a length in a cycle.
    ROUNDED_CYCLE_LENGTH: f64 = 0.51, "units", "half a unit, and room for the conversion",
        alone "the planner rounds to the nearest";

    /// Largest change of the length of a block by the rounding of its words.
    ROUNDED_BLOCK_LENGTH: f64 = 2.0, "units", "both ends are off by up to √3/2 units", equals ROUNDED_BLOCK_LENGTH;

    /// Largest error of the pitch of a thread over its length, by the rounding of words, as a share of the pitch.
    PITCH_ERROR: f64 = 0.01, "pitches", "10 µm in a thread with a pitch of 1 mm", equals PITCH_ERROR;

    /// Largest rounding of the word that gives a thread its pitch: the pitch itself, or F.
    ROUNDED_PITCH: f64 = 0.51, "units", "half a unit, and room for the conversion",
        alone "the planner rounds to the nearest";

    /// Largest rounding of a dwell.
    ROUNDED_DWELL: f64 = 6e-4, "s", "a dwell has three decimals", alone "the planner rounds to the nearest";

    /// Length that a dwell after the start of the spindle may lack.
    SHORT_SPINDLE_DWELL: f64 = 1e-3, "s", "a dwell has three decimals", alone "the planner rounds to the nearest";

    /// Largest rounding of the angle at which the spindle stops.
    ROUNDED_ORIENT_DEG: f64 = 6e-4, "degrees", "it has three decimals", alone "the planner rounds to the nearest";

    /// Largest rounding of a tolerance of blending or smoothing, in the unit of the program.
    ROUNDED_TOLERANCE: f64 = 6e-7, "mm, in or degrees", "a tolerance has six decimals",
        alone "the planner rounds to the nearest";

    /// Largest rounding of the numbers of a guard of tool data.
    ROUNDED_GUARD: f64 = 1e-3, "mm", "the last decimal of its numbers", alone "the planner rounds to the nearest";

    /// Largest relative rounding of S.
    ROUNDED_SPEED: f64 = 1e-6, "1", "both have the digits of S: rounding of arithmetic",
        alone "the planner rounds to the nearest";

    /// Largest difference of numbers of a program that are the same.
    SAME_NUMBER: f64 = 1e-9, "1", "none is written with so many decimals", alone "the planner has whole units";

    /// Largest difference of a code from tenths.
    CODE_IN_TENTHS: f64 = 1e-6, "tenths", "rounding of arithmetic", alone "the planner has codes as whole tenths";

    /// Allowances within which the tool comes back to the point at which a cut was interrupted.
    COMES_BACK: f64 = 2.0, "allowances",
        "the words with which it left and those with which it comes back are both rounded",
        alone "the planner comes back to the same place";

    /// Factor on the allowances for tip and axis of a share that suits both.
    BOTH: f64 = SQRT_2, "allowances", "it leaves each of them this much farther off than its own best share would",
        alone "the planner has the share";

    /// Shares of a motion that differ by rounding of arithmetic.
    SAME_SHARE: f64 = 1e-9, "1", "rounding of arithmetic", alone "the planner has the share";

    // Arcs.

    /// Largest difference between the angle of an arc and that of its motion: less than a revolution.
    SAME_REVOLUTION: f64 = PI, "rad", "points between the ends show how well it follows the arc", covers SAME_SWEEP;

    /// Growth of the allowance over a half circle by its angle.
    ///
    /// Other angles count with their chords; a full circle ends where it began, wherever its pole is.
    POLE_DRIFT: f64 = 1.64, "allowances",
        "the pole may be half a unit off in both axes, the distances of both ends from it twice that, three words √3/2 units",
        alone "the planner computes the drift of each arc, up to ARC_END_DRIFT";

    /// Largest difference of the radii at both ends of an arc, more than rounding.
    EQUAL_RADII: f64 = 0.002, "mm", "smaller than the limit of the controls as delivered",
        alone "the planner keeps to the tolerance of the control, with the centre nearest to equal radii";

    /// Distance of the ends below which an arc is a full circle, and has no centre by its radius.
    FULL_CIRCLE: f64 = 1e-9, "mm", "the same words: rounding of arithmetic", alone "the planner has whole units";

    /// Twice the distance by which half a chord may exceed its radius.
    RADIUS_BELOW_HALF_CHORD: f64 = 1e-3, "mm", "rounding of a radius word and of both ends",
        alone "the planner writes no radius below half a chord";

    /// Angle below which the chord of an arc of axes is the arc.
    NARROW_ARC: f64 = 1e-7, "rad", "chord and arc differ by less than 1e-22 rad",
        alone "it chooses between two computations";

    /// Difference of angles, rad, and relative difference, that is rounding of arithmetic.
    ANGLE_NOISE: f64 = 1e-9, "rad, 1", "rounding of arithmetic", alone "it chooses between two computations";

    /// Angle whose tangent is the angle, and whose cosine is 1 less half its square, for distances to a nanometre.
    SMALL_ANGLE: f64 = 1e-3, "rad", "its tangent is off by 3e-10, its cosine by 4e-14",
        alone "it chooses between two computations";

    /// Largest distance of the centres of two arcs that are nearly the same, as a share of the radius, and largest
    /// angle between their beginnings or ends, rad.
    NEARLY_SAME_ARC: f64 = 1e-2, "1, rad", "others are compared at points",
        alone "it chooses between two computations";

    /// Distance by which a point of an arc may be before the one before it.
    BEFORE_LAST_POINT: f64 = 1e-3, "mm", "rounding of words", alone "the planner has the angles of an arc";

    // Feed and time.

    /// Largest speed of the tip in units of its feed.
    FASTER: f64 = 1.01, "1", "no cut notices a hundredth", equals FASTER;

    /// Largest ratio of the time of a block, where the speeds of axes within it are bounded, to the time that its
    /// slowest axis needs.
    TIME_BOUND: f64 = 1.015, "1", "the bound of the planner, and the speeds of the check at points", covers TIME_BOUND;

    /// Time of a block in which neither tip nor tool axis moves by a unit.
    RESTING_BLOCK: f64 = 1e-3, "min", "any time will do: a thousandth of a minute is short", equals RESTING_BLOCK;

    /// Relative difference of sums of floating-point numbers.
    F_NOISE: f64 = 1e-9, "1", "a million times the rounding", alone "the planner has one of the sums";

    /// Share of the slowest axis that a tool axis rotated by rounding may cost.
    SLOWED_BY_ROUNDING: f64 = 0.99, "1", "a hundredth is more than the rounding of a tool axis costs",
        alone "the planner has the words of all axes";

    /// Factor by which an axis may move farther within a block than its ends are apart, where the control finds the
    /// angles.
    EXCURSION: f64 = 2.0, "1", "it may go out and come back", alone "the planner has the words of all axes";

    /// Ratio of the motion of the linear axes to that of the tip above which the tool axis decides the ends of a block.
    LEVER: f64 = 10.0, "1", "the rounding of the tool axis then moves the ends by more than that of the tip",
        alone "the planner has the ends";

    // Plausible sizes.

    /// Most steps of a hole.
    MOST_HOLE_STEPS: usize = 10_000, "1", "the planner refuses more", covers MOST_HOLE_STEPS;
}
