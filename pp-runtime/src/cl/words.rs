//! The major words of CL data and what becomes of each: one table.
//!
//! A word is read, or inert (it moves nothing and changes no state, so it is passed over), or refused with a reason. No
//! word is ever skipped because it is unknown: it might move the tool.

use std::cmp::Ordering;

/// Records that [`parse`](super::parse) understands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Word {
    Coolnt,
    Cutcom,
    Cutter,
    Cycle,
    Fedrat,
    From,
    Goto,
    Load,
    Loadtl,
    Msys,
    Multax,
    Opstop,
    Partno,
    Pprint,
    Rapid,
    Selctl,
    Select,
    Set,
    Spindl,
    Stop,
    Tlaxis,
    Tldata,
    Toolno,
    ToolPath,
    Trntyp,
    Units,
}

/// What becomes of a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    /// It is read.
    Modelled(Word),
    /// It says nothing that matters to the motion or the state of the machine.
    Inert,
    /// It matters and is refused until it is modelled.
    Later,
    /// It matters and is refused for this reason.
    Refused(&'static str),
    /// It belongs to a lathe.
    Turning,
}

use Use::{Inert, Later, Modelled, Refused, Turning};

const MOVES_COORDINATES: &str = "it changes the coordinates of everything behind it";
const NC_TEXT: &str = "it writes NC text that the postprocessor cannot see into";
const REDEFINES: &str = "it changes what other records mean";
const MACHINE_AXES: &str = "it commands machine axes, which the postprocessor computes itself";

/// Sorted by name; capitals only.
const TABLE: &[(&str, Use)] = &[
    ("ALIGN", Later),
    ("ARCSLP", Later),
    ("AUTOPS", Later),
    ("AUXFUN", Refused(NC_TEXT)),
    ("BREAK", Later),
    ("CALSUB", Later),
    ("CHECK", Inert),
    ("CIRCLE", Later),
    ("CLAMP", Later),
    ("CLEARP", Later),
    ("CLRSRF", Later),
    ("CNTRL", Later),
    ("COOLNT", Modelled(Word::Coolnt)),
    ("COPY", Refused(MOVES_COORDINATES)),
    ("COUPLE", Turning),
    ("CSYS", Later),
    ("CUTCOM", Modelled(Word::Cutcom)),
    ("CUTTER", Modelled(Word::Cutter)),
    ("CYCLE", Modelled(Word::Cycle)),
    ("DEFSUB", Later),
    ("DELAY", Later),
    ("DISPLAY", Inert),
    ("DISPLY", Inert),
    ("END", Inert),
    ("END-OF-PATH", Inert),
    ("ENDSUB", Later),
    ("FEDRAT", Modelled(Word::Fedrat)),
    ("FINI", Inert),
    ("FROM", Modelled(Word::From)),
    ("GODLTA", Later),
    ("GOHOME", Later),
    ("GOTO", Modelled(Word::Goto)),
    ("HEAD", Later),
    ("INDEX", Refused(MOVES_COORDINATES)),
    ("INDIRV", Later),
    ("INSERT", Refused(NC_TEXT)),
    ("INTOL", Inert),
    ("INVERSE", Later),
    ("KNOT", Later),
    ("LEADER", Inert),
    ("LETTER", Inert),
    ("LIMIT", Later),
    ("LINTOL", Later),
    ("LOAD", Modelled(Word::Load)),
    ("LOADTL", Modelled(Word::Loadtl)),
    ("LOOP", Refused("it may repeat motion")),
    ("MACHIN", Inert),
    ("MATRIX", Refused(MOVES_COORDINATES)),
    ("MCHTOL", Later),
    ("MODE", Later),
    ("MOVARC", Later),
    ("MSYS", Modelled(Word::Msys)),
    ("MULTAX", Modelled(Word::Multax)),
    ("NURBS", Later),
    ("OPSKIP", Later),
    ("OPSTOP", Modelled(Word::Opstop)),
    ("ORIGIN", Later),
    ("OUTTOL", Inert),
    ("PAINT", Inert),
    ("PARTNO", Modelled(Word::Partno)),
    ("PATTERN", Refused(MOVES_COORDINATES)),
    ("PITCH", Turning),
    ("PIVOTZ", Later),
    ("POSITN", Refused(MACHINE_AXES)),
    ("PPFUN", Refused(REDEFINES)),
    ("PPRINT", Modelled(Word::Pprint)),
    ("PPTOL", Later),
    ("PREFUN", Refused(NC_TEXT)),
    ("RAPID", Modelled(Word::Rapid)),
    ("REMARK", Inert),
    ("RESET", Later),
    ("RETRCT", Later),
    ("REWIND", Inert),
    ("ROTABL", Refused(MACHINE_AXES)),
    ("ROTATE", Refused(MOVES_COORDINATES)),
    ("ROTHED", Refused(MACHINE_AXES)),
    ("SAFETY", Later),
    ("SELCTL", Modelled(Word::Selctl)),
    ("SELECT", Modelled(Word::Select)),
    ("SEQNO", Inert),
    ("SET", Modelled(Word::Set)),
    ("SETUP", Inert),
    ("SPINDL", Modelled(Word::Spindl)),
    ("STOP", Modelled(Word::Stop)),
    ("SWITCH", Turning),
    ("SYN", Refused(REDEFINES)),
    ("SYS", Later),
    ("THREAD", Turning),
    ("TLAXIS", Modelled(Word::Tlaxis)),
    ("TLDATA", Modelled(Word::Tldata)),
    ("TLON", Later),
    ("TMARK", Inert),
    ("TOOL PATH", Modelled(Word::ToolPath)),
    ("TOOLNO", Modelled(Word::Toolno)),
    ("TPRINT", Inert),
    ("TRACUT", Later),
    ("TRANS", Later),
    ("TRNTYP", Modelled(Word::Trntyp)),
    ("TURRET", Turning),
    ("UNIT", Modelled(Word::Units)),
    ("UNITS", Modelled(Word::Units)),
    ("UNLOAD", Later),
];

