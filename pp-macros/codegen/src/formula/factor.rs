//! Polynomials factored as people write them.
//!
//! Common factors come out first. Then Horner's scheme: the sine or cosine in most terms is factored out of them, and
//! the same is done with the bracket and with the remaining terms. With several candidates each is tried, and the
//! shortest formula is kept. Where every term with `cos B` has a counterpart without it, equal up to the sign,
//! `1 - cos B` and `1 + cos B` are factored out instead. `sin² + cos² = 1` and `i² + j² + k² = 1` are used wherever
//! they make a sum shorter.
//!
//! No other factors are searched for; the formula is equal to the polynomial by construction.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::expression::Formula;
use super::names::SymbolNames;
use crate::model::Model;
use crate::symbolic::{Poly, Ring, Surd, Symbol};

/// Sums longer than this are factored by the first candidate only.
const LONG: usize = 14;

/// Numbers with more binary digits than this in numerator or denominator are not factored out of a sum.
const DIGITS: u64 = 20;

type FactoredMonomial = Vec<(Symbol, u32)>;
type FactoredTerms = BTreeMap<FactoredMonomial, Surd>;
/// A term of a sum, and its place there.
type TermOfSum = (Vec<usize>, Formula);

pub(crate) fn of_poly(model: &Model, ring: &Ring, poly: &Poly) -> Formula {
    let terms: FactoredTerms = poly.terms().map(|(powers, factor)| (powers.to_vec(), factor.clone())).collect();
    let names = SymbolNames::new(model, ring);
    let circles = names.circles();
    let writer = Writer { names, circles };
    writer.formula(terms)
}

struct Writer<'a> {
    names: SymbolNames<'a>,
    circles: Vec<Vec<Symbol>>,
}

