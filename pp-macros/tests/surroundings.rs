//! A declaration means the same whatever names surround it.

#[allow(non_camel_case_types, dead_code)]
mod with_names_of_its_own {
    struct f64;
    struct usize;
    struct str;
    struct Option;
    trait Shared {}
    mod math {}

    pp_runtime::machine! {
        /// A rotary table on a tilting table.
        #[allow(missing_docs)]
        pub struct Table;
        chain: C B | X Y Z;
        d = (0, 0, d);
        dims = { d: 150.0, alpha: 10 deg };
        axes = { B: Rx(alpha) * Y };
    }
}

#[test]
fn types_called_like_those_of_rust_do_not_disturb() {
    let machine = with_names_of_its_own::Table::default();
    assert!((machine.d - 150.0).abs() < 1e-12);
}

pp_runtime::machine! {
    /// Dimensions called like variables of the generated functions.
    #[allow(missing_docs)]
    pub struct Confusing;
    chain: C B | X Y Z;
    axes = { C: Rx(b) * Z, B: Rz(angle_b_2) * Y };
    d = (word_x + tip, sin_b, angle_b_1);
    dims = { sin_b: 4, b: 20 deg, word_x: 5, angle_b_1: 6, angle_b_2: 10 deg, tip: 7 };
}

#[test]
fn dimensions_called_like_variables_keep_their_values() {
    use pp_runtime::kinematics::{Machine, Pose};
    use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};
    let machine = Confusing::default();
    let pose =
        Pose { tip: Point3::new(10.0, 20.0, 30.0), axis: UnitVector3::new_normalize(Vector3::new(0.2, 0.1, 1.0)) };
    let solutions = machine.inverse_kinematics(&pose, &Confusing::HELD);
    assert_eq!(solutions.len(), 2);
    for solution in solutions.iter() {
        let again = machine.forward_kinematics(&solution.axes);
        assert!((again.tip - pose.tip).norm() < 1e-9 && (again.axis.as_ref() - pose.axis.as_ref()).norm() < 1e-12);
    }
}

/// A facade that re-exports the runtime under a name of its own.
mod shop {
    pub(super) use pp_runtime as post;
}

shop::post::machine! {
    /// Through the facade.
    #[allow(missing_docs)]
    pub struct Renamed;
    chain: C B | X Y Z;
    d = (0, 0, height);
    dims = { height: required };
    up = Z;
    crate = crate::shop::post;
}

#[test]
fn a_required_dimension_is_refused_until_it_is_given() {
    use pp_runtime::kinematics::{Invalid, Machine};
    let mut machine = Renamed::default();
    assert!(machine.height.is_nan() && Renamed::DIMENSIONS[0].default.is_nan());
    assert_eq!(machine.validate(), Err(Invalid::Required { name: "height" }));
    machine.height = 150.0;
    assert_eq!(machine.validate(), Ok(()));
}
