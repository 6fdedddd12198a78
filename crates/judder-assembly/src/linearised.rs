//! Small motions about steady sliding: the quadratic eigenproblem of an assembly.
//!
//! Over the closed points, with c, t and s the forms along the normal, along the slip and across it:
//!
//! - a rigid point holds c δq = 0, and its force changes act along e = c + μ t: the motion has no part that c sees, the equations none
//!   that e does, Lᵀ (λ² M + λ C + K) R z = 0 with c R = 0 and e L = 0, so even the mass is unsymmetric;
//! - a point of finite stiffness adds (∂N/∂d cᵀ + ∂T/∂d tᵀ) c to the stiffness and ∂N/∂|v| cᵀ t to the damping;
//! - the friction of every point follows the slip speed, ∂T/∂|v| tᵀt, and its direction the slip direction, T/|V| sᵀs, both in the damping;
//! - where the track's material passes, the slip velocity follows displacements too, and these are in the stiffness;
//! - where the normal turns with the deformed track, so do the forces that are there: [`Foot`](crate::contact_point::Foot).

use crate::AssemblyError;
use crate::assembly::{Assembly, from_triplets, is_symmetric, sum, symmetric_part};
use crate::compliance::outer;
use crate::error::check_length;
use crate::friction::FrictionAt;
use crate::interface::{ForceAt, FramedPoint, InterfaceLaw, PointForces};
use crate::null_basis::NullBasis;
use crate::row::Row;
use crate::steady::SteadySliding;
use faer::c64;
use faer::sparse::Triplet;
use judder_structure::assembly::Sparse;
use judder_structure::quadratic::Quadratic;
use std::sync::Arc;

/// What a contact does to small motions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ContactTerm {
    /// The pressure that follows the closure, along the normal.
    NormalStiffness,
    /// The friction that follows the normal force.
    NormalTangentialCoupling,
    /// The friction that follows the slip speed.
    FallingFriction,
    /// The friction that turns with the slip direction.
    FrictionAcrossSlip,
    /// The normal force that follows the slip speed.
    SpeedNormalCoupling,
    /// The forces that turn with the normal of the deformed track.
    TurningNormal,
    /// The friction that follows displacements as the track's material passes.
    ConvectedSlip,
}

impl ContactTerm {
    /// Whether it acts on displacements, not on velocities.
    #[must_use]
    pub fn is_stiffness(self) -> bool {
        matches!(
            self,
            Self::NormalStiffness
                | Self::NormalTangentialCoupling
                | Self::TurningNormal
                | Self::ConvectedSlip
        )
    }

    /// Whether it is there because friction follows the slip velocity.
    fn follows_slip(self) -> bool {
        !self.is_stiffness() || self == Self::ConvectedSlip
    }
}

/// A term of one interface as a matrix on all freedoms.
#[derive(Debug, Clone)]
pub struct ContactMatrix {
    /// What it is.
    pub term: ContactTerm,
    /// The interface, by its place in the assembly.
    pub interface: usize,
    /// In N/m, or N s/m.
    pub matrix: Sparse,
}

/// A rigid point that is closed.
#[derive(Debug, Clone)]
pub(crate) struct HeldPoint {
    pub(crate) interface: usize,
    /// e.
    pub(crate) equilibrium: Row,
}

/// Which dampings small motions feel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LinearisedTerms {
    /// Whether the structures are damped.
    pub damping: bool,
    /// Whether friction follows speed and direction of the slip.
    pub friction_damping: bool,
}

impl Default for LinearisedTerms {
    fn default() -> Self {
        Self { damping: true, friction_damping: true }
    }
}

/// An assembly about steady sliding.
#[derive(Debug, Clone)]
pub struct Linearised {
    /// (λ² M + λ C + K) z = 0 on the freedoms that closed rigid points leave.
    pub problem: Quadratic,
    /// M, C and K of the structures on all freedoms; the damping without entries where it is left out.
    pub structures: [Arc<Sparse>; 3],
    /// G of each body that turns, on all freedoms.
    pub gyroscopic: Vec<Arc<Sparse>>,
    /// What the contacts do, by interface and term.
    pub contacts: Vec<ContactMatrix>,
    pub(crate) held: Vec<HeldPoint>,
    trial: NullBasis,
    test: NullBasis,
}

