//! A struct of settings, an enum of alternatives.

use crate::field::{KeyField, doc, names, option, reading};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Data, DeriveInput, Error, Field, Fields, LitStr, Path, Result, Variant};

pub(crate) fn derive(input: &DeriveInput) -> Result<TokenStream> {
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
    let Parts { keys, declarations, read, write } = match &input.data {
        Data::Struct(data) => of_struct(&fields(&data.fields)?, check.as_ref()),
        Data::Enum(data) => {
            let variants = data.variants.iter().map(Alternative::new).collect::<Result<Vec<_>>>()?;
            of_alternatives(&variants, check.as_ref())
        }
        Data::Union(_) => return Err(Error::new(input.ident.span(), "settings are a struct or an enum")),
    };
    let (name, title, about) = (&input.ident, option(title.as_ref()), doc(&input.attrs));
    let (generics, parameters, conditions) = input.generics.split_for_impl();
    Ok(quote! {
        impl #generics ::judder_keys::declared::Settings for #name #parameters #conditions {
            const TITLE: ::std::option::Option<&'static str> = #title;
            const DOC: &'static str = #about;

            fn keys() -> ::std::vec::Vec<&'static str> {
                #keys
            }

            fn declarations() -> ::std::vec::Vec<::judder_keys::declared::Declaration> {
                #declarations
            }

            fn read_table(
                section: &::judder_keys::section::Section<'_>,
            ) -> ::std::result::Result<Self, ::judder_keys::error::Fault> {
                #read
            }

            fn write_table(&self, json: &mut ::judder_keys::serde_json::Map<::std::string::String, ::judder_keys::serde_json::Value>) {
                #write
            }
        }
    })
}

/// What differs between a struct and alternatives.
struct Parts {
    keys: TokenStream,
    declarations: TokenStream,
    read: TokenStream,
    write: TokenStream,
}

fn fields(fields: &Fields) -> Result<Vec<KeyField>> {
    let key = |field: &Field| match &field.ident {
        Some(name) => KeyField::new(name.clone(), &field.ty, &field.attrs),
        None => Err(Error::new_spanned(field, "settings have named fields")),
    };
    fields.iter().map(key).collect()
}

fn of_struct(keys: &[KeyField], check: Option<&Path>) -> Parts {
    let declarations = keys.iter().map(KeyField::declarations);
    let writes = keys.iter().map(|key| {
        let field = &key.field;
        key.writing(&quote!(&self.#field))
    });
    let (fields, own) = (keys.iter().map(|key| &key.field), keys.iter().map(|key| &key.read));
    let check = check.map(|check| quote!(#check(&mut settings, section)?;));
    let reading = reading(keys);
    Parts {
        keys: names(keys),
        declarations: quote!(::judder_keys::declared::beside(::std::vec![#(#declarations),*])),
        read: quote! {
            #reading
            #[allow(unused_mut, reason = "a check may fill in what depends on other keys")]
            let mut settings = Self { #(#fields: #own),* };
            #check
            ::std::result::Result::Ok(settings)
        },
        write: quote!(#(#writes)*),
    }
}

/// A variant: one key, some keys, or none.
struct Alternative {
    keys: Vec<KeyField>,
    /// The variant with its fields in the variables of the same names: as a pattern, and of what was read.
    pattern: TokenStream,
    read: TokenStream,
}

impl Alternative {
    fn new(variant: &Variant) -> Result<Self> {
        let name = &variant.ident;
        let keys = match &variant.fields {
            Fields::Unnamed(own) if own.unnamed.len() == 1 => {
                let key = format_ident!("{}", crate::choice::word(name, '_'));
                vec![KeyField::new(key, &own.unnamed[0].ty, &variant.attrs)?]
            }
            own => fields(own)?,
        };
        let fields: Vec<_> = keys.iter().map(|key| &key.field).collect();
        let own: Vec<_> = keys.iter().map(|key| &key.read).collect();
        let (pattern, read) = match &variant.fields {
            Fields::Unnamed(_) => (quote!(Self::#name(#(#fields),*)), quote!(Self::#name(#(#own),*))),
            Fields::Named(_) => {
                (quote!(Self::#name { #(#fields),* }), quote!(Self::#name { #(#fields: #own),* }))
            }
            Fields::Unit => (quote!(Self::#name), quote!(Self::#name)),
        };
        Ok(Self { keys, pattern, read })
    }
}

/// The first is meant where a section has no key of any.
fn of_alternatives(alternatives: &[Alternative], check: Option<&Path>) -> Parts {
    let (mut lists, mut declared, mut reads, mut writes) = (vec![], vec![], vec![], vec![]);
    for (index, Alternative { keys, pattern, read }) in alternatives.iter().enumerate() {
        lists.push(names(keys));
        let declarations = keys.iter().map(KeyField::declarations);
        declared.push(quote!(::judder_keys::declared::beside(::std::vec![#(#declarations),*])));
        let which = if index + 1 < alternatives.len() { quote!(#index) } else { quote!(_) };
        let reading = reading(keys);
        reads.push(quote!(#which => { #reading ::std::result::Result::Ok(#read) }));
        let writing = keys.iter().map(|key| {
            let field = &key.field;
            key.writing(&quote!(#field))
        });
        writes.push(quote!(#pattern => { #(#writing)* }));
    }
    let check = check.map(|check| quote!(#check(section)?;));
    Parts {
        keys: quote!(::judder_keys::declared::joined(::std::vec![#(#lists),*])),
        declarations: quote!(::judder_keys::declared::alternatives(::std::vec![#(#declared),*])),
        read: quote! {
            #check
            match ::judder_keys::declared::alternative(section, &[#(#lists),*])? { #(#reads),* }
        },
        write: quote!(match self { #(#writes),* }),
    }
}
