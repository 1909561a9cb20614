//! The meaning of names in an equation.

use std::collections::BTreeMap;

use super::algebra::Algebra;
use super::value::{Angle, Value};
use crate::check::{self, DimensionNames, Fault};
use crate::model::{AxisId, AxisKind, Model, Quantity};
use crate::suggest;
use crate::symbolic::{Matrix, Poly, PolyVector, Ring, Symbol};
use crate::syntax::{Assign, Equation, Expr, Unreadable, Verify};

/// Names of one block of equations, and the algebra of the current equation.
#[derive(Debug, Clone)]
pub(crate) struct Scope<'a> {
    algebra: Algebra<'a>,
    /// Values of set-up symbols, dimensions and held axes in this block.
    assumed: BTreeMap<Symbol, Poly>,
    /// Names that `where` introduces, each with its expression: it may have roots and divisors, which belong to the
    /// equation that mentions it.
    locals: Vec<(String, Expr)>,
    /// Values of the locals in the current equation, as far as it mentions them.
    values: Vec<Option<Value>>,
    /// Number of locals that can be mentioned: those before the one that is evaluated.
    visible: usize,
    /// Values of x y z and i j k.
    tip: PolyVector,
    axis: PolyVector,
    /// Sines and cosines of the angles of a free tool axis.
    free_angles: Vec<(Symbol, Symbol)>,
}

impl<'a> Scope<'a> {
    /// The names of a block; x y z and i j k are the forward kinematics. `product` is `T(q)`.
    pub(crate) fn new(model: &'a Model, ring: Ring, product: &Matrix, block: &Verify) -> Result<Self, Vec<Fault>> {
        let mut scope = Self {
            algebra: Algebra::new(model, ring),
            assumed: BTreeMap::new(),
            locals: Vec::new(),
            values: Vec::new(),
            visible: 0,
            tip: product.origin(),
            axis: product.rotate(&model.tool_axis, &model.ring),
            free_angles: Vec::new(),
        };
        let mut faults = Vec::new();
        for (place, assumption) in block.assumptions.iter().enumerate() {
            let earlier = &block.assumptions[..place];
            if earlier.iter().any(|known| known.key.name == assumption.key.name) {
                let text = format!("`{}` is given twice by `where`", assumption.key.name);
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
        scope.tip = scope.tip.clone().map(|part| scope.assumed(&part));
        scope.axis = scope.axis.clone().map(|part| scope.assumed(&part));
        for place in 0..scope.locals.len() {
            scope.begin();
            faults.extend(scope.local(place).err());
        }
        if faults.is_empty() { Ok(scope) } else { Err(faults) }
    }

    /// Begins an equation.
    pub(crate) fn begin(&mut self) {
        self.algebra.begin();
        self.values = vec![None; self.locals.len()];
    }

    /// The value of a name that `where` introduces.
    fn local(&mut self, place: usize) -> Result<Value, Fault> {
        if let Some(value) = &self.values[place] {
            return Ok(value.clone());
        }
        let expr = self.locals[place].1.clone();
        let visible = std::mem::replace(&mut self.visible, place);
        let value = self.value(&expr);
        self.visible = visible;
        let value = value?;
        self.values[place] = Some(value.clone());
        Ok(value)
    }

    /// The machine.
    pub(crate) fn model(&self) -> &'a Model {
        self.algebra.model()
    }

    /// Symbols and their relations.
    pub(crate) fn ring(&self) -> &Ring {
        self.algebra.ring()
    }

    /// The algebra of the current equation.
    pub(crate) fn algebra(&self) -> &Algebra<'a> {
        &self.algebra
    }

