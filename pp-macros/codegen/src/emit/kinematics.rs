//! Forward kinematics, the shared position function, and the joints as declared.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::{Body, lets};
use super::inputs::{InputVariables, prelude};
use crate::model::{AxisId, AxisKind, Model};
use crate::solve::Solved;
use crate::symbolic::{Id, NodeVector};

/// `forward_kinematics`.
pub(crate) fn forward(model: &Model, solved: &Solved) -> TokenStream {
    let outputs: Vec<Id> = solved.forward.tip.into_iter().chain(solved.forward.axis).collect();
    let mut body = Body::new(&solved.graph, &outputs);
    let prelude =
        prelude(model, &body.inputs(&outputs), InputVariables { words: Some("axes"), ..InputVariables::default() });
    let statements = lets(&body.statements(&outputs));
    let (tip, axis) = (components(&body, solved.forward.tip), components(&body, solved.forward.axis));
    quote! {
        #[inline]
        fn forward_kinematics(&self, axes: &Self::Axes) -> pp::kinematics::Pose {
            let _ = axes;
            #prelude
            #statements
            pp::kinematics::Pose {
                tip: pp::nalgebra::Point3::new(#tip),
                axis: pp::nalgebra::Unit::new_unchecked(pp::nalgebra::Vector3::new(#axis)),
            }
        }
    }
}

/// The private position function of sines and cosines, and its signature: values of the three solved linear axes, in
/// chain order.
pub(crate) fn position(model: &Model, solved: &Solved) -> (TokenStream, TokenStream) {
    let values: Vec<Id> = solved.position.values.iter().map(|(_, node)| *node).collect();
    let determinant = solved.position.determinant;
    let varies = solved.graph.constant_of(determinant).is_none();
    let outputs: Vec<Id> = values.iter().copied().chain(varies.then_some(determinant)).collect();
    let mut body = Body::new(&solved.graph, &outputs);
    let places =
        InputVariables { tip: Some("tip"), words: Some("held"), turns: Some("turns"), ..InputVariables::default() };
    let prelude = prelude(model, &body.inputs(&outputs), places);
    let guard = varies.then(|| {
        let statements = lets(&body.statements(&[determinant]));
        let determinant = body.tokens(determinant);
        quote! {
            #statements
            if !(math::abs(#determinant) >= pp::kinematics::SMALLEST_DETERMINANT) {
                return ::core::option::Option::None;
            }
        }
    });
    let statements = lets(&body.statements(&outputs));
    let values = values.iter().map(|node| body.tokens(*node));
    let (count, rotaries) = (model.axes.len(), rotaries(model).count());
    let signature = quote! {
        /// Linear axes from the tip and the (sine, cosine) of every rotary axis.
        fn position(
            &self,
            tip: &pp::nalgebra::Point3<f64>,
            turns: &[(f64, f64); #rotaries],
            held: &[f64; #count],
        ) -> ::core::option::Option<[f64; 3]>
    };
    let function = quote! {
        #[inline(always)]
        #signature {
            let _ = (turns, held);
            #prelude
            #guard
            #statements
            ::core::option::Option::Some([#(#values),*])
        }
    };
    (function, quote!(#signature;))
}

/// `linear_axes`.
pub(crate) fn linear_axes(model: &Model, solved: &Solved) -> TokenStream {
    let rotaries = rotaries(model);
    let linears = solved.position.values.iter().map(|(axis, _)| *axis);
    let places = 0_usize..3;
    let solved_linear = |place: &AxisId| !solved.position.values.iter().any(|(linear, _)| linear == place);
    let inputs = (0..model.axes.len()).filter(solved_linear);
    quote! {
        #[inline(always)]
        fn linear_axes(
            &self,
            tip: &pp::nalgebra::Point3<f64>,
            axes: &Self::Axes,
        ) -> ::core::option::Option<Self::Axes> {
            if !(tip.x + tip.y + tip.z #(+ axes[#inputs])*).is_finite() {
                return ::core::option::Option::None;
            }
            let turns = math::turns([#(axes[#rotaries]),*]);
            let value = self.position(tip, &turns, axes)?;
            let mut solved = *axes;
            #(solved[#linears] = value[#places];)*
            ::core::option::Option::Some(solved)
        }
    }
}

/// `joint` and `tool_axis`.
pub(crate) fn joints(model: &Model, solved: &Solved) -> TokenStream {
    let name = &model.name;
    let arms = model.axes.iter().enumerate().map(|(place, axis)| {
        let nodes: Vec<Id> = solved.directions[place].into_iter().chain(solved.centres[place]).collect();
        let mut body = Body::new(&solved.graph, &nodes);
        let prelude = prelude(model, &body.inputs(&nodes), InputVariables::default());
        let statements = lets(&body.statements(&nodes));
        let direction = components(&body, solved.directions[place]);
        let centre = components(&body, solved.centres[place]);
        let sign = if axis.reversed { quote!(-1.0) } else { quote!(1.0) };
        quote! {
            #place => {
                #prelude
                #statements
                pp::kinematics::Joint {
                    direction: pp::nalgebra::Unit::new_unchecked(
                        pp::nalgebra::Vector3::new(#direction),
                    ),
                    point: pp::nalgebra::Point3::new(#centre),
                    sign: #sign,
                }
            }
        }
    });
    let mut body = Body::new(&solved.graph, &solved.tool_axis);
    let prelude = prelude(model, &body.inputs(&solved.tool_axis), InputVariables::default());
    let statements = lets(&body.statements(&solved.tool_axis));
    let tool_axis = components(&body, solved.tool_axis);
    quote! {
        fn joint(&self, index: usize) -> pp::kinematics::Joint {
            match index {
                #(#arms)*
                _ => ::core::panic!("{} has no axis {index}", #name),
            }
        }

        fn tool_axis(&self) -> pp::nalgebra::UnitVector3<f64> {
            #prelude
            #statements
            pp::nalgebra::Unit::new_unchecked(pp::nalgebra::Vector3::new(#tool_axis))
        }
    }
}

/// Places of all rotary axes, held ones included.
pub(crate) fn rotaries(model: &Model) -> impl Iterator<Item = AxisId> + Clone + '_ {
    model.axes.iter().enumerate().filter(|(_, axis)| axis.kind == AxisKind::Rotary).map(|(place, _)| place)
}

fn components(body: &Body<'_>, vector: NodeVector) -> TokenStream {
    let parts = vector.map(|node| body.tokens(node));
    quote!(#(#parts),*)
}
