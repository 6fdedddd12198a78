//! A struct of results.

use crate::field::ResultField;
use proc_macro2::TokenStream;
use quote::quote;
use syn::meta::ParseNestedMeta;
use syn::{Data, DeriveInput, Error, Ident, LitStr, Result, Token, parenthesized, punctuated::Punctuated};

/// What the attribute of the struct says.
#[derive(Default)]
struct Said {
    arrays: Vec<Ident>,
    columns: Vec<Ident>,
    along: Option<LitStr>,
    rows: Option<LitStr>,
    prefix: String,
}

impl Said {
    fn new(input: &DeriveInput) -> Result<Self> {
        let mut said = Self::default();
        for attribute in input.attrs.iter().filter(|attribute| attribute.path().is_ident("results")) {
            attribute.parse_nested_meta(|meta| {
                let name = meta.path.get_ident().map(Ident::to_string).unwrap_or_default();
                match name.as_str() {
                    "arrays" => said.arrays = names(&meta)?,
                    "columns" => said.columns = names(&meta)?,
                    "along" => said.along = Some(meta.value()?.parse()?),
                    "rows" => said.rows = Some(meta.value()?.parse()?),
                    "prefix" => said.prefix = meta.value()?.parse::<LitStr>()?.value(),
                    _ => return Err(meta.error("results take arrays, columns, along, rows, prefix")),
                }
                Ok(())
            })?;
        }
        Ok(said)
    }
}

/// The names in parentheses.
fn names(meta: &ParseNestedMeta<'_>) -> Result<Vec<Ident>> {
    let list;
    parenthesized!(list in meta.input);
    Ok(Punctuated::<Ident, Token![,]>::parse_terminated(&list)?.into_iter().collect())
}

pub(crate) fn derive(input: &DeriveInput) -> Result<TokenStream> {
    let Data::Struct(data) = &input.data else {
        return Err(Error::new(input.ident.span(), "results are a struct"));
    };
    let said = Said::new(input)?;
    let entries = data.fields.iter().map(ResultField::new).collect::<Result<Vec<_>>>()?;
    let find = |name: &Ident| {
        let found = entries.iter().find(|entry| entry.field == *name);
        found.ok_or_else(|| Error::new(name.span(), "no field of this name"))
    };
    let along = said.rows.as_ref().or(said.along.as_ref());
    let own = |entry: &ResultField| {
        let field = &entry.field;
        match said.rows {
            Some(_) => quote!(rows.iter().map(|row| row.#field.clone()).collect::<::std::vec::Vec<_>>()),
            None => quote!(self.#field),
        }
    };
    let arrays = said.arrays.iter().map(|name| {
        let entry = find(name)?;
        entry.array(&own(entry), along, &said.prefix)
    });
    let arrays = arrays.collect::<Result<Vec<_>>>()?;
    let columns = said.columns.iter().map(|name| find(name).map(|entry| entry.column(&own(entry))));
    let columns = columns.collect::<Result<Vec<_>>>()?;
    let declared = entries.iter().filter_map(ResultField::declared);
    let scalars = entries.iter().filter_map(ResultField::scalar);
    let attributes: Vec<_> = entries.iter().filter_map(ResultField::attribute).collect();
    let name = &input.ident;
    let (generics, arguments, bounds) = input.generics.split_for_impl();
    let laid = |rest: &[TokenStream],
                kind: TokenStream,
                over: TokenStream,
                name: TokenStream,
                given: TokenStream| {
        (!rest.is_empty()).then(|| {
            quote!(
                fn #name(
                    #over,
                    mut #given: ::judder_store::#kind,
                ) -> ::std::result::Result<::judder_store::#kind, ::judder_store::StoreError> {
                    #(#rest)*
                    ::std::result::Result::Ok(#given)
                }
            )
        })
    };
    let over = if said.rows.is_some() { quote!(rows: &[Self]) } else { quote!(&self) };
    let all_arrays = [attributes, arrays].concat();
    let arrays = laid(&all_arrays, quote!(Dataset), over.clone(), quote!(add_arrays), quote!(dataset));
    let columns = laid(&columns, quote!(Table), over, quote!(add_columns), quote!(table));
    let (of_one, of_rows) = match said.rows {
        Some(_) => {
            let rows =
                quote!(impl #generics ::judder_store::Rows for #name #arguments #bounds { #arrays #columns });
            (TokenStream::new(), rows)
        }
        None => (quote!(#arrays #columns), TokenStream::new()),
    };
    Ok(quote! {
        impl #generics ::judder_store::Results for #name #arguments #bounds {
            fn declared() -> ::std::vec::Vec<::judder_store::Declared> {
                let mut declared = ::std::vec::Vec::new();
                #(#declared)*
                declared
            }

            fn scalars(&self) -> ::serde_json::Map<::std::string::String, ::serde_json::Value> {
                let mut scalars = ::serde_json::Map::new();
                #(#scalars)*
                scalars
            }

            #of_one
        }

        impl #generics ::judder_store::Told for #name #arguments #bounds {
            fn kind() -> ::judder_store::ValueKind {
                ::judder_store::ValueKind::Object(<Self as ::judder_store::Results>::declared())
            }

            fn told(&self) -> ::serde_json::Value {
                ::serde_json::Value::Object(::judder_store::Results::scalars(self))
            }
        }

        #of_rows
    })
}
