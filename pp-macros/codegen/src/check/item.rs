//! The struct as it is declared, for generated code.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use crate::syntax::Declaration;

/// What generated code takes over from the declaration as it is written, with its source positions.
#[derive(Debug, Clone)]
pub struct Item {
    /// Attributes and doc comments of the struct.
    pub(crate) attributes: Vec<TokenStream>,
    /// The `#[cfg(...)]` attributes among them: everything that is generated with the struct has them too.
    pub(crate) configured: Vec<TokenStream>,
    /// Its visibility.
    pub(crate) visibility: TokenStream,
    /// Its name.
    pub(crate) name: Ident,
    /// Path of the runtime: `::pp_runtime`, or what the field `crate` gives.
    pub(crate) runtime: TokenStream,
}

impl Item {
    /// The struct of a declaration.
    pub(crate) fn of(declaration: &Declaration) -> Self {
        let Declaration { attributes, visibility, name, runtime, .. } = declaration;
        let is_condition = |attribute: &&syn::Attribute| attribute.path().is_ident("cfg");
        Self {
            attributes: attributes.iter().map(ToTokens::to_token_stream).collect(),
            configured: attributes.iter().filter(is_condition).map(ToTokens::to_token_stream).collect(),
            visibility: visibility.to_token_stream(),
            name: name.clone(),
            runtime: runtime.as_ref().map_or_else(|| quote!(::pp_runtime), ToTokens::to_token_stream),
        }
    }
}
