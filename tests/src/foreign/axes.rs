//! Values by axis letter.

use std::fmt;

/// Axis letters, in the order in which values are kept and listed.
pub const LETTERS: [char; 9] = ['X', 'Y', 'Z', 'U', 'V', 'W', 'A', 'B', 'C'];

/// Whether a letter names a rotary axis.
#[must_use]
pub fn is_rotary(letter: char) -> bool {
    matches!(letter, 'A' | 'B' | 'C')
}

/// One value for each of some axes: words of a block, or known positions. Lengths in the unit of the program, angles in
/// degrees.
#[derive(Clone, Copy, PartialEq, Default)]
pub struct Axes([Option<f64>; LETTERS.len()]);

impl Axes {
    fn index(letter: char) -> Option<usize> {
        LETTERS.iter().position(|known| *known == letter)
    }

    /// Value of an axis, if there is one.
    #[must_use]
    pub fn get(&self, letter: char) -> Option<f64> {
        self.0[Self::index(letter)?]
    }

    /// Whether an axis has a value.
    #[must_use]
    pub fn contains(&self, letter: char) -> bool {
        self.get(letter).is_some()
    }

    /// Gives an axis a value.
    ///
    /// # Panics
    /// If the letter names no axis.
    pub fn set(&mut self, letter: char, value: f64) {
        self.0[Self::index(letter).expect("an axis letter")] = Some(value);
    }

    /// Gives every axis of `other` its value.
    pub fn extend(&mut self, other: &Self) {
        for (letter, value) in other.iter() {
            self.set(letter, value);
        }
    }

    /// Keeps the values of some axes.
    pub fn retain(&mut self, keep: impl Fn(char) -> bool) {
        for (letter, value) in LETTERS.into_iter().zip(&mut self.0) {
            *value = value.filter(|_| keep(letter));
        }
    }

    /// Letters and values, in the order of [`LETTERS`].
    pub fn iter(&self) -> impl Iterator<Item = (char, f64)> + '_ {
        LETTERS.into_iter().zip(self.0).filter_map(|(letter, value)| Some((letter, value?)))
    }

    /// Letters of the axes that have a value.
    pub fn letters(&self) -> impl Iterator<Item = char> + '_ {
        self.iter().map(|(letter, _)| letter)
    }

    /// Number of axes that have a value.
    #[must_use]
    pub fn len(&self) -> usize {
        self.iter().count()
    }

    /// Whether no axis has a value.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl<const N: usize> From<[(char, f64); N]> for Axes {
    fn from(values: [(char, f64); N]) -> Self {
        let mut axes = Self::default();
        for (letter, value) in values {
            axes.set(letter, value);
        }
        axes
    }
}

impl fmt::Debug for Axes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self.iter()).finish()
    }
}
