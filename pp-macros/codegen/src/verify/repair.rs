//! One small change that makes a false equation true: misprints of papers, and mistakes made in copying them.

use crate::model::{AxisKind, Model};
use crate::syntax::{Expr, ExprKind};

/// An expression with one change, and the change in words.
pub(crate) struct ChangedExpression {
    pub(crate) expr: Expr,
    pub(crate) words: String,
    /// Order of trying: likelier mistakes first.
    rank: u8,
}

/// All changes of an expression that are tried, the likeliest first.
pub(crate) fn changes(expr: &Expr, model: &Model) -> Vec<ChangedExpression> {
    let mut found = Vec::new();
    collect_changes(expr, true, model, &mut found, &|inner| inner);
    changes_of_names(expr, &mut found);
    found.sort_by_key(|change| change.rank);
    found
}

/// Changes of every occurrence of a name: the source counts it in the opposite direction, or measures the angle from
/// another direction.
fn changes_of_names(expr: &Expr, found: &mut Vec<ChangedExpression>) {
    for name in expr.names() {
        let is_call = |call: &Expr, function: &str| match &call.kind {
            ExprKind::Call(known, arguments) if known == function => {
                matches!(&arguments[..], [argument] if matches!(&argument.kind, ExprKind::Name(n) if n == name))
            }
            _ => false,
        };
        let other = |call: &Expr, function: &str| match &call.kind {
            ExprKind::Call(_, arguments) => {
                Some(Expr { phrase: call.phrase, kind: ExprKind::Call(function.into(), arguments.clone()) })
            }
            _ => None,
        };
        let exchanged = expr.replace(&|part| match (is_call(part, "sin"), is_call(part, "cos")) {
            (true, _) => other(part, "cos"),
            (_, true) => other(part, "sin"),
            _ => None,
        });
        let words = format!("exchange `sin({name})` and `cos({name})` wherever they occur");
        found.push(ChangedExpression { expr: exchanged, words, rank: 6 });
        let reversed = expr.replace(&|part| {
            let name = matches!(&part.kind, ExprKind::Name(known) if known == name);
            name.then(|| Expr { phrase: part.phrase, kind: ExprKind::Neg(Box::new(part.clone())) })
        });
        let words = format!(
            "it is true with `-{name}` in place of `{name}`: the source counts {name} in the opposite direction"
        );
        found.push(ChangedExpression { expr: reversed, words, rank: 6 });
    }
}

/// Collects the changes at and inside `expr`; `whole` puts a changed `expr` back into the equation.
fn collect_changes(
    expr: &Expr,
    may_be_negated: bool,
    model: &Model,
    found: &mut Vec<ChangedExpression>,
    whole: &dyn Fn(Expr) -> Expr,
) {
    changes_of_node(expr, model, found, whole);
    let is_sum = matches!(expr.kind, ExprKind::Binary(_, '+' | '-', _) | ExprKind::Neg(_));
    if may_be_negated && !is_sum {
        let negated = negated(expr);
        // Papers print the sign inside an inverse function.
        let rank = if matches!(&expr.kind, ExprKind::Call(name, _) if is_inverse(name)) { 3 } else { 2 };
        found.push(ChangedExpression {
            words: format!("write `{negated}` in place of `{expr}`"),
            expr: whole(negated),
            rank,
        });
    }
    changes_of_parts(expr, model, found, whole);
}

