//! Contact interfaces: contact points with one law.

use crate::AssemblyError;
use crate::contact_point::{ContactFrame, ContactPoint};
use crate::friction::Friction;
use crate::pressure::Pressure;
use crate::row::Row;
use std::fmt::Debug;
use std::sync::Arc;

/// A surface of the slider on a surface of the track.
#[derive(Debug, Clone)]
pub struct Interface {
    /// Its name.
    pub name: String,
    /// Its contact points.
    pub points: Vec<ContactPoint>,
    /// What presses and drags there.
    pub law: InterfaceLaw,
    /// Whether its points stay closed whatever their force.
    pub all_closed: bool,
}

/// What presses and drags at the points of an interface.
#[derive(Debug, Clone)]
pub enum InterfaceLaw {
    /// 0 ≤ N ⟂ g ≥ 0, T = μ N.
    Rigid(Friction),
    /// N = a p(−g), or k times −g of each point, T = μ N.
    Compliant(Pressure, Friction),
    /// N and T of one point, each of closure and slip speed.
    Asperity(Arc<dyn Asperity>),
}

/// The forces of a point as smooth functions of its closure d = −g in m and its slip speed |v| in m/s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PointForces {
    /// N in N.
    pub normal: ForceAt,
    /// T in N.
    pub friction: ForceAt,
}

/// A force with its slopes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ForceAt {
    /// N.
    pub value: f64,
    /// By the closure, in N/m.
    pub by_closure: f64,
    /// By the slip speed, in N s/m.
    pub by_speed: f64,
}

/// A contact whose forces follow a law of their own, as of a sphere on a viscoelastic substrate.
pub trait Asperity: Debug + Send + Sync {
    /// N and T at a closure in m and a slip speed in m/s.
    fn forces(&self, closure: f64, speed: f64) -> PointForces;
}

impl InterfaceLaw {
    /// N and T of a point at a closure in m and a slip speed in m/s; none of a rigid one, whose normal force does not follow from its
    /// closure. What `stays_closed` pulls where it is open.
    #[must_use]
    pub fn forces(&self, area: f64, closure: f64, speed: f64, stays_closed: bool) -> PointForces {
        match self {
            Self::Rigid(_) => PointForces::default(),
            Self::Compliant(pressure, friction) => {
                let area = if pressure.is_of_points() { 1.0 } else { area };
                let pressure =
                    if stays_closed { pressure.extended_at(closure) } else { pressure.at(closure) };
                let friction = friction.at(speed);
                let normal = ForceAt {
                    value: area * pressure.value,
                    by_closure: area * pressure.slope,
                    by_speed: 0.0,
                };
                let friction = ForceAt {
                    value: friction.coefficient * normal.value,
                    by_closure: friction.coefficient * normal.by_closure,
                    by_speed: friction.slope * normal.value,
                };
                PointForces { normal, friction }
            }
            Self::Asperity(law) => law.forces(closure, speed),
        }
    }
}

impl InterfaceLaw {
    /// Its friction coefficient; `None` where friction is part of a law of an asperity.
    #[must_use]
    pub fn friction(&self) -> Option<&Friction> {
        match self {
            Self::Rigid(friction) | Self::Compliant(_, friction) => Some(friction),
            Self::Asperity(_) => None,
        }
    }

    /// The closure in m at which a cubic stiffness presses a hundredth of the linear one beside it; none of other laws.
    #[must_use]
    pub fn bend(&self) -> Option<f64> {
        match self {
            Self::Compliant(pressure, _) => pressure.bend(),
            Self::Rigid(_) | Self::Asperity(_) => None,
        }
    }

    /// Whether its forces follow the closure otherwise than in straight pieces.
    pub(crate) fn is_curved(&self) -> bool {
        matches!(self, Self::Asperity(_)) || self.bend().is_some()
    }

    /// The number of the smooth piece of the law at a closure in m and a slip speed in m/s.
    pub(crate) fn piece(&self, closure: f64, speed: f64) -> usize {
        match self {
            Self::Rigid(friction) => friction.piece(speed),
            Self::Compliant(pressure, friction) => {
                pressure.piece(closure) * friction.pieces() + friction.piece(speed)
            }
            Self::Asperity(_) => 0,
        }
    }
}

