//! Texts whose effect the user declares. A declared effect is for what the control's own language does not have: a
//! code, a word or a statement of it does what the control does, whatever is declared.

use super::block::Effect;
use super::facts::LineForm;
use super::orders::{Act, ModeOrder, Orders};
use super::{InMemory, Reader, Vocabulary, own};

/// Codes that call a program of the shop, whose other words are its arguments.
const CALLS: [&str; 7] = ["G65", "G66", "G66.1", "M96", "M97", "M98", "M198"];

/// Words that begin a statement of a control: variables, jumps, loops, frames.
const STATEMENTS: [&str; 34] = [
    "#", "IF", "GOTO", "WHILE", "DO", "END", "THEN", "ELSE", "ENDIF", "GOTOF", "GOTOB", "GOTOC", "FOR", "ENDFOR",
    "LOOP", "ENDLOOP", "REPEAT", "UNTIL", "CASE", "DEF", "$", "TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE",
    "MIRROR", "AMIRROR", "FN", "LBL", "CALL LBL", "Q", "QL",
];

/// Why no effect can be declared for a text; `None` where it can.
pub(crate) fn refusal(text: &str, effect: Effect, vocabulary: &Vocabulary) -> Option<String> {
    let text = text.trim();
    let mut words = text.split_whitespace();
    if let Some(code) = words.clone().find(|word| CALLS.iter().any(|call| word.eq_ignore_ascii_case(call))) {
        let names_program = words.any(|word| word.starts_with(['P', 'p']));
        return (!names_program).then(|| {
            format!(
                "`{code}` calls different programs: declare the effect of a call with its program, as `{code} P9810`"
            )
        });
    }
    if is_statement(text) {
        return Some("it is a statement of the control's own language".to_owned());
    }
    let known = match vocabulary.family.facts().form {
        LineForm::Statements => is_known(text, effect, vocabulary).then_some(text),
        LineForm::Letters | LineForm::Keywords => {
            text.split_whitespace().find(|word| is_known(word, effect, vocabulary))
        }
    };
    known.map(|word| format!("`{word}` belongs to the control's own language, which says what it does"))
}

/// Whether a line moves an axis.
pub(crate) fn moves(line: &str, vocabulary: &Vocabulary) -> bool {
    orders(line, vocabulary).acts.iter().any(|act| match act {
        Act::Reference(_) | Act::Machine(_) | Act::EndOfTravel | Act::Move(_) | Act::Hole | Act::Orient => true,
        Act::ToolChange | Act::Dwell(_) | Act::Stop { .. } | Act::End => false,
    })
}

/// Whether a text begins as a statement of a control does: with one of its words, or with what sets a variable.
fn is_statement(text: &str) -> bool {
    let begins = |word: &&str| {
        let rest = text.get(word.len()..).filter(|_| text[..word.len()].eq_ignore_ascii_case(word));
        let is_letter = |rest: &str| rest.starts_with(|letter: char| letter.is_ascii_alphanumeric() || letter == '_');
        match *word {
            "#" | "$" => rest.is_some(),
            // Q and QL begin a parameter with its number.
            "Q" | "QL" => rest.is_some_and(|rest| {
                let after = rest.trim_start_matches(|digit: char| digit.is_ascii_digit());
                after.len() < rest.len() && after.trim_start().starts_with('=')
            }),
            _ => rest.is_some_and(|rest| !is_letter(rest)),
        }
    };
    STATEMENTS.iter().filter(|word| text.len() >= word.len() && text.is_char_boundary(word.len())).any(begins)
}

/// Whether the control knows what a text does. A tool change may name its tool.
fn is_known(text: &str, effect: Effect, vocabulary: &Vocabulary) -> bool {
    let orders = orders(text, vocabulary);
    let is_tool = |mode: &ModeOrder| effect == Effect::ToolChange && matches!(mode, ModeOrder::Tool(_));
    orders.harmless || !orders.acts.is_empty() || orders.all_modes().any(|mode| !is_tool(mode))
}

/// What the control's own language makes of a text, fields having some value.
fn orders(text: &str, vocabulary: &Vocabulary) -> Orders {
    let vocabulary = vocabulary.without_shop();
    let line = own::with_values(text.as_bytes(), &vocabulary);
    let mut reader = Reader::new(InMemory(&line), vocabulary);
    // Text in memory is read without errors.
    let _ = reader.next_block();
    reader.orders
}
