//! Arrays with their names and units as bytes of a stream.
//!
//! A frame is the length of its header and of its payload, each four bytes, little end first; the header, JSON, filled with spaces; the
//! payload. Header and payload end on multiples of eight bytes, as every array in the payload begins, so that a reader in a browser can lay
//! typed arrays over the bytes.

use judder_store::{Variable, VariableValues};
use serde_json::{Map, Value, json};

/// What every part is filled up to.
const ALIGNMENT: usize = 8;

/// A frame in the making.
#[derive(Debug, Default)]
pub(crate) struct FrameInTheMaking {
    header: Map<String, Value>,
    arrays: Vec<Value>,
    payload: Vec<u8>,
}

impl FrameInTheMaking {
    /// A frame of this kind, without arrays yet.
    pub(crate) fn new(kind: &str) -> Self {
        Self { header: Map::from_iter([("kind".to_owned(), json!(kind))]), ..Self::default() }
    }

    /// With a further entry of the header.
    pub(crate) fn with(mut self, key: &str, value: impl Into<Value>) -> Self {
        self.header.insert(key.to_owned(), value.into());
        self
    }

    /// With an array.
    pub(crate) fn array(mut self, variable: &Variable) -> Self {
        let offset = self.payload.len();
        let mut entry = json!({
            "name": variable.name, "dimensions": variable.dimensions, "shape": variable.shape, "offset": offset,
            "units": variable.units, "long_name": variable.long_name, "attributes": variable.attributes,
        });
        let (kind, values) = self.lay(&variable.data);
        entry["type"] = json!(kind);
        if let Some(values) = values {
            entry["values"] = values;
        }
        self.arrays.push(entry);
        fill(&mut self.payload, 0);
        self
    }

    /// Appends the values to the payload, and says what they are; texts stand in the header.
    fn lay(&mut self, data: &VariableValues) -> (&'static str, Option<Value>) {
        let payload = &mut self.payload;
        let mut reals = |values: &mut dyn Iterator<Item = f64>| {
            values.for_each(|value| payload.extend_from_slice(&value.to_le_bytes()));
        };
        match data {
            VariableValues::F64(values) => reals(&mut values.iter().copied()),
            // a browser's numbers are of this kind; what is counted here stays below 2⁵³
            VariableValues::I64(values) => reals(&mut values.iter().map(|value| *value as f64)),
            VariableValues::Complex(values) => {
                reals(&mut values.iter().flat_map(|value| [value.re, value.im]));
                return ("complex", None);
            }
            VariableValues::U8(values) => {
                payload.extend_from_slice(values);
                return ("u8", None);
            }
            VariableValues::Text(values) => return ("text", Some(json!(values))),
        }
        ("f64", None)
    }

    /// The bytes.
    pub(crate) fn bytes(mut self) -> Vec<u8> {
        self.header.insert("arrays".to_owned(), Value::Array(self.arrays));
        let mut header = Value::Object(self.header).to_string().into_bytes();
        fill(&mut header, b' ');
        let length = |part: &[u8]| u32::try_from(part.len()).unwrap_or(u32::MAX).to_le_bytes();
        let mut bytes = Vec::with_capacity(ALIGNMENT + header.len() + self.payload.len());
        bytes.extend_from_slice(&length(&header));
        bytes.extend_from_slice(&length(&self.payload));
        bytes.append(&mut header);
        bytes.append(&mut self.payload);
        bytes
    }
}

/// Fills a part up to a multiple of [`ALIGNMENT`].
fn fill(part: &mut Vec<u8>, with: u8) {
    part.resize(part.len().next_multiple_of(ALIGNMENT), with);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_is_laid_out_as_its_header_says() {
        let bytes = FrameInTheMaking::new("map")
            .with("seconds", 0.5)
            .array(&Variable::new("code", &["k"], &[3], vec![1_u8, 2, 3]))
            .array(&Variable::coordinate("ŷ", vec![1.5, f64::NAN]).units("1"))
            .array(&Variable::new("name", &["k"], &[1], vec!["é".to_owned()]))
            .bytes();
        let length = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        let (header, payload) = (length(0), length(4));
        assert_eq!((8 + header) % 8 + payload % 8, 0);
        assert_eq!(bytes.len(), 8 + header + payload);
        let document: Value = serde_json::from_slice(&bytes[8..8 + header]).unwrap();
        assert_eq!(document["kind"], "map");
        let arrays = document["arrays"].as_array().unwrap();
        assert_eq!((&arrays[0]["type"], &arrays[1]["type"]), (&json!("u8"), &json!("f64")));
        assert_eq!(arrays[2]["values"], json!(["é"]));
        let start = 8 + header + arrays[1]["offset"].as_u64().unwrap() as usize;
        assert_eq!(start % 8, 0);
        assert_eq!(f64::from_le_bytes(bytes[start..start + 8].try_into().unwrap()), 1.5);
    }
}