impl Linearised {
    /// Small motions about steady sliding, over the points that are closed there.
    ///
    /// # Errors
    /// [`AssemblyError::Length`] where `steady` is of other points, [`AssemblyError::HeldPoint`], [`AssemblyError::RedundantPoint`] for a
    /// closed rigid point that cannot be, [`AssemblyError::AtRest`], and what [`Assembly::framed`] and [`Quadratic::new`] say.
    pub fn new(
        assembly: &Assembly,
        steady: &SteadySliding,
        terms: LinearisedTerms,
    ) -> Result<Self, AssemblyError> {
        assembly.check_sliding()?;
        let all = assembly.framed()?;
        check_length("the points of steady sliding", steady.points.len(), all.len())?;
        let closed: Vec<ClosedPoint<'_>> = all
            .iter()
            .zip(&steady.points)
            .filter(|(_, state)| state.is_closed)
            .map(|(point, state)| ClosedPoint::new(point, state.gap - point.point.gap, state.normal_force))
            .collect();
        let contacts = contact_matrices(assembly, &closed, terms)?;
        let empty = from_triplets(assembly.size(), assembly.size(), &[])?;
        let damping = if terms.damping { Arc::clone(&assembly.damping) } else { Arc::new(empty) };
        let structures = [Arc::clone(&assembly.mass), damping, Arc::clone(&assembly.stiffness)];
        let rigid: Vec<&ClosedPoint<'_>> = closed.iter().filter(|point| point.is_rigid()).collect();
        let (trial, test) = bases(assembly, &rigid)?;
        let projected = |matrix: &Sparse| NullBasis::projected(&test, matrix, &trial);
        let gyroscopic: Vec<_> = assembly.gyroscopic.iter().map(|own| Arc::clone(&own.matrix)).collect();
        let of_contacts = |is_stiffness: bool| {
            let own = contacts.iter().filter(move |contact| contact.term.is_stiffness() == is_stiffness);
            own.map(|contact| &contact.matrix)
        };
        let problem = Quadratic::new(
            projected(&structures[0])?,
            projected(&sum(&structures[1], of_contacts(false).chain(gyroscopic.iter().map(AsRef::as_ref)))?)?,
            projected(&sum(&structures[2], of_contacts(true))?)?,
        )?;
        let held = rigid
            .iter()
            .map(|point| HeldPoint { interface: point.framed.interface, equilibrium: point.equilibrium() });
        Ok(Self { problem, structures, gyroscopic, contacts, held: held.collect(), trial, test })
    }

    /// M and K without friction, on the freedoms that are left: symmetric, its modes are the parents of those that lock in. Of a
    /// stiffness that brings circulation it is the symmetric part.
    ///
    /// # Errors
    /// [`AssemblyError::Structure`] where it does not fit into memory.
    pub fn frictionless(&self) -> Result<(Sparse, Sparse), AssemblyError> {
        let [mass, _, stiffness] = &self.structures;
        let symmetric = if is_symmetric(stiffness) { None } else { Some(symmetric_part(stiffness)?) };
        let stiffness = symmetric.as_ref().unwrap_or(stiffness);
        let normal = self.contacts.iter().filter(|contact| contact.term == ContactTerm::NormalStiffness);
        let stiffness = sum(stiffness, normal.map(|contact| &contact.matrix))?;
        let projected = |matrix: &Sparse| NullBasis::projected(&self.trial, matrix, &self.trial);
        Ok((projected(mass)?, projected(&stiffness)?))
    }

    /// A real shape on all freedoms from one on those that are left.
    #[must_use]
    pub fn expanded_real(&self, shape: &[f64]) -> Vec<f64> {
        self.trial.expanded_real(shape)
    }

    /// A shape on all freedoms from one on those that are left.
    #[must_use]
    pub fn expanded(&self, shape: &[c64]) -> Vec<c64> {
        self.trial.expanded(shape)
    }

    /// A left shape, which no force of a closed rigid point moves, on all freedoms from one on those that are left.
    #[must_use]
    pub fn expanded_left(&self, shape: &[c64]) -> Vec<c64> {
        self.test.expanded(shape)
    }
}

/// The trial basis R with c R = 0 and the test basis L with e L = 0.
fn bases(assembly: &Assembly, rigid: &[&ClosedPoint<'_>]) -> Result<(NullBasis, NullBasis), AssemblyError> {
    let fault = |number: usize| {
        let framed = rigid[number].framed;
        let (interface, place) = (assembly.interfaces[framed.interface].name.clone(), framed.point.place);
        match framed.frame.normal.is_empty() {
            true => AssemblyError::HeldPoint { interface, place },
            false => AssemblyError::RedundantPoint { interface, place },
        }
    };
    let normals: Vec<Row> = rigid.iter().map(|point| point.framed.frame.normal.clone()).collect();
    let trial = NullBasis::new(assembly.size(), &normals, None).map_err(fault)?;
    let pushes: Vec<Row> = rigid.iter().map(|point| point.equilibrium()).collect();
    let test = NullBasis::new(assembly.size(), &pushes, Some(&trial.dependent)).map_err(fault)?;
    Ok((trial, test))
}

/// A closed point with its forces and their slopes.
struct ClosedPoint<'a> {
    framed: &'a FramedPoint<'a>,
    /// μ of a rigid one.
    friction: f64,
    forces: PointForces,
}

