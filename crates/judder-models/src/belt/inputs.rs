//! The numbers of one operating point of a belt, in the units of the model or in SI.

use super::case::BeltKey;
use super::problem::BeltProblem;
use crate::friction::FrictionCurve;
use crate::motion::si::SiUnits;
use crate::sweep::Sweep;
use judder_contact::friction::{FallingFriction, Friction, FrictionError};
use judder_keys::keys::{Key, Keys};
use judder_keys::numeric_key::{Form, Value};

/// The value of every key of a belt case at one operating point; mass and stiffness are zero where the case has no units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeltInputs {
    values: [Value; BeltKey::ALL.len()],
}

impl Default for BeltInputs {
    fn default() -> Self {
        let usual = |entry: &Key<BeltKey>| entry.usual_value().unwrap_or(Value::si(0.0));
        Self { values: std::array::from_fn(|k| usual(&BeltKey::ALL[k])) }
    }
}

impl Sweep<BeltKey> {
    /// Sets the swept key of one operating point.
    pub fn set(&self, inputs: &mut BeltInputs, value: f64) {
        inputs.set(self.key, Value { number: value, form: self.form });
    }
}

impl BeltInputs {
    /// The value of a key.
    pub fn get(&self, key: BeltKey) -> Value {
        self.values[key as usize]
    }

    /// The number of a key, in the form in which it is given.
    pub fn number(&self, key: BeltKey) -> f64 {
        self.get(key).number
    }

    /// Sets a key; its range is the reader's part.
    pub fn set(&mut self, key: BeltKey, value: Value) {
        self.values[key as usize] = value;
    }

    /// Whether a key has a value: mass and stiffness of a case without units have none.
    pub(crate) fn has(&self, key: BeltKey) -> bool {
        self.number(key) > 0.0 || !matches!(key, BeltKey::Mass | BeltKey::Stiffness)
    }

    /// Whether the case is in SI: whether mass and stiffness are given.
    pub fn is_si(&self) -> bool {
        [BeltKey::Mass, BeltKey::Stiffness].iter().all(|key| self.number(*key) > 0.0)
    }

    /// ω = √(k/m) in rad/s; none of a case without units.
    pub(crate) fn natural_frequency(&self) -> Option<f64> {
        let [mass, stiffness] = [BeltKey::Mass, BeltKey::Stiffness].map(|key| self.number(key));
        self.is_si().then(|| (stiffness / mass).sqrt())
    }

    /// 1/ω in s, 1 m, the stiffness times 1 m² in J, and 1 m², where the case is in SI.
    pub(crate) fn si_units(&self) -> Option<SiUnits> {
        let joule = self.number(BeltKey::Stiffness);
        let second = self.natural_frequency()?.recip();
        Some(SiUnits { second, metre: 1.0, joule, square_metre: 1.0 })
    }

    /// The number of a key in units of the mass, 1/ω and 1 m.
    pub(crate) fn in_units(&self, key: BeltKey) -> f64 {
        let Value { number, form } = self.get(key);
        let [mass, stiffness] = [BeltKey::Mass, BeltKey::Stiffness].map(|key| self.number(key));
        let frequency = (stiffness / mass).sqrt();
        match (form, key) {
            (Form::Group, _) => number,
            (Form::Si, BeltKey::Damping) => 0.5 * number / (mass * frequency),
            (Form::Si, BeltKey::CubicStiffness | BeltKey::NormalForce) => number / stiffness,
            (Form::Si, BeltKey::DecaySpeed | BeltKey::Velocity) => number / frequency,
            (Form::Si, BeltKey::Viscous) => number * frequency,
            (Form::Si, _) => number,
        }
    }

    /// The friction coefficient in these units: by a curve in place of the keys, where there is one.
    pub(crate) fn friction(&self, curve: Option<&FrictionCurve<true>>) -> Result<Friction, FrictionError> {
        match curve {
            Some(curve) => curve.friction_by(self.natural_frequency().unwrap_or(1.0)),
            None => Ok(Friction::Falling(FallingFriction {
                at_rest: self.in_units(BeltKey::AtRest),
                at_speed: self.in_units(BeltKey::AtSpeed),
                decay_speed: self.in_units(BeltKey::DecaySpeed),
                viscous: self.in_units(BeltKey::Viscous),
                exponent: self.in_units(BeltKey::Exponent),
            })),
        }
    }

    /// Whether a value of a key goes with the units of the case: with a unit where it has some, apart from a damping ratio and from what is zero.
    pub(crate) fn check(&self, key: BeltKey, value: Value) -> Result<(), BeltProblem> {
        let entry = key.entry();
        let has_units = !entry.rule.dimension.is_number();
        match (self.is_si(), value.form) {
            (false, Form::Si) => Err(BeltProblem::WithoutUnits { key: entry.path }),
            (true, Form::Group) if has_units && key != BeltKey::Damping && value.number != 0.0 => {
                Err(BeltProblem::NeedsUnit { key: entry.path, example: entry.rule.example() })
            }
            _ => Ok(()),
        }
    }
}
