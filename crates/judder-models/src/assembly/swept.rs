//! Steady sliding and small motions about it at any values of keys.

use super::AssemblySubject;
use super::build::{BuiltAssembly, SphereState, SubstrateSphere};
use super::case::contact::ContactForceSettings;
use super::eigen::{BAND, band};
use crate::error::ModelError;
use crate::key_sweep::{KeySweep, KeySweepProblem, SweptSections};
use crate::structure::solved_size::complex_mode_settings;
use faer::{Mat, MatRef};
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_assembly::steady::{SteadySliding, pieces, steady_sliding};
use judder_keys::Settings;
use judder_nonsmooth::course::{Course, TimeFactor};
use judder_numerics::complex::ElementaryComplex;
use judder_structure::asked_region::AskedRegion;
use judder_structure::complex_modes::{ComplexMode, ComplexModeSettings, Eigenvalue, Region, complex_modes};
use judder_structure::eigen_sweep::{ProblemFamily, ProjectedProblem, SolvedPoint};
use judder_structure::quadratic::Quadratic;
use judder_study::Silent;
use std::sync::Arc;

/// Where complex modes are sought.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub enum SoughtRegion {
    /// Between two frequencies, those that grow or decay by less than half a radian a radian.
    #[key(rule = BAND, symbol = "ω", example = "[\"1 kHz\", \"10 kHz\"], or region = { frequency = […], damping_ratio = […] }")]
    Band([f64; 2]),
    /// Which eigenvalues λ = re + i im are asked for, in place of band: those of a rectangle, or of frequencies with damping ratios.
    #[key(
        example = "{ frequency = [\"0 Hz\", \"8 kHz\"], damping_ratio = [-0.1, 0.1] }, or { re = […], im = […] } in 1/s and rad/s"
    )]
    Region(AskedRegion),
}

impl SoughtRegion {
    pub(super) fn region(self) -> AskedRegion {
        match self {
            Self::Region(region) => region,
            Self::Band([from, to]) => AskedRegion::from(band(from, to)),
        }
    }
}

/// What can be swept.
pub(super) const SWEPT: SweptSections = SweptSections {
    names: &["parameters", "structure", "contact", "spring", "load", "substrate"],
    advice: "sweep a number of a structure, a contact, a spring, a load or the parameters: contact.NAME.friction_coefficient, \
        structure.NAME.material.youngs_modulus, parameters.NAME",
    example: "contact.NAME.friction_coefficient",
};

/// In place of a key: what the friction of all contacts is multiplied by.
pub(super) const ALL_FRICTION: &str = "friction";

/// An assembly with the friction of all contacts multiplied.
fn with_friction(assembly: &Assembly, factor: f64) -> Assembly {
    let [speed, load] = [TimeFactor::Constant(1.0), TimeFactor::Constant(1.0)];
    Course { speed, load, friction: vec![TimeFactor::Constant(factor)] }.first(assembly)
}

/// An assembly some of whose keys take any value.
#[derive(Clone)]
pub(super) struct SweptAssembly<'a> {
    of: &'a AssemblySubject<'a>,
    keys: Vec<&'a KeySweep>,
    terms: LinearisedTerms,
    /// That of the case as it is; `None` where it has none.
    compliance: Option<Arc<Compliance>>,
    /// What all its searches of complex modes may take together.
    pub(super) searching: ComplexModeSettings,
    /// Whether every point is held closed whatever its force.
    is_held: bool,
    /// The case with whole bodies, where these are meant.
    whole: Option<Arc<BuiltAssembly>>,
}

fn is_factor(key: &KeySweep) -> bool {
    key.path == ALL_FRICTION
}

/// Steady sliding at values of the keys.
pub(super) struct SlidingState {
    values: Vec<f64>,
    /// The assembly, where it shares its bodies with the case; that of other keys would fill the memory.
    built: Option<BuiltAssembly>,
    pub(super) steady: SteadySliding,
    /// Which points are closed and rigid, and so take a freedom from small motions.
    pub(super) held: Vec<bool>,
    /// On which pieces of their laws the points are.
    pub(super) pieces: Vec<usize>,
    /// What is to be said of it.
    pub(super) doubts: Vec<String>,
    /// The spheres that touch.
    spheres: Vec<(Arc<SubstrateSphere>, SphereState)>,
}

