//! What the motions of machines cut, against dense sampling of their forward kinematics.

use nalgebra::Point3;

use super::machining::{CertifiedCourse, MOST_HALVINGS, PATH_MM, divide};
use crate::kinematics::{AnyMachine, AxisKind, AxisValues, Pose, StepBound};
use crate::simulate::removal::{Profile, SweptPiece, TriDexel};
use crate::simulate::testing::{CUTTERS, EPS, Random, machines, places, rounds};
use crate::view::ExecutedPlace;

/// Half the box of the stock, mm.
const HALF: f64 = 6.0;

/// A block in which all axes arrive together.
struct Block<'m> {
    machine: &'m dyn AnyMachine,
    ends: [AxisValues; 2],
}

impl Block<'_> {
    fn pose(&self, share: f64) -> (AxisValues, Pose) {
        let [from, to] = &self.ends;
        let axes = std::array::from_fn(|index| from[index] + share * (to[index] - from[index]));
        (axes, self.machine.forward_kinematics(&axes))
    }

    fn place(&self, share: f64) -> ExecutedPlace {
        let (axes, pose) = self.pose(share);
        ExecutedPlace { axes, pose }
    }
}

impl CertifiedCourse for Block<'_> {
    fn at(&self, share: f64, _near: &ExecutedPlace) -> ExecutedPlace {
        self.place(share)
    }

    fn step_bound(&self, _shares: [f64; 2], [from, to]: [&ExecutedPlace; 2]) -> StepBound {
        StepBound::of(self.machine, &from.axes, &to.axes)
    }
}

/// A block that takes the tool through about the middle of the stock. `None`: the linear axes do not reach it.
fn block<'m>(machine: &'m dyn AnyMachine, random: &mut Random) -> Option<Block<'m>> {
    let mut rotary = [machine.held(); 2];
    for (index, axis) in machine.axes().iter().enumerate().filter(|(_, axis)| !axis.held) {
        if axis.kind == AxisKind::Rotary {
            rotary[0][index] = random.within(1.2);
            rotary[1][index] = rotary[0][index] + random.within(0.35);
        }
    }
    let mut tip = Point3::from(random.direction() * 5.0);
    let mut ends = [[0.0; 9]; 2];
    for (end, values) in ends.iter_mut().zip(&rotary) {
        *end = machine.linear_axes(&tip, values)?;
        tip += random.direction() * 6.0;
    }
    Some(Block { machine, ends })
}

/// Distances of points from a tool on its path.
struct Samples<'b> {
    block: &'b Block<'b>,
    profiles: &'b [Profile],
    poses: Vec<Pose>,
}

impl Samples<'_> {
    fn distance(&self, pose: &Pose, point: [f64; 3]) -> f64 {
        let from_tip = Point3::from(point) - pose.tip;
        let height = from_tip.dot(&pose.axis);
        let radius = from_tip.cross(&pose.axis).norm();
        self.profiles.iter().map(|profile| profile.distance(radius, height).0).fold(f64::INFINITY, f64::min)
    }

    /// The least one: of all places, then by thirds around the nearest ones.
    fn least(&self, point: [f64; 3]) -> f64 {
        let last = self.poses.len() - 1;
        let values: Vec<f64> = self.poses.iter().map(|pose| self.distance(pose, point)).collect();
        let mut least = f64::INFINITY;
        for (place, value) in values.iter().enumerate() {
            least = least.min(*value);
            let lowest = (place == 0 || values[place - 1] >= *value) && (place == last || values[place + 1] >= *value);
            if lowest && *value < 0.2 {
                let share = |place: f64| (place / last as f64).clamp(0.0, 1.0);
                let (mut low, mut high) = (share(place as f64 - 1.0), share(place as f64 + 1.0));
                let at = |share: f64| self.distance(&self.block.pose(share).1, point);
                for _ in 0..30 {
                    let third = (high - low) / 3.0;
                    if at(low + third) < at(high - third) { high -= third } else { low += third }
                }
                least = least.min(at(f64::midpoint(low, high)));
            }
        }
        least
    }
}

#[test]
fn what_blocks_of_four_machines_cut_is_within_the_stated_bound_of_their_motion() {
    let mut random = Random(19);
    let (mut ends, mut curved): (usize, f64) = (0, 0.0);
    for (number, machine) in machines().iter().enumerate() {
        for round in 0..rounds(400).div_ceil(100) {
            let Some(block) = block(&**machine, &mut random) else { panic!("machine {number}") };
            let cutter = CUTTERS[(round + 2 * number) % CUTTERS.len()];
            let profiles = cutter.pieces().expect("a tool");
            let reach = profiles.iter().map(|profile| profile.reach).fold(0.0, f64::max);
            let (mut pieces, mut deviation_mm): (Vec<SweptPiece>, f64) = (Vec::new(), 0.0);
            let whole = [(0.0, block.place(0.0)), (1.0, block.place(1.0))];
            curved = curved.max(block.step_bound([0.0, 1.0], [&whole[0].1, &whole[1].1]).tip);
            divide(&block, reach, whole, MOST_HALVINGS, &mut |[from, to], deviation| {
                deviation_mm = deviation_mm.max(deviation);
                for profile in 0..profiles.len() {
                    pieces.push(SweptPiece::new(&from.1.pose, &to.1.pose, profile as u32, 1));
                }
            });
            assert!(deviation_mm <= PATH_MM, "{deviation_mm}");
            let mut stock = TriDexel::block([[-HALF; 3], [HALF; 3]], 0.7).expect("a stock");
            stock.cut(&pieces, &profiles, EPS, 1);
            assert_eq!(stock.effort().uncertified, 0);
            let count = places(60);
            let poses = (0..=count).map(|place| block.pose(f64::from(place) / f64::from(count)).1).collect();
            let samples = Samples { block: &block, profiles: &profiles, poses };
            let bound = EPS + deviation_mm;
            for family in 0..3 {
                let mut lines = Vec::new();
                stock.each(family, |across, spans| lines.push((across, spans.to_vec())));
                for (line, (across, spans)) in lines.iter().enumerate().filter(|(line, _)| line % 11 == round % 11) {
                    let about = format!("machine {number}, round {round}, family {family}, line {line}, {cutter:?}");
                    let at = |along: f64| {
                        let mut point = [0.0; 3];
                        (point[family], point[(family + 1) % 3], point[(family + 2) % 3]) =
                            (along, across[0], across[1]);
                        point
                    };
                    for (end, id) in spans.iter().flat_map(|span| [(span.low, span.low_id), (span.high, span.high_id)])
                    {
                        let distance = samples.least(at(f64::from(end)));
                        assert!(id == 0 || distance <= bound, "{about}: {distance} mm outside, bound {bound}");
                        assert!(distance >= -bound, "{about}: {distance} mm inside, bound {bound}");
                        ends += usize::from(id > 0);
                    }
                    let along = random.within(HALF);
                    let distance = samples.least(at(along));
                    let kept = spans.iter().any(|span| f64::from(span.low) <= along && along <= f64::from(span.high));
                    assert!(if kept { distance > -bound } else { distance < bound }, "{about}: {kept} {distance}");
                }
            }
        }
    }
    println!("{ends} ends");
    assert!(ends > 150 && curved > 20.0 * PATH_MM, "{ends} {curved}");
}
