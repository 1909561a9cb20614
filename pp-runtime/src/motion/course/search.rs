//! Exact search over layers of states, one layer for each pose.
//!
//! Independent of the machine: states are words of rotary axes, and the caller decides which of them a cut connects.
//! Every survivor is the cheapest course to its state; its decisions are a chain of changes, whose beginnings survivors
//! share. A beginning that all of them share is final.

use crate::kinematics::math::smaller;
use crate::kinematics::{Branch, Rotary};
use crate::motion::course::packed::PackedChanges;
use crate::motion::course::{CourseAction, CourseChange};
use crate::motion::rotary::{Cost, RotaryMetric, RotaryWords, RotationSense};
use crate::shortcut::Shortcut;
use crate::tolerance::writer::SAME_WORD_AFTER_POLE;

/// Number of changes above which chains are compacted for the first time; then at twice the number that was left.
const COMPACT_ABOVE: usize = 4096;

/// Largest size of the changes of a course: some two million.
const MOST_BYTES: usize = 16 << 20;

/// Branch and rotary words of a pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct RotaryState {
    pub(crate) branch: Branch,
    pub(crate) words: RotaryWords,
}

/// Order of the turns of a branch: those nearest to zero first, positive before negative.
pub(crate) fn preference(words: &RotaryWords) -> (i64, RotaryWords) {
    (words[0].abs() + words[1].abs(), [-words[0], -words[1]])
}

/// The cheapest course to a state.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Survivor {
    state: RotaryState,
    cost: Cost,
    /// Its last change.
    last_change: HistoryIndex,
    /// At the pole: number of the motion in the air that can rotate the first rotary axis. The last that begins an
    /// operation, which rotates the axes anyway; else the first since the axis became free.
    air: Option<u64>,
    /// That motion begins an operation, or rotates the axes anyway: the first rotary axis can be at zero after it.
    zeroable: bool,
}

impl Survivor {
    /// The course to a state without a change.
    fn followed(&self, metric: &RotaryMetric, state: &RotaryState) -> Self {
        let cost = self.cost.plus(metric.cost(&self.state.words, &state.words));
        Self { state: *state, cost, last_change: self.last_change, air: None, zeroable: false }
    }
}

/// Index of a change in the history; `None` before the first change that is not final.
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
    /// Final changes: all survivors share them.
    decided: PackedChanges,
    /// Number of nodes above which the history is compacted.
    compact_above: usize,
    /// Only the cost of the course is asked for.
    forgets: bool,
}

impl History {
    fn push(&mut self, parent: HistoryIndex, motion: u64, action: CourseAction, words: RotaryWords) -> HistoryIndex {
        self.nodes.push(Node { parent, change: CourseChange { motion, action, words } });
        Some((self.nodes.len() - 1) as u32)
    }

    /// The chain that ends with a change, oldest first.
    fn chain(&self, mut last_change: HistoryIndex) -> Vec<u32> {
        let mut chain = Vec::new();
        while let Some(index) = last_change {
            chain.push(index);
            last_change = self.nodes[index as usize].parent;
        }
        chain.reverse();
        chain
    }

    /// Bytes of all changes.
    fn size(&self) -> usize {
        self.decided.size() + self.nodes.len() * size_of::<Node>()
    }

    fn decide(&mut self, chain: &[u32]) {
        if self.forgets {
            return;
        }
        for &index in chain {
            self.decided.push(&self.nodes[index as usize].change);
        }
    }

    /// Makes final the changes that all survivors share.
    fn settle(&mut self, survivors: &mut [Survivor]) {
        let Some(first) = survivors.first().map(|survivor| survivor.last_change) else { return };
        if survivors.iter().all(|survivor| survivor.last_change == first) {
            let chain = self.chain(first);
            self.decide(&chain);
            // Also if no change became final: this drops the changes of abandoned courses.
            self.nodes.clear();
            survivors.iter_mut().for_each(|survivor| survivor.last_change = None);
        } else if self.nodes.len() > self.compact_above.max(COMPACT_ABOVE) {
            self.compact(survivors);
            self.compact_above = 2 * self.nodes.len();
        }
    }

    /// Drops changes of abandoned courses, and makes the common beginning final.
    fn compact(&mut self, survivors: &mut [Survivor]) {
        let chains: Vec<Vec<u32>> = survivors.iter().map(|survivor| self.chain(survivor.last_change)).collect();
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
            survivor.last_change = chain[common..].last().and_then(|&last| renamed(last));
        }
    }
}

/// A state of the last layer at which a cut can begin.
#[derive(Debug, Clone, Copy)]
struct Predecessor {
    from: Survivor,
    /// A rewind is needed to reach this state.
    rewound: bool,
}

/// In a run of cuts, a state of the branch with more rewinds.
#[derive(Debug, Clone, Copy)]
struct WithMoreRewinds {
    /// Index of its survivor.
    survivor: usize,
    /// Cost of the rotation of its branch from where the run began up to the last pose at which rewinds were compared.
    sum: Cost,
    rewind: Option<RunRewind>,
}