/// A contact point in its frame, with the law of its interface.
#[derive(Debug, Clone)]
pub struct FramedPoint<'a> {
    /// The interface, by its place in the assembly.
    pub interface: usize,
    /// The point.
    pub point: &'a ContactPoint,
    /// Its forms.
    pub frame: ContactFrame,
    /// The law.
    pub law: &'a InterfaceLaw,
    /// Whether it stays closed whatever its force.
    pub stays_closed: bool,
}

impl FramedPoint<'_> {
    /// N and T of a point that is not rigid, opened by y in m from where the undeformed bodies lie.
    #[must_use]
    pub fn forces_at(&self, opening: f64) -> PointForces {
        let ContactPoint { area, gap, .. } = self.point;
        self.law.forces(*area, -(gap + opening), self.frame.speed, self.stays_closed)
    }

    /// Whether its forces are linear in closure and velocities as long as it presses and slides one way: friction that follows the speed, or turns with the slip direction, is not, nor
    /// is a spring that bends.
    #[must_use]
    pub fn is_linear_in_slip(&self) -> bool {
        let (springs, friction) = match self.law {
            InterfaceLaw::Rigid(friction) => (true, friction),
            InterfaceLaw::Compliant(pressure, friction) => (!pressure.bends(), friction),
            InterfaceLaw::Asperity(_) => return false,
        };
        let turns = !self.frame.across.is_empty() && !friction.is_none();
        // a point that pulls has no friction, and its state does not show it
        springs && matches!(friction, Friction::Constant(_)) && !turns && !self.stays_closed
    }

    /// e = n + μ t of a rigid point: what its unit normal force with its friction does, the equilibrium column.
    #[must_use]
    pub fn equilibrium(&self, friction: f64) -> Row {
        Row::sum([(1.0, &self.frame.normal), (friction, &self.frame.slip)])
    }
}

impl Interface {
    /// Whether its track is at rest and holds by friction what lies on it.
    #[must_use]
    pub fn rests_with_friction(&self) -> bool {
        let has_friction = match &self.law {
            InterfaceLaw::Rigid(friction) | InterfaceLaw::Compliant(_, friction) => !friction.is_none(),
            InterfaceLaw::Asperity(_) => true,
        };
        has_friction && self.points.iter().any(ContactPoint::is_at_rest)
    }

    /// Its points in their frames; `number` is its place in the assembly.
    ///
    /// # Errors
    /// [`AssemblyError::NoPoints`], [`AssemblyError::NoSlip`], [`AssemblyError::HeldPoint`], [`AssemblyError::NoArea`], what is wrong with
    /// its law.
    pub(crate) fn framed(&self, number: usize) -> Result<Vec<FramedPoint<'_>>, AssemblyError> {
        if self.points.is_empty() {
            return Err(AssemblyError::NoPoints { interface: self.name.clone() });
        }
        match &self.law {
            InterfaceLaw::Rigid(friction) => friction.check()?,
            InterfaceLaw::Compliant(pressure, friction) => {
                pressure.check()?;
                friction.check()?;
            }
            InterfaceLaw::Asperity(_) => {}
        }
        self.points.iter().map(|point| self.framed_point(number, point)).collect()
    }

    fn framed_point<'a>(
        &'a self,
        interface: usize,
        point: &'a ContactPoint,
    ) -> Result<FramedPoint<'a>, AssemblyError> {
        let (name, place) = (|| self.name.clone(), point.place);
        let frame = point.frame(&self.name)?;
        if frame.normal.is_empty() {
            return Err(AssemblyError::HeldPoint { interface: name(), place });
        }
        // so too where it is not a number
        let has_area = point.area > 0.0 && point.area.is_finite();
        let needs_area =
            matches!(&self.law, InterfaceLaw::Compliant(pressure, _) if !pressure.is_of_points());
        if needs_area && !has_area {
            return Err(AssemblyError::NoArea { interface: name(), place });
        }
        Ok(FramedPoint { interface, point, frame, law: &self.law, stays_closed: self.all_closed })
    }
}
