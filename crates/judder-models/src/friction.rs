//! The friction coefficient of a case, of every model that has one: a number, one that falls and rises with the speed, a table in the case
//! or in a file.

use crate::number_columns::ColumnFile;
use crate::written_column::WrittenColumn;
use judder_contact::friction::{FallingFriction, Friction, FrictionError, TableInterpolation};
use judder_keys::Settings;
use judder_keys::declared::{Allowed, Number, Scaled, Setting, Settings, Several};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::file_reference::FileReference;
use judder_keys::numeric_key::{Form, Range, Value};
use judder_keys::problem::{Placed, Problem};
use judder_keys::section::Section;
use serde_json::Value as Json;
use std::path::Path;
use thiserror::Error;

/// The friction coefficient against the speed of sliding.
#[derive(Debug, Clone, PartialEq)]
pub enum FrictionSettings {
    /// μ, whatever the speed.
    Constant(f64),
    /// One that falls from rest, and may rise again.
    Falling(FallingFriction),
    /// A table against the speed.
    Table(FrictionCurve<false>),
}

/// A friction coefficient of one's own against the speed.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "`{path}`")]
pub struct FrictionCurve<const HAS_GROUPS: bool> {
    /// Speeds and coefficients.
    #[key(flatten)]
    pub columns: FrictionColumns<HAS_GROUPS>,
    /// How the coefficient runs between the speeds; it is constant beyond them.
    #[key(default = TableInterpolation::Linear)]
    pub interpolation: TableInterpolation,
}

/// The columns of a table of friction; its speeds are groups of a model without units, or have units.
#[derive(Debug, Clone, PartialEq, Settings)]
pub enum FrictionColumns<const HAS_GROUPS: bool> {
    /// Lists.
    Lists {
        /// Speeds of sliding, ascending.
        #[key(rule = Several { of: speed(HAS_GROUPS), length: [1, usize::MAX] }, symbol = "v")]
        velocity: Vec<Value>,
        /// Friction coefficients there.
        #[key(rule = COEFFICIENTS, symbol = "μ(v)")]
        coefficient: Vec<f64>,
    },
    /// A table in a file in place of velocity and coefficient, with a header such as `speed [m/s],coefficient`; of a model without units `speed,coefficient`.
    File(ColumnFile),
}

const COEFFICIENT: Number = Number::non_negative(Dimension::NUMBER);
const COEFFICIENTS: Several<Number> = Several { of: COEFFICIENT, length: [1, usize::MAX] };

const fn speed(has_groups: bool) -> Scaled {
    let group = if has_groups { Some("v") } else { None };
    Scaled { dimension: Dimension::SPEED, group, range: Range::NonNegative, is_difference: false }
}

/// Numbers that make no friction coefficient.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(transparent)]
struct FrictionProblem(FrictionError);

impl Problem for FrictionProblem {
    fn kind(&self) -> &'static str {
        "Friction"
    }

    fn label(&self) -> &'static str {
        match self.0 {
            FrictionError::Coefficient { .. }
            | FrictionError::Number { .. }
            | FrictionError::Speeds { .. } => "out of range",
            FrictionError::Columns { .. } => "of another length",
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self.0 {
            FrictionError::Coefficient { .. }
            | FrictionError::Number { .. }
            | FrictionError::Speeds { .. } => return None,
            FrictionError::Columns { .. } => {
                "as in { velocity = [\"0 mm/s\", \"10 mm/s\"], coefficient = [0.4, 0.3] }, as many of one as of the other"
            }
        };
        Some(help.to_owned())
    }
}

impl<const HAS_GROUPS: bool> FrictionCurve<HAS_GROUPS> {
    /// The friction coefficient.
    ///
    /// # Errors
    /// [`FrictionError`] for columns that make none.
    pub fn friction(&self) -> Result<Friction, FrictionError> {
        let (speeds, coefficients) = self.columns();
        Friction::table(speeds, coefficients, self.interpolation)
    }

    /// The friction coefficient over speeds in units of this one.
    ///
    /// # Errors
    /// [`FrictionError`] for columns that make none.
    pub(crate) fn friction_by(&self, unit: f64) -> Result<Friction, FrictionError> {
        let (speeds, coefficients) = self.columns();
        let speeds = speeds.into_iter().map(|speed| speed / unit).collect();
        Friction::table(speeds, coefficients, self.interpolation)
    }

