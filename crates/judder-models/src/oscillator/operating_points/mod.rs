//! The operating points of an oscillator over a sweep.
//!
//! - `quantities`: what can be asked of one.
//! - `law_warnings`: what a finished sweep says of its law.
//! - `arrays`: those of any inputs, without a case or a sweep.

pub mod arrays;
mod law_warnings;
mod quantities;

pub(crate) use law_warnings::read_anew;
pub(crate) use quantities::{LINEAR_QUANTITIES, QUANTITIES, linear_values};

use crate::bridge::{self, CaseContact};
use crate::computed_law::NO_POINTS;
use crate::error::ModelError;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use crate::swept_keys::SweptKeys;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::{Form, Value};
use judder_oscillator::Contact;
use judder_study::Progress;
use judder_study::StudyError;
use judder_study::case::study_sweep::{StudySweep, SweptKey};
use judder_study::model::{Case, OperatingPoints, OperatingQuantity, OperatingWork};
use quantities::OperatingState;

/// Points at which law and material are what they are: the swept keys are set in the inputs of the case.
pub(crate) struct OfOneLaw {
    case: OscillatorCase,
    keys: Vec<(OscillatorKey, Form)>,
    contact: Contact,
    /// How a law that was computed for all points is doubtful.
    computed: Vec<String>,
}

impl OfOneLaw {
    /// `None` where the case must be read anew at each point.
    ///
    /// # Errors
    /// A law or data that cannot be.
    pub(crate) fn new(
        case: &OscillatorCase,
        sweep: &StudySweep,
        progress: &dyn Progress,
    ) -> Result<Option<Self>, ModelError> {
        let Some(keys) = set_keys(case, sweep).filter(|keys| law_stays(case, keys)) else {
            return Ok(None);
        };
        let case = bridge::with_material(case)?;
        let CaseContact { contact, warnings } = bridge::contact(&case, NO_POINTS, progress)?;
        // the others depend on the point
        let computed = if case.law == LawName::Bem { warnings } else { Vec::new() };
        Ok(Some(Self { case, keys, contact, computed }))
    }

    /// The inputs with these values.
    fn inputs(&self, values: &[f64]) -> Result<OscillatorInputs, ModelError> {
        let mut inputs = self.case.inputs;
        for ((key, form), value) in self.keys.iter().zip(values) {
            inputs.set(*key, Value { number: *value, form: *form });
        }
        inputs.check(self.case.law).map_err(|cause| ModelError::Unsupported(cause.to_string()))?;
        Ok(inputs)
    }
}

impl OperatingPoints for OfOneLaw {
    fn at(&self, values: &[f64], wanted: &[OperatingQuantity]) -> Result<Vec<f64>, StudyError> {
        let state = OperatingState::new(&self.contact, &self.inputs(values)?).map_err(ModelError::from)?;
        Ok(state.values(wanted))
    }

    fn told(&self, sweep: &StudySweep) -> Result<Vec<String>, StudyError> {
        Ok(law_warnings::law_warnings(self, sweep)?)
    }
}

/// The key of an oscillator that a sweep varies, and the form of its values.
pub(crate) fn key_of(case: &OscillatorCase, key: &SweptKey) -> Option<(OscillatorKey, Form)> {
    let form = if key.dimension.is_number() { Form::Group } else { Form::Si };
    Some((OscillatorKeys::of(case).find(&key.path).ok()?, form))
}

/// Those of a sweep, where setting them is all that reading the case anew does.
fn set_keys(case: &OscillatorCase, sweep: &StudySweep) -> Option<Vec<(OscillatorKey, Form)>> {
    sweep.axes.iter().map(|key| key_of(case, key)).collect::<Option<_>>().filter(|_| sweep.is_set)
}

/// Whether setting these keys is all that reading the case anew does, as the cases show that were tried.
pub(crate) fn is_set_by(case: &OscillatorCase, keys: &[SweptKey], tried: &[Case]) -> bool {
    let keys = keys.iter().map(|key| key_of(case, key)).collect::<Option<Vec<_>>>();
    let Some(keys) = keys else { return false };
    let is_set = |tried: &OscillatorCase| {
        let mut inputs = case.inputs;
        for (key, form) in &keys {
            // the value is that of the case read anew: what counts is what else it changed
            inputs.set(*key, Value { number: tried.inputs.number(*key), form: *form });
        }
        tried.is_like(&OscillatorCase { inputs, ..case.clone() })
    };
    tried.iter().all(|tried| tried.of().is_some_and(is_set))
}

/// These quantities of the operating point of a case, and why its law is doubtful there.
///
/// # Errors
/// A law that cannot be, no steady sliding.
pub(crate) fn of_case(
    case: &OscillatorCase,
    wanted: &[OperatingQuantity],
    progress: &dyn Progress,
) -> Result<(Vec<f64>, Vec<String>), ModelError> {
    let case = bridge::with_material(case)?;
    let CaseContact { contact, warnings: mut doubts } = bridge::contact(&case, NO_POINTS, progress)?;
    let state = OperatingState::new(&contact, &case.inputs)?;
    let values = state.values(wanted);
    doubts.extend(state.concern().map(|concern| format!("outside the law's range: {concern}")));
    Ok((values, doubts))
}

/// What a point of a sweep takes.
pub(crate) fn work(case: &OscillatorCase, sweep: &StudySweep, wanted: &[OperatingQuantity]) -> OperatingWork {
    let stays = set_keys(case, sweep).is_some_and(|keys| law_stays(case, &keys));
    match (stays, case.law == LawName::Bem) {
        (false, true) => OperatingWork::Law,
        (true, _) if !wanted.iter().any(|quantity| quantity.is_sought) => OperatingWork::Point,
        _ => OperatingWork::Search,
    }
}

/// Whether law and material are the same at every point.
fn law_stays(case: &OscillatorCase, keys: &[(OscillatorKey, Form)]) -> bool {
    let is_line = case.length.is_some();
    let of_law = |key: OscillatorKey| {
        key.entry().section() == "substrate" || (is_line && key == OscillatorKey::Radius)
    };
    let moves = keys.iter().any(|(key, _)| of_law(*key));
    !(moves && (case.law == LawName::Bem || case.substrate.decided_by().is_some()))
}
