//! What can be swept of an oscillator case: its numeric keys.

use super::{OscillatorCase, OscillatorSections};
use crate::contact::problem::ContactProblem;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use crate::swept_keys::{SweptKeys, key_of};
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Settings, listed};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::Value;
use judder_study::case::root::COMMON;

/// The numeric keys of an oscillator case, around its operating point.
pub(crate) struct OscillatorKeys {
    /// Its numbers and its law; none of a case in which something is wrong, of which nothing is checked.
    known: Option<(OscillatorInputs, LawName)>,
    /// Whether the indenter is a cylinder, whose law is one of a radius, a thickness and a Poisson's ratio.
    is_line: bool,
    /// What decides moduli and times together, where a series or data were given.
    decided_by: Option<&'static str>,
}

impl OscillatorKeys {
    /// Those of a case in which something is wrong.
    pub(crate) const UNKNOWN: Self = Self { known: None, is_line: false, decided_by: None };

    /// Those of this case.
    pub(crate) fn of(case: &OscillatorCase) -> Self {
        Self {
            known: Some((case.inputs, case.law)),
            is_line: case.length.is_some(),
            decided_by: case.substrate.decided_by(),
        }
    }

    /// Whether the case is written in SI.
    pub(crate) fn has_seconds(&self) -> bool {
        self.known.is_none_or(|(inputs, _)| inputs.si_units().is_some())
    }

    /// What keeps a key from being swept.
    fn fixed_by(&self, key: OscillatorKey) -> Option<String> {
        use OscillatorKey::{GlassyModulus, RelaxationTime, RetardationTime, RubberyModulus};
        let is_modulus = matches!(key, RubberyModulus | GlassyModulus);
        match self.decided_by {
            Some(by) if is_modulus || matches!(key, RetardationTime | RelaxationTime) => {
                Some(format!("`{by}`"))
            }
            _ if is_modulus && matches!(self.known, Some((_, LawName::Bem))) => {
                Some("the law `bem`, which is computed for one substrate,".to_owned())
            }
            _ if self.is_line && matches!(key, OscillatorKey::Radius | OscillatorKey::PoissonRatio) => {
                Some("the law of a cylinder, which is computed for one radius on one layer,".to_owned())
            }
            _ => None,
        }
    }
}

impl SweptKeys for OscillatorKeys {
    type Key = OscillatorKey;

    fn find(&self, path: &str) -> Result<OscillatorKey, Cause> {
        if let Some(key) = OscillatorKey::from_path(path) {
            return match self.fixed_by(key) {
                None => Ok(key),
                Some(by) => {
                    let problem = ContactProblem::FixedKey { key: path.to_owned(), by };
                    Err(problem.into())
                }
            };
        }
        let known = OscillatorKey::paths().into_iter().map(str::to_owned).collect();
        // of a section, or of the case itself
        let declared = || listed("", &OscillatorSections::declarations());
        let is_other = path.matches('.').count() == 1 && declared().iter().any(|own| own.path == path);
        Err(if is_other || COMMON.contains(&path) {
            Cause::NotNumeric { key: path.to_owned(), known }
        } else {
            Cause::UnknownName { what: "swept key", name: path.to_owned(), known }
        })
    }

    fn path(&self, key: OscillatorKey) -> String {
        key.to_string()
    }

    fn read(&self, key: OscillatorKey, name: &str, node: &Node) -> Result<Value, Fault> {
        key.entry().rule.read(name, node)
    }

    fn same(&self, first: OscillatorKey, second: OscillatorKey) -> bool {
        let is_time = |key| matches!(key, OscillatorKey::RetardationTime | OscillatorKey::RelaxationTime);
        first == second || (is_time(first) && is_time(second))
    }

    fn dimension(key: OscillatorKey) -> Dimension {
        key.entry().rule.dimension
    }

    fn key_form() -> Allowed {
        key_of("oscillator")
    }

    fn value_form() -> Allowed {
        Allowed::Quantity
    }

    fn check(&self, settings: &[(OscillatorKey, Value)]) -> Result<(), Cause> {
        let Some((mut inputs, law)) = self.known else { return Ok(()) };
        for (key, value) in settings {
            inputs.set(*key, *value);
        }
        inputs.check(law)
    }
}
