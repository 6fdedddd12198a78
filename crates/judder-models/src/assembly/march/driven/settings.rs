//! The keys of what changes over the time of a motion.

use super::signal::SignalSettings;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::SurfaceOf;
use crate::assembly::case::problem::AssemblyProblem;
use judder_keys::Settings;
use judder_keys::declared::{Number, Several, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list};
use judder_structure::freedom::Direction;
use std::path::Path;

/// What changes over the time of a motion.
#[derive(Debug, Clone, Default, PartialEq, Settings)]
#[settings(check = DrivenSettings::check)]
pub struct DrivenSettings {
    /// What speeds, loads and friction are multiplied by over time; nothing where left out.
    #[key(omitted)]
    pub course: Option<CourseSettings>,
    /// A temperature over time, which decides on friction by friction_over_temperature.
    #[key(omitted, example = "{ times = [\"0 s\", \"1 s\"], temperatures = [\"20 degC\", \"300 degC\"] }")]
    pub temperature: Option<TemperatureSettings>,
    /// What friction is multiplied by at a temperature, beside its factor of the course.
    #[key(omitted, example = "{ temperatures = [\"20 degC\", \"300 degC\"], factors = [1, 0.6] }")]
    pub friction_over_temperature: Option<FrictionOverTemperature>,
    /// How the base shakes that holds the bodies and rigid planes; displacements are beside it.
    #[key(rule = SEVERAL, omitted, example = "[{ direction = \"y\", acceleration = { amplitude = \"1 m/s^2\", frequency = \"50 Hz\" } }]")]
    pub base: Option<Vec<BaseSettings>>,
    /// Forces that change over time, beside the loads.
    #[key(rule = SEVERAL, omitted, example = "[{ structure = \"…\", set = \"…\", direction = \"x\", force = { amplitude = \"1 N\", frequency = \"50 Hz\" } }]")]
    pub forces: Option<Vec<ForceSettings>>,
}

impl DrivenSettings {
    /// Whether anything drives the motion.
    pub(in crate::assembly::march) fn is_driven(&self) -> bool {
        *self != Self::default()
    }
}

/// What speeds, loads and friction are multiplied by over time.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = CourseSettings::check)]
pub struct CourseSettings {
    /// What the sliding of all contacts is multiplied by.
    #[key(omitted)]
    pub speed: Option<FactorSettings>,
    /// What all loads are multiplied by.
    #[key(omitted)]
    pub load: Option<FactorSettings>,
    /// What the friction of all contacts is multiplied by.
    #[key(omitted)]
    pub friction: Option<FactorSettings>,
}

/// A factor over time.
#[derive(Debug, Clone, PartialEq, Settings)]
pub enum FactorSettings {
    /// Values at times.
    Table {
        /// Times of a table, ascending.
        #[key(rule = TIMES, symbol = "t", example = "[\"0 s\", \"3 s\"] with factors, or rise = \"0.1 s\", or file = \"….csv\"")]
        times: Vec<f64>,
        /// Factors there, straight between the times and constant outside.
        #[key(rule = FACTORS)]
        factors: Vec<f64>,
    },
    /// Time over which the factor rises from 0 to 1 with half a cosine, in place of a table.
    #[key(rule = Number::non_negative(Dimension::TIME), symbol = "T")]
    Rise(f64),
    /// A table in a file, with a header such as `time [s],factor`.
    File(FileReference),
}

/// A temperature over time.
#[derive(Debug, Clone, PartialEq, Settings)]
pub enum TemperatureSettings {
    /// Values at times.
    Table {
        /// Times of a table, ascending.
        #[key(rule = TIMES, symbol = "t")]
        times: Vec<f64>,
        /// Temperatures there, straight between the times and constant outside.
        #[key(rule = TEMPERATURES, symbol = "T")]
        temperatures: Vec<f64>,
    },
    /// A table in a file, with a header such as `time [s],temperature [degC]`.
    File(FileReference),
}

/// A factor of friction over temperature.
#[derive(Debug, Clone, PartialEq, Settings)]
pub enum FrictionOverTemperature {
    /// Values at temperatures.
    Table {
        /// Temperatures of a table, ascending; none outside of it may come.
        #[key(rule = TEMPERATURES, symbol = "T")]
        temperatures: Vec<f64>,
        /// Factors of friction there, straight between the temperatures.
        #[key(rule = FACTORS)]
        factors: Vec<f64>,
    },
    /// A table in a file, with a header such as `temperature [degC],factor`.
    File(FileReference),
}

/// How a base shakes.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub struct BaseSettings {
    /// The direction in which the base shakes.
    pub direction: Direction,
    /// Its acceleration.
    pub acceleration: SignalSettings<false>,
}

/// A force that changes over time.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub struct ForceSettings {
    /// Where it acts, on all nodes together, which share it alike.
    #[key(flatten)]
    pub nodes: SurfaceOf,
    /// Its direction.
    pub direction: Direction,
    /// The force.
    pub force: SignalSettings<true>,
}

