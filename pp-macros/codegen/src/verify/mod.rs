//! `verify "source" { equations }`: equations as papers print them, decided against the chain.
//!
//! Every name except axis letters is replaced by the forward product; the rest is decided by remainders (`decide`). The
//! message for a false equation has the formula that does follow, the difference, and the one small change that would
//! make it true, if there is one (`repair`).

mod algebra;
mod decide;
mod evaluate;
mod repair;
mod scope;
mod value;
mod witness;

use std::collections::BTreeMap;

use decide::{Condition, Verdict, decide};
use scope::Scope;
use value::Value;
use witness::{Region, has_witness};

use crate::formula::{Formula, first_branch};
use crate::model::{AxisId, AxisKind, Model};
use crate::report::Errors;
use crate::solve::{Orientation, SideCondition, Solved};
use crate::symbolic::{Interpreter, Matrix, Poly, Ring, Sign, Surd, sign_of};
use crate::syntax::{Equation, Expr, ExprKind, Unit, Verify};

/// Products of monomials allowed for the search for a remedy; an equation of a paper needs a hundredth of it.
const MOST_REPAIR_WORK: usize = 50_000;

/// A block whose equations hold.
#[derive(Debug, Clone)]
pub struct Verified {
    /// The publication that prints them.
    pub source: String,
    /// Values given by `where`, and set-up symbols that are zero: `gauge = 0, part = 0`.
    pub assumptions: Vec<String>,
    /// Equations in source order.
    pub equations: Vec<Proven>,
}

/// An equation that holds.
#[derive(Debug, Clone)]
pub struct Proven {
    /// As written.
    pub left: Formula,
    /// As written.
    pub right: Formula,
    /// Conditions under which it holds, as text; it holds everywhere if there are none.
    pub holds: Vec<String>,
    /// Divisors that contain dimensions only.
    divisors: Vec<Poly>,
}

/// Decides all equations; reports each that does not hold.
pub fn verify(blocks: &[Verify], model: &Model, solved: &mut Solved, errors: &mut Errors) -> Vec<Verified> {
    if blocks.is_empty() {
        return Vec::new();
    }
    let product = model.product();
    let derived = Derived::new(model, solved);
    let verified: Vec<Verified> =
        blocks.iter().filter_map(|block| verify_block(block, model, &derived, &product, errors)).collect();
    for Verified { source, equations, .. } in &verified {
        for divisor in equations.iter().flat_map(|equation| &equation.divisors) {
            let divisor = solved.graph.declared(divisor);
            if !solved.conditions.iter().any(|known| known.divisor == divisor) {
                let meaning = format!("equations of \"{source}\" divide by it");
                solved.conditions.push(SideCondition { divisor, tolerance: 1e-9, meaning });
            }
        }
    }
    verified
}

/// Formulas of the solver, as polynomials.
struct Derived {
    /// Ring with all symbols of the other fields.
    ring: Ring,
    /// Values of the solved linear axes.
    linear: Vec<(AxisId, Poly)>,
    /// Formulas of the solved rotary axes on the first branch.
    rotary: Vec<(AxisId, Formula)>,
    /// Positive on the first branch, negative on the second.
    side: Option<Poly>,
}

impl Derived {
    fn new(model: &Model, solved: &mut Solved) -> Self {
        let rotary = first_branch(model, solved);
        let values = solved.position.values.clone();
        let Solved { graph, orientation, .. } = solved;
        let mut reader = Interpreter::new(graph, BTreeMap::new());
        let linear = values.into_iter().map(|(axis, node)| (axis, reader.value(node))).collect();
        let side = match orientation {
            Orientation::Two(two) => {
                let side = two.side(model, &mut reader);
                Some(if two.first_is_plus() { side } else { -&side })
            }
            Orientation::Fixed { .. } | Orientation::One(_) => None,
        };
        Self { ring: reader.ring().clone(), linear, rotary, side }
    }

    /// The signs that distinguish the branches, with the assumptions of a block.
    fn branches(&self, scope: &Scope<'_>) -> Vec<(Sign, &'static str)> {
        let Some(side) = &self.side else { return Vec::new() };
        let side = scope.assumed(side);
        if scope.ring().is_zero(&side) {
            return Vec::new();
        }
        let sign = |side: &Poly| sign_of(scope.ring(), side, &scope.circles());
        vec![(sign(&side), "the first branch"), (sign(&-&side), "the second branch")]
    }

    /// The value of a solved linear axis in x y z and the rotary axes, if it has no divisor.
    fn linear(&self, scope: &Scope<'_>, left: &Expr) -> Option<Poly> {
        let ExprKind::Name(name) = &left.kind else { return None };
        let axis = scope.axis_named(name)?;
        let (_, value) = self.linear.iter().find(|(known, _)| *known == axis)?;
        let value = scope.assumed(value);
        (!self.ring.has_reciprocal(&value)).then_some(value)
    }

