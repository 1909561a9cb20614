//! `chain: C B | X Y Z`: letters and bars, with one message for each kind of mistake in their form.
//!
//! Letters are read whatever their form is, so that the rules of the chain are checked in the same compilation.

use proc_macro2::{Delimiter, TokenTree};
use syn::Token;
use syn::parse::ParseStream;

use super::ast::{Chain, SpannedName};
use super::parse::starts_field;
use super::source::{Source, peeked_word, refused};
use crate::model::kind_of;
use crate::report::Phrase;

/// What the letters of a chain look like, and the marks between them.
#[derive(Default)]
struct Form {
    lower_case: bool,
    joined: bool,
    /// `X1`, `X2`: their names as written.
    numbered: Vec<SpannedName>,
    /// Marks that do not belong in the chain, each with the number of letters before it.
    marks: Vec<(SpannedName, usize)>,
    /// Brackets or quotes around it.
    enclosed: Option<Phrase>,
}

/// Reads a chain up to its semicolon or the next field.
pub(crate) fn chain(input: ParseStream<'_>, source: &Source) -> syn::Result<Chain> {
    let mut chain = Chain { phrase: source.phrase(input.span(), input.span()), axes: Vec::new(), bars: Vec::new() };
    let mut form = Form::default();
    let start = chain.phrase;
    while !input.is_empty() {
        let semicolon = input.peek(Token![;]);
        if starts_field(input) || (semicolon && !(chain.bars.is_empty() && letter_after_semicolon(input))) {
            break;
        }
        let (phrase, token) = source.take(input)?;
        chain.phrase = start.to(phrase);
        if semicolon {
            source.report(
                phrase,
                "`;` ends the chain before its other side",
                "the machine frame is `|`: `chain: C B | X Y Z;`",
            );
            chain.bars.push((chain.axes.len(), phrase));
            continue;
        }
        form.token(phrase, token, &mut chain, source);
    }
    if chain.axes.iter().all(|axis| kind_of(&axis.name).is_none()) {
        let help =
            "list the axes from the workpiece to the tool, with `|` for the machine frame: `chain: C B | X Y Z;`";
        return Err(refused(chain.phrase, "the chain has no axis letters", help));
    }
    form.report(&mut chain, source);
    Ok(chain)
}

/// True if an axis letter comes after the semicolon that comes next, and no field.
fn letter_after_semicolon(input: ParseStream<'_>) -> bool {
    let ahead = input.fork();
    ahead.parse::<Token![;]>().is_ok()
        && !starts_field(&ahead)
        && peeked_word(&ahead).is_some_and(|word| kind_of(&word).is_some())
}

impl Form {
    fn token(&mut self, phrase: Phrase, token: TokenTree, chain: &mut Chain, source: &Source) {
        match token {
            TokenTree::Ident(ident) => self.word(&ident.to_string(), phrase, chain),
            TokenTree::Punct(punct) if punct.as_char() == '|' => chain.bars.push((chain.axes.len(), phrase)),
            TokenTree::Group(group) if group.delimiter() != Delimiter::None => {
                self.enclosed.get_or_insert(phrase);
                self.tokens(group.stream(), phrase, chain, source);
            }
            TokenTree::Literal(literal) => {
                let text = literal.to_string();
                match text.trim_matches('"').parse::<proc_macro2::TokenStream>() {
                    Ok(tokens) if text.starts_with('"') => {
                        self.enclosed.get_or_insert(phrase);
                        self.tokens(tokens, phrase, chain, source);
                    }
                    _ => self.mark(text, phrase, chain),
                }
            }
            other => self.mark(other.to_string(), phrase, chain),
        }
    }

    /// A mark or a number; `->` counts as one.
    fn mark(&mut self, name: String, phrase: Phrase, chain: &Chain) {
        let place = chain.axes.len();
        match self.marks.last_mut() {
            Some((arrow, known)) if *known == place && name == ">" && arrow.name == "-" => {
                *arrow = SpannedName { name: "->".into(), phrase: arrow.phrase.to(phrase) };
            }
            _ => self.marks.push((SpannedName { name, phrase }, place)),
        }
    }

