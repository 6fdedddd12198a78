//! `frequency-response`: what swings, over which frequencies, and how closely it is followed.

use crate::assembly::AssemblySubject;
use crate::assembly::build::Unassembled;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::SurfaceOf;
use crate::assembly::case::problem::AssemblyProblem;
use crate::assembly::march::driven::settings::{item, items};
use crate::assembly::periodic::admits_periodic;
use crate::error::ModelError;
use judder_cycles::balance::HarmonicForce;
use judder_cycles::forced::{ResponseSettings, StepMeasure};
use judder_cycles::path::PathRule;
use judder_cycles::series::Series;
use judder_keys::Settings;
use judder_keys::declared::{Number, NumberPair, Settings as _, Several, Whole, all};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_structure::freedom::Direction;
use judder_study::model::Refusal;
use num_complex::Complex64;

/// Periodic motions under forces that swing, over their frequency.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = FrequencyResponse::check)]
pub struct FrequencyResponse {
    /// The first and the last frequency, up or down: from the one on the motions are followed through their folds until they leave the range.
    #[key(rule = RANGE, symbol = "ω_1, ω_2", example = "[\"20 Hz\", \"200 Hz\"]")]
    pub frequency: [f64; 2],
    /// Forces that swing with the frequency, beside the loads.
    #[key(rule = SEVERAL, omitted, example = "[{ structure = \"…\", set = \"…\", direction = \"x\", amplitude = \"1 N\" }]")]
    pub forces: Option<Vec<SwingingForce>>,
    /// How the base swings that holds the bodies and rigid planes; displacements are beside it.
    #[key(rule = SEVERAL, omitted, example = "[{ direction = \"y\", amplitude = \"1 m/s^2\" }]")]
    pub base: Option<Vec<SwingingBase>>,
    /// How many harmonics motions and forces have, beside their mean.
    #[key(rule = Whole { from: 1, to: 500 }, symbol = "H", default = 9)]
    pub harmonics: usize,
    /// Instants of a period a harmonic at which points stick, slide or lift off.
    #[key(rule = Whole { from: 4, to: 1024 }, default = 16)]
    pub samples: usize,
    /// The most motions.
    #[key(rule = Whole { from: 2, to: 100_000 }, default = 1000)]
    pub points: usize,
    /// By how much the frequency changes from motion to motion at most; a two hundredth of the range where left out.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), omitted)]
    pub longest_step: Option<f64>,
    /// Whether Floquet multipliers say of each motion if others nearby are drawn to it.
    #[key(default = false)]
    pub stability: bool,
}

/// A force that swings, F cos (ω t + φ).
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub struct SwingingForce {
    /// Where it acts, on all nodes together, which share it alike.
    #[key(flatten)]
    pub nodes: SurfaceOf,
    /// Its direction.
    pub direction: Direction,
    /// Its amplitude.
    #[key(rule = Number::any(Dimension::FORCE), symbol = "F")]
    pub amplitude: f64,
    /// Its phase, of forces beside one another.
    #[key(rule = Number::any(Dimension::ANGLE), symbol = "φ", default = 0.0)]
    pub phase: f64,
}

/// A base that swings with the acceleration a cos (ω t + φ).
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub struct SwingingBase {
    /// The direction in which it swings.
    pub direction: Direction,
    /// The amplitude of its acceleration, at all frequencies.
    #[key(rule = Number::any(Dimension::ACCELERATION), symbol = "a")]
    pub amplitude: f64,
    /// Its phase.
    #[key(rule = Number::any(Dimension::ANGLE), symbol = "φ", default = 0.0)]
    pub phase: f64,
}

const RANGE: NumberPair = NumberPair {
    of: Number::positive(Dimension::ANGULAR_FREQUENCY),
    what: "the first and the last frequency",
    is_ascending: false,
};
const SEVERAL: Several<()> = Several { of: (), length: [1, usize::MAX] };
/// Steps over the range where the case does not say.
const STEPS: f64 = 200.0;
/// Of the largest forces so far: the first, the longest and the shortest step.
const PACE: [f64; 3] = [0.01, 0.05, 1e-8];

