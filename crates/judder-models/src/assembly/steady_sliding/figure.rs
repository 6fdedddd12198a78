//! Steady sliding: what each contact point carries, and how the bodies are moved.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::faces::CORNERS;
use super::filled::{Filled, faces, filled};
use crate::structure::shape_panels::still;
use judder_numerics::order::sort_by_number;
use judder_report::figure::ValueMap;
use judder_report::palette::{ColourMap, Marker};
use judder_report::{Axis, Layer, Legend, Panel, Role, Style};
use judder_study::pictures::{StoredArrays, at, picked, reals, words};
use std::collections::BTreeSet;

/// The diameter of the largest bubble over that of a usual marker.
const LARGEST: f64 = 3.0;
/// An interface that is narrower than this share of its length is a line.
const LINE: f64 = 1e-6;

/// Forces and gaps along each interface, or pressures on its faces; the bodies.
pub(super) fn steady_sliding(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    for name in ["contact", "x", "y", "z", "normal_force", "gap", "pressure"] {
        dataset.over(name, &["contact_point"])?;
    }
    let points = Points {
        places: [("x", reals(dataset, "x")?), ("y", reals(dataset, "y")?), ("z", reals(dataset, "z")?)],
        force: reals(dataset, "normal_force")?,
        gap: reals(dataset, "gap")?,
        pressure: reals(dataset, "pressure").unwrap_or_default(),
        faces: faces(dataset),
        lone: lone(dataset),
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
        let own = contacts.iter().enumerate().filter(|(_, own)| *own == name);
        panels.extend(points.panels(name, &own.map(|(k, _)| k).collect::<Vec<_>>()));
    }
    panels.extend(still(dataset, "the bodies, displacements enlarged"));
    Some(panels)
}

/// The nodes that have no partner: the contact of each and its place.
fn lone<'a>(dataset: &StoredArrays<'a>) -> Vec<(&'a str, [f64; 3])> {
    let contacts = dataset.over("lone_contact", &["lone_node"]).and_then(|()| words(dataset, "lone_contact"));
    let places = dataset.shaped("lone_place", &[None, Some(3)]).and_then(|()| reals(dataset, "lone_place"));
    let (Some(contacts), Some(places)) = (contacts, places) else { return Vec::new() };
    contacts.iter().map(String::as_str).zip(places.as_chunks().0.iter().copied()).collect()
}

/// The axis of a coordinate.
fn along_axis(name: &str) -> Axis {
    Axis::linear(format!("Place ${name}$ (m)"))
}

/// What is shown of places: a little more on both sides, so that markers at the rim are whole.
fn around(places: &[f64]) -> [f64; 2] {
    const MARGIN: f64 = 0.04;
    let (from, to) = (places.first().copied().unwrap_or(0.0), places.last().copied().unwrap_or(1.0));
    let margin = MARGIN * (to - from);
    [from - margin, to + margin]
}

struct Points<'a> {
    places: [(&'static str, &'a [f64]); 3],
    force: &'a [f64],
    gap: &'a [f64],
    /// In Pa; empty of older studies, not a number where a point has no area.
    pressure: &'a [f64],
    /// Corners by the numbers of points, after them those of nodes without a partner.
    faces: Vec<[usize; CORNERS]>,
    lone: Vec<(&'a str, [f64; 3])>,
}

