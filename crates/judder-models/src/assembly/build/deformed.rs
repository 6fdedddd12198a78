//! Contact points of bodies as they lie in steady sliding: where the slider meets the deformed track, with the normals of that.

use super::Unassembled;
use super::body::BuiltBody;
use super::interface::{Touching, displaced_points};
use super::size::extent;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::ContactForceSettings;
use judder_assembly::assembly::Assembly;
use judder_assembly::compliance::Compliance;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::steady::steady_sliding;
use judder_assembly::tie::Bond;
use judder_sliding::locus::Configuration;
use num_complex::Complex64;

/// How far gaps and normals may still move in the last iteration, of the bodies' size and of one.
const TOLERANCE: f64 = 1e-12;
const ITERATIONS: usize = 100;

/// Puts the contact points that see the deformed track where they lie in steady sliding, by iteration: on given points steady sliding is linear but for what closes.
pub(super) fn deform(
    case: &AssemblyCase,
    (bodies, touching, bond): (&[BuiltBody], &Touching, Option<&Bond>),
    assembly: &mut Assembly,
    nodes: &[Vec<usize>],
) -> Result<(), Unassembled> {
    let Some(contact) = case.contacts.iter().find(|contact| contact.configuration == Configuration::Deformed)
    else {
        return Ok(());
    };
    let path = format!("contact.{}.configuration", contact.name);
    if case.contacts.iter().any(|contact| matches!(contact.forces, ContactForceSettings::Asperity(_))) {
        let reason = "the deformed configuration is not known beside a sphere, whose law is found later: leave `configuration` out";
        return Err(Unassembled::because(path, &reason));
    }
    let size = bodies.iter().filter_map(|body| body.structure.mesh()).map(extent).fold(0.0, f64::max);
    let mut moved = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let steady = Compliance::new(assembly).and_then(|compliance| steady_sliding(assembly, &compliance));
        let steady = steady.map_err(|error| Unassembled::because(path.as_str(), &error))?;
        if moved <= TOLERANCE {
            return Ok(());
        }
        let of_bodies: Vec<Complex64> = steady.displacement.iter().map(|u| Complex64::new(*u, 0.0)).collect();
        let of_bodies = bond.map_or_else(|| of_bodies.clone(), |bond| bond.expanded(&of_bodies));
        let displaced: Vec<_> = bodies.iter().map(|body| displaced(body, &of_bodies)).collect();
        moved = 0.0;
        let found = displaced_points(case, bodies, touching, &displaced)?;
        for (k, found) in found.into_iter().enumerate() {
            let Some(mut found) = found else { continue };
            if found.nodes != nodes[k] {
                let reason = "as the bodies deform, nodes of the slider leave the track, or come to it: name sets that stay opposite each other";
                return Err(Unassembled::because(path, &reason));
            }
            for (point, before) in found.points.iter_mut().zip(&assembly.interfaces[k].points) {
                if let Some(bond) = bond {
                    bond.bind(point);
                }
                // the gap as it lies is that of no displacement and what displacements have added
                point.gap -= point.form(point.normal).of(&steady.displacement);
                moved = moved.max(change(point, before, size));
            }
            assembly.interfaces[k].points = found.points;
        }
    }
    let reason = format!(
        "the deformed configuration was not found: after {ITERATIONS} iterations contact points still move by {moved:.1e} of the bodies' size"
    );
    Err(Unassembled::because(path, &reason))
}

/// How far a contact point has changed, its gap by the size of the bodies.
fn change(point: &ContactPoint, before: &ContactPoint, size: f64) -> f64 {
    let turned = (0..3).map(|k| (point.normal[k] - before.normal[k]).abs()).fold(0.0, f64::max);
    turned.max((point.gap - before.gap).abs() / size.max(f64::MIN_POSITIVE))
}

/// How the nodes of a body are displaced, in m.
fn displaced(body: &BuiltBody, displacement: &[Complex64]) -> Vec<[f64; 3]> {
    let own = body.expanded(&displacement[body.first..body.first + body.size()]);
    let Some(layout) = &body.structure.layout else { return Vec::new() };
    let mut all: Vec<[f64; 3]> = layout
        .freedoms
        .iter()
        .map(|freedoms| freedoms.map(|freedom| freedom.map_or(0.0, |k| own[k].re)))
        .collect();
    for ((point, direction), by) in &body.imposed {
        all[*point][*direction as usize] = *by;
    }
    all
}