/// A rewind in a run of cuts that has led cheaper to a state than its own course.
#[derive(Debug, Clone, Copy)]
struct RunRewind {
    /// Last change of the course that rewinds.
    last_change: HistoryIndex,
    motion: u64,
    /// Words after the rewind.
    words: RotaryWords,
}

/// A state from which axes may be rewound in a run of cuts.
#[derive(Debug, Clone, Copy)]
struct RewindStart {
    /// Cost of the course to it, with a rewind.
    cost: Cost,
    words: RotaryWords,
    last_change: HistoryIndex,
}

/// The search for the cheapest course.
#[derive(Debug)]
pub(crate) struct CourseSearch {
    metric: RotaryMetric,
    /// All states of the last pose, in the order of preference; empty at the pole.
    layer: Vec<RotaryState>,
    /// Those that are reached. In a run of cuts their states are those with which it began, and their costs, too; but
    /// that of a state [with more rewinds](WithMoreRewinds) is up to the pose at which rewinds were last compared.
    survivors: Vec<Survivor>,
    next: Vec<Survivor>,
    predecessors: Vec<Predecessor>,
    /// Indices of the survivors from which a motion in the air may be the cheapest, row by row.
    starts: Vec<usize>,
    /// Number of starts up to the end of each row.
    row_ends: Vec<usize>,
    /// States of the branch with more rewinds in the present run, in the order of their survivors.
    with_more_rewinds: Vec<WithMoreRewinds>,
    /// Those from which they may be reached by a rewind.
    rewind_starts: Vec<RewindStart>,
    history: History,
    /// Only the cheapest survivor is kept: the search is made motion by motion.
    greedy: bool,
    /// The first rotary axis, where another can follow the tool axis.
    free: Option<Rotary>,
    /// It is at zero where it is free from one motion in the air to the next.
    zeroes: bool,
    /// The control finds the rotary angles: where an axis is free it takes the nearest.
    by_control: bool,
}

impl CourseSearch {
    pub(crate) fn new(metric: RotaryMetric, free: Option<Rotary>, zeroes: bool, greedy: bool) -> Self {
        Self {
            metric,
            free,
            zeroes,
            layer: Vec::new(),
            survivors: vec![Survivor {
                state: RotaryState { branch: Branch::First, words: [0; 2] },
                cost: Cost::default(),
                last_change: None,
                air: None,
                zeroable: false,
            }],
            next: Vec::new(),
            predecessors: Vec::new(),
            starts: Vec::new(),
            row_ends: Vec::new(),
            with_more_rewinds: Vec::new(),
            rewind_starts: Vec::new(),
            history: History::default(),
            greedy,
            by_control: false,
        }
    }

    /// Keeps the cost of the course alone.
    pub(crate) fn forget_changes(&mut self) {
        self.history.forgets = true;
    }

    /// Whether the changes of the course take more memory than a program may.
    pub(crate) fn is_too_long(&self) -> bool {
        self.size() > MOST_BYTES
    }

    /// Bytes of the changes of the course.
    pub(crate) fn size(&self) -> usize {
        self.history.size()
    }

    /// Sets whether the control finds the rotary angles of the cuts that come.
    pub(crate) fn set_by_control(&mut self, by_control: bool) {
        self.by_control = by_control;
    }

    /// Sets whether a free axis is at zero from the next motion on.
    pub(crate) fn set_zeroes(&mut self, zeroes: bool) {
        if zeroes != self.zeroes {
            self.leave_zeroed();
            self.zeroes = zeroes;
            // The next stretch does not decide about this one any more.
            self.survivors.iter_mut().for_each(|survivor| (survivor.air, survivor.zeroable) = (None, false));
        }
    }

    /// Sets the start words before the first motion.
    pub(crate) fn restart(&mut self, words: RotaryWords) {
        for survivor in &mut self.survivors {
            survivor.state.words = words;
        }
    }

    /// Moves every survivor to its parked words; the next motion is in the air.
    pub(crate) fn park(&mut self, parked: impl Fn(&RotaryWords) -> RotaryWords) {
        self.leave_zeroed();
        self.next.clear();
        for from in &self.survivors {
            let words = parked(&from.state.words);
            let cost = from.cost.plus(self.metric.cost(&from.state.words, &words));
            Self::keep(
                &mut self.next,
                Survivor { state: RotaryState { words, ..from.state }, cost, air: None, zeroable: false, ..*from },
            );
        }
        self.finish_layer(&[]);
    }

