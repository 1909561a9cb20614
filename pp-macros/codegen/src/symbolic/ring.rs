//! Symbols with their relations, and arithmetic modulo these.
//!
//! Squares rewrite (rules `circle`, `unit-vector`, `root`), each to a polynomial of lower degree in the leading symbol;
//! the leading symbols are distinct, hence coprime: normal forms are unique. Remainder 0 proves that a polynomial
//! vanishes, and nothing is sampled; [`symbolic`](super) explains what another remainder means. Reciprocals are
//! multiplied out first (rule `clear`).

use std::cell::Cell;
use std::collections::BTreeMap;

use num_rational::BigRational;

use super::poly::{Monomial, Poly, Symbol};
use super::surd::Surd;

/// Facts about a symbol.
#[derive(Debug, Clone)]
struct SymbolFacts {
    name: String,
    /// Set for constants (the sine of a fixed angle, the root of a number).
    value: Option<f64>,
    /// `symbol² = square`.
    square: Option<Poly>,
    /// `symbol · divisor = 1`.
    divisor: Option<Poly>,
    /// Set for the sine of a fixed angle, whose cosine is the next symbol: its degrees.
    angle: Option<BigRational>,
    /// Set for a root: it is never negative.
    root: bool,
}

/// Symbols and relations.
#[derive(Debug, Clone, Default)]
pub struct Ring {
    known: Vec<SymbolFacts>,
    /// Monomials that have been reduced.
    steps: Cell<usize>,
    /// Largest number of them; what comes after it is left undone.
    most: Option<usize>,
}

impl Ring {
    /// A free symbol. Names are unique: one that is in use gets an underscore.
    pub fn symbol(&mut self, name: impl Into<String>) -> Symbol {
        let name = self.free_name(name.into());
        self.push(name, None, None, None)
    }

    /// A pair (sine, cosine) of an unknown angle: rule `circle`.
    pub fn sin_cos(&mut self, sine: impl Into<String>, cosine: impl Into<String>) -> (Symbol, Symbol) {
        let (sine, cosine) = (self.free_name(sine.into()), self.free_name(cosine.into()));
        self.circle(sine, cosine, None)
    }

    /// A pair (sine, cosine) of a fixed angle that has no exact value here. The same angle gives the same pair.
    pub fn fixed_sin_cos(&mut self, degrees: &BigRational) -> (Symbol, Symbol) {
        if let Some(index) = self.known.iter().position(|known| known.angle.as_ref() == Some(degrees)) {
            return (symbol_at(index), symbol_at(index + 1));
        }
        let value = Surd::from(degrees.clone()).to_f64();
        let (sine, cosine) = (self.free_name(format!("sin {value}°")), self.free_name(format!("cos {value}°")));
        let pair = self.circle(sine, cosine, Some(value.to_radians().sin_cos()));
        self.known[pair.0.0 as usize].angle = Some(degrees.clone());
        pair
    }

    /// A unit vector `(i, j, k)`: rule `unit-vector`.
    pub fn unit_vector(&mut self, names: [&str; 3]) -> [Symbol; 3] {
        let [i, j] = [self.symbol(names[0]), self.symbol(names[1])];
        let rest = &(&Poly::one() - &self.square_of(i)) - &self.square_of(j);
        [i, j, self.push(names[2].into(), None, Some(rest), None)]
    }

    /// A root, whose square is `radicand`: rule `root`.
    ///
    /// Rule `one-root`: a constant has one root, so asking again gives the same symbol.
    pub fn root(&mut self, name: impl Into<String>, radicand: Poly) -> Symbol {
        let value = self.value(&radicand).map(f64::sqrt);
        let same = |known: &SymbolFacts| known.value.is_some() && known.square.as_ref() == Some(&radicand);
        if let (Some(_), Some(index)) = (value, self.known.iter().position(same)) {
            return symbol_at(index);
        }
        let root = self.push(name.into(), value, Some(radicand), None);
        self.known[root.0 as usize].root = true;
        root
    }

    /// True if a symbol is a root.
    #[must_use]
    pub fn is_root(&self, symbol: Symbol) -> bool {
        self.known[symbol.0 as usize].root
    }

