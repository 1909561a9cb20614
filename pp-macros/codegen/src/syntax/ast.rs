//! Syntax tree of a declaration.

use std::fmt;

use super::expr::Expr;
use crate::model::Up;
use crate::report::Phrase;

/// Everything between the braces of `machine!`.
pub struct Declaration {
    /// Attributes and doc comments of the struct.
    pub attributes: Vec<syn::Attribute>,
    /// Its visibility.
    pub visibility: syn::Visibility,
    /// Its name.
    pub name: syn::Ident,
    /// `chain: C B | X Y Z;`
    pub chain: Option<Chain>,
    /// `d = ...;`
    pub offsets: Option<Offsets>,
    /// `signs = { C: - };` with true for minus.
    pub signs: Vec<Assign<bool>>,
    /// `axes = { B: Rx(-45 deg) * Y };`
    pub directions: Vec<Assign<Direction>>,
    /// `dims = { d: 150.0 };`
    pub dimensions: Vec<Assign<DimensionValue>>,
    /// `tool_axis = (0, 0, 1);`
    pub tool_axis: Option<Direction>,
    /// `up = Y;`
    pub up: Option<Up>,
    /// `crate = ::my_runtime;`: the path of the runtime.
    pub runtime: Option<syn::Path>,
    /// Fields and entries that could not be read; they are reported already.
    pub unreadable: Unreadable,
    /// `hold = { W: 0 };`
    pub hold: Vec<Assign<Expr>>,
    /// `limits = { B: -5..110, C: free };`
    pub limits: Vec<Assign<Limits>>,
    /// `speeds = { B: 3600 };`
    pub speeds: Vec<Assign<Expr>>,
    /// `verify "source" { equations }`
    pub verify: Vec<Verify>,
}

impl Declaration {
    /// The same machine, without attributes, visibility, runtime and equations.
    pub(crate) fn kinematics(&self) -> Self {
        Self {
            attributes: Vec::new(),
            visibility: syn::Visibility::Inherited,
            name: self.name.clone(),
            chain: self.chain.clone(),
            offsets: self.offsets.clone(),
            signs: self.signs.clone(),
            directions: self.directions.clone(),
            dimensions: self.dimensions.clone(),
            tool_axis: self.tool_axis.clone(),
            up: self.up,
            runtime: None,
            unreadable: self.unreadable.clone(),
            hold: self.hold.clone(),
            limits: self.limits.clone(),
            speeds: self.speeds.clone(),
            verify: Vec::new(),
        }
    }
}

/// Fields and entries that could not be read: no later message complains that they are missing.
#[derive(Debug, Clone, Default)]
pub struct Unreadable {
    fields: Vec<&'static str>,
    entries: Vec<(&'static str, String)>,
}

impl Unreadable {
    /// Adds a field.
    pub(crate) fn add_field(&mut self, field: &'static str) {
        self.fields.push(field);
    }

    /// Adds an entry of a field.
    pub(crate) fn add_entry(&mut self, field: &'static str, name: &str) {
        self.entries.push((field, name.to_string()));
    }

    /// True if a field could not be read, or an entry of it.
    pub(crate) fn has_part_of(&self, field: &str) -> bool {
        self.fields.contains(&field) || self.entries.iter().any(|(known, _)| *known == field)
    }

