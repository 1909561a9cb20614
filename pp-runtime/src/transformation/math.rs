//! Sine, cosine and arc tangent in C: those of [`math`](crate::kinematics::math), operation by operation.
//!
//! With the library of its system a header would give other last bits than the post, and where a decision hangs on them, at a
//! pole or at the edge of the reach, another branch.

use crate::kinematics::math::{arc_tangent, sin_cos};

use super::c::PREFIX;

/// Definitions of `sin`, `cos` and `atan2` with the prefix.
pub(super) fn own() -> String {
    TEXT.replace("WHOLE", &c_number(sin_cos::WHOLE))
        .replace("TWO_BY_PI", &c_number(core::f64::consts::FRAC_2_PI))
        .replace("MOST_QUARTERS", &c_number(sin_cos::MOST_QUARTERS))
        .replace("FAR_ENOUGH", &c_number(sin_cos::FAR_ENOUGH))
        .replace("QUARTER_TURN_REST", &c_number(sin_cos::QUARTER_TURN_REST))
        .replace("QUARTER_TURN", &c_number(sin_cos::QUARTER_TURN))
        .replace("POLYNOMIAL_OF_SINE", &polynomial(&sin_cos::SINE))
        .replace("POLYNOMIAL_OF_COSINE", &polynomial(&sin_cos::COSINE))
        .replace("POLYNOMIAL_OF_ARC_TANGENT", &polynomial(&arc_tangent::ARC_TANGENT))
        .replace("TAN_PI_8", &c_number(arc_tangent::TAN_PI_8))
        .replace("PI_REST_2", &c_number(0.5 * arc_tangent::PI_REST))
        .replace("PI_REST_4", &c_number(0.25 * arc_tangent::PI_REST))
        .replace("PI_REST", &c_number(arc_tangent::PI_REST))
        .replace("PI_2", &c_number(core::f64::consts::FRAC_PI_2))
        .replace("PI_4", &c_number(core::f64::consts::FRAC_PI_4))
        .replace("PI_1", &c_number(core::f64::consts::PI))
        .replace("LARGEST", &c_number(arc_tangent::LARGEST))
        .replace("UPPER_BITS", &format!("0x{:X}u", arc_tangent::UPPER_BITS.to_bits()))
}

/// `sin`, `cos` and `atan2` with the prefix, as those of the library.
pub(super) fn of_library() -> String {
    ["sin", "cos", "atan2"].map(|name| format!("#define {PREFIX}_{name} {name}\n")).concat()
}

/// Digits from which C reads the same number.
fn c_number(value: f64) -> String {
    format!("{value:e}")
}

/// Horner's scheme in `square`, lowest power first.
fn polynomial(factors: &[f64]) -> String {
    let mut factors = factors.iter().rev().map(|factor| c_number(*factor));
    let highest = factors.next().unwrap_or_default();
    factors.fold(highest, |sum, factor| format!("({sum} * square + {factor})"))
}

const TEXT: &str = "/* Sine, cosine and arc tangent with the bits of the postprocessor: compile without contraction of products and \
sums\n \
* (-std=c99 or -ffp-contract=off). */
static inline double @_sine_or_cosine(double x, int quarters)
{
    const double shifted = x * TWO_BY_PI + WHOLE;
    const double k = shifted - WHOLE;
    const double coarse = x - k * QUARTER_TURN;
    const double rest = k * QUARTER_TURN_REST;
    const double y = coarse - rest;
    const double excess = rest - (coarse - y);
    const double square = y * y;
    const double half = 0.5 * square;
    const double near_one = 1.0 - half;
    if (!(fabs(y) >= fabs(k) * FAR_ENOUGH && fabs(k) <= MOST_QUARTERS)) return quarters ? cos(x) : sin(x);
    const int quarter = ((int)k + quarters) & 3;
    const double value = quarter & 1
        ? near_one + (((1.0 - near_one) - half) + ((square * square) * POLYNOMIAL_OF_COSINE + y * excess))
        : y - (excess * near_one + (y * square) * POLYNOMIAL_OF_SINE);
    return quarter & 2 ? -value : value;
}

static inline double @_sin(double x)
{
    return @_sine_or_cosine(x, 0);
}

static inline double @_cos(double x)
{
    return @_sine_or_cosine(x, 1);
}

static inline double @_upper(double x)
{
    union { double number; uint64_t bits; } of;
    of.number = x;
    of.bits &= UPPER_BITS;
    return of.number;
}

static inline double @_atan2(double y, double x)
{
    const double across = fabs(x), up = fabs(y);
    const double small = across < up ? across : up, large = across < up ? up : across;
    if (!(across + up <= LARGEST && across + up > 0.0)) return atan2(y, x);
    const int steep = up > across, behind = x < 0.0, wide = small > TAN_PI_8 * large;
    const double minus = wide ? large : 0.0, plus = wide ? small : 0.0;
    const double above = small - minus, below = large + plus;
    const double t = above / below;
    const double upper_t = @_upper(t), upper_below = @_upper(below);
    const double remainder = (above - upper_t * upper_below) - (upper_t * (below - upper_below) + (t - upper_t) * below);
    const double lost = (small - (above + minus)) - t * (plus - (below - large));
    const double square = t * t;
    const double curved = t * (square * POLYNOMIAL_OF_ARC_TANGENT) + (remainder + lost) / below;
    const double eighth = wide ? PI_4 : 0.0, eighth_rest = wide ? PI_REST_4 : 0.0;
    const double in_front = (steep ? PI_2 : 0.0) + (steep ? -eighth : eighth);
    const double in_front_rest = (steep ? PI_REST_2 : 0.0) + (steep ? -eighth_rest : eighth_rest);
    const double octant = behind ? -in_front : in_front;
    const double half_turn = behind ? PI_1 : 0.0;
    const double base = half_turn + octant;
    const double base_rest =
        ((behind ? -in_front_rest : in_front_rest) + (behind ? PI_REST : 0.0)) + (octant - (base - half_turn));
    const int turned = steep != behind;
    const double angle = base + ((turned ? -t : t) + (base_rest + (turned ? -curved : curved)));
    return signbit(y) ? -angle : angle;
}

";
