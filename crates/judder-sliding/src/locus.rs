//! The locus: complex eigenvalues against contact position, with the zones in which the pair is unstable.
//!
//! J. Brunetti, W. D'Ambrogio, A. Fregolent (2020), figure 2; there undeformed. In the deformed configuration contact row, column and
//! normal are those of the state of rest under the load, and what follows the motion feeds back.

mod branches;

use crate::SlidingError;
use crate::characteristic::PairCharacteristic;
use crate::coupling::{Coupling, SteadyFriction};
use crate::edge::EdgePoint;
use crate::pair::Pair;
use crate::spectrum::{Spectrum, WantedEigenvalues};
use crate::statics::PairEquilibrium;
use crate::zones::{PairFamily, Zone, Zones, zones};
use branches::LocusBranches;
use judder_numerics::parallel;
use num_complex::Complex64;

/// The geometry in which the contact is linear.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "configuration"))]
pub enum Configuration {
    /// As drawn.
    ///
    /// Both structures are as they are without load.
    #[default]
    Undeformed,
    /// Under load and friction of steady sliding.
    Deformed,
}

/// Under what the pair slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditions {
    /// The geometry.
    pub configuration: Configuration,
    /// Whether modes are damped and friction falls with speed; if not, nothing takes or gives energy but the follower force.
    pub is_damped: bool,
    /// Speed along the track, m/s, negative against it.
    pub velocity: f64,
    /// The load on the slider, N.
    pub load: f64,
}

/// What a locus is wanted of.
#[derive(Debug, Clone, PartialEq)]
pub struct LocusSettings {
    /// Under what the pair slides.
    pub conditions: Conditions,
    /// How many eigenvalues at each position, the lowest by the larger of imaginary and absolute real part.
    pub count: usize,
    /// Distances of the contact point, undeformed, from the track's first node, ascending, m.
    pub positions: Vec<f64>,
}

/// Eigenvalues against a parameter, and where the pair is unstable.
#[derive(Debug, Clone, PartialEq)]
pub struct Followed {
    /// For each value of the parameter the `count` lowest eigenvalues s in 1/s, one a branch; NaN where a branch is not among them.
    ///
    /// A branch goes on to the eigenvalue that is nearest to where it would be if it went straight, followed over all samples of the search
    /// for zones and not only those shown. Where two meet (an exceptional point) and part again, which of them goes on as which is not
    /// defined by the pair; here it is what this rule gives. Where one leaves the lowest and another enters, there is a branch more: none
    /// goes on as another.
    pub eigenvalues: Vec<Vec<Complex64>>,
    /// How far each of them may be off, 1/s.
    pub errors: Vec<Vec<f64>>,
    /// Unstable zones of the `count` lowest eigenvalues, from the first value to the last.
    pub zones: Vec<Zone>,
}

/// A locus.
#[derive(Debug, Clone, PartialEq)]
pub struct Locus {
    /// Distances of the contact point, undeformed, from the track's first node, m.
    pub positions: Vec<f64>,
    /// Branches by position, and unstable zones.
    pub followed: Followed,
    /// N of the state of rest at each position, N.
    pub normal_forces: Vec<f64>,
}

/// Zones are searched down to this share of a segment.
const RESOLUTION: f64 = 1e-3;
/// Nodes, where the contact is not smooth, are left out by this share of a segment on both sides.
const ASIDE: f64 = 1e-4;
/// So far before and after a node, as a share of a segment, what the deformation shifts is taken.
const BESIDE: f64 = 0.05;

/// The locus of a pair.
///
/// # Errors
/// [`SlidingError::OffTrack`], [`SlidingError::NoEquilibrium`] and [`SlidingError::NoConvergence`] of the state of rest;
/// [`SlidingError::SpragSlip`]; [`SlidingError::Incomplete`]; [`SlidingError::InvalidNumber`] for positions that do not ascend or a count
/// that the pair does not have.
pub fn locus(pair: &Pair, settings: &LocusSettings) -> Result<Locus, SlidingError> {
    locus_until(pair, settings, &|| false)
}

