//! What drives bodies over time, as forces on the freedoms of an assembly.

use super::body::{matrices, point_masses};
use super::load::{moves_nothing, of_force};
use super::{BuiltAssembly, BuiltBody, Unassembled};
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::SurfaceOf;
use crate::structure::build::points_of;
use judder_structure::assembly::inertia_load;
use judder_structure::freedom::Direction;
use judder_structure::rotation::RotatingFrame;
use judder_structure::statics::product;

impl BuiltAssembly {
    /// −M a of bodies that are seen from a base which moves with 1 m/s² along a direction, in N on the freedoms; `path` is that of the key.
    pub(crate) fn beside_base(
        &self,
        case: &AssemblyCase,
        direction: Direction,
        path: &str,
    ) -> Result<Vec<f64>, Unassembled> {
        let mut forces = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            let own = body.inertia(case, index, direction, path)?;
            forces.extend(body.on_basis(own).into_iter().map(|force| -force));
        }
        match forces.iter().any(|force| *force != 0.0) {
            true => Ok(self.on_freedoms_left(forces)),
            false => {
                let reason = format!("nothing moves along {direction}: a base that moves so does nothing");
                Err(Unassembled::because(path, &reason))
            }
        }
    }

    /// What holds sliders back that travel faster by their own speed in a second, M V with the velocity of the track beside them: their frame goes against it.
    pub(crate) fn carried_along(&self, case: &AssemblyCase, path: &str) -> Result<Vec<f64>, Unassembled> {
        let mut forces = vec![0.0; self.bodies.last().map_or(0, |last| last.first + last.size())];
        let mut carried = Vec::new();
        for own in &self.travelling {
            let index = *case.contacts[own.interface].slider.structure;
            if carried.contains(&index) {
                continue;
            }
            carried.push(index);
            let body = &self.bodies[index];
            let velocity = self.assembly.interfaces[own.interface].points[0].velocity;
            for (direction, speed) in [Direction::X, Direction::Y].into_iter().zip(velocity) {
                let inertia = body.on_basis(body.inertia(case, index, direction, path)?);
                let own = forces[body.first..].iter_mut().zip(inertia);
                own.for_each(|(force, own)| *force += speed * own);
            }
        }
        Ok(self.on_freedoms_left(forces))
    }

    /// A force of 1 N that the nodes share alike, on the freedoms; `path` is that of the table that names them.
    pub(crate) fn unit_force(
        &self,
        nodes: &SurfaceOf,
        direction: Direction,
        path: &str,
    ) -> Result<Vec<f64>, Unassembled> {
        let driven = &self.bodies[*nodes.structure];
        let points = points_of(&nodes.nodes, &driven.structure, path)?;
        let force = of_force(&driven.structure, &points, direction, 1.0).ok_or_else(|| {
            let reason = moves_nothing(&nodes.nodes.words(), direction);
            Unassembled::because(format!("{path}.direction"), &reason)
        })?;
        let own = driven.on_basis(force);
        let size = self.bodies.last().map_or(0, |last| last.first + last.size());
        let mut forces = vec![0.0; size];
        forces[driven.first..driven.first + own.len()].copy_from_slice(&own);
        Ok(self.on_freedoms_left(forces))
    }

    /// Forces on the freedoms of the bodies on those that ties leave.
    fn on_freedoms_left(&self, forces: Vec<f64>) -> Vec<f64> {
        match &self.bond {
            Some(bond) => bond.forces(&forces),
            None => forces,
        }
    }
}

impl BuiltBody {
    /// M a of all of it with 1 m/s² along a direction, on its freedoms; what is held moves with the base, and its mass counts too.
    fn inertia(
        &self,
        case: &AssemblyCase,
        index: usize,
        direction: Direction,
        path: &str,
    ) -> Result<Vec<f64>, Unassembled> {
        let own = &case.structures[index];
        let refused = |error: &dyn std::fmt::Display| Unassembled::because(path, &error.to_string());
        if own.rotation.as_ref().is_some_and(|rotation| rotation.frame == RotatingFrame::Rotating) {
            return Err(refused(&format!(
                "`{}` is seen from a frame that turns with it, in which the acceleration of the base turns the other way; give its rotation frame = \"fixed\"",
                own.name
            )));
        }
        let Some(layout) = &self.structure.layout else {
            return Err(refused(&format!(
                "`{}` has matrices whose rows have no directions, so that nobody knows how a base moves them; give its `freedoms`",
                own.name
            )));
        };
        let mut along = vec![0.0; self.structure.family.size()];
        let freedoms = layout.freedoms.iter().filter_map(|own| own[direction as usize]);
        freedoms.for_each(|freedom| along[freedom] = 1.0);
        let Some(elements) = &self.structure.elements else {
            return Ok(product(&matrices(case, index, &self.structure)?.mass, &along));
        };
        let mut unit = [0.0; 3];
        unit[direction as usize] = 1.0;
        let mut inertia = inertia_load(&elements.mesh, &elements.materials, &elements.numbering, unit)
            .map_err(|error| refused(&error))?;
        for (freedom, mass) in point_masses(own, &self.structure)? {
            inertia[freedom] += along[freedom] * mass;
        }
        Ok(inertia)
    }
}
