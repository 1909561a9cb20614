//! Clamps of rotary axes: off before an axis moves, on where it does not move until the tool leaves the part again, and
//! not switched between simultaneous blocks.
//!
//! At the end of an approach, only the following blocks show whether an axis will move. A rehearsal therefore plans the
//! whole program once without writing, and notes the axes that the planner moves, one mask for each approach.

use std::io;

use crate::kinematics::{Axis, Rotary};

use crate::motion::plan::output::Output;
use crate::motion::policy::Policy;
use crate::motion::step::{MAX_AXES, Sink, Step};
use crate::options::ClampCodes;

/// One clamp.
#[derive(Debug, Clone, PartialEq)]
struct Clamp {
    /// Position of its axis in the chain.
    index: usize,
    codes: ClampCodes,
    /// It is on; `None` if unknown.
    on: Option<bool>,
}

/// Axes that move between an approach and the next, one mask for each approach: bit `i` for the axis at position `i`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct MovingAxes(Vec<u16>);

/// The clamps of a machine.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Clamps {
    clamps: Vec<Clamp>,
    /// Result of the rehearsal; `None` in the rehearsal itself.
    rehearsed: Option<MovingAxes>,
    seen: MovingAxes,
    /// Approaches so far.
    approaches: usize,
}

impl Clamps {
    pub(crate) fn new(chain: &[Axis], policy: Policy<'_>, rotaries: &[Rotary]) -> Self {
        let clamp = |rotary: &Rotary| {
            let codes = policy.options.rotaries.clamp.get(&chain[rotary.index].letter)?.clone();
            Some(Clamp { index: rotary.index, codes, on: None })
        };
        Self { clamps: rotaries.iter().filter_map(clamp).collect(), ..Self::default() }
    }

    /// Forgets the states: the program can be entered here.
    pub(crate) fn forget(&mut self) {
        self.clamps.iter_mut().for_each(|clamp| clamp.on = None);
    }

    /// Counts an approach.
    pub(crate) fn approach(&mut self) {
        self.approaches += 1;
        if !self.clamps.is_empty() && self.rehearsed.is_none() {
            self.seen.0.push(0);
        }
    }

