//! `verify "source" { equations }`.

use proc_macro2::{Delimiter, TokenTree};
use syn::Token;
use syn::parse::ParseStream;

use super::arithmetic::side;
use super::ast::{Assign, Equation, Verify};
use super::source::{Source, expected, last_token, peeked, peeked_word, refused};

const FORM: &str = "write `verify \"paper, eqs. (1)-(5)\" { i = sin(B) * cos(C); ... }`";

/// Reads a block. A statement that cannot be read is reported and left out; the others are kept.
pub(crate) fn verify(input: ParseStream<'_>, source: &Source) -> syn::Result<Verify> {
    let (name, mut phrase) = publication(input, source)?;
    if !matches!(peeked(input), Some(TokenTree::Group(_))) {
        return Err(expected(input, "`{`", FORM));
    }
    let (braces, kind, content) = source.group(input)?;
    if kind != Delimiter::Brace {
        source.report(braces, "the equations of `verify` are in braces", FORM);
    }
    let missing = name.is_none();
    if missing {
        phrase = braces;
    }
    let mut block = Verify {
        source: name.unwrap_or_default(),
        phrase,
        assumptions: Vec::new(),
        equations: Vec::new(),
        complete: true,
    };
    while !content.is_empty() {
        if let Err(error) = statement(&content, source, &mut block) {
            block.complete = false;
            source.report_error(error);
            while !content.is_empty() && content.parse::<Option<Token![;]>>()?.is_none() {
                content.parse::<TokenTree>()?;
            }
        }
    }
    if block.equations.is_empty() && block.complete {
        source.report(
            phrase,
            "this block proves nothing: it has no equations",
            "write the equations of the source, or remove the block",
        );
    }
    Ok(block)
}

/// The source of the equations, in quotes, and its place; none is reported.
fn publication(input: ParseStream<'_>, source: &Source) -> syn::Result<(Option<String>, crate::report::Phrase)> {
    let ahead = input.fork();
    // `verify("source") { ... }`
    let enclosed = input.peek(syn::token::Paren) && ahead.parse::<TokenTree>().is_ok() && ahead.peek(syn::token::Brace);
    if enclosed {
        let (phrase, _, content) = source.group(input)?;
        source.report(phrase, "the source of the equations has no parentheses", FORM);
        return match content.parse::<syn::LitStr>() {
            Ok(name) => Ok((Some(name.value()), phrase)),
            Err(_) => Ok((None, phrase)),
        };
    }
    let at = source.phrase(input.span(), input.span());
    let Ok(name) = input.parse::<syn::LitStr>() else {
        source.report(at, "expected the source of the equations in quotes", FORM);
        return Ok((None, at));
    };
    if name.value().trim().is_empty() {
        source.report(
            at,
            "the source of the equations has no name",
            "name the publication, the manual or the notes that have these equations, with their numbers",
        );
    }
    Ok((Some(name.value()), at))
}

/// An equation or an assumption, with its semicolon.
fn statement(content: ParseStream<'_>, source: &Source, block: &mut Verify) -> syn::Result<()> {
    let start = content.fork();
    if content.peek(Token![where]) {
        content.parse::<Token![where]>()?;
        let help = "give the name a value, for example `where alpha = -45 deg;`";
        let key = source.name(content, "a name", help)?;
        equals(content, source, "where alpha = -45 deg;")?;
        block.assumptions.push(Assign { key, value: side(content, source)? });
    } else {
        let known = source.mistakes();
        let left = side(content, source)?;
        if let Err(error) = equals(content, source, "X = x * cos(C) + y * sin(C);") {
            // Two words without a mark between them may be two sides.
            source.forget_since(known);
            return Err(error);
        }
        let right = side(content, source)?;
        if content.peek(Token![=]) {
            let (phrase, _) = source.take(content)?;
            let help = format!("write an equation for each: `{left} = {right};`");
            return Err(refused(phrase, "an equation has one `=`", help));
        }
        block.equations.push(Equation { phrase: left.phrase.to(right.phrase), left, right });
    }
    if content.parse::<Option<Token![;]>>()?.is_some() {
        return Ok(());
    }
    let help = "end every equation with a semicolon";
    let next = content.is_empty() || peeked_word(content).is_some();
    match last_token(source, &start, content) {
        Some(last) if next => source.report(last.phrase, format!("missing `;` after `{}`", last.name), help),
        _ => {
            if !content.peek(Token![,]) {
                return Err(expected(content, "`;`", help));
            }
            source.report(source.take(content)?.0, "expected `;`, found `,`", help);
        }
    }
    Ok(())
}

/// The one `=` between two sides.
fn equals(content: ParseStream<'_>, source: &Source, example: &str) -> syn::Result<()> {
    let mut marks = String::new();
    let mut phrase = source.phrase(content.span(), content.span());
    while let Some(TokenTree::Punct(punct)) = peeked(content)
        && matches!(punct.as_char(), '=' | ':' | '<' | '>')
    {
        phrase = phrase.to(source.take(content)?.0);
        marks.push(punct.as_char());
    }
    match marks.as_str() {
        "=" => Ok(()),
        "" => Err(expected(content, "`=`", format!("both sides are joined by one `=`: `{example}`"))),
        _ => {
            source.report(
                phrase,
                format!("expected `=`, found `{marks}`"),
                format!("both sides are joined by one `=`: `{example}`"),
            );
            Ok(())
        }
    }
}
