//! `verify "source" { equations }`: equations as papers print them, decided against the chain.
//!
//! Every name except axis letters is replaced by the forward product; the rest is decided by remainders (`decide`). The
//! message for a false equation has the formula that does follow, the difference, and the one small change that would
//! make it true, if there is one (`repair`). Where one change of the declaration makes all equations of a block follow,
//! that change is the message (`redeclare`).

mod algebra;
mod decide;
mod evaluate;
mod redeclare;
mod repair;
mod scope;
mod value;
mod witness;

use std::collections::BTreeMap;

use decide::{Condition, Verdict, decide};
use redeclare::{Redeclared, redeclared};
use scope::Scope;
use value::Value;
use witness::{Region, has_witness};

use crate::check::Fault;
use crate::formula::{Formula, first_branch};
use crate::model::{AxisId, AxisKind, Model};
use crate::report::{Errors, Phrase};
use crate::solve::{Orientation, SideCondition, Solved};
use crate::symbolic::{Interpreter, Matrix, Poly, Ring, Sign, Surd, sign_of};
use crate::syntax::{Declaration, Equation, Expr, ExprKind, Unit, Verify};

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
    /// The same conditions as a person reads them: `B != 0` for `1 - cos B != 0`, words for long ones.
    pub holds_in_words: Vec<String>,
    /// Divisors that contain dimensions only.
    divisors: Vec<Poly>,
}

/// Decides all equations; reports each that does not hold, or the change of the declaration with which all of them do.
pub fn verify(declaration: &Declaration, model: &Model, solved: &Solved, errors: &mut Errors) -> Vec<Verified> {
    if declaration.verify.is_empty() {
        return Vec::new();
    }
    let product = model.product();
    let derived = Derived::new(model, solved);
    let mut verified = Vec::new();
    let (mut holding, mut failing) = (Vec::new(), Vec::new());
    for block in &declaration.verify {
        let decided = Block::new(model, derived.ring.clone(), &product, block).map(|block| block.decided(&derived));
        let Decided { proven, failures, faults } =
            decided.unwrap_or_else(|faults| Decided { faults, ..Decided::default() });
        match (failures.is_empty(), faults.is_empty()) {
            (true, true) => holding.push(block),
            (false, true) => failing.push((block, failures)),
            (_, false) => failures.into_iter().for_each(|failure| failure.report(errors)),
        }
        faults.into_iter().for_each(|fault| fault.report(errors));
        verified.extend(proven);
    }
    report_failing(declaration, failing, &holding, errors);
    verified
}

/// A solved machine with the divisors of verified equations among those that must not be zero.
#[must_use]
pub fn guarded(mut solved: Solved, verified: &[Verified]) -> Solved {
    for Verified { source, equations, .. } in verified {
        for divisor in equations.iter().flat_map(|equation| &equation.divisors) {
            let divisor = solved.graph.declared(divisor);
            if !solved.conditions.iter().any(|known| known.divisor == divisor) {
                let meaning = format!("equations of \"{source}\" divide by it");
                solved.conditions.push(SideCondition { divisor, tolerance: 1e-9, meaning });
            }
        }
    }
    solved
}

/// Reports blocks with equations that do not hold: by the change of the declaration with which all of them follow, or
/// equation by equation.
fn report_failing(
    declaration: &Declaration,
    failing: Vec<(&Verify, Vec<Failure>)>,
    holding: &[&Verify],
    errors: &mut Errors,
) {
    let blocks: Vec<&Verify> = failing.iter().map(|(block, _)| *block).collect();
    let count = failing.iter().map(|(_, failures)| failures.len()).sum();
    let mut changes = redeclared(declaration, &blocks, holding, count);
    // One change that makes several blocks follow is likelier than one for each.
    let contains = |changes: &[Redeclared], field: &str| changes.iter().any(|change| change.field == field);
    let fields: Vec<String> = changes.iter().flatten().map(|change| change.field.clone()).collect();
    let for_all = |field: &str| changes.iter().all(|changes| contains(changes, field));
    let for_all: Vec<String> = fields.into_iter().filter(|field| for_all(field)).collect();
    let mut reported: Vec<String> = Vec::new();
    for ((block, failures), own) in failing.into_iter().zip(&mut changes) {
        if !for_all.is_empty() {
            own.retain(|change| for_all.contains(&change.field));
        }
        if own.is_empty() {
            failures.into_iter().for_each(|failure| failure.report(errors));
        } else if !own.iter().all(|change| reported.contains(&change.field)) {
            report_redeclared(block, &failures, own, errors);
            reported.extend(own.iter().map(|change| change.field.clone()));
        }
    }
}