    /// The formula that follows from the chain for the left side, in the language of the macro.
    fn formula(&self, scope: &Scope<'_>, left: &Expr) -> Option<String> {
        let ExprKind::Name(name) = &left.kind else { return None };
        if let Some(value) = self.linear(scope, left) {
            return Some(scope.algebra().formula(&value).source());
        }
        if let Some(axis) = scope.axis_named(name) {
            return self.rotary.iter().find(|(known, _)| *known == axis).map(|(_, formula)| formula.source());
        }
        match scope.clone().value(left) {
            Ok(Value::Number(value)) => Some(scope.algebra().formula(&value).source()),
            _ => None,
        }
    }
}

fn verify_block(
    block: &Verify,
    model: &Model,
    derived: &Derived,
    product: &Matrix,
    errors: &mut Errors,
) -> Option<Verified> {
    let mut scope = match Scope::new(model, derived.ring.clone(), product, block) {
        Ok(scope) => scope,
        Err(faults) => {
            faults.into_iter().for_each(|fault| fault.report(errors));
            return None;
        }
    };
    let branches = derived.branches(&scope);
    let mut equations = Vec::new();
    let mut solution = OneSolution::default();
    for equation in &block.equations {
        if equation.left.to_string() == equation.right.to_string() {
            errors.push(
                equation.phrase,
                "this equation proves nothing: both sides are the same",
                "write the formula of the source on the right",
            );
            continue;
        }
        match decide(&mut scope, equation) {
            Ok(Verdict::Holds(conditions, region)) => {
                let proven = proven(&scope, equation, &conditions, &branches);
                solution.add(&scope, equation, region, &proven, errors);
                equations.push(proven);
            }
            Ok(verdict) => report(&scope, equation, &verdict, derived, errors),
            Err(fault) => fault.report(errors),
        }
    }
    scope.unused_names(block).into_iter().for_each(|fault| fault.report(errors));
    let mut assumptions: Vec<String> =
        block.assumptions.iter().map(|assumption| format!("{} = {}", assumption.key.name, assumption.value)).collect();
    let zero = scope.unmentioned(block);
    assumptions.extend(zero.iter().filter(|(name, _)| *name == "gauge").map(|_| "gauge = 0".to_string()));
    let parts: Vec<&str> = zero.iter().map(|(name, _)| *name).filter(|name| *name != "gauge").collect();
    match parts[..] {
        [_, _, _] => assumptions.push("part = 0".into()),
        _ => assumptions.extend(parts.iter().map(|name| format!("{name} = 0"))),
    }
    Some(Verified { source: block.source.clone(), assumptions, equations })
}

/// Equations of a block that hold in a part of the poses only. They describe one solution, so these parts have a pose in
/// common: the formulas of the two branches are never mixed.
#[derive(Default)]
struct OneSolution<'a> {
    parts: Vec<(&'a Equation, Region, String)>,
}

impl<'a> OneSolution<'a> {
    /// Adds an equation, or reports that it contradicts those before it.
    fn add(&mut self, scope: &Scope<'_>, equation: &'a Equation, region: Region, proven: &Proven, errors: &mut Errors) {
        if region.is_everywhere() {
            return;
        }
        let holds = proven.holds.join(" and ");
        let mut regions: Vec<&Region> = self.parts.iter().map(|(_, region, _)| region).collect();
        regions.push(&region);
        if has_witness(scope, &regions) {
            self.parts.push((equation, region, holds));
            return;
        }
        let pair = self.parts.iter().find(|(_, known, _)| !has_witness(scope, &[known, &region]));
        let (others, where_others) = match pair {
            Some((other, _, condition)) => {
                (format!("`{} = {}`", other.left, other.right), format!("that one holds where {condition}"))
            }
            None => ("the equations before it".into(), "they hold on one branch only".into()),
        };
        errors.push(
            equation.phrase,
            format!("this equation and {others} hold at no common pose\n  {where_others}\n  this one holds where {holds}"),
            "a block describes one solution: correct a sign, or put the formulas of the other branch into a block of their own",
        );
    }
}

fn proven(scope: &Scope<'_>, equation: &Equation, conditions: &[Condition], branches: &[(Sign, &str)]) -> Proven {
    let dimensions = scope.model().dimension_symbols();
    let holds = conditions
        .iter()
        .map(|condition| {
            let branch = match condition {
                Condition::Positive(sign) | Condition::NotNegative(sign) => {
                    branches.iter().find(|(known, _)| known == sign).map(|(_, name)| name)
                }
                Condition::NotZero(_) => None,
            };
            let text = condition.text(scope);
            branch.map_or(text.clone(), |branch| format!("{text} ({branch})"))
        })
        .collect();
    let divisors = conditions.iter().flat_map(|condition| match condition {
        Condition::NotZero(zeros) => zeros.clone(),
        _ => Vec::new(),
    });
    Proven {
        left: as_written(&equation.left),
        right: as_written(&equation.right),
        holds,
        divisors: divisors.filter(|divisor| divisor.symbols().all(|symbol| dimensions.contains(&symbol))).collect(),
    }
}