/// The locus of a pair, unless `interrupted` says to stop: it is asked before each of the many characteristic functions.
///
/// # Errors
/// As of [`locus`]; [`SlidingError::Interrupted`].
pub fn locus_until(
    pair: &Pair,
    settings: &LocusSettings,
    interrupted: &(dyn Fn() -> bool + Sync),
) -> Result<Locus, SlidingError> {
    let LocusSettings { conditions, count, positions } = settings;
    check_ascending(positions)?;
    let (Some(first), Some(last)) = (positions.first(), positions.last()) else {
        let name = "the list of positions".to_owned();
        return Err(SlidingError::Length { name, found: 0, expected: 1 });
    };
    let pieces = smooth_pieces(pair, conditions, [*first, *last])?;
    let segment = pair.node_positions().last().copied().unwrap_or_default() / (pair.edge().nodes - 1) as f64;
    let family = |position: f64| match interrupted() {
        true => Err(SlidingError::Interrupted),
        false => characteristic(pair, conditions, position),
    };
    let followed = follow(&family, positions, &pieces, *count, RESOLUTION * segment)?;
    let force = |position: &f64| Ok::<f64, SlidingError>(contact(pair, conditions, *position)?.1);
    let normal_forces = parallel::try_each(positions, force)?;
    Ok(Locus { positions: positions.clone(), followed, normal_forces })
}

/// All eigenvalues wanted at one position.
///
/// # Errors
/// Those of [`locus`].
pub fn spectrum(
    pair: &Pair,
    conditions: &Conditions,
    position: f64,
    wanted: WantedEigenvalues,
) -> Result<Spectrum, SlidingError> {
    Spectrum::new(&characteristic(pair, conditions, position)?, position, wanted)
}

/// The characteristic function at one position.
///
/// # Errors
/// Those of [`locus`], but for the search of eigenvalues.
pub fn characteristic(
    pair: &Pair,
    conditions: &Conditions,
    position: f64,
) -> Result<PairCharacteristic, SlidingError> {
    let (coupling, _) = contact(pair, conditions, position)?;
    let damping = if conditions.is_damped { pair.damping() } else { vec![0.0; pair.modes()] };
    PairCharacteristic::new(&coupling, &pair.eigenvalues(), &damping)
}

/// The linear coupling at one position, and the normal force of the state of rest.
///
/// # Errors
/// Those of [`locus`], but for the search of eigenvalues.
pub fn contact(pair: &Pair, conditions: &Conditions, position: f64) -> Result<(Coupling, f64), SlidingError> {
    let Conditions { configuration, is_damped, velocity, load } = *conditions;
    let sliding = SteadyFriction::at(pair.friction(), velocity);
    let rest = match configuration {
        Configuration::Undeformed => PairEquilibrium::undeformed(pair, position, load, sliding)?,
        Configuration::Deformed => PairEquilibrium::new(pair, position, load, sliding)?,
    };
    let (touch, force) = (&rest.touch, rest.normal_force);
    let mut coupling = Coupling::new(pair, touch, sliding);
    coupling.check(position, sliding.friction)?;
    if is_damped {
        coupling = coupling.with_falling_friction(pair, touch, sliding, force);
    }
    if configuration == Configuration::Deformed {
        coupling = coupling.with_wandering(pair, touch, sliding, force);
    }
    Ok((coupling, force))
}