const SEVERAL: Several<()> = Several { of: (), length: [1, usize::MAX] };
const TIMES: Several<Number> = Several { of: Number::non_negative(Dimension::TIME), length: [1, usize::MAX] };
const FACTORS: Several<Number> = Several { of: Number::any(Dimension::NUMBER), length: [1, usize::MAX] };
const TEMPERATURES: Several<Number> =
    Several { of: Number::positive(Dimension::TEMPERATURE), length: [1, usize::MAX] };

impl CourseSettings {
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        match (&self.speed, &self.load, &self.friction) {
            (None, None, None) => {
                let reason = "a course has a `speed`, a `load` or a `friction`".to_owned();
                Err(AssemblyProblem::Refused { reason }.at(section.place))
            }
            _ => Ok(()),
        }
    }
}

impl DrivenSettings {
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let (key, reason) = match (&self.temperature, &self.friction_over_temperature) {
            (Some(_), None) => (
                "temperature",
                "a `temperature` decides on friction by `friction_over_temperature`, which is not there",
            ),
            (None, Some(_)) => {
                ("friction_over_temperature", "`friction_over_temperature` needs a `temperature` over time")
            }
            _ => return Ok(()),
        };
        Err(AssemblyProblem::Refused { reason: reason.to_owned() }.at(section.place_of(&[key])))
    }

    /// Finds files and structures, those of a case; `section` is that of the analysis.
    pub(in crate::assembly::march) fn found(
        &mut self,
        section: &Section<'_>,
        case: &AssemblyCase,
    ) -> Result<(), Fault> {
        let folder = case.folder();
        let mut tables = Vec::new();
        if let (Some(course), Some(inner)) = (&mut self.course, section.inner("course")?) {
            let factors = [
                ("speed", &mut course.speed),
                ("load", &mut course.load),
                ("friction", &mut course.friction),
            ];
            for (key, factor) in factors {
                let file = factor.as_mut().and_then(FactorSettings::file_mut);
                tables.push(find(file, &inner, key, folder));
            }
        }
        let temperature = self.temperature.as_mut().and_then(TemperatureSettings::file_mut);
        tables.push(find(temperature, section, "temperature", folder));
        let friction = self.friction_over_temperature.as_mut().and_then(FrictionOverTemperature::file_mut);
        tables.push(find(friction, section, "friction_over_temperature", folder));
        let base = self.base.iter_mut().flatten().zip(items(section, "base")?).map(|(own, node)| {
            let item = item(section, "base", node)?;
            match item.inner("acceleration")? {
                Some(inner) => own.acceleration.found(&inner, folder),
                None => Ok(()),
            }
        });
        let base = all(base);
        let forces = self.forces.iter_mut().flatten().zip(items(section, "forces")?).map(|(own, node)| {
            let item = item(section, "forces", node)?;
            let signal = match item.inner("force")? {
                Some(inner) => own.force.found(&inner, folder),
                None => Ok(()),
            };
            both(signal, own.nodes.admit(&item, &case.structures)).map(drop)
        });
        both(all(tables), both(base, all(forces))).map(drop)
    }

    /// The files that it names.
    pub(in crate::assembly::march) fn files(&self) -> Vec<&FileReference> {
        let factors = self.course.iter().flat_map(|own| [&own.speed, &own.load, &own.friction]).flatten();
        let factors =
            factors.filter_map(|own| if let FactorSettings::File(file) = own { Some(file) } else { None });
        let temperature = match &self.temperature {
            Some(TemperatureSettings::File(file)) => Some(file),
            _ => None,
        };
        let friction = match &self.friction_over_temperature {
            Some(FrictionOverTemperature::File(file)) => Some(file),
            _ => None,
        };
        let base = self.base.iter().flatten().filter_map(|own| own.acceleration.file());
        let forces = self.forces.iter().flatten().filter_map(|own| own.force.file());
        factors.chain(temperature).chain(friction).chain(base).chain(forces).collect()
    }
}

impl FactorSettings {
    fn file_mut(&mut self) -> Option<&mut FileReference> {
        if let Self::File(file) = self { Some(file) } else { None }
    }
}

impl TemperatureSettings {
    fn file_mut(&mut self) -> Option<&mut FileReference> {
        if let Self::File(file) = self { Some(file) } else { None }
    }
}

impl FrictionOverTemperature {
    fn file_mut(&mut self) -> Option<&mut FileReference> {
        if let Self::File(file) = self { Some(file) } else { None }
    }
}

/// Finds the file of the table under a key, where it has one.
fn find(
    file: Option<&mut FileReference>,
    section: &Section<'_>,
    key: &str,
    folder: &Path,
) -> Result<(), Fault> {
    if let (Some(file), Some(inner)) = (file, section.inner(key)?) {
        *file = read_file_reference(&inner, "file", folder)?;
    }
    Ok(())
}

/// The nodes of a list.
pub(in crate::assembly) fn items<'a>(section: &Section<'a>, key: &str) -> Result<&'a [Node], Fault> {
    section.get(key).map_or(Ok(&[]), |node| list(&section.path(key), node))
}

/// One of them as a section.
pub(in crate::assembly) fn item<'a>(
    section: &Section<'_>,
    key: &str,
    node: &'a Node,
) -> Result<Section<'a>, Fault> {
    let path = section.path(key);
    Section::of_table(node, &path, &format!("an entry of `{path}`"))
}
