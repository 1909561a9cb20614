//! Token streams to declarations.
//!
//! A mistake that leaves no doubt about what was meant (a missing semicolon, `=` for `:`, another bracket) is reported,
//! and reading goes on as if it were written correctly, so that it has no consequences. Where the meaning is in doubt
//! the field is skipped, and later messages do not mention what it would have declared.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser};
use syn::{Token, token};

use super::arithmetic::expression;
use super::ast::{Declaration, Offsets, SpannedName, Unreadable};
use super::chain::chain;
use super::entries::{assigns, dimension, vector};
use super::equations::verify;
use super::fields::{FIELDS, Field, field_meant, field_named, list_of_fields};
use super::source::{Source, expected, last_token, peek_mark, peeked, peeked_word};
use super::values::{direction, limits, sign, speed, up};
use crate::report::{Errors, Refused};

/// Reads a declaration.
///
/// # Errors
/// All syntax errors, if there is no struct to read.
pub fn parse(tokens: TokenStream, errors: &mut Errors) -> Result<Declaration, Refused> {
    let source = Source::default();
    let mut found = None;
    let read = |input: ParseStream<'_>| {
        found = Some(declaration(input, &source));
        Ok(())
    };
    // Tokens that a failed field leaves unread in its brackets are covered by the message of that field.
    let rest = read.parse2(tokens);
    let (mistakes, unreadable) = source.finish();
    errors.append(mistakes);
    match (found, rest) {
        (Some(Ok(declaration)), Ok(())) => Ok(Declaration { unreadable, ..declaration }),
        (Some(Ok(declaration)), Err(_)) if !errors.is_empty() => Ok(Declaration { unreadable, ..declaration }),
        (Some(Err(error)), _) | (_, Err(error)) => {
            errors.push_syntax(0, error);
            Err(errors.refused())
        }
        (None, Ok(())) => Err(errors.refused()),
    }
}

fn declaration(input: ParseStream<'_>, source: &Source) -> syn::Result<Declaration> {
    let attributes = input.call(syn::Attribute::parse_outer)?;
    let visibility = input.parse()?;
    if !input.peek(Token![struct]) {
        // The rest is skipped: without `struct` it has no meaning.
        let error = expected(input, "`struct`", "begin with `pub struct MyMachine;`");
        input.parse::<TokenStream>()?;
        return Err(error);
    }
    input.parse::<Token![struct]>()?;
    let start = input.fork();
    let name: syn::Ident = input.parse()?;
    if input.peek(token::Brace) {
        let (body, _) = source.take(input)?;
        source.report(
            body,
            "the struct has no body",
            format!("its fields come from `dims`: write `struct {name};` and `dims = {{ ... }};`"),
        );
        input.parse::<Option<Token![;]>>()?;
    } else {
        end(input, &start, source)?;
    }
    let mut declaration = Declaration {
        attributes,
        visibility,
        name,
        chain: None,
        offsets: None,
        signs: Vec::new(),
        directions: Vec::new(),
        dimensions: Vec::new(),
        tool_axis: None,
        up: None,
        runtime: None,
        unreadable: Unreadable::default(),
        hold: Vec::new(),
        limits: Vec::new(),
        speeds: Vec::new(),
        verify: Vec::new(),
    };
    let mut seen: Vec<SpannedName> = Vec::new();
    while !input.is_empty() {
        field(input, source, &mut declaration, &mut seen)?;
    }
    Ok(declaration)
}

/// Reads one field, or reports why it cannot be read and skips it.
fn field(
    input: ParseStream<'_>,
    source: &Source,
    declaration: &mut Declaration,
    seen: &mut Vec<SpannedName>,
) -> syn::Result<()> {
    let key = match source.name(input, "a field", format!("the fields are {}", list_of_fields())) {
        Ok(key) => key,
        Err(error) => {
            source.report_error(error);
            return skip_field(input);
        }
    };
    let Some(field) = field_named(&key.name) else {
        let text = format!("unknown field `{}`", key.name);
        let Some(meant) = field_meant(&key.name) else {
            source.report(key.phrase, text, format!("the fields are {}", list_of_fields()));
            return skip_field(input);
        };
        source.report(key.phrase, text, format!("did you mean `{}`? For example `{}`", meant.name, meant.example));
        // Read as what is meant; if that fails it meant something else.
        let known = source.mistakes();
        if separator(input, meant, source).and_then(|()| value(input, source, declaration, meant)).is_err() {
            source.forget_since(known);
            source.unreadable().add_field(meant.name);
            return skip_field(input);
        }
        return Ok(());
    };
    if field.name != "verify" && seen.iter().any(|known| known.name == key.name) {
        let braces = field.example.contains('{');
        let help = if braces { "join the two into one field" } else { "keep one of the two" };
        source.report(key.phrase, format!("the field `{}` is given twice", key.name), help);
    }
    seen.push(key);
    let read = separator(input, field, source).and_then(|()| value(input, source, declaration, field));
    if let Err(error) = read {
        source.report_error(error);
        source.unreadable().add_field(field.name);
        return skip_field(input);
    }
    Ok(())
}

