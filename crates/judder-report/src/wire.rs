//! A figure for the interactive chart: its JSON, with arrays as compressed bytes and every range settled.

use crate::error::ReportError;
use crate::figure::{Figure, Layer};
use crate::layout::{bar_range, layout};
use crate::scale::PlacedAxis;
use crate::validate;
use base64::{Engine, engine::general_purpose::STANDARD};
use miniz_oxide::deflate::compress_to_vec;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Arrays up to this length stand where they are, in digits.
const SHORT: usize = 8;

/// What single precision may displace a point, over what its array spans: a pixel, where a hundredth of the picture is magnified to the
/// whole.
const DISPLACED: f64 = 1e-5;

/// The best compression of the algorithm: a page is written once and kept.
const LEVEL: u8 = 9;

/// The figure as JSON.
///
/// Its fields are those of [`Figure`], with the range of every axis and colour bar settled; a number that is not finite, a gap, is `null`.
/// `{ "array": k }` is an array of more than a few numbers: `arrays[k]` has its kind and length, `"f4"` or, where single precision would show,
/// `"f8"`, and `"u1"` for the codes of cells. Their bytes stand one array after the other in `bytes` (raw deflate, base64), of each array first
/// the lowest byte of every number, then the next, which compresses better.
///
/// # Errors
/// As [`crate::svg`].
pub fn json(figure: &Figure) -> Result<String, ReportError> {
    validate::check(figure)?;
    let failed = |error: serde_json::Error| ReportError::Json {
        figure: figure.name.clone(),
        reason: error.to_string(),
    };
    let mut value = serde_json::to_value(settled(figure)).map_err(failed)?;
    let mut arrays = FigureArrays::default();
    arrays.take_from(&mut value);
    let bytes = STANDARD.encode(compress_to_vec(&arrays.bytes, LEVEL));
    // a figure is a table
    if let Some(fields) = value.as_object_mut() {
        fields.extend([("arrays".to_owned(), json!(arrays.taken)), ("bytes".to_owned(), json!(bytes))]);
    }
    // another crate of the build may have switched serde_json to insertion order
    value.sort_all_objects();
    Ok(value.to_string())
}

/// The same figure with every range given.
fn settled(figure: &Figure) -> Figure {
    let drawn = layout(figure).panels;
    let mut figure = figure.clone();
    let range = |placed: &PlacedAxis| Some((placed.from, placed.to));
    for (panel, drawn) in figure.panels.iter_mut().zip(&drawn) {
        panel.x.range = range(&drawn.x.placed);
        panel.y.range = range(&drawn.y.placed);
        for layer in &mut panel.layers {
            if let Layer::Values(map) = layer {
                map.bar.range = range(&bar_range(map));
            }
        }
    }
    figure
}

/// Arrays that have been taken out of a figure, each once.
#[derive(Default)]
struct FigureArrays {
    /// Kinds and lengths.
    taken: Vec<(&'static str, usize)>,
    bytes: Vec<u8>,
    known: BTreeMap<(&'static str, Vec<u8>), usize>,
}

impl FigureArrays {
    fn take_from(&mut self, value: &mut Value) {
        match value {
            Value::Array(items) if items.len() > SHORT && items.iter().all(is_number) => {
                let (kind, bytes) = encoded(items);
                let next = self.taken.len();
                let number = *self.known.entry((kind, bytes.clone())).or_insert(next);
                if number == next {
                    self.taken.push((kind, items.len()));
                    self.bytes.extend(bytes);
                }
                *value = json!({ "array": number });
            }
            Value::Array(items) => items.iter_mut().for_each(|item| self.take_from(item)),
            Value::Object(fields) => fields.values_mut().for_each(|field| self.take_from(field)),
            _ => {}
        }
    }
}

fn is_number(value: &Value) -> bool {
    value.is_number() || value.is_null()
}

/// The kind and the bytes of an array.
fn encoded(items: &[Value]) -> (&'static str, Vec<u8>) {
    let codes = items.iter().map(|item| item.as_u64().and_then(|code| u8::try_from(code).ok()));
    if let Some(codes) = codes.collect::<Option<Vec<u8>>>() {
        return ("u1", codes);
    }
    let values: Vec<f64> = items.iter().map(|item| item.as_f64().unwrap_or(f64::NAN)).collect();
    if is_single(&values) {
        let numbers: Vec<[u8; 4]> = values.iter().map(|value| (*value as f32).to_le_bytes()).collect();
        return ("f4", by_significance(&numbers));
    }
    let numbers: Vec<[u8; 8]> = values.iter().map(|value| value.to_le_bytes()).collect();
    ("f8", by_significance(&numbers))
}

fn by_significance<const SIZE: usize>(numbers: &[[u8; SIZE]]) -> Vec<u8> {
    (0..SIZE).flat_map(|place| numbers.iter().filter_map(move |number| number.get(place).copied())).collect()
}

/// Whether single precision leaves every value its digits, and its place among the others.
fn is_single(values: &[f64]) -> bool {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (low, high) = finite()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    let span = if high > low { high - low } else { f64::INFINITY };
    finite().all(|value| {
        let moved = (f64::from(value as f32) - value).abs();
        moved <= 1e-7 * value.abs() && moved <= DISPLACED * span
    })
}
