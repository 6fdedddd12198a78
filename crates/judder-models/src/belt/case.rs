//! The belt case: one mass on a moving belt, with friction against the speed of sliding, for the literature's benchmarks.

use std::path::Path;
use std::sync::Arc;

use crate::REGISTRY;
use crate::belt::MODEL;
use crate::friction::FrictionCurve;
use crate::motion::settings::{MotionKinds, MotionModel};
use crate::motion::{MotionAnalysis, MotionOf};
use crate::sweep::Sweep;
use crate::swept_keys::{SweptKeys, key_of};
use judder_contact::friction::falling::LARGEST_EXPONENT;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Declaration, Settings, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::keys::{Key, Keys, Numbers};
use judder_keys::numeric_key::{Range, Scaled, Value};
use judder_keys::section::Section;
use judder_keys::{Keys, Settings};
use judder_study::case::analysis::{Kinds, Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use judder_study::model::Analysis;
use serde_json::Value as Json;

/// A number of a belt case. Mass and natural frequency are the units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Keys)]
pub enum BeltKey {
    /// Damping ratio.
    #[key(section = "oscillator", symbol = "ξ", rule = Scaled::number("ξ", Range::NonNegative), default = "0.05")]
    Damping,
    /// Cubic stiffness of the spring beside the linear one, whose force is x + κ x³.
    #[key(section = "oscillator", symbol = "κ", rule = Scaled::number("κ", Range::NonNegative), default = "0.0")]
    CubicStiffness,
    /// Friction coefficient at rest, the limit of stick.
    #[key(section = "friction", symbol = "μ_0", rule = Scaled::number("μ_0", Range::NonNegative), default = "1.0", label = "Friction at rest")]
    AtRest,
    /// Friction coefficient at high speed.
    #[key(section = "friction", symbol = "μ_∞", rule = Scaled::number("μ_∞", Range::NonNegative), default = "0.5", label = "Friction at speed")]
    AtSpeed,
    /// Speed over which friction falls: μ_∞ + (μ_0 − μ_∞) e^(−|v|/v_0).
    #[key(section = "friction", symbol = "v_0", rule = Scaled::number("v_0", Range::Positive), default = "0.5")]
    DecaySpeed,
    /// Rise of friction with the speed: c |v| beside what falls.
    #[key(section = "friction", symbol = "c", rule = Scaled::number("c", Range::NonNegative), default = "0.0", label = "Viscous friction")]
    Viscous,
    /// Exponent with which friction falls, e^(−(|v|/v_0)^n): 2 as Gauss's curve.
    #[key(section = "friction", symbol = "n", rule = Scaled::number("n", EXPONENTS), default = "1.0")]
    Exponent,
    /// Speed of the belt.
    #[key(section = "operation", symbol = "v", rule = Scaled::number("v", Range::Positive), default = "1.0", label = "Belt velocity")]
    Velocity,
    /// Normal force on the mass.
    #[key(section = "operation", symbol = "N", rule = Scaled::number("N", Range::Positive), default = "1.0")]
    NormalForce,
}

/// Below one the slope at rest would have no bound.
const EXPONENTS: Range = Range::Closed { from: 1.0, to: LARGEST_EXPONENT };

/// The value of every key of a belt case at one operating point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeltInputs {
    values: [f64; BeltKey::ALL.len()],
}

impl Default for BeltInputs {
    fn default() -> Self {
        let usual = |entry: &Key<BeltKey>| entry.usual_value().map_or(f64::NAN, |value| value.number);
        Self { values: std::array::from_fn(|k| usual(&BeltKey::ALL[k])) }
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

impl Sweep<BeltKey> {
    /// Sets the swept key of one operating point.
    pub fn set(&self, inputs: &mut BeltInputs, value: f64) {
        inputs.set(self.key, value);
    }
}

/// A validated belt case.
#[derive(Debug, Clone)]
pub struct BeltCase {
    /// The title; empty where the case gives none.
    pub title: String,
    /// The value of every key at the operating point of the case.
    pub inputs: BeltInputs,
    /// A friction coefficient of one's own, in place of the keys of one that falls.
    pub curve: Option<FrictionCurve<true>>,
    /// The analyses in the order of the case file.
    pub analyses: Vec<Planned<Arc<dyn Analysis<BeltCase>>>>,
}

/// The keys that the analyses of a belt case can vary.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BeltKeys {
    /// Whether friction is a table, which has no keys to vary.
    has_curve: bool,
}

impl SweptKeys for BeltKeys {
    type Key = BeltKey;

    fn find(&self, path: &str) -> Result<BeltKey, Cause> {
        let key = BeltKey::from_path(path).ok_or_else(|| {
            let known = BeltKey::paths().into_iter().map(str::to_owned).collect();
            Cause::UnknownName { what: "swept key", name: path.to_owned(), known }
        })?;
        match key.entry() {
            Key { path: key, .. } if self.has_curve && key.starts_with("friction.") => {
                Err(Cause::Meaningless { key, with: "a table of friction".to_owned() })
            }
            _ => Ok(key),
        }
    }

