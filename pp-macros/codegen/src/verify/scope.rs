//! The meaning of names in an equation, and the value of an expression.

use std::cell::Cell;
use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::check::{self, DimensionNames, Fault};
use crate::formula::Formula;
use crate::model::{AxisId, Kind, Model, Quantity};
use crate::symbolic::{Matrix, P3, Poly, Ring, Surd, Symbol, turn_by};
use crate::syntax::{Assign, Expr, ExprKind, Unit, Verify};

/// Products of more monomials than this are not multiplied out: no paper prints one.
const MOST_MONOMIALS: usize = 200_000;

/// Sums of more terms are not shown: no one would read them, and factoring them takes long.
const MOST_TERMS: usize = 100;

/// Products of monomials that one equation may take: a second or two.
const MOST_WORK: usize = 50_000;

/// Monomials that a polynomial may have when all divisors are multiplied out, before like ones are added.
const MOST_CLEARED: usize = 20_000;

/// Largest power of one divisor.
const MOST_DIVISIONS: u32 = 8;

/// The value of an expression.
#[derive(Debug, Clone)]
pub(crate) enum Value {
    /// A number or a length.
    Number(Poly),
    /// An angle, as the direction (cosine, sine) times a positive factor.
    Angle(Angle),
}

/// A direction in the plane.
#[derive(Debug, Clone)]
pub(crate) struct Angle {
    pub(crate) cosine: Poly,
    pub(crate) sine: Poly,
    /// Set for `asin` and `acos`, whose other part is a root.
    pub(crate) inverse: Option<Inverse>,
}

/// An angle known by one part; the other has a known sign.
#[derive(Debug, Clone)]
pub(crate) enum Inverse {
    /// `asin(p)`: the cosine is not negative.
    Sine(Poly),
    /// `acos(p)`, and with true its negative: the sine is not negative, or not positive.
    Cosine(Poly, bool),
}

/// Names of one block, and the algebra of one equation in it.
#[derive(Debug, Clone)]
pub(crate) struct Scope<'a> {
    pub(crate) model: &'a Model,
    pub(crate) ring: Ring,
    /// Values of set-up symbols, dimensions and held axes in this block.
    pub(crate) assumed: BTreeMap<Symbol, Poly>,
    locals: Vec<(String, Value)>,
    /// Values of x y z and i j k.
    tip: P3,
    axis: P3,
    /// Divisors and roots of the equation at hand.
    pub(crate) divisors: Vec<(Poly, Symbol)>,
    pub(crate) roots: Vec<Symbol>,
    /// Products of monomials that the equation has taken.
    pub(crate) work: Cell<usize>,
}

