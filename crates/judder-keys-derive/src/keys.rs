//! An enum of the numbers of a case that its analyses vary.

use crate::choice::word;
use crate::field::{doc, option};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{Data, DeriveInput, Error, Expr, Fields, Ident, LitStr, Result, Variant};

pub(crate) fn derive(input: &DeriveInput) -> Result<TokenStream> {
    let Data::Enum(data) = &input.data else {
        return Err(Error::new(input.ident.span(), "keys are an enum"));
    };
    let name = &input.ident;
    let entries = data.variants.iter().map(entry).collect::<Result<Vec<_>>>()?;
    Ok(quote! {
        impl ::judder_keys::keys::Keys for #name {
            const ALL: &'static [::judder_keys::keys::Key<Self>] = &[#(#entries),*];

            fn entry(self) -> &'static ::judder_keys::keys::Key<Self> {
                &Self::ALL[self as usize]
            }
        }

        impl ::std::fmt::Display for #name {
            /// The dotted path.
            fn fmt(&self, formatter: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                formatter.write_str(::judder_keys::keys::Keys::entry(*self).path)
            }
        }
    })
}

/// What is said of one key.
fn entry(variant: &Variant) -> Result<TokenStream> {
    let name = &variant.ident;
    if !matches!(variant.fields, Fields::Unit) {
        return Err(Error::new(name.span(), "a key has no fields"));
    }
    let (mut section, mut symbol, mut rule, mut typical) = (None, None, None, None);
    let (mut default, mut label, mut scaled) = (None, None, None);
    for attribute in variant.attrs.iter().filter(|attribute| attribute.path().is_ident("key")) {
        attribute.parse_nested_meta(|meta| {
            let text = || meta.value()?.parse::<LitStr>().map(Some);
            match meta.path.get_ident().map(Ident::to_string).as_deref() {
                Some("section") => section = text()?,
                Some("symbol") => symbol = text()?,
                Some("default") => default = text()?,
                Some("label") => label = text()?,
                Some("scaled") => scaled = text()?,
                Some("rule") => rule = Some(meta.value()?.parse::<Expr>()?),
                Some("typical") => typical = Some(meta.value()?.parse::<Expr>()?),
                _ => {
                    return Err(
                        meta.error("a key takes section, symbol, rule, default, typical, label, scaled")
                    );
                }
            }
            Ok(())
        })?;
    }
    let (Some(section), Some(symbol), Some(rule), about) = (section, symbol, rule, doc(&variant.attrs))
    else {
        return Err(Error::new(name.span(), "a key says its section, symbol and rule"));
    };
    if about.is_empty() {
        return Err(Error::new(name.span(), "the doc comment of a key says what it is"));
    }
    let path = format!("{}.{}", section.value(), word(name, '_'));
    let label = label.map_or_else(|| label_of(name), |label| label.value());
    let (default, scaled) = (option(default.as_ref()), option(scaled.as_ref()));
    let typical = match typical {
        Some(typical) => quote!(::std::option::Option::Some(#typical)),
        None => quote!(::std::option::Option::None),
    };
    Ok(quote!(::judder_keys::keys::Key {
        key: Self::#name,
        path: #path,
        symbol: #symbol,
        rule: #rule,
        default: #default,
        typical: #typical,
        doc: #about,
        label: #label,
        scaled: #scaled,
    }))
}

/// `PoissonRatio` as `Poisson ratio`.
fn label_of(name: &Ident) -> String {
    let words = word(name, ' ');
    let first = words.chars().next().map(|letter| letter.to_uppercase().to_string()).unwrap_or_default();
    first + words.get(1..).unwrap_or_default()
}
