//! Whether steady sliding is the only one.
//!
//! With the gaps w of the points, that of a compliant one its pressed part taken off, their equations are
//!
//! M w − Q N = r,   0 ≤ w ⟂ N ≥ 0,   M = I − s S_nn,   Q = S_nn + S_nt μ + M k⁻¹,
//!
//! a linear complementarity problem. Where something else than contacts holds the bodies, A = M⁻¹ Q = c K⁻¹ e + k⁻¹; for every load there is one state exactly if A is
//! a P-matrix, one whose principal minors are all positive (R. W. Cottle, J.-S. Pang, R. E. Stone, *The Linear Complementarity Problem*, 1992, theorem 3.3.7).

mod complementarity;
mod limits;
mod minors;

use crate::AssemblyError;
use crate::assembly::Assembly;
use crate::compliance::Compliance;
use crate::steady::SteadySliding;
use complementarity::{Complementarity, PIVOTED, is_definite};
use minors::{has_positive_minors, is_diagonally_dominant};

pub use limits::{FrictionOnset, FrictionOnsets};

/// Whether other states of steady sliding are there, and with how much friction they come.
#[derive(Debug, Clone, PartialEq)]
pub struct Uniqueness {
    /// Whether there are.
    pub verdict: UniquenessVerdict,
    /// By what the friction coefficients are multiplied where this begins to be lost.
    pub onsets: FrictionOnsets,
}

/// Whether there are other states of steady sliding.
#[derive(Debug, Clone, PartialEq)]
pub enum UniquenessVerdict {
    /// There is one state whatever the loads.
    Unique(UniquenessProof),
    /// There is one state under these loads.
    UniqueForLoads(UniquenessProof),
    /// There are others.
    Several {
        /// How many there are, this one among them.
        states: usize,
        /// The points that another one closes, in the order of all interfaces.
        other: Vec<usize>,
    },
    /// Neither shown.
    NotProved,
}

/// How it was shown that a state is the only one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UniquenessProof {
    /// All principal minors are positive.
    Minors,
    /// The matrix of the problem is positive definite, or semidefinite with a state of which each point either presses or is open.
    Definite,
    /// Diagonal entries outweigh the others, suitably scaled: an H-matrix.
    Dominant,
    /// Every set of closed points was tried.
    AllSets,
}

/// Points that may open up to which all principal minors are computed.
const MINORS: usize = 20;
/// The same up to which all sets of closed points are tried.
const SETS: usize = 12;
/// Up to so many sets times the cube of all points, those that stay closed among them: 12 of 64 points.
const SETS_WORK: usize = 1 << 30;
/// Points up to which dense matrices are looked at.
const LARGEST: usize = 1000;

/// Whether all sets of so many free points are few enough: up to `most` of them, and to `work` with the cubes of all points.
fn are_few(free: usize, points: usize, most: usize, work: usize) -> bool {
    free <= most && points <= LARGEST && points.pow(3) <= work >> free
}

/// Whether a state is the only one, as far as one of the proofs above goes.
///
/// # Errors
/// What [`Assembly::framed`] says.
pub fn uniqueness(
    assembly: &Assembly,
    compliance: &Compliance,
    steady: &SteadySliding,
) -> Result<Uniqueness, AssemblyError> {
    let points = assembly.framed()?;
    if points.len() > LARGEST {
        return Ok(Uniqueness { verdict: UniquenessVerdict::NotProved, onsets: FrictionOnsets::default() });
    }
    let problem = Complementarity::new(assembly, compliance, &points)?;
    let onsets = FrictionOnsets::new(assembly, &points, problem.as_ref(), steady);
    let verdict = problem.map_or(UniquenessVerdict::NotProved, |problem| verdict(&problem, steady));
    Ok(Uniqueness { verdict, onsets })
}

fn verdict(problem: &Complementarity, steady: &SteadySliding) -> UniquenessVerdict {
    let Some(pivoted) = problem.pivoted(steady) else { return UniquenessVerdict::NotProved };
    let free = problem.free().len();
    // that of a matrix and of its pivoted forms are the same (the same, theorem 4.1.3)
    if problem.is_held {
        if free <= MINORS && has_positive_minors(&pivoted.matrix) {
            return UniquenessVerdict::Unique(UniquenessProof::Minors);
        }
        if is_definite(&pivoted.matrix, PIVOTED) {
            return UniquenessVerdict::Unique(UniquenessProof::Definite);
        }
        if is_diagonally_dominant(&pivoted.matrix) {
            return UniquenessVerdict::Unique(UniquenessProof::Dominant);
        }
    }
    // of tables the state does not solve the problem, and sets cannot be tried
    if problem.is_curved {
        return UniquenessVerdict::NotProved;
    }
    if pivoted.is_decided && is_definite(&pivoted.matrix, -PIVOTED) {
        return UniquenessVerdict::UniqueForLoads(UniquenessProof::Definite);
    }
    if !are_few(free, steady.points.len(), SETS, SETS_WORK) {
        return UniquenessVerdict::NotProved;
    }
    let states = problem.states(steady);
    let own: Vec<f64> = steady.points.iter().map(|point| point.normal_force).collect();
    // the state shown must be among them, else neither is right
    let others: Vec<_> = states.iter().filter(|state| !state.has_forces(&own)).collect();
    match others[..] {
        [] if states.len() == 1 => UniquenessVerdict::UniqueForLoads(UniquenessProof::AllSets),
        [other, ..] if others.len() + 1 == states.len() => {
            UniquenessVerdict::Several { states: states.len(), other: other.closed.clone() }
        }
        _ => UniquenessVerdict::NotProved,
    }
}