impl<'a> Scope<'a> {
    /// The names of a block, x y z and i j k made by the axes. `product` is `T(q)`.
    pub(crate) fn new(model: &'a Model, ring: Ring, product: &Matrix, block: &Verify) -> Result<Self, Vec<Fault>> {
        let mut scope = Self {
            model,
            ring,
            assumed: BTreeMap::new(),
            locals: Vec::new(),
            tip: product.origin(),
            axis: product.turn(&model.tool_axis, &model.ring),
            divisors: Vec::new(),
            roots: Vec::new(),
            work: Cell::new(0),
        };
        let mut faults = Vec::new();
        for (place, assumption) in block.assumptions.iter().enumerate() {
            let earlier = &block.assumptions[..place];
            if earlier.iter().any(|known| known.key.name == assumption.key.name) {
                let text = format!("`{}` is assumed twice", assumption.key.name);
                faults.push(Fault::new(assumption.key.phrase, text, "keep one of the two"));
            } else if let Err(fault) = scope.assume(assumption) {
                faults.push(fault);
            }
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        for (_, symbol) in scope.unmentioned(block) {
            scope.assumed.insert(symbol, Poly::zero());
        }
        scope.tip = scope.tip.clone().map(|part| scope.ring.substitute(&part, &scope.assumed));
        scope.axis = scope.axis.clone().map(|part| scope.ring.substitute(&part, &scope.assumed));
        Ok(scope)
    }

    /// The same names with x y z as unknowns.
    pub(crate) fn with_free_tip(&self) -> Self {
        Self { tip: self.model.frame.tip.map(Poly::from), ..self.clone() }
    }

    /// Set-up symbols that a block does not mention: they are zero in it.
    pub(crate) fn unmentioned(&self, block: &Verify) -> Vec<(&'static str, Symbol)> {
        let [x, y, z] = self.model.frame.part;
        let known = [("gauge", self.model.frame.gauge), ("part_x", x), ("part_y", y), ("part_z", z)];
        let mentioned = |name: &str| {
            block.assumptions.iter().any(|assumption| assumption.key.name == name)
                || block.equations.iter().any(|equation| equation.left.mentions(name) || equation.right.mentions(name))
        };
        known.into_iter().filter(|(name, _)| !mentioned(name)).collect()
    }

    /// Forgets divisors and roots of the equation before.
    pub(crate) fn begin(&mut self) {
        self.divisors.clear();
        self.roots.clear();
        self.work.set(0);
    }

    /// Pairs (sine, cosine) of all unknown angles.
    pub(crate) fn circles(&self) -> Vec<(Symbol, Symbol)> {
        let axes = self.model.axes.iter().filter(|axis| axis.kind == Kind::Rotary).map(|axis| axis.turn);
        let dimensions = self.model.dimensions.iter().filter_map(|dimension| match dimension.quantity {
            Quantity::Angle(sine, cosine) => Some((sine, cosine)),
            Quantity::Length(_) => None,
        });
        axes.chain(dimensions).collect()
    }

    /// The axis of the chain with this letter.
    pub(crate) fn axis_named(&self, name: &str) -> Option<AxisId> {
        self.model.axes.iter().position(|axis| axis.letter.to_string() == name)
    }

    fn assume(&mut self, assumption: &Assign<Expr>) -> Result<(), Fault> {
        let Assign { key, value } = assumption;
        let names = DimensionNames { dimensions: &self.model.dimensions, unreadable: &[] };
        let set_up = ["gauge", "part_x", "part_y", "part_z"].iter().position(|name| key.name == *name);
        let held = self.axis_named(&key.name).filter(|axis| self.model.axes[*axis].held.is_some());
        let dimension = self.model.dimensions.iter().find(|dimension| dimension.name == key.name);
        let quantity = match (set_up, held, dimension) {
            (Some(0), ..) => Some(Quantity::Length(self.model.frame.gauge)),
            (Some(place), ..) => Some(Quantity::Length(self.model.frame.part[place - 1])),
            (_, Some(axis), _) => {
                let axis = &self.model.axes[axis];
                Some(match axis.kind {
                    Kind::Linear => Quantity::Length(axis.word),
                    Kind::Rotary => Quantity::Angle(axis.turn.0, axis.turn.1),
                })
            }
            (_, _, Some(dimension)) => Some(dimension.quantity),
            _ => None,
        };
        match quantity {
            Some(Quantity::Length(symbol)) => {
                let length = check::length(value, &names, &self.ring)?;
                self.assumed.insert(symbol, length);
            }
            Some(Quantity::Angle(sine, cosine)) => {
                let turn = check::angle(value, &names, &mut self.ring)?;
                self.assumed.insert(sine, turn.0);
                self.assumed.insert(cosine, turn.1);
            }
            None if is_taken(&key.name) => {
                return Err(Fault::new(
                    key.phrase,
                    format!("`{}` cannot be assumed", key.name),
                    "`where` gives a value to a dimension, to `gauge`, `part_x`, `part_y`, `part_z`, to a held axis, or to a name of its own",
                ));
            }
            None if is_angle(value, self.model) => {
                let (sine, cosine) = check::angle(value, &names, &mut self.ring)?;
                self.locals.push((key.name.clone(), Value::Angle(Angle { cosine, sine, inverse: None })));
            }
            None => {
                let length = check::length(value, &names, &self.ring)?;
                self.locals.push((key.name.clone(), Value::Number(length)));
            }
        }
        Ok(())
    }

    fn name(&self, name: &str, expr: &Expr) -> Result<Value, Fault> {
        let frame = &self.model.frame;
        if let Some(place) = ["x", "y", "z"].iter().position(|known| *known == name) {
            return Ok(Value::Number(self.tip[place].clone()));
        }
        if let Some(place) = ["i", "j", "k"].iter().position(|known| *known == name) {
            return Ok(Value::Number(self.axis[place].clone()));
        }
        let number = |symbol: Symbol| Value::Number(self.replaced(symbol));
        let angle = |(sine, cosine): (Symbol, Symbol)| {
            Value::Angle(Angle { cosine: self.replaced(cosine), sine: self.replaced(sine), inverse: None })
        };
        if let Some(axis) = self.axis_named(name) {
            let axis = &self.model.axes[axis];
            return Ok(match axis.kind {
                Kind::Linear => number(axis.word),
                Kind::Rotary => angle(axis.turn),
            });
        }
        if name == "gauge" {
            return Ok(number(frame.gauge));
        }
        if let Some(place) = ["part_x", "part_y", "part_z"].iter().position(|known| *known == name) {
            return Ok(number(frame.part[place]));
        }
        if let Some((_, value)) = self.locals.iter().find(|(known, _)| known == name) {
            return Ok(value.clone());
        }
        match self.model.dimensions.iter().find(|dimension| dimension.name == name) {
            Some(dimension) => Ok(match dimension.quantity {
                Quantity::Length(symbol) => number(symbol),
                Quantity::Angle(sine, cosine) => angle((sine, cosine)),
            }),
            None => Err(Fault::new(
                expr.phrase,
                format!("`{name}` means nothing in `verify`"),
                format!(
                    "known are x y z i j k, the axes {}, {}gauge, part_x, part_y, part_z, and names that a `where` gives",
                    self.letters(),
                    self.dimensions()
                ),
            )),
        }
    }

    fn letters(&self) -> String {
        self.model.letters(0..self.model.axes.len())
    }

    fn dimensions(&self) -> String {
        self.model.dimensions.iter().map(|dimension| format!("{}, ", dimension.name)).collect()
    }

    fn replaced(&self, symbol: Symbol) -> Poly {
        self.assumed.get(&symbol).cloned().unwrap_or_else(|| Poly::from(symbol))
    }

    /// The value of an expression.
    pub(crate) fn value(&mut self, expr: &Expr) -> Result<Value, Fault> {
        match &expr.kind {
            ExprKind::Number(degrees, Some(Unit::Degree)) => {
                let (sine, cosine) = turn_by(degrees, &mut self.ring);
                Ok(Value::Angle(Angle { cosine, sine, inverse: None }))
            }
            ExprKind::Number(value, _) => Ok(Value::Number(Poly::from(Surd::from(value.clone())))),
            ExprKind::Name(name) => self.name(name, expr),
            ExprKind::Neg(inner) => Ok(match self.value(inner)? {
                Value::Number(value) => Value::Number(-&value),
                Value::Angle(angle) => Value::Angle(angle.negated()),
            }),
            ExprKind::Binary(left, operator, right) => self.binary(expr, left, *operator, right),
            ExprKind::Power(base, exponent) => {
                let base = self.number(base)?;
                let mut power = Poly::one();
                for _ in 0..*exponent {
                    power = self.times(&power, &base, expr)?;
                }
                Ok(Value::Number(power))
            }
            ExprKind::Call(name, arguments) => self.call(expr, name, arguments),
        }
    }

    fn binary(&mut self, expr: &Expr, left: &Expr, operator: char, right: &Expr) -> Result<Value, Fault> {
        let (a, b) = (self.value(left)?, self.value(right)?);
        match (a, operator, b) {
            (Value::Number(a), '+', Value::Number(b)) => Ok(Value::Number(&a + &b)),
            (Value::Number(a), '-', Value::Number(b)) => Ok(Value::Number(&a - &b)),
            (Value::Number(a), '*', Value::Number(b)) => Ok(Value::Number(self.times(&a, &b, expr)?)),
            (Value::Number(a), _, Value::Number(b)) => {
                let inverse = self.reciprocal(b, right)?;
                Ok(Value::Number(self.times(&a, &inverse, expr)?))
            }
            (Value::Angle(a), '+', Value::Angle(b)) => Ok(Value::Angle(self.sum(&a, &b, expr)?)),
            (Value::Angle(a), '-', Value::Angle(b)) => Ok(Value::Angle(self.sum(&a, &b.negated(), expr)?)),
            (Value::Angle(angle), '+' | '-', Value::Number(zero)) if zero.is_zero() => Ok(Value::Angle(angle)),
            (Value::Number(zero), '+', Value::Angle(angle)) if zero.is_zero() => Ok(Value::Angle(angle)),
            (Value::Number(zero), '-', Value::Angle(angle)) if zero.is_zero() => Ok(Value::Angle(angle.negated())),
            (Value::Angle(angle), '*', Value::Number(factor)) | (Value::Number(factor), '*', Value::Angle(angle)) => {
                self.multiple(&angle, &factor, expr)
            }
            (_, '+' | '-', _) => Err(Fault::new(
                expr.phrase,
                "an angle and a number do not add up",
                "give the number its unit, `90 deg`, or take sin or cos of the angle",
            )),
            _ => Err(Fault::new(
                expr.phrase,
                "an angle is added, subtracted, or multiplied by a whole number",
                "take sin or cos of it: `x * cos(C)`",
            )),
        }
    }

    fn call(&mut self, expr: &Expr, name: &str, arguments: &[Expr]) -> Result<Value, Fault> {
        match (name, arguments) {
            ("sin" | "cos", [argument]) => {
                let angle = self.angle(argument)?;
                let part = match (name, &angle.inverse) {
                    ("sin", Some(Inverse::Sine(part))) | ("cos", Some(Inverse::Cosine(part, _))) => part.clone(),
                    ("sin", _) => self.unit_part(&angle, &angle.sine, argument)?,
                    _ => self.unit_part(&angle, &angle.cosine, argument)?,
                };
                Ok(Value::Number(part))
            }
            ("sqrt", [argument]) => {
                let radicand = self.number(argument)?;
                Ok(Value::Number(self.root(radicand, argument)?))
            }
            ("atan2", [sine, cosine]) => {
                let (sine, cosine) = (self.number(sine)?, self.number(cosine)?);
                Ok(Value::Angle(Angle { cosine, sine, inverse: None }))
            }
            ("asin" | "acos", [argument]) => {
                let part = self.number(argument)?;
                let square = self.times(&part, &part, expr)?;
                let other = self.root(&Poly::one() - &square, expr)?;
                Ok(Value::Angle(if name == "asin" {
                    Angle { cosine: other, sine: part.clone(), inverse: Some(Inverse::Sine(part)) }
                } else {
                    Angle { cosine: part.clone(), sine: other, inverse: Some(Inverse::Cosine(part, false)) }
                }))
            }
            ("sin" | "cos" | "sqrt" | "asin" | "acos", _) => Err(Fault::new(
                expr.phrase,
                format!("`{name}` takes one argument, found {}", arguments.len()),
                format!("write `{name}(...)` of one expression"),
            )),
            ("atan2", _) => Err(Fault::new(
                expr.phrase,
                format!("`atan2` takes two arguments, found {}", arguments.len()),
                "write `atan2(sine, cosine)`",
            )),
            _ => Err(Fault::new(
                expr.phrase,
                format!("`{name}` is not a function of `verify`"),
                "known are sin, cos, asin, acos, atan2 and sqrt",
            )),
        }
    }

    /// A number, or a message that this is an angle.
    fn number(&mut self, expr: &Expr) -> Result<Poly, Fault> {
        match self.value(expr)? {
            Value::Number(value) => Ok(value),
            Value::Angle(_) => Err(Fault::new(
                expr.phrase,
                format!("`{expr}` is an angle where a number is needed"),
                format!("take its sine or cosine: `sin({expr})`"),
            )),
        }
    }

    fn angle(&mut self, expr: &Expr) -> Result<Angle, Fault> {
        match self.value(expr)? {
            Value::Angle(angle) => Ok(angle),
            Value::Number(zero) if zero.is_zero() => Ok(Angle::zero()),
            Value::Number(_) => Err(Fault::new(
                expr.phrase,
                format!("`{expr}` is not an angle"),
                "an angle is a rotary axis, an angle of `dims`, `45 deg`, or atan2, asin, acos of numbers",
            )),
        }
    }

    /// One part of an angle divided by the length of its direction.
    fn unit_part(&mut self, angle: &Angle, part: &Poly, expr: &Expr) -> Result<Poly, Fault> {
        let squares = [self.times(&angle.cosine, &angle.cosine, expr)?, self.times(&angle.sine, &angle.sine, expr)?];
        let square = &squares[0] + &squares[1];
        if self.ring.is_zero(&(&square - &Poly::one())) {
            return Ok(part.clone());
        }
        let length = self.root(square, expr)?;
        let inverse = self.reciprocal(length, expr)?;
        self.times(part, &inverse, expr)
    }

    /// Rule `angle-sum`.
    pub(crate) fn sum(&self, a: &Angle, b: &Angle, expr: &Expr) -> Result<Angle, Fault> {
        let cosine = &self.times(&a.cosine, &b.cosine, expr)? - &self.times(&a.sine, &b.sine, expr)?;
        let sine = &self.times(&a.sine, &b.cosine, expr)? + &self.times(&a.cosine, &b.sine, expr)?;
        Ok(Angle { cosine, sine, inverse: None })
    }

    fn multiple(&self, angle: &Angle, factor: &Poly, expr: &Expr) -> Result<Value, Fault> {
        let whole = factor.as_number().and_then(|number| number.as_rational()).filter(BigRational::is_integer);
        let Some(times) = whole.and_then(|times| times.to_integer().to_i32()).filter(|times| times.abs() <= 24) else {
            return Err(Fault::new(
                expr.phrase,
                "an angle is multiplied by a whole number only",
                "take sin or cos of it: `x * cos(C)`",
            ));
        };
        let step = if times < 0 { angle.clone().negated() } else { angle.clone() };
        if times.abs() == 1 {
            return Ok(Value::Angle(step));
        }
        let mut sum = Angle::zero();
        for _ in 0..times.abs() {
            sum = self.sum(&sum, &step, expr)?;
        }
        Ok(Value::Angle(sum))
    }

    /// Product, unless it is too large to be anybody's formula.
    pub(crate) fn times(&self, a: &Poly, b: &Poly, expr: &Expr) -> Result<Poly, Fault> {
        let work = a.monomials() * b.monomials();
        self.work.set(self.work.get() + work);
        if work > MOST_MONOMIALS || self.work.get() > MOST_WORK {
            return Err(too_large(expr));
        }
        let product = self.ring.mul(a, b);
        self.affordable(&product, expr)?;
        Ok(product)
    }

    /// Refuses a polynomial that would grow beyond reason when it is multiplied by its divisors.
    pub(crate) fn affordable(&self, poly: &Poly, expr: &Expr) -> Result<(), Fault> {
        let mut size = poly.monomials();
        for (divisor, symbol) in &self.divisors {
            let degree = poly.degree(*symbol);
            let growth = divisor.monomials().checked_pow(degree).unwrap_or(usize::MAX);
            size = size.saturating_mul(growth);
            if degree > MOST_DIVISIONS {
                return Err(too_large(expr));
            }
        }
        if size > MOST_CLEARED { Err(too_large(expr)) } else { Ok(()) }
    }

    /// A polynomial as a person writes it; of one that is too long to read, only its size.
    pub(crate) fn formula(&self, poly: &Poly) -> Formula {
        match poly.monomials() {
            terms if terms > MOST_TERMS => Formula::Sum(vec![Formula::name(format!("a sum of {terms} terms"))]),
            _ => Formula::of_poly(self.model, &self.ring, poly),
        }
    }

    fn root(&mut self, radicand: Poly, expr: &Expr) -> Result<Poly, Fault> {
        let number = radicand.as_number();
        if number.as_ref().is_some_and(|number| number.sign().is_lt())
            || self.ring.value(&radicand).is_some_and(|value| value < 0.0)
        {
            return Err(Fault::new(expr.phrase, "the root of a negative number", "check the signs under the root"));
        }
        if let Some(root) = number.and_then(|number| number.sqrt()) {
            return Ok(Poly::from(root));
        }
        if self.ring.is_zero(&radicand) {
            return Ok(Poly::zero());
        }
        if let Some(known) = self.roots.iter().find(|root| self.ring.square_of(**root) == radicand) {
            return Ok(Poly::from(*known));
        }
        let name = format!("sqrt({})", self.formula(&radicand).source());
        let root = self.ring.root(name, radicand);
        self.roots.push(root);
        Ok(Poly::from(root))
    }

    fn reciprocal(&mut self, divisor: Poly, expr: &Expr) -> Result<Poly, Fault> {
        if let Some(number) = divisor.as_number()
            && let Some(inverse) = number.inverse()
        {
            return Ok(Poly::from(inverse));
        }
        if self.ring.is_zero(&divisor) {
            return Err(Fault::new(
                expr.phrase,
                format!("`{expr}` is zero at every pose of this machine"),
                "nothing can be divided by it",
            ));
        }
        if let (Some(value), Some(size)) = (self.ring.value(&divisor), self.ring.magnitude(&divisor, &|_| None))
            && value.abs() <= 1e-12 * size
        {
            return Err(Fault::new(
                expr.phrase,
                format!("`{expr}` is a constant that cannot be told from zero"),
                "nothing can be divided by it",
            ));
        }
        if let Some((_, known)) = self.divisors.iter().find(|(known, _)| *known == divisor) {
            return Ok(Poly::from(*known));
        }
        if divisor.monomials() > 64 {
            return Err(too_large(expr));
        }
        let number = self.divisors.len() + 1;
        let symbol = self.ring.reciprocal(format!("inverse_{number}"), divisor.clone());
        self.divisors.push((divisor, symbol));
        Ok(Poly::from(symbol))
    }
}

impl Angle {
    fn zero() -> Self {
        Self { cosine: Poly::one(), sine: Poly::zero(), inverse: None }
    }

