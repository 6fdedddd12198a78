//! The contact points as a march sees them.

use crate::NonsmoothError;
use crate::contact_problem::FrictionCondition;
use crate::travel::TravellingContact;
use judder_assembly::assembly::Assembly;
use judder_assembly::interface::{FramedPoint, InterfaceLaw, PointForces};
use judder_assembly::row::Row;

/// The contact points of all interfaces, with their forms one after the other: along the normal, along the slip and, in space, across it.
#[derive(Debug, Clone)]
pub struct ContactPoints<'a> {
    /// Components of a point: two in the plane, three in space.
    pub dimension: usize,
    /// In the order of the interfaces.
    pub points: Vec<FramedPoint<'a>>,
    /// Their forms.
    pub rows: Vec<Row>,
}

impl<'a> ContactPoints<'a> {
    /// Those of an assembly; the normals of points that travel turn with their track.
    ///
    /// # Errors
    /// What [`Assembly::framed`] says; [`NonsmoothError::TurningNormal`].
    pub fn new(assembly: &'a Assembly, travelling: &[TravellingContact]) -> Result<Self, NonsmoothError> {
        let points = assembly.framed()?;
        let travels = |own: &FramedPoint<'_>| travelling.iter().any(|other| other.interface == own.interface);
        if let Some(turning) = points.iter().find(|own| own.point.foot.is_some() && !travels(own)) {
            let interface = assembly.interfaces[turning.interface].name.clone();
            return Err(NonsmoothError::TurningNormal { interface });
        }
        let is_plane = points.iter().all(|own| own.frame.across.is_empty());
        let dimension = if is_plane { 2 } else { 3 };
        let forms = |own: &FramedPoint<'a>| {
            let frame = &own.frame;
            [frame.normal.clone(), frame.slip.clone(), frame.across.clone()].into_iter().take(dimension)
        };
        let rows = points.iter().flat_map(forms).collect();
        Ok(Self { dimension, points, rows })
    }

    /// How the slip velocities follow displacements where the track's material passes: the components' numbers with forms on the freedoms.
    #[must_use]
    pub fn convected(&self) -> Vec<(usize, Row)> {
        let of_point = |(point, own): (usize, &FramedPoint<'a>)| {
            let first = point * self.dimension + 1;
            let forms = own.frame.convected.clone().into_iter().enumerate().take(self.dimension - 1);
            forms.map(move |(k, row)| (first + k, row)).collect::<Vec<_>>()
        };
        let all = self.points.iter().enumerate().flat_map(of_point);
        all.filter(|(_, row)| !row.is_empty()).collect()
    }

    /// The gap of the undeformed bodies at a point in m.
    #[must_use]
    pub fn first_gap(&self, point: usize) -> f64 {
        self.points[point].point.gap
    }

    /// |V|, the slip speed of steady sliding in m/s.
    #[must_use]
    pub fn speed(&self, point: usize) -> f64 {
        self.points[point].frame.speed
    }

    /// Whether the normal force of a point follows from its gap.
    #[must_use]
    pub fn is_compliant(&self, point: usize) -> bool {
        !matches!(self.points[point].law, InterfaceLaw::Rigid(_))
    }

    /// N and T of a point that is not rigid.
    #[must_use]
    pub fn forces(&self, point: usize, closure: f64, speed: f64) -> PointForces {
        let own = &self.points[point];
        own.law.forces(own.point.area, closure, speed, own.stays_closed)
    }

    /// ∂N/∂d of a point that just closes, in N/m.
    #[must_use]
    pub fn first_stiffness(&self, point: usize) -> f64 {
        let own = &self.points[point];
        own.law.forces(own.point.area, 0.0, self.speed(point), true).normal.by_closure
    }

    /// The largest ∂N/∂d of a point, in N/m: of a rigid one none, and none is known of an asperity.
    #[must_use]
    pub fn largest_stiffness(&self, point: usize) -> f64 {
        let own = &self.points[point];
        match own.law {
            InterfaceLaw::Compliant(pressure, _) => {
                let area = if pressure.is_of_points() { 1.0 } else { own.point.area };
                area * pressure.largest_slope()
            }
            InterfaceLaw::Rigid(_) | InterfaceLaw::Asperity(_) => 0.0,
        }
    }

    /// The friction of a point at a closure and a slip speed, times a factor: of an asperity T/N there.
    #[must_use]
    pub fn friction(&self, point: usize, closure: f64, speed: f64, factor: f64) -> FrictionCondition<'a> {
        match self.points[point].law {
            InterfaceLaw::Rigid(law) | InterfaceLaw::Compliant(_, law) => {
                FrictionCondition::Law { law, factor }
            }
            InterfaceLaw::Asperity(law) => {
                let ratio = |speed: f64| {
                    let forces = law.forces(closure, speed);
                    let has_force = forces.normal.value > 0.0;
                    if has_force { factor * forces.friction.value / forces.normal.value } else { 0.0 }
                };
                FrictionCondition::Now { at_rest: ratio(0.0), now: ratio(speed) }
            }
        }
    }
}
