//! `curves` and `rates`, from the derivatives of the pose.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::body::{Body, lets};
use super::inputs::{InputVariables, prelude};
use crate::model::{AxisKind, Model};
use crate::solve::{Curve, Motion};
use crate::symbolic::{Id, Node, NodeVector, Symbol};

/// `curves` and `rates`.
pub(crate) fn motion(model: &Model, motion: &Motion) -> TokenStream {
    let (curves, rates) = (curves(model, motion), rates(model, motion));
    quote! {
        #curves
        #rates
    }
}

fn rates(model: &Model, motion: &Motion) -> TokenStream {
    let outputs = motion.rates.as_flattened();
    let mut body = Body::new(&motion.graph, outputs);
    let inputs = inputs(model, motion, &body, outputs, "axes");
    let statements = lets(&body.statements(outputs));
    let [tip, axis] = motion.rates.map(|rate| vector(&body, rate));
    quote! {
        #[inline]
        fn rates(
            &self,
            axes: &Self::Axes,
            change: &Self::Axes,
        ) -> (pp::nalgebra::Vector3<f64>, pp::nalgebra::Vector3<f64>) {
            let _ = (axes, change);
            #inputs
            #statements
            (#tip, #axis)
        }
    }
}

fn curves(model: &Model, motion: &Motion) -> TokenStream {
    let nodes = |curve: &Curve| curve.rate.into_iter().chain(curve.bend).chain([curve.third]).collect::<Vec<_>>();
    let centres: Vec<Id> = motion.centres.iter().flatten().copied().collect();
    let outputs = [nodes(&motion.tip), nodes(&motion.axis_curve), motion.axis.to_vec(), centres.clone()].concat();
    let mut body = Body::new(&motion.graph, &outputs);
    let inputs = inputs(model, motion, &body, &outputs, "middle");
    let statements = lets(&body.statements(&outputs));
    let (tip, axis_curve) = (curve(&body, &motion.tip), curve(&body, &motion.axis_curve));
    let axis = vector(&body, motion.axis);
    let places: Vec<usize> = (0..model.axes.len()).collect();
    let magnitudes = |kind: AxisKind| {
        let places = places.iter().filter(|place| model.axes[**place].kind == kind);
        let terms = places.map(|place| quote!(+ (math::abs(from[#place]) + math::abs(to[#place]))));
        quote!(0.0 #(#terms)*)
    };
    let (turns, travel) = (magnitudes(AxisKind::Rotary), magnitudes(AxisKind::Linear));
    let arms = arms(motion, &body, &centres);
    quote! {
        #[inline(always)]
        fn curves(&self, from: &Self::Axes, to: &Self::Axes) -> pp::kinematics::BlockCurves {
            let middle = [#(0.5 * (from[#places] + to[#places])),*];
            let change = [#(to[#places] - from[#places]),*];
            #inputs
            #statements
            let (turns, reach) = (#turns, #travel #arms);
            pp::kinematics::BlockCurves { tip: #tip, tool_axis: #axis, axis: #axis_curve, reach, turns }
        }
    }
}

/// `+ 4 Σ |c|`, component by component; constants are added up here, and equal components, whatever their sign,
/// counted.
fn arms(motion: &Motion, body: &Body<'_>, centres: &[Id]) -> TokenStream {
    let mut known = 0.0;
    let mut counts: Vec<(Id, f64)> = Vec::new();
    for &component in centres {
        if let Some(value) = motion.graph.constant_of(component).and_then(|value| motion.graph.ring().value(value)) {
            known += 4.0 * value.abs();
            continue;
        }
        let unsigned = match *motion.graph.node(component) {
            Node::Neg(inner) => inner,
            _ => component,
        };
        match counts.iter_mut().find(|(counted, _)| *counted == unsigned) {
            Some((_, factor)) => *factor += 4.0,
            None => counts.push((unsigned, 4.0)),
        }
    }
    let mut terms = TokenStream::new();
    for (component, factor) in counts {
        let (component, factor) = (body.tokens(component), Literal::f64_unsuffixed(factor));
        terms.extend(quote!(+ #factor * math::abs(#component)));
    }
    let known = (known > 0.0).then(|| Literal::f64_unsuffixed(known)).map(|known| quote!(+ #known));
    quote!(#known #terms)
}

/// Inputs of a function: axis values in the array `words`, their changes in `change`.
fn inputs(model: &Model, motion: &Motion, body: &Body<'_>, outputs: &[Id], words: &str) -> TokenStream {
    let used = body.inputs(outputs);
    let mut lets = prelude(model, &used, InputVariables { words: Some(words), ..InputVariables::default() });
    let name = |symbol: Symbol| Ident::new(motion.graph.ring().name(symbol), Span::call_site());
    let array = format_ident!("change");
    for (place, (&change, &size)) in motion.changes.iter().zip(&motion.sizes).enumerate() {
        if used.contains(&change) {
            let change = name(change);
            lets.extend(quote!(let #change = #array[#place];));
        }
        if used.contains(&size) {
            let size = name(size);
            lets.extend(quote!(let #size = math::abs(#array[#place]);));
        }
    }
    lets
}

fn vector(body: &Body<'_>, vector: NodeVector) -> TokenStream {
    let parts = vector.map(|node| body.tokens(node));
    quote!(pp::nalgebra::Vector3::new(#(#parts),*))
}

fn curve(body: &Body<'_>, curve: &Curve) -> TokenStream {
    let (rate, bend, third) = (vector(body, curve.rate), vector(body, curve.bend), body.tokens(curve.third));
    quote!(pp::kinematics::Curve { rate: #rate, bend: #bend, third: #third })
}