    /// Notes the axes that a block of an operation moves. `rotates`: the control chooses the rotary angles, and the
    /// tool axis changes, so that any rotary axis may move.
    #[inline(always)]
    pub(crate) fn note(&mut self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES], rotates: bool) {
        if let Some(seen) = self.seen.0.last_mut() {
            for clamp in self.clamps.iter().filter(|clamp| rotates || from[clamp.index] != to[clamp.index]) {
                *seen |= 1 << clamp.index;
            }
        }
    }

    /// Axes that move until the next approach; without a rehearsal all.
    fn moving(&self) -> u16 {
        let Some(MovingAxes(masks)) = &self.rehearsed else { return u16::MAX };
        self.approaches.checked_sub(1).and_then(|index| masks.get(index)).copied().unwrap_or(u16::MAX)
    }

    /// Before the rotary axes move alone: off where they rotate now or before the next approach; `all`: every axis may
    /// rotate, to a plane or from an unknown angle.
    pub(crate) fn open<S: Sink>(
        &mut self,
        from: &[i64; MAX_AXES],
        to: &[i64; MAX_AXES],
        all: bool,
        output: &mut Output<S>,
    ) -> io::Result<()> {
        let turns = |clamp: &&Clamp| all || clamp.on.is_none() || from[clamp.index] != to[clamp.index];
        let turning = self.clamps.iter().filter(turns).fold(0, |mask, clamp| mask | 1 << clamp.index);
        self.switch(turning | self.moving(), false, output)
    }

    /// After that motion: on where they do not rotate before the next approach.
    pub(crate) fn close<S: Sink>(&mut self, output: &mut Output<S>) -> io::Result<()> {
        self.switch(!self.moving(), true, output)
    }

    /// Switches the clamps of the axes in a mask.
    pub(crate) fn switch<S: Sink>(&mut self, mask: u16, on: bool, output: &mut Output<S>) -> io::Result<()> {
        for clamp in self.clamps.iter_mut().filter(|clamp| mask & (1 << clamp.index) != 0 && clamp.on != Some(on)) {
            clamp.on = Some(on);
            output.step(&Step::Code { text: if on { &clamp.codes.on } else { &clamp.codes.off } })?;
        }
        Ok(())
    }

    /// Sets the result of a rehearsal of the same program.
    pub(crate) fn set_rehearsed(&mut self, rehearsed: MovingAxes) {
        self.rehearsed = Some(rehearsed);
    }

    /// Result of the rehearsal.
    pub(crate) fn into_seen(self) -> MovingAxes {
        self.seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::kinematics::machines::Cb;
    use crate::motion::tests::{config, feed, rapid, run, spindle, tool};
    use crate::program::{Event, NewStart};

    fn axis(c: f64, b: f64) -> [f64; 3] {
        let ((sin_c, cos_c), (sin_b, cos_b)) = (c.to_radians().sin_cos(), b.to_radians().sin_cos());
        [sin_b * cos_c, sin_b * sin_c, cos_b]
    }

    /// Clamp codes and the words of rotary axes, in their order.
    fn switched(config: &Config, events: &[Event<'_>]) -> Vec<String> {
        let run = run::<Cb>(config, events);
        assert_eq!(run.diagnostics, []);
        let clamp = |word: &&str| ["M10", "M11", "M12", "M13"].contains(word);
        let relevant = |line: &String| {
            let words: Vec<&str> = line.split(' ').filter(|word| clamp(word) || word.starts_with(['B', 'C'])).collect();
            (!words.is_empty() && !line.starts_with(['(', 'N'])).then(|| words.join(" "))
        };
        run.lines.iter().filter_map(relevant).collect()
    }

    fn clamped() -> Config {
        let mut config = config();
        let codes = |on: &str, off: &str| ClampCodes { on: on.to_owned(), off: off.to_owned() };
        config.motion.rotaries.clamp.insert('C', codes("M10", "M11"));
        config.motion.rotaries.clamp.insert('B', codes("M12", "M13"));
        config
    }

    #[test]
    fn an_axis_is_clamped_where_it_stays_still_and_not_while_it_moves() {
        let events = [
            Event::NewStart(NewStart::Operation(b"PLANE")),
            tool(1),
            spindle(),
            feed([1.0, 0.0, 0.0], axis(0.0, 30.0)),
            feed([2.0, 0.0, 0.0], axis(0.0, 30.0)),
            Event::NewStart(NewStart::Operation(b"ROUND")),
            rapid([1.0, 0.0, 0.0], axis(0.0, 30.0)),
            feed([2.0, 0.0, 0.0], axis(0.0, 35.0)),
            feed([3.0, 0.0, 0.0], axis(0.0, 40.0)),
        ];
        let found = switched(&clamped(), &events);
        let (plane, round) = (["M11", "M13", "B30 C0", "M10", "M12"], ["M11", "M13", "B30 C0", "M10"]);
        assert_eq!((&found[..5], &found[5..9]), (&plane.map(str::to_owned)[..], &round.map(str::to_owned)[..]));
        let turns = found[9..].iter().all(|line| line.starts_with('B'));
        assert!(turns && found.len() > 10, "nothing between simultaneous blocks: {found:?}");
    }

    #[test]
    fn a_rapid_that_indexes_switches_the_clamps_of_the_axes_that_turn() {
        let events = [
            tool(1),
            spindle(),
            feed([1.0, 0.0, 0.0], axis(0.0, 30.0)),
            rapid([1.0, 0.0, 40.0], axis(90.0, 30.0)),
            feed([2.0, 0.0, 0.0], axis(90.0, 30.0)),
        ];
        assert_eq!(switched(&clamped(), &events), ["M11", "M13", "B30 C0", "M10", "M12", "M11", "C90", "M10"]);
    }

    #[test]
    fn a_parked_axis_is_clamped_where_it_is_parked() {
        let mut config = clamped();
        config.motion.park.insert('B', 0.0);
        let events = [tool(1), spindle(), feed([1.0, 0.0, 0.0], axis(0.0, 30.0))];
        assert_eq!(switched(&config, &events), ["M11", "M13", "B30 C0", "M10", "M12", "M13", "B0", "M12"]);
    }
}
