//! Rows of the tables of tolerances, [`writer`] and `check::tolerances`, and the comparison of the two.
//!
//! A row is a number with which a computed quantity is compared, so that it decides what is equal, near, parallel, at
//! the pole, rounded, or fast enough; or a plausible size beyond which data is a fault. Elsewhere are: counts and sizes
//! that bound work or memory; steps, parts and stopping rules of a numerical method, which belong to the method; ranges
//! of configuration keys; conversions of units; factors of a formula, as half a unit. A number with two meanings is two
//! rows.
//!
//! The check shares no code with the planner, so what both sides need is a row on each, and each row names the other
//! one.

pub(crate) mod writer;

/// Constants of a table, each with what it compares, its type and value, its unit, the reason for its size, and its
/// partner in the other table:
///
/// - `equals NAME`: both sides have the same value,
/// - `within NAME` in the table of motion, `covers NAME` in that of the check: the check allows at least as much,
/// - `alone "reason"`: no partner is needed.
macro_rules! tolerances {
    ($(
        $(#[doc = $what:literal])+
        $name:ident: $type:ty = $value:expr, $unit:literal, $why:literal, $relation:ident $partner:tt;
    )+) => {
        $(
            $(#[doc = $what])+
            #[doc = ""]
            #[doc = concat!("Unit: ", $unit, ". Reason: ", $why, ".")]
            pub(crate) const $name: $type = $value;
        )+

        /// The table, for the comparison of both.
        #[cfg(test)]
        pub(crate) const TABLE: &[$crate::tolerance::Tolerance] = &[$($crate::tolerance::Tolerance {
            name: stringify!($name),
            value: $name as f64,
            unit: $unit,
            why: $why,
            partner: $crate::tolerance::tolerances!(@ $relation $partner),
        }),+];
    };
    (@ equals $name:ident) => { $crate::tolerance::Partner::Equal(stringify!($name)) };
    (@ within $name:ident) => { $crate::tolerance::Partner::AtLeast(stringify!($name)) };
    (@ covers $name:ident) => { $crate::tolerance::Partner::AtMost(stringify!($name)) };
    (@ alone $why:literal) => { $crate::tolerance::Partner::None($why) };
}
pub(crate) use tolerances;

/// A row.
#[cfg(test)]
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tolerance {
    pub(crate) name: &'static str,
    pub(crate) value: f64,
    pub(crate) unit: &'static str,
    pub(crate) why: &'static str,
    pub(crate) partner: Partner,
}

/// The row of the other table, by its name, and its value as seen from this one.
#[cfg(test)]
#[derive(Debug, Clone, Copy)]
pub(crate) enum Partner {
    Equal(&'static str),
    AtLeast(&'static str),
    AtMost(&'static str),
    /// There is none; why none is needed.
    None(&'static str),
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;

    /// What is wrong with the row of one table in view of the other one.
    fn fault(row: &Tolerance, others: &[Tolerance]) -> Option<String> {
        let (name, relation) = match row.partner {
            Partner::None(why) => return why.is_empty().then(|| format!("{}: why has it no partner?", row.name)),
            Partner::Equal(name) | Partner::AtLeast(name) | Partner::AtMost(name) => (name, row.partner),
        };
        let Some(other) = others.iter().find(|other| other.name == name) else {
            return Some(format!("{}: there is no {name}", row.name));
        };
        let (names_back, holds) = match (relation, other.partner) {
            (Partner::Equal(_), Partner::Equal(back)) => {
                (back == row.name, row.value.to_bits() == other.value.to_bits())
            }
            (Partner::AtLeast(_), Partner::AtMost(back)) => (back == row.name, row.value <= other.value),
            (Partner::AtMost(_), Partner::AtLeast(back)) => (back == row.name, row.value >= other.value),
            _ => (false, true),
        };
        if !names_back {
            return Some(format!("{}: {name} does not name it back, or with another relation", row.name));
        }
        if row.unit != other.unit {
            return Some(format!("{} in {}, but {name} in {}", row.name, row.unit, other.unit));
        }
        (!holds).then(|| format!("{} = {}, but {name} = {}", row.name, row.value, other.value))
    }

    fn faults(motion: &[Tolerance], check: &[Tolerance]) -> Vec<String> {
        let sides = [(motion, check), (check, motion)];
        sides.iter().flat_map(|(rows, others)| rows.iter().filter_map(|row| fault(row, others))).collect()
    }

    #[test]
    fn what_motion_and_check_both_need_is_the_same_on_both_sides() {
        let (motion, check) = (writer::TABLE, check::tolerances::TABLE);
        assert_eq!(faults(motion, check), Vec::<String>::new());
        // Only motion is within, only the check covers.
        assert!(motion.iter().all(|row| !matches!(row.partner, Partner::AtMost(_))));
        assert!(check.iter().all(|row| !matches!(row.partner, Partner::AtLeast(_))));
        assert!(motion.iter().chain(check).all(|row| !row.unit.is_empty() && !row.why.is_empty()));
    }

    #[test]
    fn a_pair_that_does_not_hold_is_found() {
        let row = |name, value, unit, partner| Tolerance { name, value, unit, why: "test", partner };
        let (one, other) = (row("A", 1.0, "mm", Partner::Equal("B")), row("B", 1.0, "mm", Partner::Equal("A")));
        assert_eq!(faults(&[one], &[other]), [""; 0]);
        assert_eq!(faults(&[one], &[Tolerance { value: 1.1, ..other }]).len(), 2);
        assert_eq!(faults(&[one], &[Tolerance { unit: "rad", ..other }]).len(), 2);
        assert_eq!(faults(&[one], &[Tolerance { partner: Partner::None("test"), ..other }]).len(), 1);
        assert_eq!(faults(&[one], &[]), ["A: there is no B"]);
        let (one, other) = (row("A", 1.0, "mm", Partner::AtLeast("B")), row("B", 1.5, "mm", Partner::AtMost("A")));
        assert_eq!(faults(&[one], &[other]), [""; 0]);
        assert_eq!(faults(&[one], &[Tolerance { value: 0.9, ..other }]).len(), 2);
        assert_eq!(faults(&[row("A", 1.0, "mm", Partner::None(""))], &[]).len(), 1);
    }
}
