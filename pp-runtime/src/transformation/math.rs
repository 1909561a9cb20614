//! Sine, cosine and arc tangent in C: those of [`math`](crate::kinematics::math), operation by operation.
//!
//! With the library of its system a header would give other last bits than the post, and where a decision hangs on
//! them, at a pole or at the edge of the reach, another branch.

use crate::kinematics::math::{arc_tangent, sin_cos};

/// Numbers of the functions, with the prefix as macros.
const NUMBERS: [(&str, f64); 10] = [
    ("WHOLE", sin_cos::WHOLE),
    ("QUARTER_TURN", sin_cos::QUARTER_TURN),
    ("QUARTER_TURN_REST", sin_cos::QUARTER_TURN_REST),
    ("MOST_QUARTERS", sin_cos::MOST_QUARTERS),
    ("FAR_ENOUGH", sin_cos::FAR_ENOUGH),
    ("TWO_BY_PI", core::f64::consts::FRAC_2_PI),
    ("TAN_PI_8", arc_tangent::TAN_PI_8),
    ("HALF_TURN", core::f64::consts::PI),
    ("HALF_TURN_REST", arc_tangent::PI_REST),
    ("LARGEST", arc_tangent::LARGEST),
];

/// Polynomials in `square`, lowest power first, as macros.
const POLYNOMIALS: [(&str, &[f64]); 3] =
    [("SINE", &sin_cos::SINE), ("COSINE", &sin_cos::COSINE), ("ARC_TANGENT", &arc_tangent::ARC_TANGENT)];

/// Definitions of `sin`, `cos` and `atan2` with the prefix.
pub(super) fn own() -> String {
    let numbers = NUMBERS.map(|(name, value)| (name.to_owned(), c_number(value)));
    let polynomials = POLYNOMIALS.map(|(name, factors)| (format!("{name}(square)"), polynomial(factors)));
    let bits = ("UPPER_BITS".to_owned(), format!("0x{:X}u", arc_tangent::UPPER_BITS.to_bits()));
    let macros = numbers.into_iter().chain(polynomials).chain([bits]);
    let macros: String = macros.map(|(name, value)| format!("#define {PREFIX}_{name} {value}\n")).collect();
    format!("{REMARK}{macros}\n{FUNCTIONS}")
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

const REMARK: &str = "/* Sine, cosine and arc tangent with the bits of the postprocessor: compile without contraction of \
                      products\n * and sums (-std=c99 or -ffp-contract=off). */\n";

const FUNCTIONS: &str = "\
static inline double @_sine_or_cosine(double x, int quarters)
{
    const double shifted = x * @_TWO_BY_PI + @_WHOLE;
    const double k = shifted - @_WHOLE;
    const double coarse = x - k * @_QUARTER_TURN;
    const double rest = k * @_QUARTER_TURN_REST;
    const double y = coarse - rest;
    const double excess = rest - (coarse - y);
    const double square = y * y;
    const double half = 0.5 * square;
    const double near_one = 1.0 - half;
    if (!(fabs(y) >= fabs(k) * @_FAR_ENOUGH && fabs(k) <= @_MOST_QUARTERS)) return quarters ? cos(x) : sin(x);
    const int quarter = ((int)k + quarters) & 3;
    const double value = quarter & 1
        ? near_one + (((1.0 - near_one) - half) + ((square * square) * @_COSINE(square) + y * excess))
        : y - (excess * near_one + (y * square) * @_SINE(square));
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
    of.bits &= @_UPPER_BITS;
    return of.number;
}

static inline double @_atan2(double y, double x)
{
    const double across = fabs(x), up = fabs(y);
    const double small = across < up ? across : up, large = across < up ? up : across;
    if (!(across + up <= @_LARGEST && across + up > 0.0)) return atan2(y, x);
    const int steep = up > across, behind = x < 0.0, wide = small > @_TAN_PI_8 * large;
    const double minus = wide ? large : 0.0, plus = wide ? small : 0.0;
    const double above = small - minus, below = large + plus;
    const double t = above / below;
    const double upper_t = @_upper(t), upper_below = @_upper(below);
    const double remainder = (above - upper_t * upper_below) - (upper_t * (below - upper_below) + (t - upper_t) * below);
    const double lost = (small - (above + minus)) - t * (plus - (below - large));
    const double square = t * t;
    const double curved = t * (square * @_ARC_TANGENT(square)) + (remainder + lost) / below;
    const double eighth = wide ? 0.25 * @_HALF_TURN : 0.0, eighth_rest = wide ? 0.25 * @_HALF_TURN_REST : 0.0;
    const double in_front = (steep ? 0.5 * @_HALF_TURN : 0.0) + (steep ? -eighth : eighth);
    const double in_front_rest = (steep ? 0.5 * @_HALF_TURN_REST : 0.0) + (steep ? -eighth_rest : eighth_rest);
    const double octant = behind ? -in_front : in_front;
    const double half_turn = behind ? @_HALF_TURN : 0.0;
    const double base = half_turn + octant;
    const double base_rest =
        ((behind ? -in_front_rest : in_front_rest) + (behind ? @_HALF_TURN_REST : 0.0)) + (octant - (base - half_turn));
    const int turned = steep != behind;
    const double angle = base + ((turned ? -t : t) + (base_rest + (turned ? -curved : curved)));
    return signbit(y) ? -angle : angle;
}

";

/// Character of [`CSource`] whose place the prefix takes.
pub(super) const PREFIX: char = '@';
