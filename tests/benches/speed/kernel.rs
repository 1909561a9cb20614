//! The kinematics of a table C on B, written by hand as fast as its author could: what the generated functions are
//! compared with. Axes in the order C B X Y Z; `d` is the height of both centre lines above the table.

use pp_runtime::kinematics::Pose;

type Axes = [f64; 5];

/// Linear axes for the sines and cosines of both angles.
#[inline]
fn linear(d: f64, pose: &Pose, [sc, cc, sb, cb]: [f64; 4]) -> [f64; 3] {
    let tip = &pose.tip;
    let across = tip.x * cc + tip.y * sc;
    let above = tip.z - d;
    [across * cb - above * sb, tip.y * cc - tip.x * sc, across * sb + above * cb + d]
}

/// Sines and cosines of the first branch: C, B.
#[inline]
fn directions(pose: &Pose) -> [f64; 4] {
    let (i, j, k) = (pose.axis.x, pose.axis.y, pose.axis.z);
    let sb = (i * i + j * j).sqrt();
    let reciprocal = 1.0 / sb;
    [j * reciprocal, i * reciprocal, sb, k]
}

/// The branch with B above zero.
#[inline]
pub(crate) fn one(d: f64, pose: &Pose) -> Axes {
    let directions @ [_, _, sb, cb] = directions(pose);
    let [x, y, z] = linear(d, pose, directions);
    [pose.axis.y.atan2(pose.axis.x), sb.atan2(cb), x, y, z]
}

/// Both branches.
#[inline]
pub(crate) fn both(d: f64, pose: &Pose) -> [Axes; 2] {
    let directions @ [_, _, sb, cb] = directions(pose);
    let [x, y, z] = linear(d, pose, directions);
    let b = sb.atan2(cb);
    [[pose.axis.y.atan2(pose.axis.x), b, x, y, z], [(-pose.axis.y).atan2(-pose.axis.x), -b, -x, -y, z]]
}

/// As the papers print it: angles first, then their sines and cosines.
#[inline]
pub(crate) fn trigonometric(d: f64, pose: &Pose) -> Axes {
    let (c, b) = (pose.axis.y.atan2(pose.axis.x), pose.axis.z.acos());
    let ((sc, cc), (sb, cb)) = (c.sin_cos(), b.sin_cos());
    let [x, y, z] = linear(d, pose, [sc, cc, sb, cb]);
    [c, b, x, y, z]
}

/// Tip and tool axis.
#[inline]
pub(crate) fn forward(d: f64, &[c, b, x, y, z]: &Axes) -> [f64; 6] {
    let ((sc, cc), (sb, cb)) = (c.sin_cos(), b.sin_cos());
    let across = x * cb + (z - d) * sb;
    let above = (z - d) * cb - x * sb;
    [across * cc - y * sc, across * sc + y * cc, above + d, sb * cc, sb * sc, cb]
}
