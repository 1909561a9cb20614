//! Words for poses: rounding, units, limits of linear axes.

use super::*;

#[test]
fn an_axis_out_of_reach_is_reported_with_the_rotary_axes_of_the_machine() {
    let run = run::<Xyz>(&config(), &[tool(1), spindle(), feed([0.0; 3], [0.1, 0.0, 1.0])]);
    assert!(run.error().text.contains("Xyz has no rotary axis to tilt the tool"), "{:?}", run.error());
}

#[test]
fn linear_limits_are_machine_coordinates_that_count_the_gauge_length() {
    let mut config = config();
    config.set_up.machine_zero.insert('Z', -200.0);
    config.motion.approach.distance_mm = 10.0;
    config.set_up.tools.insert(1, GivenTool { length_mm: Some(100.0), ..GivenTool::default() });
    let events = |z| [tool(1), spindle(), feed([0.0, 0.0, z], UP)];
    // -200 + z + 100 >= -300, and the approach point stays below Z0.
    assert_eq!(run::<Xyz>(&config, &events(-200.0)).diagnostics, []);
    let low = run::<Xyz>(&config, &events(-200.001));
    assert!(low.error().text.contains("-300.001 mm (machine coordinate)"), "{:?}", low.error());
    assert_eq!(run::<Xyz>(&config, &events(90.0)).diagnostics, []);
    assert!(run::<Xyz>(&config, &events(90.001)).error().text.contains("approach"));
    // Lower retract position: the approach point must not be above it.
    config.motion.retract.position_mm = Some(-50.0);
    assert!(run::<Xyz>(&config, &events(45.0)).error().text.contains("above the retract position"));
    assert_eq!(run::<Xyz>(&config, &events(40.0)).diagnostics, []);
}

#[test]
fn without_machine_zero_only_the_span_is_compared_with_the_travel() {
    let events = |x| [tool(1), spindle(), feed([1000.0, 0.0, 0.0], UP), feed([1000.0 + x, 0.0, 0.0], UP)];
    assert_eq!(run::<Xyz>(&config(), &events(400.0)).diagnostics, []);
    let wide = run::<Xyz>(&config(), &events(400.001));
    assert!(wide.error().text.contains("400.001 mm of X travel"), "{:?}", wide.error());
}

#[test]
fn words_of_a_tilted_program_put_the_tip_within_half_a_unit_for_the_written_angles() {
    fn check<M: Machine>(config: &Config, axes: impl Fn(f64) -> [f64; 3]) {
        let mut events = vec![tool(1), spindle()];
        let mut wanted = Vec::new();
        for step in 0..200 {
            let t = f64::from(step) / 200.0;
            let tip = [40.0 * t, 13.0 * (3.0 * t).sin(), 5.0 * (7.0 * t).cos()];
            wanted.push(tip);
            events.push(feed(tip, axes(t)));
        }
        let run = run::<M>(config, &events);
        assert_eq!(run.diagnostics, []);
        let mut machine = config.set_up.machine::<M>().expect("valid");
        machine.set_up(config.set_up.part_origin.into(), config.set_up.tools[&1].length_mm.unwrap_or(0.0));
        let mut axes = M::HELD;
        let mut checked = 0;
        for line in run.lines.iter().filter(|line| !line.starts_with(['(', 'N', 'o']) && !line.contains("G53")) {
            let mut moved = false;
            for word in line.split(' ') {
                if let Some(index) = M::AXES.iter().position(|axis| word.starts_with(axis.letter)) {
                    let value: f64 = word[1..].parse().expect("a number");
                    let rotary = M::AXES[index].kind == AxisKind::Rotary;
                    axes.as_mut()[index] = if rotary { value.to_radians() } else { value };
                    moved = true;
                }
            }
            if moved && checked < wanted.len() {
                // Linear words for these very angles, computed without rounding.
                let exact = machine.linear_axes(&Point3::from(wanted[checked]), &axes).expect("regular");
                let off = |index: usize| (exact.as_ref()[index] - axes.as_ref()[index]).abs();
                let near = (0..M::AXES.len()).all(|index| off(index) <= 0.000_5 + 1e-9);
                // The blocks of the approach come first.
                if near {
                    checked += 1;
                    let tip = machine.forward_kinematics(&axes).tip;
                    assert!((tip - Point3::from(wanted[checked - 1])).norm() <= 0.000_9);
                } else {
                    assert_eq!(checked, 0, "block {line} is off");
                }
            }
        }
        assert_eq!(checked, wanted.len());
    }
    let mut config = with_lengths(Some(10.0));
    config.set_up.part_origin = [3.0, -2.0, 50.0];
    config.set_up.tools.insert(1, GivenTool { length_mm: Some(123.456), ..GivenTool::default() });
    check::<Cb>(&config, |t| cb(300.0 * t, 10.0 + 50.0 * t));
    check::<Head>(&config, |t| [0.5 * t, 0.3 * (5.0 * t).sin(), 1.0]);
    check::<Ay>(&config, |t| [0.0, 0.5 * (6.0 * t).sin(), 1.0]);
}

#[test]
fn words_in_inches_are_ten_thousandths() {
    let mut config = config();
    config.output_units = Some(Units::Inches);
    let lines = lines::<Xyz>(&config, &[tool(1), spindle(), feed([25.4, 12.7, 1.0], UP)]);
    assert!(lines[0].starts_with("N1 G20 "));
    assert_eq!(lines[7..10], ["G0 X1 Y0.5", "Z2.0079", "G1 Z0.0394 F19.685"]);
}

#[test]
fn tool_axes_just_out_of_reach_are_counted_with_the_largest() {
    let events = [
        tool(1),
        spindle(),
        feed([0.0; 3], UP),
        feed([1.0, 0.0, 0.0], [5e-7, 0.0, 1.0]),
        feed([2.0, 0.0, 0.0], [2e-7, 0.0, 1.0]),
    ];
    let run = run::<Ay>(&config(), &events);
    assert_eq!((run.diagnostics.len(), run.statistics.deviations), (0, 2));
    assert!((run.statistics.largest_deviation_rad - 5e-7).abs() < 1e-12);
}
