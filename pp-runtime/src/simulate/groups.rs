//! Things that belong together, found while their pairs are joined.

/// Numbered things, each in one group.
#[derive(Debug, Clone, Default)]
pub(super) struct Groups {
    /// Of each one another of its group with a lower number, or itself.
    parents: Vec<u32>,
}

impl Groups {
    /// Things that are each a group of their own.
    pub(super) fn of(count: usize) -> Self {
        Self { parents: (0..count as u32).collect() }
    }

    /// Adds a group of one; its number is that of those before it.
    pub(super) fn push(&mut self) {
        self.parents.push(self.parents.len() as u32);
    }

    /// The lowest number of a group.
    pub(super) fn first(&mut self, of: usize) -> usize {
        let mut at = of;
        while self.parents[at] as usize != at {
            self.parents[at] = self.parents[self.parents[at] as usize];
            at = self.parents[at] as usize;
        }
        at
    }

    /// Makes one group of two.
    pub(super) fn join(&mut self, one: usize, two: usize) {
        let (one, two) = (self.first(one), self.first(two));
        self.parents[one.max(two)] = one.min(two) as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_joined_by_others_is_one_group_with_its_lowest_number() {
        let mut groups = Groups::of(5);
        groups.push();
        [(4, 5), (1, 3), (3, 4)].into_iter().for_each(|(one, two)| groups.join(one, two));
        assert_eq!([0, 1, 2, 3, 4, 5].map(|index| groups.first(index)), [0, 1, 2, 1, 1, 1]);
    }
}
