//! The machines of the source papers: 100 000 poses each, and their joints against the chains written out by hand.

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::nalgebra::Vector3;
use tests::by_hand::compare;
use tests::conformance;
use tests::oracle::papers;

conformance!(SpinnerU5620, spinner_u5_620, 100_000);
conformance!(Dmu70e, dmu_70e, 100_000);
conformance!(LolaXoyzba, lola_xoyzba, 100_000);
conformance!(MultiProDesk, multiprodesk, 100_000);

#[test]
fn spinner_is_the_chain_of_its_paper() {
    compare::<SpinnerU5620>("CBXYZ", |machine, axes, part, _| papers::spinner_u5_620(machine.d, part, *axes));
}

#[test]
fn dmu_is_the_chain_of_its_paper() {
    compare::<Dmu70e>("CBXYZ", |machine, axes, part, _| papers::dmu_70e(machine.d, part, *axes));
}

#[test]
fn lola_is_the_chain_of_its_paper() {
    compare::<LolaXoyzba>("XYZBA", |_, axes, _, gauge| papers::lola_xoyzba(gauge, *axes));
}

#[test]
fn multiprodesk_is_the_chain_of_its_paper() {
    compare::<MultiProDesk>("AYXZ", |_, axes, part, _| papers::multiprodesk(&Vector3::zeros(), part, *axes));
}
