//! Tokens with their locations in the source.

use std::cell::Cell;

use proc_macro2::{Span, TokenTree};
use syn::parse::{ParseBuffer, ParseStream};

use super::ast::SpannedName;
use crate::report::Phrase;

/// Numbers the phrases in the order of reading.
#[derive(Debug, Default)]
pub(crate) struct Source {
    read: Cell<usize>,
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

    /// Location and content of parentheses.
    pub(crate) fn parenthesized<'a>(&self, input: ParseStream<'a>) -> syn::Result<(Phrase, ParseBuffer<'a>)> {
        let content;
        let paren = syn::parenthesized!(content in input);
        Ok((self.phrase(paren.span.open(), paren.span.close()), content))
    }

    /// The next name.
    pub(crate) fn name(&self, input: ParseStream<'_>, what: &str) -> syn::Result<SpannedName> {
        match input.fork().parse::<TokenTree>() {
            Ok(TokenTree::Ident(_)) => {
                let (phrase, token) = self.take(input)?;
                Ok(SpannedName { name: token.to_string(), phrase })
            }
            _ => Err(input.error(format!("expected {what}"))),
        }
    }
}
