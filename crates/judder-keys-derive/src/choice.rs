//! An enum of words.

use crate::field::doc;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Data, DeriveInput, Error, Fields, Ident, LitStr, Result};

pub(crate) fn derive(input: &DeriveInput) -> Result<TokenStream> {
    let Data::Enum(data) = &input.data else {
        return Err(Error::new(input.ident.span(), "a choice is an enum"));
    };
    let (mut what, mut list): (Option<LitStr>, Ident) = (None, format_ident!("ALL"));
    for attribute in input.attrs.iter().filter(|attribute| attribute.path().is_ident("choice")) {
        attribute.parse_nested_meta(|meta| {
            if meta.path.is_ident("what") {
                what = Some(meta.value()?.parse()?);
                return Ok(());
            }
            if meta.path.is_ident("list") {
                list = meta.value()?.parse()?;
                return Ok(());
            }
            Err(meta.error("a choice takes what, list"))
        })?;
    }
    let Some(what) = what else {
        return Err(Error::new(
            input.ident.span(),
            "a choice says what its words are: #[choice(what = \"…\")]",
        ));
    };
    if let Some(variant) = data.variants.iter().find(|variant| !matches!(variant.fields, Fields::Unit)) {
        return Err(Error::new(variant.ident.span(), "a word of a choice has no fields"));
    }
    let (name, count) = (&input.ident, data.variants.len());
    let variants: Vec<_> = data.variants.iter().map(|variant| &variant.ident).collect();
    let words: Vec<_> = data.variants.iter().map(|variant| word(&variant.ident, '-')).collect();
    let docs = data.variants.iter().map(|variant| doc(&variant.attrs));
    Ok(quote! {
        impl #name {
            /// Every word in the order of the declaration, with what it means.
            pub const #list: [(&'static str, Self); #count] = [#((#words, Self::#variants)),*];

            /// The word in a case file.
            pub fn name(self) -> &'static str {
                match self {
                    #(Self::#variants => #words),*
                }
            }
        }

        impl ::judder_keys::declared::Setting for #name {
            type Rule = ();

            fn form((): &()) -> ::judder_keys::declared::Allowed {
                ::judder_keys::declared::Allowed::Choice { words: &[#((#words, #docs)),*] }
            }

            fn read(
                section: &::judder_keys::section::Section<'_>,
                key: &str,
                node: &::judder_keys::document::Node,
                (): &(),
            ) -> ::std::result::Result<Self, ::judder_keys::error::Fault> {
                ::judder_keys::section::word(&section.path(key), #what, node, &Self::#list)
            }

            fn write(&self, (): &()) -> ::judder_keys::serde_json::Value {
                ::judder_keys::serde_json::Value::from(self.name())
            }
        }
    })
}

/// `ResidualFlexibility` as `residual-flexibility`.
pub(crate) fn word(name: &Ident, joint: char) -> String {
    let mut word = String::new();
    for letter in name.to_string().chars() {
        if letter.is_uppercase() && !word.is_empty() {
            word.push(joint);
        }
        word.extend(letter.to_lowercase());
    }
    word
}