impl SlidingState {
    /// How many points are closed.
    pub(super) fn closed_points(&self) -> usize {
        self.steady.points.iter().filter(|point| point.is_closed).count()
    }

    /// Whether a mode is too fast for the law of a sphere.
    pub(super) fn is_beyond_laws(&self, eigenvalue: &Eigenvalue) -> bool {
        let frequency = eigenvalue.value.modulus();
        let conditions = self.spheres.iter().filter_map(|(sphere, state)| sphere.condition(state, frequency));
        conditions.into_iter().any(|condition| condition.is_broken())
    }
}

impl<'a> SweptAssembly<'a> {
    /// With the dampings of structures and friction, or without.
    pub(super) fn new(of: &'a AssemblySubject<'a>, keys: Vec<&'a KeySweep>, damping: bool) -> Self {
        Self {
            of,
            keys,
            terms: LinearisedTerms { damping, friction_damping: damping },
            compliance: of.compliance().ok().map(Arc::new),
            searching: complex_mode_settings(of.built.assembly.stiffness.val().len()),
            is_held: false,
            whole: None,
        }
    }

    /// The same with every point held closed.
    pub(super) fn all_closed(&self) -> Self {
        Self { is_held: true, ..self.clone() }
    }

    /// The same of whole bodies.
    pub(super) fn whole(&self) -> Result<Self, ModelError> {
        let built = BuiltAssembly::new(&self.of.case.clone().whole())?;
        let compliance = Compliance::new(&built.assembly).ok().map(Arc::new);
        Ok(Self { whole: Some(Arc::new(built)), compliance, ..self.clone() })
    }

    /// The assembly with the case's own values.
    fn own(&self) -> &BuiltAssembly {
        self.whole.as_deref().unwrap_or(self.of.built)
    }

    /// The case with other bodies.
    pub(super) fn subject<'b>(&'b self, built: &'b BuiltAssembly) -> AssemblySubject<'b> {
        AssemblySubject { built, ..*self.of }
    }

    /// The bodies at values of the keys.
    pub(super) fn built(&self, values: &[f64]) -> Result<BuiltAssembly, ModelError> {
        let refused = |problem: KeySweepProblem| ModelError::Unsupported(problem.to_string());
        let (factors, swept): (Vec<_>, Vec<_>) =
            self.keys.iter().copied().zip(values.iter().copied()).partition(|(key, _)| is_factor(key));
        let mut case = self.of.case.at(&swept).map_err(refused)?;
        for contact in &mut case.contacts {
            if let ContactForceSettings::Coulomb { all_closed, .. } = &mut contact.forces {
                *all_closed |= self.is_held;
            }
        }
        let case = if self.whole.is_some() { case.whole() } else { case };
        let mut built = self.own().swept(&case, swept.iter().map(|(key, _)| key.path.as_str()))?;
        for (_, factor) in factors {
            built.assembly = with_friction(&built.assembly, factor);
        }
        built.find_laws(&Silent)?;
        Ok(built)
    }

    /// The assembly at values of the keys.
    pub(super) fn assembly(&self, values: &[f64]) -> Result<Assembly, ModelError> {
        // no case is read anew for a factor
        if let ([key], [factor], false) = (self.keys.as_slice(), values, self.is_held)
            && is_factor(key)
        {
            return Ok(with_friction(&self.own().assembly, *factor));
        }
        Ok(self.built(values)?.assembly)
    }

    /// Steady sliding at values of the keys.
    pub(super) fn state(&self, values: &[f64]) -> Result<SlidingState, ModelError> {
        let built = self.built(values)?;
        if built.assembly.interfaces.is_empty() {
            let steady = SteadySliding::untouched(built.assembly.size());
            let (values, held, pieces) = (values.to_vec(), Vec::new(), Vec::new());
            let (doubts, spheres) = (Vec::new(), Vec::new());
            return Ok(SlidingState { values, built: None, steady, held, pieces, doubts, spheres });
        }
        let told = |error| built.told(error);
        let steady = match &self.compliance {
            Some(known) if known.is_of(&built.assembly)? => steady_sliding(&built.assembly, known),
            _ => Compliance::new(&built.assembly).and_then(|own| steady_sliding(&built.assembly, &own)),
        };
        let steady = steady.map_err(told)?;
        let doubts = AssemblySubject { built: &built, ..*self.of }.doubts(&steady);
        let spheres = built.sliding_spheres(&steady);
        let spheres = spheres.map(|(_, sphere, state)| (Arc::clone(sphere), state)).collect();
        let is_rigid =
            |interface: usize| matches!(built.assembly.interfaces[interface].law, InterfaceLaw::Rigid(_));
        let held = steady.points.iter().map(|point| point.is_closed && is_rigid(point.interface)).collect();
        let pieces = pieces(&built.assembly, &steady)?;
        let built = self.own().shares_bodies(&built).then_some(built);
        Ok(SlidingState { values: values.to_vec(), built, steady, held, pieces, doubts, spheres })
    }

