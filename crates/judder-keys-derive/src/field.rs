//! A field of settings, or a variant of alternatives: its key, what is said of it, how it is read.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Attribute, Error, Expr, ExprLit, Ident, Lit, LitStr, Meta, Result, Type};

/// A key as its field declares it.
pub(crate) struct KeyField {
    pub(crate) field: Ident,
    /// The variable into which it is read, which no parameter is called.
    pub(crate) read: Ident,
    name: String,
    ty: Type,
    doc: String,
    symbol: String,
    rule: TokenStream,
    absent: Absent,
    /// What an optional key usually means where it is left out, which other keys decide.
    usual: Option<Expr>,
    example: Option<LitStr>,
    is_omitted: bool,
    is_unwritten: bool,
    /// Whether the keys of its table stand among those beside it.
    is_flat: bool,
}

/// What stands for a key that is left out.
enum Absent {
    /// What its type says.
    Type,
    Value(Expr),
    /// An empty table.
    Table,
    /// What the case fills in.
    Filled,
    /// Nothing: that is told when the case is known.
    Later,
}

impl KeyField {
    pub(crate) fn new(field: Ident, ty: &Type, attributes: &[Attribute]) -> Result<Self> {
        let mut key = Self {
            name: field.to_string(),
            read: format_ident!("read_{field}"),
            ty: ty.clone(),
            doc: doc(attributes),
            symbol: String::new(),
            rule: quote!(&()),
            absent: Absent::Type,
            usual: None,
            example: None,
            is_omitted: false,
            is_unwritten: false,
            is_flat: false,
            field,
        };
        for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("key")) {
            attribute.parse_nested_meta(|meta| {
                let has_value = meta.input.peek(syn::Token![=]);
                let name = meta.path.get_ident().map(Ident::to_string).unwrap_or_default();
                match name.as_str() {
                    "name" => key.name = meta.value()?.parse::<LitStr>()?.value(),
                    "rule" => {
                        let rule: Expr = meta.value()?.parse()?;
                        key.rule = quote!(&#rule);
                    }
                    "default" if has_value => key.absent = Absent::Value(meta.value()?.parse()?),
                    "default" => key.absent = Absent::Table,
                    "filled" => key.absent = Absent::Filled,
                    "later" => key.absent = Absent::Later,
                    "usual" => key.usual = Some(meta.value()?.parse()?),
                    "symbol" => key.symbol = meta.value()?.parse::<LitStr>()?.value(),
                    "example" => key.example = Some(meta.value()?.parse()?),
                    "omitted" => key.is_omitted = true,
                    "unwritten" => key.is_unwritten = true,
                    "flatten" => key.is_flat = true,
                    _ => {
                        return Err(meta.error(
                            "a key takes name, rule, default, filled, later, usual, symbol, example, omitted, unwritten, flatten",
                        ));
                    }
                }
                Ok(())
            })?;
        }
        if key.doc.is_empty() && !key.is_flat {
            return Err(Error::new(key.field.span(), "the doc comment of a key says what it is"));
        }
        Ok(key)
    }

    /// What a case file says of the key, or of those of its table.
    pub(crate) fn declarations(&self) -> TokenStream {
        let Self { name, ty, doc, symbol, rule, .. } = self;
        if self.is_flat {
            return quote!(<#ty as ::judder_keys::declared::Flat>::declarations(#rule));
        }
        let is_required = match self.absent {
            Absent::Type => quote!(!<#ty as ::judder_keys::declared::Setting>::IS_OPTIONAL),
            Absent::Later => quote!(true),
            Absent::Value(_) | Absent::Table | Absent::Filled => quote!(false),
        };
        let told = match (&self.absent, &self.usual) {
            (Absent::Value(value), _) => Some(quote!(#value)),
            (_, Some(value)) => Some(quote!(::std::option::Option::Some(#value))),
            _ => None,
        };
        let default = match told {
            Some(value) => quote!({
                let value: #ty = #value;
                ::std::option::Option::Some(::judder_keys::declared::Setting::write(&value, #rule))
            }),
            None => quote!(::std::option::Option::None),
        };
        quote!(::std::vec![::judder_keys::declared::Declaration {
            name: #name,
            doc: #doc,
            symbol: #symbol,
            default: #default,
            is_required: #is_required,
            alternative: ::std::option::Option::None,
            form: <#ty as ::judder_keys::declared::Setting>::form(#rule),
        }])
    }

    /// Reads the key into a variable of its name.
    fn reading(&self) -> TokenStream {
        let Self { read, name, ty, doc, rule, .. } = self;
        let value = if self.is_flat {
            quote!(<#ty as ::judder_keys::declared::Flat>::read(section, #rule))
        } else {
            let absent = match &self.absent {
                Absent::Type => quote!(<#ty as ::judder_keys::declared::Setting>::absent()),
                Absent::Value(value) => quote!(::std::option::Option::Some(#value)),
                Absent::Table => quote!(::judder_keys::declared::of_nothing()),
                Absent::Filled | Absent::Later => {
                    quote!(::std::option::Option::Some(::std::default::Default::default()))
                }
            };
            let example = option(self.example.as_ref());
            quote!(::judder_keys::declared::read_key(
                section,
                ::judder_keys::declared::Called { key: #name, doc: #doc, example: #example },
                #rule,
                || #absent,
            ))
        };
        quote!(let #read: ::std::result::Result<#ty, ::judder_keys::error::Fault> = #value;)
    }

    /// Puts the key into a canonical form.
    pub(crate) fn writing(&self, value: &TokenStream) -> TokenStream {
        let Self { ty, name, rule, is_omitted, .. } = self;
        match (self.is_unwritten, self.is_flat) {
            (true, _) => TokenStream::new(),
            (_, true) => quote!(<#ty as ::judder_keys::declared::Flat>::write(#value, json);),
            _ => quote!(::judder_keys::declared::write_key(
                json,
                #name,
                #is_omitted,
                <#ty as ::judder_keys::declared::Setting>::write(#value, #rule),
            );),
        }
    }
}

/// The names of keys that stand together, as a list.
pub(crate) fn names(keys: &[KeyField]) -> TokenStream {
    let lists = keys.iter().map(|KeyField { name, ty, rule, is_flat, .. }| match is_flat {
        true => quote!(<#ty as ::judder_keys::declared::Flat>::keys(#rule)),
        false => quote!(::std::vec![#name]),
    });
    quote!(::judder_keys::declared::joined(::std::vec![#(#lists),*]))
}

/// Reads keys that stand together, each into its variable.
pub(crate) fn reading(keys: &[KeyField]) -> TokenStream {
    let readings = keys.iter().map(KeyField::reading);
    let nothing = (quote!(::std::result::Result::Ok(())), quote!(()));
    let (all, pattern) = keys.iter().rev().fold(nothing, |(all, pattern), KeyField { read, .. }| {
        (quote!(::judder_keys::declared::both(#read, #all)), quote!((#read, #pattern)))
    });
    quote!(#(#readings)* let #pattern = #all?;)
}

/// A literal, or none, as tokens.
pub(crate) fn option(text: Option<&LitStr>) -> TokenStream {
    match text {
        Some(text) => quote!(::std::option::Option::Some(#text)),
        None => quote!(::std::option::Option::None),
    }
}

/// The first paragraph of a doc comment in one line.
pub(crate) fn doc(attributes: &[Attribute]) -> String {
    let line = |attribute: &Attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value().trim().to_owned()),
            _ => None,
        },
        _ => None,
    };
    let text =
        attributes.iter().filter_map(line).take_while(|line| !line.is_empty()).collect::<Vec<_>>().join(" ");
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
