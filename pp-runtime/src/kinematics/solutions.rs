//! Solutions of the inverse kinematics, on the stack.

use core::fmt;
use core::ops::Deref;

/// Branch of the closed-form inverse. The first is the one that the papers print (`sin B >= 0` for a C-B table).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Branch {
    /// The first branch; the only one where both coincide.
    #[default]
    First,
    /// The second branch.
    Second,
}

/// Angles of the solved rotary axes in the order of the chain, rad; 0 for each of the two that a machine does not have.
pub type RotaryAngles = [f64; 2];

/// Axis values for a pose, before whole turns and limits.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Solution<A> {
    /// Axis values in chain order, mm and rad.
    pub axes: A,
    /// Branch of this solution.
    pub branch: Branch,
    /// The tool axis is parallel to the first rotary, which keeps its held value.
    pub singular: bool,
    /// Angle between the required tool axis and the one reached, rad; at most
    /// [`REACH_TOLERANCE`](super::REACH_TOLERANCE).
    pub deviation: f64,
}

/// Zero to two solutions; derefs to a slice.
#[derive(Clone, Copy, Default)]
pub struct Solutions<A> {
    list: [Solution<A>; 2],
    len: usize,
}

impl<A: Copy + Default> Solutions<A> {
    /// No solution.
    #[must_use]
    #[inline]
    pub fn none() -> Self {
        Self::default()
    }

    /// The solutions of the branches, in their order.
    #[must_use]
    #[inline]
    pub fn from_branches(branches: [Option<Solution<A>>; 2]) -> Self {
        match branches {
            [Some(first), Some(second)] => Self { list: [first, second], len: 2 },
            [Some(only), None] | [None, Some(only)] => Self { list: [only, Solution::default()], len: 1 },
            [None, None] => Self::none(),
        }
    }
}

impl<A: Copy> Solutions<A> {
    /// The same solutions with their axis values in another form.
    #[inline]
    pub(crate) fn map<B: Copy + Default>(&self, convert: impl Fn(&A) -> B) -> Solutions<B> {
        let mut list = [Solution::default(); 2];
        for (to, from) in list.iter_mut().zip(&self.list[..self.len]) {
            let Solution { axes, branch, singular, deviation } = from;
            *to = Solution { axes: convert(axes), branch: *branch, singular: *singular, deviation: *deviation };
        }
        Solutions { list, len: self.len }
    }
}

impl<A> Deref for Solutions<A> {
    type Target = [Solution<A>];
    #[inline]
    fn deref(&self) -> &[Solution<A>] {
        &self.list[..self.len]
    }
}

impl<'a, A> IntoIterator for &'a Solutions<A> {
    type Item = &'a Solution<A>;
    type IntoIter = core::slice::Iter<'a, Solution<A>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<A: fmt::Debug> fmt::Debug for Solutions<A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}
