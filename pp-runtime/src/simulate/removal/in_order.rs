//! Results of several threads, taken in the order of the work and not held longer than that order asks for.

use std::collections::BTreeMap;

/// Takes results by their turns, 0, 1, 2 ...; one that is early waits.
pub(super) struct InOrder<T, F> {
    next: usize,
    early: BTreeMap<usize, T>,
    take: F,
}

impl<T, F: FnMut(T)> InOrder<T, F> {
    pub(super) fn new(take: F) -> Self {
        Self { next: 0, early: BTreeMap::new(), take }
    }

    /// Takes a result, and those that have waited for it.
    pub(super) fn give(&mut self, turn: usize, result: T) {
        self.early.insert(turn, result);
        while let Some(result) = self.early.remove(&self.next) {
            self.next += 1;
            (self.take)(result);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn early_results_wait_and_no_other_is_held() {
        let mut taken = Vec::new();
        let mut results = InOrder::new(|result: char| taken.push(result));
        for (turn, result, held) in [(0, 'a', 0), (3, 'd', 1), (2, 'c', 2), (1, 'b', 0), (4, 'e', 0)] {
            results.give(turn, result);
            assert_eq!(results.early.len(), held, "{turn}");
        }
        assert_eq!(taken, ['a', 'b', 'c', 'd', 'e']);
    }
}