/// Reports a block all of whose equations follow after one of some changes of the declaration.
fn report_redeclared(block: &Verify, failures: &[Failure], changes: &[Redeclared], errors: &mut Errors) {
    let [first, ..] = failures else { return };
    let count = match (failures.len(), block.equations.len()) {
        (1, 1) => "the equation".to_string(),
        (2, 2) => "both equations".to_string(),
        (failed, all) if failed == all => format!("all {all} equations"),
        (1, all) => format!("1 of {all} equations"),
        (failed, all) => format!("{failed} of {all} equations"),
    };
    let verb = if failures.len() == 1 { "does" } else { "do" };
    let mut text = format!("{count} of \"{}\" {verb} not follow from this declaration", block.source);
    text += &format!("\n  {:<12}{}", if failures.len() == 1 { "equation:" } else { "the first:" }, first.equation);
    for line in first.lines.iter().skip(usize::from(first.is_false)) {
        text += &format!("\n  {line}");
    }
    let subject = if block.equations.len() == 1 { "it follows" } else { "all equations follow" };
    let fields: Vec<String> = changes.iter().map(|change| format!("`{}`", change.field)).collect();
    let mut help = match &fields[..] {
        [only] => format!("{subject} with {only}"),
        several => format!("{subject} with one of these changes: {}", several.join(", or ")),
    };
    if let [Failure { remedy: Some(remedy), .. }] = failures {
        help += &format!("; if the declaration is right: {remedy}");
    }
    let phrase = if let [only] = changes { only.phrase } else { block.phrase };
    errors.push(phrase, text, help);
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
    fn new(model: &Model, solved: &Solved) -> Self {
        let rotary = first_branch(model, solved);
        let mut graph = solved.graph.clone();
        let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
        let linear = solved.position.values.iter().map(|(axis, node)| (*axis, reader.value(*node))).collect();
        let side = match &solved.orientation {
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

/// A block, with the meaning of its names on a machine.
struct Block<'a> {
    block: &'a Verify,
    scope: Scope<'a>,
}

/// What has been decided about the equations of a block.
#[derive(Default)]
struct Decided {
    /// `None` if the block cannot be evaluated.
    proven: Option<Verified>,
    /// Equations that do not hold, in source order.
    failures: Vec<Failure>,
    /// Equations and names that cannot be evaluated.
    faults: Vec<Fault>,
}

/// An equation that does not hold on the machine as declared.
struct Failure {
    phrase: Phrase,
    /// As written.
    equation: String,
    /// True if it does not follow from the chain; false if it does on another branch, or at no pose.
    is_false: bool,
    /// The message, line by line.
    lines: Vec<String>,
    /// The change of the equation that makes it true.
    remedy: Option<String>,
}

impl Failure {
    fn report(self, errors: &mut Errors) {
        let help = "no single change makes it true; compare `signs`, `d` and `axes` with the source as well";
        errors.push(self.phrase, self.lines.join("\n  "), self.remedy.unwrap_or_else(|| help.into()));
    }
}

impl<'a> Block<'a> {
    /// A block on a machine with the product `T(q)`; the ring has the symbols of the machine.
    fn new(model: &'a Model, ring: Ring, product: &Matrix, block: &'a Verify) -> Result<Self, Vec<Fault>> {
        Ok(Self { block, scope: Scope::new(model, ring, product, block)? })
    }

    /// True if all equations hold, at a common pose; and the products of monomials that were computed.
    fn follows(mut self) -> (bool, usize) {
        let mut solution = OneSolution::default();
        let mut work = 0;
        for (place, equation) in self.block.equations.iter().enumerate() {
            let verdict = decide(&mut self.scope, equation);
            work += self.scope.algebra().work();
            let Ok(Verdict::Holds(_, region)) = verdict else { return (false, work) };
            if solution.add(&self.scope, place, region).is_err() {
                return (false, work);
            }
        }
        (true, work)
    }

    /// Decides every equation.
    fn decided(mut self, derived: &Derived) -> Decided {
        let Self { block, scope } = &mut self;
        let branches = derived.branches(scope);
        let (mut failures, mut faults) = (Vec::new(), Vec::new());
        let mut proofs: Vec<Option<Proven>> = Vec::new();
        let mut solution = OneSolution::default();
        for (place, equation) in block.equations.iter().enumerate() {
            let verdict =
                decide(scope, equation).and_then(|verdict| match proves_nothing(scope, block, equation, &verdict) {
                    Some(fault) => Err(fault),
                    None => Ok(verdict),
                });
            let proof = match verdict {
                Ok(Verdict::Holds(conditions, region)) => {
                    let proof = proven(scope, equation, &conditions, &branches);
                    if let Err(other) = solution.add(scope, place, region) {
                        failures.push(contradiction(block, place, &proof, other, &proofs));
                    }
                    Some(proof)
                }
                Ok(verdict) => {
                    failures.extend(failure(scope, equation, &verdict, derived));
                    None
                }
                Err(fault) => {
                    faults.push(fault);
                    None
                }
            };
            proofs.push(proof);
        }
        faults.extend(scope.unused_names(block));
        let assumptions = assumptions(scope, block);
        let equations = proofs.into_iter().flatten().collect();
        let proven = Some(Verified { source: block.source.clone(), assumptions, equations });
        Decided { proven, failures, faults }
    }
}

/// The reason why an equation that holds says nothing about the machine.
fn proves_nothing(scope: &Scope<'_>, block: &Verify, equation: &Equation, verdict: &Verdict) -> Option<Fault> {
    let Verdict::Holds(..) = verdict else { return None };
    let help = "write the formula of the source on the right";
    if equation.left.to_string() == equation.right.to_string() {
        return Some(Fault::new(equation.phrase, "this equation proves nothing: both sides are the same", help));
    }
    // The value of a declared angle is that of the machine.
    if scope.mentions_angle_dimension(block, equation) {
        return None;
    }
    let holds = decide(&mut scope.with_free_pose(), equation);
    let text = "this equation proves nothing: it holds for any machine";
    matches!(holds, Ok(Verdict::Holds(..))).then(|| Fault::new(equation.phrase, text, help))
}

/// Values given by `where`, and set-up symbols that are zero.
fn assumptions(scope: &Scope<'_>, block: &Verify) -> Vec<String> {
    let mut assumptions: Vec<String> =
        block.assumptions.iter().map(|assumption| format!("{} = {}", assumption.key.name, assumption.value)).collect();
    let zero = scope.unmentioned(block);
    assumptions.extend(zero.iter().filter(|(name, _)| *name == "gauge").map(|_| "gauge = 0".to_string()));
    let parts: Vec<&str> = zero.iter().map(|(name, _)| *name).filter(|name| *name != "gauge").collect();
    match parts[..] {
        [_, _, _] => assumptions.push("part = 0".into()),
        _ => assumptions.extend(parts.iter().map(|name| format!("{name} = 0"))),
    }
    assumptions
}

/// Equations of a block that hold in a part of the poses only, by their place in the block. They describe one solution,
/// so these parts have a pose in common: the formulas of the two branches are never mixed.
#[derive(Default)]
struct OneSolution {
    parts: Vec<(usize, Region)>,
}

impl OneSolution {
    /// Adds an equation; an error if it contradicts those before it, with the one that it contradicts alone, if any.
    fn add(&mut self, scope: &Scope<'_>, place: usize, region: Region) -> Result<(), Option<usize>> {
        if region.is_everywhere() {
            return Ok(());
        }
        let mut regions: Vec<&Region> = self.parts.iter().map(|(_, region)| region).collect();
        regions.push(&region);
        if has_witness(scope, &regions) {
            self.parts.push((place, region));
            return Ok(());
        }
        Err(self.parts.iter().find(|(_, known)| !has_witness(scope, &[known, &region])).map(|(place, _)| *place))
    }
}

/// The message of an equation that holds at no pose at which those before it do; `other` is the one that it
/// contradicts.
fn contradiction(
    block: &Verify,
    place: usize,
    proof: &Proven,
    other: Option<usize>,
    proofs: &[Option<Proven>],
) -> Failure {
    let equation = &block.equations[place];
    let other = other.and_then(|other| proofs[other].as_ref().map(|proof| (&block.equations[other], proof)));
    let (others, where_others) = match other {
        Some((other, proof)) => (
            format!("`{} = {}`", other.left, other.right),
            format!("that one holds where {}", proof.holds.join(" and ")),
        ),
        None => ("the equations before it".into(), "they hold on one branch only".into()),
    };
    let remedy = "a block describes one solution: correct a sign, or put the formulas of the other branch into a block of their own";
    Failure {
        phrase: equation.phrase,
        equation: equation.to_string(),
        is_false: false,
        lines: vec![
            format!("this equation and {others} hold at no common pose"),
            where_others,
            format!("this one holds where {}", proof.holds.join(" and ")),
        ],
        remedy: Some(remedy.into()),
    }
}

fn proven(scope: &Scope<'_>, equation: &Equation, conditions: &[Condition], branches: &[(Sign, &str)]) -> Proven {
    let dimensions = scope.model().dimension_symbols();
    let branch = |condition: &Condition| match condition {
        Condition::Positive(sign) | Condition::NotNegative(sign) => {
            branches.iter().find(|(known, _)| known == sign).map(|(_, name)| *name)
        }
        Condition::NotZero(_) => None,
    };
    let named = |condition: &Condition, text: String| match branch(condition) {
        Some(branch) => format!("{text} ({branch})"),
        None => text,
    };
    let holds = conditions.iter().map(|condition| named(condition, condition.text(scope))).collect();
    let mut holds_in_words: Vec<String> = Vec::new();
    for condition in conditions {
        for text in condition.words(scope) {
            let text = named(condition, text);
            if !holds_in_words.contains(&text) {
                holds_in_words.push(text);
            }
        }
    }
    let divisors = conditions.iter().flat_map(|condition| match condition {
        Condition::NotZero(zeros) => zeros.clone(),
        _ => Vec::new(),
    });
    Proven {
        left: as_written(&equation.left),
        right: as_written(&equation.right),
        holds,
        holds_in_words,
        divisors: divisors.filter(|divisor| divisor.symbols().all(|symbol| dimensions.contains(&symbol))).collect(),
    }
}

/// The message of an equation that does not hold.
fn failure(scope: &Scope<'_>, equation: &Equation, verdict: &Verdict, derived: &Derived) -> Option<Failure> {
    let left = &equation.left;
    let (is_false, lines, remedy) = match verdict {
        Verdict::Holds(..) => return None,
        Verdict::Opposite => (
            false,
            vec![format!("this formula gives `{left} + 180 deg` at every pose")],
            Some("change the sign of both arguments".into()),
        ),
        Verdict::Nowhere => (
            false,
            vec![format!("this formula for `{left}` holds at no pose")],
            Some("check the signs of roots and arguments".into()),
        ),
        Verdict::False(gap) => {
            let change = repair(scope, equation);
            let (gap, missing) = difference(scope, equation, gap, derived);
            let mut lines = vec![format!("this equation for `{left}` does not follow from the chain")];
            lines.extend(derived.formula(scope, left).map(|derived| format!("derived:    {left} = {derived}")));
            lines.push(gap);
            (true, lines, change.or(missing))
        }
    };
    Some(Failure { phrase: equation.phrase, equation: equation.to_string(), is_false, lines, remedy })
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
        (format!("equal only where this is zero: {}", gap.source()), None)
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
