//! Token streams to declarations. A field that cannot be parsed is reported and skipped; parsing continues after it.

use proc_macro2::{TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser};
use syn::{Token, token};

use super::arithmetic::expression;
use super::ast::{Assign, Base, Chain, Declaration, Direction, Equation, Limits, Offsets, SpannedName, Vector, Verify};
use super::source::Source;
use crate::report::{Errors, Phrase, Refused};

/// Fields of the language, in the order of the documentation.
const FIELDS: [&str; 10] = ["chain", "d", "signs", "axes", "dims", "tool_axis", "hold", "limits", "speeds", "verify"];

/// Reads a declaration.
///
/// # Errors
/// All syntax errors, if the struct or any field cannot be read.
pub fn parse(tokens: TokenStream, errors: &mut Errors) -> Result<Declaration, Refused> {
    let mut found = None;
    let read = |input: ParseStream<'_>| {
        found = Some(declaration(input, errors));
        Ok(())
    };
    // Tokens that a failed field leaves unread in its brackets are covered by the message of that field.
    let rest = read.parse2(tokens);
    match (found, rest) {
        (Some(Ok(declaration)), Ok(())) => Ok(declaration),
        (Some(Ok(declaration)), Err(_)) if !errors.is_empty() => Ok(declaration),
        (Some(Err(error)), _) | (_, Err(error)) => {
            errors.push_syntax(0, error);
            Err(errors.refused())
        }
        (None, Ok(())) => Err(errors.refused()),
    }
}

fn declaration(input: ParseStream<'_>, errors: &mut Errors) -> syn::Result<Declaration> {
    let source = Source::default();
    let attributes = input.call(syn::Attribute::parse_outer)?;
    let visibility = input.parse()?;
    if !input.peek(Token![struct]) {
        // The rest is skipped: without `struct` it has no meaning.
        let error = input.error("expected `struct`\n\nhelp: begin with `pub struct MyMachine;`");
        input.parse::<TokenStream>()?;
        return Err(error);
    }
    input.parse::<Token![struct]>()?;
    let name = input.parse()?;
    if !input.peek(Token![;]) {
        let error = input.error("expected `;` after the name\n\nhelp: the struct has no body, its fields come from `dims`: write `pub struct MyMachine;`");
        input.parse::<TokenStream>()?;
        return Err(error);
    }
    input.parse::<Token![;]>()?;
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
        unreadable: Vec::new(),
        hold: Vec::new(),
        limits: Vec::new(),
        speeds: Vec::new(),
        verify: Vec::new(),
    };
    let mut seen: Vec<SpannedName> = Vec::new();
    while !input.is_empty() {
        if let Err(error) = field(input, &source, &mut declaration, &mut seen, errors) {
            errors.push_syntax(source.next(), error);
            declaration.unreadable.extend(seen.last().map(|field| field.name.clone()));
            skip_field(input)?;
        }
    }
    Ok(declaration)
}

