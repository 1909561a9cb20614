//! Posting a point allocates nothing.

use std::hint::black_box;

use pp_runtime::kinematics::Machine;
use pp_runtime::nalgebra::Vector3;
use tests::heap::{Counting, allocations};
use tests::oracle::Oracle;
use tests::random::Random;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Every map of the kinematics, also where there is no solution.
fn check<M: Machine>() {
    let mut machine = M::default();
    machine.set_up(Vector3::new(12.5, -40.0, 80.0), 120.0);
    let oracle = Oracle::of(&machine);
    let mut random = Random::new(99);
    for _ in 0..200 {
        let mut axes = M::HELD;
        for (value, axis) in axes.as_mut().iter_mut().zip(M::AXES) {
            if !axis.held {
                *value = random.between(-3.0, 3.0);
            }
        }
        let pose = oracle.forward(axes.as_ref());
        let anywhere = pp_runtime::nalgebra::UnitVector3::new_normalize(Vector3::from(random.direction()));
        let count = allocations(|| {
            black_box(machine.forward_kinematics(black_box(&axes)));
            black_box(machine.inverse_kinematics(black_box(&pose), &axes));
            black_box(machine.linear_axes(black_box(&pose.tip), &axes));
            black_box(machine.reach(black_box(&pose.axis), &axes).is_ok());
            black_box(machine.reach(black_box(&anywhere), &axes).is_ok());
            black_box(machine.motion(black_box(&axes), &M::HELD));
            black_box(machine.rates(black_box(&axes), &M::HELD));
        });
        assert_eq!(count, 0, "{} allocates", M::NAME);
    }
}

#[test]
fn the_counter_counts() {
    assert_eq!(allocations(|| drop(black_box(Box::new(1)))), 1);
}

#[test]
fn kinematics_of_a_table_allocates_nothing() {
    check::<machines::SpinnerU5620>();
}

#[test]
fn kinematics_of_an_inclined_table_allocates_nothing() {
    check::<machines::Dmu70e>();
}

#[test]
fn kinematics_of_a_head_allocates_nothing() {
    check::<machines::LolaXoyzba>();
}

#[test]
fn kinematics_of_four_axes_allocates_nothing() {
    check::<machines::MultiProDesk>();
}