impl Writer<'_> {
    /// A formula on its own: its sign is factored out only if every term has it.
    fn formula(&self, terms: FactoredTerms) -> Formula {
        let terms = self.shortest(terms);
        let (number, powers, rest) = self.content(&terms);
        if powers.is_empty() && number.is_one() && rest.len() > 1 {
            return joined(self.parts(&rest, &rest));
        }
        self.product(number, &powers, rest, None)
    }

    /// `number · powers · rest · also`.
    fn product(&self, number: Surd, powers: &FactoredMonomial, rest: FactoredTerms, also: Option<Formula>) -> Formula {
        let mut number = number;
        let mut names = Vec::new();
        let mut sin_cos = Vec::new();
        let mut powers = powers.clone();
        powers.sort_by_key(|(symbol, _)| self.names.place(*symbol));
        for (symbol, power) in powers {
            let base = self.names.formula(symbol);
            let factor = if power == 1 { base } else { Formula::Power(Box::new(base), power) };
            if self.names.is_sin_or_cos(symbol) { sin_cos.push(factor) } else { names.push(factor) }
        }
        // Sines before cosines: `sin B cos C`.
        sin_cos.sort_by_key(|factor| !is_sine(factor));
        let mut factors = names;
        if rest.len() > 1 {
            match self.formula(rest) {
                Formula::Product(inner) => factors.extend(inner),
                Formula::Neg(inner) => {
                    number = -&number;
                    match *inner {
                        Formula::Product(inner) => factors.extend(inner),
                        other => factors.push(other),
                    }
                }
                other => factors.push(other),
            }
        } else if let Some((_, factor)) = rest.into_iter().next() {
            number = &number * &factor;
        } else {
            return Formula::integer(0);
        }
        factors.extend(also);
        factors.extend(sin_cos);
        assemble(&number, factors)
    }

    /// Common number, common powers, and the remaining terms.
    fn content(&self, terms: &FactoredTerms) -> (Surd, FactoredMonomial, FactoredTerms) {
        let mut common: Option<BTreeMap<Symbol, u32>> = None;
        for monomial in terms.keys() {
            let powers: BTreeMap<Symbol, u32> = monomial.iter().copied().collect();
            common = Some(match common {
                None => powers,
                Some(known) => known
                    .into_iter()
                    .filter_map(|(symbol, power)| powers.get(&symbol).map(|other| (symbol, power.min(*other))))
                    .collect(),
            });
        }
        let common: FactoredMonomial = common.unwrap_or_default().into_iter().collect();
        let number = common_number(&terms.values().collect::<Vec<_>>());
        let Some(inverse) = number.inverse() else { return (Surd::one(), FactoredMonomial::new(), terms.clone()) };
        let rest: FactoredTerms =
            terms.iter().map(|(monomial, factor)| (divided(monomial, &common), factor * &inverse)).collect();
        let alone = common.is_empty() && number.is_one();
        let negate =
            if alone { rest.values().all(is_negative) } else { rest.len() == 1 || self.leads_with_minus(&rest) };
        if negate && self.leads_with_minus(&rest) { (-&number, common, minus(rest)) } else { (number, common, rest) }
    }

    fn leads_with_minus(&self, terms: &FactoredTerms) -> bool {
        let first = terms.iter().min_by_key(|(monomial, _)| self.key(monomial, terms));
        first.is_some_and(|(_, factor)| is_negative(factor))
    }

    /// Horner's scheme: the parts of a sum, each with its place in the sum `whole`.
    fn parts(&self, terms: &FactoredTerms, whole: &FactoredTerms) -> Vec<TermOfSum> {
        let options = self.options(terms);
        let tried = if terms.len() > LONG { 1 } else { options.len() };
        let written = options.into_iter().take(tried).map(|option| self.with(terms, option, whole));
        // The first of the shortest.
        written.min_by_key(|parts| parts.iter().map(|(_, part)| part.size()).sum::<usize>()).unwrap_or_else(|| {
            let part = |(monomial, factor): (&FactoredMonomial, &Surd)| {
                (self.key(monomial, whole), self.product(factor.clone(), monomial, unit(), None))
            };
            terms.iter().map(part).collect()
        })
    }

    fn with(&self, terms: &FactoredTerms, option: HornerStep, whole: &FactoredTerms) -> Vec<TermOfSum> {
        let first =
            |part: &FactoredTerms| part.keys().map(|monomial| self.key(monomial, whole)).min().unwrap_or_default();
        let has = |monomial: &FactoredMonomial, symbol: Symbol| monomial.iter().any(|(other, _)| *other == symbol);
        let mut rest = FactoredTerms::new();
        let mut parts = Vec::new();
        match option {
            HornerStep::Factor(symbol) => {
                let power = vec![(symbol, 1)];
                let (mut inside, mut factored) = (FactoredTerms::new(), FactoredTerms::new());
                for (monomial, factor) in terms {
                    if has(monomial, symbol) {
                        inside.insert(divided(monomial, &power), factor.clone());
                        factored.insert(monomial.clone(), factor.clone());
                    } else {
                        rest.insert(monomial.clone(), factor.clone());
                    }
                }
                parts.push((first(&factored), self.factored_out(inside, &power, None)));
            }
            HornerStep::OneAnd(symbol) => {
                let (mut plus, mut minus) = (FactoredTerms::new(), FactoredTerms::new());
                for (monomial, factor) in terms.iter().filter(|(monomial, _)| !has(monomial, symbol)) {
                    let mut with = monomial.clone();
                    with.push((symbol, 1));
                    with.sort_unstable();
                    let part = match terms.get(&with) {
                        Some(other) if other == factor => &mut plus,
                        Some(_) => &mut minus,
                        None => &mut rest,
                    };
                    part.insert(monomial.clone(), factor.clone());
                }
                let cosine = self.names.formula(symbol);
                for (part, cosine) in [(plus, cosine.clone()), (minus, cosine.negated())] {
                    if !part.is_empty() {
                        let bracket = Formula::Sum(vec![Formula::integer(1), cosine]);
                        parts.push((first(&part), self.factored_out(part, &FactoredMonomial::new(), Some(bracket))));
                    }
                }
            }
        }
        if rest.is_empty() {
            return parts;
        }
        let rest = self.shortest(rest);
        let (number, powers, inner) = self.content(&rest);
        if inner.len() > 1 && powers.is_empty() && (number.is_one() || (-&number).is_one()) {
            parts.extend(self.parts(&rest, whole));
        } else {
            parts.push((first(&rest), self.product(number, &powers, inner, None)));
        }
        parts
    }

    /// `inside · powers · also`, the sign of the leading term first.
    fn factored_out(&self, inside: FactoredTerms, powers: &FactoredMonomial, also: Option<Formula>) -> Formula {
        let inside = self.shortest(inside);
        let (mut number, common, mut inside) = self.content(&inside);
        if inside.len() > 1 && self.leads_with_minus(&inside) {
            number = -&number;
            inside = minus(inside);
        }
        let mut all: BTreeMap<Symbol, u32> = common.into_iter().collect();
        for (symbol, power) in powers {
            *all.entry(*symbol).or_default() += power;
        }
        self.product(number, &all.into_iter().collect(), inside, also)
    }

    /// Factors that can be taken out of a part of the sum, best first.
    fn options(&self, terms: &FactoredTerms) -> Vec<HornerStep> {
        let mut counts: BTreeMap<Symbol, usize> = BTreeMap::new();
        for (symbol, _) in terms.keys().flatten().filter(|(symbol, _)| self.names.is_factor(*symbol)) {
            *counts.entry(*symbol).or_default() += 1;
        }
        let most = counts.values().copied().max().unwrap_or_default();
        let mut steps: Vec<HornerStep> = Vec::new();
        let mut symbols: Vec<Symbol> = counts.keys().copied().collect();
        symbols.sort_by_key(|symbol| (self.names.place(*symbol), std::cmp::Reverse(*symbol)));
        for symbol in &symbols {
            if self.names.is_sin_or_cos(*symbol) && !is_sine(&self.names.formula(*symbol)) && pairs(terms, *symbol) {
                steps.push(HornerStep::OneAnd(*symbol));
            }
        }
        let frequent = symbols.iter().filter(|symbol| most > 1 && counts[symbol] == most);
        steps.extend(frequent.map(|symbol| HornerStep::Factor(*symbol)));
        steps
    }

    /// The form with the fewest terms modulo the circles.
    fn shortest(&self, terms: FactoredTerms) -> FactoredTerms {
        let mut best = terms;
        for circle in &self.circles {
            let squared = |terms: &FactoredTerms| {
                terms.keys().flatten().any(|(symbol, power)| *power > 1 && circle.contains(symbol))
            };
            for symbol in circle {
                if !squared(&best) {
                    break;
                }
                let others: Vec<Symbol> = circle.iter().copied().filter(|other| other != symbol).collect();
                let other = without_square(&best, *symbol, &others);
                if other.len() < best.len() {
                    best = other;
                }
            }
        }
        best
    }

    /// Sort key of a term in a sum, by its names. A number comes after lengths and before sines and cosines; together
    /// with `i j k` a sum begins with a positive term: `1 - k`, but `2 k - 1`.
    fn key(&self, monomial: &FactoredMonomial, among: &FactoredTerms) -> Vec<usize> {
        let mut key: Vec<usize> = monomial.iter().map(|(symbol, _)| self.names.place(*symbol)).collect();
        key.sort_unstable();
        if monomial.iter().all(|(symbol, _)| self.names.is_sin_or_cos(*symbol)) {
            let mut symbols = among.keys().flatten().map(|(symbol, _)| *symbol);
            let length = symbols.clone().any(|symbol| !self.names.is_factor(symbol));
            let sin_cos = symbols.all(|symbol| self.names.is_sin_or_cos(symbol));
            let like =
                |factor: &Surd| among.len() == 2 && among.values().all(|other| other == factor || *other == -factor);
            let first = |factor: &Surd| !is_negative(factor) || like(factor);
            if length || !(sin_cos || among.get(monomial).is_some_and(first)) {
                key.insert(0, usize::MAX);
            }
        }
        key
    }
}

