//! Posting a point allocates nothing.

use std::hint::black_box;
use std::io::{self, Cursor};

use pp_runtime::config::{Mode, TcpFrame, starting_point};
use pp_runtime::kinematics::Machine;
use pp_runtime::nalgebra::Vector3;
use pp_runtime::post::{Job, post};
use pp_runtime::program::Units;
use tests::by_name;
use tests::heap::allocations;
use tests::oracle::Oracle;
use tests::random::Random;

/// Checks every function of the kinematics, also where there is no solution.
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
fn the_allocator_counts() {
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

/// CL data of a cut with `points` points around a cone, back and forth: the tool axis changes in every motion.
fn cone(points: u32) -> String {
    let mut part = "LOAD/TOOL,1\nSPINDL/RPM,4000,CLW\nRAPID\nGOTO/0,0,80,0,0,1\nFEDRAT/MMPM,600\n".to_owned();
    for point in 0..points {
        let angle = 0.02 * f64::from(if point / 150 % 2 == 0 { point % 150 } else { 150 - point % 150 });
        let (y, x) = angle.sin_cos();
        part += &format!("GOTO/{:.4},{:.4},{:.4},{:.7},{:.7},0.8\n", 30.0 * x, 30.0 * y, 5.0 + y, 0.6 * x, 0.6 * y);
    }
    part + "RAPID\nGOTO/0,0,80,0,0,1\nFINI\n"
}

#[test]
fn a_motion_is_read_planned_and_written_without_allocating() {
    for (control, mode) in [
        ("linuxcnc", Mode::Axes),
        ("fanuc", Mode::Tcp),
        ("siemens", Mode::Axes),
        ("heidenhain", Mode::Tcp),
        ("haas", Mode::Axes),
    ] {
        let control = by_name::control(control);
        let mut config = starting_point(control);
        config.motion.mode = mode;
        config.set_up.part_origin = [0.0, 0.0, 20.0];
        config.motion.tip.tcp_frame = Some(TcpFrame::TableAtZero);
        config.motion.retract.distance_mm = Some(50.0);
        let count = |points: u32| {
            let part = cone(points);
            let job = Job { cl_name: "cone.cls", config: &config, control, units: Some(Units::Millimetres) };
            let mut blocks = 0;
            let count = allocations(|| {
                let report = post::<machines::SpinnerU5620>(&job, &mut Cursor::new(&part), &mut io::sink());
                let report = report.expect("nothing fails");
                assert!(!report.failed, "{:?}", report.diagnostics);
                blocks = report.blocks;
            });
            (count, blocks)
        };
        let ((few, short), (many, long)) = (count(1_000), count(4_000));
        // Lists of the course double their capacity occasionally.
        assert!(long - short >= 3_000 && many <= few + 30, "{few} for {short} blocks, {many} for {long}");
    }
}
