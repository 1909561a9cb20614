//! Lines that the user brings in: their texts, their places, and their effects.
//!
//! A line that the table reads without a fault has the effect of its codes, whoever wrote it. A line or a word that the
//! table does not have is executed by the effect that `[control] effects` declares for it, and only in a line of the
//! configuration; clamp, coolant and tip control codes have the effect of their keys.

use super::Vocabulary;
use super::block::{Effect, OwnLine, OwnPlace};
use super::draft::{Draft, effect};
use super::facts::Form;
use super::line::Line;
use super::text::shown;

/// A line of the configuration.
#[derive(Debug, Clone)]
pub(crate) struct OwnText {
    /// The line, with fields in braces.
    pub(crate) text: Vec<u8>,
    pub(crate) place: OwnPlace,
    /// Kinds of a coolant code, and whether it switches them on.
    pub(crate) coolant: Option<(u8, bool)>,
}

/// What is declared for a line: the effect, and its bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Declared {
    effect: Effect,
    bits: u8,
    /// The line is declared as a whole.
    whole: bool,
}

/// The line without its block number, and where it begins.
fn text_of(line: &[u8], numbered: bool) -> (&[u8], usize) {
    let start = line.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(line.len());
    let rest = &line[start..];
    let letter = usize::from(rest.first() == Some(&b'N'));
    let digits = rest[letter..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let end = letter + digits;
    let number = digits > 0 && (letter == 1 || numbered) && rest.get(end).is_none_or(|byte| *byte == b' ');
    let begin = if number { (start + end + 1).min(line.len()) } else { start };
    (line[begin..].trim_ascii(), begin)
}

/// What is declared for a line or for words of it, if it is one of the configuration or declared as a whole. `blanked`
/// receives the line without them.
#[inline]
pub(super) fn declared(line: &[u8], vocabulary: &Vocabulary, blanked: &mut Vec<u8>) -> Option<Declared> {
    if vocabulary.effects.is_empty() {
        return None;
    }
    search(line, vocabulary, blanked)
}

fn search(line: &[u8], vocabulary: &Vocabulary, blanked: &mut Vec<u8>) -> Option<Declared> {
    let numbered = vocabulary.family.facts().form == Form::Statements;
    let (text, begin) = text_of(line, numbered);
    blanked.clear();
    blanked.extend_from_slice(line);
    if let Some((_, effect)) = vocabulary.effects.iter().find(|(key, _)| matches(key, text)) {
        blanked[begin..].fill(b' ');
        return Some(Declared { effect: *effect, bits: bits(*effect), whole: true });
    }
    let mut found: Option<Declared> = None;
    let mut at = begin;
    for word in line[begin..].split(|byte| *byte == b' ') {
        if let Some((_, effect)) = vocabulary.effects.iter().find(|(key, _)| key == word) {
            blanked[at..at + word.len()].fill(b' ');
            let before = found.unwrap_or(Declared { effect: Effect::None, bits: 0, whole: false });
            let (effect, bits) = (before.effect.max(*effect), before.bits | bits(*effect));
            found = Some(Declared { effect, bits, whole: false });
        }
        at += word.len() + 1;
    }
    found.filter(|_| vocabulary.own.iter().any(|own| matches(&own.text, text)))
}

fn bits(declared: Effect) -> u8 {
    match declared {
        Effect::None => 0,
        Effect::Coolant => effect::COOLANT,
        Effect::Spindle => effect::SPINDLE,
        Effect::Measures | Effect::PositionLost => effect::POSITION,
        Effect::Stop => effect::STOP,
        Effect::StateLost => effect::STATE,
    }
}

/// Executes a code of clamps, coolant or tip control; whether the line is one.
#[inline]
pub(super) fn switch(text: &[u8], line: &mut Line<'_>) -> bool {
    let vocabulary = line.vocabulary;
    let (text, _) = text_of(text, line.facts.form == Form::Statements);
    let mut found = false;
    for own in vocabulary.own.iter().filter(|own| own.text == text) {
        let draft = &mut *line.draft;
        match own.place {
            OwnPlace::Clamp { axis, on: true } => draft.clamp_on |= 1 << axis,
            OwnPlace::Clamp { axis, on: false } => draft.clamp_off |= 1 << axis,
            OwnPlace::Coolant => match own.coolant {
                // In the place of what the control's own code of this spelling switches on.
                Some((bits, true)) if found => draft.coolant_on |= bits,
                Some((bits, true)) => draft.coolant_on = bits,
                Some((bits, false)) => draft.coolant_off |= bits,
                None => {}
            },
            OwnPlace::TipControl { on } => draft.tip_control = Some(on),
            _ => continue,
        }
        found = true;
        draft.speaks();
    }
    found
}

/// The own line that a line is, and what is wrong with it: an effect that is not declared.
#[cold]
pub(super) fn resolve(text: &[u8], line: &mut Line<'_>, declared: Option<Declared>, switched: bool) -> Option<OwnLine> {
    let (text, _) = text_of(text, line.facts.form == Form::Statements);
    let mut own = line.vocabulary.own.iter().filter(|own| matches(&own.text, text));
    let switches =
        |place: OwnPlace| matches!(place, OwnPlace::Clamp { .. } | OwnPlace::Coolant | OwnPlace::TipControl { .. });
    let place = if switched { own.find(|own| switches(own.place)) } else { own.next() }.map(|own| own.place);
    let effect = declared.map(|declared| declared.effect);
    if let Some(Declared { bits, whole, .. }) = declared {
        line.draft.effects = bits;
        line.draft.speaks();
        if whole || line.faults.len() == line.draft.frame_faults {
            return Some(OwnLine { place: place.unwrap_or(OwnPlace::Insert), effect });
        }
    }
    let place = place?;
    if switched {
        line.faults.truncate(line.draft.frame_faults);
        return Some(OwnLine { place, effect });
    }
    if line.faults.len() > line.draft.frame_faults {
        // What it does is unknown, so nothing of it is executed.
        let Draft { number, frame_faults, .. } = *line.draft;
        *line.draft = Draft { number, frame_faults, ..Draft::default() };
        line.faults.truncate(frame_faults);
        let text = format!(
            "`{}` is a line of the configuration with a code that the check does not know: declare its effect in \
             `[control] effects`",
            shown(text)
        );
        line.fault(0, text);
    }
    Some(OwnLine { place, effect })
}

/// Whether a line is a template with values for its fields. A word whose field has no value is left out.
fn matches(template: &[u8], line: &[u8]) -> bool {
    if !template.contains(&b'{') {
        return template == line;
    }
    let split = |text: &[u8]| text.iter().position(|byte| *byte == b' ').unwrap_or(text.len());
    let (end, word_end) = (split(template), split(line));
    let (word, rest) = (&template[..end], template.get(end + 1..));
    let after = line.get(word_end + 1..);
    let goes_on = match (rest, after) {
        (None, None) => true,
        (Some(rest), Some(after)) => matches(rest, after),
        // The words that are left have no value.
        (Some(rest), None) => rest.split(|byte| *byte == b' ').all(|word| word.contains(&b'{')),
        (None, Some(_)) => false,
    };
    if goes_on && fits(word, &line[..word_end]) {
        return true;
    }
    // A value with a blank in it: `G54.1 P3`, a name.
    if word.contains(&b'{') {
        if let Some(rest) = rest
            && matches(rest, line)
        {
            return true;
        }
        return line.iter().enumerate().filter(|(_, byte)| **byte == b' ').any(|(blank, _)| {
            let next = line[blank + 1..].iter().position(|byte| *byte == b' ').map(|at| blank + 1 + at);
            let stop = next.unwrap_or(line.len());
            fits(word, &line[..stop])
                && match rest {
                    Some(rest) => next.is_some_and(|next| matches(rest, &line[next + 1..])),
                    None => next.is_none(),
                }
        });
    }
    false
}

/// Whether a text is a word of a template.
fn fits(word: &[u8], text: &[u8]) -> bool {
    let Some(open) = word.iter().position(|byte| *byte == b'{') else { return word == text };
    let Some(close) = word.iter().position(|byte| *byte == b'}') else { return false };
    if !text.starts_with(&word[..open]) {
        return false;
    }
    let (field, rest, value) = (&word[open + 1..close], &word[close + 1..], &text[open..]);
    (1..=value.len()).any(|length| is_value(field, &value[..length]) && fits(rest, &value[length..]))
}

/// Whether a text can be the value of a field.
fn is_value(field: &[u8], value: &[u8]) -> bool {
    match field {
        b"tool" | b"next" | b"offset" | b"number" => value.iter().all(u8::is_ascii_digit),
        b"speed" | b"path_tolerance" => value.iter().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'-')),
        b"units" | b"work_offset" => {
            value.iter().all(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b' '))
        }
        _ => true,
    }
}
