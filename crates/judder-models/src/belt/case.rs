//! The belt case: one mass on a moving belt, with friction that falls with speed, for the literature's benchmarks.

use std::fmt;

use crate::REGISTRY;
use crate::motion::settings::{MotionAnalysis, MotionKinds, MotionModel};
use crate::swept_keys::{SweptKeys, key_among};
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Declaration, Scaled, all};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::numeric_key::read_value;
use judder_keys::numeric_key::{Key, Range, Value, number};
use judder_keys::section::Section;
use judder_study::case::analysis::{Kind, Planned, read_analyses};

/// A numeric key of a belt case; its position in [`BELT_KEYS`] is `key as usize`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum BeltKey {
    /// ξ.
    Damping,
    /// μ_0.
    AtRest,
    /// μ_∞.
    AtSpeed,
    /// v_0.
    DecaySpeed,
    /// v.
    Velocity,
    /// N.
    NormalForce,
}

/// Every key of a belt case, in the order of the case file. Mass and natural frequency are the units.
pub static BELT_KEYS: [Key<BeltKey>; 6] = [
    number(BeltKey::Damping, "oscillator.damping", "ξ", Range::NonNegative, ("0.05", 0.05), "damping ratio"),
    number(
        BeltKey::AtRest,
        "friction.at_rest",
        "μ_0",
        Range::NonNegative,
        ("1.0", 1.0),
        "friction coefficient at rest, the limit of stick",
    ),
    number(
        BeltKey::AtSpeed,
        "friction.at_speed",
        "μ_∞",
        Range::NonNegative,
        ("0.5", 0.5),
        "friction coefficient at high speed",
    ),
    number(
        BeltKey::DecaySpeed,
        "friction.decay_speed",
        "v_0",
        Range::Positive,
        ("0.5", 0.5),
        "speed over which friction falls: μ_∞ + (μ_0 − μ_∞) e^(−|v|/v_0)",
    ),
    number(BeltKey::Velocity, "operation.velocity", "v", Range::Positive, ("1.0", 1.0), "speed of the belt"),
    number(
        BeltKey::NormalForce,
        "operation.normal_force",
        "N",
        Range::Positive,
        ("1.0", 1.0),
        "normal force on the mass",
    ),
];

impl BeltKey {
    /// The entry of the key.
    pub fn entry(self) -> &'static Key<Self> {
        &BELT_KEYS[self as usize]
    }
}

impl fmt::Display for BeltKey {
    /// The dotted path.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.entry().path)
    }
}

/// The value of every key of a belt case at one operating point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeltInputs {
    values: [f64; BELT_KEYS.len()],
}

impl Default for BeltInputs {
    fn default() -> Self {
        Self {
            values: std::array::from_fn(|k| BELT_KEYS[k].default.map_or(f64::NAN, |(_, value)| value.number)),
        }
    }
}

impl BeltInputs {
    /// The value of a key.
    pub fn number(&self, key: BeltKey) -> f64 {
        self.values[key as usize]
    }

    /// Sets a key; its range is the reader's part.
    pub fn set(&mut self, key: BeltKey, value: f64) {
        self.values[key as usize] = value;
    }
}

/// A validated belt case.
#[derive(Debug, Clone, PartialEq)]
pub struct BeltCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The value of every key at the operating point of the case.
    pub inputs: BeltInputs,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<MotionAnalysis<BeltKey>>>,
}

/// The keys that the analyses of a belt case can vary.
pub(crate) struct BeltKeys;

impl SweptKeys for BeltKeys {
    type Key = BeltKey;

    fn find(&self, path: &str) -> Result<BeltKey, Cause> {
        BELT_KEYS.iter().find(|entry| entry.path == path).map(|entry| entry.key).ok_or_else(|| {
            let known = BELT_KEYS.iter().map(|entry| entry.path.to_owned()).collect();
            Cause::UnknownName { what: "swept key", name: path.to_owned(), known }
        })
    }

