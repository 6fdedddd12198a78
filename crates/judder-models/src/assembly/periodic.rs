//! What has periodic motions that can be computed, and what memory they need.

use super::AssemblySubject;
use super::case::problem::AssemblyProblem;
use super::linear_size::of_motion;
use crate::error::ModelError;
use judder_cycles::cycle::FINER;
use judder_cycles::fold::FOLD_REFINEMENT;
use judder_cycles::receptance::check_size;
use judder_cycles::series::Series;
use judder_cycles::stability::{FLOQUET_STEPS, FLOQUET_WIDER};
use judder_keys::memory::Memory;
use judder_nonsmooth::contact::ContactPoints;
use judder_study::model::{MemoryBound, NeededMemory, Refusal};

/// The most harmonics that are taken where the case gives none.
const MOST: usize = 40;
/// What dense matrices of all unknowns may take then, and how many there were of them when that was decided: as many harmonics on any machine.
const LIMIT: Memory = Memory::DEFAULT;
const MATRICES: usize = 5;
/// Bytes a square of the unknowns: the matrix that Newton's method writes over, and what joins the points. Measured of responses and cycles of 3600 to 5400 unknowns: 7.9 to 10.6.
const SQUARE_BYTES: u128 = 9;
/// Bytes of a point at an instant at which a motion is solved, when it is looked at between them. Measured of 3 to 31 points at 10 000 to 100 000 instants: 1000 to 1600.
const INSTANT_BYTES: u128 = 1300;

/// Refuses contacts whose points travel, and bodies with more freedoms than are taken.
pub(super) fn admits_periodic(of: &AssemblySubject<'_>) -> Result<(), Refusal> {
    let refused = |reason| Err(Refusal::key("", AssemblyProblem::Refused { reason }));
    if let Some(travelling) = of.built.travelling.first() {
        let name = &of.built.assembly.interfaces[travelling.interface].name;
        return refused(format!(
            "the points of the contact `{name}` travel along their track: no motion repeats itself there"
        ));
    }
    check_size(&of.built.assembly).or_else(|error| refused(error.to_string()))
}

/// With what periodic motions are solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct PeriodicSize {
    /// None where as many are taken as a motion asks for.
    pub(super) harmonics: Option<usize>,
    /// Instants of a period a harmonic.
    pub(super) samples: usize,
    /// Whether multipliers are computed.
    pub(super) stability: bool,
    /// Whether folds are found with more harmonics once more.
    pub(super) folds: bool,
}

impl PeriodicSize {
    /// What is held at once at most, of one motion at a time.
    ///
    /// # Errors
    /// What the contact points say.
    pub(super) fn memory(self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        let contact = ContactPoints::new(&of.built.assembly, &[])?;
        let [points, components] = [contact.points.len(), contact.rows.len()];
        let count = self.harmonics.unwrap_or_else(|| most_harmonics(components));
        let (words, bound) = match self.harmonics {
            Some(_) => ("", MemoryBound::About),
            None => ("up to ", MemoryBound::AtMost),
        };
        let (unknowns, samples) = (components * (2 * count + 1), self.samples);
        let what = format!(
            "{words}{count} harmonics of {components} components of contact forces are {unknowns} unknowns, at {samples} instants a harmonic"
        );
        let own = NeededMemory {
            beside: self.held(count, points, components),
            bound,
            what: what.into(),
            keys: &["harmonics", "samples"],
            advice: "give fewer `harmonics` or `samples`",
        };
        Ok(of_motion(of, own))
    }

    /// Bytes beside the program.
    fn held(self, harmonics: usize, points: usize, components: usize) -> u128 {
        let instants = self.samples * harmonics;
        let solving = |times: usize| {
            let unknowns = components as u128 * (2 * times as u128 * harmonics as u128 + 1);
            SQUARE_BYTES * unknowns * unknowns + Series::bytes(times * harmonics, times * instants)
        };
        let known = Series::bytes(harmonics, instants);
        let between = known
            + Series::bytes(harmonics, FINER * instants)
            + INSTANT_BYTES * points as u128 * instants as u128;
        let wider = FLOQUET_WIDER * harmonics;
        let stepped = known
            + Series::bytes(wider, FLOQUET_WIDER * instants)
            + Series::bytes(wider, 2 * FLOQUET_STEPS[1]);
        let solved = solving(if self.folds { FOLD_REFINEMENT } else { 1 });
        solved.max(between).max(if self.stability { stepped } else { 0 })
    }
}

/// The most harmonics of so many components that are taken where the case gives none.
pub(super) fn most_harmonics(components: usize) -> usize {
    let unknowns = (LIMIT.bytes as f64 / (8 * MATRICES) as f64).sqrt();
    MOST.min(((unknowns / components.max(1) as f64 - 1.0) / 2.0).floor().max(1.0) as usize)
}

/// Components of all contact points: two each in the plane, three in space.
pub(super) fn components(of: &AssemblySubject<'_>) -> Result<usize, ModelError> {
    Ok(ContactPoints::new(&of.built.assembly, &[])?.rows.len())
}
