//! Figures from stored arrays: everything that is drawn can be drawn again without computing anything.

mod branches;
mod contact;
pub(crate) mod curves;
mod engines;
mod laws;
mod map;
mod modulus;
pub(crate) mod motion;
pub(crate) mod sliding;
mod structure;
pub(crate) mod sweep;
mod transient;

use judder_report::{Axis, Figure, Panel, Role};
use judder_store::{Data, Dataset, Variable};
use num_complex::Complex64;

/// The figure of an analysis; `None` where its result is not a picture.
#[must_use]
pub fn figure(name: &str, title: &str, dataset: &Dataset) -> Option<Figure> {
    let panels = panels(dataset);
    (!panels.is_empty()).then(|| Figure::new(name, title, panels).with_caption(caption(dataset)))
}

/// How the figure of a kind is drawn; `None` where arrays are missing.
type Draw = fn(&Dataset) -> Option<Vec<Panel>>;

/// Every kind of analysis that has a figure.
const FIGURES: [(&str, Draw); 23] = [
    ("equivalent-damping", |dataset| curves::equivalent_damping(dataset).map(|panel| vec![panel])),
    ("spectrum", curves::spectrum),
    ("critical-shear-strength", |dataset| curves::critical(dataset).map(|panel| vec![panel])),
    ("critical-load", |dataset| curves::critical(dataset).map(|panel| vec![panel])),
    ("stability-map", |dataset| map::stability_map(dataset).map(|panel| vec![panel])),
    ("contact", contact::contact),
    ("contact-law", laws::contact_law),
    ("fit", laws::fit),
    ("modulus", modulus::modulus),
    ("transient", transient::transient),
    ("motion", motion::motion),
    ("limit-cycle", motion::limit_cycle),
    ("bifurcation", motion::bifurcation),
    ("basin", motion::basin),
    ("engines", engines::engines),
    ("modes", structure::modes),
    ("reduction", structure::reduction),
    ("eigen", structure::eigen),
    ("eigen-sweep", structure::eigen_sweep),
    ("locus", sliding::locus),
    ("growth", sliding::growth),
    ("march", sliding::march),
    ("spectrogram", sliding::spectrogram),
];

/// The kinds of analyses that have a figure.
pub fn kinds() -> impl Iterator<Item = &'static str> {
    FIGURES.iter().map(|(name, _)| *name)
}

/// The panels of an analysis, to be put together with those of others.
#[must_use]
pub fn panels(dataset: &Dataset) -> Vec<Panel> {
    let own = FIGURES.iter().find(|(name, _)| *name == kind(dataset));
    own.and_then(|(_, draw)| draw(dataset)).unwrap_or_default()
}

fn kind(dataset: &Dataset) -> &str {
    dataset.attributes().get("kind").and_then(|kind| kind.as_str()).unwrap_or_default()
}

/// What stands under the figure of a kind.
pub(crate) fn caption(dataset: &Dataset) -> &'static str {
    match kind(dataset) {
        "equivalent-damping" => {
            "Equivalent damping $ξ_{eq} = c_{11}/2$, eq. (23). The vertical axis is logarithmic on both sides of zero. \
             Below zero, friction that falls with speed feeds the motion."
        }
        "spectrum" => {
            "Eigenvalues in units of $ω_{nx}$: growth rates and frequencies. Solid: full system, eq. (21). Dashed: without \
             damping, eqs. (24), (25)."
        }
        "critical-shear-strength" | "critical-load" => {
            "All thresholds in the searched range. Dashed: without damping, eqs. (27), (28) made self-consistent. Solid: where the \
             full, damped system gains or loses stability. Where branches were followed: circles and squares tell super- from subcritical \
             thresholds, and the dash-dotted curve is the least fold over all motions that are known beside one; between it and the threshold \
             steady sliding is stable, but a knock may start one. Beyond it a search found none, which proves nothing of those that it \
             missed."
        }
        "stability-map" => {
            "Stability of steady sliding, coloured by what carries the instability. Curves are followed by continuation: \
             full system (solid black), without damping (dashed), full system with $η = 0$ (red). Where it is hatched, steady sliding is \
             stable, but a motion lives beside it, which a knock can start; where it is dotted, what a knock does is not known."
        }
        "contact" => {
            "The indenter slides to the right. Sections along $y$ = 0; the surface of the substrate is compared with the indenter. The grids: \
             how far force, area and friction of each are from the extrapolated values."
        }
        "contact-law" => {
            "Force, area and friction over speed for several indentations (left; dashed: Hertz with $E_{0}$ and with $E_{∞}$) and over speed and \
             indentation (right)."
        }
        "fit" => {
            "Computed values (points) and the fitted functions (34), (36), (38) (curves); right, their difference over the largest value at \
             each indentation."
        }
        "modulus" => "Storage and loss modulus and loss tangent over angular frequency.",
        "transient" => {
            "Normal force, friction force and area over time; where the path repeats itself, the loop whose area is the work of a cycle."
        }
        "motion" => {
            "The whole motion; its end with the contact state shaded (white: slip); the phase portrait of that end with the changes of the contact \
             state; the spectrum and the Poincaré section (where $x$ is largest) after the transient."
        }
        "limit-cycle" => {
            "One period with the contact state shaded (white: slip), the phase portrait with the changes of the contact state, and the Floquet \
             multipliers: the cycle is stable where all but the one at 1 lie within the unit circle."
        }
        "bifurcation" => {
            "What motions settle to as the key goes up and down, each from the end of the one before: rms of $x$ about its mean, its largest values, the \
             shares of the time in stick and off the substrate. Irregular is a motion without a period from which nearby ones part; \
             unconfirmed is what has not settled within its time, or changes its kind with the tolerance. Points are simulated, and no line joins them: neighbours may have \
             settled to different motions. Where branches were followed, lines are cycles \
             and steady sliding, stable (solid) or not (dashed)."
        }
        "basin" => "Starts, drawn evenly, and what becomes of them.",
        "engines" => {
            "The cycle by time-stepping and with a smoothed sign against that by events: relative errors of rms and period. Dotted: in proportion to the \
             step, to the width. A sign that is too wide comes to another motion, or to none."
        }
        "modes" => {
            "Shapes over the body at rest (grey), displacements enlarged alike; on the page they swing. Last, how alike any two shapes are: the \
             modal assurance criterion, $|φ_{i}^{T}φ_{j}|^{2}$ over both lengths squared."
        }
        "reduction" => {
            "How far the frequencies of the reduced structure lie above those of the full one, and what the reduction alone says that this is at most. Below \
             its limit it says that every frequency is within 10^{−4}, the dotted level."
        }
        "locus" => {
            "Complex eigenvalues of the coupled pair, dark to light along the axis: all of them with growth rates logarithmic on both sides of zero, and \
             their unstable side on even axes. Zones are located by the roots of the growth rate itself, however narrow; the markers stand where they \
             grow fastest. The last but one panel has the growth rates of the zones alone."
        }
        "eigen-sweep" => {
            "Every branch is followed through the points where eigenvalues meet: where two frequencies lock in, growth rates part. Squares are \
             unstable; the axis of growth rates is logarithmic on both sides of zero. Among the damping ratios a bubble's area is the magnitude of the damping \
             ratio."
        }
        "eigen" => {
            "All eigenvalues found in the region; the axis of growth rates is logarithmic on both sides of zero. Damping ratios $ζ = −$Re $λ/|λ|$: a \
             bubble's area is their magnitude. Shapes of the fastest growing modes, which swing on the page, and how alike any two shapes are."
        }
        "growth" => {
            "The contact held, the pair started in one mode of 10^{−5} of the normal force: the largest deviation of the normal force in each period, and \
             how the eigenvalue says that it grows, from the same start. Nothing is fitted to the line; the shaded interval is where the march's own rate is \
             measured."
        }
        "march" => {
            "Each line fills the space between the smallest and the largest sample of a column; samples are low-passed before they are thinned. Above \
             the frame, where the contact is. Extremes of every step stand in the table."
        }
        "spectrogram" => {
            "First, the highest level in each cell of the drawing, with the unstable zones of a locus as frames from start to end. Then the highest level in \
             each of successive stretches: every spectrum stands on its position and hides what is behind it; bars are the zones. Frequencies \
             beyond one and a half times the highest of a zone are stored, not drawn."
        }
        _ => "",
    }
}