    fn tokens(&mut self, tokens: proc_macro2::TokenStream, phrase: Phrase, chain: &mut Chain, source: &Source) {
        for token in tokens {
            // The tokens of a string have no place of their own.
            let own =
                if matches!(token, TokenTree::Group(_)) { phrase } else { source.phrase(token.span(), token.span()) };
            self.token(own, token, chain, source);
        }
    }

    /// One word: a letter, or several in one piece.
    fn word(&mut self, word: &str, phrase: Phrase, chain: &mut Chain) {
        let upper = word.to_uppercase();
        let letters: Vec<String> = upper.chars().map(String::from).collect();
        let number = upper.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
        let all_letters = letters.iter().all(|letter| kind_of(letter).is_some());
        if kind_of(&upper).is_some() {
            self.lower_case |= upper != word;
            chain.axes.push(SpannedName { name: upper, phrase });
        } else if all_letters && distinct(&letters) {
            self.joined = true;
            self.lower_case |= upper != word;
            chain.axes.extend(letters.into_iter().map(|name| SpannedName { name, phrase }));
        } else if kind_of(number).is_some() {
            if self.numbered.iter().all(|known| !known.name.to_uppercase().starts_with(number)) {
                chain.axes.push(SpannedName { name: number.to_string(), phrase });
            }
            self.numbered.push(SpannedName { name: word.to_string(), phrase });
        } else {
            chain.axes.push(SpannedName { name: word.to_string(), phrase });
        }
    }

    /// Reports the form of the whole chain, with the chain as it should be written.
    fn report(self, chain: &mut Chain, source: &Source) {
        let Self { lower_case, joined, numbered, marks, enclosed } = self;
        if let Some((mark, place)) = marks.first() {
            let text = format!("`{}` does not belong in the chain", mark.name);
            // A single mark between letters is where the bar should be.
            let frame =
                chain.bars.is_empty() && marks.len() == 1 && mark.name != "," && (1..chain.axes.len()).contains(place);
            if frame {
                chain.bars.push((*place, mark.phrase));
                source.report(mark.phrase, text, format!("the machine frame is written `|`: `{chain}`"));
            } else {
                source.report(mark.phrase, text, format!("separate the letters by blanks: `{chain}`"));
            }
        } else if let Some(enclosed) = enclosed {
            source.report(enclosed, "the chain has no brackets and no quotes", format!("write `{chain}`"));
        } else if joined {
            source.report(chain.phrase, "axis letters are written apart", format!("write `{chain}`"));
        } else if lower_case {
            source.report(chain.phrase, "axis letters are capitals", format!("write `{chain}`"));
        }
        report_numbered(&numbered, source);
    }
}

/// Two motors of one axis, or a letter with a number.
fn report_numbered(numbered: &[SpannedName], source: &Source) {
    let letter = |name: &SpannedName| name.name.to_uppercase().chars().next();
    for (place, name) in numbered.iter().enumerate() {
        let Some(axis) = letter(name) else { continue };
        if numbered[..place].iter().any(|known| letter(known) == Some(axis)) {
            continue;
        }
        let twins: Vec<&SpannedName> = numbered[place..].iter().filter(|other| letter(other) == Some(axis)).collect();
        match &twins[..] {
            [_, .., last] => source.report(
                name.phrase.to(last.phrase),
                format!("`{}` and `{}` are two motors of one axis", name.name, last.name),
                format!("the control moves them together: list the axis once, as `{axis}`"),
            ),
            _ => source.report(
                name.phrase,
                format!("`{}` is not an axis letter", name.name),
                format!("letters of the chain have no number: write `{axis}`"),
            ),
        }
    }
}

fn distinct(letters: &[String]) -> bool {
    letters.iter().enumerate().all(|(place, letter)| !letters[..place].contains(letter))
}
