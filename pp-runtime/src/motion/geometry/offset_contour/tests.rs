//! Contours that a tool fits into, and those that it does not.

use super::*;

fn line(start: InPlane, end: InPlane) -> ContourElement {
    ContourElement { start, end, arc: None }
}

fn arc(start: InPlane, end: InPlane, centre: InPlane, degrees: f64) -> ContourElement {
    ContourElement { start, end, arc: Some(ContourArc { centre, sweep_rad: degrees.to_radians() }) }
}

/// Offset to the left of a lead-in, elements, and a lead-out.
fn offset(left_mm: f64, elements: &[ContourElement]) -> Result<(), OffsetMisfit> {
    let [lead_in, contour @ .., lead_out] = elements else { panic!("a contour has a lead-in and a lead-out") };
    let mut offset = OffsetContour::begin(left_mm, lead_in)?;
    contour.iter().try_for_each(|element| offset.add(element))?;
    offset.end(lead_out)
}

/// An offset that is the same in all positions: reversed in direction, mirrored, and rotated.
fn offset_anyhow(left_mm: f64, elements: &[ContourElement]) -> Result<(), OffsetMisfit> {
    let found = offset(left_mm, elements);
    let with = |map: &dyn Fn(InPlane) -> InPlane, mirrors: f64| {
        let mapped: Vec<ContourElement> = elements
            .iter()
            .map(|element| ContourElement {
                start: map(element.start),
                end: map(element.end),
                arc: element.arc.map(|arc| ContourArc { centre: map(arc.centre), sweep_rad: mirrors * arc.sweep_rad }),
            })
            .collect();
        offset(mirrors * left_mm, &mapped).is_ok()
    };
    assert_eq!(with(&|[x, y]| [-x, y], -1.0), found.is_ok());
    assert_eq!(with(&|[x, y]| [900.0 + 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y], 1.0), found.is_ok());
    found
}

#[test]
fn a_slot_is_wider_than_the_tool() {
    let slot = |width: f64| {
        [
            line([-30.0, 0.0], [0.0, 0.0]),
            line([0.0, 0.0], [20.0, 0.0]),
            line([20.0, 0.0], [20.0, width]),
            line([20.0, width], [0.0, width]),
            line([0.0, width], [-30.0, width]),
        ]
    };
    assert_eq!(offset_anyhow(5.0, &slot(10.1)), Ok(()));
    let Err(OffsetMisfit::Trimmed { before: true, length_mm, trim_mm }) = offset_anyhow(5.0, &slot(9.9)) else {
        panic!("it is trimmed")
    };
    assert!((length_mm - 9.9).abs() < 1e-9 && (trim_mm - 10.0).abs() < 1e-9, "{length_mm} {trim_mm}");
    assert_eq!(offset_anyhow(-5.0, &slot(0.1)), Ok(()));
}

#[test]
fn an_arc_around_the_tool_is_larger_than_the_tool() {
    let corner = |radius: f64| {
        [
            line([-30.0, 0.0], [0.0, 0.0]),
            arc([0.0, 0.0], [radius, radius], [0.0, radius], 90.0),
            line([radius, radius], [radius, 30.0]),
        ]
    };
    assert_eq!(offset_anyhow(5.0, &corner(5.01)), Ok(()));
    assert_eq!(offset_anyhow(5.0, &corner(5.0)), Err(OffsetMisfit::InnerArc { radius_mm: 5.0 }));
    assert_eq!(offset_anyhow(-5.0, &corner(0.1)), Ok(()));
}

#[test]
fn leads_are_longer_than_the_offset() {
    let leads = |first: f64, last: f64| {
        [line([-first, 0.0], [0.0, 0.0]), line([0.0, 0.0], [9.0, 0.0]), line([9.0, 0.0], [9.0 + last, 0.0])]
    };
    assert_eq!(offset_anyhow(5.0, &leads(5.01, 5.01)), Ok(()));
    assert_eq!(offset_anyhow(5.0, &leads(5.0, 9.0)), Err(OffsetMisfit::ShortLead { length_mm: 5.0 }));
    assert_eq!(offset_anyhow(5.0, &leads(9.0, 4.0)), Err(OffsetMisfit::ShortLead { length_mm: 4.0 }));
}