fn field(
    input: ParseStream<'_>,
    source: &Source,
    declaration: &mut Declaration,
    seen: &mut Vec<SpannedName>,
    errors: &mut Errors,
) -> syn::Result<()> {
    let key = source.name(input, &format!("a field\n\nhelp: the fields are {}", list_of(&FIELDS)))?;
    if !FIELDS.contains(&key.name.as_str()) {
        let text = format!("unknown field `{}`\n\nhelp: the fields are {}", key.name, list_of(&FIELDS));
        return Err(syn::Error::new_spanned(key.phrase, text));
    }
    if key.name != "verify" && seen.iter().any(|known| known.name == key.name) {
        errors.push(key.phrase, format!("the field `{}` is given twice", key.name), "join the two into one field");
    }
    seen.push(key.clone());
    match key.name.as_str() {
        "chain" => {
            separator(input, ':', "`chain` is followed by a colon: `chain: C B | X Y Z;`")?;
            declaration.chain = Some(chain(input, source, key.phrase)?);
        }
        "verify" => {
            declaration.verify.push(verify(input, source, errors)?);
            input.parse::<Option<Token![;]>>()?;
            return Ok(());
        }
        name => {
            separator(input, '=', &format!("`{name}` is followed by `=`: `{name} = ...;`"))?;
            let sink = &mut ErrorSink { errors, unreadable: &mut declaration.unreadable };
            match name {
                "d" => declaration.offsets = Some(offsets(input, source, sink)?),
                "signs" => declaration.signs.extend(assigns(input, source, sink, sign)?),
                "axes" => declaration.directions.extend(assigns(input, source, sink, direction)?),
                "dims" => declaration.dimensions.extend(assigns(input, source, sink, expression)?),
                "tool_axis" => declaration.tool_axis = Some(direction(input, source)?),
                "hold" => declaration.hold.extend(assigns(input, source, sink, expression)?),
                "limits" => declaration.limits.extend(assigns(input, source, sink, limits)?),
                _ => declaration.speeds.extend(assigns(input, source, sink, expression)?),
            }
        }
    }
    if !input.peek(Token![;]) {
        return Err(input.error(format!("expected `;`\n\nhelp: end the field `{}` with a semicolon", key.name)));
    }
    input.parse::<Token![;]>()?;
    Ok(())
}

fn separator(input: ParseStream<'_>, wanted: char, help: &str) -> syn::Result<()> {
    let found = if wanted == ':' {
        input.parse::<Option<Token![:]>>()?.is_some()
    } else {
        input.parse::<Option<Token![=]>>()?.is_some()
    };
    if found { Ok(()) } else { Err(input.error(format!("expected `{wanted}`\n\nhelp: {help}"))) }
}

/// Skips past the next semicolon, or up to a word that looks like the next field.
fn skip_field(input: ParseStream<'_>) -> syn::Result<()> {
    while !input.is_empty() {
        if input.parse::<Option<Token![;]>>()?.is_some() {
            return Ok(());
        }
        input.parse::<TokenTree>()?;
        let ahead = input.fork();
        let starts_field = ahead.parse::<syn::Ident>().is_ok_and(|word| FIELDS.iter().any(|field| word == field))
            && (ahead.peek(Token![=]) || ahead.peek(Token![:]) || ahead.peek(syn::LitStr));
        if starts_field {
            return Ok(());
        }
    }
    Ok(())
}

fn chain(input: ParseStream<'_>, source: &Source, key: Phrase) -> syn::Result<Chain> {
    let mut chain = Chain { phrase: key, axes: Vec::new(), bars: Vec::new() };
    let mut first = None;
    while !input.is_empty() && !input.peek(Token![;]) {
        let (phrase, token) = source.take(input)?;
        chain.phrase = first.get_or_insert(phrase).to(phrase);
        match token {
            TokenTree::Ident(ident) => chain.axes.push(SpannedName { name: ident.to_string(), phrase }),
            TokenTree::Punct(punct) if punct.as_char() == '|' => chain.bars.push((chain.axes.len(), phrase)),
            other => {
                let text = format!(
                    "`{other}` does not belong in the chain\n\nhelp: list axis letters from workpiece to tool with one `|` for the machine frame: `chain: C B | X Y Z;`"
                );
                return Err(syn::Error::new_spanned(phrase, text));
            }
        }
    }
    Ok(chain)
}

fn offsets(input: ParseStream<'_>, source: &Source, sink: &mut ErrorSink<'_>) -> syn::Result<Offsets> {
    if input.peek(token::Brace) {
        Ok(Offsets::Each(assigns(input, source, sink, vector)?))
    } else {
        Ok(Offsets::Common(vector(input, source)?))
    }
}

