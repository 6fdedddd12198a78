//! Complex modes about steady sliding, and what is told of them.

use super::beyond_law::BeyondLaws;
use super::{AssemblyEigen, SoughtModes};
use crate::assembly::AssemblySubject;
use crate::assembly::build::{BuiltAssembly, ShownBodies};
use crate::assembly::doubts::IMBALANCE;
use crate::assembly::interface_error::WithInterfaceFreedoms;
use crate::error::ModelError;
use crate::structure::eigen::run::{ShownModes, asked_of, found};
use crate::structure::vectors::ImportedFreedoms;
use judder_assembly::linearised::{ContactTerm, Linearised, LinearisedTerms};
use judder_assembly::work::{GrowthShares, Worker, growth_shares};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use judder_store::{ByName, Results};
use judder_structure::asked_region::AskedRegion;
use judder_structure::complex_modes::{ComplexMode, ComplexModes, Verdict};
use judder_structure::diagnosis::participations;
use judder_structure::modes::{Mode, WantedModes, modes};
use judder_structure::quadratic::Region;
use judder_study::outcome::{CheckRecord, Outcome};
use num_complex::Complex64;

/// What is told of the modes of an assembly beside their eigenvalues.
#[derive(Results)]
pub(super) struct AssemblyModes {
    /// contact points that are closed
    closed: usize,
    /// what of bodies that turn is left out, in words
    left_out: Vec<String>,
    /// by how much eigenvalues differ from those with each freedom of the contacts kept, over |λ|: the error of interface modes; none where
    /// there are not as many
    #[result(unit = "1", optional)]
    interface_modes_error: Option<f64>,
    /// what makes each unstable mode grow, and of which modes it is made
    growing: Vec<GrowingMode>,
}

/// Why a mode grows.
#[derive(Clone, Results)]
struct GrowingMode {
    /// number of the mode, by rising frequency
    mode: usize,
    /// what each damping and each contact adds to its growth rate
    #[result(unit = "1/s")]
    growth: ByName<f64>,
    /// the modes of frictionless contact of which it is made, by their shares in its kinetic energy
    parents: Vec<Parent>,
}

/// A mode of frictionless contact in a complex mode.
#[derive(Clone, Results)]
struct Parent {
    /// its frequency, in Hz
    frequency_hz: f64,
    /// its share in the kinetic energy
    #[result(unit = "1")]
    share: f64,
}

/// Parents that are told of a mode.
const PARENTS: usize = 3;
/// How far growths may be from the growth rate, over |λ|.
const BALANCE: f64 = 1e-8;

/// Growths below so much of the largest are rounding.
const ROUNDING: f64 = 1e-10;

