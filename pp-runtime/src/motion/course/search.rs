//! Exact search over layers of states, one layer for each pose.
//!
//! Knows no machine: states are words of rotary axes, and the caller says which of them a cut connects. Every survivor is
//! the cheapest way to its state; what it decided on the way is a chain of changes that survivors share. As soon as all of
//! them share the beginning of that chain, it is decided.

use crate::kinematics::Branch;
use crate::motion::course::packed::PackedChanges;
use crate::motion::course::{CourseAction, CourseChange};
use crate::motion::rotary::{Cost, Rotary, RotaryMetric, RotaryWords, RotationSense};

/// Chains of changes are tidied up when there are more than this, and again at twice what is left.
const COMPACT_ABOVE: usize = 4096;

/// One way for the rotary axes to hold a pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct RotaryState {
    pub(crate) branch: Branch,
    pub(crate) words: RotaryWords,
}

/// The cheapest way to a state.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Survivor {
    state: RotaryState,
    cost: Cost,
    /// Its last change.
    head: HistoryIndex,
    /// At the pole: the motion in the air that can turn the first rotary. The last that begins an operation, for it turns
    /// the axes anyhow; else the first since the rotary came free.
    air: Option<u64>,
}

/// A change in the history; nothing is the part that is decided already.
type HistoryIndex = Option<u32>;

#[derive(Debug, Clone, Copy)]
struct Node {
    parent: HistoryIndex,
    change: CourseChange,
}

/// Changes of all survivors.
#[derive(Debug, Default)]
struct History {
    nodes: Vec<Node>,
    decided: PackedChanges,
    tidy_at: usize,
}

impl History {
    fn push(&mut self, parent: HistoryIndex, motion: u64, action: CourseAction, words: RotaryWords) -> HistoryIndex {
        self.nodes.push(Node { parent, change: CourseChange { motion, action, words } });
        Some((self.nodes.len() - 1) as u32)
    }

    /// The chain of a head, oldest first.
    fn chain(&self, mut head: HistoryIndex) -> Vec<u32> {
        let mut chain = Vec::new();
        while let Some(index) = head {
            chain.push(index);
            head = self.nodes[index as usize].parent;
        }
        chain.reverse();
        chain
    }

    fn decide(&mut self, chain: &[u32]) {
        for &index in chain {
            self.decided.push(&self.nodes[index as usize].change);
        }
    }

    /// Decides what all survivors share.
    fn settle(&mut self, survivors: &mut [Survivor]) {
        let Some(first) = survivors.first().map(|survivor| survivor.head) else { return };
        if survivors.iter().all(|survivor| survivor.head == first) {
            let chain = self.chain(first);
            self.decide(&chain);
            // Also where nothing is decided: what ways given up have left behind.
            self.nodes.clear();
            survivors.iter_mut().for_each(|survivor| survivor.head = None);
        } else if self.nodes.len() > self.tidy_at.max(COMPACT_ABOVE) {
            self.tidy(survivors);
            self.tidy_at = 2 * self.nodes.len();
        }
    }

    /// Drops changes that nobody shares any more, and decides the common beginning.
    fn tidy(&mut self, survivors: &mut [Survivor]) {
        let chains: Vec<Vec<u32>> = survivors.iter().map(|survivor| self.chain(survivor.head)).collect();
        let shortest = chains.iter().map(Vec::len).min().unwrap_or(0);
        let common = (0..shortest).take_while(|&at| chains.iter().all(|chain| chain[at] == chains[0][at])).count();
        self.decide(&chains[0][..common]);
        let mut kept: Vec<u32> = chains.iter().flat_map(|chain| chain[common..].iter().copied()).collect();
        kept.sort_unstable();
        kept.dedup();
        let renamed = |old: u32| kept.binary_search(&old).ok().map(|new| new as u32);
        self.nodes = kept
            .iter()
            .map(|&index| {
                let node = self.nodes[index as usize];
                Node { parent: node.parent.and_then(renamed), ..node }
            })
            .collect();
        for (survivor, chain) in survivors.iter_mut().zip(&chains) {
            survivor.head = chain[common..].last().and_then(|&last| renamed(last));
        }
    }
}