impl<'a> ClosedPoint<'a> {
    fn new(framed: &'a FramedPoint<'a>, opening: f64, normal_force: f64) -> Self {
        let fixed = |value: f64, by_speed: f64| ForceAt { value, by_closure: 0.0, by_speed };
        let (friction, mut forces) = match framed.law {
            InterfaceLaw::Rigid(friction) => {
                let FrictionAt { coefficient, slope } = friction.at(framed.frame.speed);
                let friction = fixed(coefficient * normal_force, slope * normal_force);
                (coefficient, PointForces { normal: fixed(normal_force, 0.0), friction })
            }
            InterfaceLaw::Compliant(..) | InterfaceLaw::Asperity(_) => (0.0, framed.forces_at(opening)),
        };
        // a point that is held closed and pulls has no friction that follows the slip
        if framed.stays_closed && forces.normal.value < 0.0 {
            forces.normal.value = 0.0;
            (forces.friction.value, forces.friction.by_speed) = (0.0, 0.0);
        }
        Self { framed, friction, forces }
    }

    fn is_rigid(&self) -> bool {
        matches!(self.framed.law, InterfaceLaw::Rigid(_))
    }

    fn equilibrium(&self) -> Row {
        self.framed.equilibrium(self.friction)
    }

    /// What a term takes of the point: sums of f aᵀ b with factors f, columns a and rows b.
    ///
    /// With δd = −c δq and δ|v| = −t δq̇ the forces of the right side are, on the left, stiffness and damping with the same signs.
    fn term(&self, term: ContactTerm) -> Vec<Triplet<usize, usize, f64>> {
        let frame = &self.framed.frame;
        let (normal, slip, across) = (&frame.normal, &frame.slip, &frame.across);
        let PointForces { normal: n, friction: t } = self.forces;
        let [carried, carried_across] = &frame.convected;
        // at rest nothing drags
        let turns = if t.value == 0.0 { 0.0 } else { t.value / frame.speed };
        let one = |factor: f64, column: &Row, row: &Row| outer(factor, column, row).collect();
        match term {
            ContactTerm::NormalStiffness => one(n.by_closure, normal, normal),
            ContactTerm::NormalTangentialCoupling => one(t.by_closure, slip, normal),
            ContactTerm::FallingFriction => one(t.by_speed, slip, slip),
            ContactTerm::FrictionAcrossSlip => one(turns, across, across),
            ContactTerm::SpeedNormalCoupling => one(n.by_speed, normal, slip),
            ContactTerm::ConvectedSlip => outer(-t.by_speed, slip, carried)
                .chain(outer(-turns, across, carried_across))
                .chain(outer(-n.by_speed, normal, carried))
                .collect(),
            ContactTerm::TurningNormal => {
                let point = self.framed.point;
                let terms =
                    point.foot.iter().flat_map(|foot| foot.stiffness(point, frame, [n.value, t.value]));
                terms.flat_map(|(column, row)| outer(1.0, &column, &row).collect::<Vec<_>>()).collect()
            }
        }
    }
}

const TERMS: [ContactTerm; 7] = [
    ContactTerm::NormalStiffness,
    ContactTerm::NormalTangentialCoupling,
    ContactTerm::FallingFriction,
    ContactTerm::FrictionAcrossSlip,
    ContactTerm::SpeedNormalCoupling,
    ContactTerm::TurningNormal,
    ContactTerm::ConvectedSlip,
];

/// The matrices of the contacts that are not zero, by interface and term.
fn contact_matrices(
    assembly: &Assembly,
    closed: &[ClosedPoint<'_>],
    terms: LinearisedTerms,
) -> Result<Vec<ContactMatrix>, AssemblyError> {
    let mut made = Vec::new();
    for interface in 0..assembly.interfaces.len() {
        for term in TERMS.into_iter().filter(|term| !term.follows_slip() || terms.friction_damping) {
            let own = closed.iter().filter(|point| point.framed.interface == interface);
            let entries: Vec<_> =
                own.flat_map(|point| point.term(term)).filter(|entry| entry.val != 0.0).collect();
            if !entries.is_empty() {
                let matrix = from_triplets(assembly.size(), assembly.size(), &entries)?;
                made.push(ContactMatrix { term, interface, matrix });
            }
        }
    }
    Ok(made)
}
