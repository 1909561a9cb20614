//! The major words of CL data and what becomes of each: one table.
//!
//! A word is read, or inert (it moves nothing and changes no state, so it is passed over), or refused with a reason. No
//! word is ever skipped because it is unknown: it might move the tool. `explain --cl` prints this table.

use std::cmp::Ordering;
use std::io::{self, Write};

/// Records that [`parse`](super::parse) understands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Word {
    Autops,
    Auxfun,
    Calsub,
    Circle,
    Clearp,
    Cntrl,
    Coolnt,
    Csys,
    Cutcom,
    Cutter,
    Cycle,
    Defsub,
    Delay,
    End,
    EndOfPath,
    Endsub,
    Fedrat,
    Fini,
    From,
    Godlta,
    Gohome,
    Goto,
    Indirv,
    Insert,
    Inverse,
    Knot,
    Lintol,
    Load,
    Loadtl,
    Machin,
    Mode,
    Movarc,
    Msys,
    Multax,
    Nurbs,
    Opskip,
    Opstop,
    Origin,
    Partno,
    Pprint,
    Prefun,
    Rapid,
    Retrct,
    Rewind,
    Rotabl,
    Selctl,
    Select,
    Set,
    Spindl,
    Stop,
    Tlaxis,
    Tldata,
    Tlon,
    Toolno,
    ToolPath,
    Tracut,
    Trans,
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
    /// It is refused for this reason; the user may know better and declare it inert.
    Refused(&'static str),
    /// It is refused for this reason and cannot be declared inert: what follows would be somewhere else.
    Hazard(&'static str),
    /// It belongs to a lathe.
    Turning,
}

use Use::{Hazard, Inert, Modelled, Refused, Turning};

const MOVES_COORDINATES: &str = "it changes the coordinates of everything behind it";
const REDEFINES: &str = "it changes what other records mean";
const MACHINE_AXES: &str = "it commands machine axes, which the postprocessor computes itself";
const OWN_MEANING: &str = "its meaning depends on the postprocessor that it was written for";
const TOLERANCE: &str = "it sets a tolerance of another postprocessor";

/// Sorted by name; capitals only. The third column says which forms are read.
const TABLE: &[(&str, Use, &str)] = &[
    ("ALIGN", Hazard(MACHINE_AXES), ""),
    ("ARCSLP", Refused(OWN_MEANING), ""),
    ("AUTOPS", Modelled(Word::Autops), "before TLON"),
    ("AUXFUN", Modelled(Word::Auxfun), "/n[,NEXT|NOW]; only codes that `[cl] auxfun` allows"),
    ("BREAK", Refused(OWN_MEANING), ""),
    ("CALSUB", Modelled(Word::Calsub), "/n"),
    ("CHECK", Inert, ""),
    ("CIRCLE", Modelled(Word::Circle), "/x,y,z,i,j,k[,r[,t,f,d,e][,TIMES,n]] and the GOTO that ends it"),
    ("CLAMP", Hazard(MACHINE_AXES), ""),
    ("CLEARP", Modelled(Word::Clearp), "/XYPLAN|YZPLAN|ZXPLAN,d; /a,b,c,d"),
    ("CLRSRF", Refused("it sets a clearance surface that is not a plane"), ""),
    ("CNTRL", Modelled(Word::Cntrl), "/x,y,z of a NURBS"),
    ("COOLNT", Modelled(Word::Coolnt), "/ON|OFF|FLOOD|MIST|THRU|AIR"),
    ("COPY", Hazard(MOVES_COORDINATES), ""),
    ("COUPLE", Turning, ""),
    ("CSYS", Modelled(Word::Csys), "/12 numbers, behind TRNTYP/WORLD,0,0,0"),
    ("CUTCOM", Modelled(Word::Cutcom), "/LEFT|RIGHT[,n][,XYPLAN]; /ON; /OFF"),
    ("CUTTER", Modelled(Word::Cutter), "/d[,r[,e,f,a,b,h]]"),
    ("CYCLE", Modelled(Word::Cycle), "/DRILL|FACE|CSINK|THRU|DEEP|BRKCHP|BORE|REAM|TAP|..; /OFF; /ON"),
    ("DEFSUB", Modelled(Word::Defsub), "/n, up to ENDSUB"),
    ("DELAY", Modelled(Word::Delay), "/seconds; /n,REV"),
    ("DISPLAY", Inert, ""),
    ("DISPLY", Inert, ""),
    ("END", Modelled(Word::End), "what follows is still read"),
    ("END-OF-PATH", Modelled(Word::EndOfPath), ""),
    ("ENDSUB", Modelled(Word::Endsub), ""),
    ("FEDRAT", Modelled(Word::Fedrat), "/v[,unit]; /unit,v; /RAPID; /INVERS,AUTO; MMPM MMPR IPM IPR PERMIN PERREV"),
    ("FINI", Modelled(Word::Fini), ""),
    ("FROM", Modelled(Word::From), "/x,y,z[,i,j,k]"),
    ("GODLTA", Modelled(Word::Godlta), "/dx,dy,dz[,i,j,k]; /d along the tool axis"),
    ("GOHOME", Modelled(Word::Gohome), "[/x,y,z[,i,j,k]]"),
    ("GOTO", Modelled(Word::Goto), "/x,y,z[,i,j,k]; /x,y,z / x,y,z .."),
    ("HEAD", Hazard(MACHINE_AXES), ""),
    ("INDEX", Hazard(MOVES_COORDINATES), ""),
    ("INDIRV", Modelled(Word::Indirv), "/i,j,k before TLON"),
    ("INSERT", Modelled(Word::Insert), "text; only with `--insert comment` or `--allow-insert`"),
    ("INTOL", Inert, ""),
    ("INVERSE", Modelled(Word::Inverse), "/ON|OFF"),
    ("KNOT", Modelled(Word::Knot), "/k,k.. of a NURBS"),
    ("LEADER", Inert, ""),
    ("LETTER", Inert, ""),
    ("LIMIT", Refused("it sets limits of axes, which the configuration states"), ""),
    ("LINTOL", Modelled(Word::Lintol), "/t; /OFF"),
    ("LOAD", Modelled(Word::Load), "/TOOL,n[,LENGTH,l][,OSETNO,o][,ADJUST,h]"),
    ("LOADTL", Modelled(Word::Loadtl), "/n[,n..][,LENGTH,l][,OSETNO,o][,ADJUST,h]"),
    ("LOOP", Hazard("it may repeat motion"), ""),
    ("MACHIN", Modelled(Word::Machin), "/name[,..]"),
    ("MATRIX", Hazard(MOVES_COORDINATES), ""),
    ("MCHTOL", Refused(TOLERANCE), ""),
    ("MODE", Modelled(Word::Mode), "/MILL; /ABSOL"),
    ("MOVARC", Modelled(Word::Movarc), "/x,y,z,i,j,k,r,ANGLE,degrees and the GOTO that ends it"),
    ("MSYS", Modelled(Word::Msys), "/x,y,z,i1,j1,k1,i2,j2,k2"),
    ("MULTAX", Modelled(Word::Multax), "[/ON|OFF]"),
    ("NURBS", Modelled(Word::Nurbs), "/ with KNOT and CNTRL behind it"),
    ("OPSKIP", Modelled(Word::Opskip), "/OFF"),
    ("OPSTOP", Modelled(Word::Opstop), ""),
    ("ORIGIN", Modelled(Word::Origin), "/x,y,z; /NOMORE; /0"),
    ("OUTTOL", Inert, ""),
    ("PAINT", Inert, ""),
    ("PARTNO", Modelled(Word::Partno), "text"),
    ("PATTERN", Hazard(MOVES_COORDINATES), ""),
    ("PITCH", Turning, ""),
    ("PIVOTZ", Hazard(MACHINE_AXES), ""),
    ("POSITN", Hazard(MACHINE_AXES), ""),
    ("PPFUN", Hazard(REDEFINES), ""),
    ("PPRINT", Modelled(Word::Pprint), "text"),
    ("PPTOL", Refused(TOLERANCE), ""),
    ("PREFUN", Modelled(Word::Prefun), "/n; only codes that `[cl] prefun` allows"),
    ("RAPID", Modelled(Word::Rapid), "the next motion only"),
    ("REMARK", Inert, ""),
    ("RESET", Refused(OWN_MEANING), ""),
    ("RETRCT", Modelled(Word::Retrct), "along the tool axis to the plane of CLEARP"),
    ("REWIND", Modelled(Word::Rewind), "[/n]"),
    ("ROTABL", Modelled(Word::Rotabl), "/SHORT; /NEXT,CLW|CCLW"),
    ("ROTATE", Hazard(MOVES_COORDINATES), ""),
    ("ROTHED", Hazard(MACHINE_AXES), ""),
    ("SAFETY", Refused(OWN_MEANING), ""),
    ("SELCTL", Modelled(Word::Selctl), "/n"),
    ("SELECT", Modelled(Word::Select), "/TOOL,n"),
    ("SEQNO", Inert, ""),
    ("SET", Modelled(Word::Set), "/MODE,ABSOL; /OFSETL,n"),
    ("SETUP", Inert, ""),
    ("SPINDL", Modelled(Word::Spindl), "/RPM, n, CLW|CCLW, ON|OFF in any order"),
    ("STOP", Modelled(Word::Stop), ""),
    ("SWITCH", Turning, ""),
    ("SYN", Hazard(REDEFINES), ""),
    ("SYS", Modelled(Word::Msys), "/ as MSYS"),
    ("THREAD", Turning, ""),
    ("TLAXIS", Modelled(Word::Tlaxis), "/i,j,k"),
    ("TLDATA", Modelled(Word::Tldata), "/MILL,d,r,..; /DRILL[,word],d,.."),
    ("TLON", Modelled(Word::Tlon), ",GOFWD/ (CIRCLE/ c,r),ON,[2,INTOF,](LINE/ c,e)"),
    ("TMARK", Inert, ""),
    ("TOOL PATH", Modelled(Word::ToolPath), "/name,TOOL,name"),
    ("TOOLNO", Modelled(Word::Toolno), "/n,.. describes a tool and changes nothing"),
    ("TPRINT", Inert, ""),
    ("TRACUT", Modelled(Word::Tracut), "/12 numbers of a rigid motion; /NOMORE; /0"),
    ("TRANS", Modelled(Word::Trans), "/x,y,z; /NOMORE; /0"),
    ("TRNTYP", Modelled(Word::Trntyp), "/WORLD,0,0,0"),
    ("TURRET", Turning, ""),
    ("UNIT", Modelled(Word::Units), "/MM|INCH"),
    ("UNITS", Modelled(Word::Units), "/MM|INCH|INCHES"),
    ("UNLOAD", Refused("it leaves the spindle without a tool"), ""),
];

/// Prefix of the tool descriptions of SolidWorks CAM (`CSI_SET_FLUTE_LENGTH/70.`).
const TOOL_DESCRIPTION: &[u8] = b"CSI_";

/// Looks a major word up, whatever its case. The name comes back as the table spells it.
pub(super) fn look_up(word: &[u8]) -> Option<(&'static str, Use)> {
    let found = TABLE.binary_search_by(|(name, ..)| compare(name.as_bytes(), word));
    match found {
        Ok(index) => Some((TABLE[index].0, TABLE[index].1)),
        Err(_) => {
            let described = word.get(..TOOL_DESCRIPTION.len())?.eq_ignore_ascii_case(TOOL_DESCRIPTION);
            described.then_some(("CSI_", Inert))
        }
    }
}

/// What is read of a word, as the help of a message.
pub(super) fn form(name: &str) -> Option<String> {
    let (_, usage, forms) = TABLE.iter().find(|(known, ..)| *known == name)?;
    let read = matches!(usage, Modelled(_)) && forms.starts_with(['/', '[']);
    read.then(|| format!("what is read is {name}{forms}"))
}

/// Why a word cannot be declared inert; `None` if it can.
#[must_use]
pub fn not_inert(word: &str) -> Option<String> {
    if word.is_empty() || !word.bytes().all(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b' ')) {
        return Some(format!("`{word}` is not a word of CL data"));
    }
    match look_up(word.as_bytes())?.1 {
        Modelled(_) => Some(format!("{word} is read, so it cannot be inert")),
        Hazard(reason) => Some(format!("{word} cannot be inert: {reason}")),
        Turning => Some(format!("{word} cannot be inert: it belongs to a lathe")),
        Inert | Refused(_) => None,
    }
}