/// Where a cut can begin: a state of the last layer.
#[derive(Debug, Clone, Copy)]
struct Predecessor {
    from: Survivor,
    /// It is reached by a rewind only.
    rewound: bool,
}

/// The search.
#[derive(Debug)]
pub(crate) struct CourseSearch {
    metric: RotaryMetric,
    /// All states of the last pose, in the order of preference; empty at the pole.
    layer: Vec<RotaryState>,
    survivors: Vec<Survivor>,
    next: Vec<Survivor>,
    sources: Vec<Predecessor>,
    history: History,
    /// Keep the cheapest alone: pose by pose.
    greedy: bool,
}

impl CourseSearch {
    pub(crate) fn new(metric: RotaryMetric, start: RotaryWords, greedy: bool) -> Self {
        Self {
            metric,
            layer: Vec::new(),
            survivors: vec![Survivor {
                state: RotaryState { branch: Branch::First, words: start },
                cost: Cost::default(),
                head: None,
                air: None,
            }],
            next: Vec::new(),
            sources: Vec::new(),
            history: History::default(),
            greedy,
        }
    }

    /// Where motion counts from before anything has moved.
    pub(crate) fn restart(&mut self, words: RotaryWords) {
        for survivor in &mut self.survivors {
            survivor.state.words = words;
        }
    }

    /// Every survivor turns to where `parked` puts it; what comes next is a motion in the air.
    pub(crate) fn park(&mut self, parked: impl Fn(&RotaryWords) -> RotaryWords) {
        self.next.clear();
        for from in &self.survivors {
            let words = parked(&from.state.words);
            let cost = from.cost.plus(self.metric.cost(&from.state.words, &words));
            Self::keep(
                &mut self.next,
                Survivor { state: RotaryState { words, ..from.state }, cost, air: None, ..*from },
            );
        }
        self.finish_layer(&[]);
    }

    /// The words from which the next motion turns least by chance: those of the cheapest survivor.
    pub(crate) fn words(&self) -> RotaryWords {
        self.survivors.iter().min_by_key(|survivor| survivor.cost).map_or([0; 2], |survivor| survivor.state.words)
    }

    /// Where the axes stand that have been rewound least; in front of a motion in the air only where the cheapest way has
    /// led, or there would be ever more.
    pub(crate) fn near(&self, air: bool, out: &mut Vec<RotaryWords>) {
        if air {
            return out.push(self.words());
        }
        let fewest = self.survivors.iter().map(|survivor| survivor.cost.rewinds).min();
        let least = self.survivors.iter().filter(|survivor| Some(survivor.cost.rewinds) == fewest);
        out.extend(least.map(|survivor| survivor.state.words));
    }

    /// The states of the last pose that a rewind can reach, in the order of preference.
    pub(crate) fn layer(&self) -> &[RotaryState] {
        &self.layer
    }

    /// The next survivors become the survivors, in a layer of these states. False, and nothing done, if there are none.
    fn finish_layer(&mut self, states: &[RotaryState]) -> bool {
        if self.next.is_empty() {
            return false;
        }
        self.layer.clear();
        self.layer.extend_from_slice(states);
        if self.greedy
            && let Some(best) = (0..self.next.len()).min_by_key(|&index| (self.next[index].cost, index))
        {
            self.next.swap(0, best);
            self.next.truncate(1);
        }
        std::mem::swap(&mut self.survivors, &mut self.next);
        self.history.settle(&mut self.survivors);
        true
    }

    fn keep(next: &mut Vec<Survivor>, survivor: Survivor) {
        match next.iter_mut().find(|known| known.state.words == survivor.state.words) {
            Some(known) if survivor.cost < known.cost => *known = survivor,
            Some(_) => {}
            None => next.push(survivor),
        }
    }

