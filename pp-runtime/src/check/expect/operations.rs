//! Rules of single operations: those of an operation by its number and its name.
//!
//! A rule by number goes before one by name, and a name before a likeness, for each property by itself.

use super::super::policy::{LinearMeaning, OperationRule, RuledOperation, SmoothingLevel};

/// Rules in force for an operation.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct RulesInForce {
    pub(super) linear: Option<Option<LinearMeaning>>,
    pub(super) smoothing: Option<Option<SmoothingLevel>>,
    pub(super) blending_mm: Option<f64>,
    pub(super) path_mm: Option<f64>,
    pub(super) largest_feed_mm_per_min: Option<f64>,
    pub(super) allowance_mm: Option<f64>,
}

/// The rules for an operation; a property of which two rules of the same kind differ.
pub(super) fn in_force(rules: &[OperationRule], number: u64, name: &str) -> Result<RulesInForce, &'static str> {
    Ok(RulesInForce {
        linear: one(rules, number, name, |rule| rule.linear).ok_or("mode")?,
        smoothing: one(rules, number, name, |rule| rule.smoothing).ok_or("smoothing")?,
        blending_mm: one(rules, number, name, |rule| rule.blending_mm).ok_or("path_tolerance")?,
        path_mm: one(rules, number, name, |rule| rule.path_mm).ok_or("tolerance")?,
        largest_feed_mm_per_min: one(rules, number, name, |rule| rule.largest_feed_mm_per_min).ok_or("largest_feed")?,
        allowance_mm: one(rules, number, name, |rule| rule.allowance_mm).ok_or("allowance")?,
    })
}

/// A property of an operation by the most exact kind of rule that has it; `None` where rules of that kind differ.
fn one<T: PartialEq>(
    rules: &[OperationRule],
    number: u64,
    name: &str,
    property: impl Fn(&OperationRule) -> Option<T>,
) -> Option<Option<T>> {
    let by_number = |of: &RuledOperation| matches!(of, RuledOperation::Number(wanted) if *wanted == number);
    let by_name = |of: &RuledOperation| matches!(of, RuledOperation::Name(wanted) if is_same(wanted, name));
    let by_likeness = |of: &RuledOperation| matches!(of, RuledOperation::Like(wanted) if is_like(wanted, name));
    let kinds: [&dyn Fn(&RuledOperation) -> bool; 3] = [&by_number, &by_name, &by_likeness];
    for kind in kinds {
        let mut found = rules.iter().filter(|rule| kind(&rule.of)).filter_map(&property);
        if let Some(first) = found.next() {
            return found.all(|other| other == first).then_some(Some(first));
        }
    }
    Some(None)
}

fn is_same(one: &str, other: &str) -> bool {
    one.trim().to_lowercase() == other.trim().to_lowercase()
}

/// Whether a name is like one with `*` for any text and `?` for one character.
fn is_like(wanted: &str, name: &str) -> bool {
    let name: Vec<char> = name.trim().to_lowercase().chars().collect();
    // Numbers of characters of the name that the wanted characters so far can be.
    let mut ends = vec![false; name.len() + 1];
    ends[0] = true;
    for sign in wanted.trim().to_lowercase().chars() {
        let before = ends.clone();
        for end in 0..ends.len() {
            let one_less = end.checked_sub(1);
            ends[end] = match sign {
                '*' => before[..=end].contains(&true),
                '?' => one_less.is_some_and(|start| before[start]),
                sign => one_less.is_some_and(|start| before[start] && name[start] == sign),
            };
        }
    }
    ends[name.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn likeness_is_any_text_for_a_star_and_one_character_for_a_question_mark() {
        let like = ["a*", "*c", "a?c", "*b*", "A*C", "abc", "a**c", "???", "*"];
        let unlike = ["a", "*a", "b*", "a?", "????", "abcd", "", "*b", "c*a"];
        assert!(like.iter().all(|wanted| is_like(wanted, " aBc ")), "{:?}", like.map(|wanted| is_like(wanted, "abc")));
        assert!(!unlike.iter().any(|wanted| is_like(wanted, "abc")), "{:?}", unlike.map(|name| is_like(name, "abc")));
        assert!(is_like("*", "") && is_like("", "") && !is_like("?", ""));
    }

    #[test]
    fn the_most_exact_rule_with_a_property_is_in_force_and_equal_kinds_must_agree() {
        let rule = |of, path_mm, largest_feed_mm_per_min| OperationRule {
            of,
            linear: None,
            smoothing: None,
            blending_mm: None,
            path_mm,
            largest_feed_mm_per_min,
            allowance_mm: None,
        };
        let rules = [
            rule(RuledOperation::Like("fin*".to_owned()), Some(0.3), Some(300.0)),
            rule(RuledOperation::Name("FINISH".to_owned()), Some(0.2), None),
            rule(RuledOperation::Number(4), None, Some(400.0)),
            rule(RuledOperation::Like("*blade".to_owned()), Some(0.1), Some(300.0)),
        ];
        let of =
            |number, name| in_force(&rules, number, name).map(|rules| (rules.path_mm, rules.largest_feed_mm_per_min));
        assert_eq!(of(4, "finish"), Ok((Some(0.2), Some(400.0))));
        assert_eq!(of(1, "Finish"), Ok((Some(0.2), Some(300.0))));
        assert_eq!(of(1, "rough"), Ok((None, None)));
        assert_eq!(of(1, "fine blade"), Err("tolerance"));
    }
}