impl FrequencyResponse {
    /// Reads a response of a case, whose structures are known where it is.
    pub(super) fn of(case: Option<&AssemblyCase>, section: &Section<'_>) -> Result<Self, Fault> {
        let mut own = Self::read_table(section)?;
        if let Some(case) = case {
            let forces = own.forces.iter_mut().flatten().zip(items(section, "forces")?);
            let found =
                forces.map(|(own, node)| own.nodes.admit(&item(section, "forces", node)?, &case.structures));
            all(found)?;
        }
        Ok(own)
    }

    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let refused =
            |place, reason: &str| Err(AssemblyProblem::Refused { reason: reason.to_owned() }.at(place));
        if self.frequency[0] == self.frequency[1] {
            return refused(
                section.place_of(&["frequency"]),
                "the first and the last frequency are the same: a response goes from one to another",
            );
        }
        let forces = self.forces.iter().flatten().map(|own| own.amplitude);
        let mut amplitudes = forces.chain(self.base.iter().flatten().map(|own| own.amplitude));
        match (&self.forces, &self.base) {
            (None, None) => refused(
                section.place,
                "nothing swings: a response needs `forces` with an amplitude, or the acceleration of a `base`",
            ),
            _ if amplitudes.all(|own| own == 0.0) => {
                let key = if self.forces.is_some() { "forces" } else { "base" };
                refused(section.place_of(&[key]), "nothing swings: no amplitude is other than zero")
            }
            _ => Ok(()),
        }
    }

    /// Refuses what has no response or none to tell of.
    pub(super) fn admitted(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        let refused = |key, reason| Ok(Err(Refusal::key(key, AssemblyProblem::Refused { reason })));
        if let Err(refusal) = of.touches() {
            return Ok(Err(refusal));
        }
        if of.built.watched.is_empty() {
            let reason = "nothing is observed: a response is told of the points of `[observe]`, such as points = [{ name = \"tip\", structure = \"…\", set = \"…\" }]";
            return refused("", reason.to_owned());
        }
        if let Err(Unassembled { path, cause }) = self.force(of) {
            return Ok(Err(Refusal::key(path, *cause)));
        }
        Ok(admits_periodic(of))
    }

    /// What swings, on the freedoms.
    pub(super) fn force(&self, of: &AssemblySubject<'_>) -> Result<HarmonicForce, Unassembled> {
        let mut amplitude = vec![Complex64::ZERO; of.built.assembly.size()];
        let mut add = |unit: Vec<f64>, size: f64, phase: f64| {
            let own = judder_numerics::complex::from_polar(size, phase);
            amplitude.iter_mut().zip(unit).for_each(|(sum, unit)| *sum += own * unit);
        };
        for (k, own) in self.forces.iter().flatten().enumerate() {
            let unit = of.built.unit_force(&own.nodes, own.direction, &format!("forces.{k}"))?;
            add(unit, own.amplitude, own.phase);
        }
        for (k, own) in self.base.iter().flatten().enumerate() {
            let unit = of.built.beside_base(of.case, own.direction, &format!("base.{k}.direction"))?;
            add(unit, own.amplitude, own.phase);
        }
        Ok(HarmonicForce { harmonic: 1, amplitude })
    }

    pub(super) fn series(&self) -> Series {
        Series::new(self.harmonics, self.samples * self.harmonics)
    }

    /// How the response is followed.
    pub(super) fn settings(&self) -> ResponseSettings {
        let [from, to] = self.frequency;
        ResponseSettings {
            rule: PathRule { steps: PACE, ..PathRule::default() },
            between: self.frequency,
            points: self.points,
            pace: StepMeasure::Largest(self.longest_step.unwrap_or((to - from).abs() / STEPS)),
        }
    }
}
