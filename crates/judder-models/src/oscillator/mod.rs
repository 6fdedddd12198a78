//! A sphere on a viscoelastic substrate, with two degrees of freedom.
//!
//! - [`point`], [`key_plane`]: one operating point; those over two keys.
//! - [`quasi_steady`]: eq. (3), on which laws of steady sliding stand in motion.
//! - `operating_points`: those of a sweep.
//! - `steady_states`, `law_errors`, `margins`: what the analyses have in common.
//! - `curves`: the figures of curves over one key.
//! - `check`: what `judder check` shows.
//! - A folder each: `equivalent_damping`, `spectrum`, `critical`, `stability_map`, `engines`; those of motion in `motion`.

pub mod case;
pub(crate) mod check;
pub mod contact_case;
pub mod critical;
pub mod curves;
pub mod engines;
pub mod equivalent_damping;
pub mod inputs;
pub mod key_plane;
pub mod keys;
mod law_errors;
pub mod law_name;
pub(crate) mod margins;
pub(crate) mod operating_points;
pub mod point;
pub mod problem;
pub mod quasi_steady;
pub mod settings;
pub mod spectrum;
pub mod stability_map;
pub(crate) mod steady_states;

pub use stability_map::{BoundaryCurves, BoundaryKind, STANDINGS, boundary_curves};

use crate::bridge::{self, CaseContact};
use crate::computed_law::KnownPoints;
use crate::error::ModelError;
use crate::estimate::{Estimate, cost};
use crate::known_substrate::KnownSubstrate;
use crate::labels;
use crate::material;
use crate::motion::counted::CountedMotions;
use crate::motion::model::OscillatorModel;
use crate::motion::settings::MotionKinds;
use crate::motion::{MotionAnalysis, MotionCase, MotionOf, tables as motion_tables};
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::case::{OscillatorCase, OscillatorSections};
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use crate::oscillator::settings::SoughtThresholds;
use crate::sweep::{Family, Sweep};
use crate::swept_keys::SweptKeys;
use crate::swept_tables::key_head;
use judder_contact::law::sweep::SolvedLawPoint;
use judder_keys::declared::Settings;
use judder_keys::file_reference::FileReference;
use judder_keys::keys::{Keys, lines};
use judder_oscillator::Contact;
use judder_store::{Declared, Results};
use judder_study::Progress;
use judder_study::StudyError;
use judder_study::case::analysis::{Kinds, Planned};
use judder_study::case::study_sweep::{StudySweep, SweptKey};
use judder_study::case::text::CaseText;
use judder_study::labels::{SweptQuantity, any_key};
use judder_study::model::{
    Analysed, Analysis, Case, Model, OperatingPoints, OperatingQuantity, OperatingWork, Prepared, Task, admit,
};
use judder_study::outcome::Outcome;
use judder_study::registry::{KindTables, ModelKind, Template};
use judder_study::resolve::Resolved;
use operating_points::OfOneLaw;
use quasi_steady::{QuasiSteadyCondition, ToldCondition, of_motions};
use serde_json::Value;
use std::sync::Arc;

/// The kinds of analyses.
pub(crate) static KINDS: Kinds<OscillatorKeys, Arc<dyn Operated>> = Kinds::new(&[
    equivalent_damping::KIND,
    spectrum::KIND,
    critical::OF_SHEAR_STRENGTH,
    critical::OF_LOAD,
    stability_map::KIND,
    MotionKinds::HISTORY,
    MotionKinds::LIMIT_CYCLE,
    MotionKinds::BIFURCATION,
    MotionKinds::BASIN,
    engines::KIND,
]);

/// An analysis of operating points.
pub trait Operated: Analysis<OscillatorCase> {
    /// Those at the ends of all that it varies.
    fn corners(&self, inputs: &OscillatorInputs) -> Vec<OscillatorInputs> {
        vec![*inputs]
    }
}

/// These operating points at both ends of a swept key.
fn ends(sweep: &Sweep<OscillatorKey>, points: Vec<OscillatorInputs>) -> Vec<OscillatorInputs> {
    let at = |inputs: &OscillatorInputs, value: f64| {
        let mut inputs = *inputs;
        sweep.set(&mut inputs, value);
        inputs
    };
    points.iter().flat_map(|inputs| [at(inputs, sweep.from), at(inputs, sweep.to)]).collect()
}

/// The operating points at both ends of a swept key, for each value of a family.
fn ends_of_curves(
    inputs: &OscillatorInputs,
    sweep: &Sweep<OscillatorKey>,
    family: Option<&Family<OscillatorKey>>,
) -> Vec<OscillatorInputs> {
    let members = family.map_or(vec![*inputs], |family| {
        let member = |value: &f64| {
            let mut inputs = *inputs;
            family.set(&mut inputs, *value);
            inputs
        };
        family.values.iter().map(member).collect()
    });
    ends(sweep, members)
}