    /// A stretch at the pole ends in the air: the free axis was at zero in it, or whole turns from zero.
    fn leave_zeroed(&mut self) {
        let Some(first) = self.free.filter(|_| self.zeroes) else { return };
        for index in 0..self.survivors.len() {
            let Survivor { state, cost, last_change, air: Some(air), zeroable: true } = self.survivors[index] else {
                continue;
            };
            let Some(zero) = self.metric.nearest_zero(&first, state.words[0]).filter(|zero| *zero != state.words[0])
            else {
                continue;
            };
            let words = [zero, state.words[1]];
            self.survivors[index] = Survivor {
                state: RotaryState { words, ..state },
                cost: cost.plus(self.metric.cost(&state.words, &words)),
                last_change: self.history.push(last_change, air, CourseAction::EndWith, words),
                air: None,
                zeroable: false,
            };
        }
    }

    /// Words of the cheapest survivor.
    pub(crate) fn words(&self) -> RotaryWords {
        self.survivors.iter().min_by_key(|survivor| survivor.cost).map_or([0; 2], |survivor| survivor.state.words)
    }

    /// Adds the words of the survivors with the fewest rewinds; before a motion in the air only those of the cheapest
    /// survivor, or their number would grow without bound.
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

    /// Makes the next survivors the present ones, in a layer of these states. Returns false, and changes nothing, if
    /// there are none.
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

    /// Adds a survivor unless one with the same words is as cheap.
    fn keep(next: &mut Vec<Survivor>, survivor: Survivor) {
        match next.iter_mut().find(|known| known.state.words == survivor.state.words) {
            Some(known) if survivor.cost < known.cost => *known = survivor,
            Some(_) => {}
            None => next.push(survivor),
        }
    }

    /// Takes a motion in the air: every state can be reached from every other, in the programmed sense of rotation.
    /// Returns false, and changes nothing, if no state can be reached in that sense.
    pub(crate) fn free(
        &mut self,
        motion: u64,
        states: &[RotaryState],
        sense: Option<RotationSense>,
        is_preferred: impl Fn(&RotaryState) -> bool,
    ) -> bool {
        self.leave_zeroed();
        self.next.clear();
        self.collect_starts(sense);
        let one_branch = states.iter().all(|state| state.branch == states[0].branch);
        for state in states {
            let preference = if is_preferred(state) { Cost::default() } else { Cost::AGAINST_PREFERENCE };
            let Some((cost, from)) = self.cheapest_start(&state.words, sense) else { continue };
            let cost = cost.plus(preference);
            let travel = |to: &RotaryState| self.metric.cost(&from.state.words, &to.words).travel_units;
            // Without a change the planner takes the least travel; of an axis with many turns not all are among the
            // states. Less than half a turn is less than with any other turns of its branch.
            let is_least = self.metric.shorter_than_half_turns(&from.state.words, &state.words);
            let farther =
                |other: &RotaryState| is_least && other.branch == state.branch || travel(other) > travel(state);
            let expected = sense.is_none()
                && (is_least && one_branch
                    || self.metric.short(&from.state.words, &state.words)
                        && states.iter().all(|other| other == state || farther(other)));
            let last_change = match expected {
                true => from.last_change,
                false => self.history.push(from.last_change, motion, CourseAction::EndWith, state.words),
            };
            self.next.push(Survivor { state: *state, cost, last_change, air: None, zeroable: false });
        }
        self.finish_layer(states)
    }

    /// Collects the survivors from which a motion in the air may be the cheapest, in rows: those with the same word of
    /// the second axis, in the order of the first, each with a cheaper course than by a rotation from another one of
    /// its row. If the cost is the travel, which adds up along a row, then from no start of a row a motion is cheaper
    /// than from the nearest ones. A programmed sense of rotation may not allow those; there, and with times, each
    /// start is a row.
    fn collect_starts(&mut self, sense: Option<RotationSense>) {
        let Self { survivors, starts, row_ends, metric, .. } = self;
        starts.clear();
        row_ends.clear();
        starts.extend(0..survivors.len());
        if sense.is_some() || !metric.adds_up_along_first_axis() {
            row_ends.extend(1..=survivors.len());
            return;
        }
        let words = |index: usize| survivors[index].state.words;
        let leads_to = |from: usize, to: usize| {
            let cost = survivors[from].cost.plus(metric.cost(&words(from), &words(to)));
            // Of equal courses that of the first survivor is taken.
            (cost, from) < (survivors[to].cost, to)
        };
        starts.sort_unstable_by_key(|&index| [words(index)[1], words(index)[0]]);
        let (mut first, mut kept) = (0, 0);
        for place in 0..starts.len() {
            let start = starts[place];
            if kept > first && words(starts[first])[1] != words(start)[1] {
                row_ends.push(kept);
                first = kept;
            }
            if kept > first && leads_to(starts[kept - 1], start) {
                continue;
            }
            while kept > first && leads_to(start, starts[kept - 1]) {
                kept -= 1;
            }
            starts[kept] = start;
            kept += 1;
        }
        starts.truncate(kept);
        row_ends.push(kept);
    }