    /// A reciprocal: times `divisor` it is 1.
    pub fn reciprocal(&mut self, name: impl Into<String>, divisor: Poly) -> Symbol {
        let value = self.value(&divisor).map(f64::recip);
        self.push(name.into(), value, None, Some(divisor))
    }

    /// The name given to a symbol.
    #[must_use]
    pub fn name(&self, symbol: Symbol) -> &str {
        &self.known[symbol.0 as usize].name
    }

    /// True if a reciprocal occurs.
    #[must_use]
    pub fn has_reciprocal(&self, poly: &Poly) -> bool {
        poly.symbols().any(|symbol| self.known[symbol.0 as usize].divisor.is_some())
    }

    /// All symbols.
    pub fn symbols(&self) -> impl Iterator<Item = Symbol> + use<> {
        (0..self.known.len()).map(symbol_at)
    }

    /// The polynomial that a symbol's square is rewritten to.
    #[must_use]
    pub fn square(&self, symbol: Symbol) -> Option<&Poly> {
        self.known[symbol.0 as usize].square.as_ref()
    }

    /// The divisor of a reciprocal.
    #[must_use]
    pub fn divisor(&self, symbol: Symbol) -> Option<&Poly> {
        self.known[symbol.0 as usize].divisor.as_ref()
    }

    /// Float value of a polynomial in constants; `None` if anything else occurs.
    #[must_use]
    pub fn value(&self, poly: &Poly) -> Option<f64> {
        self.evaluate(poly, &|symbol| self.known[symbol.0 as usize].value)
    }

    /// Float value with the given values for the symbols that are not constants.
    pub fn evaluate(&self, poly: &Poly, of: &dyn Fn(Symbol) -> Option<f64>) -> Option<f64> {
        if let Some(number) = poly.as_number() {
            return Some(number.to_f64());
        }
        let mut sum = 0.0;
        for (monomial, factor) in &poly.terms {
            let mut product = factor.to_f64();
            for (symbol, power) in monomial {
                let value = self.known[symbol.0 as usize].value.or_else(|| of(*symbol))?;
                product *= value.powi((*power).cast_signed());
            }
            sum += product;
        }
        Some(sum)
    }

    /// Sum of the absolute values of all terms: the scale of rounding errors.
    pub fn magnitude(&self, poly: &Poly, of: &dyn Fn(Symbol) -> Option<f64>) -> Option<f64> {
        let term = |(monomial, factor): (&Monomial, &Surd)| {
            let mut single = Poly::zero();
            single.add_term(monomial.clone(), factor.clone());
            self.evaluate(&single, of).map(f64::abs)
        };
        poly.terms.iter().map(term).sum()
    }