    /// A motion in the air: every state can be reached from every other, in the sense that was asked for. False, and
    /// nothing done, if that sense leads nowhere.
    pub(crate) fn free(
        &mut self,
        motion: u64,
        states: &[RotaryState],
        sense: Option<RotationSense>,
        is_preferred: impl Fn(&RotaryState) -> bool,
    ) -> bool {
        self.next.clear();
        for state in states {
            let preference = if is_preferred(state) { Cost::default() } else { Cost::AGAINST_PREFERENCE };
            let cost = |from: &Survivor| {
                let change = |axis| self.metric.change_in_sense(axis, from.state.words[axis], state.words[axis], sense);
                Some(from.cost.plus(self.metric.cost_of([change(0)?, change(1)?])).plus(preference))
            };
            let candidates = self.survivors.iter().filter_map(|from| Some((cost(from)?, from)));
            let Some((cost, from)) = candidates.min_by_key(|(cost, _)| *cost) else { continue };
            let travel = |to: &RotaryState| self.metric.cost(&from.state.words, &to.words).travel_units;
            // Without a word about it the least travel is taken; of an axis with many turns not all are looked at.
            let expected = sense.is_none()
                && self.metric.short(&from.state.words, &state.words)
                && states.iter().all(|other| other == state || travel(other) > travel(state));
            let head = match expected {
                true => from.head,
                false => self.history.push(from.head, motion, CourseAction::EndWith, state.words),
            };
            self.next.push(Survivor { state: *state, cost, head, air: None });
        }
        self.finish_layer(states)
    }

    /// A motion in the air to the pole, where the first rotary may stand anywhere; `second`: words of the other. `begins`:
    /// an operation begins with it.
    pub(crate) fn free_to_pole(
        &mut self,
        (motion, begins): (u64, bool),
        (first, second): (Rotary, &[i64]),
        sense: Option<RotationSense>,
    ) {
        self.next.clear();
        for from in &self.survivors {
            for &second in second {
                let state = RotaryState { words: [first.clamped(from.state.words[0]), second], ..from.state };
                let cost = from.cost.plus(self.metric.cost(&from.state.words, &state.words));
                let (head, air) = match state.words == from.state.words && sense.is_none() {
                    true => (from.head, from.air.filter(|_| !begins).unwrap_or(motion)),
                    // What turns the rotary must not stand in front of this in the course.
                    false => (self.history.push(from.head, motion, CourseAction::EndWith, state.words), motion),
                };
                Self::keep(&mut self.next, Survivor { state, cost, head, air: Some(air) });
            }
        }
        self.finish_layer(&[]);
    }

    /// A cut. False, and nothing done, if no state can be reached.
    pub(crate) fn cut(
        &mut self,
        motion: u64,
        states: &[RotaryState],
        via: Option<f64>,
        mut linked: impl FnMut(&RotaryState, &RotaryState) -> bool,
    ) -> bool {
        self.collect_sources();
        self.next.clear();
        for state in states {
            let mut best: Option<(Cost, Predecessor)> = None;
            for source in &self.sources {
                let cost = source.from.cost.plus(self.metric.cost(&source.from.state.words, &state.words));
                if best.is_none_or(|(least, _)| cost < least) && linked(&source.from.state, state) {
                    best = Some((cost, *source));
                }
            }
            let Some((cost, Predecessor { from, rewound })) = best else { continue };
            let mut head = from.head;
            if rewound {
                head = self.history.push(head, motion, CourseAction::Rewind, from.state.words);
            }
            if let Some(part) = via {
                head = self.history.push(head, motion, CourseAction::SplitAt(part), state.words);
            } else if from.state.branch != state.branch || !self.metric.plain(&from.state.words, &state.words) {
                head = self.history.push(head, motion, CourseAction::EndWith, state.words);
            }
            self.next.push(Survivor { state: *state, cost, head, air: None });
        }
        self.finish_layer(states)
    }

    /// The survivors, and every other state of the layer as a rewind from the cheapest place reaches it.
    fn collect_sources(&mut self) {
        self.sources.clear();
        let fewest = self.survivors.iter().map(|survivor| survivor.cost.rewinds).min();
        let settled = self.survivors.len() >= self.layer.len()
            && self.survivors.iter().all(|survivor| Some(survivor.cost.rewinds) == fewest);
        if settled {
            self.sources.extend(self.survivors.iter().map(|&from| Predecessor { from, rewound: false }));
            return;
        }
        for state in &self.layer {
            let alive = self.survivors.iter().find(|survivor| survivor.state == *state);
            let rewound =
                |from: &Survivor| from.cost.plus(self.metric.cost(&from.state.words, &state.words)).plus(Cost::REWIND);
            let other = self.survivors.iter().map(|from| (rewound(from), from)).min_by_key(|(cost, _)| *cost);
            match (alive, other) {
                (Some(&from), Some((cost, _))) if from.cost <= cost => {
                    self.sources.push(Predecessor { from, rewound: false });
                }
                (Some(&from), None) => self.sources.push(Predecessor { from, rewound: false }),
                (_, Some((cost, from))) => {
                    let from = Survivor { state: *state, cost, ..*from };
                    self.sources.push(Predecessor { from, rewound: true });
                }
                (None, None) => {}
            }
        }
    }

