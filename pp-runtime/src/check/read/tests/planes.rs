//! Tilted planes: each control rotates in its order.

use super::*;

fn column(tilt: &Tilt, index: usize) -> [f64; 3] {
    tilt.rotation.column(index).into_owned().into()
}

/// HEIDENHAIN TNC 620 user's manual 10/2017, page 540: `PLANE SPATIAL SPA+45 SPB+0 SPC+90` is A+45, B+0, C+90 about the
/// axes that stay, and C+90, B+0, A+45 about those that turn: both leave the new X along the old Y, and the new Z
/// leaning by 45 degrees towards the old X.
#[test]
fn plane_spatial_is_that_of_the_manual() {
    let block =
        last(Family::Heidenhain, &format!("{TNC}2 PLANE SPATIAL SPA+45 SPB+0 SPC+90 TURN MB MAX FMAX SEQ- TABLE ROT"));
    let (plane, half) = (tilt(&block), 0.5_f64.sqrt());
    assert!(near(column(&plane, 0), [0.0, 1.0, 0.0]), "{plane:?}");
    assert!(near(column(&plane, 2), [half, 0.0, half]), "{plane:?}");
    assert_eq!(block.action, Action::Orient);
    assert!(plane.oriented);
}

/// G68.2 turns about Z by I, about the new X by J, about the new Z by K: with I 90 and J 45 the new X is the old Y, and
/// the new Z leans towards the old X; K turns X and Y in the plane.
#[test]
fn g68_2_turns_about_z_x_z_as_they_go_along() {
    let text = format!("{}G68.2 X1. Y2. Z3. I90. J45. K0.\nG53.1", LINUXCNC.replace(" G64 P0.01", ""));
    let (plane, half) = (tilt(&last(Family::Fanuc, &text)), 0.5_f64.sqrt());
    assert!(near(column(&plane, 0), [0.0, 1.0, 0.0]) && near(column(&plane, 2), [half, 0.0, half]), "{plane:?}");
    assert!(plane.oriented && near(plane.origin.into(), [1.0, 2.0, 3.0]));
    let turned = tilt(&last(Family::Fanuc, &text.replace("K0.", "K90.")));
    assert!(near(column(&turned, 0), [-half, 0.0, half]), "{turned:?}");
}

/// CYCLE800 axis by axis: mode 57 is X, new Y, new Z (its bits 01, 10, 11 name the axes of A, B and C in this order),
/// 27 is Z, new Y, new X.
#[test]
fn cycle800_turns_in_the_order_of_its_mode() {
    let plane = |mode: u32, angles: &str| {
        tilt(&last(Family::Siemens, &format!("{SIEMENS}CYCLE800(0,\"TC\",0,{mode},1,0,0,{angles},0,0,5,-1,0)")))
    };
    let half = 0.5_f64.sqrt();
    // X by 90 puts the new Y along Z; the new Y then turns Z from -Y towards X.
    let moving = plane(57, "90,45,0");
    assert!(near(column(&moving, 2), [half, -half, 0.0]), "{moving:?}");
    // Z by 90, then the new Y, which is -X.
    let backwards = plane(27, "90,45,0");
    assert!(near(column(&backwards, 2), [0.0, half, half]), "{backwards:?}");
    assert!(near(moving.origin.into(), [1.0 + 5.0 * half, -5.0 * half, 0.0]), "{moving:?}");
    assert!(moving.oriented);
}