/// `{ A: value, B: value }`. An entry that cannot be parsed is reported and left out; the others are kept.
fn assigns<T>(
    input: ParseStream<'_>,
    source: &Source,
    sink: &mut ErrorSink<'_>,
    value: impl Fn(ParseStream<'_>, &Source) -> syn::Result<T>,
) -> syn::Result<Vec<Assign<T>>> {
    if !input.peek(token::Brace) {
        return Err(input.error("expected `{`\n\nhelp: write `{ NAME: value, NAME: value }`"));
    }
    let content;
    syn::braced!(content in input);
    let mut list = Vec::new();
    while !content.is_empty() {
        let entry = |key: &mut Option<SpannedName>| {
            let name = source.name(&content, "a name\n\nhelp: write `NAME: value`")?;
            *key = Some(name.clone());
            separator(&content, ':', "write `NAME: value`")?;
            let assign = Assign { key: name, value: value(&content, source)? };
            if !content.is_empty() && !content.peek(Token![,]) {
                return Err(content.error("expected `,`\n\nhelp: separate the entries with commas"));
            }
            Ok(assign)
        };
        let mut key = None;
        match entry(&mut key) {
            Ok(assign) => list.push(assign),
            Err(error) => {
                sink.errors.push_syntax(source.next(), error);
                sink.unreadable.extend(key.map(|key| key.name));
                while !content.is_empty() && !content.peek(Token![,]) {
                    content.parse::<TokenTree>()?;
                }
            }
        }
        content.parse::<Option<Token![,]>>()?;
    }
    Ok(list)
}

/// Messages so far, and names of entries that could not be parsed; no later message complains about these names.
struct ErrorSink<'a> {
    errors: &'a mut Errors,
    unreadable: &'a mut Vec<String>,
}

fn sign(input: ParseStream<'_>, _: &Source) -> syn::Result<bool> {
    if input.parse::<Option<Token![+]>>()?.is_some() {
        Ok(false)
    } else if input.parse::<Option<Token![-]>>()?.is_some() {
        Ok(true)
    } else {
        Err(input.error(
            "expected `+` or `-`\n\nhelp: write `-` if a positive word moves the axis against ISO 841, otherwise `+`",
        ))
    }
}

fn vector(input: ParseStream<'_>, source: &Source) -> syn::Result<Vector> {
    if !input.peek(token::Paren) {
        return Err(input.error("expected `(`\n\nhelp: write three components: `(0, 0, 150.0)`"));
    }
    let (phrase, content) = source.parenthesized(input)?;
    let mut parts = Vec::new();
    while !content.is_empty() {
        parts.push(expression(&content, source)?);
        if !content.is_empty() {
            if !content.peek(Token![,]) {
                return Err(content.error("expected `,`\n\nhelp: separate the components with commas"));
            }
            content.parse::<Token![,]>()?;
        }
    }
    if parts.len() != 3 {
        let text = format!("a vector has three components, found {}\n\nhelp: write `(x, y, z)`", parts.len());
        return Err(syn::Error::new_spanned(phrase, text));
    }
    Ok(Vector { phrase, parts })
}

fn direction(input: ParseStream<'_>, source: &Source) -> syn::Result<Direction> {
    let mut rotations = Vec::new();
    let mut start: Option<Phrase> = None;
    loop {
        let mut negated = false;
        if input.peek(Token![-]) {
            let (phrase, _) = source.take(input)?;
            start.get_or_insert(phrase);
            negated = true;
        }
        if input.peek(token::Paren) {
            let base = vector(input, source)?;
            let phrase = start.map_or(base.phrase, |start| start.to(base.phrase));
            return Ok(Direction { phrase, rotations, negated, base: Base::Vector(base) });
        }
        let word = source.name(
            input,
            "a direction\n\nhelp: write a rotated coordinate axis such as `Rx(-45 deg) * Y`, or a vector `(0, 1, -0.5)`",
        )?;
        let start = *start.get_or_insert(word.phrase);
        if let Some(coordinate) = ["X", "Y", "Z"].iter().position(|name| word.name == *name) {
            return Ok(Direction {
                phrase: start.to(word.phrase),
                rotations,
                negated,
                base: Base::Coordinate(coordinate),
            });
        }
        let rotation = ["Rx", "Ry", "Rz"].iter().position(|name| word.name == *name);
        let (Some(rotation), false) = (rotation, negated) else {
            let text = format!(
                "`{}` is not a direction\n\nhelp: write X, Y, Z or a vector, with rotations Rx(...), Ry(...), Rz(...) before it: `Rx(-45 deg) * Y`",
                word.name
            );
            return Err(syn::Error::new_spanned(word.phrase, text));
        };
        if !input.peek(token::Paren) {
            return Err(input.error(format!("expected `(`\n\nhelp: write `{}(45 deg) * Y`", word.name)));
        }
        let (_, content) = source.parenthesized(input)?;
        rotations.push((rotation, expression(&content, source)?));
        if !content.is_empty() {
            return Err(content.error("expected `)`\n\nhelp: a rotation has one angle: `Rx(45 deg) * Y`"));
        }
        if !input.peek(Token![*]) {
            return Err(input.error(format!(
                "expected `*`\n\nhelp: write the direction that is rotated: `{}(...) * Y`",
                word.name
            )));
        }
        input.parse::<Token![*]>()?;
    }
}

