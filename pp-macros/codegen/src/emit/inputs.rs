//! Inputs of a generated function, as `let` statements.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::model::{AxisKind, Dimension, Model, Quantity};
use crate::symbolic::Symbol;

/// Variables that hold the inputs of a function.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct InputVariables<'a> {
    /// Variable with `.x .y .z` for the tip.
    pub(crate) tip: Option<&'a str>,
    /// Variable with `.x .y .z` for the tool axis.
    pub(crate) axis: Option<&'a str>,
    /// Array in chain order with the values of axes.
    pub(crate) words: Option<&'a str>,
    /// Array of (sine, cosine) of all rotary axes; otherwise they are computed from `words`.
    pub(crate) turns: Option<&'a str>,
}

/// `let` statements for the inputs that are used.
pub(crate) fn prelude(model: &Model, used: &BTreeSet<Symbol>, variables: InputVariables<'_>) -> TokenStream {
    let inputs = Inputs { model, used, variables };
    let (pose, set_up, dimensions, axes) = (inputs.pose(), inputs.set_up(), inputs.dimensions(), inputs.axes());
    quote!(#pose #set_up #dimensions #axes)
}

/// Inputs of one function.
struct Inputs<'a> {
    model: &'a Model,
    used: &'a BTreeSet<Symbol>,
    variables: InputVariables<'a>,
}

impl Inputs<'_> {
    /// Tip and tool axis.
    fn pose(&self) -> TokenStream {
        let symbols = &self.model.symbols;
        let vectors = [(symbols.tip, self.variables.tip), (symbols.axis, self.variables.axis)];
        let vectors = vectors.into_iter().filter_map(|(symbols, place)| Some((symbols, format_ident!("{}", place?))));
        vectors.map(|(symbols, place)| self.components(symbols, &quote!(#place))).collect()
    }

    /// Part origin and gauge length.
    fn set_up(&self) -> TokenStream {
        let symbols = &self.model.symbols;
        let mut lets = self.components(symbols.part, &quote!(self.part_origin));
        lets.extend(self.value(symbols.gauge, &quote!(self.gauge_length)));
        lets
    }

    fn dimensions(&self) -> TokenStream {
        let of = |dimension: &Dimension| {
            let field = Ident::new(&dimension.name, Span::call_site());
            match dimension.quantity {
                Quantity::Length(symbol) => self.value(symbol, &quote!(self.#field)),
                Quantity::Angle(sine, cosine) => self.pair((sine, cosine), &quote!(math::sin_cos(self.#field))),
            }
        };
        self.model.dimensions.iter().filter_map(of).collect()
    }

    /// Values of linear axes, sines and cosines of rotary ones.
    #[expect(clippy::expect_used, reason = "a function that reads axis values has them as a parameter")]
    fn axes(&self) -> TokenStream {
        let mut lets = TokenStream::new();
        let words = || format_ident!("{}", self.variables.words.expect("words are at hand"));
        let mut rotary = 0_usize;
        for (place, axis) in self.model.axes.iter().enumerate() {
            match axis.kind {
                AxisKind::Linear if self.used.contains(&axis.word) => {
                    let words = words();
                    lets.extend(self.value(axis.word, &quote!(#words[#place])));
                }
                AxisKind::Linear => {}
                AxisKind::Rotary => {
                    if self.uses(axis.sin_cos) {
                        let turn = match self.variables.turns {
                            Some(turns) => {
                                let turns = format_ident!("{turns}");
                                quote!(#turns[#rotary])
                            }
                            None => {
                                let words = words();
                                quote!(math::sin_cos(#words[#place]))
                            }
                        };
                        lets.extend(self.pair(axis.sin_cos, &turn));
                    }
                    rotary += 1;
                }
            }
        }
        lets
    }

    /// `let x = tip.x;` and so on.
    fn components(&self, symbols: [Symbol; 3], place: &TokenStream) -> TokenStream {
        let parts = symbols.into_iter().zip(["x", "y", "z"]);
        let one = |(symbol, part): (Symbol, &str)| {
            let part = format_ident!("{part}");
            self.value(symbol, &quote!(#place.#part))
        };
        parts.filter_map(one).collect()
    }

    /// `let symbol = value;`, if it is used.
    fn value(&self, symbol: Symbol, value: &TokenStream) -> Option<TokenStream> {
        let name = self.name(symbol);
        self.used.contains(&symbol).then(|| quote!(let #name = #value;))
    }

    /// `let (sine, cosine) = value;`, if one of them is used.
    fn pair(&self, turn: (Symbol, Symbol), value: &TokenStream) -> Option<TokenStream> {
        let name = |symbol: Symbol| {
            let name = self.name(symbol);
            if self.used.contains(&symbol) { quote!(#name) } else { quote!(_) }
        };
        let (sine, cosine) = (name(turn.0), name(turn.1));
        self.uses(turn).then(|| quote!(let (#sine, #cosine) = #value;))
    }

    fn uses(&self, (sine, cosine): (Symbol, Symbol)) -> bool {
        self.used.contains(&sine) || self.used.contains(&cosine)
    }

    fn name(&self, symbol: Symbol) -> Ident {
        Ident::new(self.model.ring.name(symbol), Span::call_site())
    }
}