    fn path(&self, key: BeltKey) -> String {
        key.to_string()
    }

    fn read(&self, key: BeltKey, name: &str, node: &Node) -> Result<Value, Fault> {
        read_value(key.entry(), name, node)
    }

    fn same(&self, first: BeltKey, second: BeltKey) -> bool {
        first == second
    }

    fn dimension(_: BeltKey) -> Dimension {
        Dimension::NUMBER
    }

    fn key_form() -> Allowed {
        key_among("belt-key")
    }

    fn check(&self, _: &[(BeltKey, Value)]) -> Result<(), Cause> {
        Ok(())
    }
}

impl MotionModel for BeltKeys {
    type Analysis = MotionAnalysis<BeltKey>;

    fn of_motion(analysis: MotionAnalysis<BeltKey>) -> MotionAnalysis<BeltKey> {
        analysis
    }

    /// Mass and natural frequency are the units, and there is no other direction.
    fn own(declared: Vec<Declaration>) -> Vec<Declaration> {
        let own = |mut key: Declaration| {
            match &mut key.form {
                Allowed::Scaled(time) => *time = Scaled { dimension: Dimension::NUMBER, group: "t", ..*time },
                Allowed::Table { keys, .. } => keys.retain(|key| !["y", "velocity_y"].contains(&key.name)),
                _ => {}
            }
            key
        };
        declared.into_iter().map(own).collect()
    }

    fn refuse_others(section: &Section<'_>, declared: &[Declaration]) -> Result<(), Fault> {
        let given = declared.iter().filter_map(|key| Some((key, section.get(key.name)?)));
        let checked = given.map(|(key, node)| match &key.form {
            Allowed::Scaled(time) => read_value(&time.entry(), &section.path(key.name), node).map(|_| ()),
            Allowed::Table { keys, .. } => {
                let known: Vec<_> = keys.iter().map(|key| key.name).collect();
                section.table(key.name, node, &known).map(|_| ())
            }
            _ => Ok(()),
        });
        all(checked).map(|_| ())
    }
}

/// The sections of a belt case, in the order of the case file.
pub(crate) const BELT_SECTIONS: [&str; 3] = ["oscillator", "friction", "operation"];

/// The kinds of a belt case.
pub(crate) static KINDS: [Kind<BeltKeys, MotionAnalysis<BeltKey>>; 4] =
    [MotionKinds::HISTORY, MotionKinds::LIMIT_CYCLE, MotionKinds::BIFURCATION, MotionKinds::BASIN];

/// Reads a belt case from the root of its tree.
pub(crate) fn read(root: &Node) -> Result<BeltCase, Fault> {
    let known: Vec<_> =
        ["title", "model"].into_iter().chain(BELT_SECTIONS).chain(["analysis", "sweep"]).collect();
    let root = Section::open(root, "", "a belt case", &known)?;
    let title = root.text("title")?.unwrap_or_default().to_owned();
    let mut inputs = BeltInputs::default();
    for name in BELT_SECTIONS {
        let Some(node) = root.get(name) else { continue };
        let entries = || BELT_KEYS.iter().filter(|entry| entry.section() == name);
        let known: Vec<_> = entries().map(Key::name).collect();
        let section = Section::open(node, name, &format!("[{name}]"), &known)?;
        for entry in entries() {
            if let Some(node) = section.get(entry.name()) {
                inputs.set(entry.key, read_value(entry, entry.path, node)?.number);
            }
        }
    }
    let analyses = read_analyses(&root, &BeltKeys, &KINDS, REGISTRY)?;
    Ok(BeltCase { title, inputs, analyses })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_stands_at_its_index_and_has_a_default_in_range() {
        for (index, entry) in BELT_KEYS.iter().enumerate() {
            assert_eq!(entry.key as usize, index, "{}", entry.path);
            assert!(entry.range.contains(BeltInputs::default().number(entry.key)), "{}", entry.path);
        }
    }
}
