//! A temperature of the substrate, and the rule by which it moves all times of the spectrum.

use judder_keys::Settings;
use judder_keys::declared::declared_table;
use judder_keys::declared::{Allowed, Number, Scaled, Setting, Settings, conflict};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::section::Section;
use serde_json::{Value as Json, json};

/// A temperature and the rule by which it moves all times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Temperature {
    /// T, K.
    pub temperature: f64,
    /// The rule.
    pub shift: Shift,
}

/// How temperature moves all times of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shift {
    /// log₁₀ a_T = −C1 (T − T_ref)/(C2 + T − T_ref).
    Wlf(Wlf),
    /// ln a_T = E_a/R_gas (1/T − 1/T_ref).
    Arrhenius(Arrhenius),
}

/// log₁₀ a_T = −C1 (T − T_ref)/(C2 + T − T_ref).
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct Wlf {
    /// First constant of the WLF shift.
    #[key(name = "c1", rule = Number::positive(Dimension::NUMBER), symbol = "C1", example = "1.5")]
    pub first: f64,
    /// Second constant of the WLF shift, a difference of temperatures in K.
    #[key(name = "c2", symbol = "C2", example = "\"51.6 K\"")]
    pub second: TemperatureDifference,
    /// Temperature at which the times are as given.
    #[key(name = "reference_temperature", rule = TEMPERATURE, symbol = "T_ref")]
    pub reference: f64,
}

/// ln a_T = E_a/R_gas (1/T − 1/T_ref).
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct Arrhenius {
    /// Activation energy of the Arrhenius shift.
    #[key(rule = Number::positive(Dimension::MOLAR_ENERGY), symbol = "E_a")]
    pub activation_energy: f64,
    /// Temperature at which the times are as given.
    #[key(name = "reference_temperature", rule = TEMPERATURE, symbol = "T_ref")]
    pub reference: f64,
}

/// A difference of temperatures, K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TemperatureDifference(pub f64);

/// One of two rules.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
#[settings(check = ShiftKeys::one)]
struct ShiftKeys {
    /// The shift of Williams, Landel and Ferry: log₁₀ a_T = −C1 (T − T_ref)/(C2 + T − T_ref).
    #[key(omitted)]
    wlf: Option<Wlf>,
    /// The shift of Arrhenius: ln a_T = E_a/R_gas (1/T − 1/T_ref).
    #[key(omitted)]
    arrhenius: Option<Arrhenius>,
}

const TEMPERATURE: Number = Number::positive(Dimension::TEMPERATURE);

impl ShiftKeys {
    /// Refuses both, and neither.
    fn one(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        conflict(section, "wlf", "arrhenius")?;
        if self.wlf.is_none() && self.arrhenius.is_none() {
            return Err(section.missing("wlf", "wlf = { … } or arrhenius = { … }"));
        }
        Ok(())
    }
}

impl Setting for Shift {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let keys = ShiftKeys::declarations();
        let mut schema = declared_table(ShiftKeys::DOC, &keys);
        schema["minProperties"] = json!(1);
        schema["maxProperties"] = json!(1);
        Allowed::Told { schema, words: "a table with `wlf` or `arrhenius`".to_owned(), keys }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let keys: ShiftKeys = Setting::read(section, key, node, &())?;
        Ok(match (keys.wlf, keys.arrhenius) {
            (_, Some(own)) => Self::Arrhenius(own),
            (Some(own), None) => Self::Wlf(own),
            (None, None) => return Err(section.missing(key, "a rule")),
        })
    }

    fn write(&self, (): &()) -> Json {
        let keys = match *self {
            Self::Wlf(own) => ShiftKeys { wlf: Some(own), arrhenius: None },
            Self::Arrhenius(own) => ShiftKeys { wlf: None, arrhenius: Some(own) },
        };
        Setting::write(&keys, &())
    }
}

const DIFFERENCE: Scaled = Scaled { is_difference: true, ..Scaled::quantity(Dimension::TEMPERATURE) };

impl Setting for TemperatureDifference {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Scaled(DIFFERENCE)
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        DIFFERENCE.read(&section.path(key), node).map(|value| Self(value.number))
    }

    fn write(&self, (): &()) -> Json {
        Setting::write(&self.0, &TEMPERATURE)
    }
}