fn limits(input: ParseStream<'_>, source: &Source) -> syn::Result<Limits> {
    let ahead = input.fork();
    if ahead.parse::<syn::Ident>().is_ok_and(|word| word == "free") {
        source.take(input)?;
        return Ok(Limits::Free);
    }
    let lower = expression(input, source)?;
    if !input.peek(Token![..]) {
        return Err(input.error("expected `..`\n\nhelp: write the travel as `-5..110`, or `free`"));
    }
    if input.peek(Token![..=]) || input.peek(Token![...]) {
        return Err(input.error("expected `..`\n\nhelp: both ends belong to the travel: write `-5..110`"));
    }
    input.parse::<Token![..]>()?;
    Ok(Limits::Range(Box::new((lower, expression(input, source)?))))
}

/// `"source" { equations }`. A statement that cannot be parsed is reported and left out; the others are kept.
fn verify(input: ParseStream<'_>, source: &Source, errors: &mut Errors) -> syn::Result<Verify> {
    const FORM: &str = "write `verify \"paper, eqs. (1)-(5)\" { i = sin(B) * cos(C); ... }`";
    if !input.peek(syn::LitStr) {
        return Err(input.error(format!("expected the source of the equations in quotes\n\nhelp: {FORM}")));
    }
    let name = input.parse::<syn::LitStr>()?.value();
    if !input.peek(token::Brace) {
        return Err(input.error(format!("expected `{{`\n\nhelp: {FORM}")));
    }
    let content;
    syn::braced!(content in input);
    let mut block = Verify { source: name, assumptions: Vec::new(), equations: Vec::new() };
    while !content.is_empty() {
        if let Err(error) = statement(&content, source, &mut block) {
            errors.push_syntax(source.next(), error);
            while !content.is_empty() && !content.peek(Token![;]) {
                content.parse::<TokenTree>()?;
            }
            content.parse::<Option<Token![;]>>()?;
        }
    }
    Ok(block)
}

fn statement(content: ParseStream<'_>, source: &Source, block: &mut Verify) -> syn::Result<()> {
    if content.peek(Token![where]) {
        content.parse::<Token![where]>()?;
        let key =
            source.name(content, "a name\n\nhelp: give the name a value, for example `where alpha = -45 deg;`")?;
        separator(content, '=', "give the name a value, for example `where alpha = -45 deg;`")?;
        block.assumptions.push(Assign { key, value: expression(content, source)? });
    } else {
        let left = expression(content, source)?;
        separator(content, '=', "an equation has two sides: `X = x * cos(C) + y * sin(C);`")?;
        let right = expression(content, source)?;
        block.equations.push(Equation { phrase: left.phrase.to(right.phrase), left, right });
    }
    if !content.peek(Token![;]) {
        return Err(
            content.error("expected `;`\n\nhelp: end every equation with a semicolon; products are written with `*`")
        );
    }
    content.parse::<Token![;]>()?;
    Ok(())
}

fn list_of(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