/// One step of Horner's scheme.
#[derive(Debug, Clone, Copy)]
enum HornerStep {
    /// This symbol is factored out of all terms that have it.
    Factor(Symbol),
    /// One plus and one minus this cosine are factored out.
    OneAnd(Symbol),
}

/// True if every term with the symbol has a counterpart without it, equal up to the sign.
fn pairs(terms: &FactoredTerms, symbol: Symbol) -> bool {
    let mut found = false;
    for (monomial, factor) in terms {
        let Some((_, power)) = monomial.iter().find(|(other, _)| *other == symbol) else { continue };
        if *power > 1 {
            return false;
        }
        let like = terms.get(&divided(monomial, &vec![(symbol, 1)]));
        if !like.is_some_and(|like| like == factor || *like == -factor) {
            return false;
        }
        found = true;
    }
    // Two terms stay as they are.
    found && terms.len() > 2
}

/// `symbol² → 1 - Σ others²`, until no power above 1 is left.
fn without_square(terms: &FactoredTerms, symbol: Symbol, others: &[Symbol]) -> FactoredTerms {
    let mut sum = FactoredTerms::new();
    let mut pending: Vec<(FactoredMonomial, Surd)> = terms.iter().map(|(m, c)| (m.clone(), c.clone())).collect();
    while let Some((monomial, factor)) = pending.pop() {
        let squared = monomial.iter().any(|(other, power)| *other == symbol && *power > 1);
        if !squared {
            let entry = sum.entry(monomial).or_insert_with(Surd::zero);
            *entry = &*entry + &factor;
            continue;
        }
        let rest = divided(&monomial, &vec![(symbol, 2)]);
        for other in others {
            let mut powers: BTreeMap<Symbol, u32> = rest.iter().copied().collect();
            *powers.entry(*other).or_default() += 2;
            pending.push((powers.into_iter().collect(), -&factor));
        }
        pending.push((rest, factor));
    }
    sum.retain(|_, factor| !factor.is_zero());
    sum
}

