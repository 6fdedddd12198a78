//! A struct of settings.

use crate::field::{Key, doc, option};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{Data, DeriveInput, Error, Fields, LitStr, Path, Result};

pub(crate) fn derive(input: &DeriveInput) -> Result<TokenStream> {
    let Data::Struct(data) = &input.data else {
        return Err(Error::new(input.ident.span(), "settings are a struct"));
    };
    let Fields::Named(fields) = &data.fields else {
        return Err(Error::new(input.ident.span(), "settings are structs with named fields"));
    };
    let (mut check, mut title): (Option<Path>, Option<LitStr>) = (None, None);
    for attribute in input.attrs.iter().filter(|attribute| attribute.path().is_ident("settings")) {
        attribute.parse_nested_meta(|meta| {
            if meta.path.is_ident("check") {
                check = Some(meta.value()?.parse()?);
                return Ok(());
            }
            if meta.path.is_ident("title") {
                title = Some(meta.value()?.parse()?);
                return Ok(());
            }
            Err(meta.error("settings take check, title"))
        })?;
    }
    let keys = fields.named.iter().map(Key::new).collect::<Result<Vec<Key>>>()?;
    let name = &input.ident;
    let (title, about) = (option(title.as_ref()), doc(&input.attrs));
    let names = keys.iter().map(|key| &key.name);
    let declarations = keys.iter().map(Key::declaration);
    let reads = keys.iter().map(Key::read);
    let writes = keys.iter().map(Key::write);
    let fields = keys.iter().map(|key| &key.field);
    let own: Vec<_> = keys.iter().map(|key| &key.read).collect();
    let nothing = (quote!(::std::result::Result::Ok(())), quote!(()));
    let (all, pattern) = own.iter().rev().fold(nothing, |(all, pattern), read| {
        (quote!(crate::declared::both(#read, #all)), quote!((#read, #pattern)))
    });
    let check = check.map(|check| quote!(#check(&mut settings, section)?;));
    Ok(quote! {
        impl crate::declared::Settings for #name {
            const TITLE: ::std::option::Option<&'static str> = #title;
            const DOC: &'static str = #about;
            const KEYS: &'static [&'static str] = &[#(#names),*];

            fn declarations() -> ::std::vec::Vec<crate::declared::Declaration> {
                ::std::vec![#(#declarations),*]
            }

            fn read_table(
                section: &crate::section::Section<'_>,
            ) -> ::std::result::Result<Self, crate::error::Fault> {
                #(#reads)*
                let #pattern = #all?;
                #[allow(unused_mut, reason = "a check may fill in what depends on other keys")]
                let mut settings = Self { #(#fields: #own),* };
                #check
                ::std::result::Result::Ok(settings)
            }

            fn write_table(&self, json: &mut ::serde_json::Map<::std::string::String, ::serde_json::Value>) {
                #(#writes)*
            }
        }
    })
}
