//! Multipliers of a cycle that a march comes back on.
//!
//! Small motions follow the laws along the march, and its steps are parted where a point is caught or let go, lifts off or comes back. What is caught loses its slip
//! at once, δv⁺ = δv − M⁻¹ Pᵀ δp with P_T δv⁺ = 0; what is let go or touches changes nothing at once, as forces do not jump there (M. A. Aizerman, F. R. Gantmakher
//! 1958). The march is off by the first order of its steps, and so are the multipliers: those of two numbers of steps tell what is left without steps (L. F.
//! Richardson), those of three how well it is known.

use super::doubled::{multipliers_of, sort};
use super::mean_law::add;
use super::monodromy::SteppedMotions;
use super::{FloquetMultipliers, MOST, apart};
use crate::CyclesError;
use crate::backbone::PeriodicMotion;
use crate::balance::HarmonicBalance;
use crate::path::GoOn;
use crate::point_law::{ProjectedForce, projected};
use crate::shooting::course::{PhaseChange, PointPhase, ShotCourse};
use crate::shooting::{ShootingSettings, ShotCycle, course_of, shoot};
use faer::{Mat, c64};
use judder_assembly::assembly::Assembly;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::quadrature::gauss_legendre;
use std::f64::consts::TAU;

/// The multipliers of a cycle that was shot, with those of as many, half and a quarter of its steps; none where they are not told by these: in space, where a rigid
/// point touches, where slip turns without stick, or where no cycle comes back with fewer steps.
///
/// # Errors
/// [`CyclesError::Singular`], and what the march says.
pub fn shot_multipliers(
    assembly: &Assembly,
    (balance, near): (&HarmonicBalance<'_>, &PeriodicMotion),
    (shot, settings): (&ShotCycle, &ShootingSettings),
    go_on: &GoOn<'_>,
) -> Result<Option<FloquetMultipliers>, CyclesError> {
    if balance.contact().dimension != 2 || balance.bodies().coordinates() > MOST {
        return Ok(None);
    }
    let of = |shot: &ShotCycle| {
        let course = course_of(assembly, balance, shot, go_on)?;
        let matrix = along(balance, shot.frequency, &course, go_on)?;
        matrix.map(|own| multipliers_of(balance, near, &own, course.steps())).transpose()
    };
    let mut with = Vec::new();
    for fewer in [4, 2] {
        let settings = ShootingSettings { steps: settings.steps / fewer, ..*settings };
        match shoot(assembly, balance, near, &settings, go_on) {
            Ok(shot) => with.extend(of(&shot)?),
            Err(CyclesError::NotReturned { .. } | CyclesError::Singular) => return Ok(None),
            Err(error) => return Err(error),
        }
    }
    with.extend(of(shot)?);
    let [few, more, most] = &with[..] else { return Ok(None) };
    let (coarse, mut found) = (without_steps(few, more), without_steps(more, most));
    let off = |own: c64| found.phase.map_or(0.0, |phase| (phase - own).modulus());
    let of_phase = off(c64::ONE).max(coarse.phase.map_or(0.0, off));
    found.error = apart(&coarse.values, &found.values).max(of_phase);
    Ok(Some(found))
}

/// What two numbers of steps tell of none.
fn without_steps(few: &FloquetMultipliers, many: &FloquetMultipliers) -> FloquetMultipliers {
    let more = few.steps as f64 / (many.steps - few.steps) as f64;
    let beyond = |own: c64, coarse: c64| own + (own - coarse) * more;
    let nearest = |own: c64| {
        let off = |other: &c64| (own - other).modulus();
        few.values.iter().copied().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(own)
    };
    let mut values: Vec<c64> = many.values.iter().map(|own| beyond(*own, nearest(*own))).collect();
    sort(&mut values);
    FloquetMultipliers {
        values,
        phase: many.phase.zip(few.phase).map(|(own, coarse)| beyond(own, coarse)),
        ..*many
    }
}

/// What a period makes of small motions along a march.
fn along(
    balance: &HarmonicBalance<'_>,
    omega: f64,
    course: &ShotCourse,
    go_on: &GoOn<'_>,
) -> Result<Option<Mat<f64>>, CyclesError> {
    let Some(changes) = course.changes(balance.contact()) else { return Ok(None) };
    let steps = course.steps();
    let mut motions = SteppedMotions::new(balance, omega, TAU / omega / steps as f64)?;
    for which in 0..steps {
        if !go_on() {
            return Err(CyclesError::Stopped);
        }
        let ends = [which as f64, (which + 1) as f64];
        let amid = |own: &PhaseChange| own.at > ends[0] && own.at < ends[1];
        let mut cuts = vec![ends[0]];
        cuts.extend(changes.iter().filter(|own| amid(own)).map(|own| own.at));
        cuts.push(ends[1]);
        cuts.dedup();
        for part in cuts.windows(2) {
            let laws = mean_laws(balance, course, &changes, [part[0], part[1]]);
            if changes.iter().any(|own| own.at == part[0] && own.to == PointPhase::Stick) {
                motions.catch(laws.clone())?;
            }
            motions.advance(part[1] - part[0], laws)?;
        }
    }
    Ok(Some(motions.matrix()))
}

/// The mean laws of all points over a part of a step amid which nothing changes: instants crowd where a change begins or ends it, as slopes may grow without bound with
/// the logarithm of a speed that vanishes there.
fn mean_laws(
    balance: &HarmonicBalance<'_>,
    course: &ShotCourse,
    changes: &[PhaseChange],
    [from, to]: [f64; 2],
) -> Vec<ProjectedForce> {
    let changes_at = |instant: f64| changes.iter().any(|own| own.at == instant);
    let crowds = [from, to].map(changes_at);
    let of = |point: usize| {
        let mut mean = ProjectedForce::default();
        for (node, weight) in gauss_legendre::<5>() {
            let (place, share) = match crowds {
                [true, _] => (node.powi(3), 3.0 * node * node),
                [_, true] => (1.0 - node.powi(3), 3.0 * node * node),
                [false, false] => (node, 1.0),
            };
            add(
                &mut mean,
                &law(balance, course, changes, (point, from + (to - from) * place)),
                weight * share,
            );
        }
        mean
    };
    (0..balance.contact().points.len()).map(of).collect()
}

/// The law of a point at an instant between two changes.
fn law(
    balance: &HarmonicBalance<'_>,
    course: &ShotCourse,
    changes: &[PhaseChange],
    (point, instant): (usize, f64),
) -> ProjectedForce {
    /// So many times the force that all are measured by no friction holds.
    const OVERCOMES: f64 = 1e9;
    let at = course.at(changes, point, instant);
    let friction = match at.phase {
        PointPhase::Open => return ProjectedForce::default(),
        PointPhase::Stick => 0.0,
        PointPhase::Slip(sign) => -sign * OVERCOMES * balance.force_scale(),
    };
    let (own, scales) = (&balance.contact().points[point], balance.scales()[point]);
    projected(own, scales, [at.normal, friction, 0.0], [at.gap, at.slip, 0.0])
}
