//! Blocks between their ends: bounds that decide instead of points.

use nalgebra::Vector3;

use super::*;
use crate::check::expect::{Expect, ExpectedAction};
use crate::check::geometry::{PathShape, Segment, ToolPose};
use crate::check::read::{Action, Block, FeedMode, MAX_AXES, State};
use crate::check::rules::Rules;
use crate::cl::ClEvents;
use crate::program::Feed;

/// Numbers from -1 to 1 without an order.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.next())
    }
}

/// Random blocks: how many are decided by their bounds, of those whose F is right.
fn decided<M: Machine>() -> f64 {
    let (control, config) = configured::<M>("linuxcnc", Mode::Axes, "");
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let rules = Rules::new(Box::new(M::default()), &policy, Units::Millimetres);
    let data = "UNITS/MM\nLOAD/TOOL,2\nFEDRAT/500,MMPM\nGOTO/0,0,0,0,0,1\n";
    let events = ClEvents::here(Cursor::new(data), policy.reading.clone());
    let mut expect = Expect::new(rules.machine(), events, &policy, rules.rounding().unit_mm);
    expect.fill(1).expect("memory");
    let required = expect
        .get(0)
        .filter(|item| matches!(item.action, ExpectedAction::Motion(_)))
        .expect("a motion")
        .required
        .clone();
    let (linear, rotary) = (rules.words().linear_bits(), rules.words().rotary_bits());
    let mut noise = Noise(7);
    let (mut right, mut decided) = (0.0, 0.0);
    for turn in 0..1000 {
        let size = 10_f64.powf(2.0 * noise.next() - 1.0);
        let mut words = [[0.0; MAX_AXES]; 2];
        let [first, last] = &mut words;
        for (index, (from, to)) in first.iter_mut().zip(last).enumerate() {
            let (place, step) = match 1 << index {
                bit if linear & bit != 0 => (200.0, size),
                bit if rotary & bit != 0 => (2.0, 0.03 * size),
                _ => (0.0, 0.0),
            };
            *from = place * noise.next();
            *to = *from + step * noise.next();
        }
        let mut block = Block { action: Action::Feed, values: words[1], ..Block::default() };
        let ends = words.map(|words| rules.pose_from(&words, &block));
        let rounding = *rules.rounding();
        let motion = ends.map(|end| {
            let axis = (end.axis + noise.vector() * 0.5 * rounding.axis_rad).normalize();
            ToolPose { tip: end.tip + noise.vector() * 0.5 * rounding.tip_mm, axis }
        });
        let segment = Segment { from: motion[0], to: motion[1], shape: PathShape::Line };
        let path = rules.path(words[0], &block);
        let ends = [&ends[0], &ends[1]];
        let bound = |enough_mm: f64| {
            rules.deviation_bound([&words[0], &words[1]], ends, [&segment.from, &segment.to], enough_mm)
        };
        let (bound, rough) = (bound(0.0), bound(f64::INFINITY));
        let measured = rules.deviation(&path, ends, &segment, 0.0).expect("it rotates");
        assert!(measured.tip_mm <= bound.tip_mm + 1e-12, "{turn}: {measured:?} {bound:?}");
        assert!(bound.tip_mm <= rough.tip_mm + 1e-12, "{turn}: {bound:?} {rough:?}");
        assert!(measured.axis_rad <= bound.axis_rad + 1e-12, "{turn}: {measured:?} {bound:?}");
        assert!(measured.tip_rate_mm <= bound.tip_rate_mm + 1e-12, "{turn}: {measured:?} {bound:?}");

        let lengths = (segment.length_between(ends.map(|end| &end.tip)), segment.length());
        let feed = Some(Feed::PerMinute(500.0));
        let stroke =
            |deviation| rules.stroke(&words[0], &block, lengths, feed, &required).with_tip_rate(deviation, &required);
        let (even, followed) = (stroke(None), stroke(Some(&measured)));
        for part in -40..=40 {
            let written = Some(500.0 / lengths.0 * (1.0 + 0.001 * f64::from(part)));
            block.state = State { feed: written, feed_mode: Some(FeedMode::InverseTime), ..State::default() };
            let fault = rules.feed_fault(&followed, &block.state, &segment, [0.0, 1.0]);
            let plainly = rules.is_feed_plainly_right(&even, &block.state, bound.tip_rate_mm, &required);
            assert!(!plainly || fault.is_none(), "{turn}: {written:?} {fault:?}");
            right += f64::from(u8::from(fault.is_none()));
            decided += f64::from(u8::from(plainly));
        }
    }
    decided / right
}

#[test]
fn bounds_of_a_block_are_never_below_what_its_points_show_and_decide_no_f_that_they_would_refuse() {
    let shares = [decided::<Tables>(), decided::<HeadTable>(), decided::<TwoInHead>()];
    assert!(shares.iter().all(|share| *share > 0.3), "{shares:?}");
}
