//! Error messages: the broken rule, the words that break it underlined, one line of help.

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

/// Location of words of the declaration, from the first token to the last.
#[derive(Debug, Clone, Copy)]
pub struct Phrase {
    first: Span,
    last: Span,
    /// Position in the source; messages are sorted by it.
    order: usize,
}

impl Phrase {
    /// From the first token to the last; `order` increases with the position in the source.
    #[must_use]
    pub fn new(first: Span, last: Span, order: usize) -> Self {
        Self { first, last, order }
    }

    /// From here to the end of another phrase.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self { last: other.last, ..self }
    }
}

impl ToTokens for Phrase {
    /// Two tokens: `compile_error!` underlines from the first to the last.
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.extend(quote_spanned!(self.first=> x));
        tokens.extend(quote_spanned!(self.last=> x));
    }
}

/// Collects all mistakes before compilation stops.
#[derive(Debug, Default)]
pub struct Errors {
    list: Vec<(usize, syn::Error)>,
}

impl Errors {
    /// Adds a mistake with its remedy.
    ///
    /// The same mistake at the same place is reported once, however many axes share it.
    pub fn push(&mut self, at: Phrase, text: impl std::fmt::Display, help: impl std::fmt::Display) {
        let message = format!("{text}\n\nhelp: {help}");
        if !self.list.iter().any(|(order, known)| *order == at.order && known.to_string() == message) {
            self.list.push((at.order, syn::Error::new_spanned(at, message)));
        }
    }

    /// Number of mistakes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Keeps the first `count` mistakes in the order in which they were found.
    pub fn truncate(&mut self, count: usize) {
        self.list.truncate(count);
    }

    /// Adds the mistakes of another collection.
    pub fn append(&mut self, mut others: Self) {
        self.list.append(&mut others.list);
    }

    /// True if no mistake has been found.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Adds a mistake that the token parser found.
    pub fn push_syntax(&mut self, order: usize, error: syn::Error) {
        self.list.push((order, error));
    }

    /// Fails if any mistake has been found.
    ///
    /// # Errors
    /// All mistakes so far, in source order.
    pub fn propagate(&mut self) -> Result<(), Refused> {
        if self.list.is_empty() { Ok(()) } else { Err(self.refused()) }
    }

    /// Takes all mistakes so far, in source order.
    pub fn refused(&mut self) -> Refused {
        let mut list = std::mem::take(&mut self.list);
        list.sort_by_key(|(order, _)| *order);
        Refused(list.into_iter().map(|(_, error)| error).collect())
    }
}

/// A declaration that does not compile, with all its mistakes.
#[derive(Debug)]
pub struct Refused(pub Vec<syn::Error>);

impl Refused {
    /// One `compile_error!` for each mistake.
    #[must_use]
    pub fn to_compile_error(&self) -> TokenStream {
        let errors = self.0.iter().map(syn::Error::to_compile_error);
        quote!(#(#errors)*)
    }
}