/// How many points curves over one key have.
fn points_of_curves(sweep: &Sweep<OscillatorKey>, family: Option<&Family<OscillatorKey>>) -> usize {
    sweep.points * family.map_or(1, |family| family.values.len())
}

/// An oscillator in its contact.
pub struct OscillatorSubject<'a> {
    /// The name of the analysis.
    name: &'a str,
    case: &'a OscillatorCase,
    contact: &'a Contact,
}

/// An oscillator before its law is computed.
pub struct KnownOscillator<'a> {
    /// The name of the analysis.
    pub(crate) name: &'a str,
    pub(crate) case: &'a OscillatorCase,
    /// `None` of a law that would have to be computed first.
    pub(crate) contact: Option<&'a Contact>,
}

impl Analysed for OscillatorCase {
    const NAME: &'static str = MODEL.name;
    const OPERATING_QUANTITIES: &'static [OperatingQuantity] = MODEL.operating_quantities;

    type Asked = dyn Operated;
    type Subject<'a> = OscillatorSubject<'a>;
    type Known<'a> = KnownOscillator<'a>;
    type Estimate = Estimate;
    type Error = ModelError;

    fn analyses(&self) -> &[Planned<Arc<Self::Asked>>] {
        &self.analyses
    }

    fn common_summary_keys(&self) -> Vec<Declared> {
        Option::<ToldCondition>::declared()
    }
}

/// What stands at the head of works.
const ENERGY: &str = "over $k_{x}$ $x_{0}$² (−)";

/// The model.
pub const MODEL: ModelKind = ModelKind {
    name: "oscillator",
    read: |root, folder| case::read(root, folder).map(Case::new),
    doc: "the oscillator of the oscillator paper",
    declared: OscillatorSections::declarations,
    swept: OscillatorKey::paths,
    prose: include_str!("reference.md"),
    template: Template {
        name: "oscillator",
        text: include_str!("template.toml"),
        lines: |section| lines(section, |key: OscillatorKey| OscillatorInputs::default().number(key)),
    },
    kinds: || KINDS.entries(),
    operating_quantities: &operating_points::QUANTITIES,
    tables: &[
        KindTables::new(equivalent_damping::KIND.name, equivalent_damping::tables::report),
        KindTables::new(spectrum::KIND.name, |told| {
            let swept = key_head::<OscillatorKey>(&told.asked["sweep"]);
            spectrum::tables::unstable_ranges(told, &swept, &spectrum::LABELS)
        }),
        KindTables::new(critical::OF_SHEAR_STRENGTH.name, |told| {
            critical::tables::report(SoughtThresholds::ShearStrength, told)
        }),
        KindTables::new(critical::OF_LOAD.name, |told| {
            critical::tables::report(SoughtThresholds::Load, told)
        }),
        KindTables::new(stability_map::KIND.name, |told| {
            stability_map::tables::report(told, spectrum::LABELS.frequency)
        }),
        KindTables::new(MotionKinds::<OscillatorKeys>::HISTORY.name, |told| {
            motion_tables::motion(told, ENERGY)
        }),
        KindTables::new(MotionKinds::<OscillatorKeys>::LIMIT_CYCLE.name, |told| {
            motion_tables::motion(told, ENERGY)
        }),
        KindTables::new(MotionKinds::<OscillatorKeys>::BIFURCATION.name, |told| {
            motion_tables::diagram(told, &key_head::<OscillatorKey>(&told.asked["sweep"]))
        }),
        KindTables::new(MotionKinds::<OscillatorKeys>::BASIN.name, motion_tables::fates),
    ],
};

impl Model for OscillatorCase {
    fn files(&self) -> Vec<&FileReference> {
        OscillatorCase::files(self)
    }

    fn resolved(&self) -> serde_json::Value {
        OscillatorCase::resolved(self)
    }

    fn with_used(&self, resolved: serde_json::Value) -> Result<serde_json::Value, StudyError> {
        Ok(material::with_used(&self.substrate, &self.inputs, resolved)?)
    }

    fn is_one_quantity(&self, first: &str, second: &str) -> bool {
        let keys = (OscillatorKey::from_path(first), OscillatorKey::from_path(second));
        matches!(keys, (Some(first), Some(second)) if OscillatorKeys::of(self).same(first, second))
    }

    fn is_set_by(&self, keys: &[SweptKey], tried: &[Case]) -> bool {
        operating_points::is_set_by(self, keys, tried)
    }

    fn swept_label(&self, key: &SweptKey) -> SweptQuantity {
        let Some((own, form)) = operating_points::key_of(self, key) else {
            return any_key(&key.path, key.dimension);
        };
        SweptQuantity { name: key.path.clone(), ..labels::key(own, form) }
    }