pub(crate) fn reals<'a>(dataset: &'a Dataset, name: &str) -> Option<&'a [f64]> {
    match &dataset.variable(name)?.data {
        Data::F64(values) => Some(values),
        _ => None,
    }
}

pub(crate) fn complexes<'a>(dataset: &'a Dataset, name: &str) -> Option<&'a [Complex64]> {
    match &dataset.variable(name)?.data {
        Data::Complex(values) => Some(values),
        _ => None,
    }
}

pub(crate) fn codes<'a>(dataset: &'a Dataset, name: &str) -> Option<&'a [u8]> {
    match &dataset.variable(name)?.data {
        Data::U8(values) => Some(values),
        _ => None,
    }
}

fn words<'a>(dataset: &'a Dataset, name: &str) -> Option<&'a [String]> {
    match &dataset.variable(name)?.data {
        Data::Text(values) => Some(values),
        _ => None,
    }
}

fn text<'a>(variable: &'a Variable, attribute: &str) -> Option<&'a str> {
    variable.attributes.get(attribute)?.as_str()
}

/// The axis of a swept quantity.
pub(crate) fn axis(coordinate: &Variable) -> Axis {
    let label = text(coordinate, "label").unwrap_or(&coordinate.long_name);
    if text(coordinate, "scale") == Some("log") { Axis::log(label) } else { Axis::linear(label) }
}

/// The coordinate along the last named dimension that has one, and that of the family before it.
struct Swept<'a> {
    axis: &'a Variable,
    values: &'a [f64],
    family: Option<(&'a Variable, &'a [f64])>,
}

impl<'a> Swept<'a> {
    /// The swept quantities of an array: its dimensions that have coordinates.
    fn of(dataset: &'a Dataset, array: &str) -> Option<Self> {
        let mut coordinates = dataset
            .variable(array)?
            .dimensions
            .iter()
            .filter_map(|dimension| Some((dataset.variable(dimension)?, reals(dataset, dimension)?)));
        let first = coordinates.next()?;
        Some(match coordinates.next() {
            Some((axis, values)) => Self { axis, values, family: Some(first) },
            None => Self { axis: first.0, values: first.1, family: None },
        })
    }

    fn curves(&self) -> usize {
        self.family.map_or(1, |(_, values)| values.len())
    }

    /// The legend of a curve of the family: symbol = value; `alone` where there is no family.
    fn label(&self, curve: usize, alone: &str) -> String {
        let Some((variable, values)) = self.family else { return alone.to_owned() };
        let symbol = text(variable, "symbol").unwrap_or(&variable.name);
        let unit = if variable.units == "1" { String::new() } else { format!(" {}", variable.units) };
        format!("{symbol} = {}{unit}", crate::labels::short_number(values[curve]))
    }

    fn role(&self, curve: usize) -> Role {
        match self.family {
            Some(_) => Role::Graded { index: curve, count: self.curves() },
            None => Role::FullBoundary,
        }
    }
}