/// Eigenvalues and unstable zones of any family of pairs: against friction coefficient, load, an angle.
///
/// `pieces` follow each other and cover the range in which zones are sought; the family is smooth within each. `resolution` is that of
/// [`zones`]; `parameters` ascend.
///
/// # Errors
/// Those of the family; [`SlidingError::Incomplete`]; [`SlidingError::InvalidNumber`] as [`zones`] has it, and for parameters that do not
/// ascend.
pub fn follow(
    family: &dyn PairFamily,
    parameters: &[f64],
    pieces: &[[f64; 2]],
    count: usize,
    resolution: f64,
) -> Result<Followed, SlidingError> {
    check_ascending(parameters)?;
    let shown: Vec<Result<Spectrum, SlidingError>> =
        parallel::each(parameters, |at| family.spectrum(*at, count));
    let Zones { zones, samples } = zones(family, pieces, count, resolution)?;
    let shown = parameters.iter().zip(shown).map(|(at, spectrum)| Ok((*at, spectrum?)));
    let shown = shown.collect::<Result<Vec<_>, SlidingError>>()?;
    let LocusBranches { eigenvalues, errors } = LocusBranches::new(shown, samples, count);
    Ok(Followed { eigenvalues, errors, zones })
}

/// The pieces of a range of positions on which the contact is smooth: between those at which it passes a node.
///
/// # Errors
/// Those of the state of rest.
pub fn smooth_pieces(
    pair: &Pair,
    conditions: &Conditions,
    [from, to]: [f64; 2],
) -> Result<Vec<[f64; 2]>, SlidingError> {
    let nodes = pair.node_positions();
    // at both ends of the range the contact is where the deformation takes it
    let [start, end] = [touched(pair, conditions, from)?, touched(pair, conditions, to)?];
    let segment = nodes.last().copied().unwrap_or_default() / (nodes.len() - 1) as f64;
    let inner: Vec<f64> = nodes.iter().copied().filter(|node| *node > start && *node < end).collect();
    let breaks = parallel::try_each(&inner, |node| match conditions.configuration {
        Configuration::Undeformed => Ok(*node),
        Configuration::Deformed => passes(pair, conditions, *node, segment, [from, to]),
    })?;
    let mut bounds = vec![from];
    bounds.extend(breaks);
    bounds.push(to);
    let aside = ASIDE * segment;
    let last = bounds.len() - 2;
    let inward = |(k, pair): (usize, &[f64])| {
        [pair[0] + if k > 0 { aside } else { 0.0 }, pair[1] - if k < last { aside } else { 0.0 }]
    };
    Ok(bounds.windows(2).enumerate().map(inward).filter(|[from, to]| to > from).collect())
}

/// How far from the first node the contact is on the track, m.
fn touched(pair: &Pair, conditions: &Conditions, position: f64) -> Result<f64, SlidingError> {
    let EdgePoint { segment, fraction } = match conditions.configuration {
        Configuration::Undeformed => return Ok(position),
        Configuration::Deformed => {
            let sliding = SteadyFriction::at(pair.friction(), conditions.velocity);
            PairEquilibrium::new(pair, position, conditions.load, sliding)?.touch.at
        }
    };
    let nodes = pair.node_positions();
    Ok(nodes[segment] + fraction * (nodes[segment + 1] - nodes[segment]))
}

/// The position at which the deformed contact passes a node, by the shift on both sides of it: at the node itself it may jump.
fn passes(
    pair: &Pair,
    conditions: &Conditions,
    node: f64,
    segment: f64,
    [from, to]: [f64; 2],
) -> Result<f64, SlidingError> {
    let within = |position: f64| position.clamp(from, to);
    let about = within(2.0 * node - touched(pair, conditions, within(node))?);
    let (left, right) = (within(about - BESIDE * segment), within(about + BESIDE * segment));
    let (at_left, at_right) = (touched(pair, conditions, left)?, touched(pair, conditions, right)?);
    Ok(within(left + (node - at_left) * (right - left) / (at_right - at_left)))
}

fn check_ascending(values: &[f64]) -> Result<(), SlidingError> {
    let wrong =
        (0..values.len()).find(|k| !values[*k].is_finite() || (*k > 0 && values[*k] <= values[*k - 1]));
    match wrong {
        None => Ok(()),
        Some(k) => Err(SlidingError::InvalidNumber {
            name: format!("position {} of a locus", k + 1),
            value: values[k],
            requirement: "finite and above the one before",
        }),
    }
}