    /// The first of the cheapest starts of a motion in the air to these words, and the cost with its rotation.
    fn cheapest_start(&self, words: &RotaryWords, sense: Option<RotationSense>) -> Option<(Cost, &Survivor)> {
        let mut cheapest: Option<(Cost, usize)> = None;
        let mut first = 0;
        for &end in &self.row_ends {
            let row = &self.starts[first..end];
            first = end;
            let below = row.partition_point(|&index| self.survivors[index].state.words[0] < words[0]);
            for &index in &row[below.saturating_sub(1)..row.len().min(below + 1)] {
                let from = &self.survivors[index];
                let change =
                    |axis: usize| self.metric.change_in_sense(axis, from.state.words[axis], words[axis], sense);
                let rotation = match sense {
                    None => self.metric.cost(&from.state.words, words),
                    Some(_) => match (change(0), change(1)) {
                        (Some(first), Some(second)) => self.metric.cost_of([first, second]),
                        _ => continue,
                    },
                };
                let found = (from.cost.plus(rotation), index);
                if cheapest.is_none_or(|cheapest| found < cheapest) {
                    cheapest = Some(found);
                }
            }
        }
        cheapest.map(|(cost, index)| (cost, &self.survivors[index]))
    }

    /// Takes a motion in the air to the pole, where the angle of the first rotary axis is free; `second`: words of the
    /// other axis. `begins`: an operation begins with the motion.
    pub(crate) fn free_to_pole(
        &mut self,
        motion: u64,
        begins: bool,
        first: Rotary,
        second: &[i64],
        sense: Option<RotationSense>,
    ) {
        if begins {
            self.leave_zeroed();
        }
        self.next.clear();
        for from in &self.survivors {
            for &second in second {
                let state = RotaryState { words: [first.clamped(from.state.words[0]), second], ..from.state };
                let cost = from.cost.plus(self.metric.cost(&from.state.words, &state.words));
                let stays = state.words == from.state.words && sense.is_none();
                let zeroable = begins || !stays || from.zeroable;
                let (last_change, air) = match stays {
                    true => (from.last_change, from.air.filter(|_| !begins).unwrap_or(motion)),
                    // The change that rotates the axis must not come before this one in the course.
                    false => (self.history.push(from.last_change, motion, CourseAction::EndWith, state.words), motion),
                };
                Self::keep(&mut self.next, Survivor { state, cost, last_change, air: Some(air), zeroable });
            }
        }
        self.finish_layer(&[]);
    }

    /// Whether the last motion that changed the survivors was one in the air to the pole: see
    /// [`free_to_pole`](Self::free_to_pole).
    pub(crate) fn is_free_at_pole(&self) -> bool {
        self.survivors.iter().all(|survivor| survivor.air.is_some())
    }

    /// Takes a cut in which every state of the last pose rotates by less than 90° to the state of its branch and turn,
    /// so that no other state of the branch leads there. Returns false, and changes nothing, elsewhere.
    ///
    /// The result is that of [`cut`](Self::cut): where the branches are merged, all states are of the first one.
    pub(crate) fn follow(&mut self, motion: u64, states: &[RotaryState]) -> bool {
        if !Shortcut::StatesFollowed.is_on() || !self.rotates_plainly(states) {
            return false;
        }
        if self.greedy && self.survivors.len() == 1 {
            // The others would be reached by a rewind.
            let survivor = &mut self.survivors[0];
            let Some(index) = self.layer.iter().position(|last| *last == survivor.state) else { return false };
            *survivor = survivor.followed(&self.metric, &states[index]);
            self.layer.copy_from_slice(states);
            return true;
        }
        self.collect_predecessors();
        let same = |(source, last): (&Predecessor, &RotaryState)| source.from.state == *last;
        if self.predecessors.len() != states.len() || !self.predecessors.iter().zip(&self.layer).all(same) {
            return false;
        }
        self.next.clear();
        for (Predecessor { from, rewound }, state) in self.predecessors.iter().zip(states) {
            let mut survivor = from.followed(&self.metric, state);
            if *rewound {
                let words = from.state.words;
                survivor.last_change = self.history.push(from.last_change, motion, CourseAction::Rewind, words);
            }
            self.next.push(survivor);
        }
        self.finish_layer(states)
    }

