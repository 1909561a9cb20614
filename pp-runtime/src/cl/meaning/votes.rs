//! Check of the sense in which circles are traversed, by a vote of the lines next to them.
//!
//! The sense that follows from the form of a CIRCLE is compared with the feed lines before and after each arc. A line
//! that is tangent to the arc votes for or against that sense. A majority against it is an error; a minority may be
//! real cusps, and is a warning. So is any number of votes against a sense that a word states.

use crate::cl::vector::points_up;
use crate::nalgebra::{UnitVector3, Vector3};
use crate::program::{Arc, Location};

/// Cosine of the largest angle between a line and the tangent of an arc at which the line votes, 1 degree.
const TANGENTIAL: f64 = 0.999_847_695_156_391_3;

/// Length of the shortest line that votes; the direction of a shorter one is not reliable.
const SHORTEST_LINE_MM: f64 = 0.01;

/// Largest number of groups of arcs that vote separately; further ones share the last group.
const MOST_GROUPS: usize = 64;

/// Vote of a line at an end of an arc, `arm` from its centre: along the tangent in the sense of traversal
/// (`Some(true)`), against it (`Some(false)`), or none.
fn vote(line: Vector3<f64>, arm: Vector3<f64>, normal: &UnitVector3<f64>) -> Option<bool> {
    let tangent = normal.cross(&arm).normalize();
    let flat = line - normal.into_inner() * line.dot(normal);
    let length = flat.norm();
    if length < SHORTEST_LINE_MM {
        return None;
    }
    let cosine = flat.dot(&tangent) / length;
    (cosine.abs() >= TANGENTIAL).then_some(cosine > 0.0)
}

/// Arcs of one frame whose axes have the same sign and whose sense is stated by the form or by a word, and their votes.
#[derive(Debug, Clone, Copy)]
struct VoteGroup {
    frame: u32,
    upward: bool,
    stated: bool,
    agree: u64,
    against: u64,
    first_against: Location,
}

/// Result of the vote on the sense of the arcs of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ArcVote {
    /// Number of arcs read.
    pub arcs: u64,
    /// Number of arcs whose neighbouring lines confirm the sense.
    pub agree: u64,
    /// Number of arcs whose neighbouring lines contradict it.
    pub against: u64,
    /// The sense is given by an option, whatever the form.
    pub given: bool,
}

/// Arcs of a group whose neighbouring lines contradict the sense.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contradictions {
    /// Place of the first.
    pub(crate) first: Location,
    /// Number of these arcs.
    pub(crate) against: u64,
    /// Number of arcs with a vote.
    pub(crate) decided: u64,
    /// They are the majority, and no word states the sense.
    pub(crate) is_sense_wrong: bool,
}

/// Arcs whose votes are counted together.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ArcKind {
    /// Number of their frame.
    pub(crate) frame: u32,
    /// A word states their sense.
    pub(crate) stated: bool,
}

/// An arc whose following motion is not read yet.
#[derive(Debug, Clone, Copy)]
struct UndecidedArc {
    group: usize,
    before: Option<bool>,
    /// From the centre to the end.
    arm: Vector3<f64>,
    normal: UnitVector3<f64>,
    location: Location,
}

/// Votes of the lines of a file on the sense of its arcs.
#[derive(Debug, Default)]
pub(crate) struct ArcVotes {
    groups: Vec<VoteGroup>,
    undecided: Option<UndecidedArc>,
    arcs: u64,
}

impl ArcVotes {
    /// Adds an arc; `line`: the feed line before it.
    #[inline(always)]
    pub(crate) fn add_arc(
        &mut self,
        arc: &Arc,
        axis: &UnitVector3<f64>,
        line: Option<Vector3<f64>>,
        ArcKind { frame, stated }: ArcKind,
        at: Location,
    ) {
        self.conclude_arc(None);
        self.arcs += 1;
        let upward = points_up(axis.into_inner().into());
        let key = (frame, upward, stated);
        let known = self.groups.iter().position(|group| (group.frame, group.upward, group.stated) == key);
        let group = known.unwrap_or_else(|| {
            if self.groups.len() < MOST_GROUPS {
                let first_against = Location::default();
                self.groups.push(VoteGroup { frame, upward, stated, agree: 0, against: 0, first_against });
            }
            self.groups.len() - 1
        });
        self.undecided = Some(UndecidedArc {
            group,
            before: line.and_then(|line| vote(line, arc.start.tip - arc.centre, &arc.normal)),
            arm: arc.end.tip - arc.centre,
            normal: arc.normal,
            location: at,
        });
    }

    pub(crate) fn has_undecided(&self) -> bool {
        self.undecided.is_some()
    }

    /// Concludes the last arc with the feed line after it, or with `None` for any other record.
    #[inline]
    pub(crate) fn conclude_arc(&mut self, line: Option<Vector3<f64>>) {
        let Some(arc) = &self.undecided else { return };
        let after = line.and_then(|line| vote(line, arc.arm, &arc.normal));
        let group = &mut self.groups[arc.group];
        match (arc.before, after) {
            (Some(true), None | Some(true)) | (None, Some(true)) => group.agree += 1,
            (Some(false), None | Some(false)) | (None, Some(false)) => {
                if group.against == 0 {
                    group.first_against = arc.location;
                }
                group.against += 1;
            }
            // The lines before and after contradict each other: a cusp.
            (None, None) | (Some(true), Some(false)) | (Some(false), Some(true)) => {}
        }
        self.undecided = None;
    }

    pub(crate) fn count(&self, given: bool) -> ArcVote {
        let sum = |of: fn(&VoteGroup) -> u64| self.groups.iter().map(of).sum();
        ArcVote { arcs: self.arcs, agree: sum(|group| group.agree), against: sum(|group| group.against), given }
    }

    /// Contradictions of each group that has some.
    pub(crate) fn contradictions(&self) -> impl Iterator<Item = Contradictions> + '_ {
        self.groups.iter().filter(|group| group.against > 0).map(|group| {
            let decided = group.agree + group.against;
            Contradictions {
                first: group.first_against,
                against: group.against,
                decided,
                is_sense_wrong: 2 * group.against > decided && !group.stated,
            }
        })
    }
}