    /// True if this entry could not be read: alone, or with its field.
    pub(crate) fn has_entry(&self, field: &str, name: &str) -> bool {
        self.fields.contains(&field) || self.entries.iter().any(|(known, entry)| *known == field && entry == name)
    }
}

/// Equations to be proven.
#[derive(Debug, Clone)]
pub struct Verify {
    /// The publication that prints them.
    pub source: String,
    /// Location of its name, or of the block.
    pub phrase: Phrase,
    /// `where alpha = -45 deg;`
    pub assumptions: Vec<Assign<Expr>>,
    /// Equations in source order.
    pub equations: Vec<Equation>,
    /// False if a statement could not be read.
    pub complete: bool,
}

/// `left = right;`
#[derive(Debug, Clone)]
pub struct Equation {
    /// Location of both sides.
    pub phrase: Phrase,
    /// Left side.
    pub left: Expr,
    /// Right side.
    pub right: Expr,
}

/// A name and its place in the source.
#[derive(Debug, Clone)]
pub struct SpannedName {
    /// As written.
    pub name: String,
    /// Location in the source.
    pub phrase: Phrase,
}

/// `name: value` inside braces.
#[derive(Debug, Clone)]
pub struct Assign<T> {
    /// An axis letter or a dimension.
    pub key: SpannedName,
    /// Value after the colon.
    pub value: T,
}

/// Axes of the chain, and the machine frame between them.
#[derive(Debug, Clone)]
pub struct Chain {
    /// Location of all letters and bars after `chain:`.
    pub phrase: Phrase,
    /// Letters in order.
    pub axes: Vec<SpannedName>,
    /// For each `|`, the number of letters before it.
    pub bars: Vec<(usize, Phrase)>,
}

/// Value of `d`: points on the rotary centre lines.
#[derive(Debug, Clone)]
pub enum Offsets {
    /// One point for all rotaries.
    Common(Vector),
    /// A point for each.
    Each(Vec<Assign<Vector>>),
}

/// Default of a dimension.
#[derive(Debug, Clone)]
pub enum DimensionValue {
    /// A number with its unit.
    Given(Expr),
    /// `required`: each machine has its own length.
    RequiredLength,
    /// `required deg`: each machine has its own angle; `required near 45 deg`: about this one.
    RequiredAngle(Option<Expr>),
}

/// Three components in parentheses.
#[derive(Debug, Clone)]
pub struct Vector {
    /// Location, parentheses included.
    pub phrase: Phrase,
    /// The components.
    pub parts: Vec<Expr>,
}

/// `Rx(a) * Ry(b) * Z` or a vector.
#[derive(Debug, Clone)]
pub struct Direction {
    /// Location of the whole product.
    pub phrase: Phrase,
    /// Rotations from left to right: 0, 1, 2 for Rx, Ry, Rz, with the angle.
    pub rotations: Vec<(usize, Expr)>,
    /// True for `-Z`.
    pub negated: bool,
    /// Vector that is rotated.
    pub base: Base,
}

/// The last factor of a direction.
#[derive(Debug, Clone)]
pub enum Base {
    /// A coordinate direction: 0, 1, 2 for X, Y, Z.
    Coordinate(usize),
    /// Any vector.
    Vector(Vector),
}

/// Travel of an axis.
#[derive(Debug, Clone)]
pub enum Limits {
    /// `free`: no limits.
    Free,
    /// Lower and upper end, inclusive.
    Range(Box<(Expr, Expr)>),
}

/// As it is written in an equation: `k = cos(B)`.
impl fmt::Display for Equation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.left, self.right)
    }
}

/// The field as it should be written: `chain: C B | X Y Z;`.
impl fmt::Display for Chain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut words: Vec<&str> = self.axes.iter().map(|axis| axis.name.as_str()).collect();
        for (place, _) in self.bars.iter().rev() {
            words.insert((*place).min(words.len()), "|");
        }
        write!(f, "chain: {};", words.join(" "))
    }
}

/// `(0, 0, d)`
impl fmt::Display for Vector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts: Vec<String> = self.parts.iter().map(ToString::to_string).collect();
        write!(f, "({})", parts.join(", "))
    }
}

/// `Rx(-45 deg) * -Y`
impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (coordinate, angle) in &self.rotations {
            write!(f, "R{}({angle}) * ", ["x", "y", "z"][*coordinate])?;
        }
        f.write_str(if self.negated { "-" } else { "" })?;
        match &self.base {
            Base::Coordinate(coordinate) => f.write_str(["X", "Y", "Z"][*coordinate]),
            Base::Vector(vector) => vector.fmt(f),
        }
    }
}