    /// Whether its speeds are plain numbers or in SI units; `None` where they are mixed.
    pub(crate) fn speed_form(&self) -> Option<Form> {
        match &self.columns {
            FrictionColumns::Lists { velocity, .. } => {
                let first = velocity.first().map_or(Form::Group, |speed| speed.form);
                velocity.iter().all(|speed| speed.form == first).then_some(first)
            }
            FrictionColumns::File(own) => Some(own.forms[0]),
        }
    }

    /// Speeds and coefficients.
    fn columns(&self) -> (Vec<f64>, Vec<f64>) {
        match &self.columns {
            FrictionColumns::Lists { velocity, coefficient } => {
                (velocity.iter().map(|speed| speed.number).collect(), coefficient.clone())
            }
            FrictionColumns::File(ColumnFile { columns: [speeds, coefficients], .. }) => {
                (speeds.clone(), coefficients.clone())
            }
        }
    }

    /// Finds its file, which is relative to a folder, and refuses columns that make no coefficient; `section` is that of the curve.
    pub(crate) fn admit(&mut self, section: &Section<'_>, folder: &Path) -> Result<(), Fault> {
        if let FrictionColumns::File(own) = &mut self.columns {
            let header = if HAS_GROUPS {
                "speed,coefficient` or `speed [m/s],coefficient"
            } else {
                "speed [m/s],coefficient"
            };
            own.find(
                section,
                "file",
                folder,
                ([speed(HAS_GROUPS), Number::any(Dimension::NUMBER).scaled()], header),
            )?;
        }
        let (speeds, _) = self.columns();
        let what = "the speeds of the table of friction";
        let column = match &self.columns {
            FrictionColumns::Lists { .. } => WrittenColumn::of_list(section, "velocity", what, &speeds),
            FrictionColumns::File(own) => WrittenColumn::of_file(section, own, 0, what),
        };
        column.check_not_negative()?;
        column.check_ascending()?;
        let refused = |error: FrictionError| {
            let key = match error {
                FrictionError::Coefficient { .. } | FrictionError::Columns { .. } => "coefficient",
                FrictionError::Speeds { .. } | FrictionError::Number { .. } => "velocity",
            };
            FrictionProblem(error).at(section.place_of(&[key, "file"]))
        };
        self.friction().map(drop).map_err(refused)
    }

    pub(crate) fn file(&self) -> Option<&FileReference> {
        match &self.columns {
            FrictionColumns::Lists { .. } => None,
            FrictionColumns::File(own) => Some(&own.file),
        }
    }
}

impl FrictionSettings {
    /// The friction coefficient.
    ///
    /// # Errors
    /// [`FrictionError`] for numbers that make none.
    pub fn friction(&self) -> Result<Friction, FrictionError> {
        match self {
            Self::Constant(coefficient) => Ok(Friction::Constant(*coefficient)),
            Self::Falling(falling) => Ok(Friction::Falling(*falling)),
            Self::Table(curve) => curve.friction(),
        }
    }

    /// Finds its file, which is relative to a folder, and refuses numbers that make no coefficient; it stands under `key` of `section`.
    pub(crate) fn admit(&mut self, section: &Section<'_>, key: &str, folder: &Path) -> Result<(), Fault> {
        match self {
            Self::Table(curve) => section.inner(key)?.map_or(Ok(()), |own| curve.admit(&own, folder)),
            Self::Constant(_) | Self::Falling(_) => {
                let refused = |error| FrictionProblem(error).at(section.place_of(&[key]));
                self.friction().and_then(|own| own.check()).map_err(refused)
            }
        }
    }

    pub(crate) fn file(&self) -> Option<&FileReference> {
        match self {
            Self::Table(curve) => curve.file(),
            Self::Constant(_) | Self::Falling(_) => None,
        }
    }
}

/// A number, or a table against the speed.
impl Setting for FrictionSettings {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let forms = [FallingFriction::form(&()), FrictionCurve::<false>::form(&())];
        Allowed::Either([f64::form(&COEFFICIENT)].into_iter().chain(forms).collect())
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let Data::Table(table) = &node.data else {
            return f64::read(section, key, node, &COEFFICIENT).map(Self::Constant);
        };
        let own = FallingFriction::keys();
        match table.entries.iter().any(|entry| own.contains(&entry.key.as_str())) {
            true => FallingFriction::read(section, key, node, &()).map(Self::Falling),
            false => FrictionCurve::read(section, key, node, &()).map(Self::Table),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Constant(coefficient) => coefficient.write(&COEFFICIENT),
            Self::Falling(falling) => Setting::write(falling, &()),
            Self::Table(curve) => Setting::write(curve, &()),
        }
    }
}