/// Prefix of the tool descriptions of SolidWorks CAM (`CSI_SET_FLUTE_LENGTH/70.`).
const TOOL_DESCRIPTION: &[u8] = b"CSI_";

/// Looks a major word up, whatever its case. The name comes back as the table spells it.
pub(super) fn look_up(word: &[u8]) -> Option<(&'static str, Use)> {
    // Nearly every record.
    if word.eq_ignore_ascii_case(b"GOTO") {
        return Some(("GOTO", Modelled(Word::Goto)));
    }
    let found = TABLE.binary_search_by(|(name, _)| compare(name.as_bytes(), word));
    match found {
        Ok(index) => Some(TABLE[index]),
        Err(_) => {
            let described = word.get(..TOOL_DESCRIPTION.len())?.eq_ignore_ascii_case(TOOL_DESCRIPTION);
            described.then_some(("CSI_", Inert))
        }
    }
}

fn compare(name: &[u8], word: &[u8]) -> Ordering {
    name.iter().copied().cmp(word.iter().map(u8::to_ascii_uppercase))
}

/// The known word that `word` is probably meant to be.
pub(super) fn nearest(word: &str) -> Option<&'static str> {
    /// Two slips of the finger; more would be guessing.
    const SLIPS: usize = 2;
    if word.len() > 16 {
        return None;
    }
    let word = word.to_ascii_uppercase();
    let allowed = SLIPS.min(word.len() / 3);
    // Words of another length cannot be near, and the search is the costliest thing done for a fault.
    let similar = TABLE.iter().map(|(name, _)| *name).filter(|name| name.len().abs_diff(word.len()) <= allowed);
    let (distance, name) =
        similar.map(|name| (strsim::damerau_levenshtein(&word, name), name)).min_by_key(|(distance, _)| *distance)?;
    (distance <= allowed).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_sorted_and_has_no_word_twice() {
        assert!(TABLE.windows(2).all(|pair| pair[0].0 < pair[1].0));
    }

    #[test]
    fn words_are_found_in_any_case() {
        assert_eq!(look_up(b"goto"), Some(("GOTO", Modelled(Word::Goto))));
        assert_eq!(look_up(b"End-Of-Path"), Some(("END-OF-PATH", Inert)));
        assert_eq!(look_up(b"csi_set_flute_length"), Some(("CSI_", Inert)));
        assert_eq!(look_up(b"CSI"), None);
        assert_eq!(look_up(b""), None);
    }

    #[test]
    fn a_slip_of_the_finger_finds_the_word_and_gibberish_finds_none() {
        assert_eq!(nearest("GOTTO"), Some("GOTO"));
        assert_eq!(nearest("fedart"), Some("FEDRAT"));
        assert_eq!(nearest("SPINDLE"), Some("SPINDL"));
        assert_eq!(nearest("sfsdfsdf"), None);
        assert_eq!(nearest("X"), None);
    }
}
