//! PPWORD: the vocabulary of G-POST, a postprocessor of Creo.
//!
//! `PPWORD/word,n` gives a word its number in that vocabulary, and moves nothing. Words mean here what their name says,
//! so a word that is read here may only have its own number: that of another word, or a word in place of a number,
//! would give it another meaning.

use super::Record;
use super::words::look_up;
use crate::cl::text::{Arg, Args, ClFault, quoted, whole_number};
use crate::diag::code::cl;

/// Numbers of words that are in the table of words here, in the vocabulary of IBM's APT (`aptwords.tbl`), which G-POST
/// extends.
#[rustfmt::skip]
const NUMBERS: [(&str, u32); 50] = [
    ("END", 1), ("STOP", 2), ("OPSTOP", 3), ("RAPID", 5), ("SWITCH", 6), ("RETRCT", 7), ("UNLOAD", 10), ("RESET", 15),
    ("HEAD", 1002), ("MODE", 1003), ("CLEARP", 1004), ("TMARK", 1005), ("REWIND", 1006), ("CUTCOM", 1007), ("FEDRAT", 1009),
    ("DELAY", 1010), ("OPSKIP", 1012), ("LEADER", 1013), ("MACHIN", 1015), ("MCHTOL", 1016), ("PIVOTZ", 1017), ("SEQNO", 1019),
    ("DISPLY", 1021), ("AUXFUN", 1022), ("CHECK", 1023), ("TOOLNO", 1025), ("ROTABL", 1026), ("ORIGIN", 1027), ("SAFETY", 1028),
    ("ARCSLP", 1029), ("COOLNT", 1030), ("SPINDL", 1031), ("TURRET", 1033), ("ROTHED", 1035), ("THREAD", 1036), ("TRANS", 1037),
    ("TRACUT", 1038), ("INDEX", 1039), ("COPY", 1040), ("LETTER", 1043), ("PPRINT", 1044), ("PARTNO", 1045), ("INSERT", 1046),
    ("CAMERA", 1047), ("PREFUN", 1048), ("CYCLE", 1054), ("LOADTL", 1055), ("SELCTL", 1056), ("CLRSRF", 1057), ("CLAMP", 1060),
];

/// PPWORD: pairs of a word and its number.
pub(super) fn vocabulary<'a>(args: &mut Args<'a>) -> Result<Record<'a>, ClFault> {
    let mut word = args.needed()?;
    loop {
        let next = args.next()?;
        let number = next.and_then(|arg| whole_number(arg.text));
        if look_up(word.text).is_some() && number.is_none_or(|number| is_of_another(word, number)) {
            let text = format!("PPWORD is refused: it may change the meaning of {}", quoted(word.text));
            let help = "delete this line if the word has its usual meaning in this file";
            return Err(cl::UNKNOWN_WORD.cl_fault("PPWORD", word.at, text, help));
        }
        // A word of the vocabulary may begin with a digit.
        let after = if number.is_some() { args.next()? } else { next };
        let Some(after) = after else { return Ok(Record::Inert) };
        word = after;
    }
}

/// Whether a number is that of another word.
fn is_of_another(word: Arg<'_>, number: f64) -> bool {
    let owner = NUMBERS.iter().find(|(_, known)| (f64::from(*known) - number).abs() < 0.5);
    let own = NUMBERS.iter().find(|(name, _)| word.is(name));
    match (owner, own) {
        (Some((owner, _)), _) => !word.is(owner),
        (None, own) => own.is_some(),
    }
}
