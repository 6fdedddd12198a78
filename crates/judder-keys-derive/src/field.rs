//! A field of settings: its key, what is said of it, how it is read.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::spanned::Spanned;
use syn::{Attribute, Error, Expr, ExprLit, Field, Ident, Lit, LitStr, Meta, Result, Type};

/// A key as its field declares it.
pub(crate) struct Key {
    pub(crate) field: Ident,
    /// The variable into which it is read, which no parameter is called.
    pub(crate) read: Ident,
    pub(crate) name: String,
    pub(crate) ty: Type,
    pub(crate) doc: String,
    symbol: String,
    rule: TokenStream,
    default: Option<Expr>,
    /// What an optional key usually means where it is left out, which other keys decide.
    usual: Option<Expr>,
    example: Option<LitStr>,
    is_omitted: bool,
    is_unwritten: bool,
}

impl Key {
    pub(crate) fn new(field: &Field) -> Result<Self> {
        let Some(name) = field.ident.clone() else {
            return Err(Error::new(field.span(), "settings are structs with named fields"));
        };
        let mut key = Self {
            name: name.to_string(),
            read: format_ident!("read_{name}"),
            field: name,
            ty: field.ty.clone(),
            doc: doc(&field.attrs),
            symbol: String::new(),
            rule: quote!(&()),
            default: None,
            usual: None,
            example: None,
            is_omitted: false,
            is_unwritten: false,
        };
        for attribute in field.attrs.iter().filter(|attribute| attribute.path().is_ident("key")) {
            attribute.parse_nested_meta(|meta| {
                if meta.path.is_ident("name") {
                    key.name = meta.value()?.parse::<LitStr>()?.value();
                } else if meta.path.is_ident("rule") {
                    let rule: Expr = meta.value()?.parse()?;
                    key.rule = quote!(&#rule);
                } else if meta.path.is_ident("default") {
                    key.default = Some(meta.value()?.parse()?);
                } else if meta.path.is_ident("usual") {
                    key.usual = Some(meta.value()?.parse()?);
                } else if meta.path.is_ident("symbol") {
                    key.symbol = meta.value()?.parse::<LitStr>()?.value();
                } else if meta.path.is_ident("example") {
                    key.example = Some(meta.value()?.parse()?);
                } else if meta.path.is_ident("omitted") {
                    key.is_omitted = true;
                } else if meta.path.is_ident("unwritten") {
                    key.is_unwritten = true;
                } else {
                    return Err(meta.error(
                        "a key takes name, rule, default, usual, symbol, example, omitted, unwritten",
                    ));
                }
                Ok(())
            })?;
        }
        if key.doc.is_empty() {
            return Err(Error::new(field.span(), "the doc comment of a key says what it is"));
        }
        Ok(key)
    }

    /// What a case file says of the key.
    pub(crate) fn declaration(&self) -> TokenStream {
        let Self { name, ty, doc, symbol, rule, default, .. } = self;
        let is_required = default.is_none();
        let told = match (default, &self.usual) {
            (Some(value), _) => Some(quote!(#value)),
            (None, Some(value)) => Some(quote!(::std::option::Option::Some(#value))),
            (None, None) => None,
        };
        let default = match told {
            Some(value) => quote!({
                let value: #ty = #value;
                ::std::option::Option::Some(crate::declared::Setting::write(&value, #rule))
            }),
            None => quote!(::std::option::Option::None),
        };
        quote!(crate::declared::Declaration {
            name: #name,
            doc: #doc,
            symbol: #symbol,
            default: #default,
            is_required: #is_required && !<#ty as crate::declared::Setting>::IS_OPTIONAL,
            form: <#ty as crate::declared::Setting>::form(#rule),
        })
    }

    /// Reads the key into a variable of its name.
    pub(crate) fn read(&self) -> TokenStream {
        let Self { read, name, ty, doc, rule, default, .. } = self;
        let absent = match default {
            Some(value) => quote!(::std::option::Option::Some(#value)),
            None => quote!(<#ty as crate::declared::Setting>::absent()),
        };
        let example = option(self.example.as_ref());
        quote!(let #read: ::std::result::Result<#ty, crate::error::Fault> =
            crate::declared::read_key(
                section,
                crate::declared::Called { key: #name, doc: #doc, example: #example },
                #rule,
                || #absent,
            );)
    }

    /// Puts the key into a canonical form.
    pub(crate) fn write(&self) -> TokenStream {
        let Self { field, name, rule, is_omitted, is_unwritten, .. } = self;
        if *is_unwritten {
            return TokenStream::new();
        }
        quote!(crate::declared::write_key(json, (#name, #is_omitted), crate::declared::Setting::write(&self.#field, #rule));)
    }
}

/// A literal, or none, as tokens.
pub(crate) fn option(text: Option<&LitStr>) -> TokenStream {
    match text {
        Some(text) => quote!(::std::option::Option::Some(#text)),
        None => quote!(::std::option::Option::None),
    }
}

/// The doc comment of a field or a variant in one line.
pub(crate) fn doc(attributes: &[Attribute]) -> String {
    let line = |attribute: &Attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value().trim().to_owned()),
            _ => None,
        },
        _ => None,
    };
    let text = attributes.iter().filter_map(line).collect::<Vec<_>>().join(" ");
    let text = text.strip_suffix('.').unwrap_or(&text);
    let first: String = text.chars().take_while(|letter| letter.is_alphabetic()).collect();
    let rest = &text[first.len()..];
    let is_lower = first.chars().skip(1).all(char::is_lowercase);
    // a sentence becomes a part of one; symbols and names stay as they are
    match is_lower && (first == "A" || first.chars().count() > 1) && !rest.starts_with('\'') {
        true => first.to_lowercase() + rest,
        false => text.to_owned(),
    }
}