    /// The algebra of the current equation, mutable.
    pub(crate) fn algebra_mut(&mut self) -> &mut Algebra<'a> {
        &mut self.algebra
    }

    /// A polynomial with the assumptions of the block put in.
    pub(crate) fn assumed(&self, poly: &Poly) -> Poly {
        self.ring().substitute(poly, &self.assumed)
    }

    /// The same names with x y z as unknowns.
    pub(crate) fn with_free_tip(&self) -> Self {
        Self { tip: self.model().symbols.tip.map(Poly::from), values: vec![None; self.locals.len()], ..self.clone() }
    }

    /// The same names on a machine with any chain: x y z as unknowns, i j k by two unknown angles.
    pub(crate) fn with_free_pose(&self) -> Self {
        let mut free = self.with_free_tip();
        let ring = free.algebra.ring_mut();
        let [tilt, turn] = [ring.sin_cos("sin(tilt)", "cos(tilt)"), ring.sin_cos("sin(turn)", "cos(turn)")];
        let across = |part: Symbol| ring.mul(&Poly::from(tilt.0), &Poly::from(part));
        free.axis = [across(turn.1), across(turn.0), Poly::from(tilt.1)];
        free.free_angles = vec![tilt, turn];
        free
    }

    /// The unknowns of a free pose: the tip, and the sines of two angles; none where the pose is that of the chain.
    pub(crate) fn free_symbols(&self) -> impl Iterator<Item = Symbol> {
        let tip = if self.free_angles.is_empty() { None } else { Some(self.model().symbols.tip) };
        tip.into_iter().flatten().chain(self.free_angles.iter().map(|(sine, _)| *sine))
    }

    /// Whether an equation mentions a dimension that is an angle, by itself or by `where`.
    pub(crate) fn mentions_angle_dimension(&self, block: &Verify, equation: &Equation) -> bool {
        let mut exprs = vec![&equation.left, &equation.right];
        let mut rest: Vec<&Assign<Expr>> = block.assumptions.iter().collect();
        // What the names of `where` that it mentions stand for.
        while let Some(place) = rest.iter().position(|name| exprs.iter().any(|expr| expr.mentions(&name.key.name))) {
            exprs.push(&rest.swap_remove(place).value);
        }
        let mut dimensions = self.model().dimensions.iter();
        dimensions.any(|dimension| {
            matches!(dimension.quantity, Quantity::Angle(..)) && exprs.iter().any(|expr| expr.mentions(&dimension.name))
        })
    }

    /// Set-up symbols that a block does not mention: they are zero in it.
    pub(crate) fn unmentioned(&self, block: &Verify) -> Vec<(&'static str, Symbol)> {
        let [x, y, z] = self.model().symbols.part;
        let known = [("gauge", self.model().symbols.gauge), ("part_x", x), ("part_y", y), ("part_z", z)];
        let mentioned = |name: &str| {
            block.assumptions.iter().any(|assumption| assumption.key.name == name || assumption.value.mentions(name))
                || block.equations.iter().any(|equation| equation.left.mentions(name) || equation.right.mentions(name))
        };
        known.into_iter().filter(|(name, _)| !mentioned(name)).collect()
    }

    /// Names that `where` introduces and nothing mentions.
    pub(crate) fn unused_names(&self, block: &Verify) -> Vec<Fault> {
        if !block.complete {
            return Vec::new();
        }
        let mentioned = |name: &str| {
            block.assumptions.iter().any(|assumption| assumption.value.mentions(name))
                || block.equations.iter().any(|equation| equation.left.mentions(name) || equation.right.mentions(name))
        };
        let local = |name: &str| self.locals.iter().any(|(known, _)| known == name);
        let unused = block.assumptions.iter().map(|assumption| &assumption.key);
        let unused = unused.filter(|key| local(&key.name) && !mentioned(&key.name));
        unused
            .map(|key| {
                let text = format!("no equation of this block mentions `{}`", key.name);
                Fault::new(key.phrase, text, "remove it, or correct the name in the equations")
            })
            .collect()
    }

    /// Pairs (sine, cosine) of all unknown angles.
    pub(crate) fn circles(&self) -> Vec<(Symbol, Symbol)> {
        let axes = self.model().axes.iter().filter(|axis| axis.kind == AxisKind::Rotary).map(|axis| axis.sin_cos);
        let dimensions = self.model().dimensions.iter().filter_map(|dimension| match dimension.quantity {
            Quantity::Angle(sine, cosine) => Some((sine, cosine)),
            Quantity::Length(_) => None,
        });
        axes.chain(dimensions).chain(self.free_angles.iter().copied()).collect()
    }

    /// `B != 0` for `1 - cos B`, and `B != 180 deg` for `1 + cos B`: zero at one position of an angle alone.
    pub(crate) fn angle_at_which_zero(&self, poly: &Poly) -> Option<String> {
        let axes = self.model().axes.iter().map(|axis| (axis.letter.to_string(), axis.sin_cos.1));
        let dimensions = self.model().dimensions.iter().filter_map(|dimension| match dimension.quantity {
            Quantity::Angle(_, cosine) => Some((dimension.name.clone(), cosine)),
            Quantity::Length(_) => None,
        });
        let is = |other: &Poly| self.ring().is_zero(&(poly - other)) || self.ring().is_zero(&(poly + other));
        axes.chain(dimensions).find_map(|(name, cosine)| {
            let cosine = Poly::from(cosine);
            let position = match (is(&(&Poly::one() - &cosine)), is(&(&Poly::one() + &cosine))) {
                (true, _) => "0",
                (_, true) => "180 deg",
                (false, false) => return None,
            };
            Some(format!("{name} != {position}"))
        })
    }

    /// The axis of the chain with this letter.
    pub(crate) fn axis_named(&self, name: &str) -> Option<AxisId> {
        self.model().axes.iter().position(|axis| axis.letter.to_string() == name)
    }

    fn assume(&mut self, assumption: &Assign<Expr>) -> Result<(), Fault> {
        let Assign { key, value } = assumption;
        let unreadable = Unreadable::default();
        let names = DimensionNames { dimensions: &self.model().dimensions, unreadable: &unreadable };
        let set_up = ["gauge", "part_x", "part_y", "part_z"].iter().position(|name| key.name == *name);
        let held = self.axis_named(&key.name).filter(|axis| self.model().axes[*axis].held.is_some());
        let dimension = self.model().dimensions.iter().find(|dimension| dimension.name == key.name);
        let quantity = match (set_up, held, dimension) {
            (Some(0), ..) => Some(Quantity::Length(self.model().symbols.gauge)),
            (Some(place), ..) => Some(Quantity::Length(self.model().symbols.part[place - 1])),
            (_, Some(axis), _) => {
                let axis = &self.model().axes[axis];
                Some(match axis.kind {
                    AxisKind::Linear => Quantity::Length(axis.word),
                    AxisKind::Rotary => Quantity::Angle(axis.sin_cos.0, axis.sin_cos.1),
                })
            }
            (_, _, Some(dimension)) => Some(dimension.quantity),
            _ => None,
        };
        match quantity {
            Some(Quantity::Length(symbol)) => {
                let length = check::length(value, &names, self.ring())?;
                self.assumed.insert(symbol, length);
            }
            Some(Quantity::Angle(sine, cosine)) => {
                let pair = check::angle(value, &names, self.algebra.ring_mut())?;
                self.assumed.insert(sine, pair.0);
                self.assumed.insert(cosine, pair.1);
            }
            None if is_taken(&key.name) => {
                return Err(Fault::new(
                    key.phrase,
                    format!("`where` cannot give a value to `{}`", key.name),
                    "`where` gives a value to a dimension, to `gauge`, `part_x`, `part_y`, `part_z`, to a held axis, or to a new name",
                ));
            }
            None => {
                self.locals.push((key.name.clone(), value.clone()));
                self.visible = self.locals.len();
            }
        }
        Ok(())
    }

    /// The value of a name.
    pub(crate) fn name(&mut self, name: &str, expr: &Expr) -> Result<Value, Fault> {
        let symbols = &self.model().symbols;
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
            let axis = &self.model().axes[axis];
            return Ok(match axis.kind {
                AxisKind::Linear => number(axis.word),
                AxisKind::Rotary => angle(axis.sin_cos),
            });
        }
        if name == "gauge" {
            return Ok(number(symbols.gauge));
        }
        if let Some(place) = ["part_x", "part_y", "part_z"].iter().position(|known| *known == name) {
            return Ok(number(symbols.part[place]));
        }
        if let Some(place) = self.locals[..self.visible].iter().position(|(known, _)| known == name) {
            return self.local(place);
        }
        match self.model().dimensions.iter().find(|dimension| dimension.name == name) {
            Some(dimension) => Ok(match dimension.quantity {
                Quantity::Length(symbol) => number(symbol),
                Quantity::Angle(sine, cosine) => angle((sine, cosine)),
            }),
            None => Err(Fault::new(expr.phrase, format!("unknown name `{name}` in `verify`"), self.help_for(name))),
        }
    }

    /// What a name that is unknown probably means.
    fn help_for(&self, name: &str) -> String {
        let model = self.model();
        if self.locals.iter().any(|(known, _)| known == name) {
            return format!("write the line `where {name} = ...;` before the one that mentions it");
        }
        if name.eq_ignore_ascii_case("pi") {
            return "angles are in degrees: write `180 deg`".into();
        }
        // Short forms of papers: `cB`, `s_B`, `cosB`.
        let angle = |name: &str| {
            let axis = self.axis_named(name).is_some_and(|axis| model.axes[axis].kind == AxisKind::Rotary);
            let dimension = model
                .dimensions
                .iter()
                .any(|known| known.name == name && matches!(known.quantity, Quantity::Angle(..)));
            axis || dimension
        };
        for (short, function) in
            [("sin", "sin"), ("cos", "cos"), ("s", "sin"), ("c", "cos"), ("S", "sin"), ("C", "cos")]
        {
            let rest = name.strip_prefix(short).map(|rest| rest.trim_start_matches('_'));
            if let Some(rest) = rest.filter(|rest| angle(rest)) {
                return format!("write `{function}({rest})`");
            }
        }
        let letters: Vec<String> = model.axes.iter().map(|axis| axis.letter.to_string()).collect();
        let known = ["x", "y", "z", "i", "j", "k", "gauge", "part_x", "part_y", "part_z"].into_iter();
        let known = known
            .chain(letters.iter().map(String::as_str))
            .chain(model.dimensions.iter().map(|dimension| dimension.name.as_str()))
            .chain(self.locals.iter().map(|(name, _)| name.as_str()));
        if let Some(near) = suggest::nearest(name, known) {
            return format!("did you mean `{near}`? Or give it a meaning: `where {name} = ...;`");
        }
        format!(
            "the names are x y z i j k, the axes {}, {}gauge, part_x, part_y, part_z; a symbol of the source gets its meaning by `where {name} = ...;`",
            self.letters(),
            self.dimensions()
        )
    }

    fn letters(&self) -> String {
        self.model().letters(0..self.model().axes.len())
    }

    fn dimensions(&self) -> String {
        self.model().dimensions.iter().map(|dimension| format!("{}, ", dimension.name)).collect()
    }

    fn replaced(&self, symbol: Symbol) -> Poly {
        self.assumed.get(&symbol).cloned().unwrap_or_else(|| Poly::from(symbol))
    }
}

/// Names with a meaning of their own.
fn is_taken(name: &str) -> bool {
    check::is_reserved(name)
}
