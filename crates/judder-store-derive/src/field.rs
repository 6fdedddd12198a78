//! A field of results: what it is called, and what is made of it.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Error, Expr, ExprLit, Field, Ident, Lit, LitStr, Meta, Result, Type};

/// A result as its field declares it.
pub(crate) struct ResultField {
    pub(crate) field: Ident,
    ty: Type,
    doc: String,
    unit: Option<LitStr>,
    /// Its key in the summary; none of what is hidden.
    summary: Option<String>,
    along: Option<LitStr>,
    /// The head of its column, where that is not made of name and unit.
    column: Option<LitStr>,
    is_optional: bool,
    is_attribute: bool,
    has_rows: bool,
    /// Whether its keys stand among those beside it.
    is_flat: bool,
}

impl ResultField {
    pub(crate) fn new(field: &Field) -> Result<Self> {
        let Some(name) = field.ident.clone() else {
            return Err(Error::new_spanned(field, "results have named fields"));
        };
        let mut entry = Self {
            summary: Some(name.to_string()),
            field: name,
            ty: field.ty.clone(),
            doc: doc(field),
            unit: None,
            along: None,
            column: None,
            is_optional: false,
            is_attribute: false,
            has_rows: false,
            is_flat: false,
        };
        for attribute in field.attrs.iter().filter(|attribute| attribute.path().is_ident("result")) {
            attribute.parse_nested_meta(|meta| {
                let name = meta.path.get_ident().map(Ident::to_string).unwrap_or_default();
                match name.as_str() {
                    "summary" => entry.summary = Some(meta.value()?.parse::<LitStr>()?.value()),
                    "hidden" => entry.summary = None,
                    "unit" => entry.unit = Some(meta.value()?.parse()?),
                    "along" => entry.along = Some(meta.value()?.parse()?),
                    "column" => entry.column = Some(meta.value()?.parse()?),
                    "optional" => entry.is_optional = true,
                    "attribute" => entry.is_attribute = true,
                    "rows" => entry.has_rows = true,
                    "flatten" => entry.is_flat = true,
                    _ => {
                        return Err(meta.error(
                            "a result takes summary, hidden, unit, along, column, optional, attribute, rows, flatten",
                        ));
                    }
                }
                Ok(())
            })?;
        }
        Ok(entry)
    }

    /// Declares what the summary has of it.
    pub(crate) fn declared(&self) -> Option<TokenStream> {
        let Self { ty, is_optional, unit, .. } = self;
        let name = self.summary.as_ref()?;
        let unit = unit.as_ref().map(|unit| quote!(unit: #unit.to_owned(),));
        Some(match self.is_flat {
            true => quote!(declared.extend(<#ty as ::judder_store::Results>::declared());),
            false => quote!(declared.push(::judder_store::Declared {
                is_optional: #is_optional,
                #unit
                ..::judder_store::Declared::new(#name, <#ty as ::judder_store::Told>::kind())
            });),
        })
    }

    /// Puts it into the summary.
    pub(crate) fn scalar(&self) -> Option<TokenStream> {
        let Self { field, summary, .. } = self;
        let name = summary.as_ref()?;
        if self.is_flat {
            return Some(quote!(scalars.extend(::judder_store::Results::scalars(&self.#field));));
        }
        Some(match self.is_optional {
            true => quote!(if let ::std::option::Option::Some(value) = &self.#field {
                scalars.insert(#name.to_owned(), ::judder_store::Told::told(value));
            }),
            false => quote!(scalars.insert(#name.to_owned(), ::judder_store::Told::told(&self.#field));),
        })
    }

    /// Puts it among the attributes of the dataset.
    pub(crate) fn attribute(&self) -> Option<TokenStream> {
        let field = &self.field;
        let name = self.summary.clone().unwrap_or_else(|| field.to_string());
        self.is_attribute
            .then(|| quote!(dataset = dataset.attribute(#name, ::judder_store::Told::told(&self.#field))?;))
    }

    /// Puts it among the arrays; `own` are its values, `along` the dimensions where it does not say otherwise.
    pub(crate) fn array(
        &self,
        own: &TokenStream,
        along: Option<&LitStr>,
        prefix: &str,
    ) -> Result<TokenStream> {
        let Self { field, doc, unit, .. } = self;
        if self.has_rows {
            return Ok(quote!(dataset = ::judder_store::Rows::add_arrays(&#own[..], dataset)?;));
        }
        if self.is_flat {
            return Ok(quote!(dataset = ::judder_store::Results::add_arrays(&#own, dataset)?;));
        }
        let Some(along) = self.along.as_ref().or(along) else {
            return Err(Error::new(field.span(), "an array says what it lies along"));
        };
        if doc.is_empty() {
            return Err(Error::new(field.span(), "the doc comment of an array says what it is"));
        }
        let (along, name) = (along.value(), format!("{prefix}{field}"));
        let dimensions: Vec<&str> = along.split_whitespace().collect();
        let unit = unit.as_ref().map(|unit| quote!(.units(#unit)));
        Ok(quote!(
            if let ::std::option::Option::Some(variable) =
                ::judder_store::Array::variable(&#own, #name, &[#(#dimensions),*])
            {
                dataset = dataset.with(variable #unit .long_name(#doc))?;
            }
        ))
    }

    /// Puts it among the columns of the table; `own` are its values.
    pub(crate) fn column(&self, own: &TokenStream) -> TokenStream {
        let Self { field, unit, .. } = self;
        if self.has_rows {
            return quote!(table = ::judder_store::Rows::add_columns(&#own[..], table)?;);
        }
        if self.is_flat {
            return quote!(table = ::judder_store::Results::add_columns(&#own, table)?;);
        }
        let (name, unit) = match &self.column {
            Some(head) => (head.value(), String::new()),
            None => (field.to_string(), unit.as_ref().map_or_else(String::new, LitStr::value)),
        };
        quote!(
            if let ::std::option::Option::Some(cells) = ::judder_store::Column::cells(&#own) {
                table = table.column(#name, #unit, cells)?;
            }
        )
    }
}

/// The doc comment of a field in one line.
fn doc(field: &Field) -> String {
    let line = |meta: &Meta| match meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value().trim().to_owned()),
            _ => None,
        },
        _ => None,
    };
    field.attrs.iter().filter_map(|attribute| line(&attribute.meta)).collect::<Vec<_>>().join(" ")
}
