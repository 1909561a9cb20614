//! The struct, its constants, access to dimensions and set-up, and `validate`.

use num_rational::BigRational;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::Body;
use super::inputs::{InputVariables, prelude};
use super::options::Options;
use crate::check::Item;
use crate::explain::{Explanation, Section};
use crate::formula::{Formula, NamedNodes};
use crate::model::{Axis, AxisKind, Dimension, Model, Quantity, Side, to_f64};
use crate::solve::{SideCondition, Solved};

/// The struct with its documentation and its defaults.
pub(crate) fn item(declared: &Item, model: &Model, explanation: &Explanation, options: Options) -> TokenStream {
    let Item { attributes, configured, visibility, name, runtime } = declared;
    let doc = explanation.doc();
    let fields: Vec<Ident> = model.dimensions.iter().map(|d| Ident::new(&d.name, Span::call_site())).collect();
    let field_docs = model.dimensions.iter().map(|dimension| match dimension.quantity {
        Quantity::Length(_) => format!("Length `{}`, mm.", dimension.name),
        Quantity::Angle(..) => format!("Angle `{}`, radians.", dimension.name),
    });
    let defaults = model.dimensions.iter().map(default);
    let serde = options.serde.then(|| {
        let path = quote!(#runtime::serde).to_string().replace(' ', "");
        quote! {
            #[derive(#runtime::serde::Serialize, #runtime::serde::Deserialize)]
            #[serde(crate = #path, default, deny_unknown_fields)]
        }
    });
    quote! {
        #[derive(::core::clone::Clone, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #serde
        #(#attributes)*
        #(#[doc = #doc])*
        #visibility struct #name {
            #(#[doc = #field_docs] pub #fields: ::core::primitive::f64,)*
            /// Position of the part zero relative to the table's reference point, along the table's directions, mm.
            pub part_origin: #runtime::nalgebra::Vector3<::core::primitive::f64>,
            /// Distance from the gauge line to the tool tip, mm.
            pub gauge_length: ::core::primitive::f64,
        }

        #(#configured)*
        #[automatically_derived]
        #[allow(deprecated, clippy::all, clippy::pedantic, clippy::nursery)]
        impl ::core::default::Default for #name {
            fn default() -> Self {
                Self {
                    #(#fields: #defaults,)*
                    part_origin: #runtime::nalgebra::Vector3::new(0.0, 0.0, 0.0),
                    gauge_length: 0.0,
                }
            }
        }
    }
}