pub(super) fn run(of: &AssemblySubject<'_>, asked: &AssemblyEigen) -> Result<Outcome, ModelError> {
    let built = of.built;
    let steady = of.steady_or_untouched()?;
    let terms = LinearisedTerms { damping: asked.damping, friction_damping: asked.damping };
    let about = Linearised::new(&built.assembly, &steady, terms)?;
    let (sought, found) = sought(&about, asked.sought)?;
    let region = sought.rectangle();
    let shown = ShownBodies::new(&built.bodies);
    let modes = ShownModes {
        problem: &about.problem,
        sought: &region,
        found: &found,
        layout: Some(&shown.layout),
        mesh: (!shown.mesh.blocks.is_empty()).then_some(&shown.mesh),
        freedoms: imported(built),
        expanded: &|shape| built.expanded(&about.expanded(shape)),
        expanded_left: &|shape| built.expanded(&about.expanded_left(shape)),
    };
    let mut outcome = modes.outcome(of.name, None)?;
    outcome.dataset = shown.with_bodies(outcome.dataset)?;
    outcome.warnings.extend(of.doubts(&steady));
    outcome.missing += usize::from(steady.residual > IMBALANCE);
    if let SoughtModes::Count(count) = asked.sought
        && found.modes.len() < count
    {
        let few = found.modes.len();
        outcome.warnings.push(format!("{few} of {count} modes: in the searched region there are no more"));
    }
    let parents = if outcome.scalars["unstable"] == 0 { Vec::new() } else { parents(&about, &region)? };
    let is_unstable = |mode: &&ComplexMode| mode.eigenvalue.verdict() == Verdict::Unstable;
    let (mut growing, mut balances) = (Vec::new(), Vec::new());
    for mode in found.modes.iter().filter(is_unstable) {
        let shape = about.expanded(&mode.right);
        let Some(shares) = growth_shares(&about, mode.eigenvalue.value, &shape)? else { continue };
        balances.push(shares.balance.abs() / mode.eigenvalue.value.modulus());
        growing.push(GrowingMode {
            mode: 1 + found.modes.iter().position(|other| std::ptr::eq(other, mode)).unwrap_or_default(),
            growth: named(of, shares),
            parents: made_of(&about, &parents, mode, shape),
        });
    }
    if !balances.is_empty() {
        outcome.checks.push(CheckRecord::new(
            "what dampings and contacts add to growth rates sums to them",
            format!("difference over |λ|, {} growing modes", balances.len()),
            balances.into_iter().collect(),
            BALANCE,
        ));
    }
    let closed = steady.points.iter().filter(|point| point.is_closed).count();
    let left_out = built.left_out.clone();
    let interface_modes_error = interface_modes_error(of, &found, terms, &sought, &mut outcome.warnings)?;
    outcome.scalars.extend(AssemblyModes { closed, left_out, interface_modes_error, growing }.scalars());
    let (beyond, warnings) = BeyondLaws::of(of, &steady, &found.modes);
    outcome.scalars.extend(beyond.scalars());
    outcome.warnings.extend(warnings);
    Ok(outcome)
}

/// The freedoms of bodies that are imported matrices.
fn imported(built: &BuiltAssembly) -> ImportedFreedoms {
    let mut freedoms = ImportedFreedoms::default();
    for body in built.bodies.iter().filter(|body| body.structure.mesh().is_none()) {
        freedoms.add(&body.name, body.first_freedom, body.freedoms(), body.structure.layout.as_ref());
    }
    freedoms
}

/// The error of interface modes, where there are some and it is known.
fn interface_modes_error(
    of: &AssemblySubject<'_>,
    found: &ComplexModes,
    terms: LinearisedTerms,
    asked: &AskedRegion,
    warnings: &mut Vec<String>,
) -> Result<Option<f64>, ModelError> {
    let Some(finer) = WithInterfaceFreedoms::of(of)? else { return Ok(None) };
    let own: Vec<Complex64> = found.modes.iter().map(|mode| mode.eigenvalue.value).collect();
    match finer.of_eigenvalues(&own, terms, asked)? {
        Ok(error) => Ok(Some(error)),
        Err(why) => {
            warnings.push(why);
            Ok(None)
        }
    }
}

/// The modes that an analysis asks for, and where there are no others.
fn sought(about: &Linearised, sought: SoughtModes) -> Result<(AskedRegion, ComplexModes), ModelError> {
    let asked = match sought {
        SoughtModes::Region(asked) => asked,
        SoughtModes::Band([from, to]) => AskedRegion::from(band(from, to)),
        SoughtModes::Count(count) => {
            let (region, lowest) = lowest(about, count)?;
            return Ok((AskedRegion::from(region), lowest));
        }
    };
    Ok((asked, asked_of(found(&about.problem, &asked.rectangle())?, &asked)))
}

/// Growth rates that a band holds, over its upper frequency.
const STEEPNESS: f64 = 0.5;

/// All of a band that grows or decays by less than so much.
pub(in crate::assembly) fn band(from: f64, to: f64) -> Region {
    Region { re: [-STEEPNESS * to, STEEPNESS * to], im: [from, to] }
}