    /// Text of a polynomial; factors rounded to nine decimals.
    #[must_use]
    pub fn text(&self, poly: &Poly) -> String {
        let mut text = String::new();
        for (monomial, factor) in &poly.terms {
            let factor = factor.to_f64();
            let powers: Vec<String> = monomial
                .iter()
                .map(|(symbol, power)| match power {
                    1 => self.name(*symbol).to_string(),
                    power => format!("{}^{power}", self.name(*symbol)),
                })
                .collect();
            let size = (factor.abs() * 1e9).round() / 1e9;
            let number =
                if size.to_bits() == 1.0_f64.to_bits() && !powers.is_empty() { None } else { Some(size.to_string()) };
            let term = number.into_iter().chain(powers).collect::<Vec<_>>().join(" ");
            text += match (text.is_empty(), factor < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            text += &term;
        }
        if text.is_empty() { "0".into() } else { text }
    }

    /// Limits the monomials that are reduced from now on.
    pub fn limit(&mut self, most: usize) {
        self.steps.set(0);
        self.most = Some(most);
    }

    /// Whether the limit has been reached: no result since then is one.
    #[must_use]
    pub fn is_exhausted(&self) -> bool {
        self.most.is_some_and(|most| self.steps.get() > most)
    }

    /// Ends the limit; whether it had been reached.
    pub fn end_limit(&mut self) -> bool {
        let exhausted = self.is_exhausted();
        self.most = None;
        exhausted
    }

    /// Product in normal form.
    #[must_use]
    pub fn mul(&self, a: &Poly, b: &Poly) -> Poly {
        let mut product = Poly::zero();
        for (m, p) in &a.terms {
            for (n, q) in &b.terms {
                self.add_reduced(&mut product, merge(m, n), &(p * q));
            }
        }
        product
    }

    /// Sum of products, the row times column of a matrix product.
    #[must_use]
    pub fn dot(&self, a: &[Poly], b: &[Poly]) -> Poly {
        a.iter().zip(b).fold(Poly::zero(), |sum, (x, y)| &sum + &self.mul(x, y))
    }

    /// Replaces symbols by polynomials, in normal form.
    #[must_use]
    pub fn substitute(&self, poly: &Poly, by: &BTreeMap<Symbol, Poly>) -> Poly {
        let mut sum = Poly::zero();
        for (monomial, factor) in &poly.terms {
            let mut kept = Monomial::new();
            let mut product = Poly::from(factor.clone());
            for &(symbol, power) in monomial {
                match by.get(&symbol) {
                    None => kept.push((symbol, power)),
                    Some(replacement) => {
                        for _ in 0..power {
                            product = self.mul(&product, replacement);
                        }
                    }
                }
            }
            let mut rest = Poly::zero();
            rest.add_term(kept, Surd::one());
            sum = &sum + &self.mul(&product, &rest);
        }
        sum
    }

    /// True only if a polynomial vanishes wherever the relations hold and no divisor is zero: proven, or false.
    ///
    /// Rule `clear`: with `v·d = 1`, `Σ p_m v^m = 0` exactly if `Σ p_m d^(n-m) = 0`. Later reciprocals may have earlier
    /// ones in their divisors, so they are cleared last to first.
    #[must_use]
    pub fn is_zero(&self, poly: &Poly) -> bool {
        self.clear(poly, |degree| degree).is_zero() && !self.is_exhausted()
    }

    /// A polynomial of the same sign without reciprocals, wherever no divisor is zero.
    ///
    /// Rule `clear-even`: as `clear`, with an even power of the divisor.
    #[must_use]
    pub fn clear_even(&self, poly: &Poly) -> Poly {
        self.clear(poly, |degree| degree.next_multiple_of(2))
    }

    /// `poly` times `d^power(degree)` for each reciprocal in it.
    fn clear(&self, poly: &Poly, power: impl Fn(u32) -> u32) -> Poly {
        let mut rest = poly.clone();
        for (index, known) in self.known.iter().enumerate().rev() {
            let Some(divisor) = &known.divisor else { continue };
            let symbol = symbol_at(index);
            let degree = rest.degree(symbol);
            if degree == 0 {
                continue;
            }
            // Horner's scheme in the divisor: p_0 d^n + p_1 d^(n-1) + ... + p_n.
            let mut cleared = Poly::zero();
            for power in 0..=degree {
                cleared = &self.mul(&cleared, divisor) + &rest.coefficient(symbol, power);
            }
            for _ in degree..power(degree) {
                cleared = self.mul(&cleared, divisor);
            }
            rest = cleared;
        }
        rest
    }

    fn free_name(&self, mut name: String) -> String {
        while self.known.iter().any(|known| known.name == name) {
            name.push('_');
        }
        name
    }

    fn push(&mut self, name: String, value: Option<f64>, square: Option<Poly>, divisor: Option<Poly>) -> Symbol {
        let symbol = symbol_at(self.known.len());
        self.known.push(SymbolFacts { name, value, square, divisor, angle: None, root: false });
        symbol
    }

    fn circle(&mut self, sine: String, cosine: String, value: Option<(f64, f64)>) -> (Symbol, Symbol) {
        let s = self.push(sine, value.map(|v| v.0), None, None);
        let rest = &Poly::one() - &self.square_of(s);
        (s, self.push(cosine, value.map(|v| v.1), Some(rest), None))
    }

    /// The square of a symbol in normal form: of a root its radicand.
    #[must_use]
    pub fn square_of(&self, symbol: Symbol) -> Poly {
        self.mul(&Poly::from(symbol), &Poly::from(symbol))
    }

    /// Rules `circle`, `unit-vector` and `root`, applied until no leading symbol has a power above 1.
    fn add_reduced(&self, sum: &mut Poly, monomial: Monomial, factor: &Surd) {
        self.steps.set(self.steps.get() + 1);
        if self.is_exhausted() {
            return;
        }
        let square_of = |symbol: Symbol| self.known[symbol.0 as usize].square.as_ref();
        let mut leading = monomial.iter().enumerate().filter(|(_, (_, power))| *power >= 2);
        let Some((position, square)) = leading.find_map(|(position, (s, _))| Some((position, square_of(*s)?))) else {
            sum.add_term(monomial, factor.clone());
            return;
        };
        let mut rest = monomial;
        rest[position].1 -= 2;
        if rest[position].1 == 0 {
            rest.remove(position);
        }
        for (m, c) in &square.terms {
            self.add_reduced(sum, merge(&rest, m), &(c * factor));
        }
    }
}

#[expect(clippy::expect_used, reason = "memory ends before 2^32 symbols")]
fn symbol_at(index: usize) -> Symbol {
    Symbol(u32::try_from(index).expect("fewer than 2^32 symbols"))
}

fn merge(a: &Monomial, b: &Monomial) -> Monomial {
    let mut product = Monomial::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        match a[i].0.cmp(&b[j].0) {
            std::cmp::Ordering::Less => {
                product.push(a[i]);
                i += 1;
            }
            std::cmp::Ordering::Greater => {
                product.push(b[j]);
                j += 1;
            }
            std::cmp::Ordering::Equal => {
                product.push((a[i].0, a[i].1 + b[j].1));
                i += 1;
                j += 1;
            }
        }
    }
    product.extend_from_slice(&a[i..]);
    product.extend_from_slice(&b[j..]);
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_squared_plus_cosine_squared_is_one() {
        let mut ring = Ring::default();
        let (s, c) = ring.sin_cos("s", "c");
        let (s, c) = (Poly::from(s), Poly::from(c));
        let sum = &ring.mul(&s, &s) + &ring.mul(&c, &c);
        assert!(sum.is_one());
        assert!(!ring.is_zero(&(&ring.mul(&s, &s) - &ring.mul(&c, &c))));
    }