/// The associated constants.
pub(crate) fn data(model: &Model, explanation: &Explanation, (fields, text): &(Vec<String>, String)) -> TokenStream {
    let name = &model.name;
    let axes = model.axes.iter().map(axis);
    let dimensions = model.dimensions.iter().map(|dimension| {
        let name = &dimension.name;
        let value = default(dimension);
        let kind = match dimension.quantity {
            Quantity::Length(_) => quote!(Length),
            Quantity::Angle(..) => quote!(Angle),
        };
        quote! {
            pp::kinematics::Dimension {
                name: #name,
                kind: pp::kinematics::DimensionKind::#kind,
                default: #value,
            }
        }
    });
    let held = model.axes.iter().map(|axis| match &axis.held {
        Some(value) => in_radians(axis.kind, value),
        None => quote!(0.0),
    });
    let mut up = [0.0; 3];
    up[model.up.coordinate] = if model.up.negated { -1.0 } else { 1.0 };
    let explanation = tokens(explanation);
    quote! {
        const NAME: &'static str = #name;
        const AXES: &'static [pp::kinematics::Axis] = &[#(#axes),*];
        const DIMENSIONS: &'static [pp::kinematics::Dimension] = &[#(#dimensions),*];
        const HELD: Self::Axes = [#(#held),*];
        const UP: [::core::primitive::f64; 3] = [#(#up),*];
        const EXPLANATION: &'static pp::kinematics::Explanation = &#explanation;
        const C_SOURCE: pp::kinematics::CSource =
            pp::kinematics::CSource { fields: &[#(#fields),*], text: #text };
    }
}

/// An expression of type `pp_runtime::kinematics::Explanation`.
fn tokens(explanation: &Explanation) -> TokenStream {
    let fields = explanation.sections().into_iter().map(|(name, section)| {
        let name = quote::format_ident!("{name}");
        let Section { text, latex } = section;
        quote! {
            #name: pp::kinematics::Section { text: &[#(#text),*], latex: &[#(#latex),*] }
        }
    });
    quote!(pp::kinematics::Explanation { #(#fields),* })
}

/// Access to dimensions and set-up, and `validate`.
pub(crate) fn set_up(model: &Model, solved: &Solved) -> TokenStream {
    let fields: Vec<Ident> = model.dimensions.iter().map(|d| Ident::new(&d.name, Span::call_site())).collect();
    let names: Vec<&str> = model.dimensions.iter().map(|d| d.name.as_str()).collect();
    let places: Vec<usize> = (0..fields.len()).collect();
    let machine = &model.name;
    let conditions = conditions(model, solved);
    let required: Vec<&str> =
        model.dimensions.iter().filter(|dimension| dimension.default.is_none()).map(|d| d.name.as_str()).collect();
    let required_fields: Vec<Ident> = required.iter().map(|name| Ident::new(name, Span::call_site())).collect();
    quote! {
        fn dimension(&self, index: usize) -> f64 {
            match index {
                #(#places => self.#fields,)*
                _ => ::core::panic!("{} has no dimension {index}", #machine),
            }
        }

        fn set_dimension(&mut self, index: usize, value: f64) {
            let _ = value;
            match index {
                #(#places => self.#fields = value,)*
                _ => ::core::panic!("{} has no dimension {index}", #machine),
            }
        }

        fn set_up(&mut self, part_origin: pp::nalgebra::Vector3<f64>, gauge_length: f64) {
            self.part_origin = part_origin;
            self.gauge_length = gauge_length;
        }

        fn validate(&self) -> ::core::result::Result<(), pp::kinematics::Invalid> {
            #(if self.#required_fields.is_nan() {
                return ::core::result::Result::Err(pp::kinematics::Invalid::Required { name: #required });
            })*
            #(if !self.#fields.is_finite() {
                return ::core::result::Result::Err(pp::kinematics::Invalid::NotFinite { name: #names });
            })*
            if !(self.part_origin.x + self.part_origin.y + self.part_origin.z).is_finite() {
                return ::core::result::Result::Err(pp::kinematics::Invalid::NotFinite { name: "part_origin" });
            }
            if !self.gauge_length.is_finite() {
                return ::core::result::Result::Err(pp::kinematics::Invalid::NotFinite { name: "gauge_length" });
            }
            #conditions
            ::core::result::Result::Ok(())
        }
    }
}

/// Divisors that depend on dimensions alone.
fn conditions(model: &Model, solved: &Solved) -> TokenStream {
    let dimensions = model.dimension_symbols();
    let mut tests = TokenStream::new();
    for SideCondition { divisor: node, tolerance, meaning } in &solved.conditions {
        let node = *node;
        if solved.graph.constant_of(node).is_some() {
            continue;
        }
        let mut body = Body::new(&solved.graph, &[node]);
        let inputs = body.inputs(&[node]);
        if !inputs.iter().all(|symbol| dimensions.contains(symbol)) {
            continue;
        }
        let statements = body.statements(&[node]);
        let (lets, value) = (super::body::lets(&statements), body.tokens(node));
        let prelude = prelude(model, &inputs, InputVariables::default());
        let written = Formula::of_node(model, &solved.graph, node, &NamedNodes::new()).source();
        let least = float(*tolerance);
        tests.extend(quote! {
            {
                #prelude
                #lets
                if !(math::abs(#value) > #least) {
                    return ::core::result::Result::Err(pp::kinematics::Invalid::Zero {
                        expression: #written,
                        meaning: #meaning,
                    });
                }
            }
        });
    }
    tests
}

fn axis(axis: &Axis) -> TokenStream {
    let letter = axis.letter;
    let kind = match axis.kind {
        AxisKind::Linear => quote!(Linear),
        AxisKind::Rotary => quote!(Rotary),
    };
    let side = match axis.side {
        Side::Workpiece => quote!(Workpiece),
        Side::Tool => quote!(Tool),
    };
    let sign = if axis.reversed { quote!(Minus) } else { quote!(Plus) };
    let limits = match &axis.limits {
        None => quote!(::core::option::Option::None),
        Some((lower, upper)) => {
            let (lower, upper) = (in_radians(axis.kind, lower), in_radians(axis.kind, upper));
            quote!(::core::option::Option::Some(pp::kinematics::Limits { lower: #lower, upper: #upper }))
        }
    };
    let speed = match &axis.speed {
        None => quote!(::core::option::Option::None),
        Some(speed) => {
            let speed = in_radians(axis.kind, speed);
            quote!(::core::option::Option::Some(#speed))
        }
    };
    let held = axis.held.is_some();
    quote! {
        pp::kinematics::Axis {
            letter: #letter,
            kind: pp::kinematics::AxisKind::#kind,
            side: pp::kinematics::Side::#side,
            sign: pp::kinematics::Sign::#sign,
            limits: #limits,
            speed: #speed,
            held: #held,
        }
    }
}

fn in_radians(kind: AxisKind, value: &BigRational) -> TokenStream {
    let float_value = to_f64(value);
    let converted = if kind == AxisKind::Rotary { float_value.to_radians() } else { float_value };
    signed(&float(converted), value)
}

/// Default of a dimension, mm or rad; NaN if it is required.
fn default(dimension: &Dimension) -> TokenStream {
    let Some(value) = &dimension.default else { return quote!(::core::primitive::f64::NAN) };
    let number = match dimension.quantity {
        Quantity::Length(_) => to_f64(value),
        Quantity::Angle(..) => to_f64(value).to_radians(),
    };
    signed(&float(number), value)
}

/// A literal is never negative: the sign comes before it.
fn float(value: f64) -> Literal {
    Literal::f64_unsuffixed(value.abs())
}

fn signed(literal: &Literal, value: &BigRational) -> TokenStream {
    use num_traits::Signed;
    if value.is_negative() { quote!(-#literal) } else { quote!(#literal) }
}
