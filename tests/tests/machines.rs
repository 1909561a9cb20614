//! The machines of the source papers: 100 000 poses each, and their joints against the chains written out by hand.

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::kinematics::{Machine, Pose};
use pp_runtime::nalgebra::Vector3;
use tests::conformance;
use tests::oracle::{angle_between, papers};
use tests::random::Random;

conformance!(SpinnerU5620, spinner_u5_620, 100_000);
conformance!(Dmu70e, dmu_70e, 100_000);
conformance!(LolaXoyzba, lola_xoyzba, 100_000);
conformance!(MultiProDesk, multiprodesk, 100_000);

/// Compares a machine with a chain written out by hand; input of `by_hand`: axes, part origin, gauge length.
fn compare<M: Machine>(letters: &str, by_hand: impl Fn(&M::Axes, &Vector3<f64>, f64) -> Pose) {
    assert_eq!(M::AXES.iter().map(|axis| axis.letter).collect::<String>(), letters);
    let mut random = Random::new(2023);
    for _ in 0..1000 {
        let mut machine = M::default();
        let part_origin = Vector3::from_fn(|_, _| random.between(-200.0, 200.0));
        let gauge_length = random.between(0.0, 250.0);
        machine.set_up(part_origin, gauge_length);
        let mut axes = M::Axes::default();
        for (value, axis) in axes.as_mut().iter_mut().zip(M::AXES) {
            let rotary = matches!(axis.letter, 'A'..='C');
            *value = if rotary { random.between(-7.0, 7.0) } else { random.between(-400.0, 400.0) };
        }
        let (expected, pose) = (by_hand(&axes, &part_origin, gauge_length), machine.forward_kinematics(&axes));
        let distance = (expected.tip - pose.tip).norm();
        let angle = angle_between(&expected.axis, &pose.axis);
        assert!(distance <= 1e-9 && angle <= 1e-13, "{} at {axes:?}: {distance:e} mm, {angle:e} rad", M::NAME);
    }
}

#[test]
fn spinner_is_the_chain_of_its_paper() {
    compare::<SpinnerU5620>("CBXYZ", |axes, part, _| papers::spinner_u5_620(150.0, part, *axes));
}

#[test]
fn dmu_is_the_chain_of_its_paper() {
    let d = Dmu70e::default().dimension(0);
    compare::<Dmu70e>("CBXYZ", |axes, part, _| papers::dmu_70e(d, part, *axes));
}

#[test]
fn lola_is_the_chain_of_its_paper() {
    compare::<LolaXoyzba>("XYZBA", |axes, _, gauge| papers::lola_xoyzba(gauge, *axes));
}

#[test]
fn multiprodesk_is_the_chain_of_its_paper() {
    compare::<MultiProDesk>("AYXZ", |axes, part, _| papers::multiprodesk(&Vector3::zeros(), part, *axes));
}
