//! The known name that a misspelt one is closest to.

/// The candidate that differs from `word` by few letters; letter case does not count.
///
/// A word of three letters may differ by one, a longer one by a third of its letters; two letters that are exchanged
/// count as one. Words of one or two letters have no near name: almost any other would do.
pub(crate) fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let allowed = lower.chars().count() / 3;
    candidates
        .into_iter()
        .filter(|candidate| *candidate != word)
        .map(|candidate| (strsim::damerau_levenshtein(&lower, &candidate.to_lowercase()), candidate))
        .filter(|(distance, _)| *distance <= allowed)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// "did you mean `height`?" for a near name, else the list of names.
pub(crate) fn or_list(word: &str, candidates: &[&str], list: &str) -> String {
    match nearest(word, candidates.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("{list} {}", candidates.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let names = ["chain", "d", "dims", "limits", "height"];
        assert_eq!(nearest("chian", names), Some("chain"));
        assert_eq!(nearest("heigth", names), Some("height"));
        assert_eq!(nearest("Limit", names), Some("limits"));
        assert_eq!(nearest("travel", names), None);
        assert_eq!(nearest("e", names), None);
    }
}