/// Changes of the expression itself.
fn changes_of_node(expr: &Expr, model: &Model, found: &mut Vec<ChangedExpression>, whole: &dyn Fn(Expr) -> Expr) {
    let mut change = |rank: u8, new: Expr| {
        // A sum in the place of a factor keeps its parentheses.
        let sum = |expr: &Expr| matches!(expr.kind, ExprKind::Binary(_, '+' | '-', _));
        let text = if sum(&new) && !sum(expr) { format!("({new})") } else { new.to_string() };
        let words = format!("write `{text}` in place of `{expr}`");
        found.push(ChangedExpression { expr: whole(new), words, rank });
    };
    let with = |kind: ExprKind| Expr { phrase: expr.phrase, kind };
    match &expr.kind {
        ExprKind::Name(name) => {
            for other in alternatives(name, model) {
                change(4, with(ExprKind::Name(other)));
            }
        }
        ExprKind::Neg(inner) => change(1, (**inner).clone()),
        ExprKind::Call(name, arguments) => {
            if let Some((other, rank)) = other_function(name) {
                change(rank, with(ExprKind::Call(other.into(), arguments.clone())));
            }
            if name == "atan2" && arguments.len() == 2 {
                change(3, with(ExprKind::Call(name.clone(), vec![arguments[1].clone(), arguments[0].clone()])));
            }
        }
        ExprKind::Binary(left, operator @ ('+' | '-'), right) => {
            let (other, sign) = if *operator == '+' { ('-', '-') } else { ('+', '+') };
            let term = |sign: char| format!("{sign} {right}");
            found.push(ChangedExpression {
                expr: whole(with(ExprKind::Binary(left.clone(), other, right.clone()))),
                words: format!("write `{}` in place of `{}`", term(sign), term(*operator)),
                rank: 1,
            });
            found.push(ChangedExpression {
                expr: whole((**left).clone()),
                words: format!("leave out `{}`", term(*operator)),
                rank: 5,
            });
        }
        ExprKind::Number(..) | ExprKind::Binary(..) | ExprKind::Power(..) => {}
    }
}

/// Changes of its parts.
fn changes_of_parts(expr: &Expr, model: &Model, found: &mut Vec<ChangedExpression>, whole: &dyn Fn(Expr) -> Expr) {
    let with = |kind: ExprKind| Expr { phrase: expr.phrase, kind };
    match &expr.kind {
        ExprKind::Number(..) | ExprKind::Name(_) => {}
        ExprKind::Neg(inner) => {
            collect_changes(inner, false, model, found, &|new| whole(with(ExprKind::Neg(Box::new(new)))));
        }
        ExprKind::Power(base, exponent) => {
            collect_changes(base, false, model, found, &|new| whole(with(ExprKind::Power(Box::new(new), *exponent))));
        }
        ExprKind::Binary(left, operator, right) => {
            let first_term = matches!(operator, '+' | '-');
            collect_changes(left, first_term, model, found, &|new| {
                whole(with(ExprKind::Binary(Box::new(new), *operator, right.clone())))
            });
            collect_changes(right, false, model, found, &|new| {
                whole(with(ExprKind::Binary(left.clone(), *operator, Box::new(new))))
            });
        }
        ExprKind::Call(name, arguments) => {
            for (place, argument) in arguments.iter().enumerate() {
                let signed = !matches!(name.as_str(), "sin" | "cos");
                collect_changes(argument, signed, model, found, &|new| {
                    let mut arguments = arguments.clone();
                    arguments[place] = new;
                    whole(with(ExprKind::Call(name.clone(), arguments)))
                });
            }
        }
    }
}

/// `-e`, with the sign at the first factor.
pub(crate) fn negated(expr: &Expr) -> Expr {
    let kind = match &expr.kind {
        ExprKind::Binary(left, operator @ ('*' | '/'), right) => {
            ExprKind::Binary(Box::new(negated(left)), *operator, right.clone())
        }
        ExprKind::Neg(inner) => inner.kind.clone(),
        _ => ExprKind::Neg(Box::new(expr.clone())),
    };
    Expr { phrase: expr.phrase, kind }
}

/// Names that are often confused with `name`.
fn alternatives(name: &str, model: &Model) -> Vec<String> {
    let groups: [&[&str]; 2] = [&["x", "y", "z"], &["i", "j", "k"]];
    let mut others: Vec<String> = groups
        .iter()
        .filter(|group| group.contains(&name))
        .flat_map(|group| group.iter().map(ToString::to_string))
        .collect();
    let kind = |letter: &str| model.axes.iter().find(|axis| axis.letter.to_string() == letter).map(|axis| axis.kind);
    if kind(name) == Some(AxisKind::Rotary) {
        let rotaries = model.axes.iter().filter(|axis| axis.kind == AxisKind::Rotary);
        others.extend(rotaries.map(|axis| axis.letter.to_string()));
    }
    others.retain(|other| other != name);
    others
}

fn is_inverse(function: &str) -> bool {
    matches!(function, "atan2" | "asin" | "acos")
}

fn other_function(name: &str) -> Option<(&'static str, u8)> {
    match name {
        "sin" => Some(("cos", 0)),
        "cos" => Some(("sin", 0)),
        "asin" => Some(("acos", 3)),
        "acos" => Some(("asin", 3)),
        _ => None,
    }
}