    #[test]
    fn unit_vector_has_length_one_and_free_components() {
        let mut ring = Ring::default();
        let axis = ring.unit_vector(["i", "j", "k"]).map(Poly::from);
        assert!(ring.dot(&axis, &axis).is_one());
        assert!(!ring.is_zero(&(&axis[2] - &Poly::one())));
    }

    #[test]
    fn reciprocal_is_cleared_and_not_invented() {
        let mut ring = Ring::default();
        let d = &Poly::from(ring.symbol("d")) + &Poly::one();
        let v = Poly::from(ring.reciprocal("v", d.clone()));
        let inverse_of_v = ring.mul(&v, &d);
        assert!(ring.is_zero(&(&inverse_of_v - &Poly::one())));
        assert!(!ring.is_zero(&(&v - &Poly::one())));
        // A reciprocal of something that contains a reciprocal.
        let w = Poly::from(ring.reciprocal("w", &v + &Poly::one()));
        let claim = &ring.mul(&w, &(&v + &Poly::one())) - &Poly::one();
        assert!(ring.is_zero(&claim));
    }

    #[test]
    fn root_squared_is_its_radicand() {
        let mut ring = Ring::default();
        let x = Poly::from(ring.symbol("x"));
        let r = Poly::from(ring.root("r", x.clone()));
        assert_eq!(ring.mul(&r, &r), x);
        let two = ring.root("√(1+√2)", &Poly::one() + &Poly::from(Surd::from(2).sqrt().unwrap()));
        assert!((ring.value(&Poly::from(two)).unwrap() - (1.0 + 2.0_f64.sqrt()).sqrt()).abs() < 1e-15);
    }
}