    /// Begins a run of cuts in which branches and turns of the states stay the same. False if some state of the last
    /// pose may not be the beginning of the course to the same state, rotated, of the next one.
    ///
    /// A course begins elsewhere only after a rewind. From another turn of its branch that is as much cheaper or dearer
    /// in every cut as in the first. From the other branch, where that one has fewer rewinds, it may be cheaper in some
    /// cut: with `compares` a run may begin there too, in which the two are [compared](Self::compare_rewinds).
    pub(crate) fn begin_run(&mut self, compares: bool) -> bool {
        self.with_more_rewinds.clear();
        if self.layer.is_empty() {
            return false;
        }
        if self.greedy && self.survivors.len() == 1 {
            return self.layer.contains(&self.survivors[0].state);
        }
        self.collect_predecessors();
        let fewest = self.survivors.iter().map(|survivor| survivor.cost.rewinds).min();
        let has_fewest = |survivor: &Survivor| Some(survivor.cost.rewinds) == fewest;
        // The branch of all survivors with the fewest rewinds; `None` if these are of both.
        let mut least =
            self.survivors.iter().filter(|survivor| has_fewest(survivor)).map(|survivor| survivor.state.branch);
        let least = least.next().filter(|first| least.all(|branch| branch == *first));
        let has_more = |survivor: &Survivor| least.is_some_and(|least| survivor.state.branch != least);
        let begins = self.survivors.len() == self.layer.len()
            && self.predecessors.len() == self.layer.len()
            && self.survivors.iter().zip(&self.predecessors).zip(&self.layer).all(|((survivor, source), last)| {
                survivor.state == *last
                    && source.from.state == *last
                    && match has_more(survivor) {
                        true => compares,
                        false => !source.rewound && (least.is_some() || has_fewest(survivor)),
                    }
            });
        if begins {
            let more = (0..self.survivors.len()).filter(|index| has_more(&self.survivors[*index]));
            let more = more.map(|survivor| WithMoreRewinds { survivor, sum: Cost::default(), rewind: None });
            self.with_more_rewinds.extend(more);
        }
        begins
    }

    /// Whether in the present run a rewind may lead cheaper to a state than its own course.
    #[inline]
    pub(crate) fn compares_rewinds(&self) -> bool {
        !self.with_more_rewinds.is_empty()
    }

    /// Whether in the present run a rewind has led cheaper to a state than its own course.
    #[cfg(test)]
    pub(crate) fn has_rewound(&self) -> bool {
        self.with_more_rewinds.iter().any(|state| state.rewind.is_some())
    }

    /// Compares, before a cut of a run, the course to each state of the branch with more rewinds with those by a rewind
    /// from the other branch. `rotated`: see [`rotate`](Self::rotate). Returns by how much these are longer at least.
    pub(crate) fn compare_rewinds(
        &mut self,
        motion: u64,
        rotated: impl Fn(&RotaryState) -> (RotaryState, Cost),
    ) -> f64 {
        let mut least = f64::INFINITY;
        if !self.compares_rewinds() {
            return least;
        }
        let Self { survivors, with_more_rewinds, rewind_starts, metric, .. } = self;
        let fewest = survivors.iter().map(|survivor| survivor.cost.rewinds).min();
        rewind_starts.clear();
        rewind_starts.extend(survivors.iter().filter(|survivor| Some(survivor.cost.rewinds) == fewest).map(|from| {
            let (state, sum) = rotated(&from.state);
            RewindStart {
                cost: from.cost.plus(sum).plus(Cost::REWIND),
                words: state.words,
                last_change: from.last_change,
            }
        }));
        for known in with_more_rewinds {
            let survivor = &mut survivors[known.survivor];
            let (state, sum) = rotated(&survivor.state);
            survivor.cost = survivor.cost.plus(sum.since(known.sum));
            known.sum = sum;
            let cost = |start: &RewindStart| start.cost.plus(metric.cost(&start.words, &state.words));
            let mut cheapest: Option<(Cost, &RewindStart)> = None;
            for start in &*rewind_starts {
                let cost = cost(start);
                // Of equals that of the first state of the pose.
                let is_before = |(least, of): (Cost, &RewindStart)| {
                    cost < least || cost == least && preference(&start.words) < preference(&of.words)
                };
                if cheapest.is_none_or(is_before) {
                    cheapest = Some((cost, start));
                }
            }
            let Some((cost, start)) = cheapest else { continue };
            // Of equals the earliest.
            if cost < survivor.cost {
                survivor.cost = cost;
                known.rewind = Some(RunRewind { last_change: start.last_change, motion, words: state.words });
            }
            least = smaller(metric.longer_by(survivor.cost, cost), least);
        }
        least
    }

    /// States of the survivors.
    pub(crate) fn states(&self) -> impl Iterator<Item = &RotaryState> {
        self.survivors.iter().map(|survivor| &survivor.state)
    }

    /// Takes a run of cuts that [has begun](Self::begin_run). `rotated`: a state of the pose at which it began as it is
    /// now, and the cost of its rotation. The layer of the last pose must [follow](Self::enter).
    pub(crate) fn rotate(&mut self, rotated: impl Fn(&RotaryState) -> (RotaryState, Cost)) {
        let mut with_more_rewinds = self.with_more_rewinds.drain(..).peekable();
        for (index, survivor) in self.survivors.iter_mut().enumerate() {
            let (state, mut sum) = rotated(&survivor.state);
            if let Some(known) = with_more_rewinds.next_if(|known| known.survivor == index) {
                sum = sum.since(known.sum);
                if let Some(RunRewind { last_change, motion, words }) = known.rewind {
                    survivor.last_change = self.history.push(last_change, motion, CourseAction::Rewind, words);
                }
            }
            *survivor = Survivor { state, cost: survivor.cost.plus(sum), air: None, zeroable: false, ..*survivor };
        }
    }

