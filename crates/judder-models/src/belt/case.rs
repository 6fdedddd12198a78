//! The belt case: one mass on a moving belt, with friction against the speed of sliding, for the literature's benchmarks.

use std::path::Path;
use std::sync::Arc;

use crate::REGISTRY;
use crate::belt::MODEL;
use crate::belt::inputs::BeltInputs;
use crate::belt::problem::{BeltProblem, GIVE_UNITS};
use crate::friction::FrictionCurve;
use crate::motion::settings::{MotionKinds, MotionModel};
use crate::motion::{MotionAnalysis, MotionOf};
use crate::swept_keys::{SweptKeys, key_of};
use judder_contact::friction::falling::LARGEST_EXPONENT;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Declaration, Settings, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::keys::{Key, Keys, Numbers};
use judder_keys::numeric_key::{Form, Range, Scaled, Value};
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_keys::{Keys, Settings};
use judder_study::case::analysis::{Kinds, Planned, read_analyses};
use judder_study::case::root::{document, read_root};
use judder_study::model::Analysis;
use serde_json::Value as Json;

/// A number of a belt case. Mass and natural frequency are the units where the case does not give mass and stiffness in SI.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Keys)]
pub enum BeltKey {
    /// Mass; with it and the stiffness the case is in SI.
    #[key(section = "oscillator", symbol = "m", rule = Scaled::quantity(Dimension::MASS), typical = [1e-3, 1e3])]
    Mass,
    /// Stiffness of the spring.
    #[key(section = "oscillator", symbol = "k", rule = Scaled::quantity(Dimension::STIFFNESS), typical = [0.1, 1e7])]
    Stiffness,
    /// Damping ratio, or in SI the damping of the damper too.
    #[key(section = "oscillator", symbol = "ξ", rule = at_least_zero(Dimension::DAMPING, "ξ"), default = "0.05")]
    Damping,
    /// Cubic stiffness of the spring beside the linear one, whose force is x + κ x³, in SI k x + κ x³.
    #[key(section = "oscillator", symbol = "κ", rule = at_least_zero(Dimension::new(-2, 1, -2, 0), "κ"), default = "0.0")]
    CubicStiffness,
    /// Friction coefficient at rest, the limit of stick.
    #[key(section = "friction", symbol = "μ_0", rule = Scaled::number("μ_0", Range::NonNegative), default = "1.0", label = "Friction at rest")]
    AtRest,
    /// Friction coefficient at high speed.
    #[key(section = "friction", symbol = "μ_∞", rule = Scaled::number("μ_∞", Range::NonNegative), default = "0.5", label = "Friction at speed")]
    AtSpeed,
    /// Speed over which friction falls: μ_∞ + (μ_0 − μ_∞) e^(−|v|/v_0).
    #[key(section = "friction", symbol = "v_0", rule = Scaled::positive(Dimension::SPEED, "v_0"), default = "0.5")]
    DecaySpeed,
    /// Rise of friction with the speed: c |v| beside what falls.
    #[key(section = "friction", symbol = "c", rule = at_least_zero(Dimension::new(-1, 0, 1, 0), "c"), default = "0.0", label = "Viscous friction")]
    Viscous,
    /// Exponent with which friction falls, e^(−(|v|/v_0)^n): 2 as Gauss's curve.
    #[key(section = "friction", symbol = "n", rule = Scaled::number("n", EXPONENTS), default = "1.0")]
    Exponent,
    /// Speed of the belt.
    #[key(section = "operation", symbol = "v", rule = Scaled::positive(Dimension::SPEED, "v"), default = "1.0", label = "Belt velocity")]
    Velocity,
    /// Normal force on the mass.
    #[key(section = "operation", symbol = "N", rule = Scaled::positive(Dimension::FORCE, "N"), default = "1.0")]
    NormalForce,
}

/// Zero or above, as this group or with a unit.
const fn at_least_zero(dimension: Dimension, group: &'static str) -> Scaled {
    Scaled { range: Range::NonNegative, ..Scaled::positive(dimension, group) }
}

/// Below one the slope at rest would have no bound.
const EXPONENTS: Range = Range::Closed { from: 1.0, to: LARGEST_EXPONENT };

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
    /// The case without what an analysis varies.
    inputs: BeltInputs,
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
            Key { key: BeltKey::Mass | BeltKey::Stiffness, path: key, .. } if !self.inputs.is_si() => {
                Err(Cause::Meaningless { key, with: "a case without units".to_owned() })
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

    fn dimension(key: BeltKey) -> Dimension {
        key.entry().rule.dimension
    }

    fn key_form() -> Allowed {
        key_of(MODEL.name)
    }

    fn value_form() -> Allowed {
        Allowed::Quantity
    }

    fn check(&self, settings: &[(BeltKey, Value)]) -> Result<(), Cause> {
        settings.iter().try_for_each(|(key, value)| self.inputs.check(*key, *value).map_err(Cause::from))
    }
}

impl MotionModel for BeltKeys {
    const FREQUENCY: &'static str = "Frequency $ω$ (−)";
    const SECONDS: &'static str = GIVE_UNITS;

    fn has_seconds(&self) -> bool {
        self.inputs.is_si()
    }

    type Analysis = Arc<dyn Analysis<BeltCase>>;

    fn of_motion<A: MotionOf<Self>>(analysis: A) -> Self::Analysis {
        Arc::new(MotionAnalysis(analysis))
    }

