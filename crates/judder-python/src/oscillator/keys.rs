//! Keyword arguments as the keys of an oscillator case: a plain number is a group, a text carries its unit.

use crate::choice::{meant, named};
use crate::contact::PyLaw;
use crate::errors;
use crate::watched::{Manner, watched};
use judder_keys::keys::{Given, Keys};
use judder_models::bridge::{self, CaseContact};
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::inputs::OscillatorInputs;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::oscillator::law_name::LawName;
use judder_oscillator::Contact;
use judder_oscillator::FrictionLoad;
use judder_study::model::Model;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyString};

/// An oscillator as keyword arguments describe it.
pub(crate) struct AskedOscillator {
    /// The case: values of all keys, law, friction load.
    pub(crate) case: OscillatorCase,
    /// The law where it was given as one.
    pub(crate) law: Option<Py<PyLaw>>,
}

/// The value of one key.
fn value(key: OscillatorKey, given: &Bound<'_, PyAny>) -> PyResult<judder_keys::numeric_key::Value> {
    let read = |given| key.read(given).map_err(|error| errors::case(&error));
    if let Ok(number) = given.cast_exact::<PyFloat>() {
        return read(Given::Number(number.extract()?));
    }
    if let Ok(text) = given.cast::<PyString>() {
        return read(Given::Text(&text.to_cow()?));
    }
    match given.extract::<f64>() {
        Ok(number) => read(Given::Number(number)),
        Err(_) => {
            let name = key.entry().name();
            let own = given.get_type().name()?;
            let arrays = match given.hasattr("__len__")? {
                true => "; arrays go to judder.oscillator.points",
                false => "",
            };
            Err(errors::argument(
                name,
                format!("a number or a text with a unit is needed, not {own}{arrays}"),
            ))
        }
    }
}

impl AskedOscillator {
    /// The oscillator paper's values, law and friction load, where nothing else is given.
    pub(crate) fn new(law: Option<&Bound<'_, PyAny>>, friction_load: Option<&str>) -> PyResult<Self> {
        let mut asked = Self { case: OscillatorCase::default(), law: None };
        if let Some(given) = law {
            match given.cast::<PyLaw>() {
                Ok(law) => {
                    asked.case.law = LawName::File;
                    asked.law = Some(law.clone().unbind());
                }
                Err(_) => asked.case.law = named("law", given.extract()?, &LawName::ALL)?,
            }
        }
        if let Some(name) = friction_load {
            asked.case.friction_load = named("friction_load", name, &FrictionLoad::ALL)?;
        }
        Ok(asked)
    }

    /// Sets keys by their names, in the order of the case file, and checks what ties them together; one that is `None` is not given.
    pub(crate) fn set<'py>(
        &mut self,
        keys: impl IntoIterator<Item = (Bound<'py, PyAny>, Bound<'py, PyAny>)>,
    ) -> PyResult<()> {
        let mut values = Vec::new();
        for (name, given) in keys {
            // a wrong name is one, whatever its value
            let key = key(&name.extract::<String>()?)?;
            if !given.is_none() {
                values.push((key, given));
            }
        }
        values.sort_by_key(|(key, _)| *key);
        let is_given = |key| values.iter().any(|(own, _)| *own == key);
        if is_given(OscillatorKey::RetardationTime) && is_given(OscillatorKey::RelaxationTime) {
            let message = "give the retardation or the relaxation time, not both";
            return Err(errors::input("relaxation_time", message));
        }
        for (key, given) in &values {
            self.case.inputs.set(*key, value(*key, given)?);
        }
        self.checked(self.case.inputs)
    }

    /// Refuses moduli that contradict each other or the law.
    pub(crate) fn checked(&self, inputs: OscillatorInputs) -> PyResult<()> {
        inputs.check(self.case.law).map_err(|cause| errors::input("glassy_modulus", cause))
    }

    /// The case in its canonical form, JSON, a law that was given as one by its name.
    pub(crate) fn told(&self, py: Python<'_>) -> String {
        let mut json = self.case.resolved();
        if let (Some(law), Some(contact)) = (&self.law, json.get_mut("contact")) {
            contact["law"] = law.bind(py).get().name().into();
        }
        json.to_string()
    }

    /// The contact where it costs nothing to have.
    pub(crate) fn contact_at_hand(&self) -> Option<Contact> {
        let law = match &self.law {
            Some(law) => law.get().law().clone(),
            None => bridge::formula(self.case.law)?,
        };
        Some(Contact { law, friction_load: self.case.friction_load })
    }

    /// The contact with its warnings; the law `bem` is computed where it was not before.
    pub(crate) fn contact(&self, py: Python<'_>, manner: &Manner) -> PyResult<CaseContact> {
        let model = |error| errors::model(&error);
        if let Some(law) = &self.law {
            return bridge::with_law(&self.case, law.get().law().clone()).map_err(model);
        }
        if bridge::formula(self.case.law).is_some() {
            return bridge::contact_of(&self.case, &judder_study::Silent).map_err(model);
        }
        watched(py, manner, |watch| bridge::contact_of(&self.case, watch))?.settled(model)
    }
}

/// The key of a dotted path or of its last name.
pub(crate) fn key(name: &str) -> PyResult<OscillatorKey> {
    let entry = OscillatorKey::ALL.iter().find(|entry| entry.path == name || entry.name() == name);
    entry.map(|entry| entry.key).ok_or_else(|| {
        let is_path = name.contains('.');
        let known =
            meant(name, OscillatorKey::ALL.iter().map(|own| if is_path { own.path } else { own.name() }));
        errors::input(name, format!("no key of an oscillator; {known}"))
    })
}