    /// Makes all states of the last pose the layer, and puts the survivors in their order.
    pub(crate) fn enter(&mut self, states: &[RotaryState]) {
        let mut rest = states.iter();
        if !self.survivors.iter().all(|survivor| rest.any(|state| *state == survivor.state)) {
            self.survivors.sort_by_cached_key(|survivor| states.iter().position(|state| *state == survivor.state));
        }
        self.layer.clear();
        self.layer.extend_from_slice(states);
        self.history.settle(&mut self.survivors);
    }

    /// Whether the states are those of the last pose, each rotated by less than 90°.
    fn rotates_plainly(&self, states: &[RotaryState]) -> bool {
        // All turns of a branch rotate alike.
        let mut plain = None;
        states.len() == self.layer.len()
            && self.layer.iter().zip(states).all(|(last, state)| {
                let change = [0, 1].map(|axis| state.words[axis] - last.words[axis]);
                let known = plain == Some(change);
                plain = Some(change);
                last.branch == state.branch && (known || self.metric.plain(&last.words, &state.words))
            })
    }

    /// Takes a cut. Returns false, and changes nothing, if no state can be reached. `via`: fraction of the path at
    /// which it is split.
    pub(crate) fn cut(
        &mut self,
        motion: u64,
        states: &[RotaryState],
        via: Option<f64>,
        mut linked: impl FnMut(&RotaryState, &RotaryState) -> bool,
    ) -> bool {
        self.collect_predecessors();
        self.next.clear();
        for state in states {
            let mut best: Option<(Cost, Predecessor)> = None;
            for source in &self.predecessors {
                let cost = source.from.cost.plus(self.metric.cost(&source.from.state.words, &state.words));
                if best.is_none_or(|(least, _)| cost < least) && linked(&source.from.state, state) {
                    best = Some((cost, *source));
                }
            }
            let Some((cost, Predecessor { from, rewound })) = best else { continue };
            let mut last_change = from.last_change;
            if rewound {
                last_change = self.history.push(last_change, motion, CourseAction::Rewind, from.state.words);
            }
            if let Some(part) = via {
                last_change = self.history.push(last_change, motion, CourseAction::SplitAt(part), state.words);
            } else if from.state.branch != state.branch || !self.metric.plain(&from.state.words, &state.words) {
                last_change = self.history.push(last_change, motion, CourseAction::EndWith, state.words);
            }
            self.next.push(Survivor { state: *state, cost, last_change, air: None, zeroable: false });
        }
        self.finish_layer(states)
    }

    /// Collects the survivors, and every other state of the layer as reached by a rewind from its cheapest survivor.
    fn collect_predecessors(&mut self) {
        self.predecessors.clear();
        let fewest = self.survivors.iter().map(|survivor| survivor.cost.rewinds).min();
        let settled = self.survivors.len() >= self.layer.len()
            && self.survivors.iter().all(|survivor| Some(survivor.cost.rewinds) == fewest);
        if settled {
            self.predecessors.extend(self.survivors.iter().map(|&from| Predecessor { from, rewound: false }));
            return;
        }
        // The cheapest rewind begins where fewest have been made; whoever has made no more needs none.
        let rewindable = || self.survivors.iter().filter(|survivor| Some(survivor.cost.rewinds) == fewest);
        let mut place = 0;
        for state in &self.layer {
            // Survivors are in the order of their layer.
            let is_it = |survivor: &&Survivor| survivor.state == *state;
            let alive = self.survivors.get(place).filter(is_it).or_else(|| self.survivors.iter().find(is_it));
            place += usize::from(alive.is_some());
            if let Some(&from) = alive.filter(|survivor| Some(survivor.cost.rewinds) == fewest) {
                self.predecessors.push(Predecessor { from, rewound: false });
                continue;
            }
            let rewound =
                |from: &Survivor| from.cost.plus(self.metric.cost(&from.state.words, &state.words)).plus(Cost::REWIND);
            let other = rewindable().map(|from| (rewound(from), from)).min_by_key(|(cost, _)| *cost);
            match (alive, other) {
                (Some(&from), Some((cost, _))) if from.cost <= cost => {
                    self.predecessors.push(Predecessor { from, rewound: false });
                }
                (Some(&from), None) => self.predecessors.push(Predecessor { from, rewound: false }),
                (_, Some((cost, from))) => {
                    let from = Survivor { state: *state, cost, ..*from };
                    self.predecessors.push(Predecessor { from, rewound: true });
                }
                (None, None) => {}
            }
        }
    }