/// The lowest modes: as far up as so many of frictionless contact lie, and farther while damping and friction leave fewer there.
pub(in crate::assembly) fn lowest(
    about: &Linearised,
    count: usize,
) -> Result<(Region, ComplexModes), ModelError> {
    /// How much farther at a time, and how often.
    const FARTHER: (f64, usize) = (1.5, 4);
    let (mass, stiffness) = about.frictionless()?;
    let highest = modes(&stiffness, &mass, WantedModes::Lowest(count + 1))?.modes.into_iter().next_back();
    let mut region = band(0.0, highest.map_or(1.0, |mode| 1.01 * mode.eigenvalue.max(0.0).sqrt()));
    let mut all = found(&about.problem, &region)?;
    for _ in 0..FARTHER.1 {
        if all.modes.len() >= count {
            break;
        }
        region = band(0.0, FARTHER.0 * region.im[1]);
        all = found(&about.problem, &region)?;
    }
    if let (Some(last), Some(next)) = (all.modes.get(count.saturating_sub(1)), all.modes.get(count)) {
        // between the last that is told and the next
        region.im[1] = 0.5 * (last.eigenvalue.value.im + next.eigenvalue.value.im);
        all.modes.truncate(count);
    }
    Ok((region, all))
}

/// The modes of frictionless contact near the band of a region, on all freedoms.
fn parents(about: &Linearised, region: &Region) -> Result<Vec<Mode>, ModelError> {
    let (mass, stiffness) = about.frictionless()?;
    let to = 1.5 * region.im[1].abs() / std::f64::consts::TAU;
    if to <= 0.0 {
        return Ok(Vec::new());
    }
    let found = modes(&stiffness, &mass, WantedModes::Band(0.0, to))?.modes;
    Ok(found.into_iter().map(|mode| Mode { shape: about.expanded_real(&mode.shape), ..mode }).collect())
}

/// The parents that have the largest shares in the kinetic energy of a mode, whose shape on all freedoms this is.
fn made_of(about: &Linearised, parents: &[Mode], mode: &ComplexMode, shape: Vec<Complex64>) -> Vec<Parent> {
    let of_all = ComplexMode { eigenvalue: mode.eigenvalue, right: shape, left: Vec::new() };
    let mut shares = participations(&about.structures[0], parents, &of_all);
    sort_by_number(&mut shares, |own| -own.share);
    let told = shares.into_iter().take(PARENTS);
    told.map(|own| Parent { frequency_hz: parents[own.component].frequency_hz(), share: own.share }).collect()
}

/// Growths by words: `material damping`, and of each contact what it does.
fn named(of: &AssemblySubject<'_>, shares: GrowthShares) -> ByName<f64> {
    let word = |worker: Worker| match worker {
        Worker::MaterialDamping => "material damping".to_owned(),
        Worker::Circulation => "unsymmetric stiffness".to_owned(),
        Worker::Gyroscopic(body) => {
            format!("{}: gyroscopic forces", of.built.assembly.gyroscopic[body].body)
        }
        Worker::Contact(interface, term) => {
            let name = &of.built.assembly.interfaces[interface].name;
            let what = match term {
                ContactTerm::NormalStiffness => "normal stiffness",
                ContactTerm::NormalTangentialCoupling => "normal-tangential coupling",
                ContactTerm::FallingFriction => "falling friction",
                ContactTerm::FrictionAcrossSlip => "friction across the slip",
                ContactTerm::SpeedNormalCoupling => "normal force that follows the speed",
                ContactTerm::TurningNormal => "normal that turns",
                ContactTerm::ConvectedSlip => "slip of the passing track",
            };
            format!("{name}: {what}")
        }
    };
    let largest = shares.shares.iter().map(|(_, growth)| growth.abs()).fold(0.0, f64::max);
    let told = shares.shares.into_iter().filter_map(|(worker, growth)| {
        let works = growth.abs() > ROUNDING * largest;
        // gyroscopic forces do no work: that is told
        let is_told = works || matches!(worker, Worker::Gyroscopic(_));
        is_told.then(|| (word(worker), if works { growth } else { 0.0 }))
    });
    told.collect()
}
