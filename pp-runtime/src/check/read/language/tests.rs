//! Completeness of the tables.

use super::super::text::{Cursor, tenths};
use super::print::group_name;
use super::*;

const FAMILIES: [Family; 5] = [Family::LinuxCnc, Family::Fanuc, Family::Haas, Family::Siemens, Family::Heidenhain];

#[test]
fn every_code_is_found_by_its_spelling_and_by_nothing_else() {
    for family in FAMILIES {
        let language = family.language();
        for row in language.codes {
            let mut at = Cursor::new(row.spelling.as_bytes());
            let (letter, number) = at.letter_and_number().expect("a code");
            let found = language.code(letter, tenths(number).expect("tenths")).expect("a row");
            assert_eq!(found.spelling, row.spelling, "{family:?}");
        }
        for pair in language.codes.windows(2) {
            assert!(pair[0].last < pair[1].key, "{family:?}: {} and {}", pair[0].spelling, pair[1].spelling);
        }
        assert!(language.code(b'G', 770).is_none() && language.code(b'M', 550).is_none());
    }
    let siemens = Family::Siemens.language();
    assert_eq!(siemens.code(b'G', 5070).map(|row| row.spelling), Some("G505"));
    assert!(siemens.code(b'G', 5041).is_none() && siemens.code(b'G', 6000).is_none());
    assert!(Family::LinuxCnc.language().code(b'G', 555).is_none());
}

#[test]
fn every_row_has_a_meaning_and_a_source() {
    for family in FAMILIES {
        let language = family.language();
        for row in language.codes.iter().chain(language.letters).chain(language.words) {
            assert!(!row.source.is_empty() && !row.means.text().is_empty(), "{family:?}: {}", row.spelling);
            assert!(row.means.effect().iter().all(|text| !text.is_empty()), "{family:?}: {}", row.spelling);
        }
        let has_name = |row: &&CodeRow| row.group == group::FREE || group_name(row.group).is_some();
        let nameless: Vec<&str> = language.codes.iter().filter(|row| !has_name(row)).map(|row| row.spelling).collect();
        assert_eq!(nameless, [""; 0], "{family:?}");
        let mut printed = Vec::new();
        table(family, &mut printed).expect("memory");
        let printed = String::from_utf8(printed).expect("ASCII");
        assert!(language.codes.iter().all(|row| printed.contains(row.spelling)), "{printed}");
    }
}