    /// Takes a cut that ends at the pole: `entry` gives the words with which a state reaches the pole, if it does.
    /// `via`: fraction of the path at which the pole is.
    pub(crate) fn cut_to_pole(
        &mut self,
        motion: u64,
        via: Option<f64>,
        mut entry: impl FnMut(&RotaryState) -> Option<RotaryWords>,
    ) -> bool {
        self.collect_predecessors();
        self.next.clear();
        for Predecessor { from, rewound } in &self.predecessors {
            let Some(words) = entry(&from.state) else { continue };
            let cost = from.cost.plus(self.metric.cost(&from.state.words, &words));
            let mut last_change = from.last_change;
            if *rewound {
                last_change = self.history.push(last_change, motion, CourseAction::Rewind, from.state.words);
            }
            if let Some(part) = via {
                last_change = self.history.push(last_change, motion, CourseAction::SplitAt(part), words);
            } else if words[0] != from.state.words[0] || !self.metric.plain(&from.state.words, &words) {
                last_change = self.history.push(last_change, motion, CourseAction::EndWith, words);
            }
            Self::keep(
                &mut self.next,
                Survivor { state: RotaryState { words, ..from.state }, cost, last_change, air: None, zeroable: false },
            );
        }
        self.finish_layer(&[])
    }

    /// Takes a cut that begins at the pole. `exits`: for each state the words with which it leaves the pole. Where the
    /// tool has come to the pole in the air, this cut decides between the preferred states and the others.
    pub(crate) fn leave_pole(
        &mut self,
        motion: u64,
        states: &[RotaryState],
        exits: &[Option<RotaryWords>],
        is_preferred: impl Fn(&RotaryState) -> bool,
    ) -> bool {
        self.next.clear();
        for (state, exit) in states.iter().zip(exits) {
            let Some(exit) = exit else { continue };
            let preferred = is_preferred(state);
            let cost = |from: &Survivor| {
                let rotation = self.metric.cost(&from.state.words, exit);
                let chosen = from.air.is_none() || preferred;
                let preference = if chosen { Cost::default() } else { Cost::AGAINST_PREFERENCE };
                from.cost.plus(rotation).plus(self.metric.cost(exit, &state.words)).plus(preference)
            };
            let from = self.survivors.iter().filter(|from| {
                self.metric.short(&[0, from.state.words[1]], &[0, exit[1]]) && self.is_taken(from, exit, exits)
            });
            let Some(from) = from.min_by_key(|from| cost(from)) else { continue };
            let cost = cost(from);
            let mut last_change = from.last_change;
            if *exit != from.state.words {
                last_change = match from.air {
                    Some(air) => self.history.push(last_change, air, CourseAction::EndWith, *exit),
                    None => self.history.push(last_change, motion, CourseAction::RotateAtPole, *exit),
                };
            }
            last_change = self.history.push(last_change, motion, CourseAction::EndWith, state.words);
            self.next.push(Survivor { state: *state, cost, last_change, air: None, zeroable: false });
        }
        self.finish_layer(states)
    }

    /// Whether an axis that is free at the pole leaves it with the words `exit`: a control that finds the angles itself
    /// takes the nearest ones. A motion in the air can rotate the axis before.
    fn is_taken(&self, from: &Survivor, exit: &RotaryWords, exits: &[Option<RotaryWords>]) -> bool {
        let rotation = |exit: &RotaryWords| self.metric.change(0, from.state.words[0], exit[0]).abs();
        let nearest = || exits.iter().flatten().map(rotation).min();
        !self.by_control
            || from.air.is_some()
            || nearest().is_none_or(|nearest| rotation(exit) <= nearest + SAME_WORD_AFTER_POLE)
    }

