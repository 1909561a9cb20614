//! Where a generated function takes its inputs from.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::model::{Kind, Model, Quantity};
use crate::symbolic::Symbol;

/// What stands for the inputs of a function.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Places<'a> {
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
pub(crate) fn prelude(model: &Model, used: &BTreeSet<Symbol>, places: Places<'_>) -> TokenStream {
    let mut lets = TokenStream::new();
    let name = |symbol: Symbol| Ident::new(model.ring.name(symbol), Span::call_site());
    let vectors = [(model.frame.tip, places.tip), (model.frame.axis, places.axis)];
    for (symbols, place) in vectors {
        let Some(place) = place else { continue };
        let place = format_ident!("{place}");
        for (symbol, part) in symbols.into_iter().zip(["x", "y", "z"]).filter(|(symbol, _)| used.contains(symbol)) {
            let (name, part) = (name(symbol), format_ident!("{part}"));
            lets.extend(quote!(let #name = #place.#part;));
        }
    }
    for (symbol, part) in model.frame.part.into_iter().zip(["x", "y", "z"]).filter(|(symbol, _)| used.contains(symbol))
    {
        let (name, part) = (name(symbol), format_ident!("{part}"));
        lets.extend(quote!(let #name = self.part_origin.#part;));
    }
    if used.contains(&model.frame.gauge) {
        let name = name(model.frame.gauge);
        lets.extend(quote!(let #name = self.gauge_length;));
    }
    for dimension in &model.dimensions {
        let field = Ident::new(&dimension.name, Span::call_site());
        match dimension.quantity {
            Quantity::Length(symbol) if used.contains(&symbol) => {
                let name = name(symbol);
                lets.extend(quote!(let #name = self.#field;));
            }
            Quantity::Angle(sine, cosine) if used.contains(&sine) || used.contains(&cosine) => {
                let pair = pair(model, used, (sine, cosine));
                lets.extend(quote!(let #pair = math::sin_cos(self.#field);));
            }
            _ => {}
        }
    }
    let mut rotary = 0_usize;
    for (place, axis) in model.axes.iter().enumerate() {
        if axis.kind == Kind::Linear {
            if used.contains(&axis.word) {
                let (name, words) = (name(axis.word), format_ident!("{}", places.words.expect("words are at hand")));
                lets.extend(quote!(let #name = #words[#place];));
            }
            continue;
        }
        if used.contains(&axis.turn.0) || used.contains(&axis.turn.1) {
            let pair = pair(model, used, axis.turn);
            lets.extend(match places.turns {
                Some(turns) => {
                    let turns = format_ident!("{turns}");
                    quote!(let #pair = #turns[#rotary];)
                }
                None => {
                    let words = format_ident!("{}", places.words.expect("words are at hand"));
                    quote!(let #pair = math::sin_cos(#words[#place]);)
                }
            });
        }
        rotary += 1;
    }
    lets
}

fn pair(model: &Model, used: &BTreeSet<Symbol>, (sine, cosine): (Symbol, Symbol)) -> TokenStream {
    let [sine, cosine] = [sine, cosine].map(|symbol| {
        if used.contains(&symbol) {
            let name = Ident::new(model.ring.name(symbol), Span::call_site());
            quote!(#name)
        } else {
            quote!(_)
        }
    });
    quote!((#sine, #cosine))
}
