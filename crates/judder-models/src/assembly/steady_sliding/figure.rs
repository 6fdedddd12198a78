//! Steady sliding: what each contact point carries, and how the bodies are moved.

use crate::structure::shape_panels::still;
use judder_report::{Axis, Layer, Panel, Role};
use judder_store::Dataset;
use judder_study::pictures::{reals, words};

/// The diameter of the largest bubble over that of a usual marker.
const LARGEST: f64 = 3.0;
/// An interface that is narrower than this share of its length is a line.
const LINE: f64 = 1e-6;

/// Forces and gaps along each interface; the bodies.
pub(super) fn steady_sliding(dataset: &Dataset) -> Option<Vec<Panel>> {
    let points = Points {
        places: [("x", reals(dataset, "x")?), ("y", reals(dataset, "y")?), ("z", reals(dataset, "z")?)],
        force: reals(dataset, "normal_force")?,
        gap: reals(dataset, "gap")?,
    };
    let contacts = words(dataset, "contact")?;
    let mut names: Vec<&String> = Vec::new();
    for name in contacts {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let mut panels = Vec::new();
    for name in names {
        let own: Vec<usize> = (0..contacts.len()).filter(|k| contacts[*k] == *name).collect();
        panels.extend(points.panels(name, &own));
    }
    panels.extend(still(dataset, "the bodies, displacements enlarged"));
    Some(panels)
}

struct Points<'a> {
    places: [(&'static str, &'a [f64]); 3],
    force: &'a [f64],
    gap: &'a [f64],
}

impl Points<'_> {
    /// An interface: along a line its forces and gaps, over a surface its forces as bubbles.
    fn panels(&self, name: &str, own: &[usize]) -> Vec<Panel> {
        let length = |(_, axis): &(&str, &[f64])| {
            let places = own.iter().map(|k| axis[*k]);
            places.clone().fold(f64::NEG_INFINITY, f64::max) - places.fold(f64::INFINITY, f64::min)
        };
        let mut axes = self.places;
        // of equally long ones in the order x, y, z
        axes.sort_by(|a, b| length(b).total_cmp(&length(a)));
        let [long, wide, _] = axes;
        if length(&wide) > LINE * length(&long) {
            return vec![self.map(name, own, [long, wide])];
        }
        let axis = || Axis::linear(format!("Place ${}$ (m)", long.0));
        let place: Vec<f64> = own.iter().map(|k| long.1[*k]).collect();
        let along = |values: &[f64], role| {
            Layer::points("", place.clone(), own.iter().map(|k| values[*k]).collect(), role)
        };
        let panel =
            |label: &str, values, role| Panel::new(axis(), Axis::linear(label), vec![along(values, role)]);
        vec![
            panel("Normal force $N$ (N)", self.force, Role::Series(0)).with_title(format!("{name}: forces")),
            panel("Gap $g$ (m)", self.gap, Role::Series(1)).with_title(format!("{name}: gaps")),
        ]
    }

    /// Forces over a surface; a bubble's area is the force.
    fn map(&self, name: &str, own: &[usize], axes: [(&'static str, &[f64]); 2]) -> Panel {
        let largest = own.iter().map(|k| self.force[*k]).fold(f64::MIN_POSITIVE, f64::max);
        let (closed, open): (Vec<usize>, Vec<usize>) = own.iter().partition(|k| self.force[**k] > 0.0);
        let along =
            |points: &[usize], axis: usize| points.iter().map(|k| axes[axis].1[*k]).collect::<Vec<f64>>();
        let sizes = closed.iter().map(|k| LARGEST * (self.force[*k] / largest).sqrt()).collect();
        let mut layers =
            vec![Layer::bubbles("closed", along(&closed, 0), along(&closed, 1), sizes, Role::Series(0))];
        if !open.is_empty() {
            layers.push(Layer::points("open", along(&open, 0), along(&open, 1), Role::Series(1)));
        }
        let axis = |k: usize| Axis::linear(format!("Place ${}$ (m)", axes[k].0));
        Panel::new(axis(0), axis(1), layers)
            .with_title(format!("{name}: forces, the largest {largest:.3e} N"))
    }
}
