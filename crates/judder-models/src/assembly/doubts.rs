//! What is to be said of steady sliding before anything is concluded from it.

use super::AssemblySubject;
use judder_assembly::interface::Interface;
use judder_assembly::steady::{FrictionAmount, FrictionLimit, SteadySliding};

/// What the forces of a converged solution may be off, over all forces.
pub(super) const IMBALANCE: f64 = 1e-9;

impl AssemblySubject<'_> {
    /// What is to be said of steady sliding before anything is concluded from it.
    pub(super) fn doubts(&self, steady: &SteadySliding) -> Vec<String> {
        let interfaces = &self.built.assembly.interfaces;
        let mut doubts = Vec::new();
        if let FrictionLimit::At { friction: FrictionAmount::Factor(factor), point } = steady.friction_limit
            && factor <= 1.0
            && let Some((interface, at)) =
                interfaces.iter().flat_map(|own| own.points.iter().map(move |point| (own, point))).nth(point)
        {
            let [x, y, z] = at.place;
            doubts.push(format!(
                "sprag-slip: at {factor:.6} times their friction coefficients the closed points have begun to move without a change of force, first \
                 at ({x}, {y}, {z}) m of `{}`: beside the state shown there are others, or it is not reached",
                interface.name,
            ));
        }
        if steady.residual > IMBALANCE {
            let off = steady.residual;
            doubts.push(format!(
                "forces are out of balance by {off:.1e} of all forces: steady sliding is not to be trusted"
            ));
        }
        let pulling = steady.points.iter().filter(|point| point.normal_force < 0.0).count();
        if pulling > 0 {
            doubts.push(format!(
                "{pulling} contact points that are held closed pull: with `all_closed = false` they open, and the modes are others"
            ));
        }
        doubts.extend(self.beyond_friction(steady));
        for (index, sphere, state) in self.built.sliding_spheres(steady) {
            let name = &interfaces[index].name;
            doubts.extend(sphere.doubts(&state).into_iter().map(|doubt| format!("`{name}`: {doubt}")));
        }
        doubts
    }

    /// Interfaces whose closed points slip at speeds beyond those of their table of friction.
    fn beyond_friction(&self, steady: &SteadySliding) -> Vec<String> {
        let interfaces = &self.built.assembly.interfaces;
        let told = |(index, own): (usize, &Interface)| {
            let friction = own.law.friction()?;
            let states = steady.points.iter().filter(|state| state.interface == index);
            let closed: Vec<_> = states.zip(&own.points).filter(|(state, _)| state.is_closed).collect();
            let beyond = closed.iter().filter_map(|(_, point)| friction.beyond(point.slip_speed()));
            let beyond: Vec<_> = beyond.collect();
            let first = beyond.first()?.text("m/s");
            Some(format!("`{}`: at {} of {} closed points {first}", own.name, beyond.len(), closed.len()))
        };
        interfaces.iter().enumerate().filter_map(told).collect()
    }
}