    /// A cut into the pole: `entry` gives the words in which a state arrives there, if it does.
    pub(crate) fn cut_to_pole(
        &mut self,
        motion: u64,
        via: Option<f64>,
        mut entry: impl FnMut(&RotaryState) -> Option<RotaryWords>,
    ) -> bool {
        self.collect_sources();
        self.next.clear();
        for Predecessor { from, rewound } in &self.sources {
            let Some(words) = entry(&from.state) else { continue };
            let cost = from.cost.plus(self.metric.cost(&from.state.words, &words));
            let mut head = from.head;
            if *rewound {
                head = self.history.push(head, motion, CourseAction::Rewind, from.state.words);
            }
            if let Some(part) = via {
                head = self.history.push(head, motion, CourseAction::SplitAt(part), words);
            } else if words[0] != from.state.words[0] || !self.metric.plain(&from.state.words, &words) {
                head = self.history.push(head, motion, CourseAction::EndWith, words);
            }
            Self::keep(&mut self.next, Survivor { state: RotaryState { words, ..from.state }, cost, head, air: None });
        }
        self.finish_layer(&[])
    }

    /// A cut out of the pole. `exits`: for each state the words in which it leaves the pole.
    pub(crate) fn leave_pole(&mut self, motion: u64, states: &[RotaryState], exits: &[Option<RotaryWords>]) -> bool {
        self.next.clear();
        for (state, exit) in states.iter().zip(exits) {
            let Some(exit) = exit else { continue };
            let cost = |from: &Survivor| {
                let turned = self.metric.cost(&from.state.words, exit);
                from.cost.plus(turned).plus(self.metric.cost(exit, &state.words))
            };
            let from = self.survivors.iter().filter(|from| self.metric.short(&[0, from.state.words[1]], &[0, exit[1]]));
            let Some(from) = from.min_by_key(|from| cost(from)) else { continue };
            let cost = cost(from);
            let mut head = from.head;
            if *exit != from.state.words {
                head = match from.air {
                    Some(air) => self.history.push(head, air, CourseAction::EndWith, *exit),
                    None => self.history.push(head, motion, CourseAction::RotateAtPole, *exit),
                };
            }
            head = self.history.push(head, motion, CourseAction::EndWith, state.words);
            self.next.push(Survivor { state: *state, cost, head, air: None });
        }
        self.finish_layer(states)
    }

    /// The cheapest way, and what it decided.
    pub(crate) fn finish(mut self) -> (Cost, PackedChanges) {
        let best = self.survivors.iter().min_by_key(|survivor| survivor.cost).copied();
        let Some(best) = best else { return (Cost::default(), self.history.decided) };
        let chain = self.history.chain(best.head);
        self.history.decide(&chain);
        (best.cost, self.history.decided)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::rotary::AngleScale;

    #[test]
    fn ways_that_are_given_up_leave_nothing_behind() {
        let rotary = Rotary { index: 0, lower: Some(-400), upper: Some(400), rest_deg: 0.0 };
        let metric = RotaryMetric::new(&[rotary], [None; 2], AngleScale { units_per_degree: 1.0, units_per_turn: 360 });
        // Pose by pose, one way is kept and one is rewound to and given up.
        let mut search = CourseSearch::new(metric, [10, 0], true);
        let states = [10, -350].map(|word| RotaryState { branch: Branch::First, words: [word, 0] });
        assert!(search.free(0, &states, None, |_| true));
        for motion in 1..10_000 {
            assert!(search.cut(motion, &states, None, |from, to| from == to));
        }
        assert!(search.history.nodes.len() < COMPACT_ABOVE, "{}", search.history.nodes.len());
        assert_eq!(search.finish().0.rewinds, 0);
    }
}