#[test]
fn an_acute_lead_takes_more_than_the_offset() {
    // 135 degrees back towards the tool: 5 mm / tan 22.5 degrees = 12.071 mm.
    let acute = |length: f64| {
        let off = length * 0.5_f64.sqrt();
        [line([-30.0, 0.0], [0.0, 0.0]), line([0.0, 0.0], [20.0, 0.0]), line([20.0, 0.0], [20.0 - off, off])]
    };
    assert_eq!(offset_anyhow(5.0, &acute(12.08)), Ok(()));
    assert!(matches!(offset_anyhow(5.0, &acute(12.06)), Err(OffsetMisfit::Trimmed { before: false, .. })));
}

#[test]
fn a_line_and_an_arc_lose_what_the_tool_cannot_reach() {
    // The line meets an arc with a radius of 4 whose centre is 3 above it; the tool has a radius of 1.
    let x = 7.0_f64.sqrt();
    let offset = OffsetContour { left_mm: 1.0, straight_rad: [0.0; 2], last: None };
    let (before, after) = (line([-9.0, 0.0], [x, 0.0]), arc([x, 0.0], [0.0, 7.0], [0.0, 3.0], 139.0));
    let [line, arc] = offset
        .trims(&offset.offset(&before).expect("a line"), &offset.offset(&after).expect("an arc"))
        .expect("they meet");
    assert!((line - (7.0_f64.sqrt() - 5.0_f64.sqrt())).abs() < 1e-9, "{line}");
    let (corner, tool) = (math::atan2(3.0, x), math::atan2(2.0, 5.0_f64.sqrt()));
    assert!((arc - 3.0 * (corner - tool)).abs() < 1e-9, "{arc}");
}

#[test]
fn offsets_that_do_not_meet_are_apart() {
    let lens = |half: f64| {
        [
            line([-40.0, -9.0], [-half, 0.0]),
            arc([-half, 0.0], [half, 0.0], [0.0, half], 90.0),
            arc([half, 0.0], [-half, 0.0], [0.0, -half], 90.0),
            line([-half, 0.0], [-40.0, 9.0]),
        ]
    };
    assert_eq!(offset_anyhow(9.0, &lens(10.0)), Err(OffsetMisfit::Apart));
    assert_eq!(offset_anyhow(4.0, &lens(10.0)), Ok(()));
}

#[test]
fn a_corner_that_the_control_takes_as_straight_on_may_make_an_arc_too_long() {
    // The arc begins 2.5 degrees away from the tool: 5 mm sin 2.5 / 2 mm = 6.2 degrees before its start.
    let (sine, cosine) = math::sin_cos(-2.5_f64.to_radians());
    let centre = [-7.0 * sine, 7.0 * cosine];
    let (turned_sine, turned_cosine) = math::sin_cos(-1.0_f64.to_radians());
    let end = [centre[0] + 7.0 * turned_cosine, centre[1] + 7.0 * turned_sine];
    let sweep = 90.0 + 2.5 - 1.0;
    let contour = [
        line([-30.0, 0.0], [-9.0, 0.0]),
        line([-9.0, 0.0], [0.0, 0.0]),
        arc([0.0, 0.0], end, centre, sweep),
        line(end, [40.0, 20.0]),
    ];
    let on = |straight_rad| {
        let mut offset = OffsetContour::begin(5.0, &contour[0]).expect("a lead-in").with_straight_corners(straight_rad);
        offset.add(&contour[1])?;
        offset.add(&contour[2])?;
        offset.end(&contour[3])
    };
    assert_eq!(on([0.0; 2]), Ok(()));
    assert_eq!(on([0.05, 0.12]), Ok(()));
    assert!(matches!(on([0.05, 0.0254]), Err(OffsetMisfit::StraightCorner { .. })));
    assert_eq!(on([0.04, 0.0254]), Ok(()));
}

#[test]
fn a_full_circle_that_begins_and_ends_straight_on_keeps_all() {
    let circle =
        [line([-20.0, 0.0], [0.0, 0.0]), arc([0.0, 0.0], [0.0, 0.0], [0.0, 8.0], 360.0), line([0.0, 0.0], [20.0, 0.0])];
    assert_eq!(offset_anyhow(5.0, &circle), Ok(()));
    assert_eq!(offset_anyhow(-5.0, &circle), Ok(()));
}