    /// Small motions about a state.
    pub(super) fn about(&self, state: &SlidingState) -> Result<Linearised, ModelError> {
        match &state.built {
            Some(built) => Ok(Linearised::new(&built.assembly, &state.steady, self.terms)?),
            None => Ok(Linearised::new(&self.built(&state.values)?.assembly, &state.steady, self.terms)?),
        }
    }

    /// The modes of a state in a region.
    pub(super) fn solved_alone(
        &self,
        state: &SlidingState,
        region: &Region,
    ) -> Result<SolvedPoint, ModelError> {
        let found = complex_modes(&self.about(state)?.problem, region, &self.searching)?;
        Ok(SolvedPoint { modes: found.modes, gaps: found.gaps, full: true })
    }

    /// Modes of a state with their vectors on all freedoms, for those of other closed points to be compared with.
    pub(super) fn expanded(
        &self,
        state: &SlidingState,
        solved: SolvedPoint,
    ) -> Result<SolvedPoint, ModelError> {
        let about = self.about(state)?;
        let on_all = |mode: ComplexMode| ComplexMode {
            right: about.expanded(&mode.right),
            left: about.expanded_left(&mode.left),
            ..mode
        };
        Ok(SolvedPoint { modes: solved.modes.into_iter().map(on_all).collect(), ..solved })
    }
}

/// States with the same held points, whose problems are of one size.
impl ProblemFamily for SweptAssembly<'_> {
    type Point = SlidingState;
    type OnBasis = ProjectedProblem;
    type Error = ModelError;

    fn at(&self, state: &SlidingState) -> Result<Quadratic, ModelError> {
        Ok(self.about(state)?.problem)
    }

    fn coordinates(&self, state: &SlidingState) -> Vec<f64> {
        state.values.clone()
    }

    fn on_basis(&self, basis: MatRef<'_, f64>, sample: &Quadratic) -> ProjectedProblem {
        ProjectedProblem::new(sample, basis)
    }

    fn projected(
        &self,
        prepared: &ProjectedProblem,
        basis: MatRef<'_, f64>,
        _: &SlidingState,
        problem: &Quadratic,
    ) -> [Mat<f64>; 3] {
        prepared.other(problem, basis)
    }
}

impl SweptAssembly<'_> {
    /// What is to be said of steady sliding at the first few states, and at how many more.
    pub(super) fn doubts<'s>(&self, states: impl Iterator<Item = &'s SlidingState>) -> Vec<String> {
        const TOLD: usize = 3;
        let doubted = |state: &SlidingState| -> Vec<String> {
            let words = self.keys.iter().zip(&state.values);
            let words = words.map(|(key, value)| format!("{} = {}", key.path, key.text(*value)));
            let with = words.collect::<Vec<_>>().join(", ");
            state.doubts.iter().map(|doubt| format!("{with}: {doubt}")).collect()
        };
        let all: Vec<Vec<String>> = states.map(doubted).filter(|doubts| !doubts.is_empty()).collect();
        let more = all.len().saturating_sub(TOLD);
        let rest = (more > 0).then(|| format!("of {more} more values there is something to be said as well"));
        all.into_iter().take(TOLD).flatten().chain(rest).collect()
    }
}

/// That modes are too fast for the law of a sphere, so many of all; `None` where none is.
pub(super) fn beyond_laws(broken: usize, all: usize, what: &str) -> Option<String> {
    (broken > 0).then(|| {
        format!(
            "eq. (3) of the oscillator paper, the condition of steady-sliding laws in motion, is broken at {broken} of {all} {what}: ω τ ≪ 1 is asked, and what \
             such modes do is that of the law alone; `eigen` tells which they are"
        )
    })
}