/// Writes what becomes of each word.
///
/// # Errors
/// Those of the output.
pub fn list(out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "Words of CL data. A word that is not listed is refused, unless `--inert WORD` says that it is inert."
    )?;
    writeln!(out, "\nRead")?;
    for (name, usage, forms) in TABLE {
        if let Modelled(_) = usage {
            let glue = if forms.starts_with(['/', ',', '[']) || forms.is_empty() { "" } else { " " };
            writeln!(out, "    {name}{glue}{forms}")?;
        }
    }
    writeln!(out, "\nInert: nothing that moves an axis or changes a state")?;
    for (name, usage, _) in TABLE {
        if let Inert = usage {
            writeln!(out, "    {name}")?;
        }
    }
    writeln!(out, "    CSI_..")?;
    writeln!(out, "\nRefused, unless `--inert WORD` says that it is inert")?;
    for (name, usage, _) in TABLE {
        if let Refused(reason) = usage {
            writeln!(out, "    {name:<11} {reason}")?;
        }
    }
    writeln!(out, "\nRefused always")?;
    for (name, usage, _) in TABLE {
        match usage {
            Hazard(reason) => writeln!(out, "    {name:<11} {reason}")?,
            Turning => writeln!(out, "    {name:<11} it belongs to a lathe")?,
            _ => {}
        }
    }
    Ok(())
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
    let similar = TABLE.iter().map(|(name, ..)| *name).filter(|name| name.len().abs_diff(word.len()) <= allowed);
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
        assert_eq!(look_up(b"End-Of-Path"), Some(("END-OF-PATH", Modelled(Word::EndOfPath))));
        assert_eq!(look_up(b"csi_set_flute_length"), Some(("CSI_", Inert)));
        assert_eq!(look_up(b"CSI"), None);
        assert_eq!(look_up(b""), None);
    }

    #[test]
    fn only_what_moves_nothing_can_be_declared_inert() {
        for word in ["GOTO", "LOOP", "SYN", "COPY", "TURRET", "", "A/B"] {
            assert!(not_inert(word).is_some(), "{word}");
        }
        for word in ["AICC", "FIXOFTCO", "BREAK", "PAINT"] {
            assert_eq!(not_inert(word), None, "{word}");
        }
    }

    #[test]
    fn the_list_names_every_word_once() {
        let mut text = Vec::new();
        list(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        for (name, ..) in TABLE {
            let listed = text.lines().filter(|line| {
                let word = line.trim_start().split(['/', ',', '[']).next().unwrap();
                line.starts_with("    ") && (word == *name || word.starts_with(&format!("{name} ")))
            });
            assert_eq!(listed.count(), 1, "{name}");
        }
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
