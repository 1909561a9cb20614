//! The tolerances of motion, and numbers of later stages that the check has to know. What a row is:
//! [`crate::tolerance`].

use std::f64::consts::{FRAC_PI_4, PI};

crate::tolerance::tolerances! {
    // Tool axes and directions.

    /// Largest angle between tool axes that are the same.
    SAME_AXIS: f64 = 1e-6, "rad", "CL data has seven digits", equals SAME_AXIS;

    /// Largest angle by which a tool axis that is held differs from that at the begin of its stretch.
    HELD_AXIS: f64 = 1e-5, "rad", "digits of CL data, of which some systems write five", equals HELD_AXIS;

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

    /// Largest difference between the direction of an axis in the declaration and the coordinate axis with its letter.
    COORDINATE_AXIS: f64 = 1e-12, "1", "directions of a declaration: rounding of arithmetic",
        alone "it refuses a mode before anything is written";

    /// Largest difference between the shares of two linear axes in the tool axis that are equal.
    EQUAL_TOOL_SHARE: f64 = 1e-9, "1", "directions of a declaration: rounding of arithmetic", equals EQUAL_TOOL_SHARE;

    /// Smallest share of the gauge length along an axis that counts.
    NO_GAUGE_SHARE: f64 = 1e-12, "1", "directions of a declaration: rounding of arithmetic",
        alone "the check multiplies by the share, however small";

    /// Largest difference between two directions at rotary angles that are parallel.
    PARALLEL: f64 = 1e-9, "1", "rounding of the arithmetic of angles",
        alone "it chooses the form of an approach, which the check reads from the blocks";

    /// Largest deviation of a map from an orthogonal one.
    ORTHOGONAL_MAP: f64 = 1e-9, "1", "rounding of the arithmetic of angles", equals PERPENDICULAR_THERE;

    /// Sine of the angle between two tool axes below which they have no great circle.
    NO_GREAT_CIRCLE: f64 = 1e-12, "1", "its direction would be rounding of arithmetic",
        alone "such a motion passes no pole, and the check measures it at points";

    /// Length below which a step, or a distance from an axis, has no direction.
    NO_DIRECTION: f64 = 1e-9, "mm", "a millionth of the last digit of CL data", equals NO_DIRECTION;

    /// Component of a direction below which a line is parallel to a face of the clearance geometry.
    PARALLEL_TO_FACE: f64 = 1e-12, "1", "the line would reach the face beyond any machine",
        alone "the check searches along the line without a division";

    /// Largest noise of the square of the distance of two unit vectors.
    UNIT_VECTOR_NOISE: f64 = 1e-12, "1", "a thousand times the rounding of arithmetic",
        alone "it only asks the poles one by one";

    /// Largest deviation from the tool axis of the CL data that is not counted.
    NO_DEVIATION: f64 = 1e-12, "rad", "rounding of arithmetic", alone "it is for the summary";

    // The poles.

    /// Sine of the angle to a pole below which the rotary axes do not go evenly.
    UNEVEN_NEAR_POLE: f64 = 0.035, "rad", "there the first axis rotates more than 28 times as far as the tool",
        equals UNEVEN_NEAR_POLE;

    /// Distance from a pole below which the control may leave the first rotary axis where it is and take the other
    /// branch.
    CONTROL_CHOOSES_NEAR_POLE: f64 = 3e-4, "rad",
        "there that axis rotates the tool by less than a three-thousandth of its own angle",
        equals CONTROL_CHOOSES_NEAR_POLE;

    /// Share of the tolerance of the tool axis by which a motion may be bent to lead it through a pole.
    BENT_THROUGH_POLE: f64 = 0.75, "1", "rounding of the words takes the rest",
        alone "the check allows the whole tolerance";

    /// Largest cosine between the directions from a pole to the ends of a path that passes it.
    PASSES_POLE: f64 = -0.5, "1", "120°: the first rotary axis rotates by more than this",
        alone "the check measures the path of the blocks, however they pass";

    /// Distance from the pole at which the direction of a path to the pole is evaluated.
    DIRECTION_AT_POLE: f64 = 1e-8, "rad",
        "the angle of the first rotary axis is known to 1e-14 rad over this, below a word",
        alone "the check has the rotation at the pole from the words";

    /// Largest difference of words that are the same after a path through the pole.
    SAME_WORD_AFTER_POLE: i64 = 2, "units", "both are rounded", alone "the check has the words";

    /// Sine or cosine of the middle of three angles of a plane below which only the sum or the difference of the others
    /// is known.
    ONE_SUM_OF_ANGLES: f64 = 1e-12, "1", "the others would be rounding of arithmetic",
        alone "the check computes the plane from the written angles";

    /// Largest difference of a rotary angle at which two poses of a plane are one.
    SAME_PLANE_POSE: f64 = 1e-9, "rad", "rounding of arithmetic", within SAME_POSITION;

    /// Angle to the normal within which X does not give the direction of a plane.
    ALONG_PLANE_NORMAL: f64 = PI / 180.0, "rad",
        "nearer to the normal its direction in the plane is that of rounded angles",
        alone "the check computes the plane from the written angles";

    // Rotation.

    /// Largest rotation of an axis in a motion that is even.
    LARGEST_EVEN_ROTATION: f64 = FRAC_PI_4, "rad", "a wider one, near a pole, goes by the great circle",
        alone "the check measures the path of the blocks";

    /// Share of the tolerance of the tool axis up to which the course counts on an even motion.
    EVEN_SHARE: f64 = 0.9, "1", "rounding of the words takes the rest", alone "the check allows the whole tolerance";

    /// Smallest cosine between the tool axes of one block.
    WIDEST_BLOCK: f64 = -0.5, "1", "the great circle of a larger angle is ill conditioned",
        alone "the check measures blocks of any angle";

    /// Largest travel of a rotary axis in a feed motion whose revolution is forced by limits.
    LIMIT_SWING: f64 = 1_f64.to_radians(), "rad", "more would swing the tool in the cut",
        alone "the check measures the path of the blocks";

    /// Largest change of the second rotary axis in units of that of the tool axis, where limits are looked at.
    SLOPE_NEAR_LIMIT: f64 = 4.0, "1", "1 for a rectangular axis, more for a nutating one",
        alone "the check has the axis values within each block";

    /// Rotation of the tool axis with a rotary axis below which the tool axis does not fix its position, for a guard.
    LEAST_GUARDED_RATE: f64 = 0.02, "rad per rad",
        "above it, the rounding of three decimals of the angles of a plane is at most half of what the guard allows",
        within LEAST_GUARDED_RATE;

    /// Difference of one rotary position that a guard allows.
    GUARDED_ANGLE_DEG: f64 = 0.1, "degrees", "wider than rounded angles, narrower than another solution",
        alone "the program has GUARDED_SINES, which are this angle";

    /// Largest sum of |sin(d/2)| over the differences d of all axes that a guard of rotary positions allows.
    GUARDED_SINES: f64 = 0.0009, "1", "0.1 degrees for one axis alone; another solution is farther away",
        equals GUARDED_SINES;

    // Converted numbers, and axis values.

    /// Largest error of an angle or a length that is converted from the unit of its text.
    CONVERTED_NOISE: f64 = 1e-9, "rad, mm", "a thousand times the rounding, and far below a word",
        alone "the check allows for the rounding of words, which is wider";

    /// Largest relative error of an indexing step that is converted from degrees.
    INDEX_STEP_NOISE: f64 = 1e-9, "1", "a million times the rounding", alone "it is about the configuration only";

    /// Largest noise of a limit or an offset that is converted from degrees, as a word.
    WORD_NOISE: f64 = 1e-6, "units", "a limit of whole units is one after its conversion, too",
        alone "AXIS_VALUE_NOISE of the check is wider";

    /// Largest error of the value of a linear axis by the arithmetic.
    AXIS_VALUE_NOISE: f64 = 1e-6, "mm",
        "a thousand times what it is a kilometre from the zero; a value on a limit is inside", equals AXIS_VALUE_NOISE;

    /// Largest difference of axis values that are the same.
    SAME_AXIS_VALUE: f64 = 1e-9, "mm, rad", "rounding of arithmetic", equals SAME_AXIS_VALUE;

    // Points and levels.

    /// Largest distance of two points of CL data that are one.
    SAME_POINT: f64 = 0.005, "mm", "points are rounded to three decimals of a millimetre or four of an inch",
        equals SAME_POINT;

    /// Largest distance of a point that lies on a line.
    ON_LINE: f64 = 1e-3, "mm", "the last digit of CL data", equals ON_LINE;

    /// Largest height of a motion that lies in the plane of cutter compensation; half a unit of coarser words.
    IN_CUTTER_PLANE: f64 = 2e-3, "mm",
        "in a tilted plane both ends of CL data with three decimals are up to 0.87 µm off", equals IN_CUTTER_PLANE;

    /// Length of an offset element that is none, and largest excess of an arc or a lead-in over the offset that is
    /// none.
    LEAST_OFFSET: f64 = 1e-6, "mm", "a thousandth of the last digit of a word",
        alone "the check finds what is left without this margin: SPENT_SIDE";

    /// Change of direction that is no corner for an offset.
    STRAIGHT_ON: f64 = 1e-6, "rad", "it trims a radius of a metre by half a micrometre", equals STRAIGHT_ON;

    /// Length that a retract may lack.
    LED_OUT: f64 = 1e-6, "mm", "rounding of sums", alone "the check allows the rounding of the words";

    /// Length above which a motion of the CL data along the tool axis leads the tool out.
    LEADS_OUT: f64 = 1e-3, "mm", "the last digit of CL data", equals LEADS_OUT;

    /// Smallest depth of a rapid below the lowest cut that gets a remark.
    DEEP_PLUNGE: f64 = 1e-3, "mm", "the last digit of CL data", alone "it is a remark of the planner";

    /// Largest distance between equal levels of a hole.
    SAME_LEVEL: f64 = 1e-9, "mm", "sums of steps: rounding of arithmetic", equals SAME_LEVEL;

    /// Largest angle of an oriented spindle that is 0.
    NO_ORIENT_ANGLE_DEG: f64 = 1e-9, "degrees", "rounding of the conversion",
        alone "it refuses a bore before it is written";

    /// Largest difference of two distances off the wall of a bore that are equal.
    SAME_BORE_SHIFT: f64 = 1e-9, "mm", "rounding of the conversion", alone "it refuses a bore before it is written";

    /// Largest radius of an arc of more than half a circle, where the travel of the machine is not known.
    LARGEST_LONG_WAY: f64 = 2000.0, "mm", "no usual machine holds a circle of four metres",
        alone "it refuses an arc before it is written";

    /// Smallest thickness of a blank that is written.
    THINNEST_BLANK: f64 = 0.1, "mm", "a control draws no flat blank", equals THINNEST_BLANK;

    // Rounding of words.

    /// Largest displacement of an end in its plane by rounding.
    ROUNDED_END: f64 = 0.7072, "units", "half the diagonal of a square",
        alone "the check rounds words for all three axes";

    /// Largest distance between the end of an arc by its angles and the end of its words.
    ARC_END_DRIFT: f64 = 2.0, "units",
        "more than rounding of one centre explains is an accumulation over pieces, which the next motion would begin with",
        alone "the allowance of the check grows with the angle: POLE_DRIFT";

    /// Units of a rotary word by which the rounding of all angles may rotate Z of the program at a hole.
    LEAN_BY_ROUNDING: f64 = 2.0, "units", "two rotary axes, each up to half a unit off, and as much again",
        alone "it only chooses the text of a refusal";

    /// Largest change of the length of a block by the rounding of its words.
    ROUNDED_BLOCK_LENGTH: f64 = 2.0, "units", "both ends are off by up to √3/2 units", equals ROUNDED_BLOCK_LENGTH;

    /// Depth in the clearance geometry that is the rounding of words.
    GRAZES_CLEARANCE: f64 = 2.0, "units", "both ends are off by up to √3/2 units",
        alone "the check allows four roundings of a tip, at least as much";

    /// Largest distance from its axis of a rapid along the tool axis.
    RAPID_ALONG_TOOL: f64 = 2.0, "units", "both ends are off by up to √3/2 units",
        alone "the check allows four roundings of a tip, at least as much";

    /// Largest error of the pitch of a thread over its length, by the rounding of words, as a share of the pitch.
    PITCH_ERROR: f64 = 0.01, "pitches", "10 µm in a thread with a pitch of 1 mm", equals PITCH_ERROR;

    /// Largest error of a pitch over the length of the thread that is none.
    NO_PITCH_ERROR: f64 = 1e-9, "mm", "rounding of arithmetic", alone "it only chooses what the summary prints";

    // Arcs.

    /// Largest difference between the sweep of the words and the nominal one.
    SAME_SWEEP: f64 = 0.5, "rad", "beyond it the words describe another arc", within SAME_REVOLUTION;

    /// Smallest sweep for which an `R` word determines the centre reliably.
    LEAST_RADIUS_SWEEP: f64 = 0.05, "rad", "of a smaller one the chord is near zero",
        alone "the check computes the centre as a control";

    /// Largest sweep up to half a revolution for which an `R` word determines the centre reliably.
    MOST_RADIUS_SWEEP: f64 = 0.95 * PI, "rad", "of a larger one the chord is near the diameter",
        alone "the check computes the centre as a control";

    /// Excess over whole revolutions that is none.
    WHOLE_REVOLUTIONS: f64 = 1e-9, "revolutions", "rounding of arithmetic", alone "it only divides an arc into blocks";

    /// Largest error of a point of an arc by the arithmetic, per mm of its distances.
    ARC_POINT_NOISE: f64 = 1e-12, "mm per mm", "thousands of times what it is",
        alone "it widens a box that is compared with limits";

    /// Largest rise along an axis, per motion on the circle, that moves no extreme along it.
    LEVEL_ARC: f64 = 1e-9, "mm per mm", "by its square, less than rounding",
        alone "it chooses between two computations of an extreme";

    // Feed and time.

    /// Largest speed of the tip in units of its feed.
    FASTER: f64 = 1.01, "1", "no cut notices a hundredth", equals FASTER;

    /// Largest ratio of the bound of the time of a block to the time that is known to be needed.
    TIME_BOUND: f64 = 1.01, "1", "a hundredth is lost at most", within TIME_BOUND;

    /// Time of a block in which neither tip nor tool axis moves by a unit.
    RESTING_BLOCK: f64 = 1e-3, "min", "any time will do: a thousandth of a minute is short", equals RESTING_BLOCK;

    // Plausible sizes.

    /// Most chords of an arc, and of a span of a curve.
    MOST_CHORDS: f64 = 1e6, "1", "more indicate a fault in the file", alone "such a file is refused";

    /// Most revolutions of one record.
    MOST_REVOLUTIONS: f64 = 1e6, "revolutions", "more are a fault of the file",
        alone "such an arc is written as chords, or refused";

    /// Most steps of a hole.
    MOST_HOLE_STEPS: u32 = 10_000, "1", "a step in another unit than the depth", within MOST_HOLE_STEPS;
}