    /// Looks at the data of the substrate, then at the memory of what is wanted.
    fn preflight(&self, file: &CaseText, is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        admit(self, file, is_wanted, |name| KnownOscillator { name, case: self, contact: None })?;
        bridge::known_contact(&bridge::with_material(self)?)?;
        Ok(Prepared::NOTHING)
    }

    /// The law of the case is the same at all points, and was read for the first.
    fn preflight_at(
        &self,
        file: &CaseText,
        is_wanted: &dyn Fn(&str) -> bool,
        _: &Prepared,
        _: &[&str],
    ) -> Result<Prepared, StudyError> {
        admit(self, file, is_wanted, |name| KnownOscillator { name, case: self, contact: None })?;
        bridge::with_material(self)?;
        Ok(Prepared::NOTHING)
    }

    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError> {
        let case = &bridge::with_material(self)?;
        let (law, points) = (task.shared, task.shared.known());
        let keep = |point: &SolvedLawPoint| law.add(point);
        let CaseContact { contact, warnings } =
            bridge::contact(case, KnownPoints { known: &points, kept: &keep }, task.progress)?;
        let Planned { name, kind: own, .. } = &case.analyses[index];
        let mut outcome = own.run(&OscillatorSubject { name, case, contact: &contact }, task)?;
        outcome.warnings.extend(warnings);
        let (corners, substrate) = (own.corners(&case.inputs), KnownSubstrate::of(case)?);
        outcome.warnings.extend(substrate.band_warning(&contact, corners.iter().copied()));
        outcome.warnings.extend(substrate.temperature_warning);
        if let Some(condition) =
            QuasiSteadyCondition::worst(corners.into_iter(), Some(&contact), &substrate.terms)
        {
            outcome.warnings.extend(condition.warning(of_motions(&outcome.scalars)));
            outcome.scalars.extend(condition.told().scalars());
        }
        Ok(outcome)
    }

    fn resolve(&self, file: &CaseText, resolved: Value) -> Result<Resolved, StudyError> {
        Ok(check::resolve(file, &bridge::with_material(self)?, resolved)?)
    }

    fn operating_points(
        &self,
        sweep: &StudySweep,
        progress: &dyn Progress,
    ) -> Result<Option<Box<dyn OperatingPoints>>, StudyError> {
        let points = OfOneLaw::new(self, sweep, progress)?;
        Ok(points.map(|points| Box::new(points) as Box<dyn OperatingPoints>))
    }

    fn operating_point(
        &self,
        wanted: &[OperatingQuantity],
        progress: &dyn Progress,
    ) -> Result<(Vec<f64>, Vec<String>), StudyError> {
        Ok(operating_points::of_case(self, wanted, progress)?)
    }

    fn operating_work(&self, sweep: &StudySweep, wanted: &[OperatingQuantity]) -> OperatingWork {
        operating_points::work(self, sweep, wanted)
    }

    fn told_of_sweep(&self, sweep: &StudySweep, at: &dyn Fn(&[f64]) -> Option<Case>) -> Option<String> {
        operating_points::read_anew(sweep, at)
    }

    fn shared(&self, resolved: &Value) -> Option<Vec<Value>> {
        let parts = [&resolved["substrate"], &resolved["files"], &resolved["contact"]["law"]];
        // the law of a paraboloid is that of any radius
        let of_line = self.length.map(|_| &resolved["indenter"]);
        (self.law == LawName::Bem).then(|| parts.into_iter().chain(of_line).cloned().collect())
    }
}

impl MotionCase for OscillatorCase {
    type Keys = OscillatorKeys;

    const STEP: f64 = cost::MOTION_STEP;

    fn name<'a>(known: &'a KnownOscillator<'_>) -> &'a str {
        known.name
    }

    fn second(known: &KnownOscillator<'_>) -> Option<f64> {
        known.case.inputs.si_units().map(|units| units.second)
    }

    fn counted<A: MotionOf<OscillatorKeys>>(
        asked: &A,
        known: &KnownOscillator<'_>,
    ) -> Option<CountedMotions> {
        let &KnownOscillator { name, case, contact } = known;
        asked.probed().counted(&OscillatorModel { name, inputs: &case.inputs, contact: contact? })
    }

    fn follow<A: MotionOf<OscillatorKeys>>(
        asked: &A,
        of: &OscillatorSubject<'_>,
        task: Task<'_>,
    ) -> Result<Outcome, ModelError> {
        asked.run(&OscillatorModel { name: of.name, inputs: &of.case.inputs, contact: of.contact }, task)
    }
}

impl<A: MotionOf<OscillatorKeys>> Operated for MotionAnalysis<A> {
    fn corners(&self, inputs: &OscillatorInputs) -> Vec<OscillatorInputs> {
        match self.0.swept() {
            Some(sweep) => ends(sweep, vec![*inputs]),
            None => vec![*inputs],
        }
    }
}