/// Reads the value of a field, and its end.
fn value(input: ParseStream<'_>, source: &Source, declaration: &mut Declaration, field: Field) -> syn::Result<()> {
    let start = input.fork();
    match field.name {
        "chain" => declaration.chain = Some(chain(input, source)?),
        "d" => {
            declaration.offsets = Some(if input.peek(token::Brace) {
                Offsets::Each(assigns(input, source, field, |input, _| vector(input, source))?)
            } else {
                Offsets::Common(vector(input, source)?)
            });
        }
        "signs" => declaration.signs.extend(assigns(input, source, field, |input, key| sign(input, source, key))?),
        "axes" => declaration.directions.extend(assigns(input, source, field, |input, _| direction(input, source))?),
        "dims" => {
            declaration.dimensions.extend(assigns(input, source, field, |input, key| dimension(input, source, key))?)
        }
        "tool_axis" => declaration.tool_axis = Some(direction(input, source)?),
        "up" => declaration.up = Some(up(input, source)?),
        "hold" => declaration.hold.extend(assigns(input, source, field, |input, _| expression(input, source))?),
        "limits" => declaration.limits.extend(assigns(input, source, field, |input, key| limits(input, source, key))?),
        "speeds" => declaration.speeds.extend(assigns(input, source, field, |input, key| speed(input, source, key))?),
        "crate" => {
            let path = input.call(syn::Path::parse_mod_style);
            let help = "write the path of the runtime: `crate = ::my_runtime;`";
            declaration.runtime =
                Some(path.map_err(|error| syn::Error::new(error.span(), format!("expected a path\n\nhelp: {help}")))?);
        }
        _ => {
            declaration.verify.push(verify(input, source)?);
            input.parse::<Option<Token![;]>>()?;
            return Ok(());
        }
    }
    end(input, &start, source)
}

/// The mark between a field and its value: a colon after `chain`, nothing after `verify`, `=` after all others.
fn separator(input: ParseStream<'_>, field: Field, source: &Source) -> syn::Result<()> {
    let wanted = match field.name {
        "chain" => Some(':'),
        "verify" => None,
        _ => Some('='),
    };
    let mut marks = Vec::new();
    while let Some(TokenTree::Punct(punct)) = peeked(input)
        && (matches!(punct.as_char(), '=' | '>') || (punct.as_char() == ':' && !input.peek(Token![::])))
    {
        marks.push((source.take(input)?.0, punct.as_char()));
        // A path may begin with two colons.
        if punct.as_char() == ':' {
            break;
        }
    }
    if marks.iter().map(|(_, mark)| *mark).eq(wanted) {
        return Ok(());
    }
    let help = format!("write `{}`", field.example);
    let at = match &marks[..] {
        [] => source.phrase(input.span(), input.span()),
        [(first, _), .., (last, _)] => first.to(*last),
        [(only, _)] => *only,
    };
    match wanted {
        Some(wanted) => source.report(at, format!("expected `{wanted}` after `{}`", field.name), help),
        None => source.report(at, format!("no mark belongs after `{}`", field.name), help),
    }
    Ok(())
}

/// The semicolon that ends a field or the struct.
fn end(input: ParseStream<'_>, start: ParseStream<'_>, source: &Source) -> syn::Result<()> {
    if input.parse::<Option<Token![;]>>()?.is_some() {
        return Ok(());
    }
    let next = starts_field(input);
    if !next && !input.is_empty() {
        if peek_mark(input, ',') {
            let (phrase, _) = source.take(input)?;
            source.report(phrase, "expected `;`, found `,`", "a field ends with a semicolon");
            input.parse::<Option<Token![;]>>()?;
            return Ok(());
        }
        return Err(expected(input, "`;`", "a field ends with a semicolon"));
    }
    let Some(last) = last_token(source, start, input) else { return Ok(()) };
    let help = match peeked_word(input) {
        Some(word) => format!("`{word}` begins the next field: write `{};`", last.name),
        None => format!("every field ends with a semicolon: write `{};`", last.name),
    };
    source.report(last.phrase, format!("missing `;` after `{}`", last.name), help);
    Ok(())
}

/// True if a field begins here: its name, or a name that is followed by `=` or `:`.
pub(super) fn starts_field(input: ParseStream<'_>) -> bool {
    let ahead = input.fork();
    let Ok(TokenTree::Ident(word)) = ahead.parse() else { return false };
    let word = word.to_string();
    // `B: -` without its braces is an entry.
    let colon = ahead.peek(Token![:]) && !ahead.peek(Token![::]) && word.len() > 1;
    let known = FIELDS.iter().any(|field| field.name == word && word.len() > 1);
    ahead.peek(Token![=]) || colon || (known && (ahead.peek(token::Brace) || ahead.peek(syn::LitStr)))
}

/// Skips past the next semicolon, or up to the next field.
fn skip_field(input: ParseStream<'_>) -> syn::Result<()> {
    let known = |input: ParseStream<'_>| peeked_word(input).is_some_and(|word| field_meant(&word).is_some());
    while !input.is_empty() {
        if starts_field(input) && known(input) {
            break;
        }
        let ends = match input.parse()? {
            TokenTree::Punct(punct) => punct.as_char() == ';',
            // A block of equations needs no semicolon.
            TokenTree::Group(group) => group.delimiter() == Delimiter::Brace && peeked_word(input).is_some(),
            TokenTree::Ident(_) | TokenTree::Literal(_) => false,
        };
        if ends {
            break;
        }
    }
    Ok(())
}