    /// Returns the cost of the cheapest course, and its changes.
    pub(crate) fn finish(mut self) -> (Cost, PackedChanges) {
        self.leave_zeroed();
        let best = self.survivors.iter().min_by_key(|survivor| survivor.cost).copied();
        let Some(best) = best else { return (Cost::default(), self.history.decided) };
        let chain = self.history.chain(best.last_change);
        self.history.decide(&chain);
        (best.cost, self.history.decided)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::AngleScale;

    #[test]
    fn abandoned_courses_leave_no_changes() {
        let rotary = Rotary { index: 0, lower: Some(-400), upper: Some(400), rest_deg: 0.0 };
        let metric = RotaryMetric::new(&[rotary], [None; 2], AngleScale { units_per_degree: 1.0, units_per_turn: 360 });
        // Motion by motion one course is kept, and another, reached by a rewind, is abandoned.
        let mut search = CourseSearch::new(metric, None, false, true);
        search.restart([10, 0]);
        let states = [10, -350].map(|word| RotaryState { branch: Branch::First, words: [word, 0] });
        assert!(search.free(0, &states, None, |_| true));
        for motion in 1..10_000 {
            assert!(search.cut(motion, &states, None, |from, to| from == to));
        }
        assert!(search.history.nodes.len() < COMPACT_ABOVE, "{}", search.history.nodes.len());
        assert_eq!(search.finish().0.rewinds, 0);
    }

    #[test]
    fn in_rows_of_starts_the_cheapest_of_all_is_found() {
        let scale = AngleScale { units_per_degree: 1.0, units_per_turn: 36 };
        let mut random = 1_u64;
        let mut next = |range: i64| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) as i64 % range
        };
        let mut left_out = 0;
        for run in 0..4000 {
            let limited = |index, limited: bool| {
                let limit = limited.then_some(400);
                Rotary { index, lower: limit.map(|limit: i64| -limit), upper: limit, rest_deg: 0.0 }
            };
            let speeds = if run % 7 == 0 { [Some(3.0), Some(5.0)] } else { [None; 2] };
            let axes = [limited(0, run % 5 != 0), limited(1, run % 3 != 0)];
            let mut search = CourseSearch::new(RotaryMetric::new(&axes, speeds, scale), None, false, false);
            let first = search.survivors[0];
            let (one, other, spread) = (next(36), next(36), 1 + next(120));
            search.survivors.clear();
            for turn in 0..1 + next(20) {
                let (branch, words) = match next(4) {
                    0 => (Branch::Second, [other + 36 * (turn - 8), 36 - one]),
                    _ => (Branch::First, [one + 36 * (turn - 5), one]),
                };
                let cost = Cost {
                    rewinds: u32::from(next(9) == 0),
                    travel_units: (36 * (turn - 5).abs() + next(spread)).unsigned_abs(),
                    ..Cost::default()
                };
                search.survivors.push(Survivor { state: RotaryState { branch, words }, cost, ..first });
            }
            search.collect_starts(None);
            left_out += search.survivors.len() - search.starts.len();
            for _ in 0..20 {
                let words = [next(800) - 400, next(40)];
                let found = search.cheapest_start(&words, None).expect("no sense is programmed");
                let all = search.survivors.iter();
                let costs = all.map(|from| (from.cost.plus(search.metric.cost(&from.state.words, &words)), from));
                assert_eq!(Some(found), costs.min_by_key(|(cost, _)| *cost), "run {run}");
            }
        }
        assert!(left_out > 2000, "{left_out}");
    }

    /// States of a pose with both branches of a C-B table, turns inside ±`limit` degrees.
    fn states_of(first: i64, second: i64, limit: i64) -> Vec<RotaryState> {
        let branches = [(Branch::First, [first, second]), (Branch::Second, [first + 180, -second])];
        let turns = |(branch, [first, second]): (Branch, [i64; 2])| {
            let inside = (-6..=6).map(move |turn| first.rem_euclid(360) + 360 * turn).filter(move |a| a.abs() <= limit);
            let mut turns: Vec<i64> = inside.collect();
            turns.sort_by_key(|word| (word.abs(), -word));
            turns.into_iter().map(move |word| RotaryState { branch, words: [word, second] })
        };
        branches.into_iter().filter(|(_, [_, second])| *second > -40).flat_map(turns).collect()
    }

    #[test]
    fn a_cut_that_is_followed_ends_as_one_that_is_searched() {
        let axes = [0, 1].map(|index| Rotary { index, lower: Some(-900), upper: Some(900), rest_deg: 0.0 });
        let scale = AngleScale { units_per_degree: 1.0, units_per_turn: 360 };
        let metric = RotaryMetric::new(&axes, [Some(3.0), Some(5.0)], scale);
        let mut random = 1_u64;
        let mut next = |range: i64| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) as i64 % range
        };
        let (mut followed, mut rewinds) = (0, 0);
        for run in 0..400 {
            let (limit, greedy) = (200 + next(700), run % 2 == 1);
            let search = || CourseSearch::new(metric, None, false, greedy);
            let (mut short, mut long) = (search(), search());
            let (mut first, mut second) = (next(360), 20 + next(60));
            let start = states_of(first, second, limit);
            assert!(short.free(0, &start, None, |_| true) && long.free(0, &start, None, |_| true));
            for motion in 1..60 {
                first += next(40) - if run % 3 == 0 { 5 } else { 20 };
                second = (second + next(11) - 5).clamp(10, 80);
                let states = states_of(first, second, limit);
                let linked = |from: &RotaryState, to: &RotaryState| {
                    from.branch == to.branch && metric.short(&from.words, &to.words)
                };
                let goes_on = short.follow(motion, &states);
                followed += usize::from(goes_on);
                let reached = long.cut(motion, &states, None, linked);
                assert_eq!(goes_on || short.cut(motion, &states, None, linked), reached, "run {run}, motion {motion}");
                if !reached {
                    break;
                }
            }
            let (short, long) = (short.finish(), long.finish());
            rewinds += long.0.rewinds;
            assert_eq!(short, long, "run {run}");
        }
        assert!(followed > 5000 && rewinds > 20, "{followed} followed, {rewinds} rewinds");
    }
}