    /// There is no other direction, and groups are by the units of the model.
    fn own(declared: Vec<Declaration>) -> Vec<Declaration> {
        let in_units = |form: &mut Allowed| {
            if let Allowed::Scaled(own) = form {
                own.group = Some(match own.dimension {
                    Dimension::TIME => "ω t",
                    Dimension::LENGTH => "x",
                    _ => "dx/dt",
                });
            }
        };
        let own = |mut key: Declaration| {
            in_units(&mut key.form);
            if let Allowed::Table { keys, .. } = &mut key.form {
                keys.retain(|key| !["y", "velocity_y"].contains(&key.name));
                for key in keys {
                    in_units(&mut key.form);
                    if let Allowed::List { of, .. } = &mut key.form {
                        in_units(of);
                    }
                }
            }
            key
        };
        declared.into_iter().map(own).collect()
    }

    fn refuse_others(&self, section: &Section<'_>, declared: &[Declaration]) -> Result<(), Fault> {
        let given = declared.iter().filter_map(|key| Some((key, section.get(key.name)?)));
        let checked = given.map(|(key, node)| match &key.form {
            Allowed::Table { keys, .. } => {
                let known: Vec<_> = keys.iter().map(|key| key.name).collect();
                let inner = section.table(key.name, node, &known)?;
                let given = keys.iter().filter_map(|key| Some((key, inner.get(key.name)?)));
                all(given.map(|(key, node)| self.read_as_written(&key.form, &inner.path(key.name), node)))
                    .map(drop)
            }
            form => self.read_as_written(form, &section.path(key.name), node),
        });
        all(checked).map(|_| ())
    }
}

impl BeltKeys {
    /// Refuses units where the case has none, and displacements and velocities without where it has some.
    fn read_as_written(&self, form: &Allowed, name: &str, node: &Node) -> Result<(), Fault> {
        match (form, &node.data) {
            (Allowed::List { of, .. }, Data::List(items)) => {
                all(items.iter().map(|item| self.read_as_written(of, name, item))).map(drop)
            }
            (Allowed::Scaled(own), _) => {
                let is_time = own.dimension == Dimension::TIME;
                let own = match (self.inputs.is_si(), is_time) {
                    (false, _) => Scaled::number(own.group.unwrap_or_default(), own.range),
                    (true, true) => *own,
                    (true, false) => Scaled { group: None, ..*own },
                };
                own.read(name, node).map(drop)
            }
            _ => Ok(()),
        }
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
    let (title, BeltSections { oscillator, friction, operation }) = match sections {
        Ok(sections) => sections,
        Err(fault) => {
            let keys = BeltKeys { has_curve: false, inputs: BeltInputs::default() };
            return both(Err::<BeltCase, _>(fault), read_analyses(&root, &keys, &KINDS, REGISTRY))
                .map(|(case, _)| case);
        }
    };
    let (falling, mut curve) = match friction {
        BeltFriction::Falling(falling) => (falling, None),
        BeltFriction::Curve(curve) => (Numbers::default(), Some(curve)),
    };
    let mut inputs = BeltInputs::default();
    for Numbers(given) in [oscillator, falling, operation] {
        given.iter().for_each(|(key, value)| inputs.set(*key, *value));
    }
    let admitted = match (&mut curve, root.inner("friction")?) {
        (Some(curve), Some(section)) => curve.admit(&section, folder),
        _ => Ok(()),
    };
    let admitted = admitted.and_then(|()| check_units(&root, &inputs, curve.as_ref()));
    let keys = BeltKeys { has_curve: curve.is_some(), inputs };
    let ((), analyses) = both(admitted, read_analyses(&root, &keys, &KINDS, REGISTRY))?;
    Ok(BeltCase { title, inputs, curve, analyses })
}

/// Refuses a case that mixes quantities with numbers in the units of the model.
fn check_units(
    root: &Section<'_>,
    inputs: &BeltInputs,
    curve: Option<&FrictionCurve<true>>,
) -> Result<(), Fault> {
    let given = |key: BeltKey| inputs.number(key) > 0.0;
    if given(BeltKey::Mass) != given(BeltKey::Stiffness) {
        return Err(BeltProblem::HalfUnits.at(root.place_of(&["oscillator"])));
    }
    let has_meaning = |entry: &&Key<BeltKey>| curve.is_none() || entry.section() != "friction";
    let own = BeltKey::ALL.iter().filter(has_meaning).filter(|entry| inputs.has(entry.key)).map(|entry| {
        let place = match root.inner(entry.section())? {
            Some(section) => section.place_of(&[entry.name()]),
            None => root.place,
        };
        inputs.check(entry.key, inputs.get(entry.key)).map_err(|problem| problem.at(place))
    });
    all(own)?;
    let Some(curve) = curve else { return Ok(()) };
    let place = match root.inner("friction")? {
        Some(section) => section.place_of(&["velocity", "file"]),
        None => root.place,
    };
    match (curve.speed_form(), inputs.is_si()) {
        (None, _) => {
            Err(Cause::MixedForms { keys: "the speeds of `friction.velocity`".to_owned() }.at(place))
        }
        (Some(Form::Si), false) => Err(BeltProblem::WithoutUnits { key: "friction.velocity" }.at(place)),
        (Some(Form::Group), true) => {
            let example = Dimension::SPEED.example();
            Err(BeltProblem::NeedsUnit { key: "friction.velocity", example }.at(place))
        }
        _ => Ok(()),
    }
}

impl BeltCase {
    /// The canonical form.
    pub(super) fn resolved(&self) -> Json {
        let mut json = document(MODEL.name, &self.title, &self.analyses, |kind, json| kind.write(json));
        let numbers = |section| {
            let own = BeltKey::of_section(section).map(|entry| entry.key);
            let given = own.filter(|key| self.inputs.has(*key));
            Numbers(given.map(|key| (key, self.inputs.get(key))).collect())
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
            let inputs = BeltInputs::default();
            let value = inputs.get(entry.key);
            assert!(entry.rule.range.contains(value.number) || !inputs.has(entry.key), "{}", entry.path);
        }
    }
}
