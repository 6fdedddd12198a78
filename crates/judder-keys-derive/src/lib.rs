//! Derives what is declared of settings: a struct becomes a table of keys, an enum alternatives of keys or a choice of words.
//!
//! ```text
//! #[derive(Settings)]
//! #[settings(title = "a growth")]
//! struct Growth {
//!     /// where the contact is held
//!     #[key(rule = LENGTH, symbol = "s")]
//!     position: f64,
//! }
//! ```
//!
//! The doc comment of a field says what the key is, in its first paragraph. Its attribute takes
//!
//! - `rule`: what the type of the field needs to read it, as a unit, a range, a length of a list;
//! - `default`: the value where the key is left out, without a value that of an empty table; `usual`: that of an optional key, which other keys may
//!   decide otherwise; `filled`: the case fills it in; `later`: it must be given, which is told when the case is known;
//! - `symbol` and `example`, for the reference and for messages; `name`, where the key is not called as the field is;
//! - `omitted`: an absent one is left out of the canonical form and not `null` in it; `unwritten`: the form never has it;
//! - `flatten`: the keys of its table stand among those beside it; with a `rule`, where its type needs one.
//!
//! A struct takes `#[settings(check = …, title = "…")]`: what is checked and filled in when all keys are read, how messages call the table.
//!
//! An enum has an alternative a variant: one key, called as the variant and declared there, or the fields of the variant. Keys of two are refused, the
//! first variant is meant where there is no key of any; its `check` sees the section before.

//!
//! A choice takes `#[choice(what = "…")]`, what its words are; `list`, the constant of its words, where it is not `ALL`.
//!
//! An enum of keys is a list of the numbers of a case that its analyses can vary: a variant a key, called as the variant is, whose attribute takes
//! `section`, in which it stands, `symbol` and `rule`, and `default` as a case file has it, without quotes; `typical`, between which its values usually lie;
//! `label`, the words of an axis, and `scaled`, its symbol there of the dimensionless group.

mod choice;
mod field;
mod keys;
mod settings;

use proc_macro::TokenStream;
use syn::{DeriveInput, parse_macro_input};

/// A struct of settings, an enum of alternatives.
#[proc_macro_derive(Settings, attributes(settings, key))]
pub fn derive_settings(input: TokenStream) -> TokenStream {
    settings::derive(&parse_macro_input!(input as DeriveInput))
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}

/// An enum of words, each the name of a variant in lower case with dashes.
#[proc_macro_derive(Choice, attributes(choice))]
pub fn derive_choice(input: TokenStream) -> TokenStream {
    choice::derive(&parse_macro_input!(input as DeriveInput))
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}

/// An enum of the numbers of a case that its analyses vary.
#[proc_macro_derive(Keys, attributes(key))]
pub fn derive_keys(input: TokenStream) -> TokenStream {
    keys::derive(&parse_macro_input!(input as DeriveInput))
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}
