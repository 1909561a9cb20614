//! `reach`: the reason why a tool axis cannot be reached.

use proc_macro2::TokenStream;
use quote::quote;

use super::guard::{inverse_variables, parallel};
use crate::emit::body::{Body, lets};
use crate::emit::inputs::prelude;
use crate::model::{AxisId, Model, Quantity};
use crate::solve::{Orientation, Solved, Tilt};
use crate::symbolic::Id;

/// `reach`.
pub(crate) fn reach(model: &Model, solved: &Solved) -> TokenStream {
    let machine = &model.name;
    let linears = model.letters(model.solved_linears());
    let inputs = inputs(model);
    let why = match &solved.orientation {
        Orientation::Fixed { deviation } => {
            let outputs: Vec<Id> = [*deviation].into_iter().collect();
            let mut body = Body::new(&solved.graph, &outputs);
            let prelude = prelude(model, &body.inputs(&outputs), inverse_variables());
            let statements = lets(&body.statements(&outputs));
            let deviation = body.tokens(*deviation);
            quote! {
                #prelude
                #statements
                if !(#deviation <= pp::kinematics::REACH_TOLERANCE) {
                    let tool = pp::kinematics::Machine::forward_kinematics(self, held).axis;
                    return ::core::result::Result::Err(pp::kinematics::Unreachable::Fixed {
                        machine: #machine,
                        wanted: [axis.x, axis.y, axis.z],
                        tool_axis: [tool.x, tool.y, tool.z],
                    });
                }
            }
        }
        Orientation::One(one) => {
            let varies = solved.graph.constant_of(one.length_claim).is_none();
            let guard = varies.then_some((one.length_claim, one.rotary, inputs.as_str()));
            cone(model, solved, &one.tilt, one.rotary, guard)
        }
        Orientation::Two(two) => {
            let capacity = solved.graph.constant_of(two.second.capacity).is_none();
            let guard = capacity.then_some((two.second.capacity, two.rotaries[1], inputs.as_str()));
            cone(model, solved, &two.tilt, two.rotaries[0], guard)
        }
    };
    quote! {
        fn reach(
            &self,
            axis: &pp::nalgebra::UnitVector3<f64>,
            held: &Self::Axes,
        ) -> ::core::result::Result<(), pp::kinematics::Unreachable> {
            let pose = pp::kinematics::Pose { tip: pp::nalgebra::Point3::origin(), axis: *axis };
            if !pp::kinematics::Machine::inverse_kinematics(self, &pose, held).is_empty() {
                return ::core::result::Result::Ok(());
            }
            if !(axis.x + axis.y + axis.z).is_finite() {
                return ::core::result::Result::Err(pp::kinematics::Unreachable::NotFinite);
            }
            #why
            ::core::result::Result::Err(pp::kinematics::Unreachable::LinearAxes {
                machine: #machine,
                axes: #linears,
            })
        }
    }
}

/// Names of held axes and of angles of `dims`: their values can make a rotary unable to tilt the tool.
fn inputs(model: &Model) -> String {
    let held = model.axes.iter().filter(|axis| axis.held.is_some()).map(|axis| axis.letter.to_string());
    let angles = model.dimensions.iter().filter(|dimension| matches!(dimension.quantity, Quantity::Angle(..)));
    held.chain(angles.map(|dimension| dimension.name.clone())).collect::<Vec<_>>().join(", ")
}

fn cone(
    model: &Model,
    solved: &Solved,
    tilt: &Tilt,
    rotary: AxisId,
    capacity: Option<(Id, AxisId, &str)>,
) -> TokenStream {
    let machine = &model.name;
    let letter = model.axes[rotary].letter;
    let mut outputs = vec![];
    for angle in [tilt.wanted, tilt.between, tilt.tool] {
        outputs.extend(angle.nodes());
    }
    outputs.extend(tilt.direction);
    outputs.extend(capacity.map(|(node, ..)| node));
    let mut body = Body::new(&solved.graph, &outputs);
    let prelude = prelude(model, &body.inputs(&outputs), inverse_variables());
    let statements = lets(&body.statements(&outputs));
    let [wanted, between, tool] = [tilt.wanted, tilt.between, tilt.tool].map(|angle| {
        let (sine, cosine) = (body.tokens(angle.sine), body.tokens(angle.cosine));
        quote!(math::atan2(#sine, #cosine))
    });
    let direction = tilt.direction.map(|node| body.tokens(node));
    let capacity = capacity.map(|(node, axis, held)| {
        let (node, letter) = (body.tokens(node), model.axes[axis].letter);
        let least = parallel();
        quote! {
            if !(#node > #least) {
                return ::core::result::Result::Err(pp::kinematics::Unreachable::Held {
                    machine: #machine,
                    rotary: #letter,
                    held: #held,
                });
            }
        }
    });
    quote! {
        #prelude
        #statements
        #capacity
        if let ::core::option::Option::Some(value) = pp::kinematics::Cone::new(#wanted, #between, #tool).outside() {
            return ::core::result::Result::Err(pp::kinematics::Unreachable::Cone {
                machine: #machine,
                rotary: #letter,
                direction: [#(#direction),*],
                wanted: [axis.x, axis.y, axis.z],
                cone: value,
            });
        }
    }
}
