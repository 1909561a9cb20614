//! The frame in which a person at the machine sees directions: right, away and up.

use crate::model::Up;

/// A direction or a point.
pub(crate) type Xyz = [f64; 3];

/// The view from the front of the machine: the coordinate directions that point to the right, away from the observer,
/// and up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct View {
    pub(crate) right: Xyz,
    pub(crate) away: Xyz,
    pub(crate) up: Xyz,
}

impl View {
    /// Right-handed, `right × away = up`. X points to the right; where X is vertical, as on a lathe, Z does.
    pub(crate) fn of(up: Up) -> Self {
        let unit = |index: usize, negative: bool| -> Xyz {
            std::array::from_fn(|row| match row == index {
                true if negative => -1.0,
                true => 1.0,
                false => 0.0,
            })
        };
        let vertical = unit(up.coordinate, up.negated);
        let right = if up.coordinate == 0 { unit(2, false) } else { unit(0, false) };
        Self { right, away: cross(vertical, right), up: vertical }
    }

    /// The three directions with their words: positive, negative.
    pub(crate) fn directions(&self) -> [(Xyz, [&'static str; 2]); 3] {
        [(self.right, ["right", "left"]), (self.away, ["away from you", "towards you"]), (self.up, ["up", "down"])]
    }
}

pub(crate) fn cross(a: Xyz, b: Xyz) -> Xyz {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn dot(a: Xyz, b: Xyz) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub(crate) fn scaled(v: Xyz, by: f64) -> Xyz {
    v.map(|part| part * by)
}

pub(crate) fn opposite(v: Xyz) -> Xyz {
    scaled(v, -1.0)
}

/// Right-handed rotation about a unit vector (Rodrigues).
pub(crate) fn rotated(about: Xyz, degrees: f64, v: Xyz) -> Xyz {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let along = dot(about, v) * (1.0 - cosine);
    let across = cross(about, v);
    std::array::from_fn(|index| v[index] * cosine + across[index] * sine + about[index] * along)
}
