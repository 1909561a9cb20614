//! Tokens with their locations in the source, and the mistakes found while they are read.

use std::cell::{Cell, RefCell, RefMut};
use std::fmt::Display;

use proc_macro2::{Delimiter, Span, TokenTree};
use syn::parse::{ParseBuffer, ParseStream};

use super::ast::{SpannedName, Unreadable};
use crate::report::{Errors, Phrase};

/// Numbers the phrases in the order of reading, and collects mistakes after which reading goes on.
#[derive(Debug, Default)]
pub(crate) struct Source {
    read: Cell<usize>,
    errors: RefCell<Errors>,
    unreadable: RefCell<Unreadable>,
}

impl Source {
    /// Number of the next phrase.
    pub(crate) fn next(&self) -> usize {
        self.read.set(self.read.get() + 1);
        self.read.get()
    }

    /// A phrase that comes after all phrases read before.
    pub(crate) fn phrase(&self, first: Span, last: Span) -> Phrase {
        Phrase::new(first, last, self.next())
    }

    /// The next token, whatever it is.
    pub(crate) fn take(&self, input: ParseStream<'_>) -> syn::Result<(Phrase, TokenTree)> {
        let token: TokenTree = input.parse()?;
        Ok((self.phrase(token.span(), token.span()), token))
    }

    /// Location and content of brackets of any kind, with the kind.
    pub(crate) fn group<'a>(&self, input: ParseStream<'a>) -> syn::Result<(Phrase, Delimiter, ParseBuffer<'a>)> {
        let content;
        let (kind, span) = if input.peek(syn::token::Paren) {
            (Delimiter::Parenthesis, syn::parenthesized!(content in input).span)
        } else if input.peek(syn::token::Bracket) {
            (Delimiter::Bracket, syn::bracketed!(content in input).span)
        } else {
            (Delimiter::Brace, syn::braced!(content in input).span)
        };
        Ok((self.phrase(span.open(), span.close()), kind, content))
    }

    /// The next name, a word of Rust included.
    pub(crate) fn name(&self, input: ParseStream<'_>, what: &str, help: impl Display) -> syn::Result<SpannedName> {
        match peeked(input) {
            Some(TokenTree::Ident(_)) => {
                let (phrase, token) = self.take(input)?;
                Ok(SpannedName { name: token.to_string(), phrase })
            }
            _ => Err(expected(input, what, help)),
        }
    }

    /// Reports a mistake after which reading goes on.
    pub(crate) fn report(&self, at: Phrase, text: impl Display, help: impl Display) {
        self.errors.borrow_mut().push(at, text, help);
    }

    /// Reports a mistake that ended the reading of a statement, an entry or a field.
    pub(crate) fn report_error(&self, error: syn::Error) {
        self.errors.borrow_mut().push_syntax(self.next(), error);
    }

    /// Number of mistakes so far.
    pub(crate) fn mistakes(&self) -> usize {
        self.errors.borrow().len()
    }

    /// Forgets all mistakes after the first `count`.
    pub(crate) fn forget_since(&self, count: usize) {
        self.errors.borrow_mut().truncate(count);
    }

    /// Fields and entries that could not be read.
    pub(crate) fn unreadable(&self) -> RefMut<'_, Unreadable> {
        self.unreadable.borrow_mut()
    }

    /// All mistakes, and what could not be read.
    pub(crate) fn finish(self) -> (Errors, Unreadable) {
        (self.errors.into_inner(), self.unreadable.into_inner())
    }
}

/// The next token, not taken.
pub(crate) fn peeked(input: ParseStream<'_>) -> Option<TokenTree> {
    input.fork().parse().ok()
}

/// The next token if it is a word, not taken.
pub(crate) fn peeked_word(input: ParseStream<'_>) -> Option<String> {
    match peeked(input) {
        Some(TokenTree::Ident(word)) => Some(word.to_string()),
        _ => None,
    }
}

/// True if the next token is this mark.
pub(crate) fn peek_mark(input: ParseStream<'_>, mark: char) -> bool {
    matches!(peeked(input), Some(TokenTree::Punct(punct)) if punct.as_char() == mark)
}

/// An error at the next token, or at the closing bracket.
pub(crate) fn expected(input: ParseStream<'_>, what: &str, help: impl Display) -> syn::Error {
    syn::Error::new(input.span(), format!("expected {what}\n\nhelp: {help}"))
}

/// An error at a phrase.
pub(crate) fn refused(at: Phrase, text: impl Display, help: impl Display) -> syn::Error {
    syn::Error::new_spanned(at, format!("{text}\n\nhelp: {help}"))
}

/// The last token between two positions of the same tokens, with its closing bracket as its text.
pub(crate) fn last_token(source: &Source, from: ParseStream<'_>, to: ParseStream<'_>) -> Option<SpannedName> {
    let from = from.fork();
    let mut last = None;
    while from.cursor() != to.cursor() && !from.is_empty() {
        last = from.parse::<TokenTree>().ok();
    }
    let (span, text) = match last? {
        TokenTree::Group(group) => {
            let text = match group.delimiter() {
                Delimiter::Parenthesis => ")",
                Delimiter::Brace => "}",
                Delimiter::Bracket => "]",
                Delimiter::None => "",
            };
            (group.span_close(), text.to_string())
        }
        token => (token.span(), token.to_string()),
    };
    Some(SpannedName { name: text, phrase: source.phrase(span, span) })
}
