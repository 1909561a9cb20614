//! Number of floating-point operations for a set of outputs.

use super::graph::{Graph, Id, Node};

/// Number of operations of each kind; signs and constants cost nothing.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Operations {
    pub(crate) additions: usize,
    pub(crate) products: usize,
    pub(crate) divisions: usize,
    pub(crate) roots: usize,
}

impl Operations {
    /// Counts every node that `outputs` depend on once.
    pub(crate) fn of(graph: &Graph, outputs: &[Id]) -> Self {
        let mut count = Self::default();
        for id in graph.reachable(outputs) {
            match graph.node(id) {
                Node::Add(..) | Node::Sub(..) => count.additions += 1,
                Node::Mul(..) => count.products += 1,
                Node::Div(..) => count.divisions += 1,
                Node::Sqrt(_) => count.roots += 1,
                Node::Constant(_) | Node::Input(_) | Node::Neg(_) => {}
            }
        }
        count
    }

    /// The sum of two counts.
    pub(crate) fn and(self, other: Self) -> Self {
        Self {
            additions: self.additions + other.additions,
            products: self.products + other.products,
            divisions: self.divisions + other.divisions,
            roots: self.roots + other.roots,
        }
    }

    /// All operations.
    pub(crate) fn total(self) -> usize {
        self.additions + self.products + self.divisions + self.roots
    }
}
