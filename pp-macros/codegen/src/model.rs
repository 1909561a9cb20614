//! A checked machine: exact, without syntax and without spans.
//!
//! An axis is identified by its index in the chain; `check` has the spans and maps an index back to the declaration.

use std::collections::BTreeMap;

use num_rational::BigRational;

use crate::symbolic::{Matrix, Poly, PolyVector, Ring, Surd, Symbol, rotation, translation};

/// Index of an axis in the chain, counted from the workpiece.
pub type AxisId = usize;

/// Local variables of generated functions, of Rust and of C; a dimension with one of these names gets another name
/// there.
pub(crate) const LOCALS: &[&str] = &[
    "axes",
    "axis",
    "change",
    "count",
    "deviation",
    "edge_across",
    "edge_along",
    "edge_height",
    "edge_norm",
    "edge_root",
    "from",
    "held",
    "index",
    "inside",
    "m",
    "math",
    "middle",
    "point",
    "pose",
    "reach",
    "singular",
    "solved",
    "tip",
    "to",
    "turns",
    "value",
    "first",
    "second",
];

/// Keywords of C99 that are none of Rust, functions and macros that generated C calls or that compilers define.
const WORDS_OF_C: &[&str] = &[
    "asm", "auto", "atan2", "case", "char", "cos", "default", "double", "errno", "fabs", "float", "goto", "i386",
    "inline", "int", "isfinite", "linux", "long", "register", "restrict", "short", "signed", "sin", "sizeof", "sqrt",
    "switch", "typedef", "union", "unix", "unsigned", "void", "volatile",
];

/// Whether a name means something else in C: a keyword, a function, or a name that macros have, such as `NAN`.
pub(crate) fn is_word_of_c(name: &str) -> bool {
    let like_a_macro = !name.contains(|letter: char| letter.is_lowercase());
    WORDS_OF_C.contains(&name) || like_a_macro || name.starts_with('_')
}

/// Axis letters: linear ones, then rotary ones; each third of them has the direction X, Y or Z.
pub(crate) const LETTERS: [&str; 9] = ["X", "Y", "Z", "U", "V", "W", "A", "B", "C"];

/// Linear or rotary; `None` if it is no axis letter.
pub(crate) fn kind_of(letter: &str) -> Option<AxisKind> {
    let place = LETTERS.iter().position(|known| *known == letter)?;
    Some(if place < 6 { AxisKind::Linear } else { AxisKind::Rotary })
}

/// Linear or rotary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisKind {
    /// X Y Z U V W.
    Linear,
    /// A B C.
    Rotary,
}

/// Side of the machine frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Left of `|`.
    Workpiece,
    /// Right of `|`.
    Tool,
}

impl Side {
    /// The other side of the frame.
    #[must_use]
    pub fn across(self) -> Self {
        match self {
            Self::Workpiece => Self::Tool,
            Self::Tool => Self::Workpiece,
        }
    }
}

/// One axis of the chain.
#[derive(Debug, Clone)]
pub struct Axis {
    /// Address letter.
    pub letter: char,
    /// Linear or rotary.
    pub kind: AxisKind,
    /// Workpiece side or tool side.
    pub side: Side,
    /// True for sign `-`: a positive word moves the axis against ISO 841.
    pub reversed: bool,
    /// Unit direction with all axes at zero.
    pub direction: PolyVector,
    /// `d`: a point of the centre line from the side's reference point, mm; zero for linear axes.
    pub point: PolyVector,
    /// Default value of a held axis, mm or degrees.
    pub held: Option<BigRational>,
    /// Travel limits in mm or degrees; `None`: no limits.
    pub limits: Option<(BigRational, BigRational)>,
    /// Largest speed in mm/min or deg/min.
    pub speed: Option<BigRational>,
    /// Symbol of the axis value; formulas have it for linear axes only.
    pub word: Symbol,
    /// Symbols of sine and cosine of the axis value; formulas have them for rotary axes only.
    pub sin_cos: (Symbol, Symbol),
}