    fn path(&self, key: BeltKey) -> String {
        key.to_string()
    }

    fn read(&self, key: BeltKey, name: &str, node: &Node) -> Result<Value, Fault> {
        key.entry().rule.read(name, node)
    }

    fn same(&self, first: BeltKey, second: BeltKey) -> bool {
        first == second
    }

    fn dimension(_: BeltKey) -> Dimension {
        Dimension::NUMBER
    }

    fn key_form() -> Allowed {
        key_of(MODEL.name)
    }

    fn check(&self, _: &[(BeltKey, Value)]) -> Result<(), Cause> {
        Ok(())
    }
}

impl MotionModel for BeltKeys {
    const FREQUENCY: &'static str = "Frequency $ω$ (−)";
    const HAS_SECONDS: bool = false;

    type Analysis = Arc<dyn Analysis<BeltCase>>;

    fn of_motion<A: MotionOf<Self>>(analysis: A) -> Self::Analysis {
        Arc::new(MotionAnalysis(analysis))
    }

    /// Mass and natural frequency are the units, and there is no other direction.
    fn own(declared: Vec<Declaration>) -> Vec<Declaration> {
        let own = |mut key: Declaration| {
            match &mut key.form {
                Allowed::Scaled(time) => *time = Scaled::number("t", time.range),
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
            Allowed::Scaled(time) => time.read(&section.path(key.name), node).map(|_| ()),
            Allowed::Table { keys, .. } => {
                let known: Vec<_> = keys.iter().map(|key| key.name).collect();
                section.table(key.name, node, &known).map(|_| ())
            }
            _ => Ok(()),
        });
        all(checked).map(|_| ())
    }
}

/// What a case says beside its analyses.
#[derive(Debug, Settings)]
#[settings(title = "a belt case")]
pub(crate) struct BeltSections {
    /// The mass on its spring.
    #[key(rule = "oscillator")]
    oscillator: Numbers<BeltKey>,
    /// Friction between mass and belt: one that falls from rest and may rise again, or a table against the speed.
    #[key(default)]
    friction: BeltFriction,
    /// Speed and force.
    #[key(rule = "operation")]
    operation: Numbers<BeltKey>,
}

/// Friction between mass and belt.
#[derive(Debug, Settings)]
#[settings(title = "[friction]")]
pub(crate) enum BeltFriction {
    /// One that falls from rest, and may rise again.
    #[key(flatten, rule = "friction")]
    Falling(Numbers<BeltKey>),
    /// A table.
    #[key(flatten)]
    Curve(FrictionCurve<true>),
}

/// The kinds of a belt case.
pub(crate) static KINDS: Kinds<BeltKeys, Arc<dyn Analysis<BeltCase>>> = Kinds::new(&[
    MotionKinds::HISTORY,
    MotionKinds::LIMIT_CYCLE,
    MotionKinds::BIFURCATION,
    MotionKinds::BASIN,
]);

/// Reads a belt case from the root of its tree.
pub(crate) fn read(node: &Node, folder: &Path) -> Result<BeltCase, Fault> {
    let (root, sections) = read_root::<BeltSections>(node)?;
    let has_curve = sections.as_ref().is_ok_and(|(_, own)| matches!(own.friction, BeltFriction::Curve(_)));
    let analyses = read_analyses(&root, &BeltKeys { has_curve }, &KINDS, REGISTRY);
    let ((title, BeltSections { oscillator, friction, operation }), analyses) = both(sections, analyses)?;
    let (falling, mut curve) = match friction {
        BeltFriction::Falling(falling) => (falling, None),
        BeltFriction::Curve(curve) => (Numbers::default(), Some(curve)),
    };
    if let (Some(curve), Some(section)) = (&mut curve, root.inner("friction")?) {
        curve.admit(&section, folder)?;
    }
    let mut inputs = BeltInputs::default();
    for Numbers(given) in [oscillator, falling, operation] {
        given.iter().for_each(|(key, value)| inputs.set(*key, value.number));
    }
    Ok(BeltCase { title, inputs, curve, analyses })
}

impl BeltCase {
    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, |kind, json| kind.write(json));
        let numbers = |section| {
            let own = BeltKey::of_section(section).map(|entry| entry.key);
            Numbers(own.map(|key| (key, Value::group(self.inputs.number(key)))).collect())
        };
        let [oscillator, falling, operation] = ["oscillator", "friction", "operation"].map(numbers);
        let friction = self.curve.clone().map_or(BeltFriction::Falling(falling), BeltFriction::Curve);
        BeltSections { oscillator, friction, operation }.write_table(&mut json);
        Json::Object(json)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_values_of_their_keys() {
        for entry in BeltKey::ALL {
            assert!(entry.rule.range.contains(BeltInputs::default().number(entry.key)), "{}", entry.path);
        }
    }
}