fn divided(monomial: &FactoredMonomial, by: &FactoredMonomial) -> FactoredMonomial {
    let less = |symbol: Symbol| by.iter().find(|(other, _)| *other == symbol).map_or(0, |(_, power)| *power);
    let powers = monomial.iter().map(|(symbol, power)| (*symbol, power - less(*symbol)));
    powers.filter(|(_, power)| *power > 0).collect()
}

fn minus(terms: FactoredTerms) -> FactoredTerms {
    terms.into_iter().map(|(monomial, factor)| (monomial, -&factor)).collect()
}

fn unit() -> FactoredTerms {
    FactoredTerms::from([(FactoredMonomial::new(), Surd::one())])
}

fn is_plain(formula: &Formula) -> bool {
    match formula {
        Formula::Name(_) | Formula::Root(_) => true,
        Formula::Neg(inner) => is_plain(inner),
        _ => false,
    }
}

fn is_sine(formula: &Formula) -> bool {
    match formula {
        Formula::Power(base, _) => is_sine(base),
        Formula::Call(function, _) => function == "sin",
        _ => false,
    }
}

fn is_negative(number: &Surd) -> bool {
    number.to_f64() < 0.0
}

/// Positive number common to all factors: the common root, the common divisor of the numerators, the common multiple of
/// the denominators.
pub(crate) fn common_number(factors: &[&Surd]) -> Surd {
    let Some((&first, others)) = factors.split_first() else { return Surd::one() };
    if others.iter().all(|factor| *factor == first || **factor == -first) {
        return if is_negative(first) { -first } else { first.clone() };
    }
    let mut radicand = None;
    let (mut above, mut below) = (BigInt::zero(), BigInt::one());
    for factor in factors {
        let mut parts = factor.terms();
        let (Some((root, rational)), None) = (parts.next(), parts.next()) else { return Surd::one() };
        if *radicand.get_or_insert_with(|| root.clone()) != root {
            return Surd::one();
        }
        above = above.gcd(rational.numer());
        below = below.lcm(rational.denom());
    }
    let plain = |(_, rational): (_, BigRational)| rational.abs().is_one();
    // x + 3/2 is not (2 x + 3)/2.
    let spoiled = !below.is_one() && factors.iter().flat_map(|factor| factor.terms()).any(plain);
    if spoiled || above.bits().max(below.bits()) > DIGITS {
        return Surd::one();
    }
    let rational = BigRational::new(above.abs(), below);
    let root = radicand.map(|root| BigRational::from(BigInt::from(root)));
    let root = root.and_then(|root| Surd::sqrt_of_rational(&root)).unwrap_or_else(Surd::one);
    &Surd::from(rational) * &root
}

/// Terms in their order.
fn joined(mut parts: Vec<TermOfSum>) -> Formula {
    parts.sort_by(|(a, _), (b, _)| a.cmp(b));
    let mut terms: Vec<Formula> = Vec::new();
    for (_, part) in parts {
        match part {
            Formula::Sum(inner) => terms.extend(inner),
            other => terms.push(other),
        }
    }
    // `d - part_z`: a sum of plain names begins with a positive term.
    if terms.iter().all(is_plain)
        && let Some(index) = terms.iter().position(|term| !matches!(term, Formula::Neg(_)))
    {
        let first = terms.remove(index);
        terms.insert(0, first);
    }
    if terms.len() == 1 { terms.remove(0) } else { Formula::Sum(terms) }
}

/// `number · factors`, the sign first; `(1/2) (a + b)` is written `(a + b)/2`.
fn assemble(number: &Surd, mut factors: Vec<Formula>) -> Formula {
    let negative = is_negative(number);
    let number = if negative { -number } else { number.clone() };
    let divisor = number.as_rational().filter(|q| q.numer().is_one() && !q.denom().is_one());
    let formula = match (factors.len(), divisor) {
        (0, _) => Formula::Number(number),
        (1, Some(divisor)) if matches!(factors[0], Formula::Sum(_) | Formula::Name(_) | Formula::Root(_)) => {
            let below = BigRational::from(divisor.denom().clone());
            Formula::Quotient(Box::new(factors.remove(0)), Box::new(Formula::Number(Surd::from(below))))
        }
        (1, _) if number.is_one() => factors.remove(0),
        _ if number.is_one() => Formula::Product(factors),
        _ => {
            factors.insert(0, Formula::Number(number));
            Formula::Product(factors)
        }
    };
    if negative { formula.negated() } else { formula }
}