/// A named dimension.
#[derive(Debug, Clone)]
pub struct Dimension {
    /// Field name.
    pub name: String,
    /// Default in mm or degrees; `None` if each machine has its own (`required`).
    pub default: Option<BigRational>,
    /// Approximate value of a required angle, degrees: the order of the two solutions is fixed there. An angle without
    /// it and without default is one that only directions of linear axes depend on.
    pub near: Option<BigRational>,
    /// Its symbols in the formulas.
    pub quantity: Quantity,
}

impl Dimension {
    /// Default, or the approximate value of a required angle; mm or degrees.
    #[must_use]
    pub fn known(&self) -> Option<&BigRational> {
        self.default.as_ref().or(self.near.as_ref())
    }
}

/// The symbols by which a dimension enters the formulas.
#[derive(Debug, Clone, Copy)]
pub enum Quantity {
    /// A length, mm: its own symbol.
    Length(Symbol),
    /// An angle: its sine and cosine.
    Angle(Symbol, Symbol),
}

/// Symbols of the pose and of the set-up.
#[derive(Debug, Clone, Copy)]
pub struct ModelSymbols {
    /// Tool tip x y z.
    pub tip: [Symbol; 3],
    /// Tool axis i j k.
    pub axis: [Symbol; 3],
    /// Part origin from the table's reference point.
    pub part: [Symbol; 3],
    /// Gauge length.
    pub gauge: Symbol,
}

/// The coordinate direction that is up at the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Up {
    /// 0, 1, 2 for X, Y, Z.
    pub coordinate: usize,
    /// True for the negative direction.
    pub negated: bool,
}

impl Default for Up {
    fn default() -> Self {
        Self { coordinate: 2, negated: false }
    }
}

/// A machine ready to be solved.
#[derive(Debug, Clone)]
pub struct Model {
    /// Identifier of the struct.
    pub name: String,
    /// Axes from workpiece to tool.
    pub axes: Vec<Axis>,
    /// Named dimensions in the order of the declaration.
    pub dimensions: Vec<Dimension>,
    /// Unit vector from tip to spindle with all axes at zero.
    pub tool_axis: PolyVector,
    /// Direction that is up at the machine; only descriptions for people depend on it.
    pub up: Up,
    /// Symbols of pose and set-up.
    pub symbols: ModelSymbols,
    /// Default values of `hold` and `dims`, for their symbols, and approximate values of required angles; what else is
    /// required keeps its symbols.
    pub defaults: BTreeMap<Symbol, Poly>,
    /// Ring that owns all symbols of the machine and their relations, complete: later stages read it.
    pub ring: Ring,
}