/// Reports an equation that does not hold.
fn report(scope: &Scope<'_>, equation: &Equation, verdict: &Verdict, derived: &Derived, errors: &mut Errors) {
    let left = &equation.left;
    match verdict {
        Verdict::Holds(..) => {}
        Verdict::Opposite => errors.push(
            equation.phrase,
            format!("this formula gives `{left} + 180 deg` at every pose"),
            "change the sign of both arguments",
        ),
        Verdict::Nowhere => errors.push(
            equation.phrase,
            format!("this formula for `{left}` holds at no pose"),
            "check the signs of roots and arguments",
        ),
        Verdict::False(gap) => {
            let change = repair(scope, equation);
            let (gap, missing) = difference(scope, equation, gap, derived);
            let mut text = format!("this equation for `{left}` does not follow from the chain");
            if let Some(derived) = derived.formula(scope, left) {
                text += &format!("\n  derived:    {left} = {derived}");
            }
            text += &format!("\n  {gap}");
            let help = change.or(missing).unwrap_or_else(|| {
                "no single change makes it true; compare `signs`, `d` and `axes` with the source as well".into()
            });
            errors.push(equation.phrase, text, help);
        }
    }
}

/// The first single change of the right side that makes an equation true.
fn repair(scope: &Scope<'_>, equation: &Equation) -> Option<String> {
    let mut work = 0;
    for change in repair::changes(&equation.right, scope.model()) {
        let mut scope = scope.clone();
        let changed = Equation { right: change.expr, ..equation.clone() };
        if let Ok(Verdict::Holds(..)) = decide(&mut scope, &changed) {
            return Some(change.words);
        }
        work += scope.algebra().work();
        if work > MOST_REPAIR_WORK {
            break;
        }
    }
    None
}

/// The polynomial that should be zero, as text; and the missing term on the right, if only one is missing.
fn difference(scope: &Scope<'_>, equation: &Equation, gap: &Poly, derived: &Derived) -> (String, Option<String>) {
    if let Some(value) = derived.linear(scope, &equation.left) {
        let mut free = scope.with_free_tip();
        let mut linears = scope.model().axes.iter().filter(|axis| axis.kind == AxisKind::Linear);
        let mentions_linear_axes = linears.any(|axis| equation.right.mentions(&axis.letter.to_string()));
        if !mentions_linear_axes && let Ok(Value::Number(written)) = free.value(&equation.right) {
            let gap = free.algebra().formula(&(&value - &written));
            return (format!("difference: {}", gap.source()), missing_term(&gap));
        }
    }
    // Only its zeros matter, not its divisors.
    let gap = scope.algebra().formula(&scope.ring().clear_even(gap));
    if is_number(scope, &equation.left) {
        (format!("difference: {}", gap.source()), missing_term(&gap))
    } else {
        (format!("not zero:   {}", gap.source()), None)
    }
}

fn is_number(scope: &Scope<'_>, left: &Expr) -> bool {
    matches!(scope.clone().value(left), Ok(Value::Number(_)))
}

/// The missing term, if the difference is a single one.
fn missing_term(gap: &Formula) -> Option<String> {
    match gap {
        Formula::Sum(_) => None,
        Formula::Neg(term) if matches!(**term, Formula::Sum(_)) => None,
        Formula::Neg(term) => Some(format!("add `- {}`", term.source())),
        term => Some(format!("add `+ {}`", term.source())),
    }
}

/// An expression as it is written.
fn as_written(expr: &Expr) -> Formula {
    let inner = |expr: &Expr| Box::new(as_written(expr));
    match &expr.kind {
        ExprKind::Number(value, Some(Unit::Degree)) => Formula::Degrees(value.clone()),
        ExprKind::Number(value, _) => Formula::Number(Surd::from(value.clone())),
        ExprKind::Name(name) => Formula::name(name),
        ExprKind::Neg(negated) => Formula::Neg(inner(negated)),
        ExprKind::Power(base, exponent) => Formula::Power(inner(base), *exponent),
        ExprKind::Call(name, arguments) => Formula::call(name, arguments.iter().map(as_written)),
        ExprKind::Binary(left, '/', right) => match as_written(left) {
            Formula::Neg(left) => Formula::Neg(Box::new(Formula::Quotient(left, inner(right)))),
            left => Formula::Quotient(Box::new(left), inner(right)),
        },
        ExprKind::Binary(left, operator, right) => {
            let right = as_written(right);
            let right = if *operator == '-' { Formula::Neg(Box::new(right)) } else { right };
            match (as_written(left), operator) {
                (Formula::Neg(left), '*') => Formula::Neg(Box::new(product(*left, right))),
                (left, '*') => product(left, right),
                (Formula::Sum(mut terms), _) => {
                    terms.push(right);
                    Formula::Sum(terms)
                }
                (left, _) => Formula::Sum(vec![left, right]),
            }
        }
    }
}

fn product(left: Formula, right: Formula) -> Formula {
    match left {
        Formula::Product(mut factors) => {
            factors.push(right);
            Formula::Product(factors)
        }
        left => Formula::Product(vec![left, right]),
    }
}