impl Points<'_> {
    /// An interface: along a line its forces and gaps, over a surface its pressures, or its forces as bubbles where no faces are known.
    fn panels(&self, name: &str, own: &[usize]) -> Vec<Panel> {
        let length = |(_, axis): &(&str, &[f64])| {
            let places = own.iter().filter_map(|k| axis.get(*k).copied());
            places.clone().fold(f64::NEG_INFINITY, f64::max) - places.fold(f64::INFINITY, f64::min)
        };
        let mut axes = self.places;
        // of equally long ones in the order x, y, z
        sort_by_number(&mut axes, |own| -length(own));
        let [long, wide, _] = axes;
        if length(&wide) > LINE * length(&long) {
            let axes = [long, wide];
            return vec![self.filled(name, own, axes).unwrap_or_else(|| self.map(name, own, axes))];
        }
        let axis = || along_axis(long.0);
        let along = |values: &[f64], role| Layer::points("", picked(long.1, own), picked(values, own), role);
        let beside = self.lone(long.0, None, &|_, contact| contact == name);
        let panel = |label: &str, values, role| {
            let layers = std::iter::once(along(values, role)).chain(beside.clone()).collect();
            Panel::new(axis(), Axis::linear(label), layers)
        };
        vec![
            panel("Normal force $N$ (N)", self.force, Role::Series(0)).with_title(format!("{name}: forces")),
            panel("Gap $g$ (m)", self.gap, Role::Series(1)).with_title(format!("{name}: gaps")),
        ]
    }

    /// Which of the axes has this name.
    fn axis(&self, name: &str) -> usize {
        self.places.iter().position(|(own, _)| *own == name).unwrap_or_default()
    }

    /// Nodes that have no partner, at zero where there is one axis.
    fn lone(&self, along: &str, up: Option<&str>, is_shown: &dyn Fn(usize, &str) -> bool) -> Option<Layer> {
        let own = self.lone.iter().enumerate().filter(|(k, (contact, _))| is_shown(*k, contact));
        let own: Vec<[f64; 3]> = own.map(|(_, (_, place))| *place).collect();
        let (along, up) = (self.axis(along), up.map(|up| self.axis(up)));
        let x = own.iter().map(|place| at(place, along)).collect();
        let y = own.iter().map(|place| up.map_or(0.0, |up| at(place, up))).collect();
        let style = Style { marker: Marker::Cross, ..Style::from(Role::Reference) };
        (!own.is_empty()).then(|| Layer::points("no partner", x, y, style))
    }

    /// Pressures on the faces of a surface; what has no partner presses nowhere.
    fn filled(&self, name: &str, own: &[usize], axes: [(&'static str, &[f64]); 2]) -> Option<Panel> {
        let among = |corner: &usize| own.binary_search(corner).is_ok();
        let count = self.force.len();
        let [across, up] = axes.map(|(axis, _)| self.axis(axis));
        let corner = |k: usize| match self.lone.get(k.wrapping_sub(count)) {
            Some((_, place)) if k >= count => Some(([at(place, across), at(place, up)], 0.0)),
            _ => Some(([*axes[0].1.get(k)?, *axes[1].1.get(k)?], *self.pressure.get(k)?)),
        };
        let face = |corners: &[usize; CORNERS]| {
            let found: Option<Vec<_>> = corners.iter().map(|k| corner(*k)).collect();
            found?.try_into().ok()
        };
        let shown: Vec<_> = self.faces.iter().filter(|corners| corners.iter().any(among)).collect();
        let Filled { x, y, z } = filled(&shown.iter().copied().filter_map(face).collect::<Vec<_>>())?;
        if !z.iter().any(|pressure| pressure.is_finite()) {
            return None;
        }
        let [x_side, y_side] = [&x, &y].map(|places| around(places));
        let bar = Axis::linear("Pressure $p$ (Pa)");
        let mut layers = vec![Layer::Values(ValueMap { x, y, z, bar, colours: ColourMap::Sequential })];
        let open: Vec<usize> = own.iter().copied().filter(|k| at(self.force, *k) == 0.0).collect();
        if !open.is_empty() {
            let [x, y] = axes.map(|(_, places)| picked(places, &open));
            layers.push(Layer::points("open", x, y, Role::Reference));
        }
        // on the far side of a round body others lie behind the faces
        let beside: BTreeSet<usize> = shown.into_iter().flatten().copied().collect();
        layers.extend(self.lone(axes[0].0, Some(axes[1].0), &|k, _| beside.contains(&(count + k))));
        let axis = |name: &str, [from, to]: [f64; 2]| along_axis(name).over(from, to);
        let (x, y) = (axis(axes[0].0, x_side), axis(axes[1].0, y_side));
        let panel = Panel::new(x, y, layers).with_title(format!("{name}: pressure"));
        Some(panel.with_legend(Legend::Below))
    }

    /// Forces over a surface; a bubble's area is the force.
    fn map(&self, name: &str, own: &[usize], axes: [(&'static str, &[f64]); 2]) -> Panel {
        let largest = picked(self.force, own).into_iter().fold(f64::MIN_POSITIVE, f64::max);
        let (closed, open): (Vec<usize>, Vec<usize>) = own.iter().partition(|k| at(self.force, **k) > 0.0);
        let along = |points: &[usize]| axes.map(|(_, places)| picked(places, points));
        let sizes = closed.iter().map(|k| LARGEST * (at(self.force, *k) / largest).sqrt()).collect();
        let [x, y] = along(&closed);
        let mut layers = vec![Layer::bubbles("closed", x, y, sizes, Role::Series(0))];
        if !open.is_empty() {
            let [x, y] = along(&open);
            layers.push(Layer::points("open", x, y, Role::Series(1)));
        }
        Panel::new(along_axis(axes[0].0), along_axis(axes[1].0), layers)
            .with_title(format!("{name}: forces, the largest {largest:.3e} N"))
    }
}
