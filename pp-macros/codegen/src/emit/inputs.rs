//! Inputs of a generated function: which of them it needs, where each comes from, and the `let` statements of Rust.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use crate::model::{AxisId, AxisKind, Dimension, Model, Quantity};
use crate::symbolic::Symbol;

/// Variables that hold the inputs of a function.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct InputVariables<'a> {
    /// Variable with three components for the tip.
    pub(crate) tip: Option<&'a str>,
    /// Variable with three components for the tool axis.
    pub(crate) axis: Option<&'a str>,
    /// Array in chain order with the values of axes.
    pub(crate) words: Option<&'a str>,
    /// Array of (sine, cosine) of all rotary axes; otherwise they are computed from `words`.
    pub(crate) turns: Option<&'a str>,
}

/// One input, under the names of its symbols.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Input<'a> {
    /// A number.
    Value(&'a str, InputSource<'a>),
    /// Sine and cosine of an angle; at least one of them is used.
    Angle([Option<&'a str>; 2], InputSource<'a>),
}

/// Place of an input's value.
#[derive(Debug, Clone, Copy)]
pub(crate) enum InputSource<'a> {
    /// Component 0 to 2 of a vector in a variable.
    Component(&'a str, usize),
    /// Component 0 to 2 of the part origin.
    PartOrigin(usize),
    /// The gauge length.
    GaugeLength,
    /// The dimension of that name; of an angle, in radians.
    Dimension(&'a str),
    /// The value of an axis in an array in chain order.
    Word(&'a str, AxisId),
    /// Sine and cosine of the rotary with that number, in an array of pairs.
    Turn(&'a str, usize),
}

/// The inputs that are used, in the order of pose, set-up, dimensions, axes.
pub(crate) fn inputs<'a>(model: &'a Model, used: &BTreeSet<Symbol>, variables: InputVariables<'a>) -> Vec<Input<'a>> {
    let mut list = List { model, used, inputs: Vec::new() };
    let symbols = &model.symbols;
    for (vector, variable) in [(symbols.tip, variables.tip), (symbols.axis, variables.axis)] {
        if let Some(variable) = variable {
            list.components(vector, |index| InputSource::Component(variable, index));
        }
    }
    list.components(symbols.part, InputSource::PartOrigin);
    list.value(symbols.gauge, InputSource::GaugeLength);
    for Dimension { name, quantity, .. } in &model.dimensions {
        match *quantity {
            Quantity::Length(symbol) => list.value(symbol, InputSource::Dimension(name)),
            Quantity::Angle(sine, cosine) => list.angle([sine, cosine], InputSource::Dimension(name)),
        }
    }
    list.axes(variables);
    list.inputs
}

/// `let` statements for the inputs that are used; sines and cosines of axes are computed together.
pub(crate) fn prelude(model: &Model, used: &BTreeSet<Symbol>, variables: InputVariables<'_>) -> TokenStream {
    let (angles, others): (Vec<_>, Vec<_>) = inputs(model, used, variables)
        .into_iter()
        .partition(|input| matches!(input, Input::Angle(_, InputSource::Word(..))));
    let mut lets: TokenStream = others.into_iter().map(statement).collect();
    if !angles.is_empty() {
        let (patterns, values): (Vec<_>, Vec<_>) = angles.into_iter().map(definition).unzip();
        lets.extend(quote!(let [#(#patterns),*] = math::turns([#(#values),*]);));
    }
    lets
}

/// The inputs found so far.
struct List<'a, 'b> {
    model: &'a Model,
    used: &'b BTreeSet<Symbol>,
    inputs: Vec<Input<'a>>,
}

impl<'a> List<'a, '_> {
    /// Values of linear axes, sines and cosines of rotary ones.
    #[expect(clippy::expect_used, reason = "a function that reads axis values has them as a parameter")]
    fn axes(&mut self, variables: InputVariables<'a>) {
        let word = |place| InputSource::Word(variables.words.expect("words are at hand"), place);
        let mut rotary = 0_usize;
        for (place, axis) in self.model.axes.iter().enumerate() {
            match axis.kind {
                AxisKind::Linear if self.used.contains(&axis.word) => self.value(axis.word, word(place)),
                AxisKind::Linear => {}
                AxisKind::Rotary => {
                    let (sine, cosine) = axis.sin_cos;
                    if self.used.contains(&sine) || self.used.contains(&cosine) {
                        let turn = variables.turns.map(|turns| InputSource::Turn(turns, rotary));
                        self.angle([sine, cosine], turn.unwrap_or_else(|| word(place)));
                    }
                    rotary += 1;
                }
            }
        }
    }

    fn components(&mut self, symbols: [Symbol; 3], source: impl Fn(usize) -> InputSource<'a>) {
        for (index, symbol) in symbols.into_iter().enumerate() {
            self.value(symbol, source(index));
        }
    }

    fn value(&mut self, symbol: Symbol, source: InputSource<'a>) {
        self.inputs.extend(self.name(symbol).map(|name| Input::Value(name, source)));
    }

    fn angle(&mut self, symbols: [Symbol; 2], source: InputSource<'a>) {
        let names = symbols.map(|symbol| self.name(symbol));
        if names != [None; 2] {
            self.inputs.push(Input::Angle(names, source));
        }
    }

    /// Name of a symbol that is used.
    fn name(&self, symbol: Symbol) -> Option<&'a str> {
        self.used.contains(&symbol).then(|| self.model.ring.name(symbol))
    }
}

fn statement(input: Input<'_>) -> TokenStream {
    let (pattern, value) = definition(input);
    match input {
        Input::Angle(_, InputSource::Dimension(_)) => quote!(let #pattern = math::sin_cos(#value);),
        _ => quote!(let #pattern = #value;),
    }
}

/// Name, or names of sine and cosine; and the number, the angle, or the pair.
fn definition(input: Input<'_>) -> (TokenStream, TokenStream) {
    let variable = |name: &str| {
        let name = format_ident!("{name}");
        quote!(#name)
    };
    match input {
        Input::Value(name, source) => (variable(name), value(source)),
        Input::Angle(names, source) => {
            let [sine, cosine] = names.map(|name| name.map_or_else(|| quote!(_), variable));
            (quote!((#sine, #cosine)), value(source))
        }
    }
}

fn value(source: InputSource<'_>) -> TokenStream {
    let component = |index: usize| format_ident!("{}", ["x", "y", "z"][index]);
    match source {
        InputSource::Component(variable, index) => {
            let (variable, index) = (format_ident!("{variable}"), component(index));
            quote!(#variable.#index)
        }
        InputSource::PartOrigin(index) => {
            let index = component(index);
            quote!(self.part_origin.#index)
        }
        InputSource::GaugeLength => quote!(self.gauge_length),
        InputSource::Dimension(name) => {
            let field = Ident::new(name, Span::call_site());
            quote!(self.#field)
        }
        InputSource::Word(array, place) | InputSource::Turn(array, place) => {
            let array = format_ident!("{array}");
            quote!(#array[#place])
        }
    }
}