    pub(crate) fn negated(self) -> Self {
        let inverse = self.inverse.map(|inverse| match inverse {
            Inverse::Sine(part) => Inverse::Sine(-&part),
            Inverse::Cosine(part, negative) => Inverse::Cosine(part, !negative),
        });
        Self { sine: -&self.sine, inverse, ..self }
    }
}

fn too_large(expr: &Expr) -> Fault {
    Fault::new(expr.phrase, "this is too large to be decided", "split the equation, or write it in factors")
}

/// Names with a meaning of their own.
fn is_taken(name: &str) -> bool {
    check::is_reserved(name)
}

/// Whether an assumption gives an angle: it names one, or has the unit.
fn is_angle(expr: &Expr, model: &Model) -> bool {
    let dimension = |name: &str| {
        model.dimensions.iter().any(|known| known.name == name && matches!(known.quantity, Quantity::Angle(..)))
    };
    match &expr.kind {
        ExprKind::Number(_, unit) => *unit == Some(Unit::Degree),
        ExprKind::Name(name) => dimension(name),
        ExprKind::Neg(inner) => is_angle(inner, model),
        ExprKind::Binary(left, _, right) => is_angle(left, model) || is_angle(right, model),
        ExprKind::Power(..) | ExprKind::Call(..) => false,
    }
}

/// The value as an angle: a number must be zero to be one.
pub(crate) fn zero_as_angle(value: &Value) -> Option<Angle> {
    match value {
        Value::Angle(angle) => Some(angle.clone()),
        Value::Number(number) if number.is_zero() => Some(Angle::zero()),
        Value::Number(_) => None,
    }
}