impl Model {
    /// Solved rotary axes, in chain order.
    pub fn solved_rotaries(&self) -> impl Iterator<Item = AxisId> + '_ {
        self.solved(AxisKind::Rotary)
    }

    /// Name of a dimension in the structure of C: its own, unless it means something else in C.
    #[must_use]
    pub fn c_field(&self, name: &str) -> String {
        if !is_word_of_c(name) {
            return name.to_owned();
        }
        let mut field = format!("dim_{name}");
        while self.dimensions.iter().any(|dimension| dimension.name == field) {
            field.push('_');
        }
        field
    }

    /// Solved linear axes, in chain order.
    pub fn solved_linears(&self) -> impl Iterator<Item = AxisId> + '_ {
        self.solved(AxisKind::Linear)
    }

    /// Letters of axes, separated by blanks.
    #[must_use]
    pub fn letters(&self, axes: impl IntoIterator<Item = AxisId>) -> String {
        let letters: Vec<String> = axes.into_iter().map(|axis| self.axes[axis].letter.to_string()).collect();
        letters.join(" ")
    }

    /// Sine of the joint angle: the sine of the word times the sign of the axis.
    #[must_use]
    pub fn joint_sine(&self, axis: AxisId) -> Poly {
        self.signed(axis, self.axes[axis].sin_cos.0)
    }

    /// Centre of a rotary axis in the workpiece frame of the zero position: `d - part_origin` on the workpiece side,
    /// `d + gauge_length · t` on the tool side.
    #[must_use]
    pub fn centre(&self, axis: AxisId) -> PolyVector {
        let Axis { side, point, .. } = &self.axes[axis];
        std::array::from_fn(|index| match side {
            Side::Workpiece => &point[index] - &Poly::from(self.symbols.part[index]),
            Side::Tool => &point[index] + &self.ring.mul(&Poly::from(self.symbols.gauge), &self.tool_axis[index]),
        })
    }

    /// Matrix of one joint: `Trans(q·u)` if linear, `Trans(c)·Rot(n, q)·Trans(-c)` if rotary.
    #[must_use]
    pub fn joint(&self, axis: AxisId) -> Matrix {
        self.joint_or_inverse(axis, false)
    }

    /// Matrix of one joint with `-q` in place of `q`: its inverse.
    #[must_use]
    pub fn joint_inverse(&self, axis: AxisId) -> Matrix {
        self.joint_or_inverse(axis, true)
    }

    /// Product of joint matrices, in the given order.
    #[must_use]
    pub fn product_of(&self, joints: impl IntoIterator<Item = Matrix>) -> Matrix {
        joints.into_iter().fold(Matrix::identity(), |product, joint| product.times(&joint, &self.ring))
    }

    /// `T(q)`: product of all joint matrices from workpiece to tool. It maps the origin to the tip and `t` to the tool
    /// axis.
    #[must_use]
    pub fn product(&self) -> Matrix {
        self.product_of((0..self.axes.len()).map(|axis| self.joint(axis)))
    }

    fn joint_or_inverse(&self, axis: AxisId, inverse: bool) -> Matrix {
        let Axis { kind, direction, word, sin_cos, .. } = &self.axes[axis];
        let signed = |value: Poly| if inverse { -&value } else { value };
        match kind {
            AxisKind::Linear => {
                let value = signed(self.signed(axis, *word));
                translation(&direction.clone().map(|component| self.ring.mul(&component, &value)))
            }
            AxisKind::Rotary => {
                let centre = self.centre(axis);
                let rotation = rotation(direction, &signed(self.joint_sine(axis)), &Poly::from(sin_cos.1), &self.ring);
                let back = translation(&centre.clone().map(|component| -&component));
                self.product_of([translation(&centre), rotation, back])
            }
        }
    }

    /// Symbols of all dimensions.
    #[must_use]
    pub fn dimension_symbols(&self) -> Vec<Symbol> {
        let symbols = |dimension: &Dimension| match dimension.quantity {
            Quantity::Length(symbol) => vec![symbol],
            Quantity::Angle(sine, cosine) => vec![sine, cosine],
        };
        self.dimensions.iter().flat_map(symbols).collect()
    }

    /// Sample values for a numeric comparison of formulas; all relations between symbols hold for them.
    #[must_use]
    pub fn sample(&self) -> BTreeMap<Symbol, f64> {
        let angles = self.axes.iter().map(|axis| axis.sin_cos);
        let dimensions = self.dimensions.iter().filter_map(|dimension| match dimension.quantity {
            Quantity::Angle(sine, cosine) => Some((sine, cosine)),
            Quantity::Length(_) => None,
        });
        // Arbitrary values at which no formula is a special case.
        let mut values: BTreeMap<Symbol, f64> = self.symbols.axis.into_iter().zip([0.36, 0.48, 0.8]).collect();
        for (index, (sine, cosine)) in angles.chain(dimensions).enumerate() {
            let (s, c) = (0.123_4 + 0.271_8 * index as f64).sin_cos();
            values.insert(sine, s);
            values.insert(cosine, c);
        }
        values
    }

    fn signed(&self, axis: AxisId, symbol: Symbol) -> Poly {
        let value = Poly::from(symbol);
        if self.axes[axis].reversed { -&value } else { value }
    }

    fn solved(&self, kind: AxisKind) -> impl Iterator<Item = AxisId> + '_ {
        let wanted = move |axis: &Axis| axis.kind == kind && axis.held.is_none();
        self.axes.iter().enumerate().filter(move |(_, axis)| wanted(axis)).map(|(id, _)| id)
    }
}

/// Nearest float of a rational.
#[must_use]
pub fn to_f64(value: &BigRational) -> f64 {
    Surd::from(value.clone()).to_f64()
}
